# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Start poses by the names of joints, so that edits that change the order of coordinates keep them; MJCF has lists in that order."""
from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any

import numpy as np

from ._tree import Element, text_of

if TYPE_CHECKING:
    from ._description import Description


@dataclasses.dataclass
class Start:
    """A start pose. positions: a number of a hinge or slide, a quaternion of a ball, position and quaternion of a free joint, by
    the names of joints; others are where they are described. controls: by the names of actuators. mocap: position and quaternion of
    links that the program moves."""
    positions: dict[str, Any] = dataclasses.field(default_factory=dict)
    controls: dict[str, float] = dataclasses.field(default_factory=dict)
    mocap: dict[str, tuple[Any, Any]] = dataclasses.field(default_factory=dict)


def read_starts(description: Description) -> dict[str, Start]:
    """Those of <keyframe>, which is taken out of the tree."""
    keys, out = description._top.child("keyframe"), dict[str, Start]()
    if keys is None:
        return out
    for key in keys.children:
        start, at = Start(), 0
        for joint in description.joints:
            count = {"ball": 4, "free": 7}.get(joint.kind, 1)
            values = key.numbers("qpos")[at:at + count]
            if len(values) == count:
                start.positions[joint.name] = float(values[0]) if count == 1 else tuple(map(float, values))
            at += count
        for number, (actuator, value) in enumerate(zip(description.actuators, key.numbers("ctrl"))):
            if actuator["name"] is None:
                actuator.words["name"] = description._free_name("actuator", f"actuator{number}")
            start.controls[actuator.name] = float(value)
        places, turns = key.numbers("mpos").reshape(-1, 3), key.numbers("mquat").reshape(-1, 4)
        for link, place, turn in zip((one for one in description.links if one.is_mocap), places, turns):
            start.mocap[link.name] = tuple(map(float, place)), tuple(map(float, turn))
        out[key["name"] or f"start{len(out)}"] = start
    description._top.children.remove(keys)
    return out


def key_of(description: Description, name: str, start: Start) -> Element:
    """The element <key> of a start pose."""
    q: list[float] = []
    for joint in description.joints:
        reference: Any = joint.reference
        if joint.kind == "ball":
            reference = (1, 0, 0, 0)
        elif joint.kind == "free":
            reference = (*joint.link.position, *joint.link.quaternion)
        q.extend(np.atleast_1d(np.asarray(start.positions.get(joint.name, reference), float)))
    key = Element("key", {"name": name, "qpos": text_of(q)})
    if start.controls:
        key["ctrl"] = [start.controls.get(one.name, 0.0) for one in description.actuators]
    moved = [one for one in description.links if one.is_mocap]
    if start.mocap and moved:
        poses = [start.mocap.get(one.name, (one.position, one.quaternion)) for one in moved]
        key["mpos"] = np.concatenate([np.asarray(pose[0], float) for pose in poses])
        key["mquat"] = np.concatenate([np.asarray(pose[1], float) for pose in poses])
    return key
