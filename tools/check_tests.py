#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Tests read alike: their names are sentences in snake_case (their suites subjects in PascalCase), and golden hashes are in
tests/golden alone.

  check_tests.py            faults; exit status 1 if there are any
  check_tests.py --root D   judges the tree D instead of this one (tests/docs/planted_tests.sh)

A hash is a whole number of more than 13 hexadecimal or 16 decimal digits that is not one of CONSTANTS, of generators and hashes."""
import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
TEST = re.compile(r"\bTEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\)")
PYTHON_TEST = re.compile(r"^\s*(?:async )?def (test\w*)\(", re.M)
SUITE, SENTENCE = re.compile(r"[A-Z][A-Za-z0-9]*"), re.compile(r"(?:DISABLED_)?[a-z0-9]+(?:_[a-z0-9]+)+")
HASH = re.compile(r"(?<![\w.])(0x[0-9a-fA-F]{14,16}|\d{17,20})(?:u|ul|ull|n)?(?![\w.])")
CONSTANTS = {
    0xcbf29ce484222325, 1469598103934665603,  # FNV-1a's beginning, and the probe's
    6364136223846793005, 1442695040888963407,  # Knuth's generator
    0x9e3779b97f4a7c15, 0xbf58476d1ce4e5b9, 0x94d049bb133111eb,  # splitmix64
    0x2545f4914f6cdd1d,  # xorshift*
    0x910a2dec89025cc1, 0xbeeb8da1658eec67, 0xf893a2eefb32555f, 0x71c18690ee42c90b,  # the keys of a state's checksum
    0x7ff800007ff80000,  # no number in a double, nor in its two floats
    0x123456789abcdef,  # a long seed
}


def line_of(text, offset):
    return text.count("\n", 0, offset) + 1


def faults_of_names(text):
    for found in TEST.finditer(text):
        if not SUITE.fullmatch(found[1]):
            yield found.start(), f"{found[1]}: a suite is a subject in PascalCase"
        if not SENTENCE.fullmatch(found[2]):
            yield found.start(), f"{found[1]}.{found[2]}: a test is a sentence in snake_case"


def faults_of_hashes(text):
    for found in HASH.finditer(text):
        if int(found[1], 0) not in CONSTANTS:
            yield found.start(), f"{found[1]}: a golden hash is in tests/golden, a constant in tools/check_tests.py"


def faults_of_python(text):
    for found in PYTHON_TEST.finditer(text):
        if not SENTENCE.fullmatch(found[1]):
            yield found.start(), f"{found[1]}: a test is a sentence in snake_case"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--root", type=pathlib.Path, default=ROOT)
    root = parser.parse_args().root
    faults, count = 0, 0
    for path in sorted([*(root / "tests").rglob("*"), *(root / "python/tests").rglob("*.py")]):
        judges = {".cpp": [faults_of_names, faults_of_hashes], ".h": [faults_of_names, faults_of_hashes], ".mjs": [faults_of_hashes],
                  ".py": [faults_of_python]}.get(path.suffix, [])
        if not judges or not path.is_file():
            continue
        text = path.read_text()
        count += len(TEST.findall(text)) if path.suffix in (".cpp", ".h") else len(PYTHON_TEST.findall(text))
        for judge in judges:
            for offset, what in judge(text):
                faults += 1
                print(f"{path.relative_to(root)}:{line_of(text, offset)}: {what}")
    print(f"tests: {faults} faults" if faults else f"tests: ok, {count} tests")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
