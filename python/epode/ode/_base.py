# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What the objects of PyODE share: constants, methods made of functions, who owns what."""
from __future__ import annotations

import weakref
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import c

if TYPE_CHECKING:
    from ._dynamics import Body
    from ._geoms import GeomObject

Infinity = float("inf")
environment = None
AMotorUser, AMotorEuler = c.dAMotorUser, c.dAMotorEuler
ContactMu2, ContactFDir1, ContactBounce, ContactSoftERP = c.dContactMu2, c.dContactFDir1, c.dContactBounce, c.dContactSoftERP
ContactSoftCFM, ContactMotion1, ContactMotion2 = c.dContactSoftCFM, c.dContactMotion1, c.dContactMotion2
ContactSlip1, ContactSlip2, ContactApprox0 = c.dContactSlip1, c.dContactSlip2, c.dContactApprox0
ContactApprox1_1, ContactApprox1_2, ContactApprox1 = c.dContactApprox1_1, c.dContactApprox1_2, c.dContactApprox1

Vector = tuple[float, float, float]
_geoms: weakref.WeakValueDictionary[int, GeomObject] = weakref.WeakValueDictionary()
_bodies: weakref.WeakValueDictionary[c.dBodyID, Body] = weakref.WeakValueDictionary()


def InitODE() -> None:
    """Nothing: the library is ready when the module is."""


def CloseODE() -> None:
    """Nothing: the library is closed with the process."""


def _tuple(values: Any) -> Any:
    return tuple(float(v) for v in np.asarray(values).reshape(-1))


def _getter(function: Callable[..., Any], convert: Callable[[Any], Any] = _tuple) -> Any:
    def get(self: Any, *arguments: Any) -> Any:
        return convert(function(self._handle, *arguments))
    get.__doc__ = function.__doc__
    return get


def _same(value: Any) -> Any:
    return value


def _setter(function: Callable[..., Any]) -> Any:
    """A method that takes vectors where the function takes their numbers."""
    def put(self: Any, *arguments: Any) -> None:
        numbers: list[Any] = []
        for one in arguments:
            numbers.extend(one if np.ndim(one) else (one,))
        function(self._handle, *numbers)
    put.__doc__ = function.__doc__
    return put


def _whole_setter(function: Callable[..., Any]) -> Any:
    def put(self: Any, value: Any) -> None:
        function(self._handle, value)
    put.__doc__ = function.__doc__
    return put


class _Owner:
    """An object of the library that goes with its Python object."""

    _handle: Any = None
    _destroy: Callable[[Any], Any]

    def __del__(self) -> None:
        handle, self._handle = self._handle, None
        if handle is not None:
            try:
                self._destroy(handle)
            except Exception:  # gone with its world, or at the interpreter's end
                pass


def _known(handle: c.dGeomID | None) -> GeomObject | None:
    return None if handle is None else _geoms.get(handle.id)
