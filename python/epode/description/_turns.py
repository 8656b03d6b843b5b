# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Quaternions (w x y z) of what else MJCF may say a turn with, and of mirrored frames: q mirrored by a plane with the unit normal n
is that of S R S, S = 1 - 2 n n^T."""
from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from .._handle import FloatArray
from .._poses import _product


def turn(axis: ArrayLike, angle: float) -> FloatArray:
    """About an axis."""
    a = np.asarray(axis, float)
    return np.concatenate([[np.cos(angle / 2)], np.sin(angle / 2) * a / np.linalg.norm(a)])


def turn_of_z(direction: ArrayLike) -> FloatArray:
    """The least turn that brings z to a direction."""
    d = np.asarray(direction, float) / np.linalg.norm(direction)
    axis = np.array([-d[1], d[0], 0])
    length = float(np.linalg.norm(axis))
    return turn(axis if length > 1e-12 else (1, 0, 0), float(np.arctan2(length, d[2])))


def matrix_of(q: ArrayLike) -> FloatArray:
    """The rotation of a quaternion."""
    w, x, y, z = np.asarray(q, float) / np.linalg.norm(q)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def turn_of_matrix(m: FloatArray) -> FloatArray:
    """The quaternion of a rotation: the largest of four columns of 4 q q^T."""
    trace = m[0, 0] + m[1, 1] + m[2, 2]
    columns = np.array([
        [1 + trace, m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]],
        [m[2, 1] - m[1, 2], 1 + 2 * m[0, 0] - trace, m[0, 1] + m[1, 0], m[0, 2] + m[2, 0]],
        [m[0, 2] - m[2, 0], m[0, 1] + m[1, 0], 1 + 2 * m[1, 1] - trace, m[1, 2] + m[2, 1]],
        [m[1, 0] - m[0, 1], m[0, 2] + m[2, 0], m[1, 2] + m[2, 1], 1 + 2 * m[2, 2] - trace]])
    column = columns[int(np.argmax(np.diagonal(columns)))]
    q: FloatArray = column / np.linalg.norm(column)
    return q if q[0] >= 0 else -q


def turn_of_axes(x: ArrayLike, y: ArrayLike) -> FloatArray:
    """Of a frame whose x axis is the first, whose y axis is the second as far as it stands upright to it."""
    a = np.asarray(x, float) / np.linalg.norm(x)
    b = np.asarray(y, float) - a * (a @ np.asarray(y, float))
    b /= np.linalg.norm(b)
    return turn_of_matrix(np.stack([a, b, np.cross(a, b)], axis=1))


def turn_of_euler(angles: ArrayLike) -> FloatArray:
    """About x, then the turned y, then the turned z, as MJCF has it by default."""
    q = np.array([1.0, 0, 0, 0])
    for axis, angle in zip(np.eye(3), np.asarray(angles, float)):
        q = _product(q, turn(axis, float(angle)))
    return q


def mirrored(q: ArrayLike, axis: int) -> FloatArray:
    """S R S of the plane whose normal is the axis of that number."""
    out = -np.asarray(q, float)
    out[0], out[1 + axis] = -out[0], -out[1 + axis]
    return out
