# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What safe.py cannot tell from a declaration: which functions of worlds, bodies, joints and geoms the safe crate has by hand and
where, which it leaves out and why, and what a C int means. The first pattern that matches a name counts."""

# By hand in epode/src, where handles, arrays, callbacks or lifetimes need care.
WRITTEN = (
    r"dWorld(Create|Destroy|SetContactSpace|GetContactSpace|SetContactFilter|GetContactEvents|GetContacts|GetEvents|Diagnose"
    r"|GetBrokenJoints|UseDefaults|GetState\w*|SetState\w*|SetHistory|GetHistory|RollBack|GetBodies|GetJoints|Step|QuickStep"
    r"|StepFast1|StepHybrid|ShiftOrigin|Clone|CountHandles|Save|SaveToBuffer|Load|LoadFromBuffer)",
    r"dBody(Create|Destroy|SetMovedCallback|GetFirstGeom|GetNextGeom|SetMass|GetMass|GetJoint|SetData|GetData|GetWorld)",
    r"dJoint(Destroy|Attach|SetFeedback|GetFeedback|SetCouplingAxis|GetCouplingJoint|SetHinge2Axes|GetType|SetData|GetData"
    r"|Create\w+|GetBody)",
    r"dGeom(Destroy|SetFaceMaterialNumbers|GetFaceMaterialNumbers|SetBody|GetBody|SetData|GetData|GetDistance|Cast|GetTriangles|TriMeshGetTriangle|GetClass|GetBodyNext|GetSpace)",
    r"dCharacter(SettingsInit|Create|SetSettings|GetSettings)",
)

# Left out: pattern -> reason.
LEFT_OUT = {
    r"d\w*SF1": "ODE's old names of settings that have no effect or another name",
    r"dWorld(SetStepThreadingImplementation|UseSharedWorkingMemory|SetStepMemory\w+)": "pointers to functions that the world would keep",
    r"dWorld[GS]etData": "the crate keeps a world's tables there",
    r"dWorldExportDIF": "writes to a C FILE",
    r"dWorldSetManifoldFunction": "functions that threads call have no safe form yet",
    r"dWorldGet(NumFluids|Fluid)|dBodyGetFluidForce": "fluids have no type in the crate yet",
    r"dBodyCopy\w+|dGeomCopy\w+": "the getters copy",
    r"dGeom(TriMesh(Set|Get)\w*Callback|TriMeshSetData|TriMeshGetData|TriMeshGetTriMeshDataID|HeightfieldSetHeightfieldData"
    r"|HeightfieldGetHeightfieldData|TriMeshSetLastTransform|TriMeshGetLastTransform|TriMeshEnableTC|TriMeshIsTCEnabled"
    r"|TriMeshClearTCCache)": "a mesh or height field belongs to its geom and stays as it was made",
    r"dGeom(TransformSetGeom|TransformGetGeom|Transform\w+)": "transforms: geoms of bodies have offsets",
    r"dGeom(Ray\w+)": "rays are queries of the world",
    r"dGeom(SetConvex|SetConvexHull|ConvexGet\w+)": "a convex stays as it was made",
    r"dGeom(LowLevelControl|GetClassData|IsSpace|Moved)": "classes of the program, spaces: there are none",
}

# A C int that is a flag: 0 or 1.
FLAGS = (r"d(Body|Joint|Geom)(Is\w+)", r"dWorld[GS]et(FrictionCone|ManifoldFriction|ExactRotation|StepReportMode|EnergyLedgerMode"
         r"|DiagnosisMode|AutoDisableFlag)", r"dBody[GS]et(GravityMode|GyroscopicMode|FiniteRotationMode|AutoDisableFlag)",
         r"dGeom[GS]etSensor", r"dJoint[GS]etAxisContinuous", r"dCharacterSetHeight")
# A C int that is a number of an enumeration: pattern of the function -> the enumeration of the crate.
KINDS = {r"d(World|Body)[GS]etHybridStepper": "Stepper", r"dGeom[GS]etContinuous": "Continuous", r"dWorld[GS]etBehaviour": "Behaviour",
         r"dJoint[GS]etAMotorMode": "AMotorMode", r"dJoint[GS]etTransmissionMode": "TransmissionMode",
         r"dCharacter(Move|Walk)": "CharacterState"}
KINDS_OF_FIELDS = {"dMaterial.friction_rule": "CombineRule", "dMaterial.bounce_rule": "CombineRule",
                   "dMaterial.rolling_friction_rule": "CombineRule", "dIslandStepReport.method": "IslandMethod",
                   "dCharacterSettings.shape": "CharacterShape"}
FLAGS_OF_FIELDS = {"dIslandStepReport.fallback", "dIslandStepReport.contained", "dIslandStepReport.projection_unconverged",
                   "dCharacterReport.hit_wall", "dCharacterReport.hit_ceiling"}

# Fields that are 0 where there is nothing to say.
OPTIONAL_FIELDS = {"dCharacterReport.state": "CharacterState"}
# Getters that return 1, or 0 where there is nothing to say: an Option.
OPTIONAL = (r"dWorldGet(Island)?(StepReport|EnergyLedger)", r"dWorldGetEventSettings")

# Enumerations of the crate: (name, the C enumeration or enumerators, what every name loses, text where the header has none).
ENUMS = (
    ("JointKind", "dJointType", "dJointType", ""),
    ("CombineRule", "dCombineRule", "dCombine", ""),
    ("ContactEventKind", "dContactEventKind", "dContact", ""),
    ("EventKind", "dEventKind", "dEvent", ""),
    ("CharacterState", "dCharacterState", "dCharacter", ""),
    ("Defaults", "dDefaults", "dDefaults", ""),
    ("Behaviour", "dBehaviour", "dBehaviour", ""),
    ("DiagnosisKind", "dDiagnosisKind", "dDiagnosis", ""),
    ("Severity", "dSeverity", "dSeverity", ""),
    ("IslandMethod", "dIslandMethod", "dIslandMethod", ""),
    ("Continuous", "dContinuousMode", "dContinuous", ""),
    ("Stepper", "dStepper", "dStepper", ""),
    ("AMotorMode", ("dAMotorUser", "dAMotorEuler", "dAMotorTurn"), "dAMotor", "Modes of the angular motor."),
    ("TransmissionMode", ("dTransmissionParallelAxes", "dTransmissionIntersectingAxes", "dTransmissionChainDrive"), "dTransmission",
     "Modes of the transmission joint."),
    ("CharacterShape", ("dCapsuleClass", "dCylinderClass", "dBoxClass"), "d", "The shape of a character."),
)

# Structures that the crate has as values: C's name -> (its name, whether a program fills it in, fields that are left out).
STRUCTURES = {
    "dMaterial": ("Material", True, ()),
    "dDrive": ("Drive", True, ()),
    "dEventSettings": ("EventSettings", True, ()),
    "dCharacterSettings": ("CharacterSettings", True, ("filter", "data")),
    "dCharacterReport": ("CharacterReport", False, ()),
    "dWorldStepReport": ("StepReport", False, ()),
    "dIslandStepReport": ("IslandStepReport", False, ()),
    "dEnergyLedger": ("EnergyLedger", False, ()),
    "dJointFeedback": ("Feedback", False, ()),
}

# Three numbers in a row that are one vector: the names of the first and the name of the vector.
VECTORS = {("x", "y", "z"): "xyz", ("fx", "fy", "fz"): "force", ("px", "py", "pz"): "point", ("ax", "ay", "az"): "delta",
           ("dx", "dy", "dz"): "delta", ("lx", "ly", "lz"): "lengths", ("rx", "ry", "rz"): "radii", ("ix", "iy", "iz"): "impulse"}

# Getters of live joints and geoms that nothing can make the library refuse: they return the value itself.
NEVER_REFUSED = (r"dBody\w+", r"dWorld\w+", r"dJoint(GetNumBodies|IsEnabled|GetNumAxes|IsBroken|GetBody)",
                 r"dGeom(IsEnabled|GetCategoryBits|GetCollideBits|GetSensor|GetContinuous|IsOffset|GetAABB|IsCharacter|GetMaterial)")
