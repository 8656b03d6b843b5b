# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A million rays in a few calls: a lidar in a yard of boxes, as arrays in and arrays out."""
import time

import numpy as np

import epode


def main(count: int = 1_000_000) -> float:
    rng = np.random.default_rng(2)
    world = epode.World()
    ground = world.plane()
    for x, y in rng.uniform(-30, 30, (300, 2)):
        if np.hypot(x, y) > 3:
            world.geom(epode.Box(*rng.uniform(0.5, 2.5, 3)), position=(x, y, 0.5))
    angle, tilt = rng.uniform(-np.pi, np.pi, count), rng.uniform(-0.3, 0.1, count)
    directions = np.column_stack([np.cos(angle) * np.cos(tilt), np.sin(angle) * np.cos(tilt), np.sin(tilt)])
    begin = time.perf_counter()
    hits = world.rays((0, 0, 1.5), directions, 50.0, threads=0)
    seconds = time.perf_counter() - begin
    hit = hits["geom"] != 0                           # a structured array: geom, pos, normal, distance, side
    on_ground = [world.geom_of(key) is ground for key in np.unique(hits["geom"][hit])].count(True)
    print(f"{count} rays in {seconds:.2f} s; {hit.mean():.0%} hit something, {hits['distance'][hit].min():.2f} m and more away")
    assert on_ground == 1
    return float(hit.mean())


if __name__ == "__main__":
    main()
