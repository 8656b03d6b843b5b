#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# mutants.py OUR_LIBRARY_DIR PROBE COMPARE OBJECT_DIR [NAME...]
#
# Whether the cases would notice: each function they call is replaced, one at a time, by one that does nothing and
# returns 0 (LD_PRELOAD), and the cases that call it are compared with the original's records again. A replacement
# that leaves every verdict as it was is printed, and must stand in unnoticed.tsv with its reason. Takes many
# minutes, so no part of ctest; the exit status is that of a test.
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import coverage
import symbols

HERE = Path(__file__).resolve().parent
DEBIAN = Path(os.environ.get("PARITY_DEBIAN_DIR", "/usr/lib/x86_64-linux-gnu"))
STUB = ".globl {0}\n.type {0},@function\n{0}: xorl %eax,%eax\npxor %xmm0,%xmm0\nret\n.section .note.GNU-stack,\"\"\n"
LONGEST = 120  # seconds; a mutant may run in circles


class Bench:
    def __init__(self, library_dir, probe, compare, work):
        self.library_dir, self.probe, self.compare, self.work = library_dir, probe, compare, Path(work)

    def records(self, cases, library_dir, preload=None):
        environment = dict(os.environ, LD_LIBRARY_PATH=str(library_dir))
        if preload:
            environment["LD_PRELOAD"] = str(preload)
        return subprocess.run([self.probe, *cases], env=environment, capture_output=True, timeout=LONGEST)

    def agrees(self, ours, reference):
        """The verdict on two record files."""
        tables = [HERE / "tolerances.tsv", HERE / "differences.tsv"]
        done = subprocess.run([self.compare, ours, reference, *tables], capture_output=True, timeout=LONGEST)
        return done.returncode == 0

    def notices(self, name, stem, cases, reference):
        stub = self.work / "stub.so"
        subprocess.run(["cc", "-shared", "-nostdlib", "-o", stub, "-x", "assembler", "-"], input=STUB.format(name),
                       text=True, check=True)
        ours = self.work / "ours.txt"
        try:
            done = self.records(cases, self.library_dir, stub)
        except subprocess.TimeoutExpired:
            return True
        ours.write_bytes(done.stdout)
        return done.returncode != 0 or not self.agrees(ours, reference)


def case_files():
    """Case file (stem) to its cases."""
    listing = {p.stem: re.findall(r"^PARITY_CASE\((\w+)\)", p.read_text(), re.MULTILINE)
               for p in (HERE / "probe").glob("*.cpp")}
    return {stem: cases for stem, cases in listing.items() if cases}


def references(bench, files):
    """The original's records of each file's cases, shortest first."""
    result = {}
    for stem, cases in files.items():
        path = bench.work / f"{stem}.txt"
        path.write_bytes(bench.records(cases, DEBIAN).stdout)
        result[stem] = path
    return dict(sorted(result.items(), key=lambda item: item[1].stat().st_size))


def users_of(name, calls, reference):
    """Case files that call it themselves, or all if only a helper does."""
    direct = [stem for stem in reference if name in calls[stem]]
    return direct or list(reference)


def main(arguments):
    library_dir, probe, compare, objects = arguments[:4]
    calls = symbols.called_by_object(Path(objects).glob("*.o"))
    used = symbols.called(probe) & symbols.exported(DEBIAN / "libode.so.8")
    wanted = arguments[4:] or sorted(used)
    known = coverage.read_reasons(HERE / "unnoticed.tsv")
    unnoticed = []
    with tempfile.TemporaryDirectory() as work:
        bench = Bench(library_dir, probe, compare, work)
        files = case_files()
        reference = references(bench, files)
        for name in wanted:
            if not any(bench.notices(name, stem, files[stem], reference[stem])
                       for stem in users_of(name, calls, reference)):
                unnoticed.append(name)
                print(name, "" if name in known else "UNEXPECTED", flush=True)
    print(f"{len(wanted)} functions replaced, {len(unnoticed)} of them unnoticed")
    surprises = set(unnoticed) ^ (set(known) & set(wanted))
    print("\n".join(f"{name}: unnoticed.tsv is wrong about it" for name in sorted(surprises)))
    return 1 if surprises else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
