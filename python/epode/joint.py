# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Joints of all types, through one class: what a type does not have raises AttributeError with what it has."""
from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from numpy.typing import ArrayLike

from . import c
from ._handle import FloatArray, Object, Value, describe_fields, switch, three

if TYPE_CHECKING:
    from .body import Body
    from .world import World

TYPES = {"ball": "Ball", "hinge": "Hinge", "slider": "Slider", "universal": "Universal", "hinge2": "Hinge2",
         "fixed": "Fixed", "amotor": "AMotor", "lmotor": "LMotor", "plane2d": "Plane2D", "pr": "PR", "pu": "PU",
         "piston": "Piston", "dball": "DBall", "dhinge": "DHinge", "transmission": "Transmission"}
_NAMES = TYPES | {"coupling": "Coupling"}  # made by World.couple
_NUMBERS = {getattr(c, f"dJointType{suffix}"): name for name, suffix in _NAMES.items()}


def type_of(handle: c.dJointID) -> str:
    """The name of a joint's type."""
    return _NUMBERS[c.dJointGetType(handle)]


_PARAMETERS = {"lo_stop": "LoStop", "hi_stop": "HiStop", "velocity": "Vel", "max_force": "FMax",
               "fudge_factor": "FudgeFactor", "bounce": "Bounce", "cfm": "CFM", "stop_erp": "StopERP",
               "stop_cfm": "StopCFM", "suspension_erp": "SuspensionERP", "suspension_cfm": "SuspensionCFM", "erp": "ERP"}


@dataclasses.dataclass
class Drive:
    """A drive on an axis: force + stiffness (target - q) + damping (target_velocity - w), at most force_limit, and
    the inertia of a rotor (armature) and dry friction. Implicit in the step; 0 is not there."""
    stiffness: float = 0.0
    damping: float = 0.0
    armature: float = 0.0
    friction: float = 0.0
    target: float = 0.0
    target_velocity: float = 0.0
    force: float = 0.0
    force_limit: float = 0.0


def _place(name: str) -> Value[FloatArray, ArrayLike]:
    suffix = name.capitalize()

    def get(self: Joint) -> FloatArray:
        place: FloatArray = self._function("Get", suffix)(self._handle)
        return place

    def put(self: Joint, value: ArrayLike) -> None:
        function = self._function("Set", suffix)
        if self.type == "hinge2" and suffix.startswith("Axis"):
            c.dJointSetHinge2Axes(self._handle, *((value, None) if suffix == "Axis1" else (None, value)))
        else:
            function(self._handle, *three(value, name))
    kind = "A point" if name.startswith("anchor") else "A direction"
    return Value(get, put, doc=f"{kind} of the joint, in the world's frame, if its type has it.")


class Joint(Object):
    """A joint between two bodies, or a body and the world, made by ``World.joint``."""

    __slots__ = ("type", "body1", "body2")

    def __init__(self, world: World, handle: c.dJointID, kind: str, body1: Body | None, body2: Body | None) -> None:
        """As ``World.joint`` does: handle is a joint of the world, of that kind, between body1 and body2 (None: the world)."""
        self.world, self._live, self.type, self.body1, self.body2 = world, handle, kind, body1, body2

    def __repr__(self) -> str:
        return f"<epode.Joint: {self.type}>" if self.alive else super().__repr__()

    anchor, anchor1, anchor2 = _place("anchor"), _place("anchor1"), _place("anchor2")
    axis, axis1, axis2, axis3 = _place("axis"), _place("axis1"), _place("axis2"), _place("axis3")

    def _function(self, verb: str, name: str) -> Any:
        function = getattr(c, f"dJoint{verb}{_NAMES[self.type]}{name}", None)
        if function is None:
            raise AttributeError(f"a joint of type {self.type} has no {name.lower()} to {verb.lower()}")
        return function

    def parameter(self, name: str, axis: int = 0) -> float:
        """A parameter of an axis: lo_stop, hi_stop, velocity, max_force, bounce, cfm, stop_erp, ..."""
        value: float = self._function("Get", "Param")(self._handle, _number(name, axis))
        return value

    def set_parameter(self, name: str, value: float, axis: int = 0) -> None:
        """Set a parameter that ``parameter`` returns."""
        self._function("Set", "Param")(self._handle, _number(name, axis), value)

    @property
    def stops(self) -> tuple[float, float]:
        """Lowest and highest position of the first axis, m or rad; infinite: none. Setting None takes both away."""
        return self.parameter("lo_stop"), self.parameter("hi_stop")

    @stops.setter
    def stops(self, value: tuple[float, float] | None) -> None:
        low, high = (-float("inf"), float("inf")) if value is None else value
        if not low <= high:
            raise ValueError(f"stops ({low}, {high}): the lowest position first, or None")
        # The new range is never empty on the way, which would turn the stops off.
        self.set_parameter("lo_stop", -float("inf"))
        self.set_parameter("hi_stop", high)
        self.set_parameter("lo_stop", low)

    def motor(self, velocity: float, max_force: float, axis: int = 0) -> None:
        """Drive an axis at a velocity, m/s or rad/s, with at most that force, N or N m; max_force 0: no motor."""
        if not max_force >= 0:
            raise ValueError(f"max_force is {max_force}; 0 or more is expected")
        self.set_parameter("velocity", velocity, axis)
        self.set_parameter("max_force", max_force, axis)

    @property
    def axes(self) -> int:
        """How many coordinates the joint has."""
        return c.dJointGetNumAxes(self._handle)

    def position(self, axis: int = 0) -> float:
        """The coordinate of an axis, m or rad."""
        return c.dJointGetAxisPosition(self._handle, axis)

    def rate(self, axis: int = 0) -> float:
        """The derivative of ``position``, m/s or rad/s."""
        return c.dJointGetAxisRate(self._handle, axis)

    def drive(self, axis: int = 0) -> Drive | None:
        """The Drive of an axis, or None."""
        raw = c.dDrive()
        if not c.dJointGetDrive(self._handle, axis, raw):
            return None
        return Drive(**{f.name: getattr(raw, f.name) for f in dataclasses.fields(Drive)})

    def set_drive(self, drive: Drive | None = None, axis: int = 0, **fields: float) -> None:
        """Put a Drive on an axis (or its fields by name); None takes it away."""
        if drive is None and not fields:
            c.dJointSetDrive(self._handle, axis, None)
            return
        drive = dataclasses.replace(drive, **fields) if drive is not None else Drive(**fields)
        raw = c.dDrive()
        for field in dataclasses.fields(Drive):
            setattr(raw, field.name, getattr(drive, field.name))
        c.dJointSetDrive(self._handle, axis, raw)

    def drive_force(self, axis: int = 0) -> float:
        """What the drive has exerted, the mean over the last step, N or N m."""
        return c.dJointGetDriveForce(self._handle, axis)

    def add_force(self, *forces: float) -> None:
        """Add a force or torque along each axis for the next step."""
        name = {"hinge": "Torque", "slider": "Force", "universal": "Torques", "hinge2": "Torques", "amotor": "Torques",
                "piston": "Force", "pr": "Torque"}.get(self.type)
        if name is None:
            raise AttributeError(f"a joint of type {self.type} takes no force")
        getattr(c, f"dJointAdd{TYPES[self.type]}{name}")(self._handle, *forces)

    enabled = switch(c.dJointIsEnabled, c.dJointEnable, c.dJointDisable, "Whether the joint acts.")

    @property
    def broken(self) -> bool:
        """Whether the joint has broken (``break_limits``)."""
        return bool(c.dJointIsBroken(self._handle))

    @property
    def break_limits(self) -> tuple[float, float]:
        """The force, N, and torque, N m, above which the joint breaks."""
        return c.dJointGetBreakLimits(self._handle)[1:]

    @break_limits.setter
    def break_limits(self, value: tuple[float, float]) -> None:
        c.dJointSetBreakLimits(self._handle, *value)

    @property
    def feedback(self) -> c.dJointFeedback:
        """What the joint did in the last step, a ``c.dJointFeedback`` with f1, t1, f2 and t2; the first use switches it
        on, for the next step."""
        feedback = c.dJointGetFeedback(self._handle)
        if feedback is None:
            feedback = c.dJointFeedback()
            c.dJointSetFeedback(self._handle, feedback)
        return feedback

    def fix(self) -> None:
        """Let a fixed joint hold its bodies as they are now."""
        c.dJointSetFixed(self._handle)

    def destroy(self) -> None:
        """Take the joint away."""
        handle = self._handle
        c.dJointDestroy(handle)
        self._live = None
        self.world._joints.pop(handle, None)
        self.world._edition += 1


def joint_states(joints: Sequence[Joint], axes: int = 1) -> tuple[FloatArray, FloatArray]:
    """Positions and rates of many joints, of one world or of several, by one C call: arrays with a row for each joint and
    a column for each of 1 to 3 axes, 0 where a joint has no such axis."""
    return c.dJointsGetStates(c.JointList([joint._handle for joint in joints]), axes)


def _number(name: str, axis: int) -> int:
    if name not in _PARAMETERS:
        raise ValueError(f"no parameter is called {name!r}: {', '.join(_PARAMETERS)}")
    if axis not in (0, 1, 2):
        raise ValueError(f"axis {axis}: 0, 1 or 2 expected")
    first: int = getattr(c, "dParam" + _PARAMETERS[name])
    return first + axis * c.dParamGroup


SETTINGS = [name for name, one in vars(Joint).items() if isinstance(one, property) and one.fset is not None]  # of World.joint
describe_fields(Drive)
