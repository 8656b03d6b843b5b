# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""One Parquet file for each chunk: written aside, flushed and renamed, so that a file with a chunk's name is whole whatever ended the
sweep. Parameters keep their type, results are doubles."""
from __future__ import annotations

import fcntl
import io
import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from .plan import Distribution, Plan

try:
    import pyarrow  # type: ignore[import-not-found,import-untyped,unused-ignore]
    import pyarrow.parquet as parquet  # type: ignore[import-not-found,import-untyped,unused-ignore]
except ImportError:
    raise ImportError("epode.sweep keeps its rows in Parquet files: pip install epode[sweep]") from None

_TYPES = {bool: pyarrow.bool_(), int: pyarrow.int64(), float: pyarrow.float64(), str: pyarrow.string()}


def _columns(plan: Plan, rows: Sequence[dict[str, Any]]) -> Any:
    """The schema: run, parameters, seed, results in their order, then what every table has."""
    axes = dict(plan.axes)
    kinds = {name: float if isinstance(axes[name], Distribution) else type(axes[name][0]) for name in plan.parameters}  # type: ignore[index]
    fixed = {"state_hash": str, "error": str, "duration": float, "node": str}
    results = dict.fromkeys(name for row in rows for name in row if name not in {"run", "seed", *kinds, *fixed})
    columns = {"run": int, **kinds, "seed": int, **dict.fromkeys(results, float), **fixed}
    return pyarrow.schema([(name, _TYPES[kind]) for name, kind in columns.items()])


def path_of(folder: Path, name: str) -> Path:
    """Of a chunk's file."""
    return folder / f"{name}.parquet"


def write(folder: Path, name: str, plan: Plan, rows: Sequence[dict[str, Any]]) -> None:
    """Writes a chunk's file, or leaves nothing of it. Raises OSError."""
    buffer = io.BytesIO()
    parquet.write_table(pyarrow.Table.from_pylist(list(rows), _columns(plan, rows)), buffer)
    part = folder / f".{name}.part"
    try:
        with open(part, "wb") as file:
            file.write(buffer.getbuffer())
            file.flush()
            os.fsync(file.fileno())
        os.replace(part, path_of(folder, name))
    except OSError:
        part.unlink(missing_ok=True)
        raise


def failures(folder: Path, name: str) -> int | None:
    """How many rows of a chunk's file have failed; None if there is no such file, or none that can be read."""
    try:
        errors = parquet.read_table(path_of(folder, name), columns=["error"]).column(0)
    except (OSError, pyarrow.ArrowException):
        return None
    return len(errors) - int(errors.null_count)


def table(folder: Path, names: Sequence[str]) -> Any:
    """The rows of these chunks, as one pyarrow.Table in the order of the runs."""
    tables = [parquet.read_table(path_of(folder, name)) for name in names]
    if not tables:
        return pyarrow.table({})
    joined = pyarrow.concat_tables(tables, promote_options="default").sort_by("run")
    last = ["state_hash", "error", "duration", "node"]
    return joined.select([*(name for name in joined.column_names if name not in last), *last])


@contextmanager
def locked(folder: Path) -> Iterator[None]:
    """While this is held no other sweep writes into the folder. Raises BlockingIOError."""
    with open(folder / ".lock", "w") as file:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        for left in folder.glob(".*.part"):  # of a driver that was killed
            left.unlink(missing_ok=True)
        yield
