# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""An arch of loose stones carries a load that friction alone holds up: exact steps with Coulomb's friction."""
import sys

import numpy as np

import epode

STONES, INNER, OUTER, DEEP = 11, 1.0, 1.3, 0.6


def stone(world: epode.World, first: float, last: float) -> epode.Body:
    """A wedge of a ring between two angles, which its centre of mass is the origin of."""
    half, middle = (last - first) / 2, (first + last) / 2
    low, high = INNER * np.cos(half), OUTER * np.cos(half)
    radius = low + (high - low) / 3 * (INNER + 2 * OUTER) / (INNER + OUTER)
    centre = radius * np.array((np.cos(middle), 0, np.sin(middle)))
    corners = np.array([(r * np.cos(a), y, r * np.sin(a)) for a in (first, last) for r in (INNER, OUTER) for y in (-DEEP / 2, DEEP / 2)])
    return world.body(density=2500, shape=epode.Convex(corners - centre), position=centre, material=epode.Material(friction=0.7))


def main(picture: str | None = None, *, cone: bool = True) -> tuple[float, float]:
    world = epode.World()
    world.stepper = "exact"
    world.friction_cone = cone                        # False: as ODE bounds friction
    world.reports = True
    world.plane(material=epode.Material(friction=0.7))
    angles = np.linspace(0, np.pi, STONES + 1)
    arch = [stone(world, a, b) for a, b in zip(angles[:-1], angles[1:])]
    keystone = arch[STONES // 2]
    top = float(keystone.position[2])
    load = world.body(mass=300, shape=epode.Box(0.3, 0.5, 0.3), position=(0, 0, OUTER + 0.16), material=epode.Material(friction=0.7))
    worst = 0.0
    for _ in range(600):                              # 5 s
        world.step(1 / 120)
        report = world.report()
        worst = max(worst, report.friction_error if report is not None else 0)
    sunk = top - float(keystone.position[2])
    print(f"the keystone has sunk by {1000 * sunk:.1f} mm under {load.mass:.0f} kg; friction is off by {worst:.0e}")
    if picture is not None:
        world.picture(picture, width=900, height=600)
    return sunk, worst


if __name__ == "__main__":
    main(*sys.argv[1:2])
