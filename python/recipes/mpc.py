# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""An arm that reaches by sampling: model predictive path integral control, its samples the copies of a batch.

Every 20 ms 256 copies of the arm, all in its state, try controls about the nominal ones for 0.4 s, twice; the new ones are their mean, weighted
by how well they did. The arm has motors, no servos, and gravity; halfway the target moves. Source: Williams, Aldrich, Theodorou, Model
predictive path integral control, J. Guid. Control Dyn. 40(2), 2017."""
import numpy as np
from numpy.typing import NDArray

import epode

Rows = NDArray[np.float64]
ARM = """<mujoco><compiler angle="radian"/><default><joint damping="0.3" armature="0.01" limited="true" range="-2.6 2.6"/></default><worldbody>
<body name="base" pos="0 0 0.5"><joint name="turn" axis="0 0 1"/><geom type="cylinder" size="0.06 0.04" mass="1"/>
<body name="upper"><joint name="shoulder" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0.4 0 0" size="0.04" mass="1.5"/>
<body name="lower" pos="0.4 0 0"><joint name="elbow" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0.35 0 0" size="0.03" mass="0.8"/>
<site name="hand" pos="0.38 0 0"/></body></body></body></worldbody>
<contact><exclude body1="base" body2="lower"/></contact>
<actuator><motor joint="turn" gear="10" ctrlrange="-1 1"/><motor joint="shoulder" gear="25" ctrlrange="-1 1"/>
<motor joint="elbow" gear="10" ctrlrange="-1 1"/></actuator></mujoco>"""
H, HOLD, HORIZON, SAMPLES = 0.005, 4, 20, 256  # s; steps of a control; controls of a horizon
HAND = np.array([0.38, 0, 0])
SPREADS, TEMPERATURE = (0.2, 0.03), 0.003  # of controls: far, then near


def hands(batch: epode.Batch, lower: int) -> Rows:
    """Where they are: a point of the last link."""
    place, turn = batch.read("xpos").reshape(batch.copies, -1, 3)[:, lower], batch.read("xquat").reshape(batch.copies, -1, 4)[:, lower]
    w, v = turn[:, :1], turn[:, 1:]
    twice = 2 * np.cross(v, HAND)
    hand: Rows = place + HAND + w * twice + np.cross(v, twice)
    return hand


class Sampler:
    """The nominal controls, (HORIZON, 3), and what improves them."""

    def __init__(self, model: epode.robot.Model, seed: int) -> None:
        self.batch = epode.Batch(model, SAMPLES, dtype="float32", stepsize=H, threads=1)
        self.lower = model.link_names.index("lower")
        self.nominal = np.zeros((HORIZON, 3))
        self._rng = np.random.default_rng(seed)

    def improve(self, qpos: Rows, qvel: Rows, target: Rows) -> Rows:
        """The next control, from a state."""
        for spread in SPREADS:
            self._sample(spread, qpos, qvel, target)
        control: Rows = self.nominal[0]
        return control

    def _sample(self, spread: float, qpos: Rows, qvel: Rows, target: Rows) -> None:
        noise = self._rng.normal(0, spread, (SAMPLES, HORIZON, 3))
        noise[0] = 0                                  # the nominal controls are a candidate, too
        for t in range(1, HORIZON):
            noise[:, t] = 0.7 * noise[:, t - 1] + 0.7 * noise[:, t]
        controls = np.clip(self.nominal + noise, -1, 1)
        self.batch.write("qpos", qpos)
        self.batch.write("qvel", qvel)
        cost = np.zeros(SAMPLES)
        for t in range(HORIZON):
            self.batch.write("ctrl", controls[:, t])
            self.batch.step(HOLD)
            off = np.linalg.norm(hands(self.batch, self.lower) - target, axis=1)
            cost += off + 0.01 * np.square(self.batch.read("qvel")).sum(axis=1) + 0.001 * np.square(controls[:, t]).sum(axis=1)
        weight = np.exp((cost.min() - cost) / (TEMPERATURE * HORIZON))
        self.nominal = np.tensordot(weight / weight.sum(), controls, 1)

    def advance(self) -> None:
        """A control has passed."""
        self.nominal = np.vstack([self.nominal[1:], self.nominal[-1:]])


def main(seconds: float = 4.0, *, seed: int = 0) -> Rows:
    """How far the hand is from its target, m, at each control."""
    model = epode.robot.from_text(ARM)
    arm, sampler = epode.Batch(model, 1, dtype="float64", stepsize=H, threads=1), Sampler(model, seed)
    targets = np.array([[0.3, 0.35, 0.7], [0.45, -0.3, 0.35]])
    count = round(seconds / (H * HOLD))
    distance = np.empty(count)
    for k in range(count):
        target = targets[2 * k // count]
        control = sampler.improve(arm.read("qpos")[0], arm.read("qvel")[0], target)
        sampler.advance()
        arm.write("ctrl", control)
        arm.step(HOLD)
        distance[k] = np.linalg.norm(hands(arm, sampler.lower)[0] - target)
    for end in (count // 2, count):
        print(f"after {end * H * HOLD:.1f} s the hand is within {1000 * distance[end - 20:end].max():.0f} mm of its target")
    return distance


if __name__ == "__main__":
    main()
