#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# Dependencies between folders, and between the rooms of a folder, point one way. These tables are the architecture; CI runs
# them first.
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
MAY_INCLUDE = {
    "base": set(),
    "math": {"base"},
    "simd": {"base", "math"},
    "tasks": {"base"},
    "rows": {"base", "math"},
    "geometry": {"base", "math", "simd"},
    "bvh": {"base", "math", "simd", "tasks", "geometry"},
    "dynamics": {"base", "math", "rows"},
    "joints": {"base", "math", "rows", "dynamics"},
    "solve": {"base", "math", "simd", "tasks", "rows"},
    "collide": {"base", "math", "simd", "tasks", "geometry", "bvh"},
    "query": {"base", "math", "simd", "tasks", "geometry", "bvh", "collide"},
    "contacts": {"base", "math", "simd", "tasks", "rows", "geometry", "bvh", "dynamics", "collide"},
    "fluid": {"base", "math", "simd", "tasks", "rows", "geometry", "bvh", "dynamics", "collide"},
    "step": {"base", "math", "simd", "tasks", "rows", "geometry", "bvh", "dynamics", "joints", "solve", "collide",
             "query", "contacts", "fluid"},
}
MAY_INCLUDE["characters"] = MAY_INCLUDE["query"] | {"query", "dynamics", "rows", "contacts", "step"}
MAY_INCLUDE["vehicles"] = MAY_INCLUDE["step"] | {"step"}
MAY_INCLUDE["assemblies"] = MAY_INCLUDE["step"] | {"step"}
MAY_INCLUDE["state"] = MAY_INCLUDE["step"] | {"step"}
MAY_INCLUDE["diagnose"] = MAY_INCLUDE["step"] | {"step"}
MAY_INCLUDE["api"] = MAY_INCLUDE["state"] | {"state", "diagnose"}
OUTSIDE = ["viewer", "view", "drawstuff", "demos", "scenes", "record", "robots", "integrations", "cli", "bench", "tests/parity", "tests/clients", "tests/physics",
           "tests/cli", "tests/viewer", "tests/view", "tests/drawstuff", "tests/record", "tests/abi",
           "tests/gazebo"]
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)

# Rooms of the large folders: what each of them may include of its own folder.
ROOMS = {
    "base": {
        "threads": set(),
        "": {"threads"},
        "streams": {""},
        "objects": {"", "threads"},
    },
    "geometry": {
        "": set(),
        "hulls": {""},
        "overlap": {"", "hulls"},
        "immersion": set(),
    },
    "joints": {
        "": set(),
        "types": {""},
    },
    "step": {
        "common": set(),
        "island/problem": {"common"},
        "island/positions": {"common", "island/problem"},
        "island/tree": {"common", "island/problem", "island/positions"},
        "island": {"common", "island/problem", "island/positions"},
        "steppers": {"common", "island", "island/problem", "island/positions", "island/tree"},
        "": {"common", "island", "island/problem", "island/positions", "steppers"},
    },
    "api": {
        "": set(),
        "math": {""},
        "system": {""},
    },
    "solve": {
        "": set(),
        "common": {""},
        "exact/factor": set(),
        "exact/problem": {"common", "exact/factor"},
        "exact/extended": {"exact/problem", "exact/factor"},
        "exact/small": {"", "common", "exact/factor", "exact/problem"},
        "exact": {"", "common", "exact/factor", "exact/problem", "exact/extended", "exact/small"},
        "tree": {"", "common"},
        "joints": {"", "common"},
        "sweeps": {"", "common", "joints"},
        "substeps/impacts": set(),
        "substeps": {"", "common", "joints", "sweeps", "exact/factor", "substeps/impacts"},
    },
    "collide": {
        "": set(),
        "surfaces": {""},
        "types": {"", "surfaces"},
        "pairs": {"", "surfaces", "types"},
        "pairs/round": {"", "pairs"},
        "pairs/polyhedra": {"", "pairs"},
        "pairs/surfaces": {"", "surfaces", "pairs", "pairs/polyhedra"},
        "pairs/rays": {"", "surfaces", "pairs", "pairs/surfaces"},
    },
}
MAX_FILES = 30  # of a room


def room_of(name):
    folder, *inner = name.split("/")[:-1]
    return folder, "/".join(inner)


def may_see(source, target):
    (folder, room), (its_folder, its_room) = room_of(source), room_of(target)
    if folder != its_folder:
        return its_folder == "ode" or its_folder in MAY_INCLUDE.get(folder, set())
    return room == its_room or folder not in ROOMS or its_room in ROOMS[folder].get(room, set())


errors = []
files_of = {}
for path in sorted((ROOT / "src").rglob("*")):
    if path.suffix not in (".h", ".cpp", ".inc"):
        continue
    name = str(path.relative_to(ROOT / "src"))
    files_of.setdefault(room_of(name), []).append(name)
    for included in INCLUDE.findall(path.read_text()):
        if not may_see(name, included):
            errors.append(f"src/{name}: may not include {included}")
for (folder, room), files in files_of.items():
    if folder in ROOMS and room not in ROOMS[folder]:
        errors.append(f"src/{folder}/{room}: a room that is not in the table")
    if len(files) > MAX_FILES:
        errors.append(f"src/{folder}/{room}: {len(files)} files")
for outside in OUTSIDE:
    for path in sorted((ROOT / outside).rglob("*")):
        if path.suffix in (".h", ".cpp", ".c"):
            for name in INCLUDE.findall(path.read_text()):
                if (ROOT / "src" / name).exists():
                    errors.append(f"{path.relative_to(ROOT)}: only ode/*.h is visible here, not {name}")

# Batches depend on robots: of src they see short vectors alone. Kernels know the flat model, not where it comes from.
BATCH_MAY = {"": {"", "derivatives", "lanes", "model", "robots", "simd"}, "model": {"model", "robots"}, "lanes": {"lanes", "model", "simd"},
             "derivatives": {"derivatives", "lanes", "model"}, "tasks": {"", "lanes", "tasks"}, "api": {"", "api", "robots"}}
for path in sorted((ROOT / "batch").rglob("*")):
    if path.suffix not in (".h", ".cpp", ".inc"):
        continue
    room = "/".join(path.relative_to(ROOT / "batch").parts[:-1])
    for name in INCLUDE.findall(path.read_text()):
        its = name.split("/")[0]
        if its == "batch":
            its = "/".join(name.split("/")[1:-1])
        if its not in BATCH_MAY[room] | {"epode", "ode"}:
            errors.append(f"{path.relative_to(ROOT)}: may not include {name}")
for path in sorted((ROOT / "robots").rglob("*")):
    if path.suffix in (".h", ".cpp") and '"batch/' in path.read_text():
        errors.append(f"{path.relative_to(ROOT)}: robots do not know batches")

# Sizes: a file holds one concept. The exceptions carry their reason in their head comment.
LONG_FILES = {}
for path in sorted((ROOT / "src").rglob("*.*")):
    lines = path.read_text().count("\n")
    if lines > LONG_FILES.get(str(path.relative_to(ROOT)), 600):
        errors.append(f"{path.relative_to(ROOT)}: {lines} lines")

# Words that would cost us the same bits on every machine.
FORBIDDEN = re.compile(r"\b(std::fma|_mm_fmadd|_mm_rsqrt|_mm_rcp|unordered_map|unordered_set|std::rand|srand|"
                       r"std::sin|std::cos|std::atan2|std::acos|std::pow|std::exp|std::log)\b")
for path in sorted([*(ROOT / "src").rglob("*.*"), *(ROOT / "batch").rglob("*.*")]):
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if FORBIDDEN.search(line.split("//")[0]):
            errors.append(f"{path.relative_to(ROOT)}:{number}: {FORBIDDEN.search(line).group(0)} is not deterministic")

print("\n".join(errors) if errors else "layers: ok")
sys.exit(1 if errors else 0)
