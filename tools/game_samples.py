#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The table of docs/guide/howto/games.md: fourteen features of games, each with a sample of a page, and how many statements it has. `--write` writes
it, `--check` says whether it is true. tools/doc_samples.py compiles and runs the samples.

Statements are those of C: what ends with a semicolon, declarations too, and each if, else, for, while, do, switch; semicolons in the head
of a loop are none of their own. Heads of functions and preprocessor lines are not counted."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import doc_samples

GUIDE = doc_samples.ROOT / "docs/guide"
PAGE = GUIDE / "howto/games.md"
BEGIN, END = "<!-- tools/game_samples.py -->\n", "<!-- tools/game_samples.py: end -->"
# Feature, page, number of its C block there, statements before (as counted where it was built on the interface of before; None: not
# counted), what the sample shows.
FEATURES = [
    ("character", "howto/characters.md", 1, 330, "2 m/s for 2 s and a stair of 0.3 m: 4.00 m far, 0.30 m high"),
    ("car with ray wheels", "howto/vehicles.md", 1, 211, "speed and gear after 10 s of full throttle"),
    ("floating bodies", "howto/water.md", 1, 39, "a crate of 600 kg/m³ displaces three fifths"),
    ("explosion", "howto/explosions.md", 1, 64, "speeds by falloff, occlusion and reach"),
    ("ragdoll", "howto/ragdolls.md", 1, None, "joints stay closed, it sleeps, a motor bends its arm"),
    ("rope bridge", "howto/ropes.md", 2, None, "40 planks under 500 kg, no gap of 1 mm"),
    ("wall that breaks", "howto/fracture.md", 1, None, "a ball breaks a pane and goes on through it"),
    ("one-way platform", "world_contacts.md", 2, None, "a ball passes it from below and rests on it"),
    ("queries", "queries.md", 2, None, "the wall before a robot, not the robot"),
    ("drives", "drives.md", 2, None, "a servo holds an arm against its weight"),
    ("sensors", "events.md", 2, None, "a ball enters a gate and leaves it"),
    ("roll-back", "howto/rollback.md", 2, None, "five steps and a body are taken back"),
    ("streaming", "howto/large_worlds.md", 2, None, "1,800 m over nine cells at a time, and a shift of the origin"),
    ("bullets", "continuous.md", 1, None, "1,000 m/s are stopped by 5 cm"),
]


def statements(text):
    """How many statements a sample has."""
    text = re.sub(r"/\*.*?\*/|//[^\n]*|^\s*#[^\n]*", " ", text, flags=re.S | re.M)
    text = re.sub(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'', "0", text)
    count = len(re.findall(r"\b(?:if|else|for|while|do|switch)\b", text))
    count -= len(re.findall(r"\}\s*while\b", text))  # of a do
    depth = 0
    for letter in text:
        depth += (letter == "(") - (letter == ")")
        count += letter == ";" and depth == 0
    return count


def table():
    rows = ["| feature | sample | statements before | now | what its test compares |", "|---|---|---:|---:|---|"]
    for feature, page, number, before, shown in FEATURES:
        path = GUIDE / page
        sample = list(doc_samples.samples_of(path))[number - 1]
        if sample.language != "c" or not sample.expected:
            sys.exit(f"game_samples: {sample.where}: a C block that prints something is expected for {feature}")
        title = path.read_text(encoding="utf-8").split("\n", 1)[0].removeprefix("# ")
        link = page.removeprefix("howto/") if page.startswith("howto/") else f"../{page}"
        rows.append(f"| {feature} | [{title}]({link}), {number}{'st' if number == 1 else 'nd'} | {before or '-'} | {statements(sample.text)} | {shown} |")
    return "\n".join(rows) + "\n"


def main(verb):
    text = PAGE.read_text(encoding="utf-8")
    head, _, rest = text.partition(BEGIN)
    _, found, tail = rest.partition(END)
    if not found:
        sys.exit(f"game_samples: {PAGE} has no place for the table")
    true = head + BEGIN + table() + END + tail
    if verb == "--write":
        PAGE.write_text(true, encoding="utf-8")
    elif true != text:
        sys.exit(f"game_samples: the table of {PAGE} is not true: tools/game_samples.py --write")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) == 2 and sys.argv[1] in ("--write", "--check") else sys.exit(__doc__))
