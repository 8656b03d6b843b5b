# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Every function, structure and number of the C API, by its name in C.

Handles are typed objects, and what a function writes through a pointer is what it returns: ``dWorldGetGravity(world)``
is an array, ``dJointGetBreakLimits(joint)`` a tuple of the result and two numbers. Structures are objects that are
passed and written to. ``coverage()`` says how each function of the headers is reached, or why it is not.
"""
from . import errors as _errors
from . import _c
from ._c import *  # noqa: F401,F403

_c._set_exceptions(_errors.RefusedError, _errors.DeadHandleError, _errors.BusyError, _errors.EpodeWarning)


def coverage() -> dict[str, str]:
    """{function of the headers: "generated", "written" or "left out: why"}."""
    import json
    import os
    with open(os.path.join(os.path.dirname(__file__), "coverage.json"), encoding="ascii") as file:
        functions: dict[str, str] = json.load(file)["functions"]
    return functions
