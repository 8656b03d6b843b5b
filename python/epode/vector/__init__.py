# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Vectors of environments for learning, on a batch: Gymnasium's MuJoCo tasks under our names.

>>> import epode, numpy
>>> env = epode.vector.make("CartPole", 64)
>>> observations, infos = env.reset(seed=7)
>>> observations, rewards, terminated, truncated, infos = env.step(env.action_space.sample())
>>> observations.shape, float(rewards.sum())
((64, 4), 64.0)

An environment of your own is a ``Task`` with pieces of observation, terms of reward and healthy ranges, as data.
"""
try:
    import gymnasium as _gymnasium  # noqa: F401
except ImportError:
    raise ImportError("epode.vector needs gymnasium: pip install epode[gym]") from None

from .._gymnasium import register
from .environment import Scalar, VectorEnvironment, make
from .task import Piece, Range, Start, Task, Term

__all__ = ["Piece", "Range", "Scalar", "Start", "Task", "Term", "VectorEnvironment", "make"]
register()
