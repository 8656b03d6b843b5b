# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
# %% [markdown]
# # First steps
# A world, a ball in it, and what becomes of the ball. Lengths are in m, masses in kg.

# %%
import numpy as np

import epode

world = epode.World(gravity=(0, 0, -9.81))
world.plane()
ball = world.body(mass=1, position=(0, 0, 2), shape=epode.Sphere(0.2), material=epode.Material(bounce=0.7))

# %% [markdown]
# A recording has the state after each step. In a notebook, a last line with `film` alone shows it as a page (if the package has it): drag to look around.

# %%
with world.record("A ball") as film:
    world.step(0.01, steps=200)
film.times[-1], len(film)

# %% [markdown]
# Its heights as an array. A ball that falls by 1.8 m and keeps 0.7 of its speed comes back to 0.2 + 0.49 * 1.8 m.

# %%
heights = film.trajectory(0)[:, 2]
top = heights[80:150].max()
print(f"came back to {top:.2f} m of {0.2 + 0.49 * 1.8:.2f} m")
assert abs(top - 1.082) < 0.04

# %% [markdown]
# States are bytes: go back, and forward again with the same bits.

# %%
state = world.save()
world.step(0.01, steps=50)
once = ball.position
world.load(state)
world.step(0.01, steps=50)
assert np.array_equal(once, ball.position)
