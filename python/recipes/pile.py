# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A pile of boxes that tells who touched whom, and how hard."""
from collections import Counter

import numpy as np

import epode


def main() -> Counter[str]:
    rng = np.random.default_rng(1)
    world = epode.World()
    ground = world.plane()
    names = {ground: "ground"}
    for i in range(60):
        box = world.body(density=500, shape=epode.Box(0.3, 0.3, 0.3), position=(*rng.uniform(-0.4, 0.4, 2), 0.5 + 0.35 * i))
        names[box.geoms[0]] = f"box {i}"
    kinds = {epode.c.dEventContactBegin: "begin", epode.c.dEventContactEnd: "end"}
    seen: Counter[str] = Counter()
    fastest = (0.0, "")
    world.list_events()
    for _ in range(400):
        world.step(0.01, stepper="quick")
        events = world.events                         # an array with a row for each event
        seen.update(kinds.get(kind, "other") for kind in events["kind"])
        for event in events[events["kind"] == epode.c.dEventContactBegin]:
            a, b = (world.geom_of(event[g]) for g in ("g1", "g2"))
            if a is not None and b is not None:
                fastest = max(fastest, (float(event["approach_speed"]), f"{names[a]} and {names[b]}"))
    weight = world.contacts["normal_force"][[ground in (world.geom_of(p["g1"]), world.geom_of(p["g2"])) for p in world.contacts]].sum()
    print(f"{seen['begin']} pairs began to touch, {seen['end']} parted; fastest: {fastest[0]:.1f} m/s, {fastest[1]}; "
          f"the ground carries {weight:.0f} N")
    return seen


if __name__ == "__main__":
    main()
