# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What is wrong with a description before MJCF's reader sees it: names that nothing has, joints where none may be, start poses. The reader
judges the rest: words, numbers, masses."""
from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from ._acting import Actuator
from ._links import Joint, Link
from ._tree import hint

if TYPE_CHECKING:
    from ._description import Description

WHAT = {"body": "link"}


def problems_of(description: Description, starts_only: bool = False) -> list[str]:
    """A sentence each."""
    starts = _starts(description)
    return starts if starts_only else [*_references(description), *_joints(description), *starts]


def _references(description: Description) -> list[str]:
    names: dict[str, set[str]] = {"body": {"world"}}
    for one in description._top.walk():
        if one["name"] is not None:
            names.setdefault(one.space, set()).add(one.words["name"])
    out = []
    for one in description._top.walk():
        for word, space, name in one.references():
            known = names.get(space, set())
            if space and name not in known:
                title = one.title if one["name"] or one._above is None or not one._above["name"] else one._above.title
                out.append(f"{title}: there is no {WHAT.get(space, space)} {name!r}{hint(name, known)}")
        if isinstance(one, Actuator) and not any(True for _ in one.references()):
            out.append(f"{one.title} pulls nothing: set its joint or tendon")
    return out


def _joints(description: Description) -> list[str]:
    out = []
    for one in description._top.walk():
        if isinstance(one, Joint) and one.kind == "free" and (one.link.parent is not description.world or len(one.link.joints) > 1):
            out.append(f"{one.title} is free: only a link of the world may have a free joint, and no other then")
        if isinstance(one, Joint) and one.kind in ("hinge", "slide") and not np.linalg.norm(one.axis) > 1e-12:
            out.append(f"{one.title} has an axis without a direction: {one['axis']}")
        if isinstance(one, Link) and one.is_mocap and (one.parent is not description.world or len(one.joints)):
            out.append(f"{one.title} is moved by the program: it is a child of the world without joints")
    return out


def _starts(description: Description) -> list[str]:
    out = []
    sizes = {one.name: {"ball": 4, "free": 7}.get(one.kind, 1) for one in description.joints} if description.starts else {}
    for title, start in description.starts.items():
        tables = (("joint", start.positions, sizes), ("actuator", start.controls, dict.fromkeys(description.actuators.names, 1)),
                  ("link", start.mocap, dict.fromkeys((one.name for one in description.links if one.is_mocap), 7)))
        for what, values, known in tables:
            for name, value in values.items():
                if name not in known:
                    out.append(f"start {title!r}: there is no {what} {name!r}{hint(name, known)}")
                    continue
                parts: Iterable[Any] = value if what == "link" else (value,)  # type: ignore[assignment]
                numbers = np.concatenate([np.asarray(one, float).reshape(-1) for one in parts])
                if numbers.size != known[name] or not np.all(np.isfinite(numbers)):
                    out.append(f"start {title!r}: {what} {name!r} wants {known[name]} finite numbers: {value!r}")
    return out
