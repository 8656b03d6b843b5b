# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Which class an element has."""
from __future__ import annotations

from ._acting import Actuator, Coupling, Exclusion, Loop, Sensor, Tendon
from ._geoms import Geom, MeshAsset
from ._links import Joint, Link, Site
from ._part import Part
from ._tree import Element

KINDS: dict[str, type[Part]] = {"body": Link, "joint": Joint, "geom": Geom, "site": Site, "actuator": Actuator, "sensor": Sensor,
                                "tendon": Tendon, "mesh": MeshAsset, "exclude": Exclusion}


def make(above: Element | None, tag: str, words: dict[str, str]) -> Element:
    """The element of a tag in another one."""
    if tag == "worldbody":
        return Link(tag, words)
    probe = Element(tag)
    object.__setattr__(probe, "_above", above)
    space = probe.space if above is not None else ""
    if space == "equality":
        return (Loop if tag in ("connect", "weld") else Coupling)(tag, words)
    kind = KINDS.get(space)
    return kind(tag, words) if kind is not None else Part(tag, words) if space else Element(tag, words)
