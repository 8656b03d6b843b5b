# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
# %% [markdown]
# # Identification
# What are the mass at the end of a pendulum, and the damping of its joint? A motion was measured. Gauss and Newton's method finds the
# numbers whose motion is nearest: one batch simulates the guess, and the guess with each number a little changed.

# %%
import numpy as np

import epode

model = epode.robot.from_text("""<mujoco><worldbody><body name="rod" pos="0 0 2"><joint name="pivot" axis="0 1 0" damping="0.1"/>
<inertial pos=".3 0 -.4" mass="1" diaginertia=".02 .02 .02"/></body></worldbody><actuator><motor joint="pivot"/></actuator></mujoco>""")
times, h = 200, 0.005
rng = np.random.default_rng(1)
torques = 2 * np.sin(0.05 * np.arange(times))


def motion(guesses):
    """The angle at all times, a row for each guess (mass, damping)."""
    batch = epode.Batch(model, len(guesses), dtype="float64", stepsize=h)
    masses = batch.get("mass")
    masses[:, -1] = guesses[:, 0]
    batch.set("mass", masses)
    batch.set("damping", guesses[:, 1:])
    return batch.rollout(np.tile(torques[None, :, None], (len(guesses), 1, 1)))[0][:, :, 0]


truth = np.array([[1.7, 0.35]])
measured = motion(truth)[0] + rng.normal(0, 1e-3, times)

# %%
guess, change = np.array([1.0, 0.1]), 1e-6
for iteration in range(8):
    rows = motion(guess + change * np.array([[0, 0], [1, 0], [0, 1]]))
    slopes = (rows[1:] - rows[0]).T / change
    guess = guess + np.linalg.lstsq(slopes, measured - rows[0], rcond=None)[0]
    print(f"{iteration}: mass {guess[0]:.4f} kg, damping {guess[1]:.4f} N m s/rad, off by {np.std(measured - rows[0]):.2e} rad")

# %%
deviation = 1e-3 * np.sqrt(np.diag(np.linalg.inv(slopes.T @ slopes)))
print("truth", truth[0], "found", guess.round(4), "deviation", deviation)
assert (abs(guess - truth[0]) < 4 * deviation).all()
