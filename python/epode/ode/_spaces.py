# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Spaces, and what collides in them."""
from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

from .. import c
from ._base import _getter, _known, _setter
from ._dynamics import Contact
from ._geoms import GeomObject, _inside

_MOST_CONTACTS = 150


class SpaceBase(GeomObject):
    """What all spaces have: geoms that may collide."""

    _destroy = staticmethod(c.dSpaceDestroy)  # type: ignore[assignment]
    _placeable = False

    def isSpace(self) -> bool:
        """Whether the geom is a space."""
        return True

    def _begin_space(self, space: SpaceBase | None, handle: c.dSpaceID) -> None:
        self._begin(space, handle)
        c.dSpaceSetCleanup(handle, 0)  # geoms go with their Python objects

    def add(self, geom: GeomObject) -> None:
        """Put a geom into the space."""
        c.dSpaceAdd(self._handle, geom._handle)

    def remove(self, geom: GeomObject) -> None:
        """Take a geom out of the space."""
        c.dSpaceRemove(self._handle, geom._handle)

    def query(self, geom: GeomObject) -> bool:
        """Whether a geom is in the space."""
        return bool(c.dSpaceQuery(self._handle, geom._handle))

    clean = _setter(c.dSpaceClean)
    getNumGeoms = _getter(c.dSpaceGetNumGeoms, int)
    getCleanup, setCleanup = _getter(c.dSpaceGetCleanup, int), _setter(c.dSpaceSetCleanup)
    getSublevel, setSublevel = _getter(c.dSpaceGetSublevel, int), _setter(c.dSpaceSetSublevel)
    getManualCleanup, setManualCleanup = _getter(c.dSpaceGetManualCleanup, int), _setter(c.dSpaceSetManualCleanup)

    def getGeom(self, idx: int) -> GeomObject:
        """The geom with a number, from 0 on."""
        if not 0 <= idx < self.getNumGeoms():
            raise IndexError(f"geom {idx}: the space has {self.getNumGeoms()}")
        geom = _known(c.dSpaceGetGeom(self._handle, idx))
        if geom is None:
            raise RuntimeError("geom is in space but not known here: its Python object is gone")
        return geom

    def __len__(self) -> int:
        return int(self.getNumGeoms())

    def __iter__(self) -> Iterator[GeomObject]:
        return (self.getGeom(i) for i in range(len(self)))

    def collide(self, arg: Any, callback: Callable[[Any, GeomObject, GeomObject], Any]) -> None:
        """Call callback(arg, geom1, geom2) for geoms whose boxes touch."""
        c.dSpaceCollide(self._handle, _near(arg, callback))


def _near(arg: Any, callback: Callable[[Any, GeomObject, GeomObject], Any]) -> Callable[[c.dGeomID, c.dGeomID], Any]:
    def near(a: c.dGeomID, b: c.dGeomID) -> None:
        geom1, geom2 = _known(a), _known(b)
        if geom1 is not None and geom2 is not None:
            callback(arg, geom1, geom2)
    return near


class SimpleSpace(SpaceBase):
    """A space that compares each pair."""

    def __init__(self, space: SpaceBase | None = None) -> None:
        self._begin_space(space, c.dSimpleSpaceCreate(_inside(space)))


class HashSpace(SpaceBase):
    """A space that is fast with many geoms."""

    def __init__(self, space: SpaceBase | None = None) -> None:
        self._begin_space(space, c.dHashSpaceCreate(_inside(space)))

    setLevels, getLevels = _setter(c.dHashSpaceSetLevels), _getter(c.dHashSpaceGetLevels, tuple)


class QuadTreeSpace(SpaceBase):
    """A space for landscapes: a tree of depth levels over a box."""

    def __init__(self, center: Sequence[float], extents: Sequence[float], depth: int, space: SpaceBase | None = None) -> None:
        self._begin_space(space, c.dQuadTreeSpaceCreate(_inside(space), center, extents, depth))


class SAPSpace(SpaceBase):
    """A space that sweeps along the axes in an order such as "XYZ"."""

    def __init__(self, sweep_order: str = "XYZ", space: SpaceBase | None = None) -> None:
        first, second, third = ("XYZ".index(axis) for axis in (sweep_order if sorted(sweep_order) == list("XYZ") else "XYZ"))
        self._begin_space(space, c.dSweepAndPruneSpaceCreate(_inside(space), first | second << 2 | third << 4))


def Space(space_type: int = 0) -> SpaceBase:
    """A SimpleSpace (0) or HashSpace (1)."""
    if space_type not in (0, 1):
        raise ValueError(f"space type {space_type}: 0 or 1 expected")
    return HashSpace() if space_type else SimpleSpace()


def collide(geom1: GeomObject, geom2: GeomObject) -> list[Contact]:
    """The contacts of two geoms."""
    contacts = []
    for found in c.dCollide(geom1._handle, geom2._handle, _MOST_CONTACTS):
        contact = Contact()
        contact._contact.geom = found
        contacts.append(contact)
    return contacts


def collide2(geom1: GeomObject, geom2: GeomObject, arg: Any, callback: Callable[[Any, GeomObject, GeomObject], Any]) -> None:
    """Call callback(arg, a, b) for geoms of the one and of the other whose boxes touch."""
    c.dSpaceCollide2(geom1._handle, geom2._handle, _near(arg, callback))
