# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""``epode sweep FILE.toml``: a sweep that a file describes.

    scene = "drop.py:drop"              # FILE:FUNCTION, from the TOML file's folder, or MODULE:FUNCTION
    out = "runs/drop"                   # from that folder, too
    executor = "ray"                    # or serial, threads; also chunk, limit, isolated, version, draws

    [axes]                              # crossed in this order, the last one fastest
    friction = [0.4, 0.6, 0.8]
    mass = {log = [1, 10, 7]}           # or linear; uniform, normal and log_uniform are drawn
    seed = {range = 20}                 # or {range = [100, 120]}
"""
from __future__ import annotations

import argparse
import importlib
import importlib.util
import sys
import tomllib
from pathlib import Path
from typing import Any

from .plan import Axis, Plan, distribution, grid, linear, log
from .sweep import Scene, SweepError, run, status

_OPTIONS: dict[str, tuple[type, ...]] = {"chunk": (int,), "limit": (int, float), "isolated": (bool,), "version": (str,)}
_KEYS = ("scene", "out", "executor", "draws", "axes", *_OPTIONS)


class WrongFile(ValueError):
    """What a TOML file says and cannot mean."""


def _axis(name: str, said: Any) -> Axis:
    if isinstance(said, list):
        return said
    if isinstance(said, dict) and len(said) == 1:
        (how, numbers), = said.items()
        match how, numbers:
            case "linear" | "log", [low, high, count]:
                return (linear if how == "linear" else log)(low, high, count)
            case "uniform" | "normal", [low, high]:
                return distribution(how, low, high)
            case "log_uniform", [low, high]:
                return distribution("log", low, high)
            case "range", int() as count:
                return range(count)
            case "range", [int() as first, int() as end]:
                return range(first, end)
    raise WrongFile(f"axes.{name} = {said!r}: a list is expected, or {{linear or log = [low, high, count]}}, {{uniform or log_uniform = "
                    "[low, high]}, {normal = [mean, deviation]}, {range = count}")


def _scene(said: str, folder: Path) -> Scene:
    where, colon, name = said.rpartition(":")
    if not colon:
        raise WrongFile(f"scene = {said!r}: FILE:FUNCTION or MODULE:FUNCTION is expected")
    if where.endswith(".py"):
        spec = importlib.util.spec_from_file_location(Path(where).stem, folder / where)
        if spec is None or spec.loader is None or not (folder / where).is_file():
            raise WrongFile(f"scene = {said!r}: there is no file {folder / where}")
        sys.path.insert(0, str((folder / where).parent))
        module = sys.modules[spec.name] = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    else:
        sys.path.insert(0, str(folder))
        module = importlib.import_module(where)
    if not callable(getattr(module, name, None)):
        raise WrongFile(f"scene = {said!r}: there is no function {name} in it")
    scene: Scene = getattr(module, name)
    return scene


def _read(path: Path) -> tuple[Scene, Plan, dict[str, Any], Any]:
    """Scene, plan, options of ``run`` and the executor of a file."""
    said = tomllib.loads(path.read_text(encoding="utf-8"))
    for key in said:
        if key not in _KEYS:
            raise WrongFile(f"{key}: {', '.join(_KEYS)} are expected")
    for key, kind in (("scene", str), ("out", str), ("axes", dict)):
        if not isinstance(said.get(key), kind):
            raise WrongFile(f"{key}: is missing, or not a {'table' if kind is dict else 'text'}")
    for key, kinds in _OPTIONS.items():
        if key in said and not isinstance(said[key], kinds):
            raise WrongFile(f"{key} = {said[key]!r}: is of a wrong type")
    plan = grid(draws=said.get("draws", 0), **{name: _axis(name, axis) for name, axis in said["axes"].items()})
    options = {key: said[key] for key in _OPTIONS if key in said}
    return _scene(said["scene"], path.parent), plan, {"out": path.parent / said["out"], **options}, said.get("executor", "threads")


def main(words: list[str]) -> int:
    """Runs the command with these words; returns its exit code: 0, 1 for a sweep that stopped or has failed runs, 2 for wrong usage."""
    parser = argparse.ArgumentParser("epode sweep", description="Runs a scene over the parameters and seeds of a file.")
    parser.add_argument("file", type=Path, help="a TOML file: docs/guide/sweeps.md")
    parser.add_argument("--resume", action="store_true", help="go on with a sweep of which there are rows")
    parser.add_argument("--dry-run", action="store_true", help="say what would be run, and run nothing")
    parser.add_argument("--executor", choices=("serial", "threads", "ray"), help="in place of the file's")
    arguments = parser.parse_args(words)
    try:
        scene, plan, options, executor = _read(arguments.file)
        found = status(scene, plan, **{key: options[key] for key in ("out", "chunk", "version") if key in options})
    except (OSError, ValueError, TypeError, ImportError) as problem:
        print(f"epode sweep: {arguments.file}: {problem}", file=sys.stderr)
        return 2
    executor = arguments.executor or executor
    print(f"{found.runs} runs in {found.chunks} chunks, {found.runs_there} of them in {options['out']}; executor {executor}")
    if arguments.dry_run:
        return 0
    if found.chunks_there and not arguments.resume:
        print("epode sweep: rows of this sweep are there already: --resume goes on with it, another folder begins again", file=sys.stderr)
        return 2
    try:
        table = run(scene, plan, executor=executor, progress=True, **options)
    except (SweepError, ImportError, ValueError) as problem:
        print(f"epode sweep: {problem}", file=sys.stderr)
        return 1
    failed = len(table) - table.column("error").null_count
    print(f"{len(table)} rows, {failed} of failed runs")
    return 1 if failed else 0
