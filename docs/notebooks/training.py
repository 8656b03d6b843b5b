# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
# %% [markdown]
# # Training
# 256 poles on carts, all stepped by one call. A linear policy learns to balance them by the cross-entropy method: each copy tries a gain
# of its own. [ppo.py](../../python/recipes/ppo.py) has the method for robots.

# %%
import numpy as np

import epode

copies = 256
env = epode.vector.make("InvertedPendulum", copies, infos=False)
rng = np.random.default_rng(3)


def steps_survived(gains, steps=300):
    observations, _ = env.reset(seed=7)
    alive, total = np.ones(copies, bool), np.zeros(copies)
    for _ in range(steps):
        actions = np.clip((gains * observations).sum(1, keepdims=True), -3, 3)
        observations, _, terminated, *_ = env.step(actions.astype(np.float32))
        alive &= ~terminated
        total += alive
    return total


# %%
mean, spread = np.zeros(4), np.full(4, 5.0)
for generation in range(6):
    gains = rng.normal(mean, spread, (copies, 4))
    survived = steps_survived(gains)
    best = gains[np.argsort(survived)[-26:]]
    mean, spread = best.mean(0), best.std(0) + 0.1
    print(f"generation {generation}: {survived.mean():.0f} steps in the mean, {survived.max():.0f} the best")

# %%
survived = steps_survived(np.tile(mean, (copies, 1)))
print(f"the mean gain {mean.round(1)} stands {survived.mean():.0f} of 300 steps, from {copies} starts")
assert survived.mean() > 290
