#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""release_manifest.py FOLDER VERSION: what lies in a release's folder, of what commit and by what it was made, as JSON on stdout."""

import hashlib
import json
import subprocess
import sys
from pathlib import Path

# What a name ends with, where it goes, and what it is.
KINDS = [
    (".spdx.json", "the release's page", "bill of materials, SPDX 2.3"),
    (".whl", "PyPI", "wheel"),
    (".deb", "a repository of Debian's form", "Debian package"),
    ("vcpkg.json", "an overlay of vcpkg", "manifest of the port"),
    ("portfile.cmake", "an overlay of vcpkg", "the port"),
]


def says(*command):
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return done.stdout.splitlines()[0]


def kind_of(path):
    for ending, goes_to, what in KINDS:
        if path.name.endswith(ending):
            return goes_to, what
    return ("PyPI", "source distribution of the Python package") if path.parent.name == "python" else ("the release's page", "source archive")


def entry(folder, path):
    goes_to, what = kind_of(path)
    return {"file": str(path.relative_to(folder)), "what": what, "goes_to": goes_to, "bytes": path.stat().st_size,
            "sha256": hashlib.sha256(path.read_bytes()).hexdigest()}


def manifest(folder, version):
    files = sorted(path for path in folder.rglob("*") if path.is_file() and path.name not in ("SHA256SUMS", "manifest.json"))
    return {"name": "epode", "version": version, "commit": says("git", "rev-parse", "HEAD"), "date": says("git", "log", "-1", "--format=%cI"),
            "compiler": says("c++", "--version"), "cmake": says("cmake", "--version"), "files": [entry(folder, path) for path in files]}


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    json.dump(manifest(Path(sys.argv[1]), sys.argv[2]), sys.stdout, indent=1)
    print()
