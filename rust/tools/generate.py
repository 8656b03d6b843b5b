#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""generate.py [--check]: writes what the Rust crates have of the public headers: epode-sys/src/ode.rs and robots.rs (every
exported function, structure and number), epode-sys/tests/names/mod.rs (their names, for the tests of layouts, numbers and links), and
epode/src/generated (methods of the safe crate, as safe_rules.py says). --check: writes nothing, fails if a file is out of date.

What reads the headers is Python's: tools/c_functions.py, tools/c_types.py, tools/header_docs.py."""
import os
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
ENGINE = HERE.parent.parent
sys.path[:0] = [str(ENGINE / "tools"), str(HERE)]
import raw
import safe


def main():
    cc = os.environ.get("CC", "cc")
    api = raw.read(str(ENGINE / "include"), cc)
    files = raw.files(api) | safe.files(api)
    stale = []
    for name, text in files.items():
        path = HERE.parent / name
        if path.exists() and path.read_text(encoding="utf-8") == text:
            continue
        stale.append(name)
        if "--check" not in sys.argv:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
            print("written:", name)
    if stale and "--check" in sys.argv:
        sys.exit(f"generate.py: out of date: {', '.join(stale)}; run rust/tools/generate.py")


if __name__ == "__main__":
    main()
