#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# coverage.py DEBIAN_LIBRARY PROBE [--write]
#
# How many of the original's C functions the parity cases call, and whether README.md and uncovered.tsv say so. A
# name that no case calls must stand in uncovered.tsv with a reason, and no line may stand there without need;
# --write puts the count into README.md. That a called function's result is compared, too, is what mutants.py
# measures.
import fnmatch
import re
import sys
from pathlib import Path

import symbols

HERE = Path(__file__).resolve().parent
COUNT_LINE = re.compile(r"^Cases call .*$", re.MULTILINE)


def read_reasons(path):
    rows = [line.split("\t") for line in path.read_text().splitlines() if line and not line.startswith("#")]
    return {row[0]: row[1] for row in rows}


def count_line(known, used):
    return f"Cases call {len(known & used)} of the original's {len(known)} C functions."


def find_faults(uncovered, reasons):
    without = {name for name in uncovered if not any(fnmatch.fnmatchcase(name, pattern) for pattern in reasons)}
    idle = {pattern for pattern in reasons if not fnmatch.filter(uncovered, pattern)}
    return ([f"{name}: no case calls it and uncovered.tsv gives no reason" for name in sorted(without)] +
            [f"{pattern}: stands in uncovered.tsv without need" for pattern in sorted(idle)] +
            [f"{pattern}: no reason" for pattern, reason in sorted(reasons.items()) if not reason.strip()])


def main(arguments):
    debian, probe = arguments[:2]
    known, used = symbols.exported(debian), symbols.called(probe)
    faults = find_faults(known - used, read_reasons(HERE / "uncovered.tsv"))
    line = count_line(known, used)
    readme = HERE / "README.md"
    text = readme.read_text()
    if "--write" in arguments:
        readme.write_text(COUNT_LINE.sub(line, text))
    elif line not in text:
        faults.append(f"README.md does not say \"{line}\": coverage.py --write")
    print(line)
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
