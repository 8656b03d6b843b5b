# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Many worlds in one call: 200 carts balance their poles, each with gains of its own; the best are kept."""
import numpy as np

import epode


class CartPole:
    """A cart on a rail, with a pole on it."""

    def __init__(self) -> None:
        self.world = epode.World(contacts=False)
        self.cart = self.world.body(mass=1, shape=epode.Box(0.4, 0.2, 0.2))
        self.pole = self.world.body(mass=0.2, shape=epode.Capsule(0.02, 1.0), position=(0, 0, 0.5))
        self.rail = self.world.joint("slider", self.cart, axis=(1, 0, 0))
        self.hinge = self.world.joint("hinge", self.pole, self.cart, anchor=(0, 0, 0), axis=(0, 1, 0))
        self.pole.angular_velocity = (0, 0.3, 0)


def survived(gains: np.ndarray[tuple[int, int], np.dtype[np.float64]]) -> np.ndarray[tuple[int], np.dtype[np.int64]]:
    """How many steps each pole stands."""
    carts = [CartPole() for _ in gains]
    worlds = [cart.world for cart in carts]
    steps = np.zeros(len(carts), np.int64)
    standing = np.ones(len(carts), bool)
    for _ in range(200):
        for cart, (a, b, c, d) in zip(carts, gains):
            state = cart.hinge.position(), cart.hinge.rate(), cart.rail.position(), cart.rail.rate()
            cart.cart.add_force((float(np.clip(np.dot((a, b, c, d), state), -30, 30)), 0, 0))
        epode.step_worlds(worlds, 0.02, stepper="exact", threads=0)
        standing &= np.array([abs(cart.hinge.position()) < 0.6 and abs(cart.rail.position()) < 2.4 for cart in carts])
        steps += standing
    return steps


def main() -> int:
    rng = np.random.default_rng(3)
    mean, spread = np.zeros(4), np.array([40.0, 10.0, 5.0, 5.0])
    best = 0
    for generation in range(3):                       # cross-entropy: move towards the best tenth
        gains = rng.normal(mean, spread, (200, 4))
        steps = survived(gains)
        elite = gains[np.argsort(steps)[-20:]]
        mean, spread = elite.mean(axis=0), elite.std(axis=0) + 0.5
        best = int(steps.max())
        print(f"generation {generation}: the best stands {best} steps, the mean {steps.mean():.0f}")
    return best


if __name__ == "__main__":
    main()
