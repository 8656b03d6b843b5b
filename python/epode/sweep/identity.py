# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What makes two chunks the same: their name is a hash of the library, the scene, and their runs. A scene is known by its byte code and
constants, with those of the functions and constants of its own module that it names, and of theirs: comments and lines may move. What
it calls elsewhere, or reads from files, is not seen: ``version`` of ``epode.sweep.run`` is for that."""
from __future__ import annotations

import functools
import hashlib
import pickle
import sys
from collections.abc import Iterable, Iterator
from types import CodeType, FunctionType
from typing import Any

from .. import _c

_CONSTANTS = (bool, int, float, complex, str, bytes, type(None))


def _library() -> str:
    """The hash of the compiled library, and the Python that names byte code."""
    with open(_c.__file__, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest() + ".".join(map(str, sys.version_info[:2]))


def name_of_chunk(scene: str, version: str, runs: Iterable[Any]) -> str:
    """32 hexadecimal digits; scene: what ``identity_of`` returns."""
    return _digest([scene, version, *map(repr, runs)])


def identity_of(scene: Any) -> str:
    """The hash of a scene and of the library that it runs on."""
    return _digest([_library(), *_parts(scene, set())])


def _digest(parts: Iterable[str]) -> str:
    state = hashlib.sha256()
    for part in parts:
        state.update(f"{len(part)}:{part}".encode())
    return state.hexdigest()[:32]


def _parts(what: Any, seen: set[int]) -> Iterator[str]:
    if isinstance(what, (FunctionType, type)):
        if id(what) in seen:
            return
        seen.add(id(what))
    if isinstance(what, FunctionType):
        yield from _parts_of_code(what.__code__)
        cells = [cell.cell_contents for cell in what.__closure__ or ()]
        for value in [*(what.__defaults__ or ()), *(what.__kwdefaults__ or {}).values(), *cells]:
            yield from _parts(value, seen)
        for name in sorted(_names(what.__code__)):
            value = what.__globals__.get(name)
            if isinstance(value, _CONSTANTS) or getattr(value, "__module__", None) == what.__module__:
                yield name
                yield from _parts(value, seen)
    elif isinstance(what, functools.partial):
        for value in (what.func, *what.args, *(x for pair in sorted(what.keywords.items()) for x in pair)):
            yield from _parts(value, seen)
    elif isinstance(what, type):
        for name, value in sorted(vars(what).items()):
            if isinstance(value, (FunctionType, *_CONSTANTS)) and name != "__doc__":
                yield name
                yield from _parts(value, seen)
    elif isinstance(what, _CONSTANTS):
        yield repr(what)
    else:
        yield from _parts_of_pickle(what)


def _parts_of_pickle(what: Any) -> Iterator[str]:
    try:
        yield hashlib.sha256(pickle.dumps(what)).hexdigest()
    except Exception:
        yield f"{type(what).__module__}.{type(what).__qualname__}"


def _parts_of_code(code: CodeType) -> Iterator[str]:
    yield code.co_code.hex()
    yield repr(code.co_names)
    for constant in code.co_consts[_has_text(code):]:
        if isinstance(constant, CodeType):
            yield from _parts_of_code(constant)
        else:
            yield repr(sorted(map(repr, constant)) if isinstance(constant, frozenset) else constant)


def _has_text(code: CodeType) -> int:
    """1 if the first constant is the function's docstring, or stands where it would."""
    return int(bool(code.co_consts) and (code.co_consts[0] is None or isinstance(code.co_consts[0], str)))


def _names(code: CodeType) -> set[str]:
    return set(code.co_names).union(*(_names(constant) for constant in code.co_consts if isinstance(constant, CodeType)))
