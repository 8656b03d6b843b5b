# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What calls raise. Each text is the library's own."""


class RefusedError(ValueError):
    """The library refused a call; nothing has changed. ``number`` is ODE's error number."""

    number: int = 0


class DeadHandleError(RefusedError):
    """The object has been destroyed."""


class BusyError(RuntimeError):
    """The world is in a step on another thread."""


class EpodeWarning(UserWarning):
    """A message of the library."""
