# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What generate.py cannot tell from a declaration: which functions are written by hand and where, and which are left
out and why. The first pattern that matches a name counts."""

# Bound by hand in src/written.cpp, src/arrays.cpp, src/shapes.cpp or src/callbacks.cpp, where sizes of arrays or callbacks need care: the signature, which
# the stub and the docstring have. FloatArray is NDArray[float64]; structured arrays are NDArray[Any].
_OF_WORLD = "(world: dWorldID | None) -> NDArray[Any]"
_HEIGHTS = ("(d: dHeightfieldDataID | None, heights: ArrayLike, width: float, depth: float, scale: float = 1.0, "
            "offset: float = 0.0, thickness: float = 0.0, bWrap: bool = False) -> None")
_MESH = "(g: dTriMeshDataID | None, vertices: ArrayLike, indices: ArrayLike) -> None"
_NEAR = "Callable[[dGeomID, dGeomID], Any]"
WRITTEN = {
    "dWorldsStep": "(worlds: Sequence[dWorldID], stepsize: float, stepper: int = ..., iterations: int = 4, steps: int = 1, "
                   "threads: int = 0) -> list[int]",
    "dBodiesGetStates": "(bodies: BodyList, fields: int, out: FloatArray | None = None) -> FloatArray",
    "dBodiesSetStates": "(bodies: BodyList, fields: int, states: ArrayLike) -> None",
    "dJointsGetStates": "(joints: JointList, stride: int = 1) -> tuple[FloatArray, FloatArray]",
    "dWorldGetBodies": "(world: dWorldID | None) -> BodyList",
    "dWorldGetJoints": "(world: dWorldID | None) -> JointList",
    "dWorldGetBrokenJoints": "(world: dWorldID | None) -> JointList",
    "dWorldGetState": "(world: dWorldID | None) -> bytes",
    "dWorldSetState": "(world: dWorldID | None, state: bytes) -> None",
    "dWorldGetStateDelta": "(world: dWorldID | None, base: bytes) -> bytes",
    "dWorldSetStateDelta": "(world: dWorldID | None, base: bytes, delta: bytes) -> None",
    "dWorldClone": "(world: dWorldID | None, space: dSpaceID | None = None) -> tuple[dWorldID, dSpaceID | None, dict[Any, Any]]",
    "dWorldSave": "(world: dWorldID | None, space: dSpaceID | None, path: str) -> int",
    "dWorldSaveToBuffer": "(world: dWorldID | None, space: dSpaceID | None = None) -> bytes",
    "dWorldLoad": "(path: str) -> tuple[dWorldID, dSpaceID | None]",
    "dWorldLoadFromBuffer": "(buffer: bytes) -> tuple[dWorldID, dSpaceID | None]",
    "dWorldDiagnose": "(world: dWorldID | None) -> list[tuple[Any, ...]]",
    "dDefaultsText": "(preset: int) -> str",
    "dWorldGetContacts": _OF_WORLD,
    "dWorldGetContactEvents": _OF_WORLD,
    "dWorldGetEvents": _OF_WORLD,
    "dSpaceRayAll": "(space: dSpaceID | None, origin: ArrayLike, direction: ArrayLike, length: float, "
                    "filter: dQueryFilter | None = None) -> NDArray[Any]",
    "dSpaceRayBatch": "(space: dSpaceID | None, origins: ArrayLike, directions: ArrayLike, lengths: ArrayLike, "
                      "filter: dQueryFilter | None = None, threads: int = 0) -> NDArray[Any]",
    "dSpaceOverlap": "(space: dSpaceID | None, geom: dGeomID | None, filter: dQueryFilter | None = None) -> list[dGeomID]",
    "dCollide": "(o1: dGeomID | None, o2: dGeomID | None, flags: int = 8) -> list[dContactGeom]",
    "dConnectingJointList": "(body1: dBodyID | None, body2: dBodyID | None) -> list[dJointID]",
    "dCreateConvex": "(space: dSpaceID | None, planes: ArrayLike, points: ArrayLike, polygons: ArrayLike) -> dGeomID",
    "dGeomSetConvex": "(convex: dGeomID | None, planes: ArrayLike, points: ArrayLike, polygons: ArrayLike) -> None",
    "dCreateConvexHull": "(space: dSpaceID | None, points: ArrayLike, maxvertices: int = 0) -> dGeomID",
    "dGeomSetConvexHull": "(convex: dGeomID | None, points: ArrayLike, maxvertices: int = 0) -> None",
    "dGeomConvexGetPoints": "(convex: dGeomID | None) -> FloatArray",
    "dGeomConvexGetPlanes": "(convex: dGeomID | None) -> FloatArray",
    "dGeomConvexGetPolygons": "(convex: dGeomID | None) -> list[int]",
    "dGeomGetTriangles": "(geom: dGeomID | None, segments: int = 24) -> FloatArray",
    "dGeomHeightfieldDataBuildByte": _HEIGHTS,
    "dGeomHeightfieldDataBuildShort": _HEIGHTS,
    "dGeomHeightfieldDataBuildSingle": _HEIGHTS,
    "dGeomHeightfieldDataBuildDouble": _HEIGHTS,
    "dGeomHeightfieldDataBuildCallback":
        "(d: dHeightfieldDataID | None, callback: Callable[[int, int], float], width: float, depth: float, "
        "widthSamples: int, depthSamples: int, scale: float, offset: float, thickness: float, bWrap: bool) -> None",
    "dGeomHeightfieldDataSetHoles": "(d: dHeightfieldDataID | None, holes: ArrayLike) -> None",
    "dGeomTriMeshDataBuildDouble": _MESH,
    "dGeomTriMeshDataBuildSimple": _MESH,
    "dCreateTriMesh": "(space: dSpaceID | None, data: dTriMeshDataID | None) -> dGeomID",
    "dGeomTriMeshGetTriangle": "(g: dGeomID | None, index: int) -> tuple[FloatArray, FloatArray, FloatArray]",
    "dJointSetFeedback": "(joint: dJointID | None, feedback: dJointFeedback | None) -> None",
    "dJointGetFeedback": "(joint: dJointID | None) -> dJointFeedback | None",
    "dSpaceCollide": f"(space: dSpaceID | None, callback: {_NEAR}) -> None",
    "dSpaceCollide2": f"(o1: dGeomID | None, o2: dGeomID | None, callback: {_NEAR}) -> None",
    "dBodySetMovedCallback": "(body: dBodyID | None, callback: Callable[[dBodyID], Any] | None) -> None",
    "dWorldSetContactFilter": "(world: dWorldID | None, filter: Callable[[dGeomID, dGeomID], bool] | None) -> None",
    "dQueryFilterInit": "(filter: dQueryFilter) -> None",
    "dJointSetHinge2Axes": "(joint: dJointID | None, axis1: ArrayLike | None, axis2: ArrayLike | None) -> None",
}
WRITTEN_CLASSES = """class BodyList:
    def __init__(self, handles: Sequence[dBodyID]) -> None: ...
    def __len__(self) -> int: ...
    def __getitem__(self, index: int) -> dBodyID: ...


class JointList:
    def __init__(self, handles: Sequence[dJointID]) -> None: ...
    def __len__(self) -> int: ...
    def __getitem__(self, index: int) -> dJointID: ...


class dQueryFilter:
    category_bits: int
    collide_bits: int
    skip_body: dBodyID | None
    callback: Callable[[dGeomID], bool] | None
    def __init__(self) -> None: ...


class WorldRecording:
    def __init__(self) -> None: ...
    def about(self, pairs: Sequence[tuple[str, str]]) -> None: ...
    def value(self, key: str) -> str: ...
    def take_state(self, world: dWorldID, time: float, dt: float, milliseconds: float) -> None: ...
    def __len__(self) -> int: ...
    def hash(self, state: int) -> int: ...
    def figures(self) -> FloatArray: ...
    def bodies(self, state: int) -> FloatArray: ...
    def living(self, state: int) -> list[int]: ...
    def save(self, path: str, fps: float) -> None: ...
    def load(self, path: str) -> None: ...
    def picture(self, state: int, width: int, height: int, eye: ArrayLike | None, target: ArrayLike | None) -> bytes: ...


class _Painter:
    def __init__(self) -> None: ...
    def draw(self, recording: WorldRecording, state: int, width: int, height: int, eye: ArrayLike | None, target: ArrayLike | None) -> None: ...
    def close(self) -> None: ...


def _camera(recording: WorldRecording, state: int, aspect: float) -> tuple[FloatArray, FloatArray]: ...
def _screen(width: int, height: int) -> bytes: ...
def run_command(words: Sequence[str]) -> int: ...


class _RobotModel:
    name: str
    format: str
    gravity: FloatArray
    position_count: int
    velocity_count: int
    reference: FloatArray
    not_built: list[str]
    report: list[Any]
    links: list[Any]
    joints: list[Any]
    actuators: list[Any]
    starts: dict[str, FloatArray]
    sensors: list[Any]
    frame_names: list[str]
    def __init__(self, path: str, text: str | None, options: dict[str, Any]) -> None: ...
    def frame(self, name: str) -> tuple[int, FloatArray] | None: ...
    def poses(self, positions: ArrayLike) -> FloatArray: ...
    def jacobian(self, positions: ArrayLike, link: int, point: ArrayLike) -> FloatArray: ...
    def mass_matrix(self, positions: ArrayLike) -> FloatArray: ...
    def inverse_dynamics(self, positions: ArrayLike, velocities: ArrayLike, accelerations: ArrayLike) -> FloatArray: ...
    def inverse(self, guess: ArrayLike, goals: Sequence[Any], weights: ArrayLike | None, posture: ArrayLike | None,
                max_iterations: int, max_starts: int, tolerance: float) -> Any: ...
    def save(self, path: str) -> list[str]: ...
    def text(self, as_urdf: bool, folder: str) -> tuple[str, list[str]]: ...
    def build(self, world: dWorldID, space: dSpaceID, pose: FloatArray) -> _Robot: ...


class _Robot:
    bodies: list[dBodyID]
    joints: list[dJointID]
    geoms: list[dGeomID]
    def body(self, link: int) -> dBodyID | None: ...
    def joint(self, joint: int) -> dJointID | None: ...
    def release(self) -> None: ...
    def positions(self) -> FloatArray: ...
    def velocities(self) -> FloatArray: ...
    def set_positions(self, positions: ArrayLike) -> None: ...
    def set_velocities(self, velocities: ArrayLike) -> None: ...
    def control(self, actuator: int) -> float: ...
    def set_control(self, actuator: int, value: float) -> None: ...
    def set_target(self, joint: int, target: float, stiffness: float, damping: float) -> None: ...
    def update_sensors(self, h: float) -> None: ...
    def drive_forces(self) -> FloatArray: ...
    def imu(self, link: int, frame: FloatArray) -> tuple[FloatArray, FloatArray]: ...
    def watch_force(self, link: int, on: bool) -> bool: ...
    def force_torque(self, link: int, frame: FloatArray) -> tuple[FloatArray, FloatArray]: ...
    def touch(self, link: int) -> Any: ...
    def rays(self, link: int, frame: FloatArray, space: dSpaceID, directions: ArrayLike, max_distance: float) -> FloatArray: ...
    def picture(self, link: int, frame: FloatArray, space: dSpaceID, width: int, height: int, field: float,
                max_distance: float, threads: int) -> tuple[bytes, FloatArray, bytes]: ...
    def read_sensor(self, sensor: int, space: dSpaceID) -> FloatArray: ...


def _many_positions(robots: Sequence[_Robot]) -> FloatArray: ...
def _many_velocities(robots: Sequence[_Robot]) -> FloatArray: ...
def _set_many_positions(robots: Sequence[_Robot], positions: ArrayLike) -> None: ...
def _set_many_velocities(robots: Sequence[_Robot], velocities: ArrayLike) -> None: ...
def _set_many_controls(robots: Sequence[_Robot], controls: ArrayLike) -> None: ...
def _get_materials(geoms: Sequence[dGeomID]) -> NDArray[Any]: ...
def _set_materials(geoms: Sequence[dGeomID], materials: NDArray[Any]) -> None: ...
def _set_exceptions(refused: type, dead: type, busy: type, warning: type) -> None: ..."""

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
    r"dWorldCountHandles": "dWorldClone returns all handles",
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

# Code after a call, of its first argument: objects are gone, and what was kept for them (callbacks, arrays) is let go.
AFTER = {
    r"d(Body|Joint|GeomTriMeshData|GeomHeightfieldData)Destroy": "forget({});",
    r"dJointGroup(Destroy|Empty)": "forget_joints();",
    r"dWorldDestroy": "forget_world({});",
}
