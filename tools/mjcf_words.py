#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Writes robots/read/mjcf_keywords.inc and mjcf_required.inc: which words attributes of MJCF take, and which attributes an element must
have, as an installed MuJoCo answers.

Every attribute of robots/read/mjcf_names.inc is given a word that is none; where that is "invalid keyword", every word of WORDS.
Run it with a Python that has mujoco, from the root of the repository; --check compares instead (exit 1: other tables)."""
import collections
import pathlib
import re
import sys

import mujoco

from mjcf_counts import CHOICES, VALUES, document, paths

HEAD = """// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Written by tools/mjcf_words.py from what MuJoCo {version} answers: {what}
"""
WORDS = """false true auto disable enable radian degree free ball slide hinge plane hfield sphere capsule ellipsoid cylinder box mesh sdf
none gradient checker flat edge random cross 2d cube skybox linear sRGB fixed track trackcom targetbody targetbodycom spot directional point
image Euler RK4 implicit implicitfast pyramidal elliptic dense sparse PGS CG Newton integrator filter filterexact muscle user affine dcmotor
convex exact legacy shell local global body xbody geom site camera muscleuser all pos vel acc zoh cubic""".split()
# Of which WORDS may lack some, or which older files have with another meaning.
OPEN = ("flexcomp", "deformable", "sensor/contact", "sensor/rangefinder", "sensor/user", "attach", "body fuse", "body simple", "body sleep", "passthrough",
        "conflict", "camera output", "camera projection", "mesh builtin", "coordinate", "asset/model")


def answer(path, given):
    """What MuJoCo says of that element; empty: it takes it."""
    try:
        mujoco.MjSpec.from_string(document(path, given))
        return ""
    except Exception as error:  # of several types
        return str(error)


def missing_in(text):
    """(attribute, element) of what MuJoCo misses, or None."""
    match = re.search(r"required attribute missing: '(\w+)'\nElement '(\w+)'", text)
    return match and (match[1], match[2])


def said_of(path, attribute, value):
    """What MuJoCo says of a value, given what else it wants; the first answer about keywords."""
    last = path.split("/")[-1]
    text = ""
    for choice in CHOICES.get(last, [{}]):
        given = {last: {**choice, attribute: value}}
        for _ in range(12):
            text = answer(path, given)
            missing = missing_in(text)
            if not missing or missing[0] == attribute:
                break
            given.setdefault(missing[1], {})[missing[0]] = VALUES.get(missing[0], "x")
        if "keyword" in text:
            return text
    return text


def keywords():
    """{(element, words): attributes}; element empty: any other one; words empty: any."""
    found = collections.defaultdict(dict)  # by attribute and element
    for path, attribute in paths():
        is_open = not path or any(part in f"{path} {attribute}" for part in OPEN) or "keyword" not in said_of(path, attribute, "none!")
        words = "" if is_open else " ".join(word for word in WORDS if "keyword" not in said_of(path, attribute, word))
        its, element = found[attribute], path.split("/")[-1]
        if its.setdefault(element, words) != words:
            its[element] = ""  # one or the other, by where it stands
    found = {attribute: its for attribute, its in found.items() if any(its.values())}
    out = collections.defaultdict(list)
    for attribute, its in sorted(found.items()):
        (usual, count), *others = collections.Counter(its.values()).most_common()
        is_usual = bool(usual) and (not others or count > others[0][1])
        if is_usual and len(its) > 1:
            out["", usual].append(attribute)
        for element, words in sorted(its.items()):
            if words != usual or not is_usual or len(its) == 1:
                out[element, words].append(attribute)
    return out


def required():
    """{attributes: paths} that an element must have, whatever else it has."""
    out = collections.defaultdict(list)
    for path in dict.fromkeys(path for path, _ in paths()):
        last, needed = path.split("/")[-1], []
        if not path or path.startswith("default") or any(part in path for part in OPEN) or "plugin" in path:
            continue
        given = {last: {}}
        while missing := missing_in(answer(path, given)):
            if missing[1] == last:
                needed.append(missing[0])
            given.setdefault(missing[1], {})[missing[0]] = VALUES.get(missing[0], "x")
        if needed:
            out[" ".join(needed)].append(path)
    return out


def lines_of(words):
    """Words as strings of C, broken into lines."""
    rows, line = [], ""
    for word in words:
        if len(line) + len(word) > 100:
            rows.append(f'"{line} "')
            line = ""
        line += (" " if line else "") + word
    return "\n    ".join([*rows, f'"{line}"'])


def texts():
    """{file: its text}."""
    keyword_head = HEAD.format(version=mujoco.__version__, what="an element (empty: any other one), the words, and attributes\n// that take one of them; no words: any value.")
    required_head = HEAD.format(version=mujoco.__version__, what="attributes, and ways from the root to elements that must have them.")
    rows = [f'{{"{element}", "{words}",\n    {lines_of(names)}}},' for (element, words), names in sorted(keywords().items())]
    needs = [f'{{"{names}",\n    {lines_of(where)}}},' for names, where in sorted(required().items())]
    return {"mjcf_keywords.inc": "\n".join([keyword_head, *rows]) + "\n", "mjcf_required.inc": "\n".join([required_head, *needs]) + "\n"}


if __name__ == "__main__":
    folder = pathlib.Path("robots/read")
    if "--check" in sys.argv:
        sys.exit(any((folder / name).read_text() != text for name, text in texts().items()))
    for name, text in texts().items():
        (folder / name).write_text(text)
