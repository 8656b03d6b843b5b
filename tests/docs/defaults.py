#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""defaults.py PROGRAM PAGE [--write]: the table of docs/guide/defaults.md is what the library says (PROGRAM, defaults.c, asks it);
--write puts it there."""
import pathlib
import re
import subprocess
import sys

LINE = re.compile(r"(dWorldSet\w+)\(world, (.*)\);\s+/\* (.*) \*/")
BEGIN, END = "<!-- defaults -->\n", "<!-- /defaults -->"


def table(answer):
    presets = [[LINE.fullmatch(line).groups() for line in text.splitlines()] for text in answer.strip().split("\n\n")]
    ode, game, robot = ([value for _, value, _ in preset] for preset in presets)
    rows = [f"| `{name}` | {values[0]} | {values[1]} | {values[2]} | {reason} |"
            for (name, _, reason), *values in zip(presets[0], ode, game, robot)]
    return "\n".join(["| parameter | ODE | game | robot | what it is |", "|---|---|---|---|---|", *rows, ""])


def main():
    answer = subprocess.run([sys.argv[1]], capture_output=True, text=True, check=True).stdout
    page = pathlib.Path(sys.argv[2])
    text = page.read_text(encoding="utf-8")
    begin, end = text.index(BEGIN) + len(BEGIN), text.index(END)
    made = text[:begin] + table(answer) + text[end:]
    if "--write" in sys.argv:
        page.write_text(made, encoding="utf-8")
    elif made != text:
        print(f"{page}: the table is not what the library says; tests/docs/defaults.py PROGRAM {page} --write")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
