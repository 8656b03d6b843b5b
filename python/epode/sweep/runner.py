# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Runs, each under the eyes of another process. A worker (a thread of the driver, a process of Ray's) has a child, which executes runs
one by one and answers each: so a run that never ends is killed at its limit, one that kills its process is known by its number, and
both become rows. A child that lost its worker ends itself."""
from __future__ import annotations

import os
import pickle
import queue
import subprocess
import sys
import threading
import time
import traceback
from collections.abc import Callable, Sequence
from multiprocessing.connection import Connection, Pipe
from typing import Any

Run = tuple[int, dict[str, Any], int]
Row = dict[str, Any]
_START = 120.0  # s that a child may take to begin, on a busy machine
_own = threading.local()


def run_chunk(scene: bytes, runs: Sequence[Run], limit: float | None, isolated: bool, node: str = "") -> list[Row]:
    """A row for each run: what a worker does. ``scene`` is pickled; limit: s of a run."""
    node = node or os.uname().nodename
    if not isolated:
        answer = _answers(scene)
        return [{**_named(run), **answer(run), "node": node} for run in runs]
    rows = []
    for run in runs:
        child = getattr(_own, "child", None)
        if child is None or child.scene != scene:
            if child is not None:
                child.end()
            child = _own.child = _Child(scene)
        rows.append({**_named(run), **child.answer(run, limit), "node": node})
        if not child.lives:
            _own.child = None
    return rows


def _named(run: Run) -> Row:
    return {"run": run[0], **run[1], "seed": run[2]}


def _failed(reason: str, begin: float) -> Row:
    return {"error": reason, "duration": time.perf_counter() - begin}


class _Child:
    """The worker's side."""

    def __init__(self, scene: bytes) -> None:
        self.scene, self.lives = scene, True
        self._ours, theirs = Pipe()
        paths = os.pathsep.join(path or os.getcwd() for path in sys.path)
        command = [sys.executable, "-c", f"from epode.sweep.runner import serve; serve({theirs.fileno()})"]
        self._process = subprocess.Popen(command, pass_fds=[theirs.fileno()], stdin=subprocess.DEVNULL,
                                         env={**os.environ, "PYTHONPATH": paths})
        theirs.close()
        self._begun = False
        self._send(scene)

    def __del__(self) -> None:
        self.end()

    def end(self) -> None:
        """Kills it."""
        self.lives = False
        self._ours.close()
        self._process.kill()
        self._process.wait()

    def _send(self, what: bytes) -> None:
        try:
            self._ours.send_bytes(what)
        except OSError:  # it has died: the next answer says how
            pass

    def answer(self, run: Run, limit: float | None) -> Row:
        """Its row, or the row that says how it failed."""
        begin = time.perf_counter()
        try:
            if not self._begun:
                if not self._ours.poll(_START):
                    raise TimeoutError(f"its process did not begin within {_START:g} s")
                self._ours.recv_bytes()
                self._begun, begin = True, time.perf_counter()
            self._send(pickle.dumps(run))
            if not self._ours.poll(limit):
                raise TimeoutError(f"time limit: it did not end within {limit:g} s")
            row: Row = pickle.loads(self._ours.recv_bytes())
            return row
        except TimeoutError as reason:
            self.end()
            return _failed(str(reason), begin)
        except (EOFError, OSError):
            code = self._process.wait()
            self.end()
            return _failed(f"killed its process: signal {-code}" if code < 0 else f"ended its process: exit code {code}", begin)


def _answers(pickled: bytes) -> Callable[[Run], Row]:
    """The function that executes runs of this scene."""
    from .observed import row_of
    try:
        scene: Any = pickle.loads(pickled)
    except Exception as problem:
        reason = f"the scene cannot be loaded: {problem!r}"

        def refuse(run: Run) -> Row:
            del run
            return {"error": reason, "duration": 0.0}
        return refuse

    def answer(run: Run) -> Row:
        begin = time.perf_counter()
        try:
            row = row_of(scene, run[1], run[2])
        except Exception:
            return _failed(traceback.format_exc(limit=-3), begin)
        return {**row, "error": None, "duration": time.perf_counter() - begin}
    return answer


def serve(descriptor: int) -> None:
    """What the child does until it is killed, with its end of a connection: what a scene prints goes to standard error, and its worker's end is its own."""
    os.dup2(2, 1)
    connection = Connection(descriptor)
    messages: queue.SimpleQueue[bytes] = queue.SimpleQueue()

    def receive() -> None:
        try:
            while True:
                messages.put(connection.recv_bytes())
        except (EOFError, OSError):
            os._exit(1)
    threading.Thread(target=receive, daemon=True).start()
    answer = _answers(messages.get())
    connection.send_bytes(b"begun")
    while True:
        connection.send_bytes(pickle.dumps(answer(pickle.loads(messages.get()))))
