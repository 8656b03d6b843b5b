#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""vcpkg_manifest.py FILE: what vcpkg's documentation of vcpkg.json demands of a port's, of the keys that ours has."""

import json
import re
import sys
from pathlib import Path

IDENTIFIER = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")
# A platform expression: names, "&", "|", "!", parentheses; not "a & b | c" without them.
EXPRESSION = re.compile(r"!?\(?[a-z0-9]+( [&|] !?\(?[a-z0-9]+\)?)*\)?")
KNOWN = {"name", "version", "description", "homepage", "license", "supports", "dependencies", "features"}


def identifier(text):
    return isinstance(text, str) and IDENTIFIER.fullmatch(text)


def faults(manifest):
    yield from (f"unknown key '{key}'" for key in manifest.keys() - KNOWN)
    yield from (f"no '{key}'" for key in ("name", "version", "license", "description") if not isinstance(manifest.get(key), str))
    if not identifier(manifest.get("name")):
        yield "the name is not of small letters, digits and dashes"
    if not re.fullmatch(r"\d+(\.\d+)*", manifest.get("version", "")):
        yield "the version is not numbers with dots"
    if not EXPRESSION.fullmatch(manifest.get("supports", "linux")):
        yield "'supports' is no platform expression"
    for each in manifest.get("dependencies", []):
        if not identifier(each.get("name")) or each.keys() - {"name", "host", "features", "platform"}:
            yield f"dependency {each}"
    for name, feature in manifest.get("features", {}).items():
        if not identifier(name) or not isinstance(feature.get("description"), str):
            yield f"feature '{name}'"


if __name__ == "__main__":
    found = list(faults(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))))
    sys.exit("\n".join(f"{sys.argv[1]}: {fault}" for fault in found) or 0)
