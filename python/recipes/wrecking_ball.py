# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Two tonnes on a chain of links of a kilogram each swing through a wall, and the chain holds."""
import sys

import numpy as np

import epode

LINKS, LENGTH, HOLD = 11, 0.3, np.array((-3.0, 0.0, 6.0))
LEVEL = (np.sqrt(0.5), 0, np.sqrt(0.5), 0)  # from z to x


def chain(world: epode.World) -> tuple[epode.Body, list[epode.Joint]]:
    """The ball, and the joints from the hold to it; the chain is level."""
    joints: list[epode.Joint] = []
    before = None
    for i in range(LINKS):
        link = world.body(mass=1, shape=epode.Capsule(0.04, LENGTH - 0.08), position=HOLD + ((i + 0.5) * LENGTH, 0, 0), quaternion=LEVEL)
        joints.append(world.joint("ball", link, before, anchor=HOLD + (i * LENGTH, 0, 0)))
        before = link
    ball = world.body(mass=2000, shape=epode.Sphere(0.5), position=HOLD + (LINKS * LENGTH + 0.5, 0, 0))
    joints.append(world.joint("ball", ball, before, anchor=HOLD + (LINKS * LENGTH, 0, 0)))
    return ball, joints


def wall(world: epode.World) -> None:
    for row in range(8):
        for column in range(-2, 3):
            world.body(mass=5, shape=epode.Box(0.4, 0.5, 0.4), position=(-2.2, 0.5 * column + 0.25 * (row % 2), 0.2 + 0.4 * row))


def main(picture: str | None = None) -> tuple[float, float]:
    world = epode.World()
    world.stepper = "hybrid"                          # solves what hangs together exactly, and the bricks fast
    world.plane()
    ball, joints = chain(world)
    wall(world)
    gap = 0.0
    for step in range(180):                           # 3 s
        world.step(1 / 60)
        for joint in joints[1:]:
            gap = max(gap, float(np.linalg.norm(joint.anchor - joint.anchor2)))
        if step == 94 and picture is not None:
            world.picture(picture, width=900, height=600)
    bricks = world.bodies.position[LINKS + 1:]
    scattered = float(np.ptp(bricks[:, 0]))
    print(f"links part by at most {1000 * gap:.2f} mm; the bricks lie {scattered:.1f} m apart")
    return gap, scattered


if __name__ == "__main__":
    main(*sys.argv[1:2])
