#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""compare.py OURS DEBIAN: cpp_members built with our headers and run on our library, and the same source built
with the headers of Debian's libode-dev and run on Debian's library, read the same of every object. Only the
failures listed below may occur on Debian's side, and they must occur."""
import re
import subprocess
import sys

TOLERANCE = 1e-9
# Classes that Debian's headers do not have.
OURS_ALONE = ("dCone::", "dEllipsoid::", "dTaperedCapsule::")
# A fault of the original wrapper: it takes the total mass for a density.
DEBIAN_FAILS = {"dMass::setCapsuleTotal"}


def run(program):
    result = subprocess.run([program], capture_output=True, text=True, check=False)
    failed = set(re.findall(r"^FAILED (.*)$", result.stderr, re.M))
    records = [re.match(r"(.*?)((?: (?:[-+.\de]+|-?inf|-?nan))*)$", line).groups()
               for line in result.stdout.splitlines()]
    return [(name, [float(x) for x in values.split()]) for name, values in records], failed, result.returncode


def close(x, y):
    return x == y or abs(x - y) <= TOLERANCE * max(1, abs(x), abs(y))


def main():
    (ours, our_failures, status), (debian, debian_failures, _) = run(sys.argv[1]), run(sys.argv[2])
    ours = [record for record in ours if "(ours)" not in record[0] and not record[0].startswith(OURS_ALONE)]
    wrong = [f"fails here: {name}" for name in sorted(our_failures)] + (["status not 0"] if status else [])
    wrong += [f"fails or not with Debian's: {name}" for name in sorted(debian_failures ^ DEBIAN_FAILS)]
    if [name for name, _ in ours] != [name for name, _ in debian]:
        wrong.append(f"{len(ours)} checks here, {len(debian)} with Debian's, or other names")
        debian = []
    for (name, a), (_, b) in zip(ours, debian):
        if name not in DEBIAN_FAILS and not (len(a) == len(b) and all(map(close, a, b))):
            wrong.append(f"{name}: {a} here, {b} with Debian's")
    print(f"{len(ours)} checks, {sum(len(a) for _, a in ours)} numbers, {len(wrong)} differ")
    print("\n".join(wrong[:20]), file=sys.stderr)
    return bool(wrong) or len(ours) < 500


if __name__ == "__main__":
    sys.exit(main())
