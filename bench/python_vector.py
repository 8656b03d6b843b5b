#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Ants for reinforcement learning, Epode's recipe compared with gymnasium's own vector environments on MuJoCo, in the same minutes and on
the same random actions: python_vector.py [COUNT], in an environment with epode, gymnasium and mujoco. Both have 5 steps of 0.01 s in
one of the environment; the fastest of some rounds in turn counts, since the machine may be busy. Next to the time: mean height and
mean forward speed of the torso, and how many episodes end, since a fast engine that is another machine would be no use."""
import importlib.util
import pathlib
import sys
import time

import numpy as np

RECIPE = pathlib.Path(__file__).resolve().parent.parent / "python" / "recipes" / "ant.py"
STEPS, ROUNDS = 50, 5


def recipe():
    spec = importlib.util.spec_from_file_location("ant", RECIPE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Runner:
    """An environment, its best time, and what was seen in it."""

    def __init__(self, name, environment, height_of):
        self.name, self.environment, self.height_of = name, environment, height_of
        self.best, self.heights, self.ended, self.forward = float("inf"), [], 0, []
        self.environment.reset(seed=1)

    def round(self, actions):
        begin = time.perf_counter()
        for action in actions:
            observations, rewards, terminated, truncated, info = self.environment.step(action)
            self.heights.append(self.height_of(observations, info))
            self.ended += int(np.sum(terminated))
            self.forward.append(np.mean(info["x_velocity"]))
        self.best = min(self.best, (time.perf_counter() - begin) / len(actions))


def gym(kind, count):
    import gymnasium
    return gymnasium.make_vec("Ant-v5", num_envs=count, vectorization_mode=kind,
                              include_cfrc_ext_in_observation=False)


def main(count):
    ant = recipe()
    runners = [Runner(f"epode {stepper}", ant.AntVector(count, stepper=stepper), lambda o, info: info["height"].mean())
               for stepper in ("hybrid", "exact", "substeps", "quick")]
    runners += [Runner(f"gymnasium {kind}", gym(kind, count), lambda o, info: o[:, 0].mean()) for kind in ("sync", "async")]
    rng = np.random.default_rng(3)
    for _ in range(ROUNDS):
        actions = rng.uniform(-1, 1, (STEPS, count, 8)).astype(np.float32)
        for runner in runners:
            runner.round(actions)
    print(f"{count} Ants, {ROUNDS} rounds of {STEPS} steps")
    for r in runners:
        print(f"{r.name:18} {count / r.best:9.0f} steps a second   height {np.mean(r.heights):.3f} m   "
              f"forward {np.mean(r.forward):+.3f} m/s   {r.ended} fell")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 64)
