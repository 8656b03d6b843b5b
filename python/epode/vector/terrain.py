# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Landscapes to walk on: fields in rows of equal difficulty along x and columns of one kind each along y, all of whose centres are flat
and at height 0, with a flat border around. The same bits everywhere."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Heights = NDArray[np.float64]
KINDS = ("rough", "slope", "stairs_up", "stairs_down", "blocks")


@dataclass(frozen=True)
class Landscape:
    """rows of fields, from difficulty 0 to 1, and one column for each of kinds. spacing: the side of a field, m. cell: between heights,
    m. border: as wide as so many fields. seed: of what is drawn."""

    rows: int = 6
    kinds: Sequence[str] = KINDS
    spacing: float = 8.0
    cell: float = 0.16
    border: int = 1
    seed: int = 1

    def __post_init__(self) -> None:
        unknown = set(self.kinds) - set(KINDS)
        if unknown or not self.kinds:
            raise ValueError(f"kinds of fields are {', '.join(KINDS)}, not {', '.join(sorted(unknown)) or 'none'}")
        if self.rows < 1 or self.border < 1 or not 0 < 4 * self.cell <= self.spacing:
            raise ValueError("rows and a border of 1 or more, and fields of 4 cells or more are expected")

    @property
    def cells(self) -> int:
        """Along a field's side."""
        return round(self.spacing / self.cell)

    def heights(self) -> Heights:
        """Of all points, m: a row for each y, the lowest first."""
        n, around = self.cells, self.border * self.cells
        out = np.zeros((len(self.kinds) * n + 2 * around + 1, self.rows * n + 2 * around + 1))
        for column, kind in enumerate(self.kinds):
            for row in range(self.rows):
                y, x = around + column * n, around + row * n
                difficulty = row / max(1, self.rows - 1)
                field = self._field(kind, difficulty, self.seed + 1000 * column + row)
                out[y:y + n + 1, x:x + n + 1] = np.where(self._platform(), 0.0, field)
        return out

    def _from_centre(self) -> Heights:
        """How far each point of a field is from its centre along x or y, whichever is more, m."""
        along = np.abs(np.arange(self.cells + 1) - self.cells / 2) * self.cell
        far: Heights = np.maximum(along[:, None], along[None, :])
        return far

    def _platform(self) -> NDArray[np.bool_]:
        far = self._from_centre()
        return (far < 0.09 * self.spacing) | (far > self.spacing / 2 - 0.5 * self.cell)

    def _field(self, kind: str, difficulty: float, seed: int) -> Heights:
        far, n = self._from_centre(), self.cells + 1
        if kind == "rough":
            return (2 * _uniform(n * n, seed).reshape(n, n) - 1) * (0.01 + 0.05 * difficulty)
        if kind == "blocks":
            drawn = _uniform(n * n, seed).reshape(n, n)
            side = max(1, round(0.5 / self.cell))
            blocks = np.repeat(np.repeat(drawn[::side, ::side], side, axis=0), side, axis=1)[:n, :n]
            return (2 * blocks - 1) * (0.02 + 0.1 * difficulty)
        # Up or down from the platform to a ring, and back to the border's height.
        inner, rim = far - 0.09 * self.spacing, self.spacing / 2 - far
        climb = np.clip(np.minimum(inner, rim), 0, None)
        if kind == "slope":
            return climb * (0.05 + 0.35 * difficulty)
        treads = np.floor(climb / (2 * self.cell))
        return treads * (0.02 + 0.13 * difficulty) * (1 if kind == "stairs_up" else -1)

    def mjcf(self) -> tuple[str, str]:
        """An asset and a geom of MJCF, on which the centre of the first row's and column's field is the origin."""
        heights = self.heights()
        low, high = float(heights.min()), max(float(heights.max()), float(heights.min()) + 1e-3)
        half_y, half_x = ((side - 1) * self.cell / 2 for side in heights.shape)
        middle = [(count - 1) * self.spacing / 2 for count in (self.rows, len(self.kinds))]
        numbers = " ".join(f"{x:.5f}" for x in ((heights - low) / (high - low)).ravel())
        asset = (f'<hfield name="landscape" nrow="{heights.shape[0]}" ncol="{heights.shape[1]}" '
                 f'size="{half_x:.9g} {half_y:.9g} {high - low:.9g} 0.5" elevation="{numbers}"/>')
        geom = f'<geom name="ground" type="hfield" hfield="landscape" pos="{middle[0]:.9g} {middle[1]:.9g} {low:.9g}"/>'
        return asset, geom


def _uniform(count: int, seed: int) -> Heights:
    """Numbers from 0 to 1 that no version of numpy changes."""
    raw = np.random.Philox(key=seed).random_raw(count)
    return np.asarray(raw >> np.uint64(11), float) * 2.0**-53
