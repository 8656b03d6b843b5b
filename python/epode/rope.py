# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Ropes and bridges: chains of links between two points."""
from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from . import c
from ._assembly import Assembly, adopt_bodies
from ._handle import FloatArray, three
from .body import Body
from .errors import RefusedError
from .joint import Joint, type_of
from .shapes import Box, Capsule

if TYPE_CHECKING:
    from .world import World


class Rope(Assembly):
    """A row of links on joints, made by ``World.rope``: bodies, geoms and joints like any others. ``joints`` are the one before each link
    and that after the last: one more than ``bodies``, None at a loose end; ``rope.joints[0].feedback`` has the tension there."""

    __slots__ = ()

    def __repr__(self) -> str:
        return f"<epode.Rope of {len(self._bodies)} links{'' if self.alive else ', destroyed'}>"

    @classmethod
    def _new(cls, world: World, start: ArrayLike, end: ArrayLike, first: Body | None, last: Body | None, settings: c.dRopeSettings) -> Rope:
        if any(body is not None and body.world is not world for body in (first, last)):
            raise RefusedError("a body is in another world")
        begin, finish = (None if body is None else body._handle for body in (first, last))
        handles, made = c.dRopeCreate(world._handle, world._space, three(start, "start"), three(end, "end"), begin, finish, settings)
        geom = c.dBodyGetFirstGeom(handles[0])
        assert geom is not None
        if settings.width > 0:
            shape: Box | Capsule = Box(*(float(side) for side in c.dGeomBoxGetLengths(geom)))
        else:
            shape = Capsule(*c.dGeomCapsuleGetParams(geom))
        bodies = adopt_bodies(world, handles, lambda i: shape)
        joints = [None if handle is None else cls._joint(world, handle) for handle in made]
        return cls(world, bodies, joints, ())

    @staticmethod
    def _joint(world: World, handle: c.dJointID) -> Joint:
        body1, body2 = (None if end is None else world._bodies.get(end) for end in (c.dJointGetBody(handle, 0), c.dJointGetBody(handle, 1)))
        joint = world._joints[handle] = Joint(world, handle, type_of(handle), body1, body2)
        return joint

    def _ends(self) -> tuple[FloatArray, FloatArray]:
        """Where the links begin and end, as they are now."""
        self._must_live()
        shape = self.bodies[0].geoms[0].shape
        along, length = (0, shape.x) if isinstance(shape, Box) else (2, shape.length + 2 * shape.radius)  # type: ignore[attr-defined]
        centres = np.array([body.position for body in self.bodies])
        half = np.array([body.rotation[:, along] for body in self.bodies]) * (length / 2)
        return centres - half, centres + half

    @property
    def points(self) -> FloatArray:
        """Where each link begins, and where the last one ends: an array of (links + 1, 3), to draw it, m."""
        begins, ends = self._ends()
        return np.vstack([begins, ends[-1:]])

    @property
    def gap(self) -> float:
        """The largest distance between the end of a link and the beginning of the next, m: errors of joints, or how far springs are
        stretched."""
        begins, ends = self._ends()
        return float(np.linalg.norm(begins[1:] - ends[:-1], axis=1).max(initial=0.0))
