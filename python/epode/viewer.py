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

Mouse: left turns, right moves, the wheel comes nearer; with Ctrl, left pulls the body under the pointer by a spring while the world is
stepped, and right pushes it away. The panel on the left has buttons, and for each robot a slider for every control and every joint with an
axis: a joint stays where its slider is held, and then goes on from there.

Keys: space stops and goes on; while stopped the arrows right and left show the state after and before; C shows contacts and their forces, V
looks through the next camera of the robots' files, R records and saves, tab hides the panel; home shows everything; escape closes.
"""
from __future__ import annotations

import os
import time
import weakref
from types import TracebackType
from typing import TYPE_CHECKING, Any, Self

import numpy as np

from . import _c
from ._controls import rows_of
from ._hand import Hand, pick, strike
from ._handle import FloatArray
from ._panel import WIDTH, Button, Panel, Row, Title
from ._sight import Sight, contact_lines, line, turned
from .errors import RefusedError
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


def _free_path(path: str) -> str:
    """The path, or the first with a number behind it that is not there."""
    base, ending = os.path.splitext(path)
    number = 1
    while os.path.exists(path):
        number += 1
        path = f"{base}-{number}{ending}"
    return path


class Window:
    """A window on a world, which the program steps, or on a recording, which plays. ``draw`` shows the state now and takes
    the mouse and the keys; call it about 60 times a second from the thread that made the window."""

    def __init__(self, subject: World | Recording, *, width: int = 1280, height: int = 720, title: str | None = None, panel: bool = True,
                 contacts: bool = False, arrows: float = 0.3, push_speed: float = 1.0, record_to: str | os.PathLike[str] = "recording.epr") -> None:
        """Open a window. subject: a world, or a recording to play. width, height: in pixels. title: of the window. panel: whether a world's
        panel is shown, where the window is twice as wide. contacts: whether contacts are. arrows: how long the average weight of a body is as
        an arrow, m. push_speed: what a push gives the body's mass, m/s. record_to: where ``record`` saves (.epr, .glb, .html or .csv); a number
        is added where that file is there."""
        self._window: Any = None
        self._painter: Any = None
        self._subject = subject
        self.paused = False
        self.show_panel, self.show_contacts = panel, contacts
        self.arrows, self.push_speed, self.record_to = arrows, push_speed, os.fspath(record_to)
        self.camera: str | None = None
        self.recording: Recording | None = None
        self.note = ""
        self._hand: Hand | None = None
        self._grip = ""  # what the mouse holds: panel, hand, turn, move
        self._panel, self._edition = Panel([]), -1
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
        me = weakref.ref(self)

        def before_step(h: float) -> None:
            its = me()
            if its is not None:
                its._act(h)
        self._before_step = before_step
        if not isinstance(subject, Recording):
            subject._hands.append(before_step)

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
        self._mouse = self._pointer()
        glfw.set_key_callback(self._window, self._on_key)
        glfw.set_scroll_callback(self._window, lambda _, x, y: self._wheel(y))
        glfw.set_mouse_button_callback(self._window, self._on_button)

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

    @property
    def cameras(self) -> list[str]:
        """Names of the cameras of the files of the world's robots; ``camera`` is one of them, or None: the eye that the mouse moves."""
        if isinstance(self._subject, Recording):
            return []
        return [its.name for robot in self._subject.robots if robot.alive for its in robot.model.cameras if its.name]

    def look_at_all(self) -> None:
        """Move the eye to where the whole state is in sight."""
        _, width, height = self._scene()
        self.camera = None
        self.eye, self.target = _c._camera(self._film._data, self._shown, width / height)

    def _sight(self) -> Sight:
        if self.camera is not None and not isinstance(self._subject, Recording):
            for robot in self._subject.robots:
                if robot.alive and any(its.name == self.camera for its in robot.model.cameras):
                    return Sight(*robot._view(self.camera))
            self.camera = None
        return Sight(np.asarray(self.eye, float), np.asarray(self.target, float))

    def _size(self) -> tuple[int, int]:
        width, height = self._glfw.get_framebuffer_size(self._window)
        return min(max(width, 1), 4096), min(max(height, 1), 4096)

    def _scene(self) -> tuple[int, int, int]:
        """What the panel leaves free: where it begins, its width and its height, pixels."""
        width, height = self._size()
        left = WIDTH if self._has_panel else 0
        return left, width - left, height

    def _ray(self, sight: Sight, x: float, y: float) -> FloatArray:
        """The direction through a pixel of the window."""
        left, width, height = self._scene()
        return sight.ray(x - left, y, width, height)

    def draw(self) -> bool:
        """Show the state now; returns ``is_open``."""
        if self._window is None:
            return False
        if self._glfw.window_should_close(self._window):
            self.close()
            return False
        self._advance()
        self._current(self._paint)
        self._glfw.swap_buffers(self._window)
        self._glfw.poll_events()
        if self.is_open:
            self._use_mouse()
        return self.is_open

    def _paint(self) -> None:
        left, width, height = self._scene()
        sight = self._sight()
        self._painter.draw(self._film._data, self._shown, width, height, sight.eye, sight.target, sight.up, sight.field, self._lines(), left)
        if self._has_panel:
            self._make_rows()
            pixels = self._panel.pixels(height)
            self._painter.lay(pixels.tobytes(), WIDTH, height, 0, 0, height)

    def _lines(self) -> bytes:
        """What is drawn over the newest state: contacts, and what the mouse pulls."""
        if isinstance(self._subject, Recording) or self._shown != len(self._film) - 1:
            return b""
        rows = contact_lines(self._subject, self.arrows) if self.show_contacts else []
        if self._hand is not None and self._hand.body.alive:
            rows.append(line(self._hand.place, self._hand.goal))
        return np.array(rows, np.float32).tobytes()

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
            self._look(passed)

    def _look(self, passed: float) -> None:
        """The state of the world now becomes the newest one."""
        assert not isinstance(self._subject, Recording)
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
            self._paint()
            return _c._screen(width, height)
        pixels: bytes = self._current(read)
        return _png(pixels, width, height)

    # ---- the panel ----

    @property
    def _has_panel(self) -> bool:
        return self.show_panel and not isinstance(self._subject, Recording) and self._size()[0] >= 2 * WIDTH

    def _make_rows(self) -> None:
        """Make the rows again after something in the world was made or destroyed, but not while a slider is held."""
        assert not isinstance(self._subject, Recording)
        if self._edition != self._subject._edition and not self._panel.is_held:
            self._edition = self._subject._edition
            sliders = [row for robot in self._subject.robots if robot.alive for row in rows_of(robot)]
            offset = self._panel.offset
            self._panel = Panel(self._buttons() + sliders)
            self._panel.scroll(-offset, self._size()[1])
        self._panel.rows[4] = Title(self.note)
        self._panel.rows[2] = Button(f"camera: {self.camera or 'free'} (V)", self.next_camera, lambda: self.camera is not None)

    def _buttons(self) -> list[Row]:
        def pause() -> None:
            self.paused = not self.paused

        def contacts() -> None:
            self.show_contacts = not self.show_contacts
        return [Button("stop / go on (space)", pause, lambda: self.paused), Button("contacts (C)", contacts, lambda: self.show_contacts),
                Title(""), Button("record (R)", self.record, lambda: self.recording is not None), Title("")]

    def next_camera(self) -> None:
        """Look through the next camera of the robots' files; after the last one, freely again."""
        names = self.cameras
        place = names.index(self.camera) + 1 if self.camera in names else 0
        self.camera = names[place] if place < len(names) else None

    def record(self) -> None:
        """Record the world's steps from now on; called again, stop and save to ``record_to``. Only while the program makes no recording
        of its own."""
        if isinstance(self._subject, Recording):
            raise RefusedError("a recording plays: Recording.save writes it")
        if self.recording is not None:
            film, self.recording = self.recording, None
            film.stop()
            path = _free_path(self.record_to)
            film.save(path)
            self.note = f"saved {os.path.basename(path)}"
        elif self._subject._recording is not None:
            self.note = "the program records"
        else:
            self.recording = self._subject.record()
            self.note = "recording"

    # ---- the user ----

    def _act(self, h: float) -> None:
        """Before a step of the world: what the mouse holds."""
        self._panel.hold()
        if self._hand is not None:
            self._hand.pull(h)

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
        elif key == glfw.KEY_TAB:
            self.show_panel = not self.show_panel
        elif key == glfw.KEY_C:
            self.show_contacts = not self.show_contacts
        elif key == glfw.KEY_V:
            self.next_camera()
        elif key == glfw.KEY_R and not isinstance(self._subject, Recording):
            self.record()

    def _pointer(self) -> tuple[float, float]:
        """In pixels of the picture, from its upper left corner."""
        (x, y), (width, height) = self._glfw.get_cursor_pos(self._window), self._glfw.get_window_size(self._window)
        wide, high = self._size()
        return x * wide / max(width, 1), y * high / max(height, 1)

    def _wheel(self, turns: float) -> None:
        if self._has_panel and self._pointer()[0] < WIDTH:
            self._panel.scroll(30 * turns, self._size()[1])
        else:
            self._zoom(0.9 ** turns)

    def _on_button(self, window: Any, button: int, action: int, modifiers: int) -> None:
        if action == self._glfw.PRESS:
            self._press(*self._pointer(), button == self._glfw.MOUSE_BUTTON_LEFT, bool(modifiers & self._glfw.MOD_CONTROL))
        else:
            self._release()

    def _press(self, x: float, y: float, left: bool, control: bool) -> None:
        self._mouse = x, y
        if self._has_panel and x < WIDTH:
            self._grip = "panel"
            self._panel.press(x, y)
        elif control and not isinstance(self._subject, Recording):
            self._take(x, y, left)
        else:
            self._grip = "turn" if left else "move"

    def _take(self, x: float, y: float, left: bool) -> None:
        """Pull or push what is under the pointer."""
        assert not isinstance(self._subject, Recording)
        sight = self._sight()
        way = self._ray(sight, x, y)
        found = pick(self._subject, sight.eye, way)
        if found is None:
            self.note = "nothing that moves is there"
        elif left:
            self._hand, self._grip = Hand(*found), "hand"
        else:
            strike(*found, way, self.push_speed)

    def _release(self) -> None:
        self._panel.release()
        self._hand, self._grip = None, ""

    def _use_mouse(self) -> None:
        self._drag(*self._pointer())

    def _drag(self, x: float, y: float) -> None:
        """The mouse is there now, with what it holds."""
        dx, dy, self._mouse = x - self._mouse[0], y - self._mouse[1], (x, y)
        if self._grip == "panel":
            self._panel.drag(x)
            if self._panel.is_held and self.paused:
                self._look(0.0)
        elif self._grip == "hand" and self._hand is not None:
            sight = self._sight()
            depth = float((self._hand.goal - sight.eye) @ sight.axes()[2])
            way = self._ray(sight, x, y)
            self._hand.goal = sight.eye + depth / float(way @ sight.axes()[2]) * way
        elif self._grip and (dx or dy):
            self._leave_camera()
            if self._grip == "turn":
                self.eye = turned(self.eye, self.target, -0.008 * dx, 0.008 * dy)
            else:
                self._pan(dx, dy)

    def _leave_camera(self) -> None:
        """The eye goes on from where the camera of a file is."""
        if self.camera is not None:
            sight = self._sight()
            reach = float(np.linalg.norm(np.asarray(self.target) - self.eye))
            self.eye, self.target, self.camera = sight.eye, sight.eye + reach * sight.axes()[2], None

    def _zoom(self, factor: float) -> None:
        self._leave_camera()
        self.eye = self.target + (self.eye - self.target) * factor

    def _pan(self, dx: float, dy: float) -> None:
        right, up, _ = Sight(np.asarray(self.eye, float), np.asarray(self.target, float)).axes()
        step = 0.0015 * float(np.linalg.norm(self.target - self.eye)) * (up * dy - right * dx)
        self.eye, self.target = self.eye + step, self.target + step

    def close(self) -> None:
        """Close the window; a recording that it makes is stopped and saved. A second time does nothing."""
        if self.recording is not None:
            self.record()
        if not isinstance(self._subject, Recording) and getattr(self, "_before_step", None) in self._subject._hands:
            self._subject._hands.remove(self._before_step)
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
