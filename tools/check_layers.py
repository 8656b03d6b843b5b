#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# Dependencies between folders point one way. This table is the architecture; CI runs it first.
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
    "step": {"base", "math", "simd", "tasks", "rows", "geometry", "bvh", "dynamics", "joints", "solve", "collide",
             "query", "contacts"},
}
MAY_INCLUDE["api"] = MAY_INCLUDE["step"] | {"step"}
OUTSIDE = ["viewer", "view", "drawstuff", "demos", "scenes", "record", "cli", "bench", "tests/parity", "tests/clients", "tests/physics",
           "tests/cli", "tests/viewer", "tests/view", "tests/drawstuff", "tests/record", "tests/abi"]
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)

errors = []
for path in sorted((ROOT / "src").rglob("*")):
    if path.suffix not in (".h", ".cpp", ".inc"):
        continue
    folder = path.relative_to(ROOT / "src").parts[0]
    for name in INCLUDE.findall(path.read_text()):
        target = name.split("/")[0]
        if target != "ode" and target != folder and target not in MAY_INCLUDE.get(folder, set()):
            errors.append(f"{path.relative_to(ROOT)}: {folder} may not include {name}")
for outside in OUTSIDE:
    for path in sorted((ROOT / outside).rglob("*")):
        if path.suffix in (".h", ".cpp", ".c"):
            for name in INCLUDE.findall(path.read_text()):
                if (ROOT / "src" / name).exists():
                    errors.append(f"{path.relative_to(ROOT)}: only ode/*.h is visible here, not {name}")

# Sizes: a file holds one concept. The exceptions carry their reason in their head comment.
LONG_FILES = {}
for path in sorted((ROOT / "src").rglob("*.*")):
    lines = path.read_text().count("\n")
    if lines > LONG_FILES.get(str(path.relative_to(ROOT)), 600):
        errors.append(f"{path.relative_to(ROOT)}: {lines} lines")

# Words that would cost us the same bits on every machine.
FORBIDDEN = re.compile(r"\b(std::fma|_mm_fmadd|_mm_rsqrt|_mm_rcp|unordered_map|unordered_set|std::rand|srand|"
                       r"std::sin|std::cos|std::atan2|std::acos|std::pow|std::exp|std::log)\b")
for path in sorted((ROOT / "src").rglob("*.*")):
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if FORBIDDEN.search(line.split("//")[0]):
            errors.append(f"{path.relative_to(ROOT)}:{number}: {FORBIDDEN.search(line).group(0)} is not deterministic")

print("\n".join(errors) if errors else "layers: ok")
sys.exit(1 if errors else 0)
