# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Poses as arrays, position then quaternion, and names that are numbers too."""
from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ._handle import FloatArray


def _number(name: str | int, names: list[str], what: str) -> int:
    if isinstance(name, str):
        if name not in names:
            raise KeyError(f"no {what} is called {name!r}: {', '.join(names)}")
        return names.index(name)
    return int(name)


def _product(a: FloatArray, b: FloatArray) -> FloatArray:
    """Of two quaternions."""
    w, v, x, u = a[0], a[1:], b[0], b[1:]
    return np.concatenate([[w * x - v @ u], w * u + x * v + np.cross(v, u)])


def _moved(pose: FloatArray, point: ArrayLike) -> FloatArray:
    """Where a point of a frame is whose pose, position and quaternion, is given."""
    v, p = pose[4:7], np.asarray(point, float)
    t = 2 * np.cross(v, p)
    return np.asarray(p + pose[3] * t + np.cross(v, t) + pose[:3], float)
