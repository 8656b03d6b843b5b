# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Windows on worlds and recordings: ``pip install epode[viewer]`` adds the package glfw, which has the window system's part.

>>> import epode
>>> from epode.viewer import Window
>>> world = epode.World()
>>> def show():
...     with Window(world) as window:
...         while window.is_open:
...             if not window.paused:
...                 world.step(0.01)
...             window.draw()

Mouse: left turns, right moves, the wheel comes nearer. Keys: space stops and goes on; while stopped the arrows right and left
show the state after and before; home shows everything; escape closes.
"""
from __future__ import annotations

import math
import time
from types import TracebackType
from typing import TYPE_CHECKING, Any, Self

import numpy as np

from . import _c
from ._handle import FloatArray
from .recording import Recording, _png

if TYPE_CHECKING:
    from .world import World

_KEPT = 200_000_000  # bytes of states that a window keeps, about


def _glfw() -> Any:
    try:
        import glfw  # type: ignore[import-not-found,import-untyped,unused-ignore]
    except ImportError as error:
        raise ImportError("windows need the package glfw: pip install epode[viewer]") from error
    return glfw


def turned(eye: FloatArray, target: FloatArray, azimuth: float, elevation: float) -> FloatArray:
    """Where an eye is after turning about a target, rad; it never passes over the pole."""
    arm = eye - target
    distance = float(np.linalg.norm(arm))
    up = float(np.clip(math.asin(np.clip(arm[2] / distance, -1, 1)) + elevation, -1.55, 1.55))
    around = math.atan2(arm[1], arm[0]) + azimuth
    return target + distance * np.array([math.cos(up) * math.cos(around), math.cos(up) * math.sin(around), math.sin(up)])


class Window:
    """A window on a world, which the program steps, or on a recording, which plays. ``draw`` shows the state now and takes
    the mouse and the keys; call it about 60 times a second from the thread that made the window."""

    def __init__(self, subject: World | Recording, *, width: int = 1280, height: int = 720, title: str | None = None) -> None:
        """Open a window. subject: a world, or a recording to play. width, height: in pixels. title: of the window."""
        self._window: Any = None
        self._painter: Any = None
        self._subject = subject
        self.paused = False
        self._film = subject if isinstance(subject, Recording) else Recording(subject)
        if len(self._film) == 0:
            raise ValueError("the recording is empty")
        self._shown = 0 if isinstance(subject, Recording) else len(self._film) - 1
        self._clock = time.perf_counter()
        self._played = 0.0
        try:
            self._open(width, height, title or f"epode: {type(subject).__name__}")
            self.look_at_all()
        except BaseException:
            self.close()
            raise

    def _open(self, width: int, height: int, title: str) -> None:
        for name, side in (("width", width), ("height", height)):
            if not 1 <= side <= 4096:
                raise ValueError(f"{name} {side}: 1 to 4096 expected")
        if not hasattr(_c, "_Painter"):
            raise RuntimeError("this build of epode draws no pictures: libepoxy-dev, libegl-dev and libstb-dev were not there")
        glfw = self._glfw = _glfw()
        if not glfw.init():
            raise RuntimeError("no window system answers; World.picture and Recording.save need none")
        for hint, value in ((glfw.CONTEXT_VERSION_MAJOR, 3), (glfw.CONTEXT_VERSION_MINOR, 3),
                            (glfw.OPENGL_PROFILE, glfw.OPENGL_CORE_PROFILE), (glfw.OPENGL_FORWARD_COMPAT, True), (glfw.DEPTH_BITS, 0)):
            glfw.window_hint(hint, value)
        self._window = glfw.create_window(width, height, title, None, None)
        if not self._window:
            raise RuntimeError("no window with OpenGL 3.3 can be opened")
        self._painter = self._current(_c._Painter)
        glfw.swap_interval(1)
        self._mouse = glfw.get_cursor_pos(self._window)
        glfw.set_key_callback(self._window, self._on_key)
        glfw.set_scroll_callback(self._window, lambda _, x, y: self._zoom(0.9 ** y))

    def _current(self, call: Any) -> Any:
        """Call something with this window's OpenGL context."""
        self._glfw.make_context_current(self._window)
        return call()

    # ---- what is seen ----

    @property
    def is_open(self) -> bool:
        """False after the user, or ``close``, has closed the window."""
        return self._window is not None and not self._glfw.window_should_close(self._window)

    @property
    def state(self) -> int:
        """The number of the state that is shown, of those that the window has seen or of the recording."""
        return self._shown

    @state.setter
    def state(self, number: int) -> None:
        self._shown = int(np.clip(number, 0, len(self._film) - 1))

    def look_at_all(self) -> None:
        """Move the eye to where the whole state is in sight."""
        width, height = self._size()
        self.eye, self.target = _c._camera(self._film._data, self._shown, width / height)

    def _size(self) -> tuple[int, int]:
        width, height = self._glfw.get_framebuffer_size(self._window)
        return min(max(width, 1), 4096), min(max(height, 1), 4096)

    def draw(self) -> bool:
        """Show the state now; returns ``is_open``."""
        if self._window is None:
            return False
        if self._glfw.window_should_close(self._window):
            self.close()
            return False
        self._advance()
        width, height = self._size()
        self._current(lambda: self._painter.draw(self._film._data, self._shown, width, height, self.eye, self.target))
        self._glfw.swap_buffers(self._window)
        self._glfw.poll_events()
        if self.is_open:
            self._use_mouse()
        return self.is_open

    def _advance(self) -> None:
        """A recording goes on with the clock, a world is looked at again, unless the window is paused."""
        now = time.perf_counter()
        passed, self._clock = min(now - self._clock, 0.25), now
        if self.paused:
            return
        if isinstance(self._subject, Recording):
            self._played += passed
            times = self._film.times
            if self._played > times[-1] - times[0]:
                self._played = 0.0
            self._shown = int(np.searchsorted(times, times[0] + self._played, side="right")) - 1
        else:
            self._subject._handle
            if len(self._film) * (len(self._subject.bodies) + 1) * 120 > _KEPT:
                self._film = Recording(self._subject)
            else:
                self._film._take(passed, 0.0)
            self._shown = len(self._film) - 1

    def picture(self) -> bytes:
        """What the window shows, as a PNG file."""
        width, height = self._size()

        def read() -> bytes:
            self._painter.draw(self._film._data, self._shown, width, height, self.eye, self.target)
            return _c._screen(width, height)
        pixels: bytes = self._current(read)
        return _png(pixels, width, height)

    # ---- the user ----

    def _on_key(self, window: Any, key: int, code: int, action: int, modifiers: int) -> None:
        if action != self._glfw.RELEASE:
            self._key(key)

    def _key(self, key: int) -> None:
        glfw = self._glfw
        if key == glfw.KEY_ESCAPE:
            glfw.set_window_should_close(self._window, True)
        elif key == glfw.KEY_SPACE:
            self.paused = not self.paused
        elif key == glfw.KEY_HOME:
            self.look_at_all()
        elif key in (glfw.KEY_RIGHT, glfw.KEY_LEFT) and self.paused:
            self.state += 1 if key == glfw.KEY_RIGHT else -1

    def _zoom(self, factor: float) -> None:
        self.eye = self.target + (self.eye - self.target) * factor

    def _use_mouse(self) -> None:
        glfw = self._glfw
        at, (x, y) = glfw.get_cursor_pos(self._window), self._mouse
        dx, dy, self._mouse = at[0] - x, at[1] - y, at
        if glfw.get_mouse_button(self._window, glfw.MOUSE_BUTTON_LEFT):
            self.eye = turned(self.eye, self.target, -0.008 * dx, 0.008 * dy)
        elif glfw.get_mouse_button(self._window, glfw.MOUSE_BUTTON_RIGHT):
            self._pan(dx, dy)

    def _pan(self, dx: float, dy: float) -> None:
        arm = self.target - self.eye
        right = np.cross(arm, (0, 0, 1))
        right /= max(float(np.linalg.norm(right)), 1e-9)
        up = np.cross(right, arm) / max(float(np.linalg.norm(arm)), 1e-9)
        step = 0.0015 * float(np.linalg.norm(arm)) * (up * dy - right * dx)
        self.eye, self.target = self.eye + step, self.target + step

    def close(self) -> None:
        """Close the window. A second time does nothing."""
        if self._window is not None:
            if self._painter is not None:
                self._current(self._painter.close)
            self._glfw.destroy_window(self._window)
        self._window = self._painter = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()


def show(subject: World | Recording, h: float = 0.01, *, stepper: str | None = None, **settings: Any) -> None:
    """Open a window and stay in it until the user closes it: a world is stepped by h seconds as the clock says, a recording
    plays. settings: those of ``Window``."""
    with Window(subject, **settings) as window:
        due = 0.0
        before = time.perf_counter()
        while window.is_open:
            now = time.perf_counter()
            if not isinstance(subject, Recording) and not window.paused:
                due = min(due + now - before, 0.05 + h)
                while due >= h:
                    subject.step(h, stepper=stepper)
                    due -= h
            before = now
            window.draw()
