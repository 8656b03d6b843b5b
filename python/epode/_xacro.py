# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""URDF from xacro, the language of macros in which most of ROS's robots are written: by the module or the program of that name."""
from __future__ import annotations

import contextlib
import importlib.util
import os
import shutil
import subprocess
from collections.abc import Iterator
from typing import Any

from .errors import RefusedError


def is_xacro(path: str) -> bool:
    """Whether a file goes by the name of one."""
    return path.endswith(".xacro")


def expanded(path: str) -> str:
    """The URDF that the file describes, with the values that its arguments have by default."""
    if not os.path.isfile(path):
        raise RefusedError(f"'{path}' is no file")
    try:
        import xacro.substitution_args  # type: ignore[import-not-found,import-untyped,unused-ignore]
    except ImportError:
        return _by_program(path)
    try:
        with _packages_of(os.path.abspath(path), xacro.substitution_args):
            return str(xacro.process_file(path).toxml())
    except Exception as error:  # of many types, of its own and of what it evaluates
        raise RefusedError(f"{path}: xacro says: {error}") from error


@contextlib.contextmanager
def _packages_of(path: str, its: Any) -> Iterator[None]:
    """Where ROS is not installed, ``$(find NAME)`` is the folder NAME among those above the file and next to them, or in ROS_PACKAGE_PATH."""
    if importlib.util.find_spec("ament_index_python") is not None or not hasattr(its, "_eval_find"):
        yield
        return

    def find(name: str) -> str:
        above = [path]
        while above[-1] != os.path.dirname(above[-1]):
            above.append(os.path.dirname(above[-1]))
        named = [one for one in above if os.path.basename(one) == name]
        nearby = [os.path.join(one, name) for one in [*above, *os.environ.get("ROS_PACKAGE_PATH", "").split(os.pathsep)] if one]
        for folder in [*named, *nearby]:
            if os.path.isdir(folder):
                return folder
        raise RefusedError(f"there is no package {name!r} above {path} or in ROS_PACKAGE_PATH")
    before = its._eval_find
    its._eval_find = find
    try:
        yield
    finally:
        its._eval_find = before


def _by_program(path: str) -> str:
    program = shutil.which("xacro")
    if program is None:
        raise RefusedError(f"{path}: a xacro file, which the package xacro reads, and it is not here: pip install xacro, or Debian's package xacro")
    result = subprocess.run([program, path], capture_output=True, text=True)
    if result.returncode != 0:
        raise RefusedError(f"{path}: xacro says: {result.stderr.strip()[-500:]}")
    return result.stdout
