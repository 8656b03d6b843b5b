# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Sweeps: one scene over many parameters and seeds, on one machine or on a cluster of Ray's, its rows in Parquet files.

>>> import epode
>>> def drop(parameters, seed):
...     world = epode.World()
...     world.plane()
...     ball = world.body(mass=parameters["mass"], position=(0, 0, 1), shape=epode.Sphere(0.1))
...     world.step(0.01, steps=100)
...     return {"height": ball.position[2], "world": world}
>>> plan = epode.sweep.grid(mass=epode.sweep.log(1, 10, 3), seed=range(2))
>>> len(plan), plan[3]
(6, ({'mass': 3.1622776601683795}, 1))
>>> table = epode.sweep.run(drop, plan, out="runs/drop", executor="threads")  # doctest: +SKIP

Needs ``pip install epode[sweep]``: pyarrow for the files, cloudpickle for scenes, Ray where its executor is asked for.
"""
from .plan import Axis, Distribution, Plan, distribution, grid, linear, log
from .sweep import Status, SweepError, read, run, status

__all__ = ["Axis", "Distribution", "Plan", "Status", "SweepError", "distribution", "grid", "linear", "log", "read", "run", "status"]
