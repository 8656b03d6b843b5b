# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A pendulum: a rod on a hinge. Its period is that of the textbook, and its energy stays."""
import math

import epode

LENGTH = 1.0


def main() -> float:
    with epode.World() as world:
        rod = world.body(mass=1, shape=epode.Capsule(0.02, LENGTH), position=(0, 0, -LENGTH / 2))
        hinge = world.joint("hinge", rod, anchor=(0, 0, 0), axis=(0, 1, 0))
        world.exact_substeps = 10                     # the energy of ten short steps at the price of one contact search
        rod.angular_velocity = (0, 0.3, 0)
        rod.velocity = (-0.3 * LENGTH / 2, 0, 0)      # swings about the hinge from the first step on

        passes = []                                   # when it passes the lowest point, forwards
        before = hinge.position()
        for step in range(2000):
            world.step(0.005)
            now = hinge.position()
            if before < 0 <= now or before > 0 >= now:
                passes.append(0.005 * (step + now / (now - before)))
            before = now
        measured = 2 * (passes[-1] - passes[0]) / (len(passes) - 1)
        inertia = rod.inertia[1, 1] + rod.mass * (LENGTH / 2) ** 2
        print(f"period {measured:.4f} s, small swings {2 * math.pi * math.sqrt(inertia / (rod.mass * 9.81 * LENGTH / 2)):.4f} s")
        return measured


if __name__ == "__main__":
    main()
