#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# generate.py INCLUDE_DIR CC OUTPUT: reads what the public headers export and writes a table of calls in C++:
# for every function a piece of code that calls it with values from an array, and what kind of value each
# parameter takes (tests/hostile/table.h). The preprocessor resolves the headers; a declaration is then one
# marker, a result, a name and a list of parameters.
#
# Whoever exports a function has mostly nothing to do: types and names of parameters give their kinds. Else
# - a parameter of an unknown type, or an array whose size another parameter gives: its kind is given in
#   KIND_OF_TYPE or KIND_OF_PARAMETER; a new kind is added to table.h, its values to value_lists.h and
#   values.cpp, and a kind of handle to the objects of scene.cpp (a live and a destroyed one);
# - a pointer that may be null, an argument that is not read, a number that may be NaN: the lists below;
# - an object that a call makes and no scene holds: kMakers in aftermath.cpp.
# A function that is not understood is left out, and the test hostile_covers_exports names it, with the reason.
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools"))
import c_functions

# Never called, and why.
EXCUSED = {name: "ends the program, as documented" for name in ("dError", "dDebug")}

KIND_OF_TYPE = {
    "dWorldID": "World", "const dWorldID*": "WorldList", "const dBodyID*": "BodyList",
    "const dJointID*": "JointHandles", "dBodyID*": "QueryHits", "size_t": "Size", "const void*": "QueryHits",
    "dBodyID": "Body", "dJointID": "Joint", "dJointGroupID": "Group",
    "dGeomID": "Geom", "dSpaceID": "Space", "dHeightfieldDataID": "HeightfieldData",
    "dTriMeshDataID": "TriMeshData", "dFluidID": "Fluid",
    "dThreadingImplementationID": "Threading", "dThreadingThreadPoolID": "ThreadPool",
    "dCooperativeID": "Cooperative", "dResourceRequirementsID": "Requirements",
    "dResourceContainerID": "Container", "const dThreadingFunctionsInfo*": "ThreadingFunctions",
    "const dWorldStepReserveInfo*": "ReserveInfo",
    "const dWorldStepMemoryFunctionsInfo*": "MemoryFunctions",
    "dThreadReadyToServeCallback*": "ReadyCallback",
    "dReal": "Real", "int": "Int", "unsigned": "Int", "unsigned int": "Int", "unsigned long": "Int",
    "dsizeint": "Size",
    "dVector3": "Vector3", "const dVector3": "Vector3", "dVector4": "Vector4",
    "dQuaternion": "Quaternion", "const dQuaternion": "Quaternion",
    "dMatrix3": "Matrix3", "const dMatrix3": "Matrix3", "dReal[4]": "Vector4", "dReal[6]": "Vector6",
    "dReal*": "RealPointer", "int*": "IntPointer", "const int*": "Indices", "dReal**": "Rows",
    "dMass*": "Mass", "const dMass*": "Mass", "const dContact*": "Contact", "dContactGeom*": "Contacts",
    "const dGeomClass*": "GeomClass", "dWorldStepReport*": "WorldReport",
    "dIslandStepReport*": "IslandReport", "dEnergyLedger*": "Ledger", "dStopwatch*": "Stopwatch", "FILE*": "File",
    "const char*": "Text", "dQueryHit*": "QueryHits", "dCastHit*": "QueryHits", "dHandlePair*": "QueryHits", "dSpaceID*": "QueryHits", "dQueryDistance*": "QueryHits", "void*": "Data", "dJointID*": "JointList", "dJointFeedback*": "Feedback", "dGeomID*": "QueryHits",
    "dContactEvent*": "QueryHits", "dDiagnosis*": "QueryHits", "const dDiagnosis*": "QueryHits", "dWorldContact*": "QueryHits", "dEvent*": "QueryHits", "const dEventSettings*": "EventSettings", "dEventSettings*": "EventSettingsBuffer", "const dCharacterSettings*": "CharacterSettings", "dCharacterSettings*": "CharacterSettingsBuffer", "dCharacterReport*": "CharacterReport",
    "const dVehicleSettings*": "VehicleSettings", "dVehicleSettings*": "VehicleSettingsBuffer", "const dVehicleWheel*": "VehicleWheel", "dVehicleWheel*": "VehicleWheelBuffer",
    "const dVehicleControls*": "VehicleControls", "dVehicleControls*": "VehicleControlsBuffer", "dVehicleReport*": "VehicleReport", "dVehicleWheelReport*": "VehicleWheelReport",
    "const dBone*": "Bones", "dBone*": "BoneBuffer", "const dQuaternion*": "Pose", "const dRopeSettings*": "RopeSettings", "dQuaternion*": "QueryHits",
    "const dFracturePart*": "FractureParts", "const dFracture*": "Fractures",
    "dMaterial*": "Material",
    "const dMaterial*": "Material", "dDrive*": "DriveBuffer", "const dDrive*": "Drive", "const dQueryFilter*": "QueryFilter", "dContactFilter*": "ContactFilter",
    "const unsigned char*": "Bytes", "const short*": "Shorts", "const float*": "Floats",
    "const double*": "Doubles",
    "dMessageFunction*": "MessageFunction", "dAllocFunction*": "AllocFunction",
    "dReallocFunction*": "ReallocFunction", "dFreeFunction*": "FreeFunction",
    "dNearCallback*": "NearCallback", "dHeightfieldGetHeight*": "HeightCallback",
    "dManifoldFunction*": "ManifoldFunction", "dFluidSurface*": "FluidSurface", "dFluidCurrent*": "FluidCurrent", "const dFluidSettings*": "FluidSettings", "dFluidSettings*": "FluidSettingsBuffer",
    "dTriCallback*": "TriCallback", "dTriArrayCallback*": "TriArrayCallback", "dTriRayCallback*": "TriRayCallback",
    "dTriTriMergeCallback*": "TriMergeCallback", "const dintptr*": "ExtraData", "dsizeint*": "SizePointer",
    "unsigned char**": "BytesPointer", "unsigned char*": "Data", "dVector3*": "Vector3", "const dMatrix4": "Matrix4",
    "dColliderFn*": "Collider", "void(*)(dBodyID)": "MovedCallback",
}

# (function, parameter) -> kind, where the type alone does not tell. The first line that matches counts.
MATRIX = (r"d(SetZero|SetValue|Dot|Multiply\d|FactorCholesky|SolveCholesky|InvertPDMatrix|IsPositiveDefinite"
          r"|FactorLDLT|SolveL1T?|ScaleVector|VectorScale|SolveLDLT|LDLTAddTL|LDLTRemove|RemoveRowCol"
          r"|PrintMatrix|MakeRandomVector|MakeRandomMatrix|ClearUpperTriangle|MaxDifference\w*)")
KIND_OF_PARAMETER = [
    (r"dPrintMatrix:fmt", "Format"),
    (r"dThreadingAllocateThreadPool:thread_count", "ThreadCount"),
    (r"d(Material|QueryFilter|Drive|EventSettings|CharacterSettings|FluidSettings|VehicleSettings|VehicleWheel|RopeSettings)Init:(material|filter|drive|settings|wheel)", "QueryHits"),
    (r"d(Diagnosis|Defaults)Text:text", "QueryHits"),
    (r"\w+:struct_size", "StructSize"),
    (r"d(Ragdoll|Fracture)\w+:count", "Length"),
    (r"dWorldsStep:(count|steps)", "Length"),
    (r"dWorldsStep:threads", "ThreadCount"),
    (r"dWorldSetBehaviour:version", "Behaviour"),
    (r"dWorldsStep:steps_made", "QueryHits"),
    (r"d(Bodies|Joints)[GS]etStates:(count|stride)", "Length"),
    (r"d(Bodies|Joints)[GS]etStates:(out|in|value|rate)", "QueryHits"),
    (r"dWorldGetJoints:joints", "QueryHits"),
    (r"dWorldGetState(Delta)?:(buffer|out)", "StateBuffer"),
    (r"dWorld[GS]etState(Delta)?:(buffer|base)", "State"),
    (r"dWorldSetStateDelta:delta", "StateDelta"),
    (r"dWorld[GS]etState(Delta)?:(size|capacity|base_size|delta_size)", "BufferSize"),
    (r"dWorldClone:space", "SpacePointer"),
    (r"dWorldSave:path", "SavePath"),
    (r"dWorldLoad:path", "LoadPath"),
    (r"dWorldSaveToBuffer:buffer", "StateBuffer"),
    (r"dWorldLoadFromBuffer:buffer", "WorldFile"),
    (r"dWorld(SaveToBuffer:capacity|LoadFromBuffer:size)", "BufferSize"),
    (r"dSpaceRayBatch:count", "Length"),
    (r"dGeomGetFaceMaterialNumbers:numbers", "QueryHits"),
    (r"dSpaceRayBatch:(origins|directions|lengths)", "Reals"),
    (r"dCooperatively\w+:(rowCount|rowSkip|elementCount)", "Length"),
    (r"dCooperatively\w+:(A|d|L|b|dataVector|scaleVector)", "Reals"),
    (r"d(LDLTRemove|RemoveRowCol):r", "Int"),
    (r"dLDLTRemove:p", "Indices"),
    (MATRIX + r":(n|m|p|q|r|nskip|n1|n2)", "Length"),
    (MATRIX + r":(a|b|d|A|B|C|L|Ainv)", "Reals"),
    (r"d(Collide|BoxBox):flags", "ContactFlags"),
    (r"d(Collide|BoxBox):skip", "Skip"),
    (r"dGeomHeightfieldDataBuild(Byte|Short|Single|Double):(width|depth)Samples", "SampleCount"),
    (r"dGeomHeightfieldDataSetHoles:(width|depth)Cells", "SampleCount"),
    (r"d(Create|GeomSet)Convex(Hull)?:planecount", "FaceCount"),
    (r"d(Create|GeomSet)Convex(Hull)?:pointcount", "PointCount"),
    (r"d(Create|GeomSet)Convex(Hull)?:planes", "FacePlanes"),
    (r"d(Create|GeomSet)Convex(Hull)?:points", "FacePoints"),
    (r"d(Create|GeomSet)Convex(Hull)?:polygons", "Faces"),
    (r"dGeomTriMeshData\w+:VertexStride", "VertexStride"),
    (r"dGeomTriMeshData\w+:VertexCount", "VertexCount"),
    (r"dGeomTriMeshData\w+:TriStride", "TriangleStride"),
    (r"dGeomTriMeshData\w+:IndexCount", "CornerCount"),
    (r"dGeomTriMeshData\w+:Vertices", "Vertices"),
    (r"dGeomTriMeshData\w+:Indices", "Corners"),
    (r"dGeomTriMeshData\w+:Normals", "Data"),
    (r"dGeomConvexGet\w+:(points|planes)", "Reals"),
    (r"dGeomConvexGet\w+:polygons", "FaceBuffer"),
    (r"dGeomGetTriangles:facets", "QueryHits"),
    (r"dGeomGetTriangles:segments", "SampleCount"),
    (r"d(Realloc|Free):ptr", "Block"),
    (r"dJoint(Get|Set)\w*Param:parameter", "ParameterNumber"),
    (r"dGeomLowLevelControl:dataValue", "Control"),
    (r"dJointSet\w+:axis[12]", "Vector3"),
]

# Handles and pointers that may be null.
MAY_BE_NULL = [
    r"dCreate\w*:space", r"dRagdollCreate:(space|position|orientation)", r"dFractureBreak:center", r"dWorldShiftOrigin:space", r"dGeomSetFaceMaterial:material", r"dGeomSetFaceMaterialNumbers:numbers", r"dRopeCreate:(space|first|last|settings|joints)", r"d\w+SpaceCreate:space", r"dJointCreate\w*:group", r"dJointAttach:body[12]",
    r"dGeomSetBody:body", r"dConnectingJoint(List)?:body[12]", r"dAreConnected(Excluding)?:(body2|arg2)",
    r"dGeomTransformSetGeom:obj", r"dCreateHeightfield:data", r"dGeomHeightfieldSetHeightfieldData:d",
    r"\w+:(data|pUserData)", r"dJointSetFeedback:feedback", r"dSet\w+Handler:fn", r"dSetColliderOverride:fn",
    r"dBodySetMovedCallback:callback", r"dHashSpaceGetLevels:(min|max)level", r"dGeomLowLevelControl:dataValue",
    r"dJointSetDrive:drive", r"dJointSetCouplingAxis:joint", r"dWorldGetBrokenJoints:joints", r"dWorldSetContactSpace:space", r"dWorldSetContactFilter:filter", r"dWorldSetManifoldFunction:function", r"dGeomSetMaterial:material", r"dSpace\w+:filter",
    r"d(Realloc|Free):ptr", r"dJointGet(Universal|PU)Angles:angle[12]",
    r"dJointSetHinge2Axes:axis[12]",
    r"dWorldSetStepThreadingImplementation:(functions_info|threading_impl)",
    r"dCooperativeCreate:(functionInfo|threadingImpl)", r"dExternalThreading\w+:(readiness_callback|callback_context)",
    r"dThreadingAllocateThreadPool:reserved", r"dThreadingFree\w+:\w+", r"dWorldUseSharedWorkingMemory:from_world",
    r"dWorldSetStepMemory\w+:(policyinfo|memfuncs)", r"d(Cooperative|Resource\w+)Destroy:\w+",
    r"dWorldExportDIF:world_name",
    r"d(Create|GeomTriMeshSet)\w+:(Data|\w*Callback)", r"dGeomTriMeshGetTriangle:v[012]",
    r"dGeomTriMeshData\w+:(Normals|requestExtraData|in_data|pout_size|buf|bufLen)",
    r"dGeomConvexGet\w+:(points|planes|polygons)", r"dGeomGetTriangles:facets",
    r"dWorldsStep:(worlds|steps_made)",
    r"d(Bodies|Joints)[GS]etStates:(bodies|joints|out|in|value|rate)", r"dWorldGet(Bodies|Joints):(bodies|joints)",
    r"dWorldGetStateDelta:out",
    r"dWorld(Clone|CountHandles|Save|Load)\w*:space", r"dWorldClone:table", r"dWorldSaveToBuffer:buffer",
    r"dGeomHeightfieldDataSetHoles:holes", r"dWorldDiagnose:causes", r"dDefaultsText:text", r"dWorldGetEvents:events", r"d(WorldSetEventSettings|CharacterCreate|VehicleCreate):settings", r"dVehicleAddWheel:wheel", r"dFluidSetSurface:surface", r"dFluidSetCurrentFunction:current",
    r"dFluidSetVolume:volume", r"dFluidGetSubmerged\w*:(volume|centre)", r"dBodyGetFluidForce:(force|torque)", r"dBodyApply(Impulse|Force):pos", r"dBodySetVelocities:(linear|angular)", r"dWorldGetContacts:contacts", r"dWorldGetContactEvents:events", r"dSpaceRayAll:hits", r"dSpaceOverlap:geoms", r"dSpaceRayBatch:(origins|directions|lengths|hits)",
    # With no elements there is nothing to point to.
    r"d(SetZero|SetValue|Dot|ScaleVector|VectorScale|FactorLDLT):(a|b|d|A)",
    r"dCooperatively\w+:(A|L|b|d|dataVector|scaleVector)",
]
# Parameters that are documented not to be looked at.
NOT_READ = [r"dInfiniteAABB:geom", r"dLDLTRemove:A",
            # Whatever the program's own threading functions understand.
            r"dWorldSetStepThreadingImplementation:threading_impl", r"dCooperativeCreate:threadingImpl"]
# Numbers that are handed on as they are: NaN included.
ANY_NUMBER = [r"dSetValue:value"]

READER = re.compile(r"d(World|Body|Joint|Geom|Space|HashSpace|Fluid|Vehicle)\w*(Get|Is[A-Z]|Copy)|dRandGetSeed|dGet\w+Handler$")
NO_READER = re.compile(r"d(Geom|Body)(GetRelPoint\w+|GetPosRelPoint|GetPointVel)|dGeomIsSpaceX")
HANDLES = {"World", "Body", "Joint", "Group", "Geom", "Space", "HeightfieldData", "Threading", "ThreadPool",
           "Cooperative", "Requirements", "Container", "TriMeshData", "Fluid"}
ADDED = {"Vector3", "Vector4", "Quaternion", "Matrix3", "Vector6", "Mass", "RealPointer", "IntPointer"}


def matches(patterns, name):
    return any(re.fullmatch(p, name) for p in patterns)


def type_and_name(parameter, index):
    callback = re.fullmatch(r"(\w+) ?\( ?\* ?(\w+)\) ?\((.*)\)", parameter)
    if callback:
        return f"{callback[1]}(*)({callback[3]})", callback[2]
    if re.fullmatch(r"(const )?\w+(\*+)?", parameter) and parameter.split("const ")[-1].split("*")[0] in BARE:
        return parameter.replace(" *", "*"), f"arg{index + 1}"
    whole = re.fullmatch(r"(.*?[ *])(\w+)((\[\d*\])?)", parameter)
    return (whole[1].strip().replace(" *", "*") + whole[3]), whole[2]


BARE = {"dWorldID", "dBodyID", "dJointID", "dJointGroupID", "dGeomID", "dSpaceID", "int", "dReal", "dJointType"}


def kind_of(function, ctype, name):
    for pattern, kind in KIND_OF_PARAMETER:
        if re.fullmatch(pattern, f"{function}:{name}"):
            return kind
    return KIND_OF_TYPE.get(ctype)


# Why a function is not in the table, or None.
def unknown(name, typed):
    for ctype, parameter in typed:
        if kind_of(name, ctype, parameter) is None:
            return f"nothing is known of '{ctype} {parameter}': see tests/hostile/generate.py"
    return None


def declarations(text):
    for m in re.finditer(r"EPODE_EXPORTED ([^;{]*?)(\bd[A-Z]\w*) ?\(([^;]*)\);", text):
        yield m[1].strip(), m[2], c_functions.split(m[3])


def reading(name, kinds):
    if not READER.match(name) or NO_READER.match(name):
        return False
    if not kinds:
        return True
    return kinds[0] in HANDLES and all(k in ADDED or k in ("Int", "ParameterNumber") for k in kinds[1:])


def entry(index, result, name, typed):
    kinds = [kind_of(name, t, n) for t, n in typed]
    stateful = any(k in HANDLES for k in kinds)
    lines, arguments = [], []
    for i, (ctype, _) in enumerate(typed):
        plain = re.sub(r"\[\d*\]", "*", re.sub(r"(const )?d(Vector3|Vector4|Quaternion|Matrix3|Matrix4)$", "dReal*", ctype))
        arguments.append(f"a[{i}].as<{plain}>()")
    call = f"{name}({', '.join(arguments)})"
    body = f"{call};\n    return {{}};" if result == "void" else f"return result_of({call});"
    unused = "" if arguments else "[[maybe_unused]] "
    lines.append(f"Result call_{index}({unused}const Value* a)\n{{\n    {body}\n}}")
    described = []
    for kind, (ctype, pname) in zip(kinds, typed):
        key = f"{name}:{pname}"
        flags = [f for f, on in (("kMayBeNull", matches(MAY_BE_NULL, key)), ("kNotRead", matches(NOT_READ, key)),
                                 ("kAnyNumber", matches(ANY_NUMBER, key)),
                                 ("kInput", ctype.startswith("const ") and stateful)) if on]
        described.append(f'{{Kind::k{kind}, "{pname}", {" | ".join(flags) or "0"}}}')
    if described:
        lines.append(f"const Parameter parameters_{index}[] = {{{', '.join(described)}}};")
    flags = "kReader" if reading(name, kinds) else "0"
    table = f'{{"{name}", call_{index}, {f"parameters_{index}" if described else "nullptr"}, {len(kinds)}, {flags}}}'
    return lines, table


def main():
    include, cc, output = sys.argv[1:4]
    lines, table, absent, joints = [], [], [], []
    for result, name, parameters in declarations(c_functions.preprocessed(include, cc)):
        typed = [type_and_name(p, i) for i, p in enumerate(parameters)]
        if name.startswith("dJointCreate") and [kind for kind, _ in typed] == ["dWorldID", "dJointGroupID"]:
            joints.append(name)
        reason = EXCUSED.get(name) or unknown(name, typed)
        if reason:
            absent.append(f'{{"{name}", "{reason}", {"true" if name in EXCUSED else "false"}}}')
            continue
        code, row = entry(len(table), result, name, typed)
        lines += code
        table.append(row)
    with open(output, "w", encoding="ascii") as f:
        f.write("// Written by tests/hostile/generate.py from the public headers.\n")
        f.write("\n".join(lines))
        f.write("\nconst Function kTable[] = {\n    " + ",\n    ".join(table) + "};\n")
        f.write("\nconst Absent kAbsent[] = {\n    " + ",\n    ".join(absent) + "};\n")
        f.write("\nconst CreateJoint kJoints[] = {\n    " + ",\n    ".join(joints) + "};\n")


main()
