#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Functions of the step and of the solvers have few branches: a cyclomatic number (McCabe 1976: decisions + 1, as lizard counts them) of
at most LIMIT.

  check_complexity.py             faults; exit status 1 if there are any (lizard comes from PyPI, into build/lizard, if it is not there)
  check_complexity.py --list      the twenty functions with most branches in all of src, without judging
  check_complexity.py --root D    judges the tree D instead of this one (tests/docs/planted_complexity.sh)"""
import argparse
import importlib.util
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIZARD = "lizard==1.24.3"
FOLDERS = ("src/step", "src/solve")
SUFFIXES = {".cpp", ".h", ".inc"}
LIMIT = 15


def provide_lizard():
    if importlib.util.find_spec("lizard"):
        return
    venv = ROOT / "build/lizard"
    if not (venv / "bin/lizard").exists():
        subprocess.run([sys.executable, "-m", "venv", venv], check=True)
        subprocess.run([venv / "bin/pip", "install", "--quiet", "--disable-pip-version-check", LIZARD], check=True)
    sys.path += map(str, venv.glob("lib/python3*/site-packages"))


def functions(root, folders):
    """(cyclomatic number, path, line, name) of each function."""
    provide_lizard()
    import lizard
    for folder in folders:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in SUFFIXES:
                # lizard knows the language by the name, and not that of a .inc.
                found = lizard.analyze_file.analyze_source_code(f"{path}.cpp", path.read_text())
                for one in found.function_list:
                    yield one.cyclomatic_complexity, path.relative_to(root), one.start_line, one.name


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT)
    arguments = parser.parse_args()
    if arguments.list:
        for number, path, line, name in sorted(functions(arguments.root, ["src"]), reverse=True)[:20]:
            print(f"{number:3} {path}:{line} {name}")
        return 0
    count, faults = 0, 0
    for number, path, line, name in functions(arguments.root, FOLDERS):
        count += 1
        if number > LIMIT:
            faults += 1
            print(f"{path}:{line}: {name} has a cyclomatic number of {number}, over {LIMIT}")
    if count == 0:
        print("complexity: no function found")
        return 1
    print(f"complexity: {faults} faults" if faults else f"complexity: ok, {count} functions")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
