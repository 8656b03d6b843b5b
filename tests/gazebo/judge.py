#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# Judges the tables that run.sh --compare has written: features, energy, penetration and speed. Fails where a promise is not kept.
import pathlib
import sys

# dartsim's that we lack, and why (docs/guide/gz_sim.md).
LACKING = {"RetrieveWorld": "a pointer to DART's own world",
           "ConstructSdfVisual": "the engine draws nothing",
           "FreeJointCast": "loose links have no joint", "SetFreeJointRelativeTransformFeature": "the same",
           "GetShapeFrictionPyramidSlipCompliance": "world-managed contacts do not slip by force",
           "SetShapeFrictionPyramidSlipCompliance": "the same"}
OURS = "libepode-physics-plugin"
folder = pathlib.Path(sys.argv[1])
problems = []


def promise(kept, text):
    print(("kept:   " if kept else "BROKEN: ") + text)
    if not kept:
        problems.append(text)


def rows(name):
    """Of a world's table: per plugin, lists of time, speed by processor time and by the clock, energy, lowest, fastest."""
    table = {}
    for line in (folder / f"{name}.tsv").read_text().splitlines():
        plugin, *numbers = line.split("\t")
        table.setdefault(plugin.strip(), []).append([float(number) for number in numbers])
    return table


features = [line.split("\t") for line in (folder / "features.tsv").read_text().splitlines() if "\t" in line]
lacking = {row[0].strip() for row in features if len(row) > 2 and row[2] == "yes" and row[1] != "yes"}
promise(lacking <= set(LACKING), f"all of dartsim's features but {', '.join(sorted(LACKING))}; lacking: {', '.join(sorted(lacking))}")

# Released level and at rest, 3 m up: E = 2 m g 3 m = 58.8 J; of it 2 m g l = 19.6 J fall until it hangs.
drifts = {plugin: max(abs(row[3] - 58.8) for row in its) / 19.6
          for plugin, its in rows("double_pendulum").items() if its[0][4] < float("inf")}
for plugin, drift in drifts.items():
    print(f"{plugin}: energy drift {drift:.2e} of what falls")
promise(drifts[OURS] < 2e-3, "energy of the double pendulum to 0.2 %")
promise(drifts[OURS] <= min(drifts.values()), "no plugin keeps it better")
for plugin, its in rows("stack").items():
    if its[-1][4] == float("inf"):
        continue  # it does not show its links
    print(f"{plugin}: the lowest of five boxes is {0.25 - its[-1][4]:+.6f} m deep")
    if plugin == OURS:
        promise(abs(its[-1][4] - 0.25) < 1e-3, "boxes rest within 1 mm")

shapes = rows("3k_shapes")
ours = shapes[OURS]
for plugin, its in shapes.items():
    print(f"{plugin}: real-time factors of 3,000 shapes {', '.join(f'{row[1]:.3g} until {row[0]:g} s' for row in its)}")
theirs = [its for plugin, its in shapes.items() if "dartsim" in plugin]
if theirs:
    # Both over the same span: equal steps of time, so the mean of factors is harmonic.
    def mean(its):
        return len(its) / sum(1 / row[1] for row in its)
    last = theirs[0][-1][0]
    times = mean([row for row in ours if row[0] <= last + 1e-9]) / mean(theirs[0])
    promise(times > 10, f"ten times dartsim's speed while they fall and lie, until {last:g} s: {times:.1f}")
# Aimed at is 1 once they sleep, but what is round rolls on.
promise(ours[-1][1] > 0.3, f"real-time factor above 0.3 while the round ones roll: {ours[-1][1]:.3g}")
sys.exit(1 if problems else 0)
