# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Shapes: descriptions from which a world makes geoms and masses. Lengths in m."""
from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import c
from ._handle import describe_fields
from .enums import CombineRule
from .errors import RefusedError


class _Data:
    """Triangles or heights of the library, which geoms of several worlds may share: destroyed when neither their shape nor a
    geom of it is left."""

    __slots__ = ("handle", "_destroy", "__weakref__")

    def __init__(self, handle: Any, destroy: Callable[[Any], Any]) -> None:
        self.handle, self._destroy = handle, destroy

    def __del__(self) -> None:
        self._destroy(self.handle)

    def __reduce__(self) -> tuple[type[None], tuple[()]]:
        return type(None), ()  # a pickle has the arrays, and makes data of its own


class Shape:
    """A description of a shape."""

    def _create(self, space: c.dSpaceID) -> c.dGeomID:
        raise NotImplementedError

    def _adopt(self, geom: c.dGeomID) -> None:
        """The library has made a geom of the shape."""

    def _mass(self, mass: float | None, density: float, geom: c.dGeomID) -> c.dMass:
        """The c.dMass of the shape, of that total mass or density."""
        raise TypeError(f"{type(self).__name__} has no mass of its own: give the body mass and inertia")


class LoadedShape(Shape):
    """The shape of a geom that a file of a world has brought along (``load_world``); ``c`` reads its sizes."""


def _adopted(data: _Data | None, handle: Any, destroy: Callable[[Any], Any]) -> _Data:
    """Data that a loaded world has brought along, unless they are known."""
    return data if data is not None and data.handle == handle else _Data(handle, destroy)


def _weighed(total: Callable[..., Any], dense: Callable[..., Any], mass: float | None, density: float, *parts: Any) -> c.dMass:
    """A c.dMass by one of two C functions: of that total mass or, if it is None, density."""
    m = c.dMass()
    (dense if mass is None else total)(m, density if mass is None else mass, *parts)
    return m


def _solid(create: Callable[..., c.dGeomID], total: Callable[..., Any], dense: Callable[..., Any], fields: list[str], axial: bool = False) -> Any:
    """The methods of a solid whose C functions take its fields in order."""
    def make(self: Shape, space: c.dSpaceID) -> c.dGeomID:
        return create(space, *(getattr(self, f) for f in fields))

    def weigh(self: Shape, mass: float | None, density: float, geom: c.dGeomID) -> c.dMass:
        axis = [3] if axial else []
        return _weighed(total, dense, mass, density, *axis, *(getattr(self, f) for f in fields))
    return make, weigh


@dataclasses.dataclass
class Sphere(Shape):
    """A ball of a radius."""
    radius: float
    _create, _mass = _solid(c.dCreateSphere, c.dMassSetSphereTotal, c.dMassSetSphere, ["radius"])


@dataclasses.dataclass
class Box(Shape):
    """A box with full side lengths x, y and z."""
    x: float
    y: float
    z: float
    _create, _mass = _solid(c.dCreateBox, c.dMassSetBoxTotal, c.dMassSetBox, ["x", "y", "z"])


@dataclasses.dataclass
class Capsule(Shape):
    """A cylinder along z with round caps, of a radius; length is without them."""
    radius: float
    length: float
    _create, _mass = _solid(c.dCreateCapsule, c.dMassSetCapsuleTotal, c.dMassSetCapsule, ["radius", "length"], True)


@dataclasses.dataclass
class Cylinder(Shape):
    """A cylinder along z, of a radius and a length."""
    radius: float
    length: float
    _create, _mass = _solid(c.dCreateCylinder, c.dMassSetCylinderTotal, c.dMassSetCylinder, ["radius", "length"], True)


@dataclasses.dataclass
class Cone(Shape):
    """A cone along z with its apex up, of the radius of its base and a length; the origin is the centre of mass."""
    radius: float
    length: float
    _create, _mass = _solid(c.dCreateCone, c.dMassSetConeTotal, c.dMassSetCone, ["radius", "length"], True)


@dataclasses.dataclass
class TaperedCapsule(Shape):
    """The hull of two balls along z, radius2 above radius1, length between their centres; the origin is the centre of mass."""
    radius1: float
    radius2: float
    length: float
    _create, _mass = _solid(c.dCreateTaperedCapsule, c.dMassSetTaperedCapsuleTotal, c.dMassSetTaperedCapsule,
                            ["radius1", "radius2", "length"], True)


@dataclasses.dataclass
class Ellipsoid(Shape):
    """An ellipsoid with half lengths x, y and z."""
    x: float
    y: float
    z: float
    _create, _mass = _solid(c.dCreateEllipsoid, c.dMassSetEllipsoidTotal, c.dMassSetEllipsoid, ["x", "y", "z"])


@dataclasses.dataclass
class Plane(Shape):
    """The half space below normal . p = distance; it never moves."""
    normal: tuple[float, float, float] = (0, 0, 1)
    distance: float = 0.0

    def _create(self, space: c.dSpaceID) -> c.dGeomID:
        return c.dCreatePlane(space, *self.normal, self.distance)


@dataclasses.dataclass(eq=False)
class Convex(Shape):
    """The convex hull of points, an (n, 3) array, of at most max_vertices; 0: of all that it needs."""
    points: ArrayLike
    max_vertices: int = 0

    def _create(self, space: c.dSpaceID) -> c.dGeomID:
        return c.dCreateConvexHull(space, self.points, self.max_vertices)

    def _mass(self, mass: float | None, density: float, geom: c.dGeomID) -> c.dMass:
        return _weighed(c.dMassSetConvexTotal, c.dMassSetConvex, mass, density, geom)


@dataclasses.dataclass(eq=False)
class Mesh(Shape):
    """Triangles: vertices, an (n, 3) array, and indices into it, an (m, 3) array, counter-clockwise from outside.
    Contiguous float64 and uint32 arrays are not copied. solid: a closed mesh that is full."""
    vertices: ArrayLike
    triangles: ArrayLike
    solid: bool = False
    _data: _Data | None = dataclasses.field(default=None, init=False, repr=False)

    def _create(self, space: c.dSpaceID) -> c.dGeomID:
        if self._data is None:
            data = _Data(c.dGeomTriMeshDataCreate(), c.dGeomTriMeshDataDestroy)
            c.dGeomTriMeshDataBuildDouble(data.handle, self.vertices, self.triangles)
            self._data = data
        geom = c.dCreateTriMesh(space, self._data.handle)
        if self.solid:
            try:
                c.dGeomTriMeshSetSolid(geom, 1)
            except Exception:
                c.dGeomDestroy(geom)
                raise
        return geom

    def _adopt(self, geom: c.dGeomID) -> None:
        self._data = _adopted(self._data, c.dGeomTriMeshGetData(geom), c.dGeomTriMeshDataDestroy)

    def _mass(self, mass: float | None, density: float, geom: c.dGeomID) -> c.dMass:
        return _weighed(c.dMassSetTrimeshTotal, c.dMassSetTrimesh, mass, density, geom)


@dataclasses.dataclass(eq=False)
class Decomposition:
    """Hulls that together fill a solid. No measured point of them is farther from it than surplus, m, and no point of it farther
    outside them than uncovered, m, which is 0 unless their vertices were limited. closed: the mesh was."""
    parts: list[Convex]
    closed: bool
    tolerance: float
    surplus: float
    uncovered: float


def decompose(mesh: Mesh, *, tolerance: float = 0.0, max_parts: int = 32, max_vertices: int = 64) -> Decomposition:
    """A solid of any form as convex hulls, which move, roll and stack like all convex shapes.

    tolerance: how far from the solid a hull may reach, m; 0: 2.5 % of its longest side. max_parts: 1 to 256. max_vertices: of a
    hull, 0: as many as it has. Give a body a geom of each: ``for part in epode.decompose(mesh).parts: world.geom(part, body=body)``."""
    from . import _c
    if not hasattr(_c, "_decompose"):
        raise RefusedError("this build decomposes no meshes: it wants pugixml (Debian: libpugixml-dev)")
    parts, closed, tolerance, surplus, uncovered = _c._decompose(mesh.vertices, mesh.triangles, tolerance, max_parts, max_vertices)
    return Decomposition([Convex(points) for points in parts], closed, tolerance, surplus, uncovered)


@dataclasses.dataclass(eq=False)
class HeightField(Shape):
    """Ground from heights[j, i] over a rectangle of width (x) by depth (y), its middle at the origin, z up; thickness: of the ground
    below its lowest point."""
    heights: ArrayLike
    width: float
    depth: float
    thickness: float = 1.0
    _data: _Data | None = dataclasses.field(default=None, init=False, repr=False)

    def _create(self, space: c.dSpaceID) -> c.dGeomID:
        if self._data is None:
            data = _Data(c.dGeomHeightfieldDataCreate(), c.dGeomHeightfieldDataDestroy)
            # The C API's field has y up and its second side along z: turned by 90 degrees about x, z becomes -y.
            flipped = np.ascontiguousarray(np.asarray(self.heights, float)[::-1])
            c.dGeomHeightfieldDataBuildDouble(data.handle, flipped, self.width, self.depth, thickness=self.thickness)
            self._data = data
        geom = c.dCreateHeightfield(space, self._data.handle, 1)
        h = 0.5 ** 0.5
        c.dGeomSetQuaternion(geom, (h, h, 0, 0))
        return geom

    def _adopt(self, geom: c.dGeomID) -> None:
        self._data = _adopted(self._data, c.dGeomHeightfieldGetHeightfieldData(geom), c.dGeomHeightfieldDataDestroy)


@dataclasses.dataclass
class Material:
    """The surface of a geom. friction: Coulomb's coefficient; bounce: restitution, 0 to 1; compliance: m/N. The rules say how
    the coefficients of a pair follow from those of its two geoms; of two priorities the larger one's geom alone says them.
    friction_axis: in the geom's frame; friction counts along it, cross_friction across it (an ellipse); 0: in all directions.
    kind: 1 to 255; the other geom's pair material of that number (``geom.set_pair_material``) counts alone, if it has one."""
    friction: float = 0.6
    bounce: float = 0.0
    bounce_speed: float = 1.0
    surface_velocity: tuple[float, float, float] = (0.0, 0.0, 0.0)
    rolling_friction: float = 0.0
    compliance: float = 0.0
    damping_time: float = 0.0
    friction_rule: CombineRule = CombineRule.DEFAULT
    bounce_rule: CombineRule = CombineRule.DEFAULT
    rolling_friction_rule: CombineRule = CombineRule.DEFAULT
    priority: int = 0
    cross_friction: float = 0.6
    friction_axis: tuple[float, float, float] = (0.0, 0.0, 0.0)
    kind: int = 0

    def _to_c(self) -> c.dMaterial:
        material = c.dMaterial()
        for field in dataclasses.fields(self):
            setattr(material, field.name, getattr(self, field.name))
        return material

    @classmethod
    def _from_c(cls, material: c.dMaterial) -> Material:
        values = {f.name: getattr(material, f.name) for f in dataclasses.fields(cls)}
        for name in ("surface_velocity", "friction_axis"):
            values[name] = tuple(float(v) for v in values[name][:3])
        for name in ("friction_rule", "bounce_rule", "rolling_friction_rule"):
            values[name] = CombineRule(values[name])
        return cls(**values)


describe_fields(Sphere, Box, Capsule, Cylinder, Cone, TaperedCapsule, Ellipsoid, Plane, Convex, Mesh, Decomposition, HeightField, Material)
