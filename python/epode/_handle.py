# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What bodies, joints, geoms and worlds share: an object holds a handle until it, or its world, is destroyed."""
from .errors import DeadHandleError


class Object:
    """An object of the engine. After ``destroy`` every call raises DeadHandleError."""

    __slots__ = ("_live", "world", "__weakref__")

    @property
    def _handle(self):
        handle = self._live
        if handle is None:
            raise DeadHandleError(f"this {type(self).__name__} has been destroyed")
        return handle

    @property
    def alive(self):
        """False after the object, or its world, has been destroyed."""
        return self._live is not None

    def __repr__(self):
        return f"<epode.{type(self).__name__}{'' if self.alive else ', destroyed'}>"


def reads(function, doc):
    """A property that a C function returns."""
    return property(lambda self: function(self._handle), doc=doc)


def reads_and_sets(get, put, doc):
    """A property of one value."""
    return property(lambda self: get(self._handle), lambda self, value: put(self._handle, value), doc=doc)


def vector(get, put, doc):
    """A property of three numbers, which C takes one by one."""
    def assign(self, value):
        x, y, z = value
        put(self._handle, x, y, z)
    return property(lambda self: get(self._handle), assign, doc=doc)


def flag(get, put, doc):
    """A property that is true or false."""
    return property(lambda self: bool(get(self._handle)), lambda self, value: put(self._handle, int(bool(value))), doc=doc)


def switch(get, on, off, doc):
    """A property that is true or false, and has a function for each."""
    return property(lambda self: bool(get(self._handle)), lambda self, value: (on if value else off)(self._handle), doc=doc)
