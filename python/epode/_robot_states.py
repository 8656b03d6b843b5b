# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What robots add to the state of their world: controls, activations and targets.

They stand behind the library's bytes: the numbers of all robots, how many each has, how many robots, and a mark. A world
without robots has none of it."""
from __future__ import annotations

import struct
import typing

import numpy as np

from ._handle import FloatArray
from .errors import RefusedError

if typing.TYPE_CHECKING:
    from .robot import Robot

_END = struct.Struct("<I8s")
_MARK = b"EPROBOTS"
_SIZE = struct.Struct("<8xQ8x")  # of the library's header: its bytes, with the header


def _check_end(state: bytes, end: int) -> None:
    """Refuse bytes behind the library's part, which it would pass over: a state of robots that was cut off, or something else."""
    size = _SIZE.unpack_from(state)[0] if len(state) >= _SIZE.size else end
    if size < end:
        raise RefusedError(f"{end - size} bytes follow the state, which has {size}: it has been cut off, or something was added")


def numbers_of(robots: list[Robot]) -> list[tuple[Robot, FloatArray]]:
    """The numbers of all robots that are alive."""
    return [(robot, robot._live.state()) for robot in robots if robot.alive]


def set_numbers(numbers: list[tuple[Robot, FloatArray]]) -> None:
    """Give robots what ``numbers_of`` has returned."""
    for robot, its in numbers:
        robot._live.set_state(its)


def joined(state: bytes, robots: list[Robot]) -> bytes:
    """A state of the library with that of the robots."""
    numbers = [its for _, its in numbers_of(robots)]
    if not numbers:
        return state
    counts = np.array([len(its) for its in numbers], "<u4")
    return state + np.concatenate(numbers).astype("<f8").tobytes() + counts.tobytes() + _END.pack(len(counts), _MARK)


def split(state: bytes, robots: list[Robot]) -> tuple[bytes, list[tuple[Robot, FloatArray]]]:
    """The library's part of a state, and the numbers of the robots; none if it was saved without robots, or in C."""
    if len(state) < _END.size or state[-8:] != _MARK:
        _check_end(state, len(state))
        return state, []
    end = len(state) - _END.size
    places = end - 4 * _END.unpack_from(state, end)[0]
    counts = np.frombuffer(state[max(places, 0):end], "<u4").astype(int)
    begin = places - 8 * int(counts.sum())
    living = numbers_of(robots)
    if begin < 0 or [len(its) for _, its in living] != counts.tolist():
        raise RefusedError(f"a state of {len(counts)} robots, each with {counts.tolist()} numbers, is refused; this world's "
                           f"{len(living)} have {[len(its) for _, its in living]}")
    _check_end(state, begin)
    parts = np.split(np.frombuffer(state[begin:places], "<f8"), np.cumsum(counts)[:-1])
    return state[:begin], [(robot, its) for (robot, _), its in zip(living, parts)]
