# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What a run leaves: numbers of the scene, and of a world or a batch that it returns the hash of its state and the figures of its last
step's report. Hashes are of bits: rows of one run agree on all machines, or something is wrong."""
from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping
from numbers import Real
from typing import Any

import numpy as np

from ..batch import Batch
from ..world import World
from .plan import RESERVED

_FIGURES = ("residual", "joint_error", "penetration", "contained_islands")


def row_of(scene: Callable[[dict[str, Any], int], Mapping[str, Any]], parameters: dict[str, Any], seed: int) -> dict[str, Any]:
    """Runs the scene. Returns its numbers as doubles, with ``state_hash`` (of the results if it returns no world)."""
    returned = scene(dict(parameters), seed)
    if not isinstance(returned, Mapping):
        raise TypeError(f"the scene returned {type(returned).__name__}: a dict of numbers is expected")
    results: dict[str, float] = {}
    state = hashlib.sha256()
    for name, value in returned.items():
        if not isinstance(name, str) or name in RESERVED or name in parameters:
            raise ValueError(f"the scene returned {name!r}, which is a parameter or a column that every table has")
        if isinstance(value, (World, Batch)):
            for array in _state(value):
                state.update(np.ascontiguousarray(array).tobytes())
            results |= _figures(name, value)
        else:
            results[name] = _number(name, value)
    state.update(np.array(list(results.values())).tobytes())
    return {**results, "state_hash": state.hexdigest()[:16]}


def _number(name: str, value: Any) -> float:
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    if not isinstance(value, (Real, np.bool_)):
        raise TypeError(f"the scene returned {name}={value!r:.60}: a number, a world or a batch is expected")
    return float(value)


def _state(of: World | Batch) -> list[Any]:
    if isinstance(of, Batch):
        return [of.read("qpos"), of.read("qvel")]
    bodies = of.bodies
    return [bodies.position, bodies.quaternion, bodies.velocity, bodies.angular_velocity]


def _figures(name: str, of: World | Batch) -> dict[str, float]:
    if isinstance(of, Batch):
        return {f"{name}_residual": float(of.read("residual").max()), f"{name}_bad": float(of.bad)}
    report = of.report()
    return {} if report is None else {f"{name}_{figure}": float(getattr(report, figure)) for figure in _FIGURES}
