# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Poses as arrays, position then quaternion, and names that are numbers too."""
from __future__ import annotations

import difflib

import numpy as np
from numpy.typing import ArrayLike

from ._handle import FloatArray


def _unknown(name: str, names: list[str], what: str) -> str:
    """The text of an error about a name that is none: what is meant, or what there is."""
    near = difflib.get_close_matches(name, names, 1)
    if near:
        return f"no {what} is called {name!r}; did you mean {near[0]!r}?"
    shown = ", ".join(name for name in names[:20] if name) + (", ..." if len(names) > 20 else "")
    return f"no {what} is called {name!r}" + (f": {shown}" if shown else "; there is none")


def _number(name: str | int, names: list[str], what: str) -> int:
    if isinstance(name, str):
        if name not in names:
            raise KeyError(_unknown(name, names, what))
        return names.index(name)
    if not 0 <= int(name) < len(names):
        raise IndexError(f"{what} {name}: there are {len(names)}")
    return int(name)


def _vector(value: ArrayLike, size: int, what: str) -> FloatArray:
    """So many finite numbers, or a ValueError that names them."""
    array = np.asarray(value, float)
    if array.shape != (size,) or not np.isfinite(array).all():
        raise ValueError(f"{what}: {size} finite numbers are expected, not {value!r}")
    return array


def _quaternion(value: ArrayLike) -> FloatArray:
    """Four finite numbers, not all 0."""
    array = _vector(value, 4, "quaternion")
    if not array.any():
        raise ValueError("quaternion: 4 numbers that are not all 0 are expected")
    return array


def _turned(quaternion: FloatArray) -> FloatArray:
    """The 3 x 3 matrix of a quaternion."""
    w, x, y, z = quaternion
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def _product(a: FloatArray, b: FloatArray) -> FloatArray:
    """Of two quaternions. In plain numbers: numpy's own products of vectors of three take ten times as long."""
    (w, x, y, z), (s, i, j, k) = a.tolist(), b.tolist()
    return np.array([w * s - (x * i + y * j + z * k), w * i + s * x + (y * k - z * j), w * j + s * y + (z * i - x * k),
                     w * k + s * z + (x * j - y * i)])


def _moved(pose: FloatArray, point: ArrayLike) -> FloatArray:
    """Where a point of a frame is whose pose, position and quaternion, is given."""
    px, py, pz, w, x, y, z = pose.tolist()
    a, b, c = np.asarray(point, float).tolist()
    i, j, k = 2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)
    return np.array([a + w * i + (y * k - z * j) + px, b + w * j + (z * i - x * k) + py, c + w * k + (x * j - y * i) + pz])
