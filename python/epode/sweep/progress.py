# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A line on standard error that says how far a sweep is, with an estimate of what is left: at the pace of this session."""
from __future__ import annotations

import sys
import time
from typing import TextIO


def clock(seconds: float) -> str:
    """1:02:03, or 2:03."""
    minutes, left = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{left:02}" if hours else f"{minutes}:{left:02}"


class Progress:
    """Of so many runs, some of which were there before."""

    def __init__(self, total: int, before: int, shown: bool, stream: TextIO | None = None) -> None:
        self.total, self.before, self.shown = total, before, shown
        self.stream = sys.stderr if stream is None else stream
        self.done = self.failed = 0
        self._begin = time.monotonic()
        self._written = -1.0

    def line(self, elapsed: float) -> str:
        """What is shown after so many seconds."""
        done = self.before + self.done
        bar = "#" * (20 * done // max(1, self.total))
        left = (self.total - done) * elapsed / self.done if self.done else None
        return (f"[{bar:20}] {done} of {self.total} runs" + (f", {self.failed} failed" if self.failed else "") + f", {clock(elapsed)}" +
                (f", about {clock(left)} left" if left is not None and done < self.total else ""))

    def add(self, runs: int, failed: int) -> None:
        """So many have ended."""
        self.done, self.failed = self.done + runs, self.failed + failed
        self.show()

    def show(self, last: bool = False) -> None:
        """Writes the line, on a terminal over the one before, at most five times a second."""
        now = time.monotonic()
        if not self.shown or (not last and now - self._written < (0.2 if self.stream.isatty() else 10)):
            return
        self._written = now
        text = self.line(now - self._begin)
        if self.stream.isatty():
            print(f"\r\x1b[K{text}", end="\n" if last else "", file=self.stream, flush=True)
        else:
            print(text, file=self.stream, flush=True)
