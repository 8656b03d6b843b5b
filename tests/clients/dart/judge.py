#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""judge.py PROGRAM OUR_LIBRARY REFERENCE_LIBRARY FOLDER: DART's collision detector by ODE on 1,000 random pairs, on two libraries.

Solids of one piece and planes: both say which pairs touch, the depth told is one that parts them, and never more than the
reference's; where a formula gives it (no cylinder) it is the reference's, mostly with as many contacts. Torus and height field,
where libraries differ as triangles are taken together: what geometry computed in PROGRAM says lies under the surface touches,
what it says lies above does not.
"""

import math
import os
import subprocess
import sys
from collections import namedtuple

COUNT = 1000
FACETS = 0.05  # metres between a smooth torus and its facets, and between samples of a surface
INSIDE = 0.2   # what lies as deep under the torus' surface may be in it wholly, and surfaces do not meet

Pair = namedtuple("Pair", "first second contacts depth left sunk nx ny nz")
failures = []


def require(condition, text):
    print("%s dart: %s" % ("ok    " if condition else "FAILED", text), flush=True)
    if not condition:
        failures.append(text)


def write_torus(path, around=16, across=10):
    at = [(2 * math.pi * i / around, 2 * math.pi * j / across) for i in range(around) for j in range(across)]
    radius = [0.6 + 0.25 * math.cos(b) for _, b in at]
    with open(path, "w") as file:
        for r, (a, b) in zip(radius, at):
            file.write("v %.6f %.6f %.6f\n" % (r * math.cos(a), r * math.sin(a), 0.25 * math.sin(b)))
        for i in range(around):
            for j in range(across):
                corner = [1 + (i + k) % around * across + (j + m) % across for k, m in ((0, 0), (1, 0), (1, 1), (0, 1))]
                file.write("f %d %d %d\nf %d %d %d\n" % (*corner[:3], corner[0], *corner[2:]))


def run(program, library, torus):
    environment = dict(os.environ, LD_LIBRARY_PATH=os.path.dirname(library))
    done = subprocess.run([program, str(COUNT), torus], env=environment, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=200)
    lines = done.stdout.splitlines()
    if not lines or int(lines[0].split()[2]) != os.stat(library).st_ino or lines[-1] != "#end":
        sys.exit("dart: %s did not run to its end on %s: %s" % (program, library, done.stderr[-500:]))
    words = [line.split()[1:] for line in lines if line.startswith("pair ")]
    return [Pair(w[0], w[1], int(w[2]), float(w[3]), int(w[4]), *map(float, w[5:])) for w in words], done.stderr


def judge_solids(both):
    both = [(a, b) for a, b in both if "mesh" not in a[:2] and a.first != "heights"]
    touching = [(a, b) for a, b in both if a.contacts]
    require(len(touching) > COUNT / 3 and all(bool(a.contacts) == bool(b.contacts) for a, b in both),
            "%d of %d pairs of solids touch, the same ones there" % (len(touching), len(both)))
    require(not any(a.left for a, _ in touching), "moved by the depth told, they part")
    deeper = max(a.depth - b.depth for a, b in touching)
    require(deeper < 1e-6, "no depth is more than there (at most by %.1e m)" % deeper)
    exact = [(a, b) for a, b in touching if "cylinder" not in a[:2] or "plane" in a[:2] or "sphere" in a[:2]]
    off = max(abs(a.depth - b.depth) for a, b in exact)
    same = sum(a.contacts == b.contacts for a, b in exact) / len(exact)
    require(off < 1e-9 and same > 0.95, "%d with a formula: the same depth to %.1e m, %.0f %% as many contacts" % (len(exact), off, 100 * same))
    less = sum(a.depth < b.depth - 1e-6 for a, b in touching)
    print("       (%d cylinders part by less than there)" % less)


def judge_planes(mine):
    planes = [p for p in mine if p.first == "plane" and p.contacts]
    require(len(planes) > 50 and all(-FACETS < p.depth - p.sunk < FACETS for p in planes), "%d on planes: as deep as they lie" % len(planes))


def judge_surface(kind, mine, theirs):
    def faults(pairs):
        missed = sum(p.contacts == 0 and FACETS < p.sunk < (INSIDE if kind == "mesh" else 9) for p in pairs if p.first == kind)
        return missed, sum(p.contacts > 0 and p.sunk < -FACETS for p in pairs if p.first == kind)

    touching = sum(p.contacts > 0 for p in mine if p.first == kind)
    require(touching > 50 and faults(mine) == (0, 0),
            "%s: %d touch, %d missed, %d without reason (there %d, %d)" % (kind, touching, *faults(mine), *faults(theirs)))


def main(program, ours, reference, folder):
    torus = os.path.join(folder, "torus.obj")
    write_torus(torus)
    mine, messages = run(program, ours, torus)
    theirs, _ = run(program, reference, torus)
    require(len(mine) == COUNT == len(theirs) and "ODE " not in messages, "%d pairs, no message of ours" % len(mine))
    judge_solids(list(zip(mine, theirs)))
    judge_planes(mine)
    judge_surface("mesh", mine, theirs)
    judge_surface("heights", mine, theirs)
    up = sum(p.nz > 0.3 for p in mine if p.first == "heights" and p.second != "mesh" and p.contacts)
    all_of_them = sum(p.first == "heights" and p.second != "mesh" and p.contacts > 0 for p in mine)
    require(up == all_of_them, "heights push up what lies on them (%d of %d)" % (up, all_of_them))
    sys.exit("dart: %d judgements failed" % len(failures) if failures else 0)


if __name__ == "__main__":
    main(*sys.argv[1:5])
