# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Rigid bodies, and arrays of the states of many."""
import numpy as np

from . import c
from ._handle import Object, flag, reads, reads_and_sets, switch, vector


class Body(Object):
    """A rigid body, made by ``World.body``. Vectors are in the world's frame and are copies."""

    __slots__ = ("geoms",)

    def __init__(self, world, handle):
        self.world, self._live, self.geoms = world, handle, []

    position = vector(c.dBodyGetPosition, c.dBodySetPosition, "Of the centre of mass, m.")
    velocity = vector(c.dBodyGetLinearVel, c.dBodySetLinearVel, "Of the centre of mass, m/s.")
    angular_velocity = vector(c.dBodyGetAngularVel, c.dBodySetAngularVel, "rad/s.")
    force = vector(c.dBodyGetForce, c.dBodySetForce, "Accumulated for the next step, N.")
    torque = vector(c.dBodyGetTorque, c.dBodySetTorque, "Accumulated for the next step, N m.")
    quaternion = reads_and_sets(c.dBodyGetQuaternion, c.dBodySetQuaternion, "w x y z.")
    rotation = reads_and_sets(c.dBodyGetRotation, c.dBodySetRotation, "3 x 3: body coordinates to the world's.")
    gravity = flag(c.dBodyGetGravityMode, c.dBodySetGravityMode, "Whether gravity acts on the body.")
    gyroscopic = flag(c.dBodyGetGyroscopicMode, c.dBodySetGyroscopicMode, "Whether the gyroscopic torque acts.")
    linear_damping = reads_and_sets(c.dBodyGetLinearDamping, c.dBodySetLinearDamping, "Share of velocity lost in a step.")
    angular_damping = reads_and_sets(c.dBodyGetAngularDamping, c.dBodySetAngularDamping, "Share of rotation lost in a step.")
    auto_disable = flag(c.dBodyGetAutoDisableFlag, c.dBodySetAutoDisableFlag, "Whether the body may fall asleep.")
    joint_count = reads(c.dBodyGetNumJoints, "How many joints are attached.")

    @property
    def quaternion_xyzw(self):
        """The quaternion with the real part last, as scipy, glTF and ROS have it."""
        return np.roll(self.quaternion, -1)

    @quaternion_xyzw.setter
    def quaternion_xyzw(self, value):
        self.quaternion = np.roll(np.asarray(value, float), 1)

    @property
    def mass(self):
        """The mass, kg. Setting it scales the inertia."""
        return self.mass_properties.mass

    @mass.setter
    def mass(self, value):
        m = self.mass_properties
        c.dMassAdjust(m, value)
        c.dBodySetMass(self._handle, m)

    @property
    def inertia(self):
        """3 x 3, about the centre of mass, in the body's frame, kg m^2."""
        return self.mass_properties.I

    @inertia.setter
    def inertia(self, value):
        m = self.mass_properties
        m.I = value
        c.dBodySetMass(self._handle, m)

    @property
    def mass_properties(self):
        """A copy of the body's ``c.dMass``."""
        m = c.dMass()
        c.dBodyGetMass(self._handle, m)
        return m

    @mass_properties.setter
    def mass_properties(self, value):
        c.dBodySetMass(self._handle, value)

    enabled = switch(c.dBodyIsEnabled, c.dBodyEnable, c.dBodyDisable,
                     "Whether steps move the body; false while it sleeps.")
    kinematic = switch(c.dBodyIsKinematic, c.dBodySetKinematic, c.dBodySetDynamic,
                       "Whether the body moves as its velocity says, and nothing else moves it.")

    @property
    def joints(self):
        """The joints attached that Python knows."""
        handles = (c.dBodyGetJoint(self._handle, i) for i in range(self.joint_count))
        known = self.world._joints
        return [known[h] for h in handles if h in known]

    def add_force(self, force, *, at=None, relative=False):
        """Add a force, N, for the next step, at the centre or at a point of the world; relative: in the body's frame."""
        if at is not None:
            (c.dBodyAddRelForceAtPos if relative else c.dBodyAddForceAtPos)(self._handle, *force, *at)
        else:
            (c.dBodyAddRelForce if relative else c.dBodyAddForce)(self._handle, *force)

    def add_torque(self, torque, *, relative=False):
        """Add a torque, N m, for the next step; relative: in the body's frame."""
        (c.dBodyAddRelTorque if relative else c.dBodyAddTorque)(self._handle, *torque)

    def to_world(self, point):
        """Where a point of the body is in the world."""
        return c.dBodyGetRelPointPos(self._handle, *point)

    def to_body(self, point):
        """Which point of the body is at a point of the world."""
        return c.dBodyGetPosRelPoint(self._handle, *point)

    def velocity_at(self, point):
        """The velocity of the body at a point of the world, m/s."""
        return c.dBodyGetPointVel(self._handle, *point)

    def add(self, shape, **settings):
        """Put a shape on the body, as ``World.geom`` does."""
        return self.world.geom(shape, body=self, **settings)

    def on_move(self, function):
        """Call function(body) after each step that moved the body; None: no more."""
        wrapped = None if function is None else (lambda _handle: function(self))
        c.dBodySetMovedCallback(self._handle, wrapped)

    def destroy(self):
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


class Bodies:
    """All bodies of a world, from the oldest on. Its properties are arrays with a row for each body, read and set by
    one C call: ``world.bodies.position`` is a new (n, 3) array."""

    __slots__ = ("_world",)

    def __init__(self, world):
        self._world = world

    def __len__(self):
        return len(self._list())

    def __iter__(self):
        known = self._world._bodies
        handles = self._list()
        return (known[handles[i]] for i in range(len(handles)))

    def __getitem__(self, index):
        return list(self)[index]

    def _list(self):
        world = self._world
        if world._body_list is None:
            world._body_list = c.dWorldGetBodies(world._handle)
        return world._body_list

    def get(self, *names):
        """One array with the named parts side by side, in the order of ``position``, ``quaternion``, ``velocity``,
        ``angular_velocity``, ``force``, ``torque``, ``enabled``."""
        return c.dBodiesGetStates(self._list(), self._fields(names))

    def set(self, states, *names):
        """Set the named parts of all bodies from an array as ``get`` returns it."""
        c.dBodiesSetStates(self._list(), self._fields(names), states)

    def _fields(self, names):
        self._world._handle
        return sum(_COLUMNS[name][0] for name in set(names))


def _column(name):
    def get(self):
        rows = self.get(name)
        return rows[:, 0].astype(bool) if name == "enabled" else rows

    def put(self, value):
        shape = (len(self), _COLUMNS[name][1])
        value = np.asarray(value, float)
        self.set(np.broadcast_to(value.reshape(-1, 1) if name == "enabled" and value.ndim else value, shape), name)
    return property(get, put, doc=f"The {name.replace('_', ' ')} of each body, as an array.")


for _name in _COLUMNS:
    setattr(Bodies, _name, _column(_name))
