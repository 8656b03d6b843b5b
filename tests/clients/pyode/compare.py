#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""compare.py OURS REFERENCE OUR_LIBRARY REFERENCE_LIBRARY: figures of falling.py from two libraries.

Single answers (rays, contacts, boxes) must agree to 1e-9, runs of 100 steps to 1e-6, relative to the larger
of the figure and 1. Both files must come from the library they are said to come from, by its inode.
"""

import os
import sys

CLOSE = ("ray", "aabb", "transform", "ball-transform", "space", "forces", "points", "free-fall", "connected", "sleep")
CLOSE_TOLERANCE = 1e-9
RUN_TOLERANCE = 1e-6


def read(path):
    library, extension, figures = None, None, []
    with open(path) as lines:
        for line in lines:
            name, *words = line.split()
            if name == "#library":
                library = (words[0], int(words[1]))
            elif name == "#extension":
                extension = words[0]
            else:
                figures.append((name, [float(word) for word in words]))
    return library, extension, figures


def check_library(who, loaded, expected):
    if loaded is None or loaded[1] != os.stat(expected).st_ino:
        sys.exit("pyode: %s ran on %s, not on %s" % (who, loaded, expected))
    print("%-9s %s (inode %d)" % (who, *loaded))


def tolerance_of(name):
    return CLOSE_TOLERANCE if name.startswith(CLOSE) else RUN_TOLERANCE


def worst_difference(ours, reference):
    if len(ours) != len(reference):
        return float("inf")
    worst = 0.0
    for a, b in zip(ours, reference):
        relative = abs(a - b) / max(abs(a), abs(b), 1.0)
        worst = relative if not relative <= worst else worst
    return worst


def main(ours_path, reference_path, ours_library, reference_library):
    loaded, extension, ours = read(ours_path)
    reference_loaded, reference_extension, reference = read(reference_path)
    check_library("ours", loaded, ours_library)
    check_library("reference", reference_loaded, reference_library)
    if loaded[1] == reference_loaded[1]:
        sys.exit("pyode: both runs used the same library")
    if extension is None or extension != reference_extension:
        sys.exit("pyode: a run did not finish, or used another extension")
    if [name for name, _ in ours] != [name for name, _ in reference]:
        missing = {name for name, _ in ours} ^ {name for name, _ in reference}
        sys.exit("pyode: different figures: %s" % sorted(missing))
    failures, worst = 0, {}
    for (name, a), (_, b) in zip(ours, reference):
        difference = worst_difference(a, b)
        group = name.split(".")[0].rstrip("0123456789")
        worst[group] = max(worst.get(group, 0.0), difference)
        if not difference <= tolerance_of(name):
            failures += 1
            print("differs: %s %.3g\n  ours      %s\n  reference %s" % (name, difference, a, b))
    for group, difference in sorted(worst.items()):
        print("%-16s worst %.3g (allowed %.0e)" % (group, difference, tolerance_of(group)))
    print("%d figures, %d beyond tolerance; extension %s" % (len(ours), failures, extension))
    sys.exit(1 if failures or not ours else 0)


if __name__ == "__main__":
    main(*sys.argv[1:5])
