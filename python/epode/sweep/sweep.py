# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The driver: chunks that have no whole file are given to the executor, a few more than it can do at a time, and what returns is
written. What is killed, and when, does not matter: files are whole or not there, and the next start asks only which are missing. An
exception of the executor itself (Ray's after its retries) is a failure of all runs of the chunk."""
from __future__ import annotations

import errno
import sys
from collections.abc import Callable, Mapping
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any, Literal

from . import files
from .executors import executor_of, width_of
from .identity import identity_of, name_of_chunk
from .plan import Plan
from .progress import Progress
from .runner import Row, Run, run_chunk

Scene = Callable[[dict[str, Any], int], Mapping[str, Any]]
Place = Literal["serial", "threads", "ray"] | Executor
_BAD_IN_A_ROW = 3


class SweepError(RuntimeError):
    """A sweep has stopped: the text says why. What is in its folder stays, and the next run goes on from there."""


@dataclass(frozen=True)
class Chunk:
    """Runs that are executed together, and the name of their file."""

    name: str
    runs: list[Run]


@dataclass(frozen=True)
class Status:
    """What of a plan is in a folder: runs, chunks, and how many of each have whole files; failed: runs of these that have failed."""

    runs: int
    chunks: int
    runs_there: int
    chunks_there: int
    failed: int


class _Sweep:
    def __init__(self, scene: Scene, plan: Plan, out: str | PathLike[str], chunk: int, version: str) -> None:
        if not callable(scene):
            raise TypeError(f"scene {scene!r}: a function (parameters, seed) is expected")
        if not isinstance(plan, Plan):
            raise TypeError(f"plan {plan!r}: epode.sweep.grid makes one")
        if not isinstance(chunk, int) or chunk < 1:
            raise ValueError(f"chunk {chunk!r}: 1 or more is expected")
        self.scene, self.plan, self.folder = scene, plan, Path(out)
        runs = [(i, *run) for i, run in enumerate(plan)]
        parts = [runs[first:first + chunk] for first in range(0, len(runs), chunk)]
        identity = identity_of(scene)
        self.chunks = [Chunk(name_of_chunk(identity, version, part), part) for part in parts]
        self.there = {c.name: failed for c in self.chunks if (failed := files.failures(self.folder, c.name)) is not None}

    def missing(self) -> list[Chunk]:
        """Those without a file, and those all of whose runs have failed."""
        return [c for c in self.chunks if self.there.get(c.name, len(c.runs)) == len(c.runs)]

    def status(self) -> Status:
        missing = self.missing()
        there = len(self.plan) - sum(len(c.runs) for c in missing)
        of_missing = {c.name for c in missing}
        failed = sum(count for name, count in self.there.items() if name not in of_missing)
        return Status(len(self.plan), len(self.chunks), there, len(self.chunks) - len(missing), failed)


def run(scene: Scene, plan: Plan, *, out: str | PathLike[str], executor: Place = "threads", chunk: int = 64, limit: float | None = None,
        isolated: bool = True, version: str = "", progress: bool | None = None) -> Any:
    """Runs ``scene(parameters, seed)``, which returns a dict of numbers, worlds and batches, for all of the plan. Returns a pyarrow.Table
    with a row for each run, in the plan's order, and leaves a Parquet file of each ``chunk`` of runs in ``out``. Chunks whose file is whole
    are not run again: the same call goes on with a sweep that was ended, by whatever; if all runs of a chunk have failed, they are.

    Columns: run, parameters, seed, results, state_hash, error (its text, or null), duration in s, node. Of a world under a key there are
    the residual, joint_error, penetration and contained_islands of its last step's report (if ``world.reports``), KEY_residual and so on; of
    a batch KEY_residual and KEY_bad. state_hash is of their states and of the results.

    executor: "serial", "threads" (of this machine), "ray", or any concurrent.futures.Executor. limit: s that a run may take. isolated:
    runs are executed by a child process of each worker, which may be killed; False: by the worker, for debuggers. version: of what
    the scene uses from elsewhere than its own module. progress: a line on standard error; default: on a terminal. Raises SweepError."""
    import cloudpickle  # type: ignore[import-not-found,import-untyped,unused-ignore]
    if limit is not None and not limit > 0:
        raise ValueError(f"limit {limit}: seconds above 0 are expected")
    if limit is not None and not isolated:
        raise ValueError("a run that is not isolated cannot be ended at a limit")
    sweep = _Sweep(scene, plan, out, chunk, version)
    sweep.folder.mkdir(parents=True, exist_ok=True)
    place, is_ours = executor_of(executor)
    status = sweep.status()
    line = Progress(status.runs, status.runs_there, sys.stderr.isatty() if progress is None else progress)
    done = False
    try:
        with files.locked(sweep.folder):
            _drive(sweep, place, (cloudpickle.dumps(scene), limit, isolated), line)
        done = True
    except BlockingIOError:
        raise SweepError(f"another sweep writes into {sweep.folder}") from None
    finally:
        line.show(last=True)
        if is_ours:
            place.shutdown(wait=done, cancel_futures=True)
    return files.table(sweep.folder, [c.name for c in sweep.chunks])


def _drive(sweep: _Sweep, place: Executor, work: tuple[bytes, float | None, bool], line: Progress) -> None:
    scene, limit, isolated = work
    waiting, running = iter(sweep.missing()), dict[Future[list[Row]], Chunk]()
    bad = 0
    try:
        while True:
            width = width_of(place)  # a cluster may have grown
            while len(running) < (1 if width == 1 else 2 * width) and (chunk := next(waiting, None)):
                running[place.submit(run_chunk, scene, chunk.runs, limit, isolated)] = chunk
            if not running:
                return
            for future in wait(running, return_when=FIRST_COMPLETED).done:
                rows = _rows_of(future, chunk := running.pop(future))
                _keep(sweep, chunk, rows)
                failed = [row for row in rows if row["error"] is not None]
                line.add(len(rows), len(failed))
                bad = bad + 1 if len(failed) == len(rows) else 0
                if bad == _BAD_IN_A_ROW:
                    raise SweepError(f"all runs of {bad} chunks in a row have failed; the last one: {failed[-1]['error']}")
    finally:
        for future in running:
            future.cancel()


def _rows_of(future: Future[list[Row]], chunk: Chunk) -> list[Row]:
    try:
        return future.result()
    except Exception as problem:
        reason = f"the executor gave up: {problem!r}"
        return [{"run": run, **parameters, "seed": seed, "error": reason} for run, parameters, seed in chunk.runs]


def _keep(sweep: _Sweep, chunk: Chunk, rows: list[Row]) -> None:
    try:
        files.write(sweep.folder, chunk.name, sweep.plan, rows)
    except OSError as problem:
        full = "the disk is full" if problem.errno in (errno.ENOSPC, errno.EDQUOT) else str(problem)
        there = sum(files.path_of(sweep.folder, c.name).exists() for c in sweep.chunks)
        raise SweepError(f"{sweep.folder}: {full}; {there} of {len(sweep.chunks)} chunks are whole, and the same call goes on "
                         "from there") from problem


def status(scene: Scene, plan: Plan, *, out: str | PathLike[str], chunk: int = 64, version: str = "") -> Status:
    """What ``run`` with these arguments would find; runs nothing."""
    return _Sweep(scene, plan, out, chunk, version).status()


def read(out: str | PathLike[str]) -> Any:
    """All rows in a folder, as a pyarrow.Table, of whatever sweeps are there."""
    folder = Path(out)
    names = sorted(path.stem for path in folder.glob("*.parquet"))
    if not names:
        raise FileNotFoundError(f"{folder}: no rows of a sweep are there")
    return files.table(folder, names)
