# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What acts on links and joints, reads them, or holds them together."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._handle import FloatArray, Value
from ._geoms import Geom
from ._links import Joint, Site
from ._part import Part
from ._tree import Element
from ._values import name_of, number, reference, span, text, vector


class Actuator(Part):
    """What a control acts on. kind: motor, position, velocity, general and the other actuators of MJCF."""

    __slots__ = ()
    joint = reference("joint", "The name of the joint that it pulls, or None.")
    tendon = reference("tendon", "The name of the tendon that it pulls, or None.")
    site = reference("site", "The name of the site that it pushes, or None.")
    control_limits = span("ctrlrange", "ctrllimited", "What the control is clamped to; None: any control.")
    force_limits = span("forcerange", "forcelimited", "What its force is clamped to, before the gear; None: any force.")

    def _gear(self) -> FloatArray:
        return self.numbers("gear", [1])

    gear: Value[FloatArray, ArrayLike] = Value(_gear, lambda self, value: self.put_numbers("gear", value, min(max(np.size(value), 1), 6)),
                                               doc="The factor of its force; three numbers along the axes of a ball, six of a site.")

    @property
    def kind(self) -> str:
        """motor, position, velocity, general and so on."""
        return self.tag


class Sensor(Part):
    """A sensor of MJCF's kinds."""

    __slots__ = ()

    @property
    def kind(self) -> str:
        """jointpos, accelerometer and so on."""
        return self.tag

    @property
    def object(self) -> str | None:
        """The name of what it is on."""
        return next((name for word, _, name in self.references() if word != "refname"), None)


class Tendon(Part):
    """A weighted sum of joints' coordinates (``joints``), or a string along a path of sites and round geoms (``path``)."""

    __slots__ = ()
    limits = span("range", "limited", "The shortest and the longest it may be; None: no limits.")
    stiffness = number("stiffness", 0, "Of its spring.")
    damping = number("damping", 0, "Of its length's rate.")
    rest = text("springlength", "The length at which its spring rests, or two that it rests between; None: that of the described pose.")

    def _joints(self) -> dict[str, float]:
        return {one.words["joint"]: float(one.numbers("coef", [1])[0]) for one in self.children if one.tag == "joint"}

    def _put_joints(self, value: Mapping[str | Joint, float]) -> None:
        self.children[:] = []
        for joint, factor in value.items():
            self.add(Element("joint", {"joint": name_of(joint)}))["coef"] = factor

    joints: Value[dict[str, float], Mapping[Any, float]] = Value(_joints, _put_joints, doc="The factor of each joint.")

    def _path(self) -> list[str]:
        return [one.words[one.tag] for one in self.children if one.tag in ("site", "geom")]

    def _put_path(self, value: Sequence[str | Site | Geom | tuple[str | Geom, str | Site | None]]) -> None:
        owner = self.description
        self.children[:] = []
        for part in value:
            one, side = part if isinstance(part, tuple) else (part, None)
            name = name_of(one)
            tag = "geom" if isinstance(one, Geom) or side is not None or (
                isinstance(one, str) and owner is not None and name not in owner.sites.names and name in owner.geoms.names) else "site"
            its = self.add(Element(tag, {tag: name}))
            if side is not None:
                its["sidesite"] = name_of(side)

    path: Value[list[str], Sequence[Any]] = Value(_path, _put_path, doc="Names of sites, and of spheres and cylinders that it goes round; set a geom "
                                                  "as (geom, site) where the site says on which side.")


class Coupling(Part):
    """What two joints, or two tendons, are to each other: q1 - r1 = c0 + c1 (q2 - r2) + ..., r being their references."""

    __slots__ = ()
    joint1 = reference("joint1", "The joint that follows.")
    joint2 = reference("joint2", "The joint that leads; None: the first one is held.")
    coefficients = vector("polycoef", (0, 1, 0, 0, 0), "c0, c1, ... c4.")


class Loop(Part):
    """Two links held together: at a point (connect) or altogether (weld)."""

    __slots__ = ()
    link1 = reference("body1", "The first link.")
    link2 = reference("body2", "The second link; None: the world.")
    anchor = vector("anchor", (0, 0, 0), "The point, in the first link's frame of a connect, in the second's of a weld, m.")


class Exclusion(Part):
    """Two links that do not touch."""

    __slots__ = ()
    link1 = reference("body1", "The first link.")
    link2 = reference("body2", "The second link.")
