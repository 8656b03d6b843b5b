#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""joint_parameters.py PROGRAM PAGE: the tables of docs/guide/joint_parameters.md say what joints take and what they begin with; PROGRAM
(joint_parameters.c) asks the library."""
import pathlib
import re
import subprocess
import sys

DEFAULTS = {"-infinity": "-inf", "infinity": "inf", "the world's ERP": "0.375", "the world's CFM": "0.0625"}


def rows(text, head):
    lines = text[text.index(head):].splitlines()[2:]
    table = lines[:next((i for i, line in enumerate(lines) if not line.startswith("|")), len(lines))]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in table]


def said(text):
    """{(type, parameter): default} by the page."""
    defaults = {name: DEFAULTS.get(row[4], row[4]) for row in rows(text, "| parameter |") if row[4] for name in re.findall(r"`(\w+)`", row[0])}
    axis = re.findall(r"`(\w+)`", text[text.index("*Limit and motor*"):].split("\n\n")[0])
    found = {}
    for joint, *axes, others in rows(text, "| type |"):
        for cell, ending in zip(axes, ("", "2", "3")):
            if cell.startswith("limit and motor"):
                found |= {(joint, name + ending): defaults[name] for name in axis}
        found |= {(joint, name): defaults[name] for name in re.findall(r"`(\w+)`", others)}
    return found


def main():
    answer = subprocess.run([sys.argv[1]], capture_output=True, text=True, check=True).stdout
    measured = {(joint, name): value for joint, name, value in (line.split() for line in answer.splitlines())}
    page = said(pathlib.Path(sys.argv[2]).read_text(encoding="utf-8"))
    for key in sorted(measured.keys() | page.keys()):
        if measured.get(key) != page.get(key):
            print(f"{key[0]} {key[1]}: the page says {page.get(key, 'not taken')}, the library {measured.get(key, 'not taken')}")
    print(f"{len(measured)} parameters of {len({joint for joint, _ in measured})} types")
    return measured != page or not measured


if __name__ == "__main__":
    sys.exit(main())
