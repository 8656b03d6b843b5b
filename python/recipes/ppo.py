# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A robot learns: proximal policy optimisation in one file, numpy alone, on Epode's or anybody's Gymnasium vector.

Two networks with two hidden layers of tanh: the mean m(o) of a normal distribution of actions a with deviations exp(s), and the value
V(o). In each round all copies take T steps. Advantages are generalised ones: A_t = d_t + g l A_{t+1} within an episode, with
d_t = r_t + g V(o_{t+1}) - V(o_t), where V is 0 after an end that is no time limit. Then a few epochs of minibatches climb
min(q A, clip(q, 1 - e, 1 + e) A) with q = p(a) / p_old(a), and descend (V - V_target)^2, by Adam. The step of Adam is adapted to hold the
divergence from the old policy near a target. Observations are normalised, rewards divided by the deviation of the discounted return.
Gradients are written out: for networks of this size torch is no faster on a CPU, and from PyPI it brings 3 GB.

[Schulman et al., Proximal policy optimization algorithms, 2017; High-dimensional continuous control using generalized advantage
estimation, 2016]"""
import argparse
import time
from dataclasses import dataclass, field
from typing import Any

import gymnasium
import numpy as np
from numpy.typing import NDArray

import epode
import epode.vector  # registers Epode/Ant-v0

Array = NDArray[np.float32]


class Network:
    """Layers of tanh, the last one linear; with Adam."""

    def __init__(self, sizes: list[int], last_gain: float, rng: np.random.Generator, extra: int = 0) -> None:
        self.weights: list[Array] = []
        for number, (inputs, outputs) in enumerate(zip(sizes, sizes[1:])):
            square = np.linalg.qr(rng.normal(size=(max(inputs, outputs),) * 2))[0][:inputs, :outputs]
            gain = last_gain if number == len(sizes) - 2 else np.sqrt(2)
            self.weights += [(gain * square).astype(np.float32), np.zeros(outputs, np.float32)]
        self.weights += [np.zeros(extra, np.float32)] if extra else []
        self.layers = len(sizes) - 1
        self.moments = [(np.zeros_like(w), np.zeros_like(w)) for w in self.weights]
        self.steps = 0

    def forward(self, inputs: Array) -> list[Array]:
        """What each layer gives, the inputs first."""
        values = [inputs]
        for layer in range(self.layers):
            out = values[-1] @ self.weights[2 * layer] + self.weights[2 * layer + 1]
            values.append(out if layer == self.layers - 1 else np.tanh(out, out=out))
        return values

    def backward(self, values: list[Array], slope: Array) -> list[Array]:
        """The gradients of all weights, from the slope at the outputs."""
        gradients: list[Array] = []
        for layer in reversed(range(self.layers)):
            gradients[:0] = [values[layer].T @ slope, slope.sum(0)]
            if layer:
                slope = (slope @ self.weights[2 * layer].T) * (1 - values[layer] ** 2)
        return gradients

    def descend(self, gradients: list[Array], rate: float, longest: float = 1.0) -> None:
        """A step of Adam, with the gradient no longer than so."""
        self.steps += 1
        length = float(np.sqrt(sum(float((g * g).sum()) for g in gradients)))
        scale = np.float32(min(1.0, longest / (length + 1e-8)))
        ahead = rate * np.sqrt(1 - 0.999**self.steps) / (1 - 0.9**self.steps)
        for weight, gradient, (first, second) in zip(self.weights, gradients, self.moments):
            first += np.float32(0.1) * (scale * gradient - first)
            second += np.float32(0.001) * ((scale * gradient) ** 2 - second)
            weight -= np.float32(ahead) * first / (np.sqrt(second) + np.float32(1e-8))


class Scale:
    """Mean and variance of all that it has seen."""

    def __init__(self, size: int) -> None:
        self.mean, self.variance, self.count = np.zeros(size), np.ones(size), 1e-4

    def see(self, rows: NDArray[Any]) -> None:
        """Takes in more rows."""
        count, mean, variance = len(rows), rows.mean(0, dtype=float), rows.var(0, dtype=float)
        total, apart = self.count + count, mean - self.mean
        self.variance = (self.variance * self.count + variance * count + apart**2 * self.count * count / total) / total
        self.mean, self.count = self.mean + apart * count / total, total

    def apply(self, rows: NDArray[Any]) -> Array:
        """Rows with mean 0 and deviation 1, none beyond 10."""
        return np.asarray(np.clip((rows - self.mean) / np.sqrt(self.variance + 1e-8), -10, 10), np.float32)


@dataclass
class Settings:
    """What may be chosen."""

    steps: int = 64            # T, of a round
    epochs: int = 5
    minibatches: int = 8
    discount: float = 0.99
    decay: float = 0.95        # l
    clip: float = 0.2          # e
    divergence: float = 0.015  # of a round
    rate: float = 5e-4
    hidden: int = 64
    deviation: float = 0.6     # exp(s) at first


# Of tasks that need others. A gait is found by what noise does alone, and its commands change all the time: more noise, shorter rounds.
SETTINGS = {f"Epode/{name}-v0": Settings(steps=24, minibatches=4, divergence=0.02, deviation=1.0) for name in ("Quadruped", "RoughQuadruped")}


@dataclass
class Point:
    """Of the curve: after so many seconds and steps, the mean return of the last episodes."""

    seconds: float
    steps: int
    value: float


@dataclass
class Rollout:
    """A round: arrays (T, copies, ...)."""

    observations: list[Array] = field(default_factory=list)
    actions: list[Array] = field(default_factory=list)
    log_old: list[Array] = field(default_factory=list)
    rewards: list[Array] = field(default_factory=list)
    ends: list[NDArray[np.bool_]] = field(default_factory=list)
    done: list[NDArray[np.bool_]] = field(default_factory=list)
    counts: list[NDArray[np.bool_]] = field(default_factory=list)


class Learner:
    """Policy and value of an environment of continuous actions (autoreset mode NextStep)."""

    def __init__(self, env: Any, seed: int = 1, settings: Settings | None = None) -> None:
        self.env, self.settings, self.rng = env, settings or Settings(), np.random.default_rng(seed)
        inputs, outputs, hidden = env.single_observation_space.shape[0], env.single_action_space.shape[0], self.settings.hidden
        self.low, self.high = env.single_action_space.low, env.single_action_space.high
        self.policy = Network([inputs, hidden, hidden, outputs], 0.01, self.rng, extra=outputs)
        self.policy.weights[-1][:] = np.log(self.settings.deviation)
        self.value = Network([inputs, hidden, hidden, 1], 1.0, self.rng)
        self.scale, self.return_scale = Scale(inputs), Scale(1)
        self.rate, self.steps, self.returns = self.settings.rate, 0, [0.0]
        self.seen, _ = env.reset(seed=seed)
        self.begun = np.zeros(env.num_envs, bool)  # the next step begins an episode, and its action is ignored
        self.total, self.discounted = np.zeros(env.num_envs), np.zeros(env.num_envs)

    def act(self, observations: NDArray[Any]) -> Array:
        """The mean action."""
        return self.controls(self.policy.forward(self.scale.apply(observations))[-1])

    def controls(self, actions: NDArray[Any]) -> Array:
        """Actions from -1 to 1 as the environment has them."""
        return np.asarray(self.low + (np.clip(actions, -1, 1) + 1) * 0.5 * (self.high - self.low), np.float32)

    def log_probability(self, apart: NDArray[Any]) -> Array:
        """Of actions that are so many deviations apart from the mean, without a constant."""
        return np.asarray(-0.5 * (apart * apart).sum(-1) - self.policy.weights[-1].sum(), np.float32)

    def collect(self) -> Rollout:
        """Takes T steps."""
        rollout = Rollout()
        for _ in range(self.settings.steps):
            self.scale.see(self.seen)
            observed = self.scale.apply(self.seen)
            apart = self.rng.standard_normal((len(observed), len(self.low)), np.float32)
            actions = self.policy.forward(observed)[-1] + np.exp(self.policy.weights[-1]) * apart
            self.seen, rewards, ends, cut, _ = self.env.step(self.controls(actions))
            self.count(rewards, ends | cut)
            rewards = rewards / np.sqrt(self.return_scale.variance + 1e-8)
            for kept, value in zip(vars(rollout).values(), (observed, actions, self.log_probability(apart), rewards.astype(np.float32), ends, ends | cut,
                                                            ~self.begun)):
                kept.append(value)
            self.begun = ends | cut
        rollout.observations.append(self.scale.apply(self.seen))
        return rollout

    def count(self, rewards: NDArray[Any], done: NDArray[np.bool_]) -> None:
        """Keeps account of returns."""
        self.steps += len(done)
        self.total = np.where(self.begun, 0, self.total + rewards)
        self.discounted = np.where(self.begun, 0, self.settings.discount * self.discounted + rewards)
        self.return_scale.see(self.discounted[:, None])
        self.returns = [*self.returns, *self.total[done & ~self.begun].tolist()][-100:]

    def advantages(self, rollout: Rollout) -> tuple[Array, Array]:
        """A and V_target, (T, copies)."""
        values = np.array([self.value.forward(o)[-1][:, 0] for o in rollout.observations])
        result, later, settings = np.zeros_like(values[:-1]), np.float32(0) * values[0], self.settings
        for t in reversed(range(len(result))):
            d = rollout.rewards[t] + settings.discount * values[t + 1] * ~rollout.ends[t] - values[t]
            later = d + settings.discount * settings.decay * ~rollout.done[t] * later
            result[t] = later
        return result, result + values[:-1]

    def improve(self, rollout: Rollout) -> None:
        """The epochs over a round."""
        advantages, targets = self.advantages(rollout)
        used = np.array(rollout.counts).ravel()
        flat = [np.array(rows).reshape(len(used), -1)[used] for rows in (rollout.observations[:-1], rollout.actions, rollout.log_old, advantages, targets)]
        for _ in range(self.settings.epochs):
            for part in np.array_split(self.rng.permutation(len(flat[0])), self.settings.minibatches):
                observed, actions, log_old, gains, aims = (rows[part] for rows in flat)
                self.climb(observed, actions, log_old[:, 0], (gains[:, 0] - gains.mean()) / (gains.std() + 1e-8))
                values = self.value.forward(observed)
                self.value.descend(self.value.backward(values, (values[-1] - aims) / np.float32(len(aims))), self.rate)

    def climb(self, observed: Array, actions: Array, log_old: Array, gains: Array) -> None:
        """A step of the policy, and of the rate."""
        values = self.policy.forward(observed)
        deviation = np.exp(self.policy.weights[-1])
        apart = (actions - values[-1]) / deviation
        log_ratio = self.log_probability(apart) - log_old
        ratio = np.exp(log_ratio)
        free = np.where(gains > 0, ratio < 1 + self.settings.clip, ratio > 1 - self.settings.clip)
        slope = (-(free * gains * ratio) / np.float32(len(gains)))[:, None]
        gradients = self.policy.backward(values, slope * apart / deviation)
        self.policy.descend([*gradients, (slope * (apart * apart - 1)).sum(0)], self.rate)
        np.clip(self.policy.weights[-1], -2.5, 0.5, out=self.policy.weights[-1])
        divergence = float((ratio - 1 - log_ratio).mean())
        if divergence > 2 * self.settings.divergence:
            self.rate = max(1e-5, self.rate / 1.2)
        elif divergence < 0.5 * self.settings.divergence:
            self.rate = min(2e-3, self.rate * 1.05)

    def learn(self, seconds: float = np.inf, steps: float = np.inf, enough: float = np.inf, shown: bool = False) -> list[Point]:
        """Rounds until so many seconds, steps, or this mean return of the last 100 episodes. Returns the curve."""
        begin, curve = time.perf_counter(), list[Point]()
        while not curve or (curve[-1].seconds < seconds and self.steps < steps and curve[-1].value < enough):
            self.improve(self.collect())
            curve.append(Point(time.perf_counter() - begin, self.steps, float(np.mean(self.returns))))
            if shown:
                print(f"{curve[-1].seconds:7.1f} s {self.steps:10,} steps  return {curve[-1].value:8.1f}", flush=True)
        return curve


def film(learner: Learner, seconds: float = 10.0) -> epode.Recording:
    """The policy without noise, in copy 0 of an environment of Epode's: to save as a page, or to look at."""
    env = learner.env
    observations, _ = env.reset(seed=99)
    with env.batch.record(0, title="what was learnt") as recording:
        for _ in range(round(seconds / (env.batch.stepsize * env.task.frame_skip))):
            observations, *_ = env.step(learner.act(observations))
    return recording  # type: ignore[no-any-return]


def main(name: str = "Epode/InvertedPendulum-v0", copies: int = 64, seconds: float = 60, enough: float = np.inf, seed: int = 1,
         shown: bool = True, **options: Any) -> tuple[Learner, list[Point]]:
    """Learns; returns the learner and its curve."""
    env = gymnasium.make_vec(name, num_envs=copies, **options)
    learner = Learner(env, seed, SETTINGS.get(name))
    return learner, learner.learn(seconds, enough=enough, shown=shown)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("name", nargs="?", default="Epode/InvertedPendulum-v0", help="Epode/Ant-v0, Ant-v5, ...")
    parser.add_argument("--copies", type=int, default=64)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--film", help="file.html, .epr, .glb or .csv of ten seconds (environments of Epode's)")
    given = parser.parse_args()
    learnt, _ = main(given.name, given.copies, given.seconds, seed=given.seed)
    if given.film:
        film(learnt).save(given.film)
