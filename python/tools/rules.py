# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What generate.py cannot tell from a declaration: which functions are written by hand and where, and which are left
out and why. The first pattern that matches a name counts."""

# Bound by hand in src/written.cpp or src/callbacks.cpp, where sizes of arrays or callbacks need care.
WRITTEN = r"""
dWorldsStep dBodies[GS]etStates dJointsGetStates dWorldGet(Bodies|Joints) dWorld[GS]etState(Delta)?
dWorldDiagnose dWorldGet(Contacts|ContactEvents|BrokenJoints) dSpaceRay(All|Batch) dSpaceOverlap dCollide dConnectingJointList
dCreateConvex(Hull)? dGeomSetConvex(Hull)? dGeomConvexGet(Points|Planes|Polygons) dGeomGetTriangles
dGeomHeightfieldDataBuild\w+ dGeomHeightfieldDataSetHoles dGeomTriMeshDataBuild(Double|Simple) dCreateTriMesh
dGeomTriMeshGetTriangle dJoint[GS]etFeedback
dSpaceCollide2? dBodySetMovedCallback dWorldSetContactFilter dQueryFilterInit dJointSetHinge2Axes
""".split()

# Left out: pattern -> reason.
_NUMPY = "dense linear algebra on raw arrays: numpy has it"
_OWN_THREADS = "threading functions of the program's own: dWorldSetStepThreads is the way from Python"
_DATA = "a pointer of the program's: Python objects have attributes"
_HANDLERS = "taken by the package, which turns messages into exceptions and warnings"
LEFT_OUT = {
    r"dError|dDebug": "end the process, as documented",
    r"dMessage": "takes a printf format; use the module warnings",
    r"d[GS]et(Error|Debug|Message)Handler": _HANDLERS,
    r"d(SetZero|SetValue|Dot|Multiply\d|FactorCholesky|SolveCholesky|InvertPDMatrix|IsPositiveDefinite|FactorLDLT"
    r"|SolveL1T?|ScaleVector|VectorScale|SolveLDLT|LDLTAddTL|LDLTRemove|RemoveRowCol|PrintMatrix|MakeRandomVector"
    r"|MakeRandomMatrix|ClearUpperTriangle|MaxDifference\w*|TestMatrixComparison|TestSolveLCP)": _NUMPY,
    r"d(Cooperat\w+|Resource\w+|EstimateCooperat\w+)": _NUMPY,
    r"d(Threading|ExternalThreading)\w+|dWorldSetStepThreadingImplementation": _OWN_THREADS,
    r"dWorldSetStepMemory\w+|d[GS]et(Alloc|Realloc|Free)Handler|d(Alloc|Realloc|Free)":
        "memory functions of the program's own",
    r"d(World|Body|Joint|Geom)[GS]etData": _DATA,
    r"dGeomGetClassData|dCreateGeom(Class)?|dSetColliderOverride":
        "classes of the program's own: colliders in Python would hold the interpreter in every step",
    r"dDiagnosisText": "the last element of what dWorldDiagnose returns",
    r"d(Timer|Stopwatch)\w+": "timers: Python's own are better",
    r"dWorldExportDIF": "writes to a C FILE",
    r"dGeomLowLevelControl": "no geom class has a control of this kind that a property does not have",
    r"dGeomTriMeshData(BuildSingle1?|BuildDouble1|BuildSimple1|Set|Get2|GetBuffer|SetBuffer|Preprocess2)":
        "layouts that numpy converts to the two that are bound, and buffers that the library does not use",
    r"dGeomTriMesh[GS]et(Array|Ray|TriMerge)?Callback": "a Python call for each triangle",
    r"d(BoxBox|InfiniteAABB)": "helpers of colliders in C: dCollide does it",
    r"dGeomMoved|dBodyGetMovedCallback": "the library sees every move from Python",
    r"d(Init|Close|Cleanup|Allocate)ODE\w*": "done once when the module is imported",
}

# Arrays of fixed size that a function reads and writes.
READ_AND_WRITTEN = r"d(Safe)?Normalize[34]|dOrthogonalizeR"

# Functions that run for long: the interpreter's lock is released, and the world is busy for other threads.
STEPS = r"dWorld(Step|QuickStep|StepFast1|StepHybrid)"
