#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Every public function of include/ode and include/drawstuff says what it does, names its arguments and says where its definition comes
from (header_docs.py has the convention). Fails on

  a function without a comment, or whose comment says nothing in words;
  an argument whose name is neither in the comment nor among the arguments of the chapter, or that has no name;
  a function in no chapter, or in one that does not say what is refused;
  a comment without [guide], [0.16] or [ours], or [guide] where the guide knows none of its functions, or the
  other way round (tests/abi/guide_names.inc lists what the guide names);
  a function declared in two headers.

check_docs.py [FILE...]: without files all of both folders; --count prints how many functions there are."""
import pathlib
import re
import sys

import header_docs

ROOT = pathlib.Path(__file__).resolve().parent.parent
HEADERS = sorted(header for folder in ("ode", "drawstuff") for header in (ROOT / "include" / folder).glob("*.h"))
# Classes, not functions: every member calls the C function of its name, and tests/cpp/members.py counts them; and
# names of C++ that call C functions.
WITHOUT_FUNCTIONS = ("odecpp", "doubles")


def guide_names():
    text = (ROOT / "tests" / "abi" / "guide_names.inc").read_text(encoding="utf-8")
    return set(re.findall(r"^F\((\w+)\)", text, re.M))


def names_in(comment):
    return set(re.findall(r"[A-Za-z_]\w*", comment))


def faults_of(path, run, guide):
    words = names_in(run.comment)
    explained = run.chapter.arguments if run.chapter else {}
    for function in run.functions:
        where = f"{path}:{function.line}: {function.name}"
        if len(words) < 2:
            yield f"{where}: no comment"
            continue
        if not run.chapter or not run.chapter.refused and "efuse" not in run.comment:
            yield f"{where}: neither the comment nor the chapter says what is refused"
        for name in function.parameters:
            if not name:
                yield f"{where}: an argument has no name"
            elif name not in words and name not in explained:
                yield f"{where}: argument {name} is not in the comment"
    if run.functions and run.comment:
        where = f"{path}:{run.functions[0].line}: {run.functions[0].name}"
        sources, known = run.sources(), {f.name for f in run.functions} & guide
        if not sources:
            yield f"{where}: the comment does not end with [guide], [0.16] or [ours]"
        elif ("guide" in sources) != bool(known):
            yield f"{where}: [guide] does not agree with the names that the guide has"


def main():
    arguments = [a for a in sys.argv[1:] if not a.startswith("-")]
    paths = [pathlib.Path(a).resolve() for a in arguments] or HEADERS
    guide, declared, faults, commented = guide_names(), {}, [], 0
    for path in paths:
        if path.name.startswith(WITHOUT_FUNCTIONS):
            continue
        shown = path.relative_to(ROOT) if path.is_relative_to(ROOT) else path
        for run in header_docs.runs(path.read_text(encoding="utf-8")):
            faults += faults_of(shown, run, guide)
            commented += bool(run.functions and run.comment)
            for function in run.functions:
                if function.name in declared:
                    faults.append(f"{shown}:{function.line}: {function.name}: also in {declared[function.name]}")
                declared[function.name] = shown
    print("\n".join(faults))
    print(f"{len(declared)} public functions in {len(paths)} headers, {commented} comments, {len(faults)} faults")
    return bool(faults) or not declared


if __name__ == "__main__":
    sys.exit(main())
