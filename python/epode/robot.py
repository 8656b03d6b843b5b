# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Robots from URDF and MJCF files: models, robots in worlds, kinematics and dynamics as arrays.

>>> import epode
>>> model = epode.robot.from_text("<mujoco><worldbody><body name='rod'><joint name='hinge' axis='0 1 0'/>"
...                               "<geom type='capsule' size='0.02' fromto='0 0 0 1 0 0'/></body></worldbody></mujoco>")
>>> model.joint_names, round(float(model.gravity_forces([0.0])[0]), 3)
(['hinge'], -6.328)
>>> robot = model.build()
>>> robot.target("hinge", 0.5, stiffness=1000, damping=100)
>>> robot.world.step(0.01, steps=300)
>>> round(float(robot.positions[0]), 2)
0.51

Positions and velocities are arrays with the coordinates of all joints in their order, as ``epode/robots.h`` has them: a
number of a hinge or slider, a quaternion (w x y z) and three of a ball, seven and six of a free joint.
"""
from __future__ import annotations

import os
import typing
from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from . import _c, c
from ._handle import FloatArray
from ._geom_names import names_of
from ._poses import _moved, _number, _product, _quaternion, _turned, _unknown, _vector
from ._robots import Robots as Robots
from ._xacro import expanded, is_xacro
from ._robot_data import (Actuator as Actuator, Camera as Camera, Link as Link, ModelJoint as ModelJoint, Note as Note, Options as Options,
                          Path as Path, Picture as Picture, RobotContact as RobotContact, Sensor as Sensor, Solution as Solution, Target as Target,
                          Touch as Touch)
from .body import Body
from .description import Description as Description
from .errors import DeadHandleError, RefusedError
from .geom import Geom
from .joint import Joint, type_of
from .shapes import Shape
from .world import World

if typing.TYPE_CHECKING:
    from ._c import _Robot, _RobotModel


class FileShape(Shape):
    """A shape that a robot's file describes."""


def _read(path: Path, text: str | None, options: Options) -> _RobotModel:
    if not hasattr(_c, "_RobotModel"):
        raise RefusedError("this build has no robots: it wants pugixml (Debian: libpugixml-dev)")
    unknown = set(options) - set(Options.__annotations__)
    if unknown:
        raise TypeError(f"no option is called {', '.join(sorted(unknown))}: {', '.join(Options.__annotations__)}")
    missing_mass, roots = options.get("missing_mass", 0.0), [os.fspath(root) for root in options.get("roots", ())]
    return _c._RobotModel(os.fspath(path), text, {**options, "missing_mass": missing_mass, "roots": roots})


def check(path: Path, **options: typing.Unpack[Options]) -> list[Note]:
    """The report of a file, a list of ``Note``, whether it has errors or not. Options as for ``load``."""
    return [Note(*line) for line in _read(path, _text_of(path), options).report]


def _text_of(path: Path) -> str | None:
    """Of a xacro file what it becomes; None: the library reads the file."""
    return expanded(os.fspath(path)) if is_xacro(os.fspath(path)) else None


def load(path: Path, **options: typing.Unpack[Options]) -> Model:
    """Read a URDF or MJCF file, or a .xacro file where the package xacro is installed. What makes it unusable raises RefusedError; the rest is in the model's ``report``.

    strict: what is approximated or ignored is an error. keep_fixed: links that are fixed to others stay links. fixed_base:
    the root of a URDF is fixed to the world. repair: inertias that no body can have are mended. inertia_from_shapes: links
    without an inertial get that of their shapes. meshes_as_triangles: not as their convex hulls. meshes_as_parts: as
    several hulls each (``epode.decompose``). missing_mass: of other moving links without an inertial, kg. roots: more folders that may be read."""
    text = _text_of(path)
    return Model(_read(path, text, options), (os.path.abspath(path), text, options))


def from_text(text: str, path: Path = "robot.xml", **options: typing.Unpack[Options]) -> Model:
    """Read a text as if it were the file path. Options as for ``load``."""
    return Model(_read(path, text, options), (os.fspath(path), text, options))


def _unpickled(path: str, text: str | None, options: Options) -> Model:
    """The model that ``Model.__reduce__`` has written."""
    return Model(_read(path, text, options), (path, text, options))


def _robot_of(world: World, number: int) -> Robot:
    """The robot that ``Robot.__reduce__`` has written."""
    return world._robots[number]


class Model:
    """What a file says, as data. Frames are links, and merged links and sites, by name."""

    def __init__(self, model: _RobotModel, source: tuple[str, str | None, Options]) -> None:
        """As ``load`` and ``from_text`` do: model is what the library has read, source the path, the text, and the options."""
        self._model, self._source = model, source
        self.report = [Note(*line) for line in model.report]
        errors = [note for note in self.report if note.kind == "error"]
        if errors:
            more = f" (and {len(errors) - 1} more: epode.robot.check)" if len(errors) > 1 else ""
            if "libsdformat" in errors[0].text:
                more = "; wheels do not read SDF, pip install ./python -C cmake.define.EPODE_SDF=ON from a clone does"
            place = f"{errors[0].file}:{errors[0].line}: " if errors[0].line else ""
            raise RefusedError(f"{place}{errors[0].text}{more}")
        self.name, self.format = model.name, model.format
        self.links = [Link(*row) for row in model.links]
        self.joints = [ModelJoint(*row) for row in model.joints]
        self.actuators = [Actuator(*row) for row in model.actuators]
        self.sensors = [Sensor(*row) for row in model.sensors]
        self.cameras = [Camera(*row) for row in model.cameras]
        self.starts = model.starts
        self._names_of_geoms: list[list[str]] | None = None  # of each link

    def __eq__(self, other: object) -> bool:
        """Models are equal if MJCF says the same of them."""
        return self.text("mjcf") == other.text("mjcf") if isinstance(other, Model) else NotImplemented

    def __hash__(self) -> int:
        return hash((self.name, *self.link_names, *self.joint_names))

    def __reduce__(self) -> tuple[typing.Any, ...]:
        """Pickles hold the text of the robot's file; files that it includes and meshes are read again, where they were."""
        path, text, options = self._source
        if text is None and self.format != "SDF":
            with open(path, encoding="utf-8") as file:
                text = file.read()
        return _unpickled, (path, text, options)

    @property
    def mocap_names(self) -> list[str]:
        """Of the links that the program moves (``Robot.mocap``)."""
        return [self.links[i].name for i in self._model.mocap]

    def __repr__(self) -> str:
        return f"<epode.robot.Model {self.name!r}: {len(self.links) - 1} links, {len(self.joints)} joints>"

    @property
    def link_names(self) -> list[str]:
        """Of all links, from the world on."""
        return [link.name for link in self.links]

    @property
    def joint_names(self) -> list[str]:
        """Of all joints."""
        return [joint.name for joint in self.joints]

    @property
    def actuator_names(self) -> list[str]:
        """Of all actuators."""
        return [actuator.name for actuator in self.actuators]

    def link(self, name: str) -> Link:
        """A link, by name."""
        return self.links[_number(name, self.link_names, "link")]

    def joint(self, name: str) -> ModelJoint:
        """A joint, by name: its ``position`` and ``velocity`` say where its numbers stand."""
        return self.joints[_number(name, self.joint_names, "joint")]

    def actuator(self, name: str) -> Actuator:
        """An actuator, by name."""
        return self.actuators[_number(name, self.actuator_names, "actuator")]

    @property
    def frame_names(self) -> list[str]:
        """What ``pose``, ``jacobian`` and ``ik`` know: links, merged links and sites."""
        return self._model.frame_names

    @property
    def geom_names(self) -> list[list[str]]:
        """The names of each link's geoms, the world's first; empty where a geom has none."""
        if self._names_of_geoms is None:
            names = names_of(self.text("mjcf")[0])
            self._names_of_geoms = names if len(names) == len(self.links) else [[] for _ in self.links]
        return self._names_of_geoms

    @property
    def gravity(self) -> FloatArray:
        """The file's, m/s^2."""
        return self._model.gravity

    @property
    def stepsize(self) -> float | None:
        """The time of a step that the file asks for, s (MJCF's timestep, SDF's max_step_size); None where it does not say. Worlds are
        stepped by what ``World.step`` is given: ``world.step(model.stepsize or 0.002)``."""
        return self._model.stepsize or None

    @property
    def position_count(self) -> int:
        """How many coordinates the joints have."""
        return self._model.position_count

    @property
    def velocity_count(self) -> int:
        """How many velocities the joints have."""
        return self._model.velocity_count

    @property
    def reference(self) -> FloatArray:
        """The positions in which the file describes the robot."""
        return self._model.reference

    @property
    def low(self) -> FloatArray:
        """The lowest position of each coordinate; minus infinity where there is no limit."""
        return self._limits("low", -np.inf)

    @property
    def high(self) -> FloatArray:
        """The highest position of each coordinate."""
        return self._limits("high", np.inf)

    def _limits(self, name: str, none: float) -> FloatArray:
        out = np.full(self.position_count, none)
        for joint in self.joints:
            if joint.kind in ("hinge", "slide"):
                out[joint.position] = getattr(joint, name)
        return out

    def _frame(self, name: str) -> tuple[int, FloatArray]:
        found = self._model.frame(name)
        if found is None:
            raise KeyError(_unknown(name, self.frame_names, "link or frame"))
        return found

    def save(self, path: Path) -> list[str]:
        """Write the model to a file: URDF if it ends in .urdf, MJCF if in .xml or .mjcf. Paths of meshes count from its folder.
        Returns a sentence for each thing that the format cannot say."""
        return self._model.save(os.fspath(path))

    def edit(self) -> Description:
        """What the model says, to be changed (``epode.description``). Its file is read again, with links that are fixed to others apart."""
        return Description._of_model(self)

    def text(self, format: str, folder: Path = ".") -> tuple[str, list[str]]:
        """What ``save`` would write to a file in a folder, and the sentences. format: "urdf" or "mjcf"."""
        if format not in ("urdf", "mjcf"):
            raise ValueError(f"no robot is written as {format!r}: urdf or mjcf")
        return self._model.text(format == "urdf", os.fspath(folder))

    # ---- kinematics and dynamics ----

    def fk(self, positions: ArrayLike) -> FloatArray:
        """Forward kinematics: the poses of all links, an (n, 7) array of position and quaternion each."""
        return self._model.poses(positions)

    def pose(self, frame: str, positions: ArrayLike) -> tuple[FloatArray, FloatArray]:
        """The position and the quaternion of a frame, by name."""
        link, local = self._frame(frame)
        pose = self.fk(positions)[link]
        return _moved(pose, local[:3]), _product(pose[3:], local[3:])

    def jacobian(self, frame: str, positions: ArrayLike, point: ArrayLike = (0, 0, 0)) -> FloatArray:
        """6 x velocity_count: what the velocities make of a point of a frame, linear then angular, in the world's axes."""
        link, local = self._frame(frame)
        return self._model.jacobian(positions, link, _moved(local, _vector(point, 3, "point")))

    def mass_matrix(self, positions: ArrayLike) -> FloatArray:
        """velocity_count x velocity_count, rotor inertias on its diagonal."""
        return self._model.mass_matrix(positions)

    def constraints(self, positions: ArrayLike) -> tuple[FloatArray, FloatArray]:
        """What couplings and loops ask: how far they are from it, and the derivative of that by the velocities, a row each (one
        of a coupling, three of a loop, six of a welded one). Motions that keep them are those that the matrix maps to 0."""
        return self._model.constraints(positions)

    @property
    def tendon_names(self) -> list[str]:
        """Of all tendons of an MJCF file."""
        return self._model.tendon_names

    def tendons(self, positions: ArrayLike) -> tuple[FloatArray, FloatArray]:
        """The lengths of all tendons, of spatial ones along their paths, m, and their moment arms: the derivatives of the
        lengths by the velocities, a row each."""
        return self._model.tendons(positions)

    def inverse_dynamics(self, positions: ArrayLike, velocities: ArrayLike | None = None,
                         accelerations: ArrayLike | None = None) -> FloatArray:
        """The forces that give the accelerations, against gravity, without springs, dampers and friction; None: zeros."""
        zeros = np.zeros(self.velocity_count)
        return self._model.inverse_dynamics(positions, zeros if velocities is None else velocities,
                                            zeros if accelerations is None else accelerations)

    def fluid_forces(self, positions: ArrayLike, velocities: ArrayLike) -> FloatArray:
        """What the medium of an MJCF file (density, viscosity, wind) exerts at these velocities; zeros without one."""
        return self._model.fluid_forces(positions, velocities)

    def gravity_forces(self, positions: ArrayLike) -> FloatArray:
        """Gravity compensation: the forces that hold the robot still."""
        return self.inverse_dynamics(positions)

    def ik(self, target: str | Iterable[Target], position: ArrayLike | None = None, quaternion: ArrayLike | None = None, *,
           guess: ArrayLike | None = None, weights: ArrayLike | None = None, posture: ArrayLike | None = None,
           point: ArrayLike = (0, 0, 0), tolerance: float = 1e-10, max_starts: int = 32,
           max_iterations: int = 100) -> Solution:
        """Inverse kinematics: positions, within the limits, at which a frame is at a position, at a quaternion, or both;
        or at which all of a list of ``Target`` are met. Returns a ``Solution``: the nearest one if ``reached`` is False.

        guess: where the search begins; without it at the reference. weights: of velocities, 0: it stays, 2: it moves rather
        than one of 1. posture: positions to be near where the targets leave a choice."""
        targets = [Target(target, position, quaternion, point)] if isinstance(target, str) else list(target)
        if not targets or any(one.position is None and one.quaternion is None for one in targets):
            raise ValueError("a position, a quaternion, or both are expected for each target")
        answer = self._model.inverse(self.reference if guess is None else guess, [self._goal(t) for t in targets], weights,
                                     posture, max_iterations, max_starts, tolerance)
        return Solution(*answer)

    def _goal(self, target: Target) -> tuple[int, FloatArray, FloatArray, float, float]:
        link, local = self._frame(target.frame)
        frame = np.concatenate([_moved(local, _vector(target.point, 3, "point")), local[3:]])
        pose = np.concatenate([np.zeros(3) if target.position is None else _vector(target.position, 3, "position"),
                               [1.0, 0, 0, 0] if target.quaternion is None else _quaternion(target.quaternion)])
        return (link, frame, pose, 0.0 if target.position is None else float(target.position_weight),
                0.0 if target.quaternion is None else float(target.orientation_weight))

    # ---- worlds ----

    def build(self, world: World | None = None, *, position: ArrayLike = (0, 0, 0), quaternion: ArrayLike = (1, 0, 0, 0),
              start: str | ArrayLike | None = None) -> Robot:
        """A robot in a world; without one in a new world with the file's gravity and the defaults "robot". position and quaternion place the model's
        world in it. start: positions, or the name of a start pose of the file; without it, the first, or the reference."""
        pose = np.concatenate([_vector(position, 3, "position"), _quaternion(quaternion)])
        if isinstance(start, str):
            if start not in self.starts:
                raise KeyError(_unknown(start, list(self.starts), "start pose"))
        elif start is not None:
            start = _vector(start, self.position_count, "start")
        if world is None:
            world = World(gravity=self.gravity, defaults="robot")
        robot = Robot(self, world, pose)
        if start is None:
            start = next(iter(self.starts), None)
        if isinstance(start, str):
            for name, pose in zip(self.mocap_names, self._model.start_mocap[start]):
                robot.mocap[name] = pose[:3], pose[3:]
            start = self.starts[start]
        if start is not None:
            robot.positions = start
        return robot


class Mocap(Mapping[str, tuple[FloatArray, FloatArray]]):
    """The links of a robot that the program moves, by name: ``robot.mocap["target"] = position, quaternion`` (None: as it is) puts
    one there in the world, at once and for good; reading gives both."""

    def __init__(self, robot: Robot) -> None:
        """As ``Robot.mocap`` is: the links of this robot."""
        self._robot = robot

    def __len__(self) -> int:
        return len(self._robot.model.mocap_names)

    def __iter__(self) -> Iterator[str]:
        return iter(self._robot.model.mocap_names)

    def _link(self, name: str) -> int:
        model = self._robot.model
        if name not in model.mocap_names:
            raise KeyError(_unknown(name, model.mocap_names, "link that the program moves"))
        return model._model.mocap[model.mocap_names.index(name)]

    def __getitem__(self, name: str) -> tuple[FloatArray, FloatArray]:
        pose = self._robot._live.link_pose(self._link(name))
        return pose[:3], pose[3:]

    def __setitem__(self, name: str, pose: tuple[ArrayLike | None, ArrayLike | None]) -> None:
        link = self._link(name)
        position, quaternion = self[name]
        parts = [position if pose[0] is None else np.asarray(pose[0], float),
                 quaternion if pose[1] is None else np.asarray(pose[1], float)]
        if [part.shape for part in parts] != [(3,), (4,)] or not np.any(parts[1]):
            raise ValueError("a position of 3 numbers and a quaternion of 4, not all 0, are expected")
        self._robot._live.set_mocap(link, np.concatenate(parts))


class Robot:
    """A robot in a world, made by ``Model.build``. Its bodies, joints and geoms are the world's like all others; destroy
    them all at once. In a notebook it shows itself: a picture, its joints and controls."""

    __slots__ = ("model", "world", "mocap", "_robot", "_seen", "_bodies", "_joints", "_geoms", "_acts", "_pushed", "_senses", "_measured",
                 "__weakref__")

    def __init__(self, model: Model, world: World, pose: FloatArray) -> None:
        """As ``Model.build`` does. pose: of the model's world in the world, position and quaternion."""
        self.model, self.world = model, world
        self._robot: _Robot | None = model._model.build(world._handle, world._space_handle, pose)
        self._seen = -1  # the world's edition when all of it was alive
        world._robots.append(self)
        self._add_all(self._robot)
        self.mocap = Mocap(self)
        self._begin_steps()
        for sensor in model.sensors:
            if sensor.kind in ("force", "torque"):
                self._robot.watch_force(model._frame(sensor.object)[0], True)

    def _places(self) -> tuple[list[int], list[int], list[int]]:
        """Where its bodies, joints and geoms are among its world's."""
        world, live = self.world, self._live
        bodies, joints = ({handle: i for i, handle in enumerate(group)} for group in (world._bodies, world._joints))
        geoms = {geom: i for i, geom in enumerate(world._geoms.values())}
        return [bodies[h] for h in live.bodies], [joints[h] for h in live.joints], [geoms[g] for g in self._geoms]

    @classmethod
    def _copied(cls, model: Model, like: _Robot, world: World, places: tuple[list[int], list[int], list[int]]) -> Robot:
        """The robot in a copy of its world, whose bodies, joints and geoms stand at those places."""
        self = cls.__new__(cls)
        all_bodies, all_joints, all_geoms = list(world._bodies.values()), list(world._joints.values()), list(world._geoms.values())
        bodies, joints, geoms = [all_bodies[i] for i in places[0]], [all_joints[i] for i in places[1]], [all_geoms[i] for i in places[2]]
        self.model, self.world = model, world
        self._robot = like.counterpart(world._handle, [one._handle for one in bodies], [one._handle for one in joints],
                                        [one._handle for one in geoms])
        self._bodies, self._joints = {b._handle: b for b in bodies}, {j._handle: j for j in joints}
        self._geoms, self._seen, self.mocap = geoms, -1, Mocap(self)
        self._begin_steps()
        world._robots.append(self)
        return self

    def __reduce__(self) -> tuple[typing.Any, ...]:
        """A robot is pickled with its world."""
        self._live
        return _robot_of, (self.world, [robot for robot in self.world._robots if robot.alive].index(self))

    def _add_all(self, robot: _Robot) -> None:
        world = self.world
        self._bodies = {h: Body(world, h) for h in robot.bodies}
        world._bodies.update(self._bodies)
        world._body_list = None
        world._edition += 1
        self._joints = {}
        for handle in robot.joints:
            ends = [self._body_of(c.dJointGetBody(handle, i)) for i in (0, 1)]
            self._joints[handle] = Joint(world, handle, type_of(handle), *ends)
        world._joints.update(self._joints)
        self._geoms: list[Geom] = []
        for shape in robot.geoms:
            body = self._body_of(c.dGeomGetBody(shape))
            geom = Geom(world, shape, FileShape(), body)
            if body is not None:
                body.geoms.append(geom)
            world._geoms[geom._key] = geom
            self._geoms.append(geom)

    def _body_of(self, handle: c.dBodyID | None) -> Body | None:
        return None if handle is None else self._bodies.get(handle)

    @property
    def _live(self) -> _Robot:
        if self._robot is None or (self._seen != self.world._edition and not self._look()):
            raise DeadHandleError("this Robot, or a part of it, has been destroyed")
        return self._robot

    def _look(self) -> bool:
        alive = self.alive
        if alive:
            self._seen = self.world._edition
        return alive

    @property
    def alive(self) -> bool:
        """False after the robot, a part of it, or its world, has been destroyed."""
        return self._robot is not None and all(b.alive for b in self._bodies.values()) and all(
            j.alive for j in self._joints.values())

    def __repr__(self) -> str:
        return f"<epode.robot.Robot {self.model.name!r}{'' if self.alive else ', destroyed'}>"

    @property
    def bodies(self) -> list[Body]:
        """Of all links, and small ones between several joints of one."""
        return list(self._bodies.values())

    @property
    def geoms(self) -> list[Geom]:
        """All geoms."""
        return list(self._geoms)

    @property
    def _named_geoms(self) -> dict[int, str]:
        """The names of the geoms that have one, by their keys."""
        live, links = self._live, range(len(self.model.links))
        places = {handle: link for link in links if (handle := live.body(link)) is not None}
        of_links: list[list[Geom]] = [[] for _ in links]
        for geom in self._geoms:
            of_links[0 if geom.body is None else places.get(geom.body._handle, 0)].append(geom)
        out = {}
        for geoms, names in zip(of_links, self.model.geom_names):
            if len(geoms) == len(names):  # else one has become several, or none
                out.update({geom._key: name for geom, name in zip(geoms, names) if name})
        return out

    def geom(self, name: str) -> Geom:
        """A geom of the file, by name."""
        named = {its: key for key, its in self._named_geoms.items()}
        if name not in named:
            raise KeyError(_unknown(name, list(named), "geom"))
        return self.world._geoms[named[name]]

    def geom_name(self, geom: Geom) -> str:
        """What the file calls a geom of the robot; empty: it has no name there, or is not the robot's."""
        return self._named_geoms.get(geom._key, "")

    def body(self, link: str) -> Body | None:
        """The Body of a link, merged link or site, by name; None of the world's."""
        handle = self._live.body(self.model._frame(link)[0])
        return None if handle is None else self._bodies[handle]

    def joint(self, name: str) -> Joint | None:
        """The Joint of a joint of the model, by name; None of a free one."""
        handle = self._live.joint(self._joint_number(name))
        return None if handle is None else self._joints[handle]

    @property
    def joints(self) -> dict[str | int, Joint]:
        """The Joints of hinges, sliders and balls, by name, or by number if they have none."""
        live = self._live
        handles = {joint.name or number: live.joint(number) for number, joint in enumerate(self.model.joints)}
        return {name: self._joints[handle] for name, handle in handles.items() if handle is not None}

    def _joint_number(self, name: str | int) -> int:
        return _number(name, self.model.joint_names, "joint")

    @property
    def positions(self) -> FloatArray:
        """The coordinates of all joints. Setting them moves all bodies there, at rest."""
        return self._live.positions()

    @positions.setter
    def positions(self, value: ArrayLike) -> None:
        self._live.set_positions(value)

    @property
    def velocities(self) -> FloatArray:
        """The velocities of all joints."""
        return self._live.velocities()

    @velocities.setter
    def velocities(self, value: ArrayLike) -> None:
        self._live.set_velocities(value)

    def reset(self, start: str | ArrayLike | None = None) -> None:
        """Begin again, at rest: at positions, at a start pose of the file by name, or, without start, where ``Model.build`` puts it;
        controls and activations are 0, targets stay."""
        if isinstance(start, str) and start not in self.model.starts:
            raise KeyError(_unknown(start, list(self.model.starts), "start pose"))
        if start is None:
            start = next(iter(self.model.starts), None)
        wanted = self.model.reference if start is None else self.model.starts[start] if isinstance(start, str) else start
        self.positions = _vector(wanted, self.model.position_count, "start")
        self.controls = np.zeros(len(self.model.actuators))
        self.activations = np.zeros(len(self.model.actuators))

    @property
    def controls(self) -> FloatArray:
        """The controls of all actuators; setting them clamps each to its range."""
        return self._live.controls()

    @controls.setter
    def controls(self, values: ArrayLike) -> None:
        for i, value in enumerate(self._each_actuator(values, "controls")):
            self._live.set_control(i, float(value))

    def control(self, actuator: str | int, value: float) -> None:
        """Set the control of an actuator, by name or number."""
        self._live.set_control(_number(actuator, self.model.actuator_names, "actuator"), float(value))

    def target(self, joint: str | int, target: float, *, stiffness: float, damping: float) -> None:
        """Pull a hinge or slider, by name or number, to a target, m or rad, by a spring and damper, at most with the
        joint's max_force; both 0: no longer."""
        self._live.set_target(self._joint_number(joint), float(target), float(stiffness), float(damping))

    def add_fluid_forces(self, h: float) -> int:
        """Add what the medium of an MJCF file alone exerts to the forces on the bodies, in place of all that ``World.step`` would
        add. Returns how many links of the file they act on: 0 without a medium."""
        count = self._live.add_fluid_forces(h)
        self._pushed = True
        return count

    def add_forces(self, h: float) -> int:
        """Add all that acts only from step to step: spatial tendons, the medium, and filters of actuators, which it moves on.
        ``World.step`` does it before each step, unless the program has. Returns how many filters, tendons and links it acts on."""
        count = self._live.add_forces(h)
        self._pushed = True
        return count

    @property
    def activations(self) -> FloatArray:
        """What the forces of filtered actuators follow instead of their controls; 0 of those without a filter. Setting them
        clamps each to its range."""
        return self._live.activations()

    @activations.setter
    def activations(self, values: ArrayLike) -> None:
        for i, value in enumerate(self._each_actuator(values, "activations")):
            self._live.set_activation(i, float(value))

    @property
    def actuator_forces(self) -> FloatArray:
        """What the actuators exert now, N or N m, before their gears."""
        return self._live.actuator_forces()

    def _each_actuator(self, values: ArrayLike, what: str) -> FloatArray:
        wanted = np.asarray(values, float)
        if wanted.shape != (len(self.model.actuators),):
            raise ValueError(f"{len(self.model.actuators)} {what} expected, not {wanted.size}")
        return wanted

    def pose(self, frame: str) -> tuple[FloatArray, FloatArray]:
        """The position and the quaternion, in the world, of a link, merged link or site, by name."""
        link, local = self.model._frame(frame)
        its = self._live.link_pose(link)
        return _moved(its, local[:3]), _product(its[3:], local[3:])

    @property
    def poses(self) -> FloatArray:
        """The poses of all links in the world, an (n, 7) array of position and quaternion each, as ``Model.fk`` has them."""
        return self._live.link_poses().reshape(-1, 7)

    # ---- kinematics and dynamics, here and now ----

    def ik(self, target: str, position: ArrayLike | None = None, quaternion: ArrayLike | None = None, **settings: typing.Any) -> Solution:
        """``Model.ik`` of one frame with position and quaternion in the world, searched from where the robot is."""
        place = self._live.placement
        back = np.array([1, -1, -1, -1]) * place[3:]
        if position is not None:
            position = _turned(back) @ (_vector(position, 3, "position") - place[:3])
        if quaternion is not None:
            quaternion = _product(back, _quaternion(quaternion))
        return self.model.ik(target, position, quaternion, **{"guess": self.positions, **settings})

    def jacobian(self, frame: str, point: ArrayLike = (0, 0, 0)) -> FloatArray:
        """6 x velocity_count: what the velocities make of a point of a frame where the robot is, linear then angular, in the
        world's axes."""
        turn, its = _turned(self._live.placement[3:]), self.model.jacobian(frame, self.positions, point)
        return np.concatenate([turn @ its[:3], turn @ its[3:]])

    def mass_matrix(self) -> FloatArray:
        """``Model.mass_matrix`` at the robot's positions."""
        return self.model.mass_matrix(self.positions)

    def bias_forces(self) -> FloatArray:
        """Gravity, Coriolis and centrifugal forces along the velocities at the robot's positions and velocities: what holds
        against them (MuJoCo's qfrc_bias). Gravity is the world's, wherever the robot stands."""
        model, positions = self.model, self.positions
        out = model.inverse_dynamics(positions, self.velocities)
        other = model.gravity - _turned(self._live.placement[3:]).T @ self.world.gravity
        if np.any(other):
            for number, link in enumerate(model.links[1:], 1):
                out = out + link.mass * model._model.jacobian(positions, number, link.centre)[:3].T @ other
        return np.asarray(out, float)

    def apply(self, forces: ArrayLike) -> None:
        """Add forces along the velocities for the next step, one for each: N m or N of hinges and sliders, N m in the link's axes of
        balls, and of free joints N at the link's origin in the world's axes, then N m in the link's. They need no actuators."""
        wanted = _vector(forces, self.model.velocity_count, "forces")
        live, turn = self._live, _turned(self._live.placement[3:])
        for number, joint in enumerate(self.model.joints):
            handle, first = live.joint(number), joint.velocity
            if joint.kind in ("hinge", "slide"):
                assert handle is not None
                (c.dJointAddHingeTorque if joint.kind == "hinge" else c.dJointAddSliderForce)(handle, float(wanted[first]))
                continue
            body = live.body(joint.link)
            assert body is not None
            if joint.kind == "free":
                origin = live.link_pose(joint.link)[:3]
                c.dBodyAddForceAtPos(body, *(turn @ wanted[first:first + 3]), *origin)
                first += 3
            torque = wanted[first:first + 3]
            c.dBodyAddRelTorque(body, *torque)
            parent = live.body(self.model.links[joint.link].parent)
            if joint.kind == "ball" and parent is not None:
                c.dBodyAddTorque(parent, *(-_turned(c.dBodyGetQuaternion(body)) @ torque))

    def contacts(self, link: str | None = None) -> list[RobotContact]:
        """The points at which the robot, or one of its links, touched something in the last step. A touch of two of its links is
        there twice, once for each."""
        wanted = None if link is None else self._live.body(self.model._frame(link)[0])
        names = {handle: self.model.links[i].name for i in range(len(self.model.links)) if (handle := self._live.body(i)) is not None}
        mine = {geom._key: None if geom.body is None else geom.body._handle for geom in self._geoms}
        out = []
        for row in self.world.contacts:
            for me, other, sign in ((int(row["g1"]), int(row["g2"]), 1.0), (int(row["g2"]), int(row["g1"]), -1.0)):
                body = mine.get(me)
                if body is None or (link is not None and (wanted is None or body != wanted)):
                    continue
                their = mine.get(other)
                touched = None if their is None else names.get(their)
                out.append(RobotContact(names.get(body, ""), self.world.geom_of(other) if touched is None else touched,
                                        row["pos"].copy(), sign * row["normal"], float(row["depth"]), float(row["normal_force"]),
                                        sign * row["friction_force"], self.world._geoms[me], self.world._geoms[other]))
        return out

    def _repr_html_(self) -> str:
        from ._robot_page import page
        return page(self)

    # ---- what steps do with it ----

    def _begin_steps(self) -> None:
        self._acts: bool | None = None  # whether anything acts from step to step; None: no step has told yet
        self._pushed = False  # by the program, since the last step
        self._senses = any(sensor.kind in ("accelerometer", "gyro", "framelinacc", "frameangacc", "clock") for sensor in self.model.sensors)
        self._measured = False  # after the last step

    @property
    def _is_there(self) -> bool:
        """``alive``, looked up again only after something in the world was made or destroyed."""
        return self._robot is not None and (self._seen == self.world._edition or self._look())

    @property
    def _is_acting(self) -> bool:
        return self._acts is not False and self._is_there

    @property
    def _is_sensing(self) -> bool:
        return self._senses and self._is_there

    def _act(self, h: float) -> None:
        """Before a step: add what acts from step to step, unless the program has."""
        if not 0 < h < np.inf:
            return  # the step will say so
        if not self._pushed:
            acts = self._live.add_forces(h) > 0
            self._acts = self._acts or acts or bool(self.model.tendon_names)  # tendons may rest
        self._pushed = False

    def _sense(self, h: float) -> None:
        """After a step: note how all bodies move."""
        self._live.update_sensors(h)
        self._measured = True

    def _view(self, camera: str) -> tuple[FloatArray, FloatArray, FloatArray, float]:
        """Eye, target, what is up, and field of view of a camera of the file."""
        its = next(one for one in self.model.cameras if one.name == camera)
        pose = self._live.link_pose(its.link)
        eye, turn = _moved(pose, its.frame[:3]), _product(pose[3:], its.frame[3:])
        axes = np.concatenate([np.zeros(3), turn])
        return eye, eye + _moved(axes, (0, 0, -1)), _moved(axes, (0, 1, 0)), its.field

    # ---- sensors ----

    def _at(self, frame: str, pose: ArrayLike | None) -> tuple[int, FloatArray]:
        """The link of a frame, and the pose in it of a sensor that has a pose in the frame."""
        link, local = self.model._frame(frame)
        if pose is None:
            return link, local
        its = np.asarray(pose, float)
        return link, np.concatenate([_moved(local, its[:3]), _product(local[3:], its[3:])])

    def update_sensors(self, h: float) -> None:
        """Note how all bodies move, for ``imu``, after a step of size h. ``World.step`` does it; it is needed where other functions
        have moved the world."""
        if not 0 < h < np.inf:
            raise ValueError(f"a step size must be positive, not {h}")
        if not self._measured:
            self._live.update_sensors(h)
        self._measured = False

    @property
    def drive_forces(self) -> FloatArray:
        """What springs, dampers and actuators have exerted in the last step: a number, N or N m, for each velocity."""
        return self._live.drive_forces()

    @property
    def forces(self) -> FloatArray:
        """``drive_forces``, as ``Robots.forces`` has them."""
        return self.drive_forces

    def imu(self, frame: str, pose: ArrayLike | None = None) -> tuple[FloatArray, FloatArray]:
        """The specific force, m/s^2 (at rest 9.81 upwards), and the angular velocity, rad/s, at a frame, in its axes. pose:
        the sensor's in the frame, position and quaternion. The force is that of the last step."""
        self._senses = True
        try:
            return self._live.imu(*self._at(frame, pose))
        except ValueError:
            raise RefusedError("no step has been measured yet: read accelerations after World.step") from None

    def watch_force(self, link: str, on: bool = True) -> None:
        """Let steps write down what the joint between a link and its parent bears, for ``force_torque``."""
        if not self._live.watch_force(self.model._frame(link)[0], on):
            raise RefusedError(f"no joint holds {link!r}")

    def force_torque(self, frame: str, pose: ArrayLike | None = None) -> tuple[FloatArray, FloatArray]:
        """The force, N, and torque, N m, that a frame's link exerts on its parent, in the frame's axes and about it."""
        return self._live.force_torque(*self._at(frame, pose))

    def touch(self, link: str) -> Touch:
        """What touches a link: the contacts that the world has found in the last step."""
        return Touch(*self._live.touch(self.model._frame(link)[0]))

    def rays(self, frame: str, directions: ArrayLike, max_distance: float = np.inf, pose: ArrayLike | None = None) -> FloatArray:
        """Distances from a frame along directions in its axes, (n, 3), to what is not its link; infinite: nothing."""
        return self._live.rays(*self._at(frame, pose), self.world._space_handle, directions, max_distance)

    def picture(self, frame: str, width: int = 320, height: int = 240, *, field: float | None = None, max_distance: float = 100.0,
                threads: int = 1, pose: ArrayLike | None = None) -> Picture:
        """A ``Picture`` by a camera of the file (``Model.cameras``), or by one that looks along a frame's -z axis, x to the right, y up; field:
        of view, from the lowest to the highest row, rad; None: the camera's, else 0.8. It needs no display; the frame's link is not seen."""
        camera = next((one for one in self.model.cameras if one.name == frame), None)
        if field is None:
            field = 0.8 if camera is None else camera.field
        place = self._at(frame, pose) if camera is None or pose is not None else (camera.link, camera.frame)
        color, depth, geoms = self._live.picture(*place, self.world._space_handle, width, height, field, max_distance, threads)
        return Picture(np.frombuffer(color, np.uint8).reshape(height, width, 3), depth,
                       np.frombuffer(geoms, np.uint64).reshape(height, width))

    def sensor(self, sensor: str | int) -> FloatArray:
        """Read a sensor that the file names, by name or number."""
        number = _number(sensor, [s.name for s in self.model.sensors], "sensor")
        try:
            return self._live.read_sensor(number, self.world._space_handle)
        except ValueError as problem:
            if "dRobotUpdateSensors" not in str(problem):
                raise RefusedError(f"sensor {sensor!r}, a {self.model.sensors[number].kind}, {problem}") from None
            self._senses = True
            raise RefusedError(f"sensor {sensor!r} is of the last step, and none has been measured yet: read it after World.step") from None

    @property
    def sensors(self) -> dict[str | int, FloatArray]:
        """What the sensors of the file read, by name, or number if they have none; without those that are not computed, or of
        which no step has been measured yet."""
        out: dict[str | int, FloatArray] = {}
        for number, sensor in enumerate(self.model.sensors):
            try:
                out[sensor.name or number] = self.sensor(number)
            except RefusedError:
                pass
        return out

    def destroy(self) -> None:
        """Destroy the robot's bodies, joints and geoms."""
        self._live
        for joint in self._joints.values():
            if joint.alive:
                joint.destroy()
        for body in self._bodies.values():
            if body.alive:
                body.destroy()
        for geom in self._geoms:
            if geom.alive:
                geom.destroy()
        self.world._edition += 1
        if self.world._past is None:  # else a step taken back brings geoms back, which point to the model's arrays
            self._dead()
            self.world._robots.remove(self)

    def _dead(self) -> None:
        if self._robot is not None:
            self._robot.release()
        self._robot = None
