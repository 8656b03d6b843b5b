# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Names of our environments in Gymnasium's registry. Gymnasium calls this by itself (an entry point of the package)."""
from __future__ import annotations

# Names and steps of an episode.
LIMITS = {"Ant": 1000, "HalfCheetah": 1000, "Humanoid": 1000, "Hopper": 1000, "Walker2d": 1000, "Swimmer": 1000, "Reacher": 50, "Pusher": 100,
          "InvertedPendulum": 1000, "InvertedDoublePendulum": 1000, "CartPole": 500}


def register() -> None:
    """Adds ``Epode/Ant-v0`` and the others to Gymnasium's registry."""
    from gymnasium.envs.registration import register as add, registry

    for name, limit in LIMITS.items():
        full = f"Epode/{name}-v0"
        if full not in registry:
            add(id=full, entry_point="epode.vector:Scalar", vector_entry_point="epode.vector:make", max_episode_steps=limit,
                kwargs={"task": name})
