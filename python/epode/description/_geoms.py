# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Shapes of links, and the meshes that they show."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from .._handle import FloatArray, Value
from ..shapes import Box, Capsule, Convex, Cylinder, Ellipsoid, Mesh, Plane, Shape, Sphere
from ._part import Part, Placed, removed
from ._turns import turn_of_z
from ._values import Path, number, put_pose, text, vector

if TYPE_CHECKING:
    from ._links import Link


class Geom(Placed):
    """A shape of a link."""

    __slots__ = ()
    size = text("size", "Its sizes as MJCF has them; ``shape`` is easier.")
    density = number("density", 1000, "kg/m^3, where neither its mass nor its link's is stated.")
    color = vector("rgba", (0.5, 0.5, 0.5, 1), "Red, green, blue and opacity, 0 ... 1.")

    def _mass(self) -> float | None:
        return None if self["mass"] is None else float(self.numbers("mass")[0])

    mass: Value[float | None, float | None] = Value(_mass, lambda self, value: self.__setitem__("mass", value),
                                                    doc="kg; None: by its density.")

    def _friction(self) -> FloatArray:
        its = self.numbers("friction", (1, 0.005, 0.0001))
        return np.concatenate([its, np.array([1, 0.005, 0.0001])[len(its):]])

    def _put_friction(self, value: ArrayLike) -> None:
        its = np.atleast_1d(np.asarray(value, float))
        self.put_numbers("friction", its, min(max(its.size, 1), 3))

    friction: Value[FloatArray, ArrayLike] = Value(_friction, _put_friction, doc="Coefficient, torsional and rolling friction, m; one number "
                                                   "sets the first.")

    def _touches(self) -> bool:
        return bool(self.numbers("contype", [1])[0] or self.numbers("conaffinity", [1])[0])

    def _put_touches(self, value: bool) -> None:
        if not value or not self.touches:
            self["contype"] = self["conaffinity"] = None if value else 0

    touches: Value[bool, bool] = Value(_touches, _put_touches, doc="Whether it touches, or is only looked at.")

    @property
    def kind(self) -> str:
        """sphere, box, capsule, cylinder, ellipsoid, plane, mesh or hfield."""
        return self["type"] or "sphere"

    @property
    def link(self) -> Link:
        """Whose shape it is."""
        from ._links import Link
        if not isinstance(self._above, Link):
            raise removed(self)
        return self._above

    def _shape(self) -> Shape | None:
        s, kind = [float(one) for one in self.numbers("size")], self.kind
        if kind in ("capsule", "cylinder"):
            return (Capsule if kind == "capsule" else Cylinder)(s[0], 2 * s[1])
        if kind == "plane":
            return Plane()
        if kind in ("mesh", "hfield"):
            return None
        return Sphere(s[0]) if kind == "sphere" else Box(2 * s[0], 2 * s[1], 2 * s[2]) if kind == "box" else Ellipsoid(s[0], s[1], s[2])

    def _put_shape(self, shape: Shape | Path, scale: Any = None) -> None:
        owner = self.description
        if owner is None:
            raise removed(self)
        self["mesh"] = self["hfield"] = None
        if isinstance(shape, (str, os.PathLike)):
            self["type"], self["mesh"] = "mesh", owner.add_mesh(shape, scale=(1, 1, 1) if scale is None else scale).name
            return
        if scale is not None:
            raise ValueError(f"{self.title}: scale is for files of meshes")
        if isinstance(shape, (Mesh, Convex)):
            faces = shape.triangles if isinstance(shape, Mesh) else None
            points = shape.vertices if isinstance(shape, Mesh) else shape.points
            self["type"], self["mesh"] = "mesh", owner.add_mesh(vertices=points, triangles=faces).name
        elif isinstance(shape, Sphere):
            self["type"], self["size"] = "sphere", shape.radius
        elif isinstance(shape, (Capsule, Cylinder)):
            self["type"], self["size"] = "capsule" if isinstance(shape, Capsule) else "cylinder", (shape.radius, shape.length / 2)
        elif isinstance(shape, Box):
            self["type"], self["size"] = "box", (shape.x / 2, shape.y / 2, shape.z / 2)
        elif isinstance(shape, Ellipsoid):
            self["type"], self["size"] = "ellipsoid", (shape.x, shape.y, shape.z)
        elif isinstance(shape, Plane):
            normal = np.asarray(shape.normal, float)
            self["type"], self["size"] = "plane", (0, 0, 1)
            put_pose(self, normal / np.linalg.norm(normal) * shape.distance, turn_of_z(normal))
        else:
            raise TypeError(f"{self.title}: MJCF has no {type(shape).__name__}: Sphere, Capsule, Cylinder, Box, Ellipsoid, Plane, Convex, Mesh")

    shape: Value[Shape | None, Shape | Path] = Value(_shape, _put_shape, doc="As for bodies of worlds; None of meshes and height fields. A mesh "
                                                     "or the file of one may be set, too.")


class MeshAsset(Part):
    """A mesh that geoms show."""

    __slots__ = ()
    file = text("file", "Its file; None: its vertices stand in the description.")
    scale = vector("scale", (1, 1, 1), "Factors of its axes; negative ones mirror it.")
