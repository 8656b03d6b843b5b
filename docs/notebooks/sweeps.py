# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
# %% [markdown]
# # Sweeps
# How far does a box slide, for which friction and slope? Every run is a row; [the guide](../guide/sweeps.md) has clusters and files.

# %%
import tempfile

import numpy as np

import epode


def slide(parameters, seed):
    angle = np.radians(parameters["slope"])
    world = epode.World(gravity=(9.81 * np.sin(angle), 0, -9.81 * np.cos(angle)))
    material = epode.Material(friction=parameters["friction"])
    world.plane(material=material)
    box = world.body(mass=1, shape=epode.Box(0.2, 0.2, 0.1), position=(0, 0, 0.05), material=material)
    world.step(0.01, steps=100)
    return {"distance": box.position[0], "world": world}


plan = epode.sweep.grid(slope=[10.0, 20.0, 30.0], friction=epode.sweep.linear(0.1, 0.7, 7))
folder = tempfile.mkdtemp()
table = epode.sweep.run(slide, plan, out=folder, executor="threads", chunk=4)
table.select(["slope", "friction", "distance", "state_hash"]).slice(0, 3).to_pylist()

# %% [markdown]
# Coulomb's law: it slides if tan(slope) is more than the friction, with the acceleration g (sin - friction cos).

# %%
slope, friction, distance = (table[name].to_numpy() for name in ("slope", "friction", "distance"))
angle = np.radians(slope)
law = 0.5 * 9.81 * np.maximum(0, np.sin(angle) - friction * np.cos(angle))
print("off the law by at most", abs(distance - law).max(), "m")
assert abs(distance - law).max() < 0.05

# %% [markdown]
# The same call again runs nothing: the rows are there.

# %%
epode.sweep.status(slide, plan, out=folder, chunk=4)
