# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Geoms and the data of meshes and height fields."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import c
from ._base import Vector, environment
from ._base import _geoms, _getter, _known, _Owner, _setter, _tuple, _whole_setter

if TYPE_CHECKING:
    from ._dynamics import Body
    from ._spaces import SpaceBase


class GeomObject(_Owner):
    """What all geoms have. A geom takes whatever attributes a program gives it."""

    _destroy = staticmethod(c.dGeomDestroy)
    _placeable = True

    def _begin(self, space: SpaceBase | None, handle: c.dGeomID) -> None:
        self._handle, self.body, self.space, self.attribs = handle, environment, space, {}
        _geoms[handle.id] = self

    body: Body | None
    space: SpaceBase | None
    attribs: dict[str, Any]

    def _id(self) -> int:
        return int(self._handle.id)

    def placeable(self) -> bool:
        """Whether the geom has a place."""
        return self._placeable

    def isSpace(self) -> bool:
        """Whether the geom is a space."""
        return False

    def setBody(self, body: Body | None) -> None:
        """Put the geom on a body, or take it off (None)."""
        if not self._placeable:
            raise ValueError("the geom has no place and cannot be on a body")
        c.dGeomSetBody(self._handle, None if body is None else body._handle)
        self.body = body

    def getBody(self) -> Body | None:
        """The body, or environment."""
        return self.body

    def getSpace(self) -> SpaceBase | None:
        """The space that the geom is in, or None."""
        found = c.dGeomGetSpace(self._handle)
        known: Any = _known(found)
        return known if known is not None and known.isSpace() else None

    getPosition, setPosition = _getter(c.dGeomGetPosition), _setter(c.dGeomSetPosition)
    getRotation, setRotation = _getter(c.dGeomGetRotation), _whole_setter(c.dGeomSetRotation)
    getQuaternion, setQuaternion = _getter(c.dGeomGetQuaternion), _whole_setter(c.dGeomSetQuaternion)
    setOffsetPosition, clearOffset = _setter(c.dGeomSetOffsetPosition), _setter(c.dGeomClearOffset)
    setOffsetRotation, setOffsetQuaternion = _whole_setter(c.dGeomSetOffsetRotation), _whole_setter(c.dGeomSetOffsetQuaternion)
    getAABB = _getter(c.dGeomGetAABB)
    getCategoryBits, setCategoryBits = _getter(c.dGeomGetCategoryBits, int), _setter(c.dGeomSetCategoryBits)
    getCollideBits, setCollideBits = _getter(c.dGeomGetCollideBits, int), _setter(c.dGeomSetCollideBits)
    enable, disable, isEnabled = _setter(c.dGeomEnable), _setter(c.dGeomDisable), _getter(c.dGeomIsEnabled, bool)


def _inside(space: SpaceBase | None) -> c.dSpaceID | None:
    return None if space is None else space._handle


def _depth(function: Callable[..., float]) -> Any:
    def pointDepth(self: Any, p: Sequence[float]) -> float:
        x, y, z = p
        return function(self._handle, x, y, z)
    pointDepth.__doc__ = function.__doc__
    return pointDepth


class GeomSphere(GeomObject):
    """A ball."""

    def __init__(self, space: SpaceBase | None = None, radius: float = 1.0) -> None:
        self._begin(space, c.dCreateSphere(_inside(space), radius))

    getRadius, setRadius = _getter(c.dGeomSphereGetRadius, float), _setter(c.dGeomSphereSetRadius)
    pointDepth = _depth(c.dGeomSpherePointDepth)


class GeomBox(GeomObject):
    """A box with full side lengths."""

    def __init__(self, space: SpaceBase | None = None, lengths: Sequence[float] = (1.0, 1.0, 1.0)) -> None:
        self._begin(space, c.dCreateBox(_inside(space), *lengths))

    getLengths, setLengths = _getter(c.dGeomBoxGetLengths), _setter(c.dGeomBoxSetLengths)
    pointDepth = _depth(c.dGeomBoxPointDepth)


class GeomPlane(GeomObject):
    """The half space below normal . p = dist."""

    _placeable = False

    def __init__(self, space: SpaceBase | None = None, normal: Sequence[float] = (0, 0, 1), dist: float = 0) -> None:
        x, y, z = normal
        self._begin(space, c.dCreatePlane(_inside(space), x, y, z, dist))

    def setParams(self, normal: Sequence[float], dist: float) -> None:
        """Set normal and distance."""
        x, y, z = normal
        c.dGeomPlaneSetParams(self._handle, x, y, z, dist)

    def getParams(self) -> tuple[Vector, float]:
        """Normal and distance."""
        a, b, d, distance = _tuple(c.dGeomPlaneGetParams(self._handle))
        return (a, b, d), distance

    pointDepth = _depth(c.dGeomPlanePointDepth)


class GeomCapsule(GeomObject):
    """A cylinder along z with round caps; length is without them."""

    def __init__(self, space: SpaceBase | None = None, radius: float = 0.5, length: float = 1.0) -> None:
        self._begin(space, c.dCreateCapsule(_inside(space), radius, length))

    getParams, setParams = _getter(c.dGeomCapsuleGetParams, tuple), _setter(c.dGeomCapsuleSetParams)
    pointDepth = _depth(c.dGeomCapsulePointDepth)


GeomCCylinder = GeomCapsule


class GeomCylinder(GeomObject):
    """A cylinder along z."""

    def __init__(self, space: SpaceBase | None = None, radius: float = 0.5, length: float = 1.0) -> None:
        self._begin(space, c.dCreateCylinder(_inside(space), radius, length))

    getParams, setParams = _getter(c.dGeomCylinderGetParams, tuple), _setter(c.dGeomCylinderSetParams)


class GeomRay(GeomObject):
    """A ray."""

    def __init__(self, space: SpaceBase | None = None, rlen: float = 1.0) -> None:
        self._begin(space, c.dCreateRay(_inside(space), rlen))

    getLength, setLength = _getter(c.dGeomRayGetLength, float), _setter(c.dGeomRaySetLength)
    set = _setter(c.dGeomRaySet)

    def get(self) -> tuple[Vector, Vector]:
        """Start and direction."""
        start, direction = c.dGeomRayGet(self._handle)
        return _tuple(start[:3]), _tuple(direction[:3])


class GeomTransform(GeomObject):
    """A geom that is somewhere else than where its body is."""

    def __init__(self, space: SpaceBase | None = None) -> None:
        self._begin(space, c.dCreateGeomTransform(_inside(space)))
        c.dGeomTransformSetCleanup(self._handle, 0)
        self.geom: GeomObject | None = None

    def setGeom(self, geom: GeomObject) -> None:
        """Set the geom inside, which has a place and is in no space and on no body."""
        if not geom.placeable() or c.dGeomGetSpace(geom._handle) is not None or geom.body is not None:
            raise ValueError("a geom expected that has a place, and is in no space and on no body")
        c.dGeomTransformSetGeom(self._handle, geom._handle)
        self.geom = geom

    def getGeom(self) -> GeomObject | None:
        """The geom inside."""
        return self.geom

    getInfo, setInfo = _getter(c.dGeomTransformGetInfo, int), _setter(c.dGeomTransformSetInfo)


class TriMeshData(_Owner):
    """Triangles."""

    _destroy = staticmethod(c.dGeomTriMeshDataDestroy)

    def __init__(self) -> None:
        self._handle = c.dGeomTriMeshDataCreate()

    def build(self, verts: Sequence[Sequence[float]], faces: Sequence[Sequence[int]]) -> None:
        """Vertices, and three indices for each triangle."""
        c.dGeomTriMeshDataBuildDouble(self._handle, np.array(verts, float), np.array(faces, np.uint32))


class GeomTriMesh(GeomObject):
    """A surface of triangles."""

    def __init__(self, data: TriMeshData, space: SpaceBase | None = None) -> None:
        self.data = data
        self._begin(space, c.dCreateTriMesh(_inside(space), data._handle))

    clearTCCache = _setter(c.dGeomTriMeshClearTCCache)
    getTriangleCount = _getter(c.dGeomTriMeshGetTriangleCount, int)

    def getTriangle(self, idx: int) -> tuple[Vector, Vector, Vector]:
        """The corners of a triangle, in the world."""
        a, b, d = c.dGeomTriMeshGetTriangle(self._handle, idx)
        return _tuple(a), _tuple(b), _tuple(d)


def _heights(function: Callable[..., None], dtype: Any) -> Any:
    def build(self: Any, heightData: Any, copy: bool, width: float, depth: float, widthSamples: int, depthSamples: int,
              scale: float, offset: float, thickness: float, bWrap: bool) -> None:
        heights = np.asarray(heightData, dtype).reshape(depthSamples, widthSamples)
        function(self._handle, heights, width, depth, scale, offset, thickness, bool(bWrap))
    build.__doc__ = function.__doc__
    return build


class HeightfieldData(_Owner):
    """Heights on a grid, y up."""

    _destroy = staticmethod(c.dGeomHeightfieldDataDestroy)

    def __init__(self) -> None:
        self._handle = c.dGeomHeightfieldDataCreate()

    buildByte, buildShort = _heights(c.dGeomHeightfieldDataBuildByte, np.uint8), _heights(c.dGeomHeightfieldDataBuildShort, np.int16)
    buildSingle, buildDouble = _heights(c.dGeomHeightfieldDataBuildSingle, np.float32), _heights(c.dGeomHeightfieldDataBuildDouble, float)
    setBounds = _setter(c.dGeomHeightfieldDataSetBounds)

    def build_callback(self, userdata: Any, callback: Callable[[Any, int, int], float], width: float, depth: float, widthSamples: int,
                       depthSamples: int, scale: float, offset: float, thickness: float, bwrap: bool) -> None:
        """Heights that callback(userdata, x, z) returns."""
        c.dGeomHeightfieldDataBuildCallback(self._handle, lambda x, z: callback(userdata, x, z), width, depth, widthSamples,
                                            depthSamples, scale, offset, thickness, bool(bwrap))


class GeomHeightfield(GeomObject):
    """Ground from heights."""

    def __init__(self, data: HeightfieldData, space: SpaceBase | None = None, placeable: bool = True) -> None:
        self.data = data
        self._placeable = bool(placeable)
        self._begin(space, c.dCreateHeightfield(_inside(space), data._handle, int(self._placeable)))

    def setHeightfieldData(self, data: HeightfieldData) -> None:
        """Give the geom other data."""
        c.dGeomHeightfieldSetHeightfieldData(self._handle, data._handle)
        self.data = data
