# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Rigid bodies, and arrays of the states of many."""
from __future__ import annotations

import weakref
from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, Any, SupportsIndex

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import c
from ._handle import FloatArray, Object, Value, flag, reads, reads_and_sets, share, switch, three, vector
from .errors import BusyError, RefusedError

if TYPE_CHECKING:
    from .geom import Geom
    from .joint import Joint
    from .shapes import Shape
    from .world import World


class Body(Object):
    """A rigid body, made by ``World.body``. Vectors are in the world's frame and are copies."""

    __slots__ = ("geoms",)
    geoms: list[Geom]

    def __init__(self, world: World, handle: c.dBodyID) -> None:
        """As ``World.body`` does: handle is a body of the world."""
        self.world, self._live, self.geoms = world, handle, []

    def __repr__(self) -> str:
        if not self.alive:
            return super().__repr__()
        try:
            (x, y, z), mass = self.position, self.mass
        except BusyError:  # in a step of another thread
            return super().__repr__()
        return f"<epode.Body: {mass:.4g} kg at ({x:.4g}, {y:.4g}, {z:.4g})>"

    position = vector(c.dBodyGetPosition, c.dBodySetPosition, "Of the centre of mass, m.")
    velocity = vector(c.dBodyGetLinearVel, c.dBodySetLinearVel, "Of the centre of mass, m/s.")
    angular_velocity = vector(c.dBodyGetAngularVel, c.dBodySetAngularVel, "rad/s.")
    force = vector(c.dBodyGetForce, c.dBodySetForce, "Accumulated for the next step, N.")
    torque = vector(c.dBodyGetTorque, c.dBodySetTorque, "Accumulated for the next step, N m.")
    quaternion = reads_and_sets(c.dBodyGetQuaternion, c.dBodySetQuaternion, "w x y z.")
    rotation = reads_and_sets(c.dBodyGetRotation, c.dBodySetRotation, "3 x 3: body coordinates to the world's.")
    gravity = flag(c.dBodyGetGravityMode, c.dBodySetGravityMode, "Whether gravity acts on the body.")
    gyroscopic = flag(c.dBodyGetGyroscopicMode, c.dBodySetGyroscopicMode, "Whether the gyroscopic torque acts.")
    linear_damping = share(c.dBodyGetLinearDamping, c.dBodySetLinearDamping, "Share of velocity lost in a step.")
    angular_damping = share(c.dBodyGetAngularDamping, c.dBodySetAngularDamping, "Share of rotation lost in a step.")
    auto_disable = flag(c.dBodyGetAutoDisableFlag, c.dBodySetAutoDisableFlag, "Whether the body may fall asleep.")
    joint_count = reads(c.dBodyGetNumJoints, "How many joints are attached.")

    @property
    def quaternion_xyzw(self) -> FloatArray:
        """The quaternion with the real part last, as scipy, glTF and ROS have it."""
        return np.roll(self.quaternion, -1)

    @quaternion_xyzw.setter
    def quaternion_xyzw(self, value: ArrayLike) -> None:
        self.quaternion = np.roll(np.asarray(value, float), 1)

    @property
    def mass(self) -> float:
        """The mass, kg. Setting it scales the inertia."""
        return self.mass_properties.mass

    @mass.setter
    def mass(self, value: float) -> None:
        if not 0 < value < float("inf"):
            raise RefusedError(f"mass is {value}; a positive number is expected")
        m = self.mass_properties
        c.dMassAdjust(m, value)
        c.dBodySetMass(self._handle, m)

    @property
    def inertia(self) -> FloatArray:
        """3 x 3, about the centre of mass, in the body's frame, kg m^2."""
        return self.mass_properties.I

    @inertia.setter
    def inertia(self, value: ArrayLike) -> None:
        m = self.mass_properties
        m.I = value
        c.dBodySetMass(self._handle, m)

    @property
    def mass_properties(self) -> c.dMass:
        """A copy of the body's ``c.dMass``."""
        m = c.dMass()
        c.dBodyGetMass(self._handle, m)
        return m

    @mass_properties.setter
    def mass_properties(self, value: c.dMass) -> None:
        c.dBodySetMass(self._handle, value)

    enabled = switch(c.dBodyIsEnabled, c.dBodyEnable, c.dBodyDisable,
                     "Whether steps move the body; false while it sleeps.")
    kinematic = switch(c.dBodyIsKinematic, c.dBodySetKinematic, c.dBodySetDynamic,
                       "Whether the body moves as its velocity says, and nothing else moves it.")

    @property
    def joints(self) -> list[Joint]:
        """The joints attached that Python knows."""
        handles = (c.dBodyGetJoint(self._handle, i) for i in range(self.joint_count))
        known = self.world._joints
        return [known[h] for h in handles if h is not None and h in known]

    def add_force(self, force: ArrayLike, *, at: ArrayLike | None = None, relative: bool = False) -> None:
        """Add a force, N, for the next step, at the centre or at a point of the world; relative: in the body's frame."""
        fx, fy, fz = three(force, "force")
        if at is not None:
            x, y, z = three(at, "at")
            (c.dBodyAddRelForceAtPos if relative else c.dBodyAddForceAtPos)(self._handle, fx, fy, fz, x, y, z)
        else:
            (c.dBodyAddRelForce if relative else c.dBodyAddForce)(self._handle, fx, fy, fz)

    def add_torque(self, torque: ArrayLike, *, relative: bool = False) -> None:
        """Add a torque, N m, for the next step; relative: in the body's frame."""
        (c.dBodyAddRelTorque if relative else c.dBodyAddTorque)(self._handle, *three(torque, "torque"))

    def apply_impulse(self, impulse: ArrayLike, *, at: ArrayLike | None = None) -> None:
        """Give an impulse, N s, at the centre or at a point of the world: the velocities change at once, and the body wakes."""
        c.dBodyApplyImpulse(self._handle, impulse, self.position if at is None else at)

    def apply_angular_impulse(self, impulse: ArrayLike) -> None:
        """Give the moment of an impulse, N m s: the angular velocity changes at once, and the body wakes."""
        c.dBodyApplyAngularImpulse(self._handle, impulse)

    def apply_force(self, force: ArrayLike, *, at: ArrayLike | None = None) -> None:
        """Add a force, N, for the next step, at the centre or at a point of the world, and wake the body."""
        c.dBodyApplyForce(self._handle, force, self.position if at is None else at)

    def apply_torque(self, torque: ArrayLike) -> None:
        """Add a torque, N m, for the next step, and wake the body."""
        c.dBodyApplyTorque(self._handle, torque)

    def set_velocities(self, linear: ArrayLike | None = None, angular: ArrayLike | None = None, *, wake: bool = True) -> None:
        """Set the linear (m/s) and the angular velocity (rad/s); None: it stays."""
        c.dBodySetVelocities(self._handle, self.velocity if linear is None else linear,
                             self.angular_velocity if angular is None else angular, int(wake))

    @property
    def fluid_force(self) -> tuple[FloatArray, FloatArray]:
        """(force, torque) that fluids exerted on the body in the last step in which it was awake; zeros outside of them."""
        _, force, torque = c.dBodyGetFluidForce(self._handle)
        return force, torque

    def to_world(self, point: ArrayLike) -> FloatArray:
        """Where a point of the body is in the world."""
        return c.dBodyGetRelPointPos(self._handle, *three(point, "point"))

    def to_body(self, point: ArrayLike) -> FloatArray:
        """Which point of the body is at a point of the world."""
        return c.dBodyGetPosRelPoint(self._handle, *three(point, "point"))

    def velocity_at(self, point: ArrayLike) -> FloatArray:
        """The velocity of the body at a point of the world, m/s."""
        return c.dBodyGetPointVel(self._handle, *three(point, "point"))

    def add(self, shape: Shape, **settings: Any) -> Geom:
        """Put a shape on the body, as ``World.geom`` does."""
        return self.world.geom(shape, body=self, **settings)

    def on_move(self, function: Callable[[Body], Any] | None) -> None:
        """Call function(body) after each step that moved the body; None: no more."""
        if function is None:
            c.dBodySetMovedCallback(self._handle, None)
            return
        called, body = function, weakref.ref(self)  # what the engine keeps must not keep the world

        def moved(_: c.dBodyID) -> None:
            if (me := body()) is not None:
                called(me)
        c.dBodySetMovedCallback(self._handle, moved)

    def destroy(self) -> None:
        """Destroy the body and its geoms; joints stay and hold nothing there."""
        handle = self._handle
        c.dBodyDestroy(handle)
        self._live = None
        self.world._forget_body(handle)
        for geom in list(self.geoms):
            geom.destroy()


_COLUMNS = {"position": (c.dStatePosition, 3), "quaternion": (c.dStateQuaternion, 4),
            "velocity": (c.dStateLinearVel, 3), "angular_velocity": (c.dStateAngularVel, 3),
            "force": (c.dStateForce, 3), "torque": (c.dStateTorque, 3), "enabled": (c.dStateEnabled, 1)}


def _column(name: str) -> Value[FloatArray, ArrayLike]:
    def get(self: Bodies) -> FloatArray:
        return self.get(name)

    def put(self: Bodies, value: ArrayLike) -> None:
        self.set(np.broadcast_to(np.asarray(value, float), (len(self), _COLUMNS[name][1])), name)
    return Value(get, put, doc=f"The {name.replace('_', ' ')} of each body, as an array.")


class Bodies:
    """All bodies of a world, from the oldest on. Its properties are arrays with a row for each body, read and set by
    one C call: ``world.bodies.position`` is a new (n, 3) array."""

    __slots__ = ("_world",)

    def __init__(self, world: World) -> None:
        """As ``World.bodies`` is: all bodies of the world."""
        self._world = world

    position = _column("position")
    quaternion = _column("quaternion")
    velocity = _column("velocity")
    angular_velocity = _column("angular_velocity")
    force = _column("force")
    torque = _column("torque")

    @property
    def enabled(self) -> NDArray[np.bool_]:
        """Whether each body is moved by steps, as an array."""
        return self.get("enabled")[:, 0].astype(bool)

    @enabled.setter
    def enabled(self, value: ArrayLike) -> None:
        self.set(np.broadcast_to(np.asarray(value, float), len(self)), "enabled")

    def __len__(self) -> int:
        return len(self._list())

    def __iter__(self) -> Iterator[Body]:
        known = self._world._bodies
        handles = self._list()
        return (known[handles[i]] for i in range(len(handles)))

    def __getitem__(self, index: SupportsIndex) -> Body:
        return list(self)[index]

    def _list(self) -> c.BodyList:
        world = self._world
        if world._live is None or world._body_list is None:
            world._body_list = c.dWorldGetBodies(world._handle)
        return world._body_list

    def __repr__(self) -> str:
        return f"<epode.{type(self).__name__} of {len(self)}>"

    def get(self, *names: str, out: FloatArray | None = None) -> FloatArray:
        """One array with the named parts side by side, in the order of ``position``, ``quaternion``, ``velocity``,
        ``angular_velocity``, ``force``, ``torque``, ``enabled``. out: a float64 array of that size to fill instead of a
        new one."""
        return c.dBodiesGetStates(self._list(), _fields(names), out)

    def set(self, states: ArrayLike, *names: str) -> None:
        """Set the named parts of all bodies from an array as ``get`` returns it."""
        c.dBodiesSetStates(self._list(), _fields(names), states)


class BodyGroup(Bodies):
    """Some bodies, of one world or of several, with the same arrays: one C call reads a body of each of a thousand worlds."""

    __slots__ = ("_members", "_handles")

    def __init__(self, bodies: Iterable[Body]) -> None:
        """bodies: a row of the arrays each, in this order."""
        self._members = list(bodies)
        self._handles = c.BodyList([body._handle for body in self._members])

    def __iter__(self) -> Iterator[Body]:
        return iter(self._members)

    def _list(self) -> c.BodyList:
        return self._handles

    def get(self, *names: str, out: FloatArray | None = None) -> FloatArray:
        """As ``Bodies.get``."""
        try:
            return super().get(*names, out=out)
        except RefusedError:
            self._must_live()
            raise

    def set(self, states: ArrayLike, *names: str) -> None:
        """As ``Bodies.set``."""
        try:
            super().set(states, *names)
        except RefusedError:
            self._must_live()
            raise

    def _must_live(self) -> None:
        for body in self._members:
            body._handle


def _fields(names: tuple[str, ...]) -> int:
    known = _FIELDS.get(names)
    if known is None:
        unknown = [name for name in names if name not in _COLUMNS]
        if unknown or not names:
            raise ValueError(f"{', '.join(unknown) or 'nothing'}: no part of a state; there are {', '.join(_COLUMNS)}")
        known = _FIELDS[names] = sum(_COLUMNS[name][0] for name in set(names))
    return known


_FIELDS: dict[tuple[str, ...], int] = {}
