# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Links, their joints and their named frames."""
from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._handle import FloatArray, Value
from ..shapes import Shape
from ._geoms import Geom
from ._part import Part, Placed, removed
from ._tree import Element, Word, hint
from ._turns import matrix_of
from ._values import Elements, Path, number, put_pose, put_words, span, vector

SPEEDS = "epode_max_velocity"  # robots/files/mjcf_custom.h


class Link(Placed):
    """A rigid part. Its joints, in their order, let it move against its parent; without one it is fixed to it. ``world`` is a link, too."""

    __slots__ = ()
    is_mocap: Value[bool, bool] = Value(lambda self: self["mocap"] == "true", lambda self, value: self.__setitem__("mocap", value or None),
                                        doc="Whether the program moves it (``Robot.mocap``): of a child of the world without joints.")
    weightlessness = number("gravcomp", 0, "The share of its weight that is taken off it, 0 ... 1.")

    @property
    def title(self) -> str:
        """How messages call it."""
        return "the world" if self.tag == "worldbody" else super().title

    @property
    def parent(self) -> Link | None:
        """The link that it hangs on; None of the world."""
        return self._above if isinstance(self._above, Link) else None

    def _of(self, kind: type[Any], what: str) -> Elements[Any]:
        return Elements(lambda: (one for one in self.children if isinstance(one, kind)), what)

    @property
    def links(self) -> Elements[Link]:
        """Those that hang on it."""
        return self._of(Link, "link")

    @property
    def joints(self) -> Elements[Joint]:
        """Between its parent and it."""
        return self._of(Joint, "joint")

    @property
    def geoms(self) -> Elements[Geom]:
        """Its shapes."""
        return self._of(Geom, "geom")

    @property
    def sites(self) -> Elements[Site]:
        """Its named frames."""
        return self._of(Site, "site")

    # ---- mass ----

    @property
    def mass(self) -> float | None:
        """kg; None: it is that of its geoms. Setting it scales the inertia, too."""
        inertial = self.child("inertial")
        return None if inertial is None else float(inertial.numbers("mass", [0])[0])

    @mass.setter
    def mass(self, value: float) -> None:
        inertial, old = self.child("inertial"), self.mass
        if inertial is None or not old:
            raise ValueError(f"{self.title} has no mass of its own to scale: set that of its geoms, or set_inertial(mass, inertia)")
        if not (np.isfinite(value) and value > 0):
            raise ValueError(f"{self.title}: a mass above 0 kg is expected: {value!r}")
        inertial["mass"] = value
        for word in ("diaginertia", "fullinertia"):
            if inertial[word] is not None:
                inertial[word] = inertial.numbers(word) * (value / old)

    @property
    def centre(self) -> FloatArray | None:
        """Of mass, in the link's frame, m; None: that of its geoms."""
        inertial = self.child("inertial")
        return None if inertial is None else inertial.numbers("pos", (0, 0, 0))

    @centre.setter
    def centre(self, value: ArrayLike) -> None:
        self._inertial().put_numbers("pos", value, 3)

    @property
    def inertia(self) -> FloatArray | None:
        """About the centre of mass in the link's axes, 3 x 3, kg m^2; None: that of its geoms."""
        inertial = self.child("inertial")
        if inertial is None:
            return None
        d, f = inertial.numbers("diaginertia", (0, 0, 0)), inertial.numbers("fullinertia")
        its = np.diag(d) if f.size == 0 else np.array([[f[0], f[3], f[4]], [f[3], f[1], f[5]], [f[4], f[5], f[2]]])
        turned = matrix_of(inertial.numbers("quat", (1, 0, 0, 0)))
        return np.asarray(turned @ its @ turned.T)

    @inertia.setter
    def inertia(self, value: ArrayLike) -> None:
        self.set_inertial(float(self._inertial().numbers("mass", [0])[0]), value, self.centre)

    def _inertial(self) -> Element:
        inertial = self.child("inertial")
        if inertial is None:
            raise ValueError(f"{self.title} takes its mass from its geoms: set_inertial(mass, inertia, centre) states it")
        return inertial

    def set_inertial(self, mass: float, inertia: ArrayLike, centre: ArrayLike | None = None) -> None:
        """State mass, kg, inertia about the centre of mass, 3 x 3 or its diagonal, kg m^2, and that centre, m; masses of geoms do not
        count then."""
        if not (np.isfinite(mass) and mass >= 0):
            raise ValueError(f"{self.title}: a mass of 0 kg or more is expected: {mass!r}")
        its = np.asarray(inertia, float)
        its = np.diag(its) if its.shape == (3,) else its
        if its.shape != (3, 3) or not np.allclose(its, its.T, rtol=1e-9, atol=0):
            raise ValueError(f"{self.title}: an inertia is 3 numbers, or 3 x 3 and symmetric")
        inertial = Element("inertial")
        inertial.put_numbers("pos", (0, 0, 0) if centre is None else centre, 3)
        inertial["mass"] = mass
        off = [its[0, 1], its[0, 2], its[1, 2]]
        inertial["fullinertia" if any(off) else "diaginertia"] = [*np.diagonal(its), *(off if any(off) else [])]
        old = self.child("inertial")
        if old is not None:
            self.children.remove(old)
        self.add(inertial)
        self.children.insert(0, self.children.pop())

    # ---- what is added ----

    def _added(self, part: Element, name: str | None, words: dict[str, Word | None]) -> Any:
        owner = self.description
        if owner is None:
            raise removed(self)
        object.__setattr__(part, "_above", self)  # for messages
        if name is not None:
            owner._check_name(part.space, name, part)
            part.words["name"] = name
        put_words(part, words)
        return self.add(part)

    def add_link(self, name: str, *, position: ArrayLike | None = None, quaternion: ArrayLike | None = None, **words: Word) -> Link:
        """A link that hangs on this one, fixed to it until it has joints."""
        link = Link("body")
        put_pose(link, position, quaternion)
        return self._added(link, name, dict(words))  # type: ignore[no-any-return]

    def add_joint(self, name: str, kind: str = "hinge", **words: Word | None) -> Joint:
        """A joint between the parent and this link: a hinge, slide, ball or free one. words: properties of ``Joint`` (axis, anchor,
        limits, damping and the like) and attributes of MJCF."""
        if self.tag == "worldbody":
            raise ValueError(f"the world has no joints: {name!r}")
        words.setdefault("axis", (0, 0, 1) if kind in ("hinge", "slide") else None)
        joint = Joint("joint", {"type": "hinge"})
        joint.kind = kind
        if words["axis"] is None:
            del words["axis"]
        return self._added(joint, name, dict(words))  # type: ignore[no-any-return]

    def add_geom(self, shape: Shape | Path | None = None, *, name: str | None = None, position: ArrayLike | None = None,
                 quaternion: ArrayLike | None = None, **words: Word | None) -> Geom:
        """A shape, which touches and, where the link does not state its mass, weighs 1000 kg/m^3. shape: ``epode.Box`` and the like, or the
        file of a mesh (scale: factors of its axes), which touches as its convex hull. words: properties of ``Geom`` (density, mass,
        friction, color, touches) and attributes of MJCF (type, size, fromto, in place of a shape)."""
        geom = Geom("geom")
        scale = words.pop("scale", None)
        if self.mass is not None and self.tag == "body" and ("mass" in words or "density" in words):
            raise ValueError(f"{self.title} states its mass, so that of a geom does not count: change Link.mass, or leave it out")
        size: dict[str, Word | None] = {word: words.pop(word) for word in ("type", "size") if word in words}
        self._added(geom, name, {})
        try:
            if shape is not None:
                geom._put_shape(shape, scale)
            put_pose(geom, position, quaternion)
            put_words(geom, {**size, **words})
        except BaseException:
            self.children.remove(geom)
            raise
        return geom

    def add_site(self, name: str, *, position: ArrayLike | None = None, quaternion: ArrayLike | None = None, **words: Word) -> Site:
        """A named frame: for tendons, sensors, inverse kinematics and to attach to."""
        site = Site("site")
        put_pose(site, position, quaternion)
        return self._added(site, name, dict(words))  # type: ignore[no-any-return]


class Joint(Part):
    """A joint between a link and its parent: its coordinate is 0 in the described pose, or ``reference``. rad or m, N m or N."""

    __slots__ = ()
    axis = vector("axis", (0, 0, 1), "Of a hinge or slide, in the link's frame.")
    anchor = vector("pos", (0, 0, 0), "A point of the axis, in the link's frame, m.")
    limits = span("range", "limited", "The lowest and the highest coordinate; None: no limits. Of a ball 0 and the largest angle.")
    reference = number("ref", 0, "The coordinate in the described pose.")
    spring_reference = number("springref", 0, "The coordinate at which its spring rests.")
    stiffness = number("stiffness", 0, "Of its spring, N m/rad or N/m.")
    damping = number("damping", 0, "N m s/rad or N s/m.")
    armature = number("armature", 0, "The inertia of its rotor, kg m^2 or kg.")
    friction = number("frictionloss", 0, "Dry friction, N m or N.")

    def _kind(self) -> str:
        return "free" if self.tag == "freejoint" else self["type"] or "hinge"

    def _put_kind(self, value: str) -> None:
        kinds = ("hinge", "slide", "ball", "free")
        if value not in kinds:
            raise ValueError(f"{self.title}: no joint is of kind {value!r}: {', '.join(kinds)}{hint(value, kinds)}")
        object.__setattr__(self, "tag", "joint")
        self["type"] = value
        for word in () if value in ("hinge", "slide") else ("axis",):
            self[word] = None

    kind: Value[str, str] = Value(_kind, _put_kind, doc="hinge, slide, ball or free.")

    def _max_force(self) -> float:
        return float(np.max(np.abs(self.numbers("actuatorfrcrange", [np.inf]))))

    def _put_max_force(self, value: float) -> None:
        self["actuatorfrcrange"] = None if value == np.inf else (-value, value)
        self["actuatorfrclimited"] = None

    max_force: Value[float, float] = Value(_max_force, _put_max_force, doc="What actuators may exert on it in all; infinity: any force.")

    def _speed(self, make: bool = False) -> Element | None:
        """Its line in <custom>, where limits of velocity stand that MJCF has no word for."""
        custom = self.top.child("custom")
        known = custom and next((one for one in custom.children if one["name"] == SPEEDS), None)
        found = known and next((one for one in known.children if one["objname"] == self["name"]), None)
        if found or not make or self.description is None:
            return found
        known = known or self.description._section("custom").add(Element("tuple", {"name": SPEEDS}))
        return known.add(Element("element", {"objtype": "joint", "objname": self.name}))

    def _max_velocity(self) -> float:
        its = self._speed()
        return float(its.numbers("prm")[0]) if its is not None else np.inf

    def _put_max_velocity(self, value: float) -> None:
        if not value > 0:
            raise ValueError(f"{self.title}: a limit of velocity is above 0: {value!r}")
        its = self._speed(make=value != np.inf)
        if its is not None and value != np.inf:
            its["prm"] = value
        elif its is not None and its._above is not None:
            its._above.children.remove(its)

    max_velocity: Value[float, float] = Value(_max_velocity, _put_max_velocity, doc="rad/s or m/s, as data for controllers; infinity: none.")

    @property
    def link(self) -> Link:
        """The link that it moves."""
        if not isinstance(self._above, Link):
            raise removed(self)
        return self._above


class Site(Placed):
    """A named frame of a link."""

    __slots__ = ()

    @property
    def link(self) -> Link:
        """Whose frame it is."""
        if not isinstance(self._above, Link):
            raise removed(self)
        return self._above
