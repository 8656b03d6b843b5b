# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A column of buttons and sliders as pixels, for windows: no toolkit is needed, and tests need no screen."""
from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence

import numpy as np

from ._letters import HIGH, Pixels, put_text

WIDTH = 280
_ROW, _EDGE, _BAR = 30, 10, 6
_BACK, _TEXT, _FAINT, _TRACK, _FILL, _KNOB = (30, 33, 40), (235, 236, 240), (150, 156, 168), (64, 70, 82), (72, 140, 220), (240, 240, 245)


@dataclasses.dataclass
class Title:
    """A line between groups."""
    text: str


@dataclasses.dataclass
class Button:
    """Something to click; is_on: drawn as pressed."""
    text: str
    click: Callable[[], None]
    is_on: Callable[[], bool] = lambda: False


@dataclasses.dataclass
class Slider:
    """A number between low and high: read tells it, and turn sets it, again and again while it is held."""
    text: str
    low: float
    high: float
    read: Callable[[], float]
    turn: Callable[[float], None]
    held: float | None = None

    def share(self) -> float:
        """Where the knob is, 0 to 1."""
        value = self.read() if self.held is None else self.held
        return float(np.clip((value - self.low) / (self.high - self.low), 0, 1)) if np.isfinite(value) else 0.5


Row = Title | Button | Slider


class Panel:
    """Rows from the top, and what the mouse does with them. Places are pixels from the upper left corner of the panel."""

    def __init__(self, rows: Sequence[Row]) -> None:
        """rows: from the top."""
        self.rows = list(rows)
        self.offset = 0  # how far it is scrolled, in pixels
        self._held: Slider | None = None

    @property
    def height(self) -> int:
        """Of all rows, in pixels."""
        return _ROW * len(self.rows) + 2 * _EDGE

    def scroll(self, by: float, height: int) -> None:
        """Move the rows by so many pixels, of a panel that shows `height` of them."""
        self.offset = int(np.clip(self.offset - by, 0, max(0, self.height - height)))

    def press(self, x: float, y: float) -> None:
        """The button of the mouse goes down."""
        number = int((y + self.offset - _EDGE) // _ROW)
        if not 0 <= number < len(self.rows):
            return
        row = self.rows[number]
        if isinstance(row, Button):
            row.click()
        elif isinstance(row, Slider):
            self._held = row
            self.drag(x)

    def drag(self, x: float) -> None:
        """The mouse is at x, the button still down."""
        its = self._held
        if its is not None:
            share = float(np.clip((x - _EDGE) / (WIDTH - 2 * _EDGE), 0, 1))
            its.held = its.low + share * (its.high - its.low)
            its.turn(its.held)

    def hold(self) -> None:
        """A step has been made: what is held is where the mouse holds it."""
        if self._held is not None and self._held.held is not None:
            self._held.turn(self._held.held)

    def release(self) -> None:
        """The button of the mouse goes up."""
        if self._held is not None:
            self._held.held, self._held = None, None

    @property
    def is_held(self) -> bool:
        """Whether a slider is."""
        return self._held is not None

    def pixels(self, height: int) -> Pixels:
        """The panel, of that height: rows of red, green and blue."""
        out = np.empty((max(self.height, height + self.offset), WIDTH, 3), np.uint8)
        out[:] = _BACK
        for i, row in enumerate(self.rows):
            if _EDGE + _ROW * (i + 1) > self.offset and _EDGE + _ROW * i < self.offset + height:
                _draw(out[_EDGE + _ROW * i:_EDGE + _ROW * (i + 1)], row)
        return np.ascontiguousarray(out[self.offset:self.offset + height])


def _draw(area: Pixels, row: Row) -> None:
    if isinstance(row, Title):
        put_text(area, row.text[:(WIDTH - 2 * _EDGE) // 12], _EDGE, 8, _FAINT, 2)
        return
    if isinstance(row, Button):
        area[3:_ROW - 3, _EDGE:WIDTH - _EDGE] = _FILL if row.is_on() else _TRACK
        put_text(area, row.text[:40], _EDGE + 8, (_ROW - HIGH) // 2, _TEXT)
        return
    end = WIDTH - _EDGE
    value = f"{row.read() if row.held is None else row.held:.3f}"
    put_text(area, value, _EDGE, 4, _FAINT, right=end)
    put_text(area, row.text[:(end - _EDGE) // 6 - len(value) - 1], _EDGE, 4, _TEXT)
    knob = _EDGE + round(row.share() * (end - _EDGE))
    area[17:17 + _BAR, _EDGE:end] = _TRACK
    area[17:17 + _BAR, _EDGE:knob] = _FILL
    area[14:17 + _BAR + 3, max(_EDGE, knob - 3):min(end, knob + 3)] = _KNOB
