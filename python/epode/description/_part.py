# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What all parts of a description share: a name that others refer to, a place."""
from __future__ import annotations

from numpy.typing import ArrayLike

from .._handle import FloatArray, Value
from ._tree import Element
from ._values import put_pose, vector


def removed(part: Element) -> ValueError:
    """The error of a part that is in no description any more."""
    return ValueError(f"{part.title} has been removed from its description")


class Part(Element):
    """What has a name in a description."""

    __slots__ = ()

    def _rename(self, name: str) -> None:
        owner = self.description
        old = self["name"]
        if owner is not None:
            owner._check_name(self.space, name, self)
            if old is not None:
                owner._renamed(self.space, old, name)
        self.words["name"] = name

    name: Value[str, str] = Value(lambda self: self["name"] or "", lambda self, value: self._rename(value),
                                  doc="Its name; what refers to it follows a change.")

    def remove(self) -> list[str]:
        """Take it, what is in it, and all that refers to that out of the description. Returns what else went, a text each."""
        owner = self.description
        if owner is None:
            raise removed(self)
        return owner._remove(self)


class Placed(Part):
    """What has a pose in its link's frame, or in its parent's."""

    __slots__ = ()
    position = vector("pos", (0, 0, 0), "Where it is in its link's frame (of a link: in its parent's), m.")
    quaternion: Value[FloatArray, ArrayLike] = Value(lambda self: self.numbers("quat", (1, 0, 0, 0)),
                                                     lambda self, value: put_pose(self, None, value), doc="How it is turned there.")
