# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A description's mirror image. With S = 1 - 2 n n^T: points and directions x become S x, frames R become S R S, inertias S I S; what turns
(axes of hinges) becomes -S a, so that the same coordinate moves the mirror image. Shapes are mirror images of themselves, but
for meshes, which get a negative scale, and height fields, whose rows change places."""
from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._handle import FloatArray
from ._geoms import Geom
from ._links import Joint
from ._tree import Element
from ._turns import matrix_of, mirrored, turn_of_matrix
from ._values import put_pose

if TYPE_CHECKING:
    from ._description import Description


def mirror(description: Description, axis: int) -> None:
    """See Description.mirror."""
    _check_fields(description)
    sign = np.ones(3)
    sign[axis] = -1
    for one in list(description._top.walk()):
        if one.section == "worldbody" and one.tag in ("body", "geom", "site", "inertial", "joint"):
            _mirror_element(one, axis, sign)
        elif one.tag in ("connect", "weld"):
            _mirror_loop(one, axis, sign)
        elif one.section == "asset" and one.tag == "mesh":
            one["scale"] = one.numbers("scale", (1, 1, 1)) * sign
        elif one.section == "asset" and one.tag == "hfield":
            _mirror_field(one)
    description.gravity = description.gravity * sign
    if description.option["wind"] is not None:
        description.option["wind"] = description.option.numbers("wind") * sign
    balls = {joint.name for joint in description.joints if joint.kind == "ball"}
    for actuator in description.actuators:
        gear = actuator.numbers("gear")
        if len(gear) >= 3 and actuator["joint"] in balls:
            actuator["gear"] = np.concatenate([-sign * gear[:3], gear[3:]])
        elif len(gear) == 6 and actuator["site"] is not None:
            actuator["gear"] = np.concatenate([sign * gear[:3], -sign * gear[3:]])
    _mirror_starts(description, axis, sign)


def _mirror_element(one: Element, axis: int, sign: FloatArray) -> None:
    if one["pos"] is not None:
        one["pos"] = one.numbers("pos") * sign
    if isinstance(one, Geom) and one.kind in ("plane", "hfield"):  # whose z stays outward: they are their own image across y
        s, local = np.diag(sign), np.diag([1.0, -1, 1])
        put_pose(one, None, turn_of_matrix(s @ matrix_of(one.numbers("quat", (1, 0, 0, 0))) @ local))
    elif one["quat"] is not None:
        one["quat"] = mirrored(one.numbers("quat"), axis)
    if one["fullinertia"] is not None:
        f = one.numbers("fullinertia")
        products = np.array([sign[0] * sign[1], sign[0] * sign[2], sign[1] * sign[2]])
        one["fullinertia"] = np.concatenate([f[:3], f[3:] * products])
    if isinstance(one, Joint) and one.kind in ("hinge", "slide"):
        one["axis"] = one.axis * (sign if one.kind == "slide" else -sign)


def _mirror_loop(one: Element, axis: int, sign: FloatArray) -> None:
    if one["anchor"] is not None:
        one["anchor"] = one.numbers("anchor") * sign
    if one["relpose"] is not None:
        pose = one.numbers("relpose")
        one["relpose"] = np.concatenate([pose[:3] * sign, mirrored(pose[3:], axis) if pose[3:].any() else pose[3:]])


def _check_fields(description: Description) -> None:
    for one in description._top.walk():
        if one.tag == "hfield" and one.section == "asset" and one["file"] is not None:
            raise ValueError(f"the height field {one['name']!r} of a file cannot be mirrored: its samples stand in {one['file']}")


def _mirror_field(one: Element) -> None:
    rows, columns = int(one.numbers("nrow", [0])[0]), int(one.numbers("ncol", [0])[0])
    samples = one.numbers("elevation")
    if samples.size == rows * columns and samples.size:
        one["elevation"] = samples.reshape(rows, columns)[::-1]


def _mirror_starts(description: Description, axis: int, sign: FloatArray) -> None:
    kinds = {joint.name: joint.kind for joint in description.joints}

    def pose(p: FloatArray, q: FloatArray) -> tuple[tuple[float, ...], tuple[float, ...]]:
        return tuple(map(float, np.asarray(p, float) * sign)), tuple(map(float, mirrored(q, axis)))
    for start in description.starts.values():
        for name, value in start.positions.items():
            if kinds.get(name) == "free":
                place, turn = pose(np.asarray(value, float)[:3], np.asarray(value, float)[3:])
                start.positions[name] = (*place, *turn)
            elif kinds.get(name) == "ball":
                start.positions[name] = tuple(map(float, mirrored(value, axis)))
        start.mocap = {name: pose(*value) for name, value in start.mocap.items()}
