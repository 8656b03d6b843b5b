# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A four-bar linkage, turned by a motor: three links, four hinges, one way to move."""
import numpy as np

import epode

POINTS = {"ground_a": (0.0, 0.0), "crank": (0.0, 0.3), "rocker": (1.0, 0.8), "ground_b": (1.0, 0.0)}


def link(world: epode.World, a: tuple[float, float], b: tuple[float, float]) -> epode.Body:
    """A rod from a to b in the plane y = 0."""
    (ax, az), (bx, bz) = a, b
    length = float(np.hypot(bx - ax, bz - az))
    tilt = float(np.arctan2(bx - ax, bz - az))        # from z towards x
    return world.body(density=2700, shape=epode.Cylinder(0.03, length), position=((ax + bx) / 2, 0, (az + bz) / 2),
                      quaternion=(np.cos(tilt / 2), 0, np.sin(tilt / 2), 0))


def main() -> float:
    world = epode.World(contacts=False)
    crank = link(world, POINTS["ground_a"], POINTS["crank"])
    coupler = link(world, POINTS["crank"], POINTS["rocker"])
    rocker = link(world, POINTS["rocker"], POINTS["ground_b"])
    pins = [world.joint("hinge", one, other, anchor=(x, 0, z), axis=(0, 1, 0))
            for (one, other), (x, z) in zip(((crank, None), (crank, coupler), (coupler, rocker), (rocker, None)), POINTS.values())]
    pins[0].motor(velocity=2 * np.pi, max_force=500)  # one turn a second
    world.reports = True
    swing = []
    worst = 0.0
    for _ in range(2000):                             # two turns
        world.step(0.001)
        swing.append(pins[3].position())
        report = world.report()
        worst = max(worst, report.joint_error if report is not None else 0.0)
    width = float(np.degrees(max(swing) - min(swing)))
    print(f"the rocker swings {width:.1f} degrees while the crank turns; pins part by at most {1e6 * worst:.2f} micrometres")
    return width


if __name__ == "__main__":
    main()
