#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Writes robots/read/mjcf_names.inc: the attributes of every MJCF element, as an installed MuJoCo prints them.

Run it with a Python that has mujoco, from the root of the repository; --check compares instead (exit 1: another table)."""
import pathlib
import re
import sys

import mujoco

HEAD = """// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Written by tools/mjcf_names.py from what MuJoCo {version} prints of its schema: elements of MJCF by their way from the root,
// and their attributes. What stands in a body is under body, wherever the body is.
"""


def rows():
    """(path, attributes) of every element."""
    out, stack = [], []
    for line in mujoco.mj_printSchema(False, True).split("\n"):
        match = re.match(r"^( *)(\S+) \(.\)\s*(.*)$", line)
        if match:
            depth = len(match[1]) // 3
            stack = stack[:depth] + [match[2].replace("(world)", "")]
            out.append(("/".join(stack[1:]), match[3].split()))
        elif line.strip():
            out[-1][1].extend(line.split())
    return out


def text():
    """The whole file."""
    lines = [HEAD.format(version=mujoco.__version__)]
    for path, names in rows():
        first, line = f'{{"{path}",', " "
        lines.append(first)
        for name in names:
            if len(line) + len(name) > 104:
                lines.append(f'    "{line[1:]} "')
                line = " "
            line += (" " if line != " " else "") + name
        lines.append(f'    "{line[1:]}"}},')
    return "\n".join(lines) + "\n"


file = pathlib.Path("robots/read/mjcf_names.inc")
if "--check" in sys.argv:
    sys.exit(file.read_text() != text())
file.write_text(text())
