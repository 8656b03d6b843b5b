#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""upstream.py SOURCE_FOLDER OUR_LIBRARY REFERENCE_LIBRARY: pyode's own tests and tutorials on two libraries, judged.

Where a run is smooth its figures must be those of the reference; where it is chaotic (thirty boxes in a pile) or where the
reference ends the program, it must obey what is known of it: nothing below the floor by more than a stated depth, boxes at
rest at their heights, wheels on their axles. The original library does not survive three of the eight runs (it is printed
which); ours must survive them all.
"""

import os
import re
import subprocess
import sys

import compare

HERE = os.path.dirname(os.path.abspath(__file__))
FRAME = re.compile(r"frame(\d+)\.(\w+)(?:\.(\w+))?$")
# Frames until which a tutorial is compared, and the tolerance. tutorial3: at frame 100 the second box has met the first.
# transforms: xode hands over scaled rotations, and the original then turns bodies that have no spin (docs/compat.md, D1).
SMOOTH = {"tutorial1": (999, 1e-6), "tutorial2": (999, 1e-9), "tutorial_heightmap": (999, 1e-6), "tutorial3": (100, 1e-6),
          "transforms": (1, 1e-12), "vehicle": (0, 0.0)}
EXPECTED_OK = 105  # of 111: two want trimeshes, which Debian's pyode is built without; four, numbers of parameters older than 0.16

failures = []


def require(condition, text):
    print("%s %s" % ("ok    " if condition else "FAILED", text))
    if not condition:
        failures.append(text)


def run(library, program, *arguments):
    """Status, lines of output, messages. The script runs on the library or says that it does not."""
    environment = dict(os.environ, LD_LIBRARY_PATH=os.path.dirname(library))
    done = subprocess.run(["/usr/bin/python3", "-B", os.path.join(HERE, program), *arguments], env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=300)
    lines = done.stdout.splitlines()
    loaded = lines[0].split() if lines else []
    if loaded[:1] != ["#library"] or int(loaded[2]) != os.stat(library).st_ino:
        sys.exit("pyode: %s did not run on %s: %s\n%s" % (program, library, loaded, done.stderr))
    return done.returncode, lines[1:], done.stderr


def ending(status):
    return "ends" if status == 0 else "dies of signal %d" % -status if status < 0 else "fails with %d" % status


def unit_tests(folder, ours, reference):
    status, lines, _ = run(ours, "unit_tests.py", folder)
    _, reference_lines, _ = run(reference, "unit_tests.py", folder)
    mine, theirs = (dict(line.split(" ", 1) for line in each if line[0] != "#") for each in (lines, reference_lines))
    lost = [name for name, outcome in theirs.items() if outcome == "ok" and mine.get(name) != "ok"]
    strange = [name for name, outcome in mine.items() if outcome not in ("ok", theirs.get(name))]
    count = list(mine.values()).count("ok")
    require(status == 0 and len(mine) == len(theirs) == 111, "unit tests: %d ran" % len(mine))
    require(count == EXPECTED_OK, "unit tests: %d pass (reference: %d)" % (count, list(theirs.values()).count("ok")))
    require(not lost and not strange, "unit tests: none that passes there fails here %s" % (lost + strange))
    status, lines, messages = run(ours, "unit_tests.py", folder, "--together")
    require(status == 0 and lines[-1] == "#end", "unit tests in one process: %s (reference %s)"
            % (ending(status), ending(run(reference, "unit_tests.py", folder, "--together")[0])))
    unexpected = [line for line in messages.splitlines() if line and "dBodyDestroy" not in line]
    require(not unexpected, "no messages but those about bodies destroyed after their world %s" % unexpected[:3])


def figures_of(lines):
    """{frame: {name of item and figure: numbers}}"""
    frames = {}
    for line in lines:
        name, *words = line.split()
        found = FRAME.match(name)
        if found:
            frame, item, kind = found.groups()
            frames.setdefault(int(frame), {})[item, kind] = [float(word) for word in words]
    return frames


def tutorial(folder, name, ours, reference):
    status, lines, _ = run(ours, "tutorials.py", folder, name)
    other_status, other_lines, _ = run(reference, "tutorials.py", folder, name)
    require(status == 0 and lines[-1].startswith("#extension"), "%s: %s (reference %s)" % (name, ending(status), ending(other_status)))
    mine, theirs = figures_of(lines), figures_of(other_lines)
    last, tolerance = SMOOTH[name]
    pairs = [(mine[frame].get(key), theirs[frame][key]) for frame in theirs if frame <= last and frame in mine for key in theirs[frame]]
    if last:
        worst = max((compare.worst_difference(a or [], b) for a, b in pairs), default=float("inf"))
        require(worst <= tolerance and mine.keys() == theirs.keys(),
                "%s: %d figures, worst difference %.3g, allowed %.0e" % (name, len(pairs), worst, tolerance))
    return mine, theirs


def falls_and_bounces(frames):
    """tutorial1: semi-implicit Euler, h = 0.04, g = 10 from 10 m on: z_n = 10 - g h^2 n (n+1) / 2; the bounce halves the speed."""
    heights = [10 - 10 * 0.04 ** 2 * n * (n + 1) / 2 for n in range(1, 30)]
    balls = [frames[n]["0", "ball"] for n in sorted(frames)]
    worst = max(abs(ball[2] - height) for ball, height in zip(balls, heights))
    require(worst < 1e-12, "tutorial1: falls as the formula says, to %.1e m" % worst)
    speeds = [ball[5] for ball in balls]
    bounce = next(i for i, speed in enumerate(speeds) if speed > 0)
    require(abs(speeds[bounce] / speeds[bounce - 1] + 0.5) < 1e-6, "tutorial1: half the speed after the bounce")


def pendulum_keeps_its_rods(frames):
    """tutorial2: two rods of 1 m; energy of two equal masses with (v^2)/2 + g y, to what a step of 20 ms conserves."""
    worst, energies = 0.0, []
    for frame in sorted(frames):
        a, b = frames[frame]["0", "place"], frames[frame]["1", "place"]
        u, v = frames[frame]["0", "motion"], frames[frame]["1", "motion"]
        worst = max(worst, abs(((a[0]) ** 2 + (a[1] - 2) ** 2) ** 0.5 - 1), abs(((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2) ** 0.5 - 1))
        energies.append(sum(0.5 * x * x for x in u[:3] + v[:3]) + 9.81 * (a[1] + b[1] - 4))
    require(worst < 0.03, "tutorial2: rods keep their length to %.2g m" % worst)
    require(max(map(abs, energies)) < 3, "tutorial2: energy stays in [%.2f, %.2f] J/kg of the 29 that swing" % (min(energies), max(energies)))


def transforms_compose(frames):
    """transforms: turns of 30 degrees about y, x and z and again within, scaled by 1.25 each; nothing moves."""
    cosines = {"0": 3, "1": 1 + 2 * 0.75 ** 0.5, "2": 2, "3": 1 + 2 * 0.75 ** 0.5, "4": 2, "5": 1 + 2 * 0.75 ** 0.5, "6": 2}
    places = {item: numbers for (item, kind), numbers in frames[1].items() if kind == "place"}
    worst = max(abs(numbers[3] + numbers[7] + numbers[11] - cosines[item]) for item, numbers in places.items())
    require(len(places) == 7 and worst < 1e-12, "transforms: the trace of each rotation is 1 + 2 cos, to %.1e" % worst)
    moved = max(compare.worst_difference(frames[frame][item, "place"], places[item]) for frame in frames for item in places)
    require(moved < 1e-14 and len(frames) >= 3, "transforms: what has no speed stays where it is, to %.1e" % moved)


def lowest_corner(place, half):
    return place[1] - sum(abs(place[6 + i]) * half[i] for i in range(3))


def pile_obeys(frames, theirs):
    """tutorial3: thirty boxes of 1 x 0.2 x 0.2 m dropped from 3 m, then thrown apart and pulled together."""
    def depth(all_frames):
        return -min(lowest_corner(numbers, (0.5, 0.1, 0.1)) for objects in all_frames.values()
                    for (_, kind), numbers in objects.items() if kind == "place")

    def speed(frame):
        return max(sum(x * x for x in numbers[:3]) ** 0.5 for (_, kind), numbers in frames[frame].items() if kind == "motion")

    def mean_speed(frames_of, first, last):
        """Of all boxes in these frames: one that is still tumbling, chance decides which, does not count for all."""
        speeds = [sum(x * x for x in numbers[:3]) ** 0.5 for frame in range(first, last)
                  for (_, kind), numbers in frames_of[frame].items() if kind == "motion"]
        return sum(speeds) / len(speeds)

    def mean_height(frame):
        heights = [numbers[1] for (_, kind), numbers in frames[frame].items() if kind == "place"]
        return sum(heights) / len(heights)

    dropped = max(speed(frame) for frame in frames if frame < 700)
    require(depth(frames) < 0.2, "tutorial3: no box deeper in the floor than %.3f m (reference %.3f)" % (depth(frames), depth(theirs)))
    require(dropped < (2 * 9.81 * 3.2) ** 0.5, "tutorial3: nothing faster than its fall from 3 m: %.2f m/s" % dropped)
    # With six seeds 0.01 to 0.09 m/s, in the original 0.003 to 0.07.
    require(mean_speed(frames, 680, 700) < 0.15, "tutorial3: the heap comes to rest: %.3f m/s (reference %.3f)"
            % (mean_speed(frames, 680, 700), mean_speed(theirs, 680, 700)))
    require(speed(701) > 5, "tutorial3: the explosion throws it apart: %.2f m/s" % speed(701))
    require(speed(900) < 0.5 and 0.09 < mean_height(900) < 0.2, "tutorial3: the boxes lie about: mean height %.4f m" % mean_height(900))


def wall_and_vehicle_stand(frames):
    """vehicle: at rest after 2 s the wheels (radius 1) are on the ground at -4, the wall's boxes of 0.5 m one on the other."""
    last = frames[max(frames)]
    wheels = [numbers for (item, kind), numbers in last.items() if kind == "place" and item in ("2", "3", "4")]
    require(max(abs(place[1] + 3) for place in wheels) < 1e-4, "vehicle: wheels touch the ground")
    gaps = [abs(a - b) for (item, kind), numbers in last.items() if item.startswith("joint") for a, b in zip(numbers[0:3], numbers[3:6])]
    require(len(gaps) == 9 and max(gaps) < 1e-4, "vehicle: wheels sit on their axles to %.1e m" % max(gaps))
    heights = sorted(numbers[1] for (item, kind), numbers in last.items() if kind == "place" and int(item) > 4)
    expected = sorted(-3.75 + 0.5 * (i % 7) for i in range(63))
    worst = max(abs(a - b) for a, b in zip(heights, expected))
    require(len(heights) == 63 and worst < 0.01, "vehicle: the 63 boxes of the wall stand one on the other, to %.1e m" % worst)


def main(folder, ours, reference):
    unit_tests(folder, ours, reference)
    for name, judge in (("tutorial1", falls_and_bounces), ("tutorial2", pendulum_keeps_its_rods), ("tutorial_heightmap", None),
                        ("transforms", transforms_compose), ("vehicle", wall_and_vehicle_stand)):
        mine, _ = tutorial(folder, name, ours, reference)
        if judge:
            judge(mine)
    pile_obeys(*tutorial(folder, "tutorial3", ours, reference))
    sys.exit("pyode: %d judgements failed" % len(failures) if failures else 0)


if __name__ == "__main__":
    main(*sys.argv[1:4])
