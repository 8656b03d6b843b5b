# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The sliders of a robot: one for each actuator, and one for each joint with an axis."""
from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ._panel import Row, Slider, Title

if TYPE_CHECKING:
    from ._robot_data import Actuator, ModelJoint
    from .robot import Robot


def _ends(low: float, high: float, usual: float) -> tuple[float, float]:
    """Finite ones, in order."""
    low, high = low if math.isfinite(low) else -usual, high if math.isfinite(high) else usual
    return (low, high) if low < high else (low - usual, low + usual)


def _reach(robot: Robot, its: Actuator) -> tuple[float, float]:
    """Of a control: its range; else that of what a servo moves; else the largest force of the joint, or 10."""
    joint = robot.model.joints[its.joint] if its.joint >= 0 else None
    if joint is not None and its.kind == "position" and not math.isfinite(its.low):
        return _ends(joint.low, joint.high, math.pi)
    largest = joint.max_force if joint is not None and math.isfinite(joint.max_force) and joint.max_force > 0 else 10.0
    return _ends(its.low, its.high, largest)


def _actuator_slider(robot: Robot, number: int, its: Actuator) -> Slider:
    def read() -> float:
        return float(robot.controls[number]) if robot.alive else math.nan

    def turn(value: float) -> None:
        if robot.alive:
            robot.control(number, value)
    return Slider(its.name or f"actuator {number}", *_reach(robot, its), read, turn)


def _joint_slider(robot: Robot, number: int, its: ModelJoint) -> Slider:
    def read() -> float:
        return float(robot.positions[its.position]) if robot.alive else math.nan

    def turn(value: float) -> None:  # the others go on as they move
        if not robot.alive:
            return
        positions, velocities = robot.positions, robot.velocities
        positions[its.position], velocities[its.velocity] = value, 0.0
        robot.positions = positions
        robot.velocities = velocities
    return Slider(its.name or f"joint {number}", *_ends(its.low, its.high, math.pi if its.kind == "hinge" else 1.0), read, turn)


def rows_of(robot: Robot) -> list[Row]:
    """Titles and sliders."""
    model = robot.model
    actuators: list[Row] = [_actuator_slider(robot, i, its) for i, its in enumerate(model.actuators)]
    joints: list[Row] = [_joint_slider(robot, i, its) for i, its in enumerate(model.joints) if its.kind in ("hinge", "slide")]
    out: list[Row] = []
    for word, rows in (("controls", actuators), ("joints", joints)):
        if rows:
            out += [Title(f"{model.name or 'robot'}: {word}"), *rows]
    return out
