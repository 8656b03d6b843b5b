# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What calls raise. The library's text names a function of C; for a program that called something else it is that call: ``World.step(h=-1): ...``.
A program that calls ``epode.c`` reads the text as it is."""
from __future__ import annotations

import re
import sys
from types import FrameType

_OF_C = re.compile(r"(?s)(?P<text>.*) in (?P<function>d[A-Z]\w*)\(\)$")
_UNKNOWN = "Bad argument(s)"
_LONGEST = 60


def _outermost() -> FrameType | None:
    """The call of the package that the program has made: of the frames from here on that are the package's own, the last."""
    frame: FrameType | None = sys._getframe(2)
    found = None
    while frame is not None and str(frame.f_globals.get("__name__", "")).partition(".")[0] == "epode":
        found, frame = frame, frame.f_back
    return found


def _short(value: object) -> str:
    if isinstance(value, (list, tuple)) and len(value) > 8:
        return f"a {type(value).__name__} of {len(value)}"
    text = " ".join(repr(value).split())
    return text if len(text) <= _LONGEST else text[:_LONGEST - 3] + "..."


def _described(frame: FrameType) -> str:
    """A call as the program wrote it, or nearly: its name and what it was given."""
    code, values = frame.f_code, frame.f_locals
    names = list(code.co_varnames[:code.co_argcount + code.co_kwonlyargcount])
    owner = values.get(names[0]) if names else None
    is_method = "." in code.co_qualname
    given = names[1:] if is_method else names
    if is_method and isinstance(getattr(type(owner), code.co_name, None), property):
        return code.co_qualname + (f" = {_short(values.get(given[0]))}" if given else "")
    title = code.co_qualname.removesuffix(".__init__") if is_method else f"epode.{code.co_name}"
    said = (f"{name}={_short(values[name])}" for name in given if values.get(name) is not None and values[name] is not False)
    return f"{title}({', '.join(said)})"


def _expected(function: str) -> str:
    """What the header says that a function of C refuses, for those that send no text of their own."""
    from . import _c
    said = " ".join((getattr(_c, function).__doc__ or "").split())
    found = re.search(r"Refused: (.*?)(?:\. [A-Z]|\.?$)", said) or re.search(r"refused \(([^()]*)\)", said)
    return f"refused: {found[1]}" if found else "an argument is refused: not finite, or out of its range"


class RefusedError(ValueError):
    """The library refused a call; nothing has changed. ``number`` is ODE's error number."""

    number: int = 0

    def __init__(self, text: str = "") -> None:
        """text: what was refused, and what would not be."""
        found, frame = _OF_C.match(text), _outermost()
        if found is not None and frame is not None:
            reason = _expected(found["function"]) if found["text"] == _UNKNOWN else found["text"]
            text = f"{_described(frame)}: {reason}"
        super().__init__(text)


class DeadHandleError(RefusedError):
    """The object has been destroyed."""


class BusyError(RuntimeError):
    """The world is in a step on another thread."""


class EpodeWarning(UserWarning):
    """A message of the library."""
