# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A walking robot of 12 joints that follows commanded velocities, on flat ground or on a landscape. The model is ours, of the size
and mass of the quadrupeds that laboratories have: 12.5 kg, legs of 0.42 m. Its joints are 0 where it stands; an action moves the target of
a servo by up to half a radian."""
from __future__ import annotations

import math

from ..robot import Model
from .task import Commands, Curriculum, HeightScan, Piece, Range, Start, Task, Term
from .terrain import Landscape

Bounds = tuple[float, float]
LEGS = {"front_left": (1, 1), "front_right": (1, -1), "rear_left": (-1, 1), "rear_right": (-1, -1)}
BEND, LENGTH, FOOT = 0.9, 0.21, 0.023  # rad, of a thigh where it stands; m; m
STAND = 2 * LENGTH * math.cos(BEND) + FOOT


def _leg(name: str, front: int, left: int) -> str:
    across, down = LENGTH * math.sin(BEND), LENGTH * math.cos(BEND)
    return f"""
<body name="{name}_hip" pos="{0.19 * front} {0.05 * left} 0"><joint name="{name}_hip" axis="1 0 0" range="-0.8 0.8"/>
<inertial pos="0 {0.03 * left} 0" mass="0.7" diaginertia="0.0005 0.0008 0.0006"/>
<body name="{name}_thigh" pos="0 {0.08 * left} 0"><joint name="{name}_thigh" axis="0 1 0" range="-1.5 2.4"/>
<inertial pos="{-0.2 * across} 0 {-0.2 * down}" mass="0.9" diaginertia="0.0055 0.0051 0.0013"/>
<geom type="capsule" fromto="0 0 0 {-across} 0 {-down}" size="0.02"/>
<body name="{name}_calf" pos="{-across} 0 {-down}"><joint name="{name}_calf" axis="0 1 0" range="-0.9 0.9"/>
<inertial pos="{0.5 * across} 0 {-0.5 * down}" mass="0.23" diaginertia="0.0021 0.0021 0.0001"/>
<geom type="capsule" fromto="0 0 0 {0.9 * across} 0 {-0.9 * down}" size="0.013"/>
<geom name="{name}_foot" type="sphere" pos="{across} 0 {-down}" size="{FOOT}"/></body></body></body>"""


def model_text(asset: str = "", ground: str = '<geom name="ground" type="plane" size="50 50 1"/>') -> str:
    """The robot's MJCF, on a ground."""
    kp, kd, reach = 30.0, 0.7, 0.5
    servos = "".join(f'<general joint="{leg}_{part}" gainprm="{kp * reach}" biastype="affine" biasprm="0 {-kp} {-kd}" forcerange="{-limit} {limit}"/>'
                     for leg in LEGS for part, limit in (("hip", 24), ("thigh", 24), ("calf", 36)))
    return f"""<mujoco model="quadruped"><compiler angle="radian" autolimits="true"/><option timestep="0.004"/>
<default><joint armature="0.01" damping="0.1"/><geom friction="0.8" contype="1" conaffinity="0"/><general ctrllimited="true" ctrlrange="-1 1"/></default>
<asset>{asset}</asset><worldbody>{ground.replace('<geom ', '<geom contype="0" conaffinity="1" ')}
<body name="trunk" pos="0 0 {STAND:.9g}"><freejoint/>
<inertial pos="0 0 0" mass="5.2" diaginertia="0.017 0.057 0.065"/><geom type="box" size="0.18 0.09 0.05"/>{"".join(_leg(leg, *side) for leg, side in LEGS.items())}
</body></worldbody><actuator>{servos}</actuator></mujoco>"""


LANDSCAPE = Landscape()


def rough_text() -> str:
    """The robot on LANDSCAPE."""
    return model_text(*LANDSCAPE.mjcf())


def quadruped(model: Model, *, frame_skip: int = 5, forward_range: Bounds = (-1.0, 1.0), sideways_range: Bounds = (-0.5, 0.5),
              turn_range: Bounds = (-1.0, 1.0), command_steps: int = 250, standing_share: float = 0.1, tracking_weight: float = 1.0,
              turning_weight: float = 0.5, tracking_width: float = 0.25, error_cost_weight: float = 0.5,
              healthy_reward: float = 0.1, vertical_cost_weight: float = 0.5, tilting_cost_weight: float = 0.01, level_cost_weight: float = 0.5,
              torque_cost_weight: float = 2e-5, action_rate_cost_weight: float = 0.002, healthy_upright: float = 0.5, reset_noise_scale: float = 0.05,
              height_scan: HeightScan | None = None, curriculum: Curriculum = Curriculum()) -> Task:
    """Goes at the speeds of its commands: forward, sideways, m/s, and turning, rad/s, in its own axes; they change every
    command_steps steps. Observed: those velocities, the direction of gravity in the trunk's axes, commands, joints, the last action, and
    the ground of a height_scan. Far from a command reward_tracking has no slope that a learner could follow: reward_error has."""
    if not isinstance(height_scan, HeightScan | None):
        raise TypeError(f"height_scan {height_scan!r}: an epode.vector.HeightScan is expected")
    trunk, joints = model.link_names.index("trunk"), model.velocity_count - 6
    forward = Piece("qvel", 0, 2, axes_of=trunk, command=0)
    down = Piece("direction", 0, 3, link=trunk, point=(0.0, 0.0, -1.0))
    upright = Piece("direction", 2, 1, link=trunk, point=(0.0, 0.0, 1.0))
    tilt = Piece("direction", 0, 2, link=trunk, point=(0.0, 0.0, -1.0))
    level = reset_noise_scale
    scan = [height_scan.piece(trunk, STAND)] if height_scan else []
    rough = [Term("row", "sum", Piece("row"), is_reward=False, at_reset=True)] if curriculum.rows else []
    return Task(
        [Piece("qvel", 0, 3, axes_of=trunk), Piece("qvel", 3, 3), down, Piece("command", 0, 3), Piece("qpos", 7, joints),
         Piece("qvel", 6, joints, scale=0.1), Piece("action", 0, joints), *scan],
        [Term("reward_tracking", "gaussian", forward, weight=tracking_weight, width=tracking_width),
         Term("reward_turning", "gaussian", Piece("qvel", 5, 1, command=2), weight=turning_weight, width=tracking_width),
         Term("reward_error", "length", forward, weight=-error_cost_weight),
         Term("reward_survive", "healthy", weight=healthy_reward),
         Term("reward_vertical", "squares", Piece("qvel", 2, 1), weight=-vertical_cost_weight),
         Term("reward_tilting", "squares", Piece("qvel", 3, 2), weight=-tilting_cost_weight),
         Term("reward_level", "squares", tilt, weight=-level_cost_weight),
         Term("reward_torque", "squares", Piece("qfrc_actuator", 6, joints), weight=-torque_cost_weight),
         Term("reward_action_rate", "squares", Piece("action_change", 0, joints), weight=-action_rate_cost_weight),
         Term("tracking_error", "length", forward, is_reward=False), *rough],
        [Start("qpos", [-level] * joints, [level] * joints, 7),
         Start("qvel", [-level] * (joints + 6), [level] * (joints + 6))],
        frame_skip, [Range(upright, low=healthy_upright), Range(Piece("qpos", 2), low=-10.0)],
        commands=Commands([forward_range[0], sideways_range[0], turn_range[0]], [forward_range[1], sideways_range[1], turn_range[1]],
                          command_steps, standing_share),
        curriculum=curriculum)


def rough_quadruped(model: Model, *, forward_range: Bounds = (0.3, 1.0), sideways_range: Bounds = (-0.2, 0.2), turn_range: Bounds = (-0.3, 0.3),
                    level_cost_weight: float = 0.1, vertical_cost_weight: float = 0.5, command_steps: int = 0, standing_share: float = 0.0,
                    **arguments: object) -> Task:
    """The same on a landscape, whose rows get harder: a copy that leads far enough begins its next episode on the next row."""
    curriculum = Curriculum(LANDSCAPE.rows, len(LANDSCAPE.kinds), 2, LANDSCAPE.spacing, up=LANDSCAPE.spacing / 2, down=LANDSCAPE.spacing / 4)
    return quadruped(model, forward_range=forward_range, sideways_range=sideways_range, turn_range=turn_range, level_cost_weight=level_cost_weight,
                     vertical_cost_weight=vertical_cost_weight, command_steps=command_steps, standing_share=standing_share, curriculum=curriculum,
                     **arguments)  # type: ignore[arg-type]
