# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Swinging a pole up on a cart: iLQR on the derivatives of a batch.

The steps of a trajectory are the copies of one batch, so one call linearises all of them; candidates of the line search are the copies
of another, so one rollout tries all step lengths. Source: Tassa, Erez, Todorov, Synthesis and stabilization of complex behaviors through
online trajectory optimization, IROS 2012."""
import numpy as np
from numpy.typing import NDArray

import epode

Rows = NDArray[np.float64]
CART_POLE = """<mujoco><compiler angle="radian"/><worldbody><body name="cart"><joint name="rail" type="slide" axis="1 0 0" damping="0.1"/>
<geom type="box" size="0.1 0.05 0.05" mass="1"/><body name="pole"><joint name="hinge" axis="0 1 0" damping="0.002"/>
<geom type="capsule" fromto="0 0 0 0 0 0.6" size="0.02" mass="0.2"/></body></body></worldbody>
<actuator><motor joint="rail" ctrlrange="-10 10"/></actuator></mujoco>"""
H, STEPS, CANDIDATES = 0.02, 150, 12
EFFORT, FINAL = 1e-3, np.array([20.0, 400.0, 4.0, 20.0])  # of cart, angle, and their speeds, at the end


class Swing:
    """States are rows of x, angle (0: upright) and their speeds."""

    def __init__(self) -> None:
        model = epode.robot.from_text(CART_POLE)
        self.steps = epode.Batch(model, STEPS, dtype="float64", stepsize=H, threads=1)
        self.tries = epode.Batch(model, CANDIDATES, dtype="float64", stepsize=H, threads=1)
        self.start = np.array([0, np.pi, 0, 0])

    def cost(self, states: Rows, controls: Rows) -> Rows:
        """Of trajectories (n, STEPS + 1, 4) and (n, STEPS)."""
        effort = EFFORT * np.square(controls).sum(axis=1)
        way = H * (1 - np.cos(states[:, :-1, 1]) + 0.1 * np.square(states[:, :-1, 0])).sum(axis=1)
        cost: Rows = effort + way + 0.5 * (np.square(states[:, -1]) * FINAL).sum(axis=1)
        return cost

    def rollout(self, states: Rows, controls: Rows, feed: Rows, gains: Rows) -> tuple[Rows, Rows]:
        """Each copy follows the trajectory with a share of the feed-forward of its own: 1, 1/2, 1/4 ..."""
        share = 0.5 ** np.arange(CANDIDATES)
        new_states, new_controls = np.empty((CANDIDATES, STEPS + 1, 4)), np.empty((CANDIDATES, STEPS))
        new_states[:, 0] = self.start
        self.tries.reset()
        self.tries.write("qpos", self.start[:2])
        for t in range(STEPS):
            off = new_states[:, t] - states[t]
            new_controls[:, t] = np.clip(controls[t] + share * feed[t] + off @ gains[t], -10, 10)
            self.tries.write("ctrl", new_controls[:, t, None])
            self.tries.step()
            new_states[:, t + 1] = np.hstack([self.tries.read("qpos"), self.tries.read("qvel")])
        return new_states, new_controls

    def improve(self, states: Rows, controls: Rows, damping: float) -> tuple[Rows, Rows]:
        """Feed-forward and gains, from the last step to the first."""
        self.steps.write("qpos", states[:-1, :2])
        self.steps.write("qvel", states[:-1, 2:])
        self.steps.write("ctrl", controls[:, None])
        a, b = self.steps.linearise()
        feed, gains = np.zeros(STEPS), np.zeros((STEPS, 4))
        slope, bend = FINAL * states[-1], np.diag(FINAL)
        for t in reversed(range(STEPS)):
            angle = states[t, 1]
            q = H * np.array([0.2 * states[t, 0], np.sin(angle), 0, 0])
            qq = H * np.diag([0.2, max(np.cos(angle), 0), 0, 0])
            u = 2 * EFFORT * controls[t] + b[t, :, 0] @ slope
            uu = 2 * EFFORT + b[t, :, 0] @ bend @ b[t, :, 0] + damping
            ux = b[t, :, 0] @ bend @ a[t]
            feed[t], gains[t] = -u / uu, -ux / uu
            slope = q + a[t].T @ slope + ux * feed[t]
            bend = qq + a[t].T @ bend @ a[t] + np.outer(ux, gains[t])
        return feed, gains


def main(rounds: int = 120, *, seed: int = 0) -> tuple[Rows, Rows]:
    swing = Swing()
    controls = np.random.default_rng(seed).normal(0, 1, STEPS)
    found, tried = swing.rollout(np.tile(swing.start, (STEPS + 1, 1)), controls, np.zeros(STEPS), np.zeros((STEPS, 4)))
    states, controls, damping = found[0], tried[0], 1.0
    best = swing.cost(found, tried)[0]
    for _ in range(rounds):
        found, tried = swing.rollout(states, controls, *swing.improve(states, controls, damping))
        costs = swing.cost(found, tried)
        chosen = int(costs.argmin())
        gain = best - costs[chosen]
        if gain > 0:
            best, states, controls = costs[chosen], found[chosen], tried[chosen]
            damping = max(damping / 2, 1e-6)
            if gain < 1e-6 * best:
                break
        else:
            damping = min(8 * damping, 1e6)
    print(f"after {STEPS * H:.0f} s the pole is {np.degrees(abs(states[-1, 1])):.2f} degrees from upright, the cart {states[-1, 0]:.3f} m "
          f"from the middle; the largest force is {np.abs(controls).max():.1f} N")
    return states, controls


if __name__ == "__main__":
    main()
