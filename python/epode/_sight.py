# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Where a window's eye is and which ray goes through a pixel; and lines that show forces."""
from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ._handle import FloatArray

if TYPE_CHECKING:
    from .world import World

FIELD = math.radians(32)  # of view where nothing says one, from the lowest to the highest row
_ORANGE, _RED, _BLUE = (0.95, 0.55, 0.10), (0.85, 0.20, 0.15), (0.15, 0.45, 0.90)


def turned(eye: FloatArray, target: FloatArray, azimuth: float, elevation: float) -> FloatArray:
    """Where an eye is after turning about a target, rad; it never passes over the pole."""
    arm = eye - target
    distance = float(np.linalg.norm(arm))
    up = float(np.clip(math.asin(np.clip(arm[2] / distance, -1, 1)) + elevation, -1.55, 1.55))
    around = math.atan2(arm[1], arm[0]) + azimuth
    return target + distance * np.array([math.cos(up) * math.cos(around), math.cos(up) * math.sin(around), math.sin(up)])


class Sight(NamedTuple):
    """An eye, what it looks at, what is up in the picture (None: z), and the field of view, rad (0: FIELD)."""
    eye: FloatArray
    target: FloatArray
    up: FloatArray | None = None
    field: float = 0.0

    def axes(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Unit vectors to the right, up and forward."""
        forward = (self.target - self.eye) / max(float(np.linalg.norm(self.target - self.eye)), 1e-12)
        right = np.cross(forward, (0, 0, 1) if self.up is None else self.up)
        right /= max(float(np.linalg.norm(right)), 1e-12)
        return right, np.cross(right, forward), forward

    def ray(self, x: float, y: float, width: int, height: int) -> FloatArray:
        """The unit direction through a pixel of a picture of that size, counted from its upper left corner."""
        right, up, forward = self.axes()
        half = math.tan((self.field or FIELD) / 2)
        way = forward + half * ((2 * x / width - 1) * width / height * right + (1 - 2 * y / height) * up)
        return np.asarray(way / float(np.linalg.norm(way)))


def line(a: FloatArray, b: FloatArray, color: tuple[float, float, float] = _BLUE) -> FloatArray:
    """A row of nine numbers: both ends and the colour."""
    return np.concatenate([a, b, color])


def arrow(at: FloatArray, way: FloatArray, color: tuple[float, float, float]) -> list[FloatArray]:
    """From a point along a vector, with a head."""
    size, tip = float(np.linalg.norm(way)), at + way
    if size < 1e-9:
        return []
    aside = np.cross(way, (0, 0, 1) if abs(way[2]) < 0.9 * size else (1, 0, 0))
    aside *= 0.1 * size / float(np.linalg.norm(aside))
    return [line(at, tip, color), *(line(tip, tip - 0.25 * way + s * aside, color) for s in (-1, 1))]


def contact_lines(world: World, metres: float) -> list[FloatArray]:
    """Arrows at the points of contact of the last step: of normal forces, and of friction; the average weight of a body that moves is so
    many metres long."""
    contacts = world.contacts
    masses = [body.mass for body in world.bodies if not body.kinematic]
    weight = float(np.mean(masses)) * float(np.linalg.norm(world.gravity)) if masses else 0.0
    scale = metres / weight if weight > 0 else 0.0
    out: list[FloatArray] = []
    for contact in contacts:
        at = np.asarray(contact["pos"][:3], float)
        out += arrow(at, scale * float(contact["normal_force"]) * np.asarray(contact["normal"][:3], float), _ORANGE)
        out += arrow(at, scale * np.asarray(contact["friction_force"][:3], float), _RED)
    return out
