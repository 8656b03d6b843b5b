#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Every source compiles alone: with its own includes, whatever its folder's other files and precompiled headers bring. Builds compile
the files of a folder as one (EPODE_BY_FOLDER), so they do not notice an include that is missing.

  check_alone.py                    the sources that have changed, and one that includes it for each changed header, since the merge base
                                    with origin's main; where that is the current commit, or unknown, in the last COMMITS commits
  check_alone.py --since COMMIT     since that commit
  check_alone.py --all              all of them
  check_alone.py --limit N          no more than N sources, those that changed last first; the rest is named as left to --all
  check_alone.py --build FOLDER     of this configured build instead of build/release; generated files must have been made
  check_alone.py --root FOLDER      judges that tree instead of this one (tests/docs/planted_alone.sh)

The compiler checks the syntax and optimises nothing; warnings are errors as in the build. A source of both libraries is checked in both
precisions. Exit status 1 if a source fails."""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

COMMITS = 50
INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([^">]+)[">]', re.M)


def git(root, *arguments):
    """What git prints, or None if it refuses."""
    done = subprocess.run(["git", *arguments], cwd=root, capture_output=True, text=True)
    return done.stdout.strip() if done.returncode == 0 else None


def last_landed(root):
    """The commit to compare with, or None: all files."""
    base = git(root, "merge-base", "HEAD", "origin/main")
    if base and base != git(root, "rev-parse", "HEAD"):
        return base
    return git(root, "rev-parse", "--verify", "--quiet", f"HEAD~{COMMITS}")


def includes(path):
    return INCLUDE.findall(path.read_text(errors="replace"))


def sources_of(path):
    """The files of ours that a file of the build consists of: those of a folder where they are compiled as one."""
    return [pathlib.Path(name) for name in includes(path)] if "/Unity/unity_" in str(path) else [path]


def checking(entry):
    """The compiler's words for a check in place of the build's object, without its precompiled headers."""
    words, kept = shlex.split(entry["command"]), []
    skip = 0
    for at, word in enumerate(words):
        if skip:
            skip -= 1
        elif word in ("-o", "-c"):
            skip = 1
        elif word == "-include" and "cmake_pch" in words[at + 1]:
            skip = 1
        elif word != "-Winvalid-pch":
            kept.append(word)
    return kept + ["-fsyntax-only"]


def commands(build):
    """By source and precision, the compiler's words and where to run them."""
    found = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        path = pathlib.Path(entry["file"])
        if path.name.startswith("cmake_pch"):
            continue
        for source in sources_of(path):
            if source.is_relative_to(build):  # generated
                continue
            single = "-DdIDESINGLE" in entry["command"]
            found.setdefault((source, single), (entry["directory"], checking(entry) + [str(source)]))
    return found


def changed_since(root, commit):
    names = git(root, "diff", "--name-only", commit, "--")
    if names is None:
        sys.exit(f"check_alone.py: there is no commit {commit}")
    new = git(root, "ls-files", "--others", "--exclude-standard")
    return {name for name in (names + "\n" + new).split("\n") if name}


def headers_of(source, root):
    """What it may include of ours. Headers are named from one of the folders of headers, or their own."""
    here = os.path.dirname(str(source.relative_to(root)))
    return {os.path.normpath(f"{folder}{header}") for header in includes(source) for folder in ("", "src/", "include/", f"{here}/")}


def newest_first(known, root, since):
    """Sources whose own last change is younger come first."""
    names = (git(root, "log", "--name-only", "--format=", f"{since}..HEAD", "--") or "").split("\n")
    age = {name: number for number, name in reversed(list(enumerate(names)))}
    return dict(sorted(known.items(), key=lambda its: age.get(str(its[0][0].relative_to(root)), len(names))))


def concerned(known, root, changed):
    """What has changed, and for each changed header the first source that includes it."""
    kept, seen = {}, set()
    for key in sorted(known):
        new = (headers_of(key[0], root) & changed) - seen
        if new or str(key[0].relative_to(root)) in changed:
            kept[key] = known[key]
            seen |= new
    return kept


def check(command):
    folder, words = command
    return subprocess.run(words, cwd=folder, capture_output=True, text=True)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--all", action="store_true")
    options.add_argument("--since")
    options.add_argument("--limit", type=int, default=sys.maxsize)
    options.add_argument("--build", default="build/release")
    options.add_argument("--root", default=pathlib.Path(__file__).parent.parent, type=pathlib.Path)
    asked = options.parse_args()
    root = asked.root.resolve()
    build = root / asked.build
    if not (build / "compile_commands.json").is_file():
        sys.exit(f"check_alone.py: no {build}/compile_commands.json: configure it first (scripts/test)")

    known = commands(build)
    since = None if asked.all else asked.since or last_landed(root)
    if since:
        changed = changed_since(root, since)
        known = newest_first(concerned(known, root, changed), root, since)
    left = max(0, len(known) - asked.limit)
    known = dict(list(known.items())[:asked.limit])
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as several:
        for (source, single), done in zip(known, several.map(check, known.values())):
            if done.returncode != 0:
                failed += 1
                print(f"{source.relative_to(root)} does not compile alone{' in single precision' if single else ''}:\n{done.stderr}")
    what = f"changed since {git(root, 'describe', '--always', since)}" if since else "all"
    print(f"check_alone: {len(known)} sources ({what}), {failed} do not compile alone" + (f"; {left} more are left to --all" if left else ""))
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
