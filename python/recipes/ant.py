# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Sampling for reinforcement learning: gymnasium's Ant, many worlds at once, arrays in and arrays out.

The robot is the file that gymnasium brings along (``pip install epode[gym]``); task, rewards and ends of an episode are those
of its ``Ant-v5`` without contact forces. What has ended begins again in the same step."""
import importlib.util
import os
import time
from typing import Any

import numpy as np
from numpy.typing import NDArray

import epode

Rows = NDArray[np.float64]
Flags = NDArray[np.bool_]
H, FRAMES = 0.01, 5  # seconds of a step of the engine, steps of the engine in one of the environment


def ant_file() -> str:
    """Where gymnasium keeps the Ant."""
    found = importlib.util.find_spec("gymnasium")
    if found is None or found.origin is None:
        raise ImportError("the Ant is gymnasium's: pip install epode[gym]")
    return os.path.join(os.path.dirname(found.origin), "envs", "mujoco", "assets", "ant.xml")


class AntVector:
    """Many Ants, with the habits of gymnasium's vector environments. Actions: 8 torques from -1 to 1 for each Ant; observations:
    27 numbers, which are positions without x and y, then velocities."""

    def __init__(self, count: int, *, seed: int = 0, stepper: str = "hybrid", threads: int = 0) -> None:
        model = epode.load(ant_file())
        self.robots = epode.robot.Robots(
            model.build(epode.World(gravity=model.gravity, defaults="robot")) for _ in range(count))
        self.num_envs, self.stepper, self.threads = count, stepper, threads
        self._worlds = self.robots.worlds
        self._torsos = epode.BodyGroup(body for robot in self.robots if (body := robot.body("torso")) is not None)
        self._rng = np.random.default_rng(seed)
        self._start = self._worlds[0].save()          # all worlds have the same structure: one state resets any of them
        self.steps = np.zeros(count, np.int64)        # of each episode

    def reset(self, *, seed: int | None = None) -> tuple[Rows, dict[str, Any]]:
        """All Ants begin, each a little different."""
        if seed is not None:
            self._rng = np.random.default_rng(seed)
        self._begin(np.ones(self.num_envs, bool))
        return self._observe(), {}

    def _begin(self, which: Flags) -> None:
        chosen = epode.robot.Robots(self.robots[i] for i in np.flatnonzero(which))
        for world in chosen.worlds:
            world.load(self._start)                   # also what cannot be read: warm starts, contacts
        model = self.robots.model
        positions = chosen.positions + self._rng.uniform(-0.1, 0.1, (len(chosen), model.position_count))
        positions[:, 3:7] /= np.linalg.norm(positions[:, 3:7], axis=1, keepdims=True)
        chosen.positions = positions
        chosen.velocities = 0.1 * self._rng.standard_normal((len(chosen), model.velocity_count))
        self.steps[which] = 0

    def _observe(self) -> Rows:
        return np.hstack([self.robots.positions[:, 2:], self.robots.velocities])

    def step(self, actions: Rows) -> tuple[Rows, Rows, Flags, Flags, dict[str, Any]]:
        """One step of each: observations, rewards, which have fallen, which have had their 1000 steps, and more."""
        actions = np.clip(actions, -1, 1)
        self.robots.control(actions)
        before = self._torsos.get("position")
        epode.step_worlds(self._worlds, H, stepper=self.stepper, steps=FRAMES, threads=self.threads)
        after = self._torsos.get("position")
        forward = (after[:, 0] - before[:, 0]) / (H * FRAMES)
        healthy = np.isfinite(after).all(axis=1) & (after[:, 2] >= 0.2) & (after[:, 2] <= 1.0)
        rewards = forward + healthy - 0.5 * np.square(actions).sum(axis=1)
        self.steps += 1
        terminated, truncated = ~healthy, self.steps >= 1000
        observations = self._observe()
        info: dict[str, Any] = {"x_velocity": forward, "height": after[:, 2]}
        ended = terminated | truncated
        if ended.any():
            info["final_obs"] = observations[ended]
            self._begin(ended)
            observations = self._observe()
        return observations, rewards, terminated, truncated, info


def main(count: int = 64, steps: int = 100) -> dict[str, Rows]:
    ants = AntVector(count)
    rng = np.random.default_rng(1)
    ants.reset(seed=1)
    seen: dict[str, list[Rows]] = {"rewards": [], "heights": [], "fallen": []}
    begin = time.perf_counter()
    for _ in range(steps):
        _, rewards, terminated, _, info = ants.step(rng.uniform(-1, 1, (count, 8)))
        for name, values in (("rewards", rewards), ("heights", info["height"]), ("fallen", terminated.astype(float))):
            seen[name].append(values)
    seconds = time.perf_counter() - begin
    result = {name: np.array(values) for name, values in seen.items()}
    print(f"{count} Ants: {count * steps / seconds:.0f} steps of the environment a second, mean reward {result['rewards'].mean():.2f}, "
          f"mean height {result['heights'].mean():.2f} m, {int(result['fallen'].sum())} fell")
    return result


if __name__ == "__main__":
    main()
