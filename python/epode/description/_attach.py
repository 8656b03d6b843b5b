# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Parts of descriptions taken out, put into others, and renamed. What refers to something goes where that goes."""
from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from .._handle import FloatArray
from .._poses import _product
from ._geoms import Geom
from ._links import Link, Site
from ._tree import SECTIONS, Element
from ._turns import matrix_of
from ._values import moved

if TYPE_CHECKING:
    from ._description import Description


def rename_all(description: Description, changed: Callable[[str], str]) -> None:
    """Every name and what refers to it, at once, so that two may change places."""
    names: dict[tuple[str, str], str] = {}
    for one in description._top.walk():
        if one["name"] is not None and one.space:
            new = changed(one.words["name"])
            if not isinstance(new, str) or not new or (one.space, new) in {(space, name) for (space, _), name in names.items()}:
                raise ValueError(f"{one.title} would be called {new!r}, which is no name, or that of another one")
            names[one.space, one.words["name"]] = new
    for one in description._top.walk():
        for word, space, name in list(one.references()):
            one.words[word] = names.get((space, name), name)
    for one in description._top.walk():
        if one["name"] is not None and one.space:
            one.words["name"] = names[one.space, one.words["name"]]
    for start in description.starts.values():
        for space, table in (("joint", start.positions), ("actuator", start.controls), ("body", start.mocap)):
            items: list[tuple[str, Any]] = list(table.items())
            table.clear()
            table.update({names.get((space, name), name): value for name, value in items})


def _users(description: Description) -> list[Element]:
    """What refers to others: elements of sections, tendons as wholes."""
    custom = description._top.child("custom")
    return [*(one for section in description._top.children if section.tag in SECTIONS - {"asset"} for one in section.children),
            *(element for one in (custom.children if custom is not None else []) for element in one.children)]


def _references_of(user: Element) -> set[tuple[str, str]]:
    return {(space, name) for one in user.walk() for _, space, name in one.references() if space}


def remove(description: Description, part: Element) -> list[str]:
    """Take a part out, and what refers to it, and so on. Returns what else went."""
    out = []
    gone = {(one.space, one.words["name"]) for one in part.walk() if one["name"] is not None}
    above = part._above
    if above is None or part.tag == "worldbody":
        raise ValueError(f"{part.title} cannot be removed")
    above.children.remove(part)
    object.__setattr__(part, "_above", None)
    found = True
    while found:
        found = False
        for user in [*_users(description), *(one for one in description._top.walk() if isinstance(one, Geom))]:
            if _references_of(user) & gone and user._above is not None:
                if user.section != "custom":
                    out.append(user.title)
                if user["name"] is not None:
                    gone.add((user.space, user.words["name"]))
                user._above.children.remove(user)
                object.__setattr__(user, "_above", None)
                found = True
    for start in description.starts.values():
        tables: tuple[tuple[str, dict[str, Any]], ...] = (("joint", start.positions), ("actuator", start.controls), ("body", start.mocap))
        for space, table in tables:
            for name in [name for name in table if (space, name) in gone]:
                del table[name]
    return out


def extract(description: Description, link: Link) -> Description:
    """A copy of which all else has been removed."""
    if link.description is not description or link.tag != "body":
        raise ValueError(f"{link.title} is no link of this description")
    out = description.copy()
    kept = out.links[link.name]
    inner = {(one.space, one.words["name"]) for one in kept.walk() if one["name"] is not None}
    for user in _users(out):  # what refers to anything else
        bodies = {pair for pair in _references_of(user) if pair[0] in ("body", "joint", "geom", "site")}
        if user._above is not None and bodies - inner:
            remove(out, user)
    above = kept._above
    assert above is not None
    above.children.remove(kept)
    for child in list(out.world.children):
        if child._above is not None:
            remove(out, child)
    out.world.add(kept)
    known = {(one.space, one.words["name"]) for one in out._top.walk() if one["name"] is not None}
    for start in out.starts.values():
        tables: tuple[tuple[str, dict[str, Any]], ...] = (("joint", start.positions), ("actuator", start.controls), ("body", start.mocap))
        for space, table in tables:
            for name in [name for name in table if (space, name) not in known]:
                del table[name]
    _drop_assets(out)
    out.name = link.name
    return out


def _drop_assets(description: Description) -> None:
    used = {pair for one in description._top.walk() for pair in _references_of(one) if pair[0] in ("mesh", "hfield", "material")}
    assets = description._section("asset")
    assets.children[:] = [one for one in assets.children if (one.tag, one.words.get("name", "")) in used]


def attach(to_all: Description, other: Description, place: Link | Site, prefix: str, position: ArrayLike, quaternion: ArrayLike) -> list[Link]:
    """See Description.attach."""
    if place.description is not to_all:
        raise ValueError(f"{place.title} is no part of this description")
    target = place.link if isinstance(place, Site) else place
    p, q = _frame(place, position, quaternion)
    copy = other.copy()
    rename_all(copy, lambda name: prefix + name)
    _free_asset_names(to_all, copy)
    for one in copy._top.walk():
        if one["name"] is not None and one.space and any(its["name"] == one["name"] for its in to_all._in_space(one.space)):
            raise ValueError(f"there is a {one.title} already: attach with another prefix")
    _meet(to_all, copy)
    _move_world(copy, p, q)
    if target.tag == "body":
        _fix(copy, target)
    for start in copy.starts.values():
        for joint in copy.joints:
            if joint.kind == "free" and joint.name in start.positions:
                start.positions[joint.name] = _moved_pose(p, q, start.positions[joint.name])
        start.mocap = {name: _split(_moved_pose(p, q, (*pose[0], *pose[1]))) for name, pose in start.mocap.items()}
    speeds = {joint.name: joint.max_velocity for joint in copy.joints if np.isfinite(joint.max_velocity)}
    out = []
    for child in list(copy.world.children):
        if isinstance(child, Geom) and child.kind in ("plane", "hfield"):
            continue
        if child.tag not in ("body", "geom", "site", "camera", "light"):
            continue
        moved(child, p, q)
        target.add(child)
        if isinstance(child, Link):
            out.append(child)
    _take_sections(to_all, copy)
    for name, value in speeds.items():
        to_all.joints[name].max_velocity = value
    _drop_assets(to_all)
    for name, start in copy.starts.items():
        mine = to_all.starts.setdefault(name, type(start)())
        mine.positions.update(start.positions), mine.controls.update(start.controls), mine.mocap.update(start.mocap)
    to_all.lost.extend(one for one in other.lost if one not in to_all.lost)
    return out


def _frame(place: Link | Site, position: ArrayLike, quaternion: ArrayLike) -> tuple[FloatArray, FloatArray]:
    p, q = np.asarray(position, float), np.asarray(quaternion, float)
    if p.shape != (3,) or q.shape != (4,) or not (np.all(np.isfinite(p)) and np.all(np.isfinite(q)) and q.any()):
        raise ValueError("a position of 3 finite numbers and a quaternion of 4, not all 0, are expected")
    q = q / np.linalg.norm(q)
    if isinstance(place, Site):
        turned = place.quaternion / np.linalg.norm(place.quaternion)
        p, q = place.position + matrix_of(turned) @ p, _product(turned, q)
    return p, q


def _moved_pose(p: FloatArray, q: FloatArray, pose: Any) -> tuple[float, ...]:
    its = np.asarray(pose, float)
    return (*map(float, p + matrix_of(q) @ its[:3]), *map(float, _product(q, its[3:])))


def _split(pose: tuple[float, ...]) -> tuple[tuple[float, ...], tuple[float, ...]]:
    return pose[:3], pose[3:]


def _meet(to_all: Description, copy: Description) -> None:
    """What URDF means by contacts stands in texts of <custom>; there is one meaning for all: ours, unless there are no links yet."""
    meanings = []
    for one in (to_all, copy):
        custom = one._top.child("custom")
        meanings.append([its for its in (custom.children if custom is not None else []) if its.tag == "text" and (its["name"] or "").startswith("epode_")])
    if not len(to_all.links):
        for its in meanings[1]:
            to_all._section("custom").add(its)
    elif [its.words for its in meanings[0]] != [its.words for its in meanings[1]]:
        sentence = "links that overlap, and frictions of pairs, mean in what was attached what they mean in what it was attached to"
        to_all.lost.extend([] if sentence in to_all.lost else [sentence])


def _free_asset_names(to_all: Description, copy: Description) -> None:
    for one in [one for one in copy._top.walk() if one.section == "asset" and one["name"] is not None]:
        name = one.words["name"]
        if any(its["name"] == name for its in to_all._in_space(one.space)):
            taken = {its["name"] for its in (*to_all._in_space(one.space), *copy._in_space(one.space))}
            new = next(f"{name}_{i}" for i in range(2, len(taken) + 3) if f"{name}_{i}" not in taken)
            copy._renamed(one.space, name, new)
            one.words["name"] = new


def _move_world(copy: Description, p: FloatArray, q: FloatArray) -> None:
    """Loops that are held to the copy's world, whose frame has this pose now."""
    back = q * (1, -1, -1, -1)
    inverse = np.concatenate([-(matrix_of(back) @ p), back])
    for loop in copy.loops:
        pose = loop.numbers("relpose", (0, 1, 0, 0, 0, 0, 0))
        if loop["body1"] == "world" and loop["anchor"] is not None and loop.tag == "connect":
            loop.anchor = p + matrix_of(q) @ loop.anchor
        if loop.tag != "weld" or not pose[3:].any():
            continue
        if loop["body1"] == "world":
            loop["relpose"] = _moved_pose(p, q, pose)
        elif loop["body1"] is not None and loop["body2"] in (None, "world"):
            loop["relpose"] = _moved_pose(pose[:3], pose[3:], inverse)


def _fix(copy: Description, target: Link) -> None:
    """On a link: no free joints, none that the program moves, and the other's world is that link."""
    for joint in [joint for joint in copy.joints if joint.kind == "free"]:
        remove(copy, joint)
    for link in copy.links:
        link.is_mocap = False
    for start in copy.starts.values():
        start.mocap.clear()
    for user in _users(copy):
        for one in user.walk():
            for word, space, name in list(one.references()):
                if space == "body" and name == "world":
                    one.words[word] = target.name
        if user.section == "equality" and user.tag in ("connect", "weld") and user["body1"] is not None and user["body2"] is None:
            user["body2"] = target.name


def _take_sections(to_all: Description, copy: Description) -> None:
    for section in copy._top.children:
        if section.tag in SECTIONS:
            for one in list(section.children):
                to_all._section(section.tag).add(one)

