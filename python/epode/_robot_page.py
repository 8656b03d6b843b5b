# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What a notebook shows of a robot: a picture, and a table of its joints and controls."""
from __future__ import annotations

import base64
import html
import typing

import numpy as np

if typing.TYPE_CHECKING:
    from .robot import Robot

_UNITS = {"hinge": "rad", "slide": "m"}


def _table(head: list[str], rows: list[list[object]]) -> str:
    def cells(row: list[object], tag: str) -> str:
        return "".join(f"<{tag}>{html.escape(f'{cell:.4g}' if isinstance(cell, float) else str(cell))}</{tag}>" for cell in row)
    body = "".join(f"<tr>{cells(row, 'td')}</tr>" for row in rows)
    return f"<table><thead><tr>{cells(list(head), 'th')}</tr></thead><tbody>{body}</tbody></table>"


def _joints(robot: Robot) -> str:
    q, v = robot.positions, robot.velocities
    rows: list[list[object]] = []
    for joint in robot.model.joints:
        if joint.kind in _UNITS:
            limits = "-" if np.isinf([joint.low, joint.high]).all() else f"{joint.low:.4g} to {joint.high:.4g}"
            rows.append([joint.name, joint.kind, float(q[joint.position]), float(v[joint.velocity]), limits, _UNITS[joint.kind]])
        else:
            size = 7 if joint.kind == "free" else 4
            rows.append([joint.name, joint.kind, str(np.round(q[joint.position:joint.position + size], 3)), "", "-", ""])
    return _table(["joint", "kind", "position", "velocity", "limits", "unit"], rows)


def _actuators(robot: Robot) -> str:
    controls = robot.controls
    return _table(["actuator", "kind", "control", "range"],
                  [[one.name, one.kind, float(control), "-" if np.isinf([one.low, one.high]).all() else f"{one.low:.4g} to {one.high:.4g}"]
                   for one, control in zip(robot.model.actuators, controls)])


def _picture(robot: Robot) -> str:
    """Of the robot, from where all of it can be seen; empty in a build without pictures."""
    places = np.array([body.position for body in robot.bodies]) if robot.bodies else np.zeros((1, 3))
    boxes = [geom.aabb for geom in robot.geoms if geom.body is not None]
    low, high = (np.min([b[:, 0] for b in boxes], axis=0), np.max([b[:, 1] for b in boxes], axis=0)) if boxes else (
        places.min(axis=0), places.max(axis=0))
    centre, size = (low + high) / 2, max(0.1, float(np.linalg.norm(high - low)))
    try:
        png = robot.world.picture(width=480, height=360, eye=centre + size * np.array([0.8, -1.3, 0.6]), target=centre)
    except (RuntimeError, OSError):
        return ""
    return f'<img width="480" height="360" src="data:image/png;base64,{base64.b64encode(png).decode()}">'


def page(robot: Robot) -> str:
    """The robot as HTML."""
    if not robot.alive:
        return html.escape(repr(robot))
    title = f"<b>{html.escape(robot.model.name)}</b>: {len(robot.model.links) - 1} links, {len(robot.model.joints)} joints"
    return f"<div>{title}<br>{_picture(robot)}{_joints(robot)}{_actuators(robot) if robot.model.actuators else ''}</div>"
