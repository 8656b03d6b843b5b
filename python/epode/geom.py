# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Geoms: shapes that are somewhere."""
from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import c
from ._handle import FloatArray, Object, flag, reads_and_sets, three, vector
from .errors import BusyError
from .shapes import Material, Shape

if TYPE_CHECKING:
    from .body import Body
    from .world import World


_KINDS = {getattr(c, name): kind for name, kind in (
    ("dSphereClass", "sphere"), ("dBoxClass", "box"), ("dCapsuleClass", "capsule"), ("dCylinderClass", "cylinder"), ("dPlaneClass", "plane"),
    ("dConvexClass", "convex"), ("dTriMeshClass", "mesh"), ("dHeightfieldClass", "height field")) if hasattr(c, name)}


class Geom(Object):
    """A shape in a world, made by ``World.geom`` or with a body; ``shape`` is what it was made from."""

    __slots__ = ("shape", "body", "_key")

    def __init__(self, world: World, handle: c.dGeomID, shape: Shape, body: Body | None) -> None:
        """As ``World.geom`` does: handle is a geom in the world, of the shape, on the body."""
        self.world, self._live, self.shape, self.body, self._key = world, handle, shape, body, handle.id

    def __repr__(self) -> str:
        if not self.alive:
            return super().__repr__()
        try:
            kind = _KINDS.get(c.dGeomGetClass(self._handle), "shape")
        except BusyError:  # in a step of another thread
            return super().__repr__()
        return f"<epode.Geom: a {kind}{'' if self.body is None else f' on {self.body!r}'}>"

    position = vector(c.dGeomGetPosition, c.dGeomSetPosition, "In the world, m. Setting it moves the body, if there is one.")
    rotation = reads_and_sets(c.dGeomGetRotation, c.dGeomSetRotation, "3 x 3: the geom's coordinates to the world's.")
    quaternion = reads_and_sets(c.dGeomGetQuaternion, c.dGeomSetQuaternion, "w x y z.")
    category = reads_and_sets(c.dGeomGetCategoryBits, c.dGeomSetCategoryBits, "Bits of what the geom is.")
    collides_with = reads_and_sets(c.dGeomGetCollideBits, c.dGeomSetCollideBits, "Bits of what it collides with.")

    sensor = flag(c.dGeomGetSensor, c.dGeomSetSensor, "Whether it reports what overlaps it (``World.events``) and exerts no force.")

    @property
    def offset(self) -> FloatArray:
        """Where the geom sits on its body, in the body's frame, m."""
        return c.dGeomGetOffsetPosition(self._handle)

    @offset.setter
    def offset(self, value: ArrayLike) -> None:
        c.dGeomSetOffsetPosition(self._handle, *three(value, "offset"))

    @property
    def aabb(self) -> FloatArray:
        """The bounding box: [[min x, max x], [min y, max y], [min z, max z]]."""
        return c.dGeomGetAABB(self._handle).reshape(3, 2)

    @property
    def enabled(self) -> bool:
        """Whether the geom is seen by collision."""
        return bool(c.dGeomIsEnabled(self._handle))

    @enabled.setter
    def enabled(self, value: object) -> None:
        (c.dGeomEnable if value else c.dGeomDisable)(self._handle)

    @property
    def continuous(self) -> bool:
        """Whether a fast geom stops at what it would have passed."""
        return c.dGeomGetContinuous(self._handle) == c.dContinuousOn

    @continuous.setter
    def continuous(self, value: object) -> None:
        c.dGeomSetContinuous(self._handle, c.dContinuousOn if value else c.dContinuousOff)

    @property
    def material(self) -> Material:
        """A copy of the surface; assign it to change it."""
        material = c.dMaterial()
        c.dGeomGetMaterial(self._handle, material)
        return Material._from_c(material)

    @material.setter
    def material(self, value: Material | None) -> None:
        if value is not None and not isinstance(value, Material):
            raise TypeError(f"a Material, such as epode.Material(friction=0.5), is expected, not {value!r}")
        c.dGeomSetMaterial(self._handle, None if value is None else value._to_c())

    def set_face_materials(self, numbers: ArrayLike, materials: Mapping[int, Material | None]) -> None:
        """Give the triangles of a mesh, in their order, or the cells of a height field (cell (i, j) by i + j (samples along the first
        axis - 1)) materials by numbers from 1 to 255; 0, or one without a material, is the geom's own. Empty numbers: all are."""
        for number, material in materials.items():
            if material is not None and not isinstance(material, Material):
                raise TypeError(f"materials: a Material is expected, not {material!r}")
            c.dGeomSetFaceMaterial(self._handle, number, None if material is None else material._to_c())
        c.dGeomSetFaceMaterialNumbers(self._handle, np.asarray(numbers, np.uint8).ravel())

    def set_pair_material(self, kind: int, material: Material | None) -> None:
        """Against geoms whose material is of that kind (1 to 255) this material alone says friction, bounce, rolling friction and
        compliance; None: no longer. Of a mesh with ``set_face_materials`` it is the material of the faces of that number, too."""
        if material is not None and not isinstance(material, Material):
            raise TypeError(f"a Material, such as epode.Material(friction=0.5), is expected, not {material!r}")
        c.dGeomSetFaceMaterial(self._handle, kind, None if material is None else material._to_c())

    @property
    def face_numbers(self) -> NDArray[np.uint8]:
        """The numbers that ``set_face_materials`` has given to the faces; empty: all have the geom's own material."""
        return c.dGeomGetFaceMaterialNumbers(self._handle)

    def distance(self, other: Geom) -> float | None:
        """The signed distance to another geom, m (below 0: minus the depth); None where there is none."""
        result = c.dQueryDistance()
        found = c.dGeomGetDistance(self._handle, other._handle, float("inf"), result)
        return result.distance if found else None

    def collide(self, other: Geom, limit: int = 8) -> list[c.dContactGeom]:
        """The contacts with another geom, as a list of ``c.dContactGeom``."""
        return c.dCollide(self._handle, other._handle, limit)

    def triangles(self, segments: int = 24) -> FloatArray:
        """The surface of a convex solid to draw: an array of (n, 3 corners, 3), in the geom's frame."""
        return c.dGeomGetTriangles(self._handle, segments)

    def destroy(self) -> None:
        """Take the geom away."""
        c.dGeomDestroy(self._handle)
        self._dead()
        if self.body is not None and self in self.body.geoms:
            self.body.geoms.remove(self)

    def _dead(self) -> None:
        self._live = None
        self.world._geoms.pop(self._key, None)
        self.world._edition += 1
