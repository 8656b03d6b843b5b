#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Writes robots/read/mjcf_counts.inc: how many numbers each attribute of MJCF takes at most, as an installed MuJoCo answers.

Every attribute of robots/read/mjcf_names.inc is given sixty numbers, then as many as are not "too much data".
Run it with a Python that has mujoco, from the root of the repository; --check compares instead (exit 1: another table)."""
import collections
import pathlib
import re
import sys

import mujoco

HEAD = """// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Written by tools/mjcf_counts.py from what MuJoCo {version} refuses as too much data: an element (empty: any other one), how many
// numbers an attribute takes at most (0: it may be words), attributes.
"""
# What MuJoCo wants in an element before it reads the attribute: of one that is missing, and of those of which there must be one.
VALUES = {"objtype": "site", "dim": "2", "pos": "0 0 0", "mass": "1", "coef": "1", "size": "1 1 1 1", "role": "rgb",
          "bindpos": "0 0 0", "bindquat": "1 0 0 0", "vertid": "0", "vertweight": "1", "element": "0 1 2"}
CHOICES = {"connect": [{"site1": "a", "site2": "b"}, {"body1": "a"}, {"body1": "a", "anchor": "0 0 0"}],
           "weld": [{"site1": "a", "site2": "b"}, {"body1": "a"}], "rangefinder": [{"site": "s"}],
           "distance": [{"geom1": "a", "geom2": "b"}], "normal": [{"geom1": "a", "geom2": "b"}],
           "fromto": [{"geom1": "a", "geom2": "b"}], "dcmotor": [{"motorconst": "1 1", "resistance": "1"}],
           "flexcomp": [{"type": "grid", "count": "2 2 2", "spacing": "1 1 1", "name": "f"}]}
# What the schema leaves out.
MORE = [("frame", "pos", 3), ("frame", "quat", 4), ("replicate", "count", 1), ("replicate", "offset", 3), ("replicate", "sep", 0)]


def paths():
    """(path, attribute) of the table of names."""
    rows = re.findall(r'\{"([^"]*)",\s*((?:"[^"]*"\s*)+)\}', pathlib.Path("robots/read/mjcf_names.inc").read_text())
    for path, names in rows:
        for name in " ".join(re.findall(r'"([^"]*)"', names)).split():
            if name not in ("name", "class", "user", "file", "content_type"):
                yield path, name


def document(path, given):
    """A document with that element, with attributes by the names of elements."""
    out = ""
    for name in reversed(path.split("/")):
        out = f"<{name} " + " ".join(f'{k}="{v}"' for k, v in given.get(name, {}).items()) + f">{out}</{name}>"
    return "<mujoco>" + (f"<worldbody>{out}</worldbody>" if path.startswith("body") else out) + "</mujoco>"


def refusal(path, attribute, count, choice):
    """What MuJoCo says of so many numbers, with what else it wants."""
    last = path.split("/")[-1]
    given = {last: dict(choice)}
    text = ""
    for _ in range(12):
        given[last][attribute] = " ".join(["1"] * count)
        try:
            mujoco.MjSpec.from_string(document(path, given))
            return ""
        except Exception as error:  # of several types
            text = str(error)
        match = re.search(r"required attribute missing: '(\w+)'\nElement '(\w+)'", text)
        if not match:
            break
        given.setdefault(match[2], {})[match[1]] = VALUES.get(match[1], "x")
    return text


def limit_of(path, attribute):
    """How many numbers; 0: no refusal counts them."""
    for choice in CHOICES.get(path.split("/")[-1], [{}]):
        if "too much data" in refusal(path, attribute, 60, choice):
            count = 1
            while "too much data" not in refusal(path, attribute, count + 1, choice):
                count += 1
            return count
    return 0


def table():
    """{(element, count): attributes}."""
    found = collections.defaultdict(dict)  # by attribute and element
    for path, attribute in paths():
        if path and not path.startswith("asset/model"):
            its, element = found[attribute], path.split("/")[-1]
            its[element] = max(its.get(element, 0), limit_of(path, attribute))
    for element, attribute, count in MORE:
        found[attribute][element] = count
    out = collections.defaultdict(list)
    for attribute, its in sorted(found.items()):
        common = collections.Counter(its.values()).most_common()
        usual = 0 if len(common) > 1 and common[0][1] == common[1][1] else common[0][0]
        if usual:
            out["", usual].append(attribute)
        for element, count in sorted(its.items()):
            if count != usual:
                out[element, count].append(attribute)
    return out


def text():
    """The whole file."""
    lines = [HEAD.format(version=mujoco.__version__)]
    for (element, count), names in sorted(table().items()):
        line, rows = "", []
        for name in names:
            if len(line) + len(name) > 100:
                rows.append(f'"{line} "')
                line = ""
            line += (" " if line else "") + name
        rows.append(f'"{line}"')
        lines.append(f'{{"{element}", {count},\n    ' + "\n    ".join(rows) + "},")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    file = pathlib.Path("robots/read/mjcf_counts.inc")
    if "--check" in sys.argv:
        sys.exit(file.read_text() != text())
    file.write_text(text())
