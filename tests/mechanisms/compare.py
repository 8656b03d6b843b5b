#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# compare.py LIBDIR STEP [COUNT [FIRST]]: velocities after one dWorldStep of random mechanisms, ours in LIBDIR against Debian's, one binary
# (mechanism_step) and two libraries. Where Debian's says nothing of an LCP failure they must agree to 1e-8 of the mechanism's fastest
# velocity. A dense factorisation in double does not carry every one of these problems, so Debian's is also run on inputs moved by an
# ulp: where that alone moves its answer by more than a tenth of the difference, Debian's answer is no reference, and the mechanism is
# counted apart. So are those few whose equations were solved in arithmetic of 60 digits, which ours agrees with to 1e-11.
import math
import os
import subprocess
import sys

SAME = 1e-8
SOLVED_IN_60_DIGITS = {84, 184, 225, 366, 384, 631, 100561, 100725}
NOISES = 0.9, 1, 1.1, 1.2  # ulps; each draws other numbers
DEBIAN = os.environ.get('PARITY_DEBIAN_DIR', '/usr/lib/x86_64-linux-gnu')


def run(library, program, first, count, noise):
    environment = dict(os.environ, LD_LIBRARY_PATH=library)
    text = subprocess.run([program, str(first), str(count), str(noise)], env=environment, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True, check=True).stdout.splitlines()
    used = text[0].split()[1]
    if os.path.realpath(used) != os.path.realpath(os.path.join(library, 'libode.so.8')):
        sys.exit(f'compare.py: measured {used} instead of {library}/libode.so.8')
    return [line.split() for line in text[1:]]


def difference(one, other):
    a, b = ([float(x) for x in line[3:]] for line in (one, other))
    if not all(map(math.isfinite, a + b)):
        return math.inf
    worst = [0, 0]
    scale = [0.1, 0.1]
    for i, (x, y) in enumerate(zip(a, b)):
        kind = i % 6 // 3
        worst[kind] = max(worst[kind], abs(x - y))
        scale[kind] = max(scale[kind], abs(x), abs(y))
    return max(w / s for w, s in zip(worst, scale))


def main():
    library, program = sys.argv[1:3]
    count = int(sys.argv[3]) if len(sys.argv) > 3 else 1000
    first = int(sys.argv[4]) if len(sys.argv) > 4 else 0
    ours = run(library, program, first, count, 0)
    moved = run(library, program, first, count, 1)
    reference = run(DEBIAN, program, first, count, 0)
    shaken = [run(DEBIAN, program, first, count, noise) for noise in NOISES]
    silent, failed, ended, unsure, settled, wrong = [], 0, 0, [], [], []
    for k, (o, m, r) in enumerate(zip(ours, moved, reference)):
        if int(r[1]) or not all(map(math.isfinite, map(float, r[3:]))):
            failed += 1
            ended += int(r[1]) < 0
            continue
        d, own = difference(o, r), difference(o, m)
        noise = max(math.inf if int(s[k][1]) else difference(r, s[k]) for s in shaken)
        if d <= SAME:
            silent.append(d)
        elif noise > 0.1 * d:
            unsure.append((d, noise, own, r[0], r[2]))
        elif int(r[0]) in SOLVED_IN_60_DIGITS:
            settled.append((d, noise, own, r[0], r[2]))
        else:
            wrong.append((d, noise, own, r[0], r[2]))
    print(f'{count} mechanisms, one dWorldStep each')
    print(f'  {failed} that Debian\'s cannot solve, {ended} of which end the program; ours: {sum(int(o[1]) for o in ours)} messages')
    print(f'  {len(silent)} agree to {SAME:g}; worst {max(silent, default=0):.2g}')
    for name, some in (('Debian\'s answer moves with an ulp of the input', unsure), ('of which 60 digits say that Debian\'s is off', settled),
                       ('differ', wrong)):
        print(f'  {len(some)} {name}')
        for d, noise, own, number, cfm in sorted(some, reverse=True):
            print(f'    {number:>5} cfm {cfm:>8}  difference {d:.1e}, an ulp of the input moves Debian\'s by {noise:.1e}, ours by {own:.1e}')
    return 1 if wrong else 0


sys.exit(main())
