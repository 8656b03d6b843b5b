# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Hills from an array, and balls that roll into the valleys."""
import numpy as np

import epode


def main() -> epode.World:
    x, y = np.meshgrid(np.linspace(-10, 10, 81), np.linspace(-10, 10, 81))
    heights = 0.8 * np.sin(0.9 * x) * np.cos(0.8 * y) + 0.02 * (x ** 2 + y ** 2)  # heights[j, i]: j along y, i along x
    world = epode.World()
    world.geom(epode.HeightField(heights, width=20, depth=20), material=epode.Material(friction=0.8))
    for i in range(-3, 4):
        for j in range(-3, 4):
            world.body(density=300, shape=epode.Sphere(0.25), position=(2.3 * i, 2.3 * j, 2.0))
    for ball in world.bodies:
        ball.angular_damping = 0.02
    world.step(0.01, stepper="quick", steps=800)
    ground = world.rays(world.bodies.position + (0, 0, 5), (0, 0, -1))["pos"][:, 2] - 0.5  # under each ball, whose top is hit
    print(f"{len(ground)} balls lie {np.mean(ground):.2f} m high in the mean, the land is {np.mean(heights):.2f} m high")
    return world


if __name__ == "__main__":
    import sys
    if len(sys.argv) > 1:
        main().picture(sys.argv[1], width=800, height=450, eye=(13, -16, 10), target=(0, 0, 0))
    else:
        main()
