# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Recordings of worlds: to look at in a notebook or a browser, to plot, to compare; and pictures."""
from __future__ import annotations

import os
import struct
import weakref
from types import TracebackType
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from numpy.typing import ArrayLike

from . import _c, c
from ._handle import FloatArray

if TYPE_CHECKING:
    from .body import Body
    from .world import World


def _use_page() -> None:
    """Say where the replay page is, unless the user has."""
    page = os.path.join(os.path.dirname(__file__), "replay.html")
    if os.path.isfile(page):
        os.environ.setdefault("EPODE_PAGE", page)


def _png(pixels: bytes, width: int, height: int) -> bytes:
    """An 8-bit RGB PNG file of rows from the top."""
    import zlib  # as other modules here: an import of the package does not wait for them
    rows = np.frombuffer(pixels, np.uint8).reshape(height, 3 * width)
    filtered = np.concatenate([np.zeros((height, 1), np.uint8), rows], axis=1).tobytes()

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(filtered, 6)) + chunk(b"IEND", b"")


def _unpickled(file: bytes) -> Recording:
    """The recording that ``Recording.__reduce__`` has written."""
    import tempfile
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "states.epr")
        with open(path, "wb") as to:
            to.write(file)
        return Recording.load(path)


class Recording:
    """The states of a world, from ``World.record`` or a file: the initial one, then one after each step.

    ``save`` writes .epr (which the command replays, compares and converts), .glb (Blender), .html (a page for any
    browser) or .csv. In a notebook a recording shows itself as that page."""

    def __init__(self, world: World | None = None, title: str = "") -> None:
        """A recording of the world as it is now; ``World.record`` goes on with each step. title: what the page is called. Without a
        world it is empty."""
        self._data = _c.WorldRecording()
        self._world = weakref.ref(world) if world is not None else None
        self._known: dict[Any, Any] = {}
        self._edition = -1
        self._time = 0.0
        if world is not None:
            self._data.about([("source", "python"), ("scene", title or "epode"), ("contacts", "managed"), ("precision", "double"),
                              ("library_kind", "Epode"), ("library_configuration", c.dGetConfiguration())])
            self._take(0.0, 0.0)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Recording:
        """A recording from an .epr file."""
        recording = cls()
        recording._data.load(os.fspath(path))
        return recording

    # ---- being made ----

    def _sync(self, world: World) -> None:
        """Tell the recorder what was made and destroyed since the last state."""
        if self._edition == world._edition:
            return
        self._edition = world._edition
        groups = (("body", world._bodies), ("geom", world._geoms), ("joint", world._joints))
        living = {one: kind for kind, group in groups for one in group.values()}
        for one in [one for one in self._known if one not in living]:
            kind, handle = self._known.pop(one)
            getattr(self._data, f"remove_{kind}")(handle)
        for one, kind in living.items():
            if one not in self._known:
                self._known[one] = kind, one._handle
                getattr(self._data, f"add_{kind}")(one._handle)

    def _take(self, h: float, milliseconds: float) -> None:
        world = self._world() if self._world is not None else None
        if world is not None:
            self._sync(world)
            self._time += h
            self._data.take_state(world._handle, self._time, h, milliseconds)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickles hold the states so far, as the .epr file has them; their recording goes on with no world."""
        import tempfile
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "states.epr")
            self.save(path)
            with open(path, "rb") as file:
                return _unpickled, (file.read(),)

    def stop(self) -> None:
        """Record no more."""
        world = self._world() if self._world is not None else None
        if world is not None and world._recording is self:
            world._recording = None
        self._world = None
        self._known.clear()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.stop()

    # ---- what is in it ----

    def __len__(self) -> int:
        return len(self._data)

    def __repr__(self) -> str:
        return f"<epode.Recording, {len(self)} states, {self.times[-1] if len(self) else 0:g} s>"

    def _state(self, state: int) -> int:
        number = state + len(self) if state < 0 else state
        if not 0 <= number < len(self):
            raise IndexError(f"state {state}: the recording has {len(self)}")
        return number

    @property
    def times(self) -> FloatArray:
        """The time of each state, s."""
        return self._data.figures()[:, 0]

    @property
    def kinetic(self) -> FloatArray:
        """The kinetic energy of each state, J."""
        return self._data.figures()[:, 2]

    @property
    def potential(self) -> FloatArray:
        """The potential energy of each state, J."""
        return self._data.figures()[:, 3]

    @property
    def contact_counts(self) -> FloatArray:
        """How many points of contact each state has."""
        return self._data.figures()[:, 4]

    @property
    def step_milliseconds(self) -> FloatArray:
        """How long each step took, ms."""
        return self._data.figures()[:, 5]

    def bodies(self, state: int = -1) -> FloatArray:
        """The bodies of a state: a row each of position 3, quaternion 4, velocity 3, angular velocity 3."""
        return self._data.bodies(self._state(state))

    def trajectory(self, body: int) -> FloatArray:
        """A body, by its number in the recording, through all states: rows as ``bodies`` has them, NaN where it is not there."""
        rows = np.full((len(self), 13), np.nan)
        for state in range(len(self)):
            living = self._data.living(state)
            if body in living:
                rows[state] = self._data.bodies(state)[living.index(body)]
        return rows

    def hash(self, state: int = -1) -> int:
        """A number that is the same for the same bits of all bodies."""
        return self._data.hash(self._state(state))

    # ---- to look at ----

    def save(self, path: str | os.PathLike[str], fps: float = 60) -> None:
        """Write the recording: .epr, .glb, .html or .csv, by the ending of path; fps: of .glb and .html."""
        _use_page()
        self._data.save(os.fspath(path), fps)

    def html(self, fps: float = 60) -> str:
        """The replay page, one file for any browser."""
        import tempfile
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "page.html")
            self.save(path, fps)
            with open(path, encoding="utf-8") as file:
                return file.read()

    def _repr_html_(self) -> str:
        import html
        page = html.escape(self.html(), quote=True)
        return f'<iframe srcdoc="{page}" style="width: 100%; height: 640px; border: 0" allowfullscreen></iframe>'

    def view(self, **settings: Any) -> None:
        """Open a window and play the recording until the user closes it (``epode.viewer.show``)."""
        from .viewer import show
        show(self, **settings)

    def picture(self, path: str | os.PathLike[str] | None = None, *, state: int = -1, width: int = 1280, height: int = 720,
                eye: ArrayLike | None = None, target: ArrayLike | None = None, up: ArrayLike | None = None, field: float = 0.0) -> bytes:
        """A state as a PNG file, drawn without a display: from eye towards target, or from where all can be seen. up: what is up in it, z
        without it; field: of view, from the lowest to the highest row, rad; 0: 0.56. Returns its bytes, and writes them to path."""
        for name, side in (("width", width), ("height", height)):
            if not 1 <= side <= 4096:
                raise ValueError(f"{name} {side}: 1 to 4096 expected")
        png = _png(self._data.picture(self._state(state), width, height, eye, target, up, field), width, height)
        if path is not None:
            with open(path, "wb") as file:
                file.write(png)
        return png
