# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Rigid bodies with exact joints and hard contacts.

>>> import epode
>>> with epode.World(gravity=(0, 0, -9.81)) as world:
...     ground = world.plane()
...     ball = world.body(mass=1, position=(0, 0, 2), shape=epode.Sphere(0.2))
...     for _ in range(200):
...         world.step(0.01)
...     print(round(float(ball.position[2]), 2))
0.2

Lengths are in m, masses in kg, angles in rad; quaternions are w x y z. ``epode.c`` has the whole C API.
"""
from typing import TYPE_CHECKING, Any

from . import c
from .body import Body, BodyGroup
from .character import Character
from .enums import (Behaviour, BoneJoint, CauseKind, CharacterState, CombineRule, ContactEventKind, Differential, EventGone, EventKind, Falloff,
                    IslandMethod, RopeEnds, Severity, VehicleKind, WheelCast)
from .errors import BusyError, DeadHandleError, EpodeWarning, RefusedError
from .fluid import Fluid
from .fracture import Fracture
from .geom import Geom
from .joint import Drive, Joint, joint_states
from .ragdoll import Bone, Ragdoll, human
from .recording import Recording
from .rope import Rope
from .shapes import (Box, Capsule, Cone, Convex, Cylinder, Decomposition, Ellipsoid, HeightField, Material, Mesh, Plane,
                     Sphere, TaperedCapsule, decompose)
from .vehicle import Vehicle, Wheel
from .world import Cause, World, defaults_text, load_world, step_worlds

if TYPE_CHECKING:
    from . import robot, sweep, vector
    from .batch import Batch
    from .robot import Model as Model, Robot as Robot, Robots as Robots, load

__version__ = "0.1.0"
__all__ = ["Batch", "Behaviour", "Body", "BodyGroup", "Bone", "BoneJoint", "Box", "BusyError", "Capsule", "Cause",
           "CauseKind", "Character", "CharacterState", "CombineRule", "Cone", "ContactEventKind", "Convex", "Cylinder",
           "DeadHandleError", "Decomposition", "Differential", "Drive", "Ellipsoid", "EpodeWarning", "EventGone",
           "EventKind", "Falloff", "Fluid", "Fracture", "Geom", "HeightField", "IslandMethod", "Joint", "Material",
           "Mesh", "Plane", "Ragdoll", "Recording", "RefusedError", "Rope", "RopeEnds", "Severity", "Sphere",
           "TaperedCapsule", "Vehicle", "VehicleKind", "Wheel", "WheelCast", "World", "c", "decompose",
           "defaults_text", "human", "joint_states", "load", "load_world", "robot", "step_worlds", "sweep", "vector"]


def __getattr__(name: str) -> Any:
    """epode.robot, epode.load, epode.Model, epode.Robot, epode.Robots, epode.Batch, epode.vector and epode.sweep are imported when they are used first: the rest does not wait
    for them."""
    if name in ("robot", "load", "Model", "Robot", "Robots"):
        import importlib
        robot = importlib.import_module(".robot", __name__)
        globals().update(robot=robot, load=robot.load, Model=robot.Model, Robot=robot.Robot, Robots=robot.Robots)
        return globals()[name]
    if name == "Batch":
        from .batch import Batch
        globals()[name] = Batch
        return Batch
    if name in ("vector", "sweep"):
        import importlib
        return importlib.import_module(f".{name}", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
