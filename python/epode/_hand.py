# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What the mouse does with bodies of a world: it picks one by a ray, pulls it by a damped spring while steps are made, and pushes it."""
from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from . import c
from ._handle import FloatArray

if TYPE_CHECKING:
    from .body import Body
    from .world import World

_SPEED = 2 * math.pi * 2.5  # rad/s of the spring on the mass that it feels
_SHARE = 0.3  # of 1/h at most, so that long steps follow


class Hand:
    """Holds a point of a body and draws it to ``goal``."""

    def __init__(self, body: Body, place: FloatArray) -> None:
        """body: what is held. place: where, in the world, m."""
        self.body = body
        self.goal = np.array(place, float)
        self._local = body.rotation.T @ (self.goal - body.position)

    @property
    def place(self) -> FloatArray:
        """Where the held point is now."""
        return np.asarray(self.body.position + self.body.rotation @ self._local)

    def pull(self, h: float) -> None:
        """Before a step of size h: add the force of the spring and its damper, for that step."""
        if not self.body.alive or not 0 < h < math.inf:
            return
        at = self.place
        speed = min(_SPEED, _SHARE / h)
        moving = self.body.velocity + np.cross(self.body.angular_velocity, at - self.body.position)
        force = self._mass(at) * (speed * speed * (self.goal - at) - 2 * speed * moving)
        self.body.enabled = True
        c.dBodyAddForceAtPos(self.body._handle, *force, *at)

    def _mass(self, at: FloatArray) -> float:
        """What the point of the body alone feels like on the way to the goal, kg."""
        way = self.goal - at
        size = float(np.linalg.norm(way))
        if size < 1e-9:
            return self.body.mass
        arm = self.body.rotation.T @ np.cross(at - self.body.position, way / size)
        return float(1 / (1 / self.body.mass + arm @ np.linalg.solve(self.body.inertia, arm)))


def pick(world: World, eye: FloatArray, way: FloatArray) -> tuple[Body, FloatArray] | None:
    """The body that can move and is first on a ray, and where the ray meets it; None: there is none, or what stands still hides it."""
    hit = world.ray(eye, way)
    if hit is None or hit[0] is None or hit[0].body is None or hit[0].body.kinematic:
        return None
    return hit[0].body, np.array(hit[1])


def strike(body: Body, place: FloatArray, way: FloatArray, speed: float) -> None:
    """Give a body the momentum that its mass has at `speed`, m/s, along a direction, at a point."""
    momentum = body.mass * speed * way / float(np.linalg.norm(way))
    turn = np.linalg.solve(body.inertia, body.rotation.T @ np.cross(place - body.position, momentum))
    body.enabled = True
    body.velocity = body.velocity + momentum / body.mass
    body.angular_velocity = body.angular_velocity + body.rotation @ turn
