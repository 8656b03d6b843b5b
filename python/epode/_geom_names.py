# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Names of a model's geoms, from what it is written as: MJCF has the links in their order, each with its geoms in theirs."""
from __future__ import annotations

import xml.etree.ElementTree as ElementTree


def _is_look(geom: ElementTree.Element) -> bool:
    return geom.get("contype") == "0" and geom.get("conaffinity") == "0"


def _walk(part: ElementTree.Element, out: list[list[str]]) -> None:
    mine: list[str] = []
    out.append(mine)
    for child in part:
        if child.tag == "geom" and not _is_look(child):
            mine.append(child.get("name", ""))
        elif child.tag == "body":
            _walk(child, out)


def names_of(mjcf: str) -> list[list[str]]:
    """Of the geoms of each link that are not looks alone; the world's first."""
    out: list[list[str]] = []
    world = ElementTree.fromstring(mjcf).find("worldbody")
    if world is not None:
        _walk(world, out)
    return out
