# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A game that predicts: when the other player's input arrives late, take steps back, and play them again with it."""
import numpy as np

import epode


def play(world: epode.World, car: epode.Body, forces: dict[int, float], first: int, last: int) -> None:
    """Steps first to last, with the input of each."""
    for step in range(first, last):
        car.add_force((forces.get(step, 0.0), 0, 0))
        world.step(1 / 60)


def main() -> bool:
    late = {20: 900.0, 21: 900.0}                     # was given at step 20, and arrives at step 26
    worlds = []
    for _ in range(2):
        world = epode.World()
        world.plane()
        car = world.body(mass=10, shape=epode.Box(1, 0.5, 0.3), position=(0, 0, 0.15))
        for i in range(5):
            world.body(mass=1, shape=epode.Box(0.3, 0.3, 0.3), position=(1.2, 0, 0.15 + 0.3 * i))
        worlds.append((world, car))
    (guessing, car), (knowing, other) = worlds
    guessing.history = 10                             # so many steps can be taken back
    play(guessing, car, {}, 0, 26)                    # nothing known of the input
    guessing.roll_back(6)
    play(guessing, car, late, 20, 60)                 # now it is
    play(knowing, other, late, 0, 60)
    same = bool(np.array_equal(guessing.bodies.get("position", "quaternion", "velocity"),
                               knowing.bodies.get("position", "quaternion", "velocity")))
    print(f"{'the same bits' if same else 'something else'} as in a world that knew the input in time")
    return same


if __name__ == "__main__":
    main()
