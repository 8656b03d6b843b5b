# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""An arm of five joints with a gripper of two fingers, which lifts a cube from a table to where it is asked to. The model is ours: an arm
of 0.6 m on a post of 0.35 m, a cube of 4 cm and 0.1 kg. Its joints are 0 where it waits with the gripper down above the table; an action
moves the targets of its servos by up to 1.2 rad, and the fingers' from closed to 4 cm from their middle."""
from __future__ import annotations

import math

from ..robot import Model
from .task import Commands, Piece, Range, Start, Task, Term

Bounds = tuple[float, float]
POST, UPPER, FORE, HAND = 0.35, 0.3, 0.3, 0.14  # m; HAND: from the wrist to between the fingertips
WAITS = (0.5, 1.7, math.pi - 2.2)               # rad, of shoulder, elbow and wrist: where joints are 0
CUBE = 0.02                                     # m, half its side
REACH, OPEN = 1.2, 0.04                         # rad and m, of an action of 1


def joints_for(x: float, y: float, z: float) -> list[float]:
    """Where the arm's five joints are when the fingertips' middle is there, the gripper down and its fingers to the left and right."""
    far, up = math.hypot(x, y), z + HAND - POST
    cosine = (far * far + up * up - UPPER * UPPER - FORE * FORE) / (2 * UPPER * FORE)
    if not -1 < cosine < 1:
        raise ValueError(f"({x}, {y}, {z}) is out of the arm's reach")
    elbow = math.acos(cosine)
    shoulder = math.atan2(far, up) - math.atan2(FORE * math.sin(elbow), UPPER + FORE * math.cos(elbow))
    bends = (shoulder, elbow, math.pi - shoulder - elbow)
    return [math.atan2(y, x), *(bend - home for bend, home in zip(bends, WAITS, strict=True)), 0.0]


def _finger(name: str, side: int) -> str:
    return f"""<body name="{name}" pos="0 0 {HAND}"><joint name="{name}" type="slide" axis="0 {side} 0" range="0 {OPEN}" damping="2" armature="0.1"/>
<inertial pos="0 {0.004 * side} -0.02" mass="0.05" diaginertia="2e-5 2e-5 4e-6"/>
<geom name="{name}" type="box" pos="0 {0.004 * side} -0.01" size="0.012 0.004 0.025" contype="1" friction="1"/></body>"""


def model_text() -> str:
    """Its MJCF."""
    turn = "".join(f'<general joint="{name}" gainprm="{kp * REACH}" biastype="affine" biasprm="0 {-kp} {-kd}" forcerange="{-limit} {limit}"/>'
                   for name, kp, kd, limit in (("yaw", 200, 20, 60), ("shoulder", 400, 40, 100), ("elbow", 300, 30, 80),
                                              ("wrist", 100, 5, 20), ("roll", 40, 2, 10)))
    grip = "".join(f'<general joint="{name}" gainprm="{1000 * OPEN / 2}" biastype="affine" biasprm="{1000 * OPEN / 2} -1000 -20" forcerange="-15 15"/>'
                   for name in ("left", "right"))
    return f"""<mujoco model="lift"><compiler angle="radian" autolimits="true"/><option timestep="0.004"/>
<default><joint armature="0.05" damping="0.2"/><geom contype="2" conaffinity="0" friction="0.8"/><general ctrllimited="true" ctrlrange="-1 1"/></default>
<worldbody><geom name="table" type="plane" size="2 2 1" contype="0" conaffinity="1"/><geom type="cylinder" fromto="0 0 0 0 0 {POST - 0.05}" size="0.05"/>
<body name="base" pos="0 0 {POST}"><joint name="yaw" axis="0 0 1" range="-1.5 1.5"/><geom type="sphere" size="0.06" mass="1"/>
<body name="upper" euler="0 {WAITS[0]} 0"><joint name="shoulder" axis="0 1 0" range="-1.5 1.5"/><geom type="capsule" fromto="0 0 0 0 0 {UPPER}" size="0.035" mass="1.5"/>
<body name="fore" pos="0 0 {UPPER}" euler="0 {WAITS[1]} 0"><joint name="elbow" axis="0 1 0" range="-1.5 1.2"/><geom type="capsule" fromto="0 0 0 0 0 {FORE}" size="0.03" mass="1"/>
<body name="wrist" pos="0 0 {FORE}" euler="0 {WAITS[2]} 0"><joint name="wrist" axis="0 1 0" range="-1.5 1.5"/><geom type="sphere" size="0.03" mass="0.3"/>
<body name="hand"><joint name="roll" axis="0 0 1" range="-1.5 1.5"/><geom type="box" pos="0 0 0.08" size="0.02 0.05 0.015" mass="0.3"/>
{_finger("left", 1)}{_finger("right", -1)}<body name="grip" pos="0 0 {HAND}"/></body></body></body></body></body>
<body name="cube" pos="0.4 0 {CUBE}"><freejoint/><geom name="cube" type="box" size="{CUBE} {CUBE} {CUBE}" mass="0.1" contype="1" conaffinity="1" friction="1"/></body>
</worldbody><actuator>{turn}{grip}</actuator></mujoco>"""


def lift(model: Model, *, frame_skip: int = 5, goal_low: tuple[float, float, float] = (0.3, -0.15, 0.15),
         goal_high: tuple[float, float, float] = (0.5, 0.15, 0.35), cube_x_range: Bounds = (0.32, 0.48), cube_y_range: Bounds = (-0.12, 0.12),
         reach_weight: float = 0.5, lift_weight: float = 1.0, goal_weight: float = 4.0, width: float = 0.02, ctrl_cost_weight: float = 1e-3,
         action_rate_cost_weight: float = 1e-2, reset_noise_scale: float = 0.02) -> Task:
    """Lifts the cube to the goal, which the commands are, in the world. Observed: joints, the gripper's place, the cube's pose and
    velocity, the cube from the gripper, the goal, the goal from the cube, the last action."""
    grip, cube = (3 * model.link_names.index(name) for name in ("grip", "cube"))
    nq, nv, joints = model.position_count, model.velocity_count, model.velocity_count - 6
    apart, away = Piece("xpos", cube, 3, minus=grip), Piece("qpos", nq - 7, 3, command=0)
    x, y = (((high + low) / 2, (high - low) / 2) for low, high in (cube_x_range, cube_y_range))
    noise = reset_noise_scale
    return Task(
        [Piece("qpos", 0, joints), Piece("qvel", 0, joints, scale=0.1), Piece("xpos", grip, 3), Piece("qpos", nq - 7, 7),
         Piece("qvel", nv - 6, 6, scale=0.1), apart, Piece("command", 0, 3), away, Piece("action", 0, joints)],
        [Term("reward_reach", "gaussian", apart, weight=reach_weight, width=width),
         Term("reward_lift", "sum", Piece("qpos", nq - 5, offset=CUBE, scale=10.0, low=0.0, high=1.0), weight=lift_weight),
         Term("reward_goal", "gaussian", away, weight=goal_weight, width=width),
         Term("reward_ctrl", "squares", Piece("action", 0, joints), weight=-ctrl_cost_weight),
         Term("reward_action_rate", "squares", Piece("action_change", 0, joints), weight=-action_rate_cost_weight),
         Term("goal_distance", "length", away, is_reward=False, at_reset=True)],
        [Start("qpos", [-noise] * 5, [noise] * 5), Start("qpos", [OPEN, OPEN], [OPEN, OPEN], 5, is_relative=False),
         Start("qpos", [x[0] - x[1], y[0] - y[1]], [x[0] + x[1], y[0] + y[1]], nq - 7, is_relative=False)],
        frame_skip, [Range(Piece("qpos", nq - 5), low=-0.1)], commands=Commands(goal_low, goal_high))
