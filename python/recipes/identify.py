# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What does the arm weigh? Gauss-Newton over masses and dampings, from two seconds of motion and the derivatives of a batch.

The steps of the predicted trajectory are the copies of one batch, which linearises all of them at once. With A_t = d(next)/d(state) and
P_t = d(next)/d(numbers) the prediction's sensitivity is S_t+1 = A_t S_t + P_t, and numbers move by the least squares of S dp = measured -
predicted. Inertias follow their links' masses."""
import numpy as np
from numpy.typing import NDArray

import epode

Rows = NDArray[np.float64]
ARM = """<mujoco><compiler angle="radian"/><default><joint armature="0.02"/></default><worldbody><body name="upper" pos="0 0 1">
<joint name="shoulder" axis="0 1 0" damping="0.5"/><geom type="capsule" fromto="0 0 0 0.4 0 0" size="0.04" mass="2"/>
<body name="lower" pos="0.4 0 0"><joint name="elbow" axis="0 1 0" damping="0.5"/><geom type="capsule" fromto="0 0 0 0.35 0 0" size="0.03" mass="2"/>
<body name="hand" pos="0.35 0 0"><joint name="wrist" axis="0 0 1" damping="0.5"/><geom type="box" pos="0.06 0 0" size="0.06 0.02 0.05" mass="2"/>
</body></body></body></worldbody><contact><exclude body1="upper" body2="hand"/><exclude body1="upper" body2="lower"/>
<exclude body1="lower" body2="hand"/></contact><actuator><motor joint="shoulder" gear="20"/><motor joint="elbow" gear="10"/>
<motor joint="wrist" gear="3"/></actuator></mujoco>"""
H, STEPS = 0.004, 500
TRUE = np.array([1.6, 0.9, 0.55, 0.3, 0.22, 0.08])  # masses of the links, kg; dampings of the joints, N m s


def excitation() -> Rows:
    """Controls that move every joint: sums of sines, (STEPS, 3)."""
    t = H * np.arange(STEPS)[:, None]
    controls: Rows = 0.5 * np.sin(2 * np.pi * np.array([0.9, 1.7, 2.3]) * t) + 0.4 * np.sin(2 * np.pi * np.array([2.1, 0.6, 3.1]) * t + 1)
    return controls


def set_numbers(batch: epode.Batch, numbers: Rows) -> None:
    batch.set("mass", np.concatenate([[0], numbers[:3]]))
    batch.set("damping", numbers[3:])


class Predictor:
    """Trajectories of the arm for given numbers, and how they depend on them."""

    def __init__(self) -> None:
        model = epode.robot.from_text(ARM)
        self.one = epode.Batch(model, 1, dtype="float64", stepsize=H, threads=1)
        self.steps = epode.Batch(model, STEPS, dtype="float64", stepsize=H, threads=1)
        self.controls = excitation()

    def trajectory(self, numbers: Rows) -> Rows:
        """(STEPS + 1, 6): angles and their speeds."""
        set_numbers(self.one, numbers)
        self.one.reset()
        qpos, qvel = self.one.rollout(self.controls[None])
        return np.vstack([np.zeros(6), np.hstack([qpos[0], qvel[0]])])

    def sensitivity(self, numbers: Rows, states: Rows) -> Rows:
        """(STEPS + 1, 6, 6): of states by numbers."""
        set_numbers(self.steps, numbers)
        self.steps.write("qpos", states[:-1, :3])
        self.steps.write("qvel", states[:-1, 3:])
        self.steps.write("ctrl", self.controls)
        a, _ = self.steps.linearise()
        p = np.concatenate([self.steps.linearise_parameter("mass")[:, :, 1:], self.steps.linearise_parameter("damping")], axis=2)
        out = np.zeros((STEPS + 1, 6, 6))
        for t in range(STEPS):
            out[t + 1] = a[t] @ out[t] + p[t]
        return out


def identify(predictor: Predictor, measured: Rows, guess: Rows, rounds: int = 10) -> Rows:
    """Numbers whose predicted angles (STEPS + 1, 3) are nearest to those measured. The beginning of the motion is fitted first: over a
    long time a wrong arm is somewhere else, and slopes there say little. A step that makes things worse is halved."""
    numbers = guess.copy()
    for end in (STEPS // 8, STEPS // 3, STEPS):
        off = measured[:end] - predictor.trajectory(numbers)[:end, :3]
        for _ in range(rounds):
            slope = predictor.sensitivity(numbers, predictor.trajectory(numbers))[:end, :3].reshape(-1, 6)
            change = np.linalg.lstsq(slope, off.ravel(), rcond=None)[0]
            for _ in range(8):
                tried = np.maximum(numbers + change, 0.2 * numbers)
                left = measured[:end] - predictor.trajectory(tried)[:end, :3]
                if np.square(left).sum() < np.square(off).sum():
                    numbers, off = tried, left
                    break
                change = change / 2
            else:
                break                                 # nothing is nearer
    return numbers


def main(noise: float = 1e-3, *, seed: int = 0) -> Rows:
    """Relative errors of masses and dampings, from angles with a noise in rad."""
    predictor = Predictor()
    angles = predictor.trajectory(TRUE)[:, :3]
    measured = angles + np.random.default_rng(seed).normal(0, noise, angles.shape)
    found = identify(predictor, measured, np.array([2.0, 2.0, 2.0, 0.5, 0.5, 0.5]))
    error: Rows = np.abs(found / TRUE - 1)
    print(f"masses {found[:3].round(4)} kg, dampings {found[3:].round(4)} N m s: within {100 * error.max():.2f} %")
    return error


if __name__ == "__main__":
    main()
