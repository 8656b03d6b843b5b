# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What an environment asks of a batch, as data. The engine evaluates it in C++, for each copy in the thread that steps it."""
from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Literal

from ..batch import _PARAMETERS, _QUANTITIES

Distribution = Sequence[Any]
_SOURCES = ("quantity", "action", "point", "action_change", "command", "direction", "row", "height")
_FUNCTIONS = (None, "sin", "cos")
_KINDS = ("constant", "healthy", "rate", "sum", "squares", "length", "gaussian")


@dataclass(frozen=True)
class Piece:
    """``count`` numbers of a quantity of batches (epode.Batch.bind) from ``first`` on, or of ``"action"``, each as
    clip(scale * (function(x) - offset), low, high); with ``minus`` less those from there on, with ``command`` less the commands from there
    on, with ``axes_of`` of a vector that begins at ``first``, in that link's axes. Of ``"point"`` they are the coordinates of a point of a
    link, of ``"direction"`` a direction of the world in the axes of a link, of ``"action_change"`` what the action differs by from the last
    one, of ``"command"`` what the episode asks for, of ``"row"`` the row of the curriculum, of ``"height"`` how high a link's origin is above
    the ground at ``places`` around it, m, x where the link's x heads (``HeightScan``)."""

    quantity: str
    first: int = 0
    count: int = 1
    function: Literal["sin", "cos"] | None = None
    offset: float = 0.0
    scale: float = 1.0
    low: float = -math.inf
    high: float = math.inf
    link: int = 0
    point: tuple[float, float, float] = (0.0, 0.0, 0.0)
    minus: int = -1
    command: int = -1
    axes_of: int = -1
    places: Sequence[tuple[float, float]] = ()

    def _packed(self) -> tuple[Any, ...]:
        source = self.quantity if self.quantity in _SOURCES else "quantity"
        quantity = _QUANTITIES.index(self.quantity) if source == "quantity" else 0
        return (_SOURCES.index(source), quantity, self.first, self.count, _FUNCTIONS.index(self.function), float(self.offset),
                float(self.scale), float(self.low), float(self.high), *map(float, self.point), self.link, self.minus, self.command, self.axes_of,
                tuple((float(x), float(y)) for x, y in self.places))


@dataclass(frozen=True)
class HeightScan:
    """A grid of places around a robot, in rows along x, of which a task observes the heights: ``length`` along where the robot heads,
    ``width`` across, ``spacing`` between places, m. Observed is how far the robot's base is above the ground there, less its height where
    it stands: 0 on flat ground, 0.1 over a hole of 10 cm, within ``limit``, which it also is where there is no ground."""

    length: float = 1.6
    width: float = 1.0
    spacing: float = 0.1
    limit: float = 1.0

    def __post_init__(self) -> None:
        if not (0 < self.spacing < math.inf and 0 <= self.length < math.inf and 0 <= self.width < math.inf and 0 < self.limit < math.inf):
            raise ValueError("height_scan: a length and a width of 0 or more, a spacing and a limit above 0 are expected")

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns of the grid: across, along."""
        return round(self.width / self.spacing) + 1, round(self.length / self.spacing) + 1

    @property
    def places(self) -> list[tuple[float, float]]:
        """From the robot's base, ahead and to the left; those of a row one after the other, the right row and what is behind first."""
        rows, columns = self.shape
        return [(self.spacing * (column - (columns - 1) / 2), self.spacing * (row - (rows - 1) / 2)) for row in range(rows) for column in range(columns)]

    def piece(self, link: int, stand: float) -> Piece:
        """Of a link that is so high where the robot stands."""
        places = self.places
        return Piece("height", 0, len(places), offset=stand, low=-self.limit, high=self.limit, link=link, places=places)


@dataclass(frozen=True)
class Term:
    """A part of the reward, or of the infos alone: clip(weight * f(of), low, high). ``kind`` is f: ``constant`` 1; ``healthy`` 1
    where the copy is; ``rate`` of a number over the step; ``sum``; ``squares``, summed; ``length``; ``gaussian`` exp(-squares / width).
    Terms of one name are one info."""

    name: str
    kind: Literal["constant", "healthy", "rate", "sum", "squares", "length", "gaussian"]
    of: Piece | None = None
    weight: float = 1.0
    low: float = -math.inf
    high: float = math.inf
    is_reward: bool = True
    at_reset: bool = False
    width: float = 1.0

    def _packed(self, columns: Sequence[str]) -> tuple[Any, ...]:
        piece = None if self.of is None else self.of._packed()
        return (_KINDS.index(self.kind), piece, float(self.weight), float(self.low), float(self.high), columns.index(self.name),
                self.is_reward, self.at_reset, float(self.width))


@dataclass(frozen=True)
class Range:
    """Where a copy is healthy: all numbers of the piece from low to high, without these if it is open."""

    of: Piece
    low: float = -math.inf
    high: float = math.inf
    is_open: bool = False


@dataclass(frozen=True)
class Start:
    """Coordinates (or velocities) from ``first`` on at the begin of an episode: drawn from low to high, or with those means and
    deviations, added to the reference if relative; drawn again until their length is within ``length``."""

    of: Literal["qpos", "qvel"]
    low: Sequence[float]
    high: Sequence[float]
    first: int = 0
    distribution: Literal["uniform", "normal"] = "uniform"
    is_relative: bool = True
    length: tuple[float, float] = (-1.0, math.inf)

    def _packed(self) -> tuple[Any, ...]:
        return (self.of == "qvel", self.distribution == "normal", self.is_relative, self.first, [float(x) for x in self.low],
                [float(x) for x in self.high], *map(float, self.length))


@dataclass(frozen=True)
class Commands:
    """What an episode asks for, as numbers: drawn when it begins and every ``steps`` steps (0: never again), all 0 in a share of draws."""

    low: Sequence[float] = ()
    high: Sequence[float] = ()
    steps: int = 0
    none: float = 0.0

    def _packed(self) -> tuple[Any, ...]:
        return [float(x) for x in self.low], [float(x) for x in self.high], self.steps, float(self.none)


@dataclass(frozen=True)
class Curriculum:
    """Fields of a landscape, in rows of equal difficulty along x, a ``spacing`` each, m. An episode begins on its copy's row, in any
    column: a row higher if the last one led farther than ``up``, m, a row lower if not as far as ``down``; after the last row in any. The
    first begins below ``first_rows``."""

    rows: int = 0
    columns: int = 1
    first_rows: int = 1
    spacing: float = 8.0
    up: float = 4.0
    down: float = 2.0

    def _packed(self) -> tuple[Any, ...]:
        return self.rows, self.columns, self.first_rows, float(self.spacing), float(self.up), float(self.down)


@dataclass(frozen=True)
class Task:
    """An environment. ``choices``: of discrete actions the controls; none: actions are the controls. ``high``: bounds of the
    observation, either side; none: no bounds."""

    observation: Sequence[Piece]
    terms: Sequence[Term]
    starts: Sequence[Start]
    frame_skip: int
    healthy: Sequence[Range] = ()
    terminates: bool = True
    choices: Sequence[Sequence[float]] = ()
    high: Sequence[float] = ()
    draws: Sequence[tuple[Any, ...]] = field(default_factory=tuple)
    noise: Sequence[float] = ()
    commands: Commands = Commands()
    curriculum: Curriculum = Curriculum()

    def __post_init__(self) -> None:
        if not 1 <= self.frame_skip <= 1000000:
            raise ValueError("frame_skip: 1 or more is expected")

    @property
    def size(self) -> int:
        """Of an observation."""
        return sum(piece.count for piece in self.observation)

    @property
    def columns(self) -> list[str]:
        """Names of the infos."""
        return list(dict.fromkeys(term.name for term in self.terms))

    def varied(self, randomise: Mapping[str, Distribution], noise: float | Sequence[float]) -> Task:
        """With parameters that each episode draws, and noise on observations."""
        draws = [_draw(name, distribution) for name, distribution in randomise.items()]
        deviations = [float(noise)] * self.size if isinstance(noise, (int, float)) else [float(x) for x in noise]
        if any(not 0 <= x < math.inf for x in deviations):
            raise ValueError("observation_noise: finite deviations of 0 or more are expected")
        return replace(self, draws=draws, noise=deviations if any(deviations) else [])

    def _packed(self, time_limit: int) -> dict[str, Any]:
        columns = self.columns
        return {"observation": [piece._packed() for piece in self.observation], "terms": [term._packed(columns) for term in self.terms],
                "healthy": [(r.of._packed(), float(r.low), float(r.high), r.is_open) for r in self.healthy],
                "starts": [start._packed() for start in self.starts], "draws": list(self.draws), "noise": list(self.noise),
                "choices": [float(x) for row in self.choices for x in row], "columns": len(columns), "frame_skip": self.frame_skip,
                "time_limit": time_limit, "terminates": self.terminates, "commands": self.commands._packed(),
                "curriculum": self.curriculum._packed()}


def _draw(name: str, distribution: Distribution) -> tuple[Any, ...]:
    kind, low, high, *words = distribution
    if name not in _PARAMETERS:
        raise ValueError(f"randomise: no parameter is called {name!r}: {', '.join(_PARAMETERS)}")
    if kind not in ("uniform", "normal") or set(words) - {"scale", "each"} or not all(map(math.isfinite, (low, high))):
        raise ValueError(f"randomise: ('uniform', low, high) or ('normal', mean, deviation), then 'scale', 'each', not {distribution}")
    return (_PARAMETERS.index(name), kind == "normal", "scale" in words, "each" in words, float(low), float(high))
