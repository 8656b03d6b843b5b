# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Properties of elements: an attribute of MJCF as a Python value."""
from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from typing import Any, Generic, TypeVar, overload

from numpy.typing import ArrayLike

from .._handle import FloatArray, Value
from ._tree import Element, Word, hint
from ._turns import matrix_of, turn, turn_of_axes, turn_of_euler, turn_of_z

E = TypeVar("E", bound=Element)


def number(word: str, default: float, doc: str) -> Value[float, float]:
    """A number."""
    return Value(lambda self: float(self.numbers(word, [default])[0]), lambda self, value: self.put_numbers(word, value, 1), doc=doc)


def vector(word: str, default: Sequence[float], doc: str) -> Value[FloatArray, ArrayLike]:
    """As many numbers as the default has."""
    return Value(lambda self: self.numbers(word, default), lambda self, value: self.put_numbers(word, value, len(default)), doc=doc)


def text(word: str, doc: str) -> Value[str | None, str | None]:
    """A word or a name; None: there is none."""
    return Value(lambda self: self[word], lambda self, value: self.__setitem__(word, value), doc=doc)


def span(word: str, flag: str, doc: str) -> Value[tuple[float, float] | None, Sequence[float] | None]:
    """Two numbers, or None."""
    def read(self: Element) -> tuple[float, float] | None:
        if self[word] is None or self[flag] == "false":
            return None
        low, high = self.numbers(word)
        return float(low), float(high)

    def put(self: Element, value: Sequence[float] | None) -> None:
        if value is None:
            self[word] = self[flag] = None
            return
        low, high = value
        if not low <= high:
            raise ValueError(f"{self.title}: limits end before they begin: {value!r}")
        self.put_numbers(word, value, 2)
        self[flag] = None
    return Value(read, put, doc=doc)


def name_of(one: Element | str) -> str:
    """Of an element, or the name itself."""
    if isinstance(one, str):
        return one
    name = one["name"]
    if name is None:
        raise ValueError(f"{one.title} has no name")
    return name


def reference(word: str, doc: str) -> Value[str | None, Element | str | None]:
    """The name of another element, which may be set by the element."""
    return Value(lambda self: self[word], lambda self, value: self.__setitem__(word, None if value is None else name_of(value)), doc=doc)


def put_pose(self: Element, position: ArrayLike | None, quaternion: ArrayLike | None) -> None:
    """What is None stays."""
    if position is not None:
        self.put_numbers("pos", position, 3)
    if quaternion is not None:
        self.put_numbers("quat", quaternion, 4)
        if not self.numbers("quat").any():
            raise ValueError(f"{self.title}: a quaternion of zeros is no turn")


def put_words(self: Element, words: dict[str, Word | None]) -> None:
    """Set properties and attributes by their names. What says a turn otherwise, in rad, becomes a quaternion, fromto a pose and a size."""
    for word, value in words.items():
        if word in ("class", "childclass"):
            raise ValueError(f"{self.title}: a description has no default classes: state what is meant")
        if isinstance(getattr(type(self), word, None), property):
            setattr(self, word, value)
        elif word == "euler":
            put_pose(self, None, turn_of_euler(value))  # type: ignore[arg-type]
        elif word == "axisangle":
            put_pose(self, None, turn(list(value)[:3], float(list(value)[3])))  # type: ignore[arg-type]
        elif word == "zaxis":
            put_pose(self, None, turn_of_z(value))  # type: ignore[arg-type]
        elif word == "xyaxes":
            put_pose(self, None, turn_of_axes(list(value)[:3], list(value)[3:]))  # type: ignore[arg-type]
        elif word != "fromto":
            self[word] = value
    if words.get("fromto") is not None:
        put_ends(self, words["fromto"])


def put_ends(self: Element, ends: Any) -> None:
    """fromto: along z from one point to another; half of their distance is its half length."""
    probe = Element(self.tag)
    probe.put_numbers("fromto", ends, 6)
    a, b = probe.numbers("fromto")[:3], probe.numbers("fromto")[3:]
    length = float(((b - a) @ (b - a)) ** 0.5)
    if length == 0:
        raise ValueError(f"{self.title}: fromto is one point")
    put_pose(self, (a + b) / 2, turn_of_z(b - a))
    size = self.numbers("size")
    across = size[:1] if self["type"] in ("capsule", "cylinder", None) else [size[0], size[1] if len(size) > 1 else size[0]]
    self["size"] = [*across, length / 2]


def moved(element: Element, position: FloatArray, quaternion: FloatArray) -> None:
    """Let a pose stand in a frame that has this pose itself."""
    from .._poses import _product
    q = element.numbers("quat", (1, 0, 0, 0))
    put_pose(element, position + matrix_of(quaternion) @ element.numbers("pos", (0, 0, 0)), _product(quaternion, q / (q @ q) ** 0.5))


class Elements(Sequence[E], Generic[E]):
    """Elements of one kind, in the text's order: by number or by name; ``in`` knows names and elements."""

    def __init__(self, find: Callable[[], Iterator[E]], what: str) -> None:
        self._find, self._what = find, what

    def _all(self) -> list[E]:
        return list(self._find())

    @property
    def names(self) -> list[str]:
        """Of all that have one."""
        return [name for name in (one["name"] for one in self._find()) if name is not None]

    def __len__(self) -> int:
        return len(self._all())

    def __iter__(self) -> Iterator[E]:
        return iter(self._all())

    @overload
    def __getitem__(self, key: int | str) -> E: ...
    @overload
    def __getitem__(self, key: slice) -> list[E]: ...
    def __getitem__(self, key: int | str | slice) -> E | list[E]:
        if not isinstance(key, str):
            return self._all()[key]
        for one in self._find():
            if one["name"] == key:
                return one
        raise KeyError(f"no {self._what} is called {key!r}{hint(key, self.names)}")

    def __contains__(self, key: object) -> bool:
        return any(one is key or (isinstance(key, str) and one["name"] == key) for one in self._find())

    def __repr__(self) -> str:
        return repr(self._all())


Path = str | os.PathLike[str]
