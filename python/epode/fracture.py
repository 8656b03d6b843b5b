# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Fracture: bodies that break into given parts."""
from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from numpy.typing import ArrayLike

from . import c
from ._assembly import Assembly
from ._handle import FloatArray, three
from .body import Body
from .errors import RefusedError
from .geom import Geom

if TYPE_CHECKING:
    from .joint import Joint
    from .world import World


def _limit(name: str, value: float) -> float:
    if not value >= 0:
        raise ValueError(f"{name} is {value}; 0 or more is expected")
    return float(value)


class Fracture(Assembly):
    """A body of given parts, made by ``World.fracture``, and what it breaks into. Parts are geoms, which keep their objects; ``geom.body`` says
    which piece a part belongs to. Call ``World.break_fractures`` before each step.

    The pieces go on as the body moved. The blow that breaks a body has its strength and no more: a ball goes on through a pane
    with what is left of its momentum."""

    __slots__ = ("_densities", "_strength", "_radius")

    def __init__(self, world: World, parts: Sequence[Geom | None], densities: FloatArray, strength: float, radius: float) -> None:
        """As ``World.fracture`` does: in the world, of parts with densities, with a strength and a radius."""
        super().__init__(world, (), (), parts)
        self._densities, self._strength, self._radius = densities, strength, radius

    def __repr__(self) -> str:
        return f"<epode.Fracture of {len(self.parts)} parts in {len(self.bodies)} bodies>"

    @classmethod
    def _new(cls, world: World, parts: Sequence[Geom], density: ArrayLike, strength: float, radius: float) -> Fracture:
        for part in parts:
            if not isinstance(part, Geom):
                raise TypeError(f"parts: geoms, as World.geom makes them, are expected, not {part!r}")
            if part.world is not world:
                raise RefusedError("a part is in another world")
        densities = np.broadcast_to(np.asarray(density, dtype=float), len(parts)).copy()
        fracture = cls(world, parts, densities, _limit("strength", strength), _limit("radius", radius))
        handle = c.dFractureCreate(world._handle, fracture._list())
        body = world._bodies[handle] = Body(world, handle)
        body.geoms.extend(parts)
        for part in parts:
            part.body = body
        world._body_list = None
        world._edition += 1
        return fracture

    def _settings(self) -> tuple[Any, ...]:
        return self._densities, self._strength, self._radius

    @classmethod
    def _again(cls, world: World, settings: tuple[Any, ...], bodies: list[Body | None], joints: list[Joint | None],
               geoms: list[Geom | None]) -> Self:
        return cls(world, geoms, *settings)

    def _list(self) -> list[c.dFracturePart]:
        """The parts that are left, as C takes them."""
        parts = []
        for geom, density in zip(self._geoms, self._densities):
            if geom is not None and geom.alive:
                part = c.dFracturePart()
                part.geom, part.density = geom._handle, float(density)
                parts.append(part)
        return parts

    # ---- what it is ----

    @property
    def parts(self) -> tuple[Geom, ...]:
        """The geoms that have not been destroyed."""
        return tuple(geom for geom in self._geoms if geom is not None and geom.alive)

    @property
    def alive(self) -> bool:
        """Whether a part of it is left."""
        return len(self.parts) > 0

    @property
    def bodies(self) -> tuple[Body, ...]:
        """The bodies that it is now, in the order of their parts."""
        return tuple(dict.fromkeys(geom.body for geom in self.parts if geom.body is not None))

    @property
    def strength(self) -> float:
        """The normal impulse, N s, of a blow of one other geom on one part that it withstands. A resting load exerts its weight times
        the step."""
        return self._strength

    @strength.setter
    def strength(self, value: float) -> None:
        self._strength = _limit("strength", value)

    @property
    def radius(self) -> float:
        """Parts within this distance of the hardest contact come off, each alone, m; infinite: all."""
        return self._radius

    @radius.setter
    def radius(self, value: float) -> None:
        self._radius = _limit("radius", value)

    # ---- breaks ----

    def break_up(self, body: Body | None = None, *, center: ArrayLike | None = None, radius: float = float("inf")) -> int:
        """Break one of its bodies (None: each that has more than one part). Parts within radius, m, of center (None: all) come off, each
        alone; of the others those that touch each other stay together. Returns how many bodies there are more."""
        if body is not None and body not in self.bodies:
            raise RefusedError("the body is none of this Fracture")
        at, more = None if center is None else three(center, "center"), 0
        _limit("radius", radius)
        for one in self.bodies if body is None else (body,):
            try:
                pieces = c.dFractureBreak(self._list(), one._handle, at, radius)
                more += max(pieces - 1, 0)
            finally:
                meet_pieces(self.world, [self])
        return more

    def destroy(self) -> None:
        """Destroy its bodies, with all parts."""
        for body in self.bodies:
            body.destroy()
        for part in self.parts:  # on no body
            part.destroy()


def meet_pieces(world: World, fractures: Sequence[Fracture]) -> None:
    """Make objects for the bodies that pieces have become; those that have broken are gone. Of the pieces one may have the address of
    its body, but never all."""
    def now(part: Geom) -> Any:
        return c.dGeomGetBody(part._handle)
    broken = [body for fracture in fractures for body in fracture.bodies if any(now(geom) != body._live for geom in body.geoms)]
    if not broken:
        return
    parts = [geom for body in broken for geom in body.geoms]
    for body in broken:
        world._bodies.pop(body._live, None)
        body._live, body.geoms = None, []
    pieces: dict[Any, list[Geom]] = {}
    for part in parts:
        pieces.setdefault(now(part), []).append(part)
    order = c.dWorldGetBodies(world._handle)
    for handle in (order[i] for i in range(len(order))):
        if handle in pieces:
            piece = world._bodies[handle] = Body(world, handle)
            piece.geoms = pieces[handle]
            for part in piece.geoms:
                part.body = piece
    world._body_list = None
    world._edition += 1
