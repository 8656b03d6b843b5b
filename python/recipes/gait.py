# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A gait by evolution: CMA-ES over the rhythm of the half-cheetah, a population a batch.

Each of its six motors follows a sine of its own amplitude, phase and offset, all at one frequency: 19 numbers, and the distance after
4 s is what counts. The robot is gymnasium's file (``pip install epode[gym]``). Source: Hansen, The CMA evolution strategy: a tutorial,
arXiv:1604.00772."""
import importlib.util
import os

import numpy as np
from numpy.typing import NDArray

import epode

Rows = NDArray[np.float64]
H, HOLD, SECONDS, MOTORS = 0.01, 5, 4.0, 6


class Evolution:
    """CMA-ES: a normal distribution that learns from the better half of what it samples; the least value is best."""

    def __init__(self, mean: Rows, spread: float, population: int, seed: int) -> None:
        n = len(mean)
        self.mean, self.spread, self.population = mean.copy(), spread, population
        self._rng = np.random.default_rng(seed)
        weight = np.log((population + 1) / 2) - np.log(np.arange(1, population // 2 + 1))
        self._weight = weight / weight.sum()
        mass = 1 / np.square(self._weight).sum()
        self._path_rate, self._step_rate = (4 + mass / n) / (n + 4 + 2 * mass / n), (mass + 2) / (n + mass + 5)
        self._rank_one = 2 / ((n + 1.3) ** 2 + mass)
        self._rank_many = min(1 - self._rank_one, 2 * (mass - 2 + 1 / mass) / ((n + 2) ** 2 + mass))
        self._damping = 1 + 2 * max(0.0, np.sqrt((mass - 1) / (n + 1)) - 1) + self._step_rate
        self._length = np.sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n))  # of a normal vector
        self._mass, self._covariance, self._path, self._step_path = mass, np.eye(n), np.zeros(n), np.zeros(n)
        self._generation = 0

    def sample(self) -> Rows:
        """(population, n) candidates."""
        root, axes = np.linalg.eigh(self._covariance)
        self._root, self._axes = np.sqrt(np.maximum(root, 1e-20)), axes
        self._steps = (self._rng.standard_normal((self.population, len(self.mean))) * self._root) @ axes.T
        candidates: Rows = self.mean + self.spread * self._steps
        return candidates

    def learn(self, values: Rows) -> None:
        """What the candidates are worth; the less the better."""
        self._generation += 1
        steps = self._steps[np.argsort(values, kind="stable")[:len(self._weight)]]
        step = self._weight @ steps
        self.mean = self.mean + self.spread * step
        white = self._axes @ ((self._axes.T @ step) / self._root)
        c, d = self._step_rate, self._path_rate
        self._step_path = (1 - c) * self._step_path + np.sqrt(c * (2 - c) * self._mass) * white
        length = np.linalg.norm(self._step_path)
        calm = length / np.sqrt(1 - (1 - c) ** (2 * self._generation)) < (1.4 + 2 / (len(step) + 1)) * self._length
        self._path = (1 - d) * self._path + calm * np.sqrt(d * (2 - d) * self._mass) * step
        kept = 1 - self._rank_one - self._rank_many + (not calm) * self._rank_one * d * (2 - d)
        self._covariance = (kept * self._covariance + self._rank_one * np.outer(self._path, self._path)
                            + self._rank_many * (steps.T * self._weight) @ steps)
        self.spread *= float(np.exp(c / self._damping * (length / self._length - 1)))


def controls_of(gaits: Rows, time: float) -> Rows:
    """Of gaits (n, 19): amplitudes, phases, offsets, frequency about 2 Hz."""
    amplitude, phase, offset = np.split(gaits[:, :3 * MOTORS], 3, axis=1)
    wave = np.sin(2 * np.pi * (2 + gaits[:, -1:]) * time + 3 * phase)
    controls: Rows = np.clip(amplitude * wave + 0.5 * offset, -1, 1)
    return controls


def distances(batch: epode.Batch, gaits: Rows) -> Rows:
    """How far each goes, m; those that lie on their backs count nothing."""
    batch.reset()
    for k in range(round(SECONDS / (H * HOLD))):
        batch.write("ctrl", controls_of(gaits, k * H * HOLD))
        batch.step(HOLD)
    qpos = batch.read("qpos").astype(float)
    return np.where(np.abs(qpos[:, 2]) < 1, qpos[:, 0], 0)


def main(generations: int = 60, population: int = 32, *, seed: int = 0) -> Rows:
    """The best distance of each generation."""
    found = importlib.util.find_spec("gymnasium")
    if found is None or found.origin is None:
        raise ImportError("the half-cheetah is gymnasium's: pip install epode[gym]")
    model = epode.load(os.path.join(os.path.dirname(found.origin), "envs", "mujoco", "assets", "half_cheetah.xml"))
    batch, evolution = epode.Batch(model, population, stepsize=H, threads=1), Evolution(np.zeros(3 * MOTORS + 1), 0.5, population, seed)
    best = []
    for _ in range(generations):
        way = distances(batch, evolution.sample())
        evolution.learn(-way)
        best.append(way.max())
    print(f"{best[0]:.1f} m in {SECONDS:.0f} s at first, {best[-1]:.1f} m after {generations} generations of {population}")
    return np.array(best)


if __name__ == "__main__":
    main()
