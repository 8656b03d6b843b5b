# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What a sweep runs: axes, crossed. Run i has one value of each axis: i in mixed radix, the last axis changes fastest, as in nested
loops. An axis that is a distribution has no values to cross: run i draws from it u(i) in (0, 1) and takes its quantile. u(i) is the
first word of Philox with the counter i and the key (seed of the plan, hash of the axis's name), so a draw depends on neither the other
axes' names nor the order of runs nor the machine. The driver draws; workers are given numbers."""
from __future__ import annotations

import hashlib
import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from statistics import NormalDist
from typing import Any, Literal

import numpy as np

Value = bool | int | float | str
RESERVED = ("run", "seed", "state_hash", "error", "duration", "node")
_KINDS = ("uniform", "normal", "log")


@dataclass(frozen=True)
class Distribution:
    """What each run draws from: ``epode.sweep.distribution`` makes it."""

    kind: Literal["uniform", "normal", "log"]
    low: float
    high: float

    def quantile(self, share: float) -> float:
        """The value below which that share lies, 0 < share < 1."""
        if self.kind == "normal":
            return NormalDist(self.low, self.high).inv_cdf(share)
        if self.kind == "log":
            return float(self.low * (self.high / self.low) ** share)
        return self.low + (self.high - self.low) * share


Axis = Sequence[Value] | range | np.ndarray[Any, Any] | Distribution


def distribution(kind: Literal["uniform", "normal", "log"], low: float, high: float) -> Distribution:
    """An axis that each run draws from: ``"uniform"`` from low to high, ``"log"`` likewise in the logarithm (low > 0), ``"normal"`` with
    low as its mean and high as its deviation."""
    if kind not in _KINDS:
        raise ValueError(f"distribution {kind!r}: {', '.join(_KINDS)} are expected")
    low, high = float(low), float(high)
    if not (math.isfinite(low) and math.isfinite(high)):
        raise ValueError(f"distribution {kind!r} of {low}, {high}: finite numbers are expected")
    if high <= (0 if kind == "normal" else low) or (kind == "log" and low <= 0):
        wanted = {"uniform": "low < high", "log": "0 < low < high", "normal": "a deviation above 0"}[kind]
        raise ValueError(f"distribution {kind!r} of {low}, {high}: {wanted} is expected")
    return Distribution(kind, low, high)


def linear(low: float, high: float, count: int) -> list[float]:
    """count values from low to high, at equal distances."""
    return [float(x) for x in np.linspace(low, high, _count(count))]


def log(low: float, high: float, count: int) -> list[float]:
    """count values from low to high, each the same multiple of the one before."""
    if not 0 < low <= high < math.inf:
        raise ValueError(f"log({low}, {high}): 0 < low <= high is expected")
    count = _count(count)
    return [float(low)] if count == 1 else [*(low * (high / low) ** (i / (count - 1)) for i in range(count - 1)), float(high)]


def _count(count: int) -> int:
    if not 1 <= count <= 10**9:
        raise ValueError(f"count {count}: 1 or more is expected")
    return int(count)


@dataclass(frozen=True)
class Plan:
    """The runs of a sweep, a sequence of (parameters, seed): ``epode.sweep.grid`` makes it. Runs are made when they are asked for, so a
    plan of a million takes no memory."""

    axes: tuple[tuple[str, tuple[Value, ...] | range | Distribution], ...]
    draws: int = 0

    @property
    def parameters(self) -> list[str]:
        """Names of the parameters, without the seed."""
        return [name for name, _ in self.axes if name != "seed"]

    def __len__(self) -> int:
        return math.prod(1 if isinstance(axis, Distribution) else len(axis) for _, axis in self.axes)

    def __getitem__(self, run: int) -> tuple[dict[str, Value], int]:
        if not 0 <= run < len(self):
            raise IndexError(f"run {run}: 0 to {len(self) - 1} are there")
        values: dict[str, Value] = {}
        rest = run
        for name, axis in reversed(self.axes):
            if isinstance(axis, Distribution):
                values[name] = axis.quantile(_share(self.draws, name, run))
            else:
                rest, place = divmod(rest, len(axis))
                values[name] = axis[place]
        seed = values.pop("seed", 0)
        return {name: values[name] for name in self.parameters}, int(seed)

    def __iter__(self) -> Iterator[tuple[dict[str, Value], int]]:
        return (self[run] for run in range(len(self)))


def _share(seed: int, name: str, run: int) -> float:
    key = int.from_bytes(hashlib.sha256(name.encode()).digest()[:8], "little")
    word = int(np.random.Philox(counter=run, key=[seed, key]).random_raw())
    return ((word >> 12) + 0.5) * 2.0**-52


def grid(*, draws: int = 0, **axes: Axis) -> Plan:
    """Every combination of the axes' values, the last axis fastest. An axis is a sequence of values of one type (numbers, truth values,
    texts) or a distribution, of which every run draws a value of its own; ``draws`` is the seed of these draws. The axis ``seed``,
    whole numbers, is given to the scene as its second argument, 0 if there is none. Repeat draws by seeds: ``seed=range(100)``."""
    if not 0 <= draws < 2**64:
        raise ValueError(f"draws {draws}: a whole number from 0 to 2^64 - 1 is expected")
    if not axes:
        raise ValueError("a plan without axes: one at least is expected, seed=range(10) for instance")
    return Plan(tuple((name, _axis(name, axis)) for name, axis in axes.items()), int(draws))


def _axis(name: str, axis: Any) -> tuple[Value, ...] | range | Distribution:
    if name in RESERVED and name != "seed":
        raise ValueError(f"a parameter {name!r}: this is a column that every table has; another name is expected")
    if isinstance(axis, Distribution):
        if name == "seed":
            raise ValueError("seed: whole numbers are expected, not a distribution")
        return axis
    if isinstance(axis, (str, bytes)) or not isinstance(axis, Iterable):
        raise TypeError(f"{name}: a sequence of values or a distribution is expected, not {axis!r}")
    if isinstance(axis, range) and axis:
        _seeds_or_values(name, (_value(name, axis[0]), _value(name, axis[-1])))
        return axis
    return _seeds_or_values(name, tuple(_value(name, value) for value in axis))


def _seeds_or_values(name: str, values: tuple[Value, ...]) -> tuple[Value, ...]:
    if not values:
        raise ValueError(f"{name}: has no value")
    if name == "seed" and any(type(value) is not int or not 0 <= value < 2**63 for value in values):
        raise ValueError("seed: whole numbers from 0 to 2^63 - 1 are expected")
    kinds = {type(value) for value in values}
    if kinds == {int, float}:
        values, kinds = tuple(float(value) for value in values), {float}
    if len(kinds) > 1:
        raise TypeError(f"{name}: values of one type are expected, not {', '.join(sorted(kind.__name__ for kind in kinds))}")
    return values


def _value(name: str, value: Any) -> Value:
    value = value.item() if isinstance(value, np.generic) else value
    if not isinstance(value, (bool, int, float, str)):
        raise TypeError(f"{name}: numbers, truth values or texts are expected, not {value!r}")
    if isinstance(value, float) and not math.isfinite(value):
        raise ValueError(f"{name}: {value} is not finite")
    if isinstance(value, int) and not -2**63 <= value < 2**63:
        raise ValueError(f"{name}: {value} does not fit into 64 bits")
    return value
