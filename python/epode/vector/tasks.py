# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Gymnasium's tasks (version 5 of its MuJoCo environments), with its names of arguments: formulas of observations, rewards and ends;
and the list of all. A task is a function of the model; models are files of the user's gymnasium package, or texts of ours."""
from __future__ import annotations

import math
from collections.abc import Callable

from ..robot import Model
from . import lift, quadruped
from .task import Piece, Range, Start, Task, Term

Bounds = tuple[float, float]

CART_POLE = """<mujoco model="cartpole"><option gravity="0 0 -9.8" timestep="0.02"/><worldbody>
<body name="cart"><joint name="rail" type="slide" axis="1 0 0"/><inertial pos="0 0 0" mass="1" diaginertia="0.01 0.01 0.01"/>
<body name="pole"><joint name="hinge" axis="0 1 0"/><inertial pos="0 0 0.5" mass="0.1" diaginertia="0.00833333333333333 0.00833333333333333 0.00001"/>
</body></body></worldbody><actuator><motor joint="rail"/></actuator></mujoco>"""


def _state(skipped: int, model: Model, speed: float = math.inf) -> list[Piece]:
    nq, nv = _sizes(model)
    return [Piece("qpos", skipped, nq - skipped), Piece("qvel", 0, nv, low=-speed, high=speed)]


def _sizes(model: Model) -> tuple[int, int]:
    return model.position_count, model.velocity_count


def _noise(model: Model, scale: float, normal: bool = False) -> list[Start]:
    nq, nv = _sizes(model)
    velocities = Start("qvel", [0.0] * nv, [scale] * nv, distribution="normal") if normal else Start("qvel", [-scale] * nv, [scale] * nv)
    return [Start("qpos", [-scale] * nq, [scale] * nq), velocities]


def _info(name: str, piece: Piece, kind: str = "sum", at_reset: bool = True) -> Term:
    return Term(name, kind, piece, is_reward=False, at_reset=at_reset)  # type: ignore[arg-type]


def _place(*, y: bool = False, rate: Piece = Piece("qpos")) -> list[Term]:
    """Where the robot is and how fast it went."""
    terms = [_info("x_position", Piece("qpos")), _info("x_velocity", rate, kind="rate", at_reset=False)]
    if y:
        across = Piece(rate.quantity, rate.first + 1)
        terms += [_info("y_position", Piece("qpos", 1)), _info("distance_from_origin", Piece("qpos", 0, 2), kind="length"),
                  _info("y_velocity", across, kind="rate", at_reset=False)]
    return terms


def _height(model: Model) -> Term:
    return _info("z_distance_from_origin", Piece("qpos", 1, offset=float(model.reference[1])))


def _effort(model: Model, weight: float) -> Term:
    return Term("reward_ctrl", "squares", Piece("action", 0, len(model.actuators)), weight=-weight)


def ant(model: Model, *, frame_skip: int = 5, forward_reward_weight: float = 1.0, ctrl_cost_weight: float = 0.5,
        contact_cost_weight: float = 5e-4, healthy_reward: float = 1.0, terminate_when_unhealthy: bool = True,
        healthy_z_range: Bounds = (0.2, 1.0), contact_force_range: Bounds = (-1.0, 1.0), reset_noise_scale: float = 0.1,
        exclude_current_positions_from_observation: bool = True, include_cfrc_ext_in_observation: bool = True) -> Task:
    """Runs as fast as it can, on four legs."""
    low, high = contact_force_range
    touch = Piece("cfrc_ext", 6, 6 * len(model.links) - 6, low=low, high=high)
    return Task([*_state(2 * exclude_current_positions_from_observation, model), *([touch] if include_cfrc_ext_in_observation else [])],
                [Term("reward_forward", "rate", Piece("qpos"), weight=forward_reward_weight), Term("reward_survive", "healthy", weight=healthy_reward),
                 _effort(model, ctrl_cost_weight), Term("reward_contact", "squares", touch, weight=-contact_cost_weight),
                 *_place(y=True)],
                _noise(model, reset_noise_scale, normal=True), frame_skip, [Range(Piece("qpos", 2), *healthy_z_range)],
                terminate_when_unhealthy)


def half_cheetah(model: Model, *, frame_skip: int = 5, forward_reward_weight: float = 1.0, ctrl_cost_weight: float = 0.1,
                 reset_noise_scale: float = 0.1, exclude_current_positions_from_observation: bool = True) -> Task:
    """Runs in a plane, on two legs; it may fall."""
    return Task(_state(1 * exclude_current_positions_from_observation, model),
                [Term("reward_forward", "rate", Piece("qpos"), weight=forward_reward_weight), _effort(model, ctrl_cost_weight), *_place()],
                _noise(model, reset_noise_scale, normal=True), frame_skip)


def humanoid(model: Model, *, frame_skip: int = 5, forward_reward_weight: float = 1.25, ctrl_cost_weight: float = 0.1,
             contact_cost_weight: float = 5e-7, contact_cost_range: Bounds = (-math.inf, 10.0), healthy_reward: float = 5.0,
             terminate_when_unhealthy: bool = True, healthy_z_range: Bounds = (1.0, 2.0), reset_noise_scale: float = 1e-2,
             exclude_current_positions_from_observation: bool = True, include_cinert_in_observation: bool = True,
             include_cvel_in_observation: bool = True, include_qfrc_actuator_in_observation: bool = True,
             include_cfrc_ext_in_observation: bool = True) -> Task:
    """Runs upright."""
    moving, (_, nv) = len(model.links) - 1, _sizes(model)
    touch = Piece("cfrc_ext", 6, 6 * moving)
    more = [(include_cinert_in_observation, Piece("cinert", 10, 10 * moving)), (include_cvel_in_observation, Piece("cvel", 6, 6 * moving)),
            (include_qfrc_actuator_in_observation, Piece("qfrc_actuator", 6, nv - 6)), (include_cfrc_ext_in_observation, touch)]
    cheapest, dearest = contact_cost_range
    return Task([*_state(2 * exclude_current_positions_from_observation, model), *(piece for wanted, piece in more if wanted)],
                [Term("reward_survive", "healthy", weight=healthy_reward), Term("reward_forward", "rate", Piece("com"), weight=forward_reward_weight),
                 _effort(model, ctrl_cost_weight), Term("reward_contact", "squares", touch, weight=-contact_cost_weight, low=-dearest, high=-cheapest),
                 *_place(y=True, rate=Piece("com"))],
                _noise(model, reset_noise_scale), frame_skip, [Range(Piece("qpos", 2), *healthy_z_range, is_open=True)],
                terminate_when_unhealthy)


def _planar_walker(model: Model, healthy: list[Range], frame_skip: int, forward: float, effort: float, survival: float, terminates: bool,
                   noise: float, skipped: bool) -> Task:
    return Task(_state(1 * skipped, model, 10.0),
                [Term("reward_forward", "rate", Piece("qpos"), weight=forward), Term("reward_survive", "healthy", weight=survival),
                 _effort(model, effort), *_place(), _height(model)],
                _noise(model, noise), frame_skip, healthy, terminates)


def hopper(model: Model, *, frame_skip: int = 4, forward_reward_weight: float = 1.0, ctrl_cost_weight: float = 1e-3, healthy_reward: float = 1.0,
           terminate_when_unhealthy: bool = True, healthy_state_range: Bounds = (-100.0, 100.0), healthy_z_range: Bounds = (0.7, math.inf),
           healthy_angle_range: Bounds = (-0.2, 0.2), reset_noise_scale: float = 5e-3,
           exclude_current_positions_from_observation: bool = True) -> Task:
    """Hops in a plane, on one leg."""
    nq, nv = _sizes(model)
    healthy = [Range(Piece("qpos", 2, nq - 2), *healthy_state_range, is_open=True), Range(Piece("qvel", 0, nv), *healthy_state_range, is_open=True),
               Range(Piece("qpos", 1), *healthy_z_range, is_open=True), Range(Piece("qpos", 2), *healthy_angle_range, is_open=True)]
    return _planar_walker(model, healthy, frame_skip, forward_reward_weight, ctrl_cost_weight, healthy_reward, terminate_when_unhealthy,
                          reset_noise_scale, exclude_current_positions_from_observation)


def walker2d(model: Model, *, frame_skip: int = 4, forward_reward_weight: float = 1.0, ctrl_cost_weight: float = 1e-3, healthy_reward: float = 1.0,
             terminate_when_unhealthy: bool = True, healthy_z_range: Bounds = (0.8, 2.0), healthy_angle_range: Bounds = (-1.0, 1.0),
             reset_noise_scale: float = 5e-3, exclude_current_positions_from_observation: bool = True) -> Task:
    """Walks in a plane, on two legs."""
    healthy = [Range(Piece("qpos", 1), *healthy_z_range, is_open=True), Range(Piece("qpos", 2), *healthy_angle_range, is_open=True)]
    return _planar_walker(model, healthy, frame_skip, forward_reward_weight, ctrl_cost_weight, healthy_reward, terminate_when_unhealthy,
                          reset_noise_scale, exclude_current_positions_from_observation)


def swimmer(model: Model, *, frame_skip: int = 4, forward_reward_weight: float = 1.0, ctrl_cost_weight: float = 1e-4,
            reset_noise_scale: float = 0.1, exclude_current_positions_from_observation: bool = True) -> Task:
    """Swims."""
    return Task(_state(2 * exclude_current_positions_from_observation, model),
                [Term("reward_forward", "rate", Piece("qpos"), weight=forward_reward_weight), _effort(model, ctrl_cost_weight),
                 *_place(y=True)], _noise(model, reset_noise_scale), frame_skip)


def _link(model: Model, name: str) -> int:
    if name not in model.link_names:
        raise ValueError(f"the model has no link {name!r}, which this task needs")
    return model.link_names.index(name)


def _apart(model: Model, one: str, other: str, count: int = 3) -> Piece:
    return Piece("xpos", 3 * _link(model, one), count, minus=3 * _link(model, other))


def reacher(model: Model, *, frame_skip: int = 2, reward_dist_weight: float = 1.0, reward_control_weight: float = 1.0) -> Task:
    """Reaches a point in a plane with an arm of two links."""
    nq, nv = _sizes(model)
    return Task([Piece("qpos", 0, 2, "cos"), Piece("qpos", 0, 2, "sin"), Piece("qpos", 2, nq - 2), Piece("qvel", 0, 2),
                 _apart(model, "fingertip", "target", 2)],
                [Term("reward_dist", "length", _apart(model, "fingertip", "target"), weight=-reward_dist_weight), _effort(model, reward_control_weight)],
                [Start("qpos", [-0.1] * nq, [0.1] * nq), Start("qpos", [-0.2] * 2, [0.2] * 2, nq - 2, is_relative=False, length=(-1.0, 0.2)),
                 Start("qvel", [-0.005] * (nv - 2), [0.005] * (nv - 2))], frame_skip)


def pusher(model: Model, *, frame_skip: int = 5, reward_near_weight: float = 0.5, reward_dist_weight: float = 1.0,
           reward_control_weight: float = 0.1) -> Task:
    """Pushes a cylinder to its goal with an arm of seven joints."""
    places = [Piece("xpos", 3 * _link(model, name), 3) for name in ("tips_arm", "object", "goal")]
    nq, nv = _sizes(model)
    return Task([Piece("qpos", 0, 7), Piece("qvel", 0, 7), *places],
                [Term("reward_dist", "length", _apart(model, "object", "goal"), weight=-reward_dist_weight), _effort(model, reward_control_weight),
                 Term("reward_near", "length", _apart(model, "object", "tips_arm"), weight=-reward_near_weight)],
                [Start("qpos", [-0.3, -0.2], [0.0, 0.2], nq - 4, is_relative=False, length=(0.17, math.inf)),
                 Start("qpos", [0.0, 0.0], [0.0, 0.0], nq - 2, is_relative=False),
                 Start("qvel", [-0.005] * (nv - 4), [0.005] * (nv - 4))], frame_skip)


def inverted_pendulum(model: Model, *, frame_skip: int = 2, reset_noise_scale: float = 0.01) -> Task:
    """Keeps a pole upright on a cart."""
    return Task(_state(0, model), [Term("reward_survive", "healthy")], _noise(model, reset_noise_scale), frame_skip,
                [Range(Piece("qpos", 1), -0.2, 0.2)])


def inverted_double_pendulum(model: Model, *, frame_skip: int = 5, healthy_reward: float = 10.0, reset_noise_scale: float = 0.1) -> Task:
    """Keeps two poles upright on a cart."""
    pole = _link(model, "pole2")
    tip = [Piece("point", axis, link=pole, point=(0.0, 0.0, 0.6)) for axis in range(3)]
    away = Piece("point", 2, link=pole, point=(0.0, 0.0, 0.6), offset=2.0)
    return Task([Piece("qpos"), Piece("qpos", 1, 2, "sin"), Piece("qpos", 1, 2, "cos"), Piece("qvel", 0, 3, low=-10, high=10),
                 Piece("qfrc_constraint", 0, 1, low=-10, high=10)],
                [Term("reward_survive", "healthy", weight=healthy_reward), Term("distance_penalty", "squares", tip[0], weight=-0.01),
                 Term("distance_penalty", "squares", away, weight=-1.0), Term("velocity_penalty", "squares", Piece("qvel", 1), weight=-1e-3),
                 Term("velocity_penalty", "squares", Piece("qvel", 2), weight=-5e-3)],
                _noise(model, reset_noise_scale, normal=True), frame_skip, [Range(tip[2], 1.0, is_open=True)])


def cart_pole(model: Model, *, frame_skip: int = 1, sutton_barto_reward: bool = False) -> Task:
    """Keeps a pole upright on a cart that is pushed to the left (0) or to the right (1) with 10 N."""
    del model
    x, angle = 2.4, 12 * 2 * math.pi / 360
    terms = [Term("reward", "healthy"), Term("reward", "constant", weight=-1.0)] if sutton_barto_reward else [Term("reward", "constant")]
    return Task([Piece("qpos", 0), Piece("qvel", 0), Piece("qpos", 1), Piece("qvel", 1)], terms,
                [Start("qpos", [-0.05] * 2, [0.05] * 2), Start("qvel", [-0.05] * 2, [0.05] * 2)], frame_skip,
                [Range(Piece("qpos", 0), -x, x), Range(Piece("qpos", 1), -angle, angle)], choices=[[-10.0], [10.0]],
                high=[2 * x, math.inf, 2 * angle, math.inf])


# Of each environment the task, the model (a file of gymnasium's, a text, or what makes one) and how many steps an episode has.
TASKS: dict[str, tuple[Callable[..., Task], str | Callable[[], str], int]] = {
    "Ant": (ant, "ant.xml", 1000), "HalfCheetah": (half_cheetah, "half_cheetah.xml", 1000), "Humanoid": (humanoid, "humanoid.xml", 1000),
    "Hopper": (hopper, "hopper.xml", 1000), "Walker2d": (walker2d, "walker2d_v5.xml", 1000), "Swimmer": (swimmer, "swimmer.xml", 1000),
    "Reacher": (reacher, "reacher.xml", 50), "Pusher": (pusher, "pusher_v5.xml", 100),
    "InvertedPendulum": (inverted_pendulum, "inverted_pendulum.xml", 1000),
    "InvertedDoublePendulum": (inverted_double_pendulum, "inverted_double_pendulum.xml", 1000), "CartPole": (cart_pole, CART_POLE, 500),
    "Quadruped": (quadruped.quadruped, quadruped.model_text, 1000), "RoughQuadruped": (quadruped.rough_quadruped, quadruped.rough_text, 1000),
    "Lift": (lift.lift, lift.model_text, 250)}
