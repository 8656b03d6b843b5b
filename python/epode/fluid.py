# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Water and other fluids."""
from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from . import c
from ._handle import FloatArray, Object, Value

if TYPE_CHECKING:
    from .body import Body
    from .geom import Geom
    from .world import World


def _setting(name: str, doc: str) -> Value[float, float]:
    def put(self: Fluid, value: float) -> None:
        given = self._settings()
        setattr(given, name, value)
        c.dFluidSetSettings(self._handle, given)
    return Value(lambda self: float(getattr(self._settings(), name)), put, doc=doc)


class Fluid(Object):
    """A fluid of a world, made by ``World.fluid``: everything below a surface. It lifts, brakes and carries awake bodies in
    every step."""

    __slots__ = ()

    def __init__(self, world: World, live: c.dFluidID | None = None) -> None:
        """world: where it is. live: a fluid of that world that the library has; without one, a new one: water below z = 0."""
        self.world = world
        self._live: c.dFluidID | None = live if live is not None else c.dFluidCreate(world._handle)

    @classmethod
    def _around(cls, world: World, live: c.dFluidID) -> Fluid:
        return cls(world, live)

    def _settings(self) -> c.dFluidSettings:
        given = c.dFluidSettings()
        c.dFluidGetSettings(self._handle, given)
        return given

    density = _setting("density", "kg/m^3; 1000 at first.")
    drag = _setting("drag", "Coefficient of drag by pressure; 1 at first, a ball has about 0.47.")
    linear_drag = _setting("linear_drag", "Drag proportional to the velocity, N s/m^3; 200 at first.")
    angular_drag = _setting("angular_drag", "Times the drag against turning of a box; 1 at first.")

    @property
    def current(self) -> FloatArray:
        """Velocity of the fluid, m/s."""
        return np.array(self._settings().current[:3], dtype=float)

    @current.setter
    def current(self, value: ArrayLike) -> None:
        given = self._settings()
        given.current = np.asarray(value, dtype=float)
        c.dFluidSetSettings(self._handle, given)

    @property
    def plane(self) -> FloatArray:
        """(a, b, c, d): the surface a x + b y + c z = d, (a, b, c) out of the fluid."""
        return c.dFluidGetPlane(self._handle)

    @plane.setter
    def plane(self, value: ArrayLike) -> None:
        a, b, z, d = np.asarray(value, dtype=float)
        c.dFluidSetPlane(self._handle, a, b, z, d)

    def surface(self, function: Callable[[FloatArray, float], float] | None) -> None:
        """Let function(place, time) say how high the fluid stands above its plane; None: nowhere."""
        c.dFluidSetSurface(self._handle, function)

    def flow(self, function: Callable[[FloatArray, float], ArrayLike] | None) -> None:
        """Let function(place, time) say how the fluid moves, m/s; None: as ``current`` says."""
        c.dFluidSetCurrentFunction(self._handle, function)

    @property
    def volume(self) -> Geom | None:
        """The geom of the world that the fluid is restricted to; None: no limit."""
        handle = c.dFluidGetVolume(self._handle)
        if handle is None:
            return None
        return next((geom for geom in self.world._geoms.values() if geom._live == handle), None)

    @volume.setter
    def volume(self, geom: Geom | None) -> None:
        c.dFluidSetVolume(self._handle, None if geom is None else geom._handle)

    @property
    def time(self) -> float:
        """What functions get as time, s."""
        return c.dFluidGetTime(self._handle)

    @time.setter
    def time(self, value: float) -> None:
        c.dFluidSetTime(self._handle, value)

    def submerged(self, what: Body | Geom) -> tuple[float, FloatArray]:
        """(volume, centre) of what of a body or geom lies in the fluid."""
        from .body import Body
        find = c.dFluidGetSubmergedBody if isinstance(what, Body) else c.dFluidGetSubmerged
        _, volume, centre = find(self._handle, what._handle)
        return float(volume), centre

    def destroy(self) -> None:
        """Destroy the fluid. A second time does nothing."""
        if self._live is None:
            return
        c.dFluidDestroy(self._live)
        self._live = None
        self.world._fluids.remove(self)
