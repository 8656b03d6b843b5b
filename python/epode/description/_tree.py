# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The tree of elements behind a description: MJCF's elements and attributes as texts, with angles in rad and every turn a
quaternion. A subclass for each kind of element gives its attributes types and names (``_elements``)."""
from __future__ import annotations

import difflib
import math
import xml.etree.ElementTree as xml
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any
from xml.sax.saxutils import quoteattr

import numpy as np

if TYPE_CHECKING:
    from ._description import Description

# What the name of an attribute's value is the name of, where it refers to another element; objname and refname say so themselves.
REFERENCES = {
    "joint": "joint", "joint1": "joint", "joint2": "joint", "jointinparent": "joint", "body": "body", "body1": "body", "body2": "body",
    "geom": "geom", "geom1": "geom", "geom2": "geom", "site": "site", "site1": "site", "site2": "site", "refsite": "site",
    "sidesite": "site", "slidersite": "site", "cranksite": "site", "tendon": "tendon", "tendon1": "tendon", "tendon2": "tendon",
    "actuator": "actuator", "mesh": "mesh", "hfield": "hfield", "material": "material", "camera": "camera"}
TYPED = {"objname": "objtype", "refname": "reftype"}
SECTIONS = {"actuator", "sensor", "equality", "contact", "tendon", "asset"}
Word = str | bool | float | Sequence[float] | Any


def hint(wrong: str, names: Iterable[str]) -> str:
    """; did you mean 'x'?, or nothing."""
    near = difflib.get_close_matches(wrong, list(names), 1)
    return f"; did you mean {near[0]!r}?" if near else ""


def text_of_number(value: float) -> str:
    """The shortest text that reads back as the same number."""
    value = float(value)
    return str(int(value)) if value.is_integer() and abs(value) < 1e15 else repr(value)


def text_of(value: Word) -> str:
    """A value as an attribute's text."""
    if isinstance(value, str):
        return value
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    numbers = [float(one) for one in np.asarray(value, float).reshape(-1)]
    if not all(math.isfinite(one) for one in numbers):
        raise ValueError(f"numbers that are finite are expected: {value}")
    return " ".join(map(text_of_number, numbers))


class Element:
    """An element of a description. ``element["solref"]`` reads and sets an attribute of MJCF by its name there, as text, number
    or sequence (None: it is left out); angles are rad."""

    __slots__ = ("tag", "words", "children", "_above")
    tag: str
    words: dict[str, str]
    children: list[Element]
    _above: Element | None

    def __init__(self, tag: str, words: dict[str, str] | None = None) -> None:
        put = object.__setattr__
        put(self, "tag", tag), put(self, "words", words or {}), put(self, "children", []), put(self, "_above", None)

    def __setattr__(self, name: str, value: Any) -> None:
        if not hasattr(type(self), name):
            names = [one for one in dir(type(self)) if not one.startswith("_")]
            raise AttributeError(f"{self.title} has no {name!r}{hint(name, names)}")
        object.__setattr__(self, name, value)

    def __reduce__(self) -> Any:
        raise TypeError(f"{self.title} is copied and pickled with its description")

    def __getitem__(self, word: str) -> str | None:
        return self.words.get(word)

    def __setitem__(self, word: str, value: Word | None) -> None:
        if word == "name":
            raise ValueError(f"{self.title}: set .name, which what refers to it follows")
        if value is None:
            self.words.pop(word, None)
        else:
            try:
                self.words[word] = text_of(value)
            except (TypeError, ValueError):
                raise ValueError(f"{self.title}: {word} is text, or numbers that are finite: {value!r}") from None

    def __repr__(self) -> str:
        return f"<epode.description.{type(self).__name__} {self.words.get('name', '')!r}>"

    @property
    def title(self) -> str:
        """How messages call it."""
        name = self.words.get("name")
        kind = type(self).__name__.lower() if type(self) is not Element else f"<{self.tag}>"
        link = "" if self._above is None or self._above.tag != "body" or self.tag == "body" else f" of link {self._above.words.get('name', '')!r}"
        return f"{kind} {name!r}{link}" if name else f"{kind}{link}"

    # ---- the tree ----

    def add(self, child: Element) -> Element:
        """Append a child; returns it."""
        object.__setattr__(child, "_above", self)
        self.children.append(child)
        return child

    def child(self, tag: str) -> Element | None:
        """The first child of a tag."""
        return next((one for one in self.children if one.tag == tag), None)

    def walk(self) -> Iterator[Element]:
        """The element and all in it, as they stand in a text."""
        stack = [self]
        while stack:
            one = stack.pop()
            yield one
            stack.extend(reversed(one.children))

    @property
    def top(self) -> Element:
        """The element that has all others in it."""
        one = self
        while one._above is not None:
            one = one._above
        return one

    @property
    def description(self) -> Description | None:
        """The description that it is part of; None: it has been removed."""
        return getattr(self.top, "owner", None)

    @property
    def section(self) -> str:
        """The section that it stands in: worldbody, actuator, sensor and the like."""
        one = self
        while one._above is not None and one._above._above is not None:
            one = one._above
        return one.tag

    @property
    def space(self) -> str:
        """Among which elements its name is the only one of its kind: body, joint, geom, site, tendon, actuator, sensor, equality, mesh
        and the like; empty: it has no name."""
        above = self._above
        if above is None or self.tag in ("worldbody", "inertial"):
            return ""
        if self.section == "worldbody":
            return {"freejoint": "joint"}.get(self.tag, self.tag)
        if above._above is None:
            return ""
        if self.section in ("actuator", "sensor", "equality", "tendon") and above.tag == self.section:
            return self.section
        return self.tag if self.section in ("asset", "contact", "keyframe") and above.tag == self.section else ""

    def references(self) -> Iterator[tuple[str, str, str]]:
        """(attribute, space, name) of what it refers to."""
        inside = self.section in SECTIONS
        for word, name in self.words.items():
            if word in TYPED:
                kind = self.words.get(TYPED[word], "")
                yield word, {"xbody": "body"}.get(kind, kind), name
            elif word in REFERENCES and (inside or word in ("mesh", "hfield", "material")):
                yield word, REFERENCES[word], name

    # ---- numbers ----

    def numbers(self, word: str, default: Sequence[float] = ()) -> np.ndarray[Any, np.dtype[np.float64]]:
        """An attribute's numbers, or the default; not to be written to."""
        text = self.words.get(word)
        out = np.array([float(one) for one in text.split()] if text is not None else default, float)
        out.setflags(write=False)
        return out

    def put_numbers(self, word: str, value: Any, count: int) -> None:
        """Set an attribute to so many finite numbers."""
        try:
            numbers = np.asarray(value, float)
        except (TypeError, ValueError):
            numbers = np.array([np.nan])
        if numbers.size != count or not np.all(np.isfinite(numbers)):
            raise ValueError(f"{self.title}: {word} is {'a number that is finite' if count == 1 else f'{count} numbers that are finite'}: {value!r}")
        self.words[word] = text_of(numbers)


class Top(Element):
    """The element <mujoco>, which knows its description."""

    __slots__ = ("owner",)
    owner: Description


def read(text: str, make: Callable[[Element | None, str, dict[str, str]], Element]) -> Element:
    """The tree of a text; make gives the element of a tag in another one."""
    source = xml.fromstring(text)
    top = make(None, source.tag, dict(source.attrib))
    stack = [(source, top)]
    while stack:
        one, element = stack.pop()
        for child in one:
            stack.append((child, element.add(make(element, child.tag, dict(child.attrib)))))
    return top


def written(top: Element) -> tuple[str, list[Element | None]]:
    """The text, an element a line, and which element each line begins."""
    lines: list[str] = ["<?xml version=\"1.0\"?>"]
    owners: list[Element | None] = [None, None]  # lines count from 1
    stack: list[tuple[Element, int, bool]] = [(top, 0, False)]
    while stack:
        one, depth, ends = stack.pop()
        owners.append(one)
        if ends:
            lines.append("  " * depth + f"</{one.tag}>")
            continue
        words = "".join(f" {word}={quoteattr(value)}" for word, value in one.words.items())
        lines.append("  " * depth + f"<{one.tag}{words}{'>' if one.children else '/>'}")
        if one.children:
            stack.append((one, depth, True))
            stack.extend((child, depth + 1, False) for child in reversed(one.children))
    return "\n".join(lines) + "\n", owners
