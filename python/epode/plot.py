# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Plots of recordings, by matplotlib: ``pip install epode[plot]``. Each takes the Axes to draw on, or makes some, and returns
them."""
from __future__ import annotations

from typing import Any

from .recording import Recording


def _axes(axes: Any, y: str) -> Any:
    if axes is None:
        try:
            from matplotlib import pyplot
        except ImportError as error:
            raise ImportError("epode.plot needs matplotlib: pip install epode[plot]") from error
        axes = pyplot.subplots()[1]
    axes.set_xlabel("time, s")
    axes.set_ylabel(y)
    return axes


def energy(recording: Recording, axes: Any = None) -> Any:
    """Kinetic and potential energy, and their sum."""
    axes = _axes(axes, "energy, J")
    for values, label in ((recording.kinetic, "kinetic"), (recording.potential, "potential"),
                          (recording.kinetic + recording.potential, "sum")):
        axes.plot(recording.times, values, label=label)
    axes.legend()
    return axes


def position(recording: Recording, body: int, axes: Any = None) -> Any:
    """Where a body, by its number in the recording, is."""
    axes = _axes(axes, "position, m")
    for values, label in zip(recording.trajectory(body)[:, :3].T, "xyz"):
        axes.plot(recording.times, values, label=label)
    axes.legend()
    return axes


def contacts(recording: Recording, axes: Any = None) -> Any:
    """How many points of contact there are."""
    axes = _axes(axes, "points of contact")
    axes.plot(recording.times, recording.contact_counts)
    return axes


def speed(recording: Recording, axes: Any = None) -> Any:
    """How long each step took."""
    axes = _axes(axes, "step, ms")
    axes.plot(recording.times[1:], recording.step_milliseconds[1:])
    return axes
