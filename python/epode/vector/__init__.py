# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Vectors of environments for learning, on a batch: Gymnasium's MuJoCo tasks under our names, ``Epode/Ant-v0`` and so on in its
registry from this module's import on.

>>> import epode, numpy
>>> env = epode.vector.make("CartPole", 64)
>>> observations, infos = env.reset(seed=7)
>>> observations, rewards, terminated, truncated, infos = env.step(env.action_space.sample())
>>> observations.shape, float(rewards.sum())
((64, 4), 64.0)

An environment of your own is a ``Task`` with pieces of observation, terms of reward and healthy ranges, as data.
"""
try:
    import gymnasium as _gymnasium
except ImportError:
    raise ImportError("epode.vector needs gymnasium: pip install epode[gym]") from None

from .environment import Scalar, VectorEnvironment, make
from .task import Commands, Curriculum, HeightScan, Piece, Range, Start, Task, Term
from .tasks import TASKS as _TASKS

__all__ = ["Commands", "Curriculum", "HeightScan", "Piece", "Range", "Scalar", "Start", "Task", "Term", "VectorEnvironment", "make"]

for _name, _described in _TASKS.items():
    if f"Epode/{_name}-v0" not in _gymnasium.registry:
        _gymnasium.register(f"Epode/{_name}-v0", entry_point="epode.vector:Scalar", vector_entry_point="epode.vector:make",
                            max_episode_steps=_described[2], kwargs={"task": _name})
