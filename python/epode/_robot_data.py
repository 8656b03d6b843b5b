# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The plain data of epode.robot: parts of a model, what sensors and inverse kinematics answer, options."""
from __future__ import annotations

import os
import typing
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._handle import FloatArray

if typing.TYPE_CHECKING:
    from .geom import Geom

Path = str | os.PathLike[str]


class Note(typing.NamedTuple):
    """A line of a report. kind: changed (something else with the same motion), approximated, ignored or error."""
    kind: str
    file: str
    line: int
    text: str


class Link(typing.NamedTuple):
    """A link; number 0 is the world. centre, m, and inertia, kg m^2, about it, are in the link's frame."""
    name: str
    parent: int
    mass: float
    centre: FloatArray
    inertia: FloatArray
    joints: list[int]
    shapes: int


class ModelJoint(typing.NamedTuple):
    """A joint between a link and its parent; position and velocity: number of its first one among all."""
    name: str
    kind: str
    link: int
    position: int
    velocity: int
    anchor: FloatArray
    axis: FloatArray
    low: float
    high: float
    max_force: float
    max_velocity: float


class Actuator(typing.NamedTuple):
    """What a control acts on; joint -1: a tendon. low and high clamp the control."""
    name: str
    kind: str
    joint: int
    low: float
    high: float


class Sensor(typing.NamedTuple):
    """A sensor that a file names: ``Robot.sensor`` reads values numbers of it; 0: it is not computed."""
    name: str
    kind: str
    object: str
    values: int


class Touch(typing.NamedTuple):
    """What touches a link: points of contact (an int), the sum of their normal forces, N (a float), the force on the link, N, and
    the centre of pressure, m, in the world. ``Robots.touch`` has arrays of them."""
    points: typing.Any
    normal_force: typing.Any
    force: FloatArray
    centre: FloatArray


class RobotContact(typing.NamedTuple):
    """A point at which a robot touched something in the last step: its link and what that touched (a link's name, or the Geom
    of something else), the place, m, the normal, which points to the link, by how much they overlap, m, the forces on the
    link: along the normal, N, and of friction, N, in the world's axes, and the two Geoms (``Robot.geom_name``)."""
    link: str
    other: typing.Any
    position: FloatArray
    normal: FloatArray
    depth: float
    normal_force: float
    friction_force: FloatArray
    geom: Geom
    other_geom: Geom


class Picture(typing.NamedTuple):
    """What a camera sees, row by row from the top: red, green and blue, depth along the view axis, m, infinite where there
    is nothing, and geoms (``World.geom_of`` knows them; 0: nothing)."""
    color: NDArray[np.uint8]
    depth: FloatArray
    geoms: NDArray[np.uint64]


class Camera(typing.NamedTuple):
    """A camera of a file: it looks along the -z axis of its frame, x to the right, y up. frame: position and quaternion in the frame of the
    link of that number; field: of view, from the lowest to the highest row, rad."""
    name: str
    link: int
    frame: FloatArray
    field: float


class Target(typing.NamedTuple):
    """Where a frame is to be brought: its point (in the frame, m) to position, m, and the frame to quaternion, in the
    model's world; None: anywhere, any way."""
    frame: str
    position: ArrayLike | None = None
    quaternion: ArrayLike | None = None
    point: ArrayLike = (0.0, 0.0, 0.0)
    position_weight: float = 1.0
    orientation_weight: float = 1.0


class Solution(typing.NamedTuple):
    """What inverse kinematics found; errors in m and rad are the largest of all targets."""
    positions: FloatArray
    reached: bool
    position_error: float
    orientation_error: float
    residual: float
    iterations: int
    starts: int


class Options(typing.TypedDict, total=False):
    """What ``load`` may be given besides the file."""
    strict: bool
    keep_fixed: bool
    fixed_base: bool
    repair: bool
    inertia_from_shapes: bool
    meshes_as_triangles: bool
    meshes_as_parts: bool
    missing_mass: float
    roots: Sequence[Path]
