#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""judge.py DEMO DRIVE OUR_LIBRARY REFERENCE_LIBRARY: OMPL's planner on two libraries.

DEMO, OMPL's own, steers a free body: with one seed both libraries must give the same plan, to the last digit printed, and each
step of it must be Newton's (x' = x + h v', |F| <= 0.2 N on 4 g). DRIVE pushes a box over the ground: speeds of straight pushes
are known (F/m - mu g), other pushes are compared, and the plan must miss the wall, end at the goal and be repeatable.
"""

import os
import re
import subprocess
import sys

failures = []


def require(condition, text):
    print("%s %s" % ("ok    " if condition else "FAILED", text))
    if not condition:
        failures.append(text)


def run(program, library):
    environment = dict(os.environ, LD_LIBRARY_PATH=os.path.dirname(library))
    done = subprocess.run([program], env=environment, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=200)
    lines = done.stdout.splitlines()
    loaded = lines[0].split() if lines else []
    if loaded[:1] != ["#library"] or int(loaded[2]) != os.stat(library).st_ino:
        sys.exit("ompl: %s did not run on %s: %s\n%s" % (program, library, loaded, done.stderr))
    return done.returncode, lines, done.stderr


def states_of(lines):
    """The rows of 13 numbers (place, velocity, spin, quaternion) among what the demo prints."""
    return [[float(word) for word in line.split()] for line in lines if re.fullmatch(r"(-?[0-9][0-9.e+-]* ){13}", line)]


def is_newtons(a, b, step=0.05, gravity=(0, 0, -0.981), force_over_mass=0.2 / 0.004):
    moved = all(abs(b[i] - a[i] - step * b[3 + i]) < 2e-4 for i in range(3))
    pushed = all(abs((b[3 + i] - a[3 + i]) / step - gravity[i]) < force_over_mass + 1e-2 for i in range(3))
    return moved and pushed and b[9:13] == [0, 0, 0, 1]


def judge_demo(program, ours, reference):
    status, lines, messages = run(program, ours)
    other_status, other_lines, _ = run(program, reference)
    mine, theirs = states_of(lines), states_of(other_lines)
    require(status == 0, "demo: ends with %d (reference %d)" % (status, other_status))
    require("ODE" not in messages.replace("OpenDE", ""), "demo: no message of ours")
    require(len(mine) > 100 and mine == theirs, "demo: the same plan of %d states (reference %d)" % (len(mine), len(theirs)))
    require(all(is_newtons(a, b) for a, b in zip(mine, mine[1:])), "demo: each of its steps is Newton's")
    off = sum((x - goal) ** 2 for x, goal in zip(mine[-1], (30, 55, 35))) ** 0.5
    require(mine[0][:6] == [0] * 6 and off < 0.5, "demo: from rest at the origin to %.3f from the goal" % off)


def rows(lines, name):
    return [[float(word) for word in line.split()[1:]] for line in lines if line.startswith(name + " ")]


def straight_speeds():
    """Box of 2 kg, mu = 0.3: 10 N for 0.5 s, then let go; every 0.1 s its speed."""
    slowing = 0.3 * 9.81
    faster = [(10 / 2 - slowing) * 0.1 * (i + 1) for i in range(5)]
    return faster + [max(0, faster[-1] - slowing * 0.1 * (i + 1)) for i in range(5)]


def judge_straight_drives(lines, other_lines):
    mine, theirs = rows(lines, "push"), rows(other_lines, "push")
    worst = max(abs(row[3] - speed) for row, speed in zip(mine, straight_speeds()))
    other = max(abs(row[3] - speed) for row, speed in zip(theirs, straight_speeds()))
    require(len(mine) == 35 and worst < 1e-6, "drive: straight pushes as the formula says, to %.1e m/s (reference %.1e)" % (worst, other))
    difference = max(abs(a - b) for mine_row, their_row in zip(mine, theirs) for a, b in zip(mine_row, their_row))
    require(len(theirs) == 35 and difference < 0.02, "drive: all pushes as there, to %.1e" % difference)


def judge_path(lines):
    path = rows(lines, "plan")
    at_wall = [p for p in path if abs(p[0] - 1.5) < 0.3 and abs(p[1]) < 1.2]
    lifted = max(abs(p[2] - 0.1) for p in path)
    off = ((path[-1][0] - 3) ** 2 + path[-1][1] ** 2) ** 0.5
    repeated = max(row[2] for row in rows(lines, "again"))
    require(off < 0.25 and max(abs(p[1]) for p in path) > 1.0, "drive: the plan of %d steps ends %.3f from the goal" % (len(path), off))
    require(not at_wall and "valid 1" in lines, "drive: it goes round the wall")
    require(lifted < 1e-3, "drive: the box stays on the ground to %.1e m" % lifted)
    require(repeated < 1e-6, "drive: run again, its states come again to %.1e m" % repeated)


def main(demo, drive, ours, reference):
    judge_demo(demo, ours, reference)
    status, lines, messages = run(drive, ours)
    _, other_lines, _ = run(drive, reference)
    require(status == 0 and lines[-1] == "#end" and not messages, "drive: ends with %d %s" % (status, messages[:200]))
    judge_straight_drives(lines, other_lines)
    judge_path(lines)
    sys.exit("ompl: %d judgements failed" % len(failures) if failures else 0)


if __name__ == "__main__":
    main(*sys.argv[1:5])
