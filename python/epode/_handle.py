# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What bodies, joints, geoms and worlds share: an object holds a handle until it, or its world, is destroyed."""
from __future__ import annotations

import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Generic, Never, Self, TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import DeadHandleError

if TYPE_CHECKING:
    from .world import World

FloatArray = NDArray[np.float64]
T = TypeVar("T")
S = TypeVar("S", contravariant=True)


def three(value: Any, what: str = "") -> tuple[float, float, float]:
    """A vector as C takes it, number by number; ``what`` names it in the error; without it the property that is set does."""
    try:
        x, y, z = value
        return float(x), float(y), float(z)
    except (TypeError, ValueError):
        raise ValueError(f"{what or sys._getframe(1).f_code.co_name}: 3 numbers are expected, not {value!r}") from None


class Object:
    """An object of the engine. After ``destroy`` every call raises DeadHandleError."""

    __slots__ = ("_live", "world", "__weakref__")
    _live: Any
    world: World

    @property
    def _handle(self) -> Any:
        handle = self._live
        if handle is None:
            raise DeadHandleError(f"this {type(self).__name__} has been destroyed")
        return handle

    @property
    def alive(self) -> bool:
        """False after the object, or its world, has been destroyed."""
        return self._live is not None

    def __repr__(self) -> str:
        return f"<epode.{type(self).__name__}{'' if self.alive else ', destroyed'}>"


if TYPE_CHECKING:
    class Value(Generic[T, S]):
        """A property that is read as T and set from S."""

        def __init__(self, fget: Callable[[Any], T], fset: Callable[[Any, S], Any] | None = None, *, doc: str) -> None: ...
        @overload
        def __get__(self, instance: None, owner: type) -> Self: ...
        @overload
        def __get__(self, instance: object, owner: type) -> T: ...
        def __get__(self, instance: object | None, owner: type) -> Self | T: ...
        def __set__(self, instance: object, value: S) -> None: ...
else:
    class Value(property):
        """A property. Its functions bear its name, by which errors and tracebacks call them."""

        def __class_getitem__(cls, _):
            return cls

        def __set_name__(self, owner, name):
            for function in (self.fget, self.fset):
                if function is not None:
                    function.__code__ = function.__code__.replace(co_name=name, co_qualname=f"{owner.__name__}.{name}")


def reads(function: Callable[[Any], T], doc: str) -> Value[T, Never]:
    """A property that a C function returns."""
    return Value(lambda self: function(self._handle), doc=doc)


def reads_and_sets(get: Callable[[Any], T], put: Callable[[Any, S], Any], doc: str) -> Value[T, S]:
    """A property of one value."""
    return Value(lambda self: get(self._handle), lambda self, value: put(self._handle, value), doc=doc)


def share(get: Callable[[Any], float], put: Callable[[Any, float], Any], doc: str) -> Value[float, float]:
    """A property that is a share of something, from 0 to 1."""
    def assign(self: Any, value: float) -> None:
        if value < 0 or value > 1:  # C refuses what is no number
            raise ValueError(f"{sys._getframe().f_code.co_name}: a share, from 0 to 1, is expected, not {value!r}")
        put(self._handle, value)
    return Value(lambda self: get(self._handle), assign, doc=doc)


def vector(get: Callable[[Any], FloatArray], put: Callable[[Any, float, float, float], Any], doc: str) -> Value[FloatArray, ArrayLike]:
    """A property of three numbers, which C takes one by one."""
    def assign(self: Any, value: Any) -> None:
        put(self._handle, *three(value))
    return Value(lambda self: get(self._handle), assign, doc=doc)


def flag(get: Callable[[Any], int], put: Callable[[Any, int], Any], doc: str) -> Value[bool, object]:
    """A property that is true or false."""
    return Value(lambda self: bool(get(self._handle)), lambda self, value: put(self._handle, int(bool(value))), doc=doc)


def switch(get: Callable[[Any], int], on: Callable[[Any], Any], off: Callable[[Any], Any], doc: str) -> Value[bool, object]:
    """A property that is true or false, and has a function for each."""
    return Value(lambda self: bool(get(self._handle)), lambda self, value: (on if value else off)(self._handle), doc=doc)


def number_of(structure: Callable[[Any], Any], field: str, doc: str) -> Value[float, Never]:
    """A property that a structure of numbers, such as a report, has as a field."""
    return Value(lambda self: float(getattr(structure(self), field)), doc=doc)


def vector_of(structure: Callable[[Any], Any], field: str, doc: str) -> Value[FloatArray, Never]:
    """The same, of three numbers."""
    return Value(lambda self: np.array(getattr(structure(self), field), dtype=float), doc=doc)


def flag_of(structure: Callable[[Any], Any], field: str, doc: str) -> Value[bool, Never]:
    """The same, true or false."""
    return Value(lambda self: bool(getattr(structure(self), field)), doc=doc)


def settable(*classes: type) -> list[str]:
    """The names of the properties of classes that can be set."""
    return [name for one in classes for name, what in vars(one).items() if isinstance(what, property) and what.fset is not None]


def put_settings(one: Any, settings: dict[str, Any], known: list[str], kind: str) -> None:
    """Set properties of a new object by their names, of which it has those that are known."""
    for name, value in settings.items():
        if name not in known:
            raise TypeError(f"a {kind} has no {name}: {', '.join(known)}")
        setattr(one, name, value)


def describe_fields(*classes: type) -> None:
    """Give the constructors of dataclasses, which say nothing, the text of their class, which tells of its fields."""
    for one in classes:
        vars(one)["__init__"].__doc__ = one.__doc__
