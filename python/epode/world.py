# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Worlds."""
from __future__ import annotations

import collections
import itertools
import os
import time
import typing
import weakref
from collections.abc import Callable, Sequence
from types import TracebackType

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _c, c
from ._assembly import Assembly, assemble
from ._handle import FloatArray, Object, Value, flag, put_settings, reads_and_sets, share, three
from ._portions import portions
from ._robot_states import joined, numbers_of, set_numbers, split
from ._structure import Description, Past, Structure
from .body import Bodies, Body
from .character import SETTINGS as CHARACTER_SETTINGS
from .character import Character
from .enums import Behaviour, CauseKind, Falloff, RopeEnds, Severity
from .errors import RefusedError
from .fluid import Fluid
from .fracture import Fracture, meet_pieces
from .geom import Geom
from .joint import SETTINGS, TYPES, Joint
from .ragdoll import Bone, Ragdoll
from .recording import Recording
from .rope import Rope
from .shapes import Material, Plane, Shape
from .vehicle import Vehicle

if typing.TYPE_CHECKING:
    from .robot import Robot

Contacts = NDArray[typing.Any]
Made = typing.TypeVar("Made", bound=Assembly)
_STEPS: dict[str, Callable[[c.dWorldID, float], int]] = {"exact": c.dWorldStep, "quick": c.dWorldQuickStep, "hybrid": c.dWorldStepHybrid}
_STEPPERS = {"hybrid": c.dStepperHybrid, "exact": c.dStepperExact, "substeps": c.dStepperSubsteps,
             "substeps_exact_joints": c.dStepperSubstepsExactJoints, "quick": c.dStepperQuick}
_DEFAULTS = {"ode": c.dDefaultsOde, "game": c.dDefaultsGame, "robot": c.dDefaultsRobot}
_SPACES: dict[str, Callable[[None], c.dSpaceID]] = {"hash": c.dHashSpaceCreate, "simple": c.dSimpleSpaceCreate}


class Cause(typing.NamedTuple):
    """What makes a world misbehave: the objects to blame, as far as they are alive, the worst figure and what it should stay
    below (``c.dDiagnosisKind`` has their unit), the step in which it was seen first, and in how many."""
    kind: CauseKind
    severity: Severity
    body: Body | None
    other: Body | None
    joint: Joint | None
    geom: Geom | None
    figure: float
    threshold: float
    first_step: int
    steps: int
    text: str


def _unpickled(file: bytes, description: Description, numbers: list[int], robots: Sequence[typing.Any] = ()) -> World:
    """The world that ``World.__reduce__`` has written."""
    handle, space = c.dWorldLoadFromBuffer(file)
    assert space is not None
    world = World._around(handle, space)
    geoms = [c.dSpaceGetGeom(space, i) for i in numbers]
    bodies, joints = c.dWorldGetBodies(handle), c.dWorldGetJoints(handle)
    world._adopt(description, [bodies[i] for i in range(len(bodies))], [joints[i] for i in range(len(joints))],
                 [geom for geom in geoms if geom is not None])
    for model, pose, places, state in robots:
        like = model.build(World(), position=pose[:3], quaternion=pose[3:])  # its parts stand in the same order
        type(like)._copied(model, like._live, world, places)._live.set_state(state)
    return world


def load_world(path: str | os.PathLike[str]) -> World:
    """The world of a file that ``World.save_file``, the command or dWorldSave has written. Its bodies, joints and geoms are in the
    order of their creation; robots in it are bodies and joints like others."""
    handle, space = c.dWorldLoad(os.fspath(path))
    if space is None:
        space = c.dHashSpaceCreate(None)
    world = World._around(handle, space)
    found, others = c.dWorldGetBodies(handle), c.dWorldGetJoints(handle)
    bodies, joints = [found[i] for i in range(len(found))], [others[i] for i in range(len(others))]
    geoms = [geom for i in range(c.dSpaceGetNumGeoms(space)) if (geom := c.dSpaceGetGeom(space, i)) is not None]
    world._adopt(Description.of_handles(bodies, joints, geoms), bodies, joints, geoms)
    return world


class World(Object):
    """A world of bodies, joints and geoms, which finds its contacts by itself. At the end of a ``with`` block it is destroyed; it is
    destroyed too when nothing refers to it, or to anything in it, any more."""

    __slots__ = ("_bodies", "_joints", "_geoms", "_space", "_body_list", "bodies", "_group", "_past", "_edition", "_recording", "stepper", "_robots", "_fluids",
                 "_assemblies", "_hands")
    _bodies: dict[c.dBodyID, Body]
    _joints: dict[c.dJointID, Joint]
    _geoms: dict[int, Geom]
    _space: c.dSpaceID
    _body_list: c.BodyList | None
    _past: collections.deque[Past] | None  # after the steps that can be taken back
    _hands: list[Callable[[float], None]]  # of windows: called with its size before each step of ``step``
    stepper: str  # of step()
    _edition: int  # grows when something is made or destroyed
    _recording: Recording | None
    _robots: list[Robot]
    _fluids: list[Fluid]
    _assemblies: list[Assembly]

    def __init__(self, *, gravity: ArrayLike = (0, 0, -9.81), contacts: bool = True, threads: int | None = None,
                 space: str = "hash", defaults: str = "ode") -> None:
        """A new, empty world.

        gravity: m/s^2. contacts: whether steps find and solve contacts; False leaves them to ``collide``. threads: of a step, 0 for
        one on each processor, None: as ``defaults`` say. space: "hash", or "simple" for a handful of geoms. defaults: "game" or
        "robot" for parameters of steps that suit these (``use_defaults``), "ode" for ODE's."""
        self._live = None
        if space not in _SPACES:
            raise ValueError(f"no space is called {space!r}: {', '.join(_SPACES)}")
        if defaults not in _DEFAULTS:
            raise ValueError(f"no defaults are called {defaults!r}: {', '.join(_DEFAULTS)}")
        self._live = c.dWorldCreate()
        self._bodies, self._joints, self._geoms, self._body_list, self._past, self._recording = {}, {}, {}, None, None, None
        self._hands = []
        self._edition = 0
        self._robots = []
        self._fluids = []
        self._assemblies = []
        self._space = _SPACES[space](None)
        self._group = c.dJointGroupCreate(0)
        self.bodies = Bodies(self)
        self.gravity = gravity
        if contacts:
            c.dWorldSetContactSpace(self._live, self._space)
        self.stepper = "exact"
        if defaults != "ode":
            self.use_defaults(defaults)
        if threads is not None:
            self.threads = threads

    def __repr__(self) -> str:
        if not self.alive:
            return super().__repr__()
        counts = ((self._bodies, "bodies"), (self._joints, "joints"), (self._geoms, "geoms"), (self._robots, "robots"))
        return f"<epode.World: {', '.join(f'{len(group)} {name}' for group, name in counts)}>"

    def __enter__(self) -> typing.Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.destroy()

    def __del__(self) -> None:
        if getattr(self, "_live", None) is not None:
            try:
                self.destroy()
            except Exception:  # at the interpreter's end, or busy in a step of another thread
                pass

    def destroy(self) -> None:
        """Destroy the world and all that is in it. A second time does nothing."""
        if self._live is None:
            return
        c.dJointGroupDestroy(self._group)
        c.dWorldDestroy(self._live)
        c.dSpaceDestroy(self._space)
        self._live = None
        self._past = None
        for objects in (self._bodies, self._joints, self._geoms):
            for one in objects.values():
                one._live = None
            objects.clear()
        for fluid in self._fluids:
            fluid._live = None
        self._fluids.clear()
        self._assemblies.clear()
        for robot in self._robots:
            robot._dead()
        self._robots.clear()

    @property
    def gravity(self) -> FloatArray:
        """m/s^2."""
        return c.dWorldGetGravity(self._handle)

    @gravity.setter
    def gravity(self, value: ArrayLike) -> None:
        c.dWorldSetGravity(self._handle, *three(value, "gravity"))

    def use_defaults(self, preset: str) -> None:
        """Give all parameters of steps the values for a purpose: "game", "robot", or "ode" (those of a new world), and
        take the stepper that goes with them. Bodies made later are concerned. ``defaults_text`` lists the values."""
        if preset not in _DEFAULTS:
            raise ValueError(f"no defaults are called {preset!r}: {', '.join(_DEFAULTS)}")
        c.dWorldUseDefaults(self._handle, _DEFAULTS[preset])
        self.stepper = "exact" if preset == "ode" else "hybrid"

    erp = share(c.dWorldGetERP, c.dWorldSetERP, "Share of a joint's error that is corrected in a step.")
    cfm = reads_and_sets(c.dWorldGetCFM, c.dWorldSetCFM, "Softness of joints.")
    threads = reads_and_sets(c.dWorldGetStepThreads, c.dWorldSetStepThreads, "Largest number of threads of a step; 0: all.")
    quick_iterations = reads_and_sets(c.dWorldGetQuickStepNumIterations, c.dWorldSetQuickStepNumIterations, "Of quick steps.")
    hybrid_substeps = reads_and_sets(c.dWorldGetHybridSubsteps, c.dWorldSetHybridSubsteps, "Substeps of a hybrid step.")
    hybrid_budget = reads_and_sets(c.dWorldGetHybridBudget, c.dWorldSetHybridBudget,
                                   "Time of the exact solutions in a hybrid step, times that of substeps.")
    exact_substeps = reads_and_sets(c.dWorldGetExactSubsteps, c.dWorldSetExactSubsteps, "Substeps of an exact step.")
    joint_coordinates = flag(c.dWorldGetJointCoordinates, c.dWorldSetJointCoordinates,
                             "Solve robots in step() in the coordinates of their joints, which stay closed.")
    exact_rotation = flag(c.dWorldGetExactRotation, c.dWorldSetExactRotation, "Rotate bodies under joints and contacts exactly, too.")
    friction_cone = flag(c.dWorldGetFrictionCone, c.dWorldSetFrictionCone,
                         "Whether friction is Coulomb's: in exact steps bounded by the normal forces that act, as in an arch.")
    projection = reads_and_sets(c.dWorldGetStepProjection, c.dWorldSetStepProjection,
                                "Newton iterations that close joints after an exact step; 0: none.")
    behaviour: Value[Behaviour, int] = Value(lambda self: Behaviour(c.dWorldGetBehaviour(self._handle)),
                                             lambda self, value: c.dWorldSetBehaviour(self._handle, value),
                                             doc="Whose results steps have.")
    auto_disable = flag(c.dWorldGetAutoDisableFlag, c.dWorldSetAutoDisableFlag, "Whether new bodies may fall asleep.")
    reports = flag(c.dWorldGetStepReportMode, c.dWorldSetStepReportMode, "Whether steps are reported (``report``).")
    keeps_ledger = flag(c.dWorldGetEnergyLedgerMode, c.dWorldSetEnergyLedgerMode, "Whether steps account for energy (``ledger``).")
    diagnosing = flag(c.dWorldGetDiagnosisMode, c.dWorldSetDiagnosisMode, "Whether steps look for causes of failure (``diagnose``).")

    # ---- what is in it ----

    def body(self, *, mass: float | None = None, density: float | None = None, position: ArrayLike | None = None,
             rotation: ArrayLike | None = None, quaternion: ArrayLike | None = None, velocity: ArrayLike | None = None,
             angular_velocity: ArrayLike | None = None, shape: Shape | None = None, material: Material | None = None,
             kinematic: bool = False, inertia: ArrayLike | None = None) -> Body:
        """A new body. With a shape it has a geom, and its inertia; mass, kg, or density, kg/m^3 (1000 if neither is
        given), tells how heavy it is."""
        body = Body(self, c.dBodyCreate(self._handle))
        self._bodies[body._live] = body
        self._body_list = None
        self._edition += 1
        try:
            geom = self.geom(shape, body=body, material=material) if shape is not None else None
            if mass is not None or density is not None or shape is not None:
                self._set_mass(body, geom, mass, density, inertia)
            for name, value in (("position", position), ("rotation", rotation), ("quaternion", quaternion),
                                ("velocity", velocity), ("angular_velocity", angular_velocity)):
                if value is not None:
                    setattr(body, name, value)
            if kinematic:
                body.kinematic = True
        except BaseException:
            body.destroy()
            raise
        return body

    @staticmethod
    def _set_mass(body: Body, geom: Geom | None, mass: float | None, density: float | None, inertia: ArrayLike | None) -> None:
        for name, value in (("mass", mass), ("density", density)):
            if value is not None and not 0 < value < float("inf"):
                raise RefusedError(f"{name} is {value}; a positive number is expected")
        if geom is None or inertia is not None:
            m = c.dMass()
            i = np.asarray(np.eye(3) if inertia is None else inertia, float)
            c.dMassSetParameters(m, 1.0 if mass is None else mass, 0, 0, 0, i[0, 0], i[1, 1], i[2, 2], i[0, 1], i[0, 2], i[1, 2])
        else:
            m = geom.shape._mass(mass, 1000.0 if density is None else density, geom._handle)
            centre = [float(v) for v in m.c[:3]]
            if any(centre):
                c.dGeomSetOffsetPosition(geom._handle, *(-v for v in centre))
                c.dMassTranslate(m, *(-v for v in centre))
        c.dBodySetMass(body._handle, m)

    def geom(self, shape: Shape, *, body: Body | None = None, position: ArrayLike | None = None, rotation: ArrayLike | None = None,
             quaternion: ArrayLike | None = None, offset: ArrayLike | None = None, material: Material | None = None) -> Geom:
        """A new geom of a shape: on a body, or fixed in the world at a position."""
        self._handle
        if not isinstance(shape, Shape):
            raise TypeError(f"a shape such as epode.Box(1, 1, 1) is expected, not {shape!r}")
        if body is not None and body.world is not self:
            raise RefusedError("the body is in another world")
        geom = Geom(self, shape._create(self._space), shape, body)
        self._geoms[geom._key] = geom
        self._edition += 1
        try:
            if body is not None:
                c.dGeomSetBody(geom._live, body._handle)
                body.geoms.append(geom)
            for name, value in (("position", position), ("rotation", rotation), ("quaternion", quaternion),
                                ("offset", offset), ("material", material)):
                if value is not None:
                    setattr(geom, name, value)
        except BaseException:
            geom.destroy()
            raise
        return geom

    def plane(self, normal: Sequence[float] = (0, 0, 1), distance: float = 0.0, **settings: typing.Any) -> Geom:
        """Ground: everything below normal . p = distance."""
        x, y, z = three(normal, "normal")
        if not (x or y or z):
            raise ValueError("a normal that is not 0 is expected")
        return self.geom(Plane((x, y, z), distance), **settings)

    def fluid(self, *, plane: ArrayLike | None = None, **settings: typing.Any) -> Fluid:
        """Water below z = 0, or below a plane (a, b, c, d). settings: density, drag, current and whatever else a Fluid has."""
        fluid = Fluid(self)
        self._fluids.append(fluid)
        try:
            if plane is not None:
                fluid.plane = np.asarray(plane, dtype=float)
            for name, value in settings.items():
                if not hasattr(type(fluid), name):
                    raise TypeError(f"a fluid has no {name}")
                setattr(fluid, name, value)
        except BaseException:
            fluid.destroy()
            raise
        return fluid

    @property
    def fluids(self) -> tuple[Fluid, ...]:
        """The fluids of the world, the oldest first."""
        return tuple(self._fluids)

    def character(self, *, shape: str = "capsule", radius: float = 0.3, height: float = 1.8, up: ArrayLike = (0, 0, 1),
                  **settings: typing.Any) -> Character:
        """A new character, a "capsule", "cylinder" or "box", with its feet at the origin. radius, of a box half the side of its square
        base, and height in m. settings: feet, slope_limit, step_height, max_force, filter and whatever else a Character has."""
        character = Character._new(self, shape, radius, height, up)
        self._geoms[character._key] = character
        self._edition += 1
        try:
            put_settings(character, settings, CHARACTER_SETTINGS, "character")
        except BaseException:
            character.destroy()
            raise
        return character

    def vehicle(self, *, mass: float | None = None, density: float | None = None, position: ArrayLike | None = None,
                rotation: ArrayLike | None = None, quaternion: ArrayLike | None = None, shape: Shape | None = None,
                material: Material | None = None, inertia: ArrayLike | None = None, **settings: typing.Any) -> Vehicle:
        """A new body, as ``body`` makes it, that is the chassis of a vehicle without wheels; ``Vehicle.add_wheel`` adds them. settings:
        kind, engine_curve, gear_ratios, max_steer and whatever else a Vehicle has."""
        body = self.body(mass=mass, density=density, position=position, rotation=rotation, quaternion=quaternion, shape=shape,
                         material=material, inertia=inertia)
        handle = body._handle
        try:
            return Vehicle._new(self, body, settings)
        except BaseException:
            self._bodies[handle].destroy()
            raise

    def ragdoll(self, bones: Sequence[Bone], *, position: ArrayLike | None = None, quaternion: ArrayLike | None = None,
                material: Material | None = None) -> Ragdoll:
        """A new figure of bones, such as ``epode.human()`` lists, limp, with the frame of the list at a position and turned by a quaternion.
        Bones with a common joint do not collide with each other."""
        return self._assembled(Ragdoll._new(self, bones, position, quaternion), material)

    def rope(self, start: ArrayLike, end: ArrayLike, *, links: int = 20, length: float = 0.0, mass: float = 1.0, radius: float = 0.02,
             width: float = 0.0, stretch: float = 0.0, load: float = 1000.0, ends: RopeEnds = RopeEnds.BOTH, first: Body | None = None,
             last: Body | None = None, material: Material | None = None) -> Rope:
        """A new rope from one point to another, m. links: capsules of a radius, m; with a width, m, planks on hinges, twice radius thick: a bridge.
        length: of all links, m; 0: the distance of the points; what is longer hangs in an arc. mass: of all links, kg. stretch: how
        much longer it is, as a share, under load, N; 0: it does not stretch. ends: which are fastened, to the bodies first and last, or to the
        world where these are None."""
        settings = c.dRopeSettings()
        for name, value in (("links", links), ("length", length), ("mass", mass), ("radius", radius), ("width", width),
                            ("ends", int(ends)), ("stretch", stretch), ("load", load)):
            setattr(settings, name, value)
        return self._assembled(Rope._new(self, start, end, first, last, settings), material)

    def fracture(self, parts: Sequence[Geom], *, density: ArrayLike = 1000.0, strength: float = float("inf"),
                 radius: float = float("inf")) -> Fracture:
        """A new body of parts, geoms that are on no body, where they are, that breaks into them. density: kg/m^3, one or one for each part. strength: the
        normal impulse of a blow on one part that it withstands, N s. radius: parts within this distance of the blow come off, each
        alone, m. Call ``break_fractures`` before each step."""
        return self._assembled(Fracture._new(self, parts, density, strength, radius), None)

    def _assembled(self, one: Made, material: Material | None) -> Made:
        """Keep what has been made of several bodies; where steps are not taken back, forget what has been destroyed."""
        self._assemblies = [other for other in self._assemblies if other.alive or self._past is not None] + [one]
        if material is not None:
            try:
                for body in one.bodies:
                    body.geoms[0].material = material
            except BaseException:
                one.destroy()
                raise
        return one

    def _alive(self, kind: type[Made]) -> tuple[Made, ...]:
        return tuple(one for one in self._assemblies if isinstance(one, kind) and one.alive)

    @property
    def ragdolls(self) -> tuple[Ragdoll, ...]:
        """The ragdolls of the world, the oldest first."""
        return self._alive(Ragdoll)

    @property
    def ropes(self) -> tuple[Rope, ...]:
        """The ropes of the world, the oldest first."""
        return self._alive(Rope)

    @property
    def fractures(self) -> tuple[Fracture, ...]:
        """What ``fracture`` has made and a part is left of, the oldest first."""
        return self._alive(Fracture)

    def break_fractures(self) -> int:
        """Break whatever the last step has hit harder than the strength of its Fracture. Call it before each step. Returns how many bodies
        broke."""
        fractures = self.fractures
        try:
            return c.dFractureUpdate(self._handle, [(one._list(), one.strength, one.radius) for one in fractures])
        finally:
            meet_pieces(self, fractures)

    def joint(self, type: str, body1: Body | None, body2: Body | None = None, **settings: typing.Any) -> Joint:
        """A new joint of a type (ball, hinge, slider, universal, hinge2, fixed, amotor, lmotor, plane2d, pr, pu, piston,
        dball, dhinge, transmission) between two bodies, or a body and the world. settings: anchor, axis, axis1, axis2,
        stops and whatever else a Joint has."""
        if type not in TYPES:  # couplings have World.couple
            raise ValueError(f"no joint is called {type!r}: {', '.join(TYPES)}")
        bodies = (body1, body2)
        if any(b is not None and b.world is not self for b in bodies):
            raise RefusedError("a body is in another world")
        handles = [None if b is None else b._handle for b in bodies]
        joint = Joint(self, getattr(c, f"dJointCreate{TYPES[type]}")(self._handle, None), type, body1, body2)
        self._joints[joint._live] = joint
        self._edition += 1
        try:
            c.dJointAttach(joint._live, *handles)
            if type == "fixed":
                joint.fix()
            for name, value in settings.items():
                if not isinstance(getattr(Joint, name, None), property):
                    raise TypeError(f"joints have no {name}: {', '.join(SETTINGS)}")
                setattr(joint, name, value)
        except BaseException:
            joint.destroy()
            raise
        return joint

    def couple(self, *members: tuple[Joint, float] | tuple[Joint, float, int], stops: tuple[float, float] = (0.0, 0.0)) -> Joint:
        """A new joint that holds the sum of factor * position over its members within stops: mimic joints, gears,
        differentials. members: (joint, factor) or (joint, factor, axis), at most eight."""
        if not members:
            raise ValueError("at least one member, (joint, factor), is expected")
        joint = Joint(self, c.dJointCreateCoupling(self._handle, None), "coupling", None, None)
        self._joints[joint._live] = joint
        self._edition += 1
        try:
            for place, (member, factor, *axis) in enumerate(members):
                c.dJointSetCouplingAxis(joint._live, place, member._handle, axis[0] if axis else 0, factor)
            joint.stops = stops
        except BaseException:
            joint.destroy()
            raise
        return joint

    def _forget_body(self, handle: c.dBodyID) -> None:
        self._bodies.pop(handle, None)
        self._body_list = None
        self._edition += 1

    @property
    def joints(self) -> list[Joint]:
        """The joints, from the oldest on."""
        return list(self._joints.values())

    @property
    def geoms(self) -> list[Geom]:
        """The geoms, from the oldest on."""
        return list(self._geoms.values())

    @property
    def robots(self) -> list[Robot]:
        """The robots (``epode.robot.Model.build``), from the oldest on."""
        return [robot for robot in self._robots if robot.alive]

    # ---- steps ----

    def step(self, h: float, *, stepper: str | None = None, steps: int = 1) -> None:
        """Advance by steps steps of h seconds: ``exact``, ``quick`` or ``hybrid``; None: as ``self.stepper`` says, which
        is "exact" until ``use_defaults`` or the program sets it. Other threads of Python run meanwhile;
        they may use other worlds. What acts on robots from step to step (tendons, muscles, filters, a medium) acts, and what their
        sensors measure is measured."""
        stepper = self.stepper if stepper is None else stepper
        take = _STEPS.get(stepper)
        if take is None:
            raise ValueError(f"no stepper is called {stepper!r}: {', '.join(_STEPS)}")
        if steps < 0:
            raise ValueError(f"steps is {steps}; 0 or more are expected")
        handle, acting = self._handle, [robot for robot in self._robots if robot._is_acting]
        sensing = [robot for robot in self._robots if robot._is_there]
        for _ in range(steps):
            for robot in acting:
                robot._act(h)
            for hand in self._hands:
                hand(h)
            begin = time.perf_counter() if self._recording is not None else 0.0
            take(handle, h)
            for robot in sensing:
                robot._sense(h)
            if self._recording is not None:
                self._recording._take(h, 1000 * (time.perf_counter() - begin))
            if self._past is not None:
                self._remember(1)

    def _note_steps(self, h: float, count: int) -> None:
        """So many steps have been made elsewhere: for what records and what takes them back."""
        if count > 0 and self._recording is not None:
            self._recording._take(h * count, 0.0)
        if count > 0 and self._past is not None:
            self._remember(count)

    def collide(self, near: Callable[[Geom, Geom], typing.Any]) -> None:
        """Call near(geom1, geom2) for pairs of geoms whose boxes touch. The first exception is raised at the end."""
        geoms = self._geoms
        c.dSpaceCollide(self._space_handle, lambda a, b: near(geoms[a.id], geoms[b.id]))

    @property
    def _space_handle(self) -> c.dSpaceID:
        self._handle
        return self._space

    def on_pair(self, function: Callable[[Geom, Geom], bool] | None) -> None:
        """Ask function(geom1, geom2) whether two geoms that come near each other may touch; None: all may."""
        if function is None:
            c.dWorldSetContactFilter(self._handle, None)
            return
        called, world = function, weakref.ref(self)  # what the engine keeps must not keep the world

        def touch(a: c.dGeomID, b: c.dGeomID) -> bool:
            me = world()
            return me is None or called(me._geoms[a.id], me._geoms[b.id])
        c.dWorldSetContactFilter(self._handle, touch)

    def on_manifold(self, function: Callable[[Geom, Geom, c.dManifold], typing.Any] | None) -> None:
        """Call function(geom1, geom2, manifold) for every manifold of contacts in every step, before it is solved; None: no more. It may
        set accept, friction, bounce, bounce_speed, rolling_friction, compliance, damping_time and surface_velocity of the ``c.dManifold``,
        for this step alone; geom1 has a body."""
        if function is None:
            c.dWorldSetManifoldFunction(self._handle, None)
            return
        called, world = function, weakref.ref(self)  # what the engine keeps must not keep the world

        def show(manifold: c.dManifold) -> None:
            me, g1, g2 = world(), manifold.g1, manifold.g2
            if me is not None and g1 is not None and g2 is not None:
                called(me._geoms[g1.id], me._geoms[g2.id], manifold)
        c.dWorldSetManifoldFunction(self._handle, show)

    # ---- to look at ----

    def record(self, title: str = "") -> Recording:
        """Begin to record: the state now, and from now on one after each ``step``, until the recording's ``stop`` or the end of
        its ``with`` block. A recording that was being made stops."""
        self._handle
        if not isinstance(title, str):
            raise TypeError(f"the title of a recording is expected, not {title!r}")
        if self._recording is not None:
            self._recording.stop()
        recording = Recording(self, title)
        self._recording = recording
        return recording

    def picture(self, path: str | os.PathLike[str] | None = None, *, width: int = 1280, height: int = 720,
                eye: ArrayLike | None = None, target: ArrayLike | None = None, up: ArrayLike | None = None, field: float = 0.0,
                camera: str | None = None) -> bytes:
        """The world now as a PNG file, as ``Recording.picture`` draws it. camera: the name of one that the file of a robot has, in place of
        eye, target, up and field. Returns its bytes, and writes them to path."""
        self._handle
        if camera is not None:
            robot = next((one for one in self.robots if one.alive and any(its.name == camera for its in one.model.cameras)), None)
            if robot is None:
                names = [its.name for one in self.robots for its in one.model.cameras]
                raise KeyError(f"no robot of this world has a camera {camera!r}: {', '.join(names) or 'there is none'}")
            eye, target, up, field = robot._view(camera)
        return Recording(self).picture(path, width=width, height=height, eye=eye, target=target, up=up, field=field)

    def view(self, h: float = 0.01, *, stepper: str | None = None, **settings: typing.Any) -> None:
        """Open a window and step the world by h seconds as the clock says, until the user closes it (``epode.viewer.show``)."""
        from .viewer import show
        self._handle
        show(self, h, stepper=stepper, **settings)

    # ---- what a step did ----

    @property
    def contacts(self) -> Contacts:
        """Points of contact of the last step: a structured array with g1, g2 (``geom_of`` knows them), pos, normal,
        depth, normal_force and friction_force."""
        return c.dWorldGetContacts(self._handle)

    @property
    def contact_events(self) -> NDArray[typing.Any]:
        """Pairs of the last step: a structured array with kind (a ``ContactEventKind``), g1 and g2."""
        return c.dWorldGetContactEvents(self._handle)

    @property
    def materials(self) -> NDArray[typing.Any]:
        """The surfaces of ``geoms``, in their order, as a structured array with the fields of ``Material``. Assigning one
        sets all of them, or none if one is refused."""
        self._handle
        return _c._get_materials([geom._live for geom in self._geoms.values()])

    @materials.setter
    def materials(self, values: NDArray[typing.Any]) -> None:
        self._handle
        _c._set_materials([geom._live for geom in self._geoms.values()], values)

    def list_events(self, **settings: float) -> None:
        """List ``events`` from the next step on. settings: the fields of ``c.dEventSettings``, such as kinds and
        min_approach_speed."""
        given = c.dEventSettings()
        for name, value in settings.items():
            if not hasattr(given, name):
                raise TypeError(f"event settings have no {name}")
            setattr(given, name, value)
        c.dWorldSetEventSettings(self._handle, given)

    @property
    def events(self) -> NDArray[typing.Any]:
        """What happened in the last step, if ``list_events`` was called before it: a structured array with kind
        (an ``EventKind``), g1 and g2 (``geom_of`` knows them), joint, pos, normal, approach_speed, impulse
        and gone."""
        return c.dWorldGetEvents(self._handle)

    def geom_of(self, key: int) -> Geom | None:
        """The Geom that a structured array names; None where there is none."""
        return self._geoms.get(int(key))

    def broken_joints(self) -> list[Joint]:
        """The joints that broke in the last step (``Joint.break_limits``)."""
        broken = c.dWorldGetBrokenJoints(self._handle)
        return [self._joints[broken[i]] for i in range(len(broken)) if broken[i] in self._joints]

    def report(self) -> c.dWorldStepReport | None:
        """A ``c.dWorldStepReport`` of the last step, or None; set ``reports`` first."""
        report = c.dWorldStepReport()
        return report if c.dWorldGetStepReport(self._handle, report) else None

    def island_reports(self) -> list[c.dIslandStepReport]:
        """A ``c.dIslandStepReport`` of each island of the last step, from the one with the youngest body on; set ``reports``
        first. ``IslandMethod`` has the names of its method."""
        total = self.report()
        reports = [c.dIslandStepReport() for _ in range(0 if total is None else total.islands)]
        for island, report in enumerate(reports):
            c.dWorldGetIslandStepReport(self._handle, island, report)
        return reports

    def ledger(self) -> c.dEnergyLedger | None:
        """A ``c.dEnergyLedger`` of the last step: what gravity, forces, drives, friction, impacts and the rest did to the
        energy, J; or None. Set ``keeps_ledger`` first."""
        ledger = c.dEnergyLedger()
        return ledger if c.dWorldGetEnergyLedger(self._handle, ledger) else None

    def island_ledgers(self) -> list[c.dEnergyLedger]:
        """The same of each island."""
        total = self.ledger()
        ledgers = [c.dEnergyLedger() for _ in range(0 if total is None else total.islands)]
        for island, ledger in enumerate(ledgers):
            c.dWorldGetIslandEnergyLedger(self._handle, island, ledger)
        return ledgers

    def diagnose(self) -> list[Cause]:
        """Why the world misbehaves: the causes seen since ``diagnosing`` was set, the worst first, each a ``Cause``."""
        causes = []
        for kind, severity, body, other, joint, geom, *figures in c.dWorldDiagnose(self._handle):
            objects = (self._bodies.get(body), self._bodies.get(other), self._joints.get(joint),
                       None if geom is None else self._geoms.get(geom.id))
            causes.append(Cause(CauseKind(kind), Severity(severity), *objects, *figures))
        return causes

    # ---- queries ----

    def rays(self, origins: ArrayLike, directions: ArrayLike, lengths: ArrayLike = float("inf"), *,
             filter: c.dQueryFilter | None = None, threads: int = 1) -> NDArray[typing.Any]:
        """Cast many rays: (n, 3) arrays of origins and directions, and lengths. Returns a structured array with geom (0:
        nothing), pos, normal, distance and side. filter: a ``c.dQueryFilter``."""
        starts, ways = np.atleast_2d(np.asarray(origins, float)), np.atleast_2d(np.asarray(directions, float))
        if starts.shape[1:] != (3,) or ways.shape[1:] != (3,) or len({len(starts), len(ways)} - {1}) > 1:
            raise ValueError(f"origins and directions, rows of 3, as many or one, are expected, not {starts.shape} and {ways.shape}")
        origins, directions = np.broadcast_arrays(starts, ways)
        lengths = np.broadcast_to(np.asarray(lengths, float), origins.shape[:1])
        return c.dSpaceRayBatch(self._space_handle, origins, directions, lengths, filter, threads)

    def ray(self, origin: ArrayLike, direction: ArrayLike, length: float = float("inf"), *,
            filter: c.dQueryFilter | None = None) -> tuple[Geom | None, FloatArray, FloatArray, float] | None:
        """The first hit of a ray: (geom, pos, normal, distance), or None."""
        hit = c.dQueryHit()
        if not c.dSpaceRayClosest(self._space_handle, origin, direction, length, filter, hit) or hit.geom is None:
            return None
        return self.geom_of(hit.geom.id), hit.pos[:3], hit.normal[:3], hit.distance

    def overlaps(self, geom: Geom, *, filter: c.dQueryFilter | None = None) -> list[Geom]:
        """The geoms that a geom touches or overlaps."""
        if not isinstance(geom, Geom):
            raise TypeError(f"a Geom, such as one of body.geoms, is expected, not {geom!r}")
        found = c.dSpaceOverlap(self._space_handle, geom._handle, filter)
        return [self._geoms[one.id] for one in found if one.id in self._geoms]

    def cast(self, geom: Geom, motion: ArrayLike, *, filter: c.dQueryFilter | None = None) -> NDArray[typing.Any]:
        """All that a geom would hit if it moved by ``motion``, m, each geom once, the nearest first: a structured array with geom
        (``geom_of`` finds it), pos, normal, distance, side, face_normal and depth (of an overlap at the beginning)."""
        if not isinstance(geom, Geom):
            raise TypeError(f"a Geom, such as one of body.geoms, is expected, not {geom!r}")
        return c.dSpaceCastAll(self._space_handle, geom._handle, motion, filter)

    def shift_origin(self, offset: ArrayLike) -> None:
        """Make the point offset, m, the new origin of the world, for worlds that are too large for their numbers: nothing moves against
        anything else, and what could be rolled back is gone."""
        c.dWorldShiftOrigin(self._handle, self._space_handle, three(offset, "offset"))

    def radial_impulse(self, center: ArrayLike, radius: float, impulse: float, *, falloff: Falloff = Falloff.LINEAR,
                       occlusion: bool = False, filter: c.dQueryFilter | None = None) -> int:
        """Give an impulse, N s, away from the centre to each body within the radius, m: what the falloff leaves at its nearest
        point. occlusion: only to those that nothing else hides. Returns how many had one."""
        return c.dSpaceApplyRadialImpulse(self._space_handle, center, radius, impulse, falloff, int(occlusion), filter)

    # ---- states ----

    def save(self) -> bytes:
        """The state, as bytes: a world of the same structure goes on from it with the same bits. Controls, activations and
        targets of its robots are part of it."""
        return joined(c.dWorldGetState(self._handle), self._robots)

    def load(self, state: bytes) -> None:
        """Give the world, and the robots in it, a state that ``save`` has returned."""
        of_world, of_robots = split(bytes(state), self._robots)
        c.dWorldSetState(self._handle, of_world)
        set_numbers(of_robots)

    def save_file(self, path: str | os.PathLike[str]) -> None:
        """Write the whole world to a file, which the command runs (``python -m epode run FILE``) and ``load_world`` reads."""
        c.dWorldSave(self._handle, self._space, os.fspath(path))

    # ---- copies ----

    def clone(self) -> World:
        """A copy that goes on with the same bits: bodies, joints and geoms in the same order, the same shapes, settings and
        state, functions of fluids and filters of characters; without callbacks of bodies, pairs and manifolds, history and recording."""
        handle, space, counterparts = c.dWorldClone(self._handle, self._space)
        assert space is not None
        copy = World._around(handle, space)
        copy._adopt(self, [counterparts[h] for h in self._bodies], [counterparts[h] for h in self._joints],
                    [counterparts[geom._live] for geom in self._geoms.values()])
        for mine, other in zip(self._geoms.values(), copy._geoms.values()):
            if isinstance(mine, Character) and isinstance(other, Character) and mine.filter is not None:
                other.filter = mine.filter
        for robot in self._robots:
            if robot.alive:
                type(robot)._copied(robot.model, robot._live, copy, robot._places())
        return copy

    __copy__ = clone

    def __deepcopy__(self, memo: dict[int, typing.Any]) -> World:
        return self.clone()

    def __reduce__(self) -> tuple[typing.Any, ...]:
        """Pickles hold the world's file and what Python knows in addition."""
        numbers = [self._geom_number(geom) for geom in self._geoms.values()]
        robots = [(robot.model, robot._live.placement, robot._places(), robot._live.state())
                  for robot in self._robots if robot.alive]
        return _unpickled, (c.dWorldSaveToBuffer(self._handle, self._space), Description(self), numbers, robots)

    def _geom_number(self, geom: Geom) -> int:
        return next(i for i in range(c.dSpaceGetNumGeoms(self._space)) if c.dSpaceGetGeom(self._space, i) == geom._live)

    @classmethod
    def _around(cls, handle: c.dWorldID, space: c.dSpaceID) -> World:
        """A world of the library, without objects of Python yet."""
        world = cls.__new__(cls)
        world._live, world._space, world._group = handle, space, c.dJointGroupCreate(0)
        world._bodies, world._joints, world._geoms, world._body_list, world._past, world._recording = {}, {}, {}, None, None, None
        world._hands = []
        world._edition, world.bodies, world.stepper, world._robots = 0, Bodies(world), "exact", []
        world._assemblies = []
        found = [c.dWorldGetFluid(handle, i) for i in range(c.dWorldGetNumFluids(handle))]
        world._fluids = [Fluid._around(world, live) for live in found if live is not None]
        return world

    def _adopt(self, like: World | Description, bodies: list[c.dBodyID], joints: list[c.dJointID], geoms: list[c.dGeomID]) -> None:
        """Make objects for handles like those of another world."""
        was = like if isinstance(like, Description) else Description(like)
        self.stepper = was.stepper
        for body in bodies:
            self._bodies[body] = (Vehicle if c.dBodyIsVehicle(body) else Body)(self, body)
        mine = list(self._bodies.values())
        for joint, (kind, *ends) in zip(joints, was.joints):
            body1, body2 = (None if end is None else mine[end] for end in ends)
            self._joints[joint] = Joint(self, joint, kind, body1, body2)
        for handle, (shape, number) in zip(geoms, was.geoms):
            geom = (Character if c.dGeomIsCharacter(handle) else Geom)(self, handle, shape, None if number is None else mine[number])
            shape._adopt(handle)
            self._geoms[geom._key] = geom
            if geom.body is not None:
                geom.body.geoms.append(geom)
        assemble(self, was.assemblies)

    # ---- steps that can be taken back ----

    @property
    def history(self) -> int:
        """How many of the last steps can be taken back with ``roll_back``; 0, the default: none. Setting it begins again."""
        return c.dWorldGetHistory(self._handle)

    @history.setter
    def history(self, steps: int) -> None:
        c.dWorldSetHistory(self._handle, steps)
        self._past = collections.deque([self._now()], steps + 1) if steps else None

    @property
    def history_steps(self) -> int:
        """How many steps can be taken back now."""
        return c.dWorldGetHistoryFrames(self._handle)

    def roll_back(self, steps: int) -> None:
        """Take back the last steps, and all that the program has done since. What has been destroyed since is alive again, and
        what has been created since is destroyed; both keep their Python objects."""
        c.dWorldRollBack(self._handle, steps)
        past = self._past
        assert past is not None  # or the library has refused
        for _ in range(steps):
            past.pop()
        past[-1].structure.restore(self)
        set_numbers(past[-1].robots)

    def _now(self, structure: Structure | None = None) -> Past:
        return Past(Structure(self) if structure is None else structure, numbers_of(self._robots))

    def _remember(self, steps: int) -> None:
        """Note what there is after some steps of a world that has a history."""
        assert self._past is not None
        last = self._past[-1].structure
        self._past.extend([self._now(last if last.edition == self._edition else None)] * steps)

    def save_changes(self, base: bytes) -> bytes:
        """What has changed since the state base, as bytes; what sleeps costs next to nothing."""
        return joined(c.dWorldGetStateDelta(self._handle, split(bytes(base), self._robots)[0]), self._robots)

    def load_changes(self, base: bytes, changes: bytes) -> None:
        """Give the world the state that base and changes make up."""
        of_world, of_robots = split(bytes(changes), self._robots)
        c.dWorldSetStateDelta(self._handle, split(bytes(base), self._robots)[0], of_world)
        set_numbers(of_robots)


def defaults_text(preset: str) -> str:
    """What ``World.use_defaults`` sets for a preset, as calls in C with a reason each."""
    if preset not in _DEFAULTS:
        raise ValueError(f"no defaults are called {preset!r}: {', '.join(_DEFAULTS)}")
    return c.dDefaultsText(_DEFAULTS[preset])


def step_worlds(worlds: Sequence[World], h: float, *, stepper: str = "hybrid", steps: int = 1, substeps: int = 4,
                threads: int = 0) -> list[int]:
    """Advance many worlds at once, each on a thread of its own; the bits are those of each world alone. stepper: hybrid,
    exact, quick, substeps or substeps_exact_joints. Returns how many steps each has made."""
    if stepper not in _STEPPERS:
        raise ValueError(f"no stepper is called {stepper!r}: {', '.join(_STEPPERS)}")
    if steps < 0:
        raise ValueError(f"steps is {steps}; 0 or more are expected")
    acting = [robot for world in worlds for robot in world._robots if robot._is_acting]
    sensing = [robot for world in worlds for robot in world._robots if robot._is_sensing]
    made, handles = [0] * len(worlds), [w._handle for w in worlds]
    try:
        for count in itertools.repeat(1, steps) if acting or sensing else portions(steps):  # what acts on such robots is taken before each step
            for robot in acting:
                robot._act(h)
            done = c.dWorldsStep(handles, h, _STEPPERS[stepper], substeps, count, threads)
            made = [was + more for was, more in zip(made, done)]
            for robot in sensing:
                robot._sense(h)
    finally:
        for world, count in zip(worlds, made):
            world._note_steps(h, count)
    return made
