#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Every public function of include/ode, include/drawstuff and include/epode says what it does, names its arguments and says where its definition comes
from (header_docs.py has the convention). Fails on

  a function without a comment, or whose comment says nothing in words;
  an argument whose name is neither in the comment nor among the arguments of the chapter, or that has no name;
  a function in no chapter, or in one that does not say what is refused;
  a comment without [guide], [0.16] or [ours], or [guide] where the guide knows none of its functions, or the
  other way round (tests/abi/guide_names.inc lists what the guide names);
  a function declared in two headers;
  a function that has no text of its own in a run of several, or the text of another one of the run;
  a text that names an argument that the function lacks, or that speaks of its place on a page ("above", "the first
  two functions", "the same"), since each entry of the manual stands alone;
  a refusal of a kind of argument that the function does not take, or that no function of the chapter can have.

check_docs.py [FILE...]: without files all of both folders; --count prints how many functions there are."""
import pathlib
import re
import sys

import header_docs

ROOT = pathlib.Path(__file__).resolve().parent.parent
HEADERS = sorted(header for folder in ("ode", "drawstuff", "epode") for header in (ROOT / "include" / folder).glob("*.h"))
# Classes, not functions: every member calls the C function of its name, and tests/cpp/members.py counts them; and
# names of C++ that call C functions.
WITHOUT_FUNCTIONS = ("odecpp", "doubles")


def guide_names():
    text = (ROOT / "tests" / "abi" / "guide_names.inc").read_text(encoding="utf-8")
    return set(re.findall(r"^F\((\w+)\)", text, re.M))


# Names of arguments that are words of English as well: in a text they need not mean the argument.
WORDS = set("""
    a adr ap axis back bits block bodies body bounce bound buffer callback capsule center channel clip collide color comp
    contact convex count cylinder data depth description dir direction distance down end enable enabled err error first
    factor file flags force frame friction from function functions geom g group handle head hit hits hole i id index info instance
    iterations joint k l left length level lines list m mass material mesh message mode moment motion mu n name normal
    num number offset on out over p pair parameter parts plane planes point points polygons position prefix problem
    character feet struct_size height
    quality r radius range ratio ray rel requirements reserve resources room s scale seconds side size slip
    solid solution source space sphere start stats step stepper steps t text the threads threshold time tolerance
    centre current fluid settings struct_size surface volume angle backlash batch box by category contacts cooperative Data directions events geoms gravity lengths most origin other
    report velocities model robot links joints poses actuator actuators link result skip torque transform triangle type u v value vector vel vertices w way width world x y z
""".split())
# What points to another place of a page.
PLACES = re.compile(r"""
    \b(?:see|as|said|named|listed|described|explained|given|told|functions?|that|one|here)\s+(?:above|below)\b
    | \((?:see\s+)?(?:above|below)\) | ,\s+(?:above|below)[,.]
    | \bthe\s+(?:former|latter)\b
    | \b[Tt]he\s+(?:first|second|third|last|other|previous|next|preceding|following|same)\s+(?:(?:one|two|three|four|five|six|seven|eight)\s+)?
      (?:functions?|forms?|products?|calls?|getters?|setters?|flags)\b
    | \b(?:[Tt]he|[Tt]his)\s+(?:getters?|setters?)\b | ^(?:Get|Set)\d?\s+(?:answers|writes)\b
    | ^(?:The\s+same\b(?!\s+\w+\s+(?:of|as)\b)|And\s|Likewise|Each\s+sets|Old\s+forms\b|Rates\s+of\s+the\s+two)
    """, re.X | re.M)


def all_chapters():
    """The chapters of all headers by name."""
    return {chapter.name: chapter for path in HEADERS for chapter in header_docs.chapters(path.read_text(encoding="utf-8"))}


def names_in(comment):
    return set(re.findall(r"[A-Za-z_]\w*", comment))


def faults_of(path, run, guide):
    words = names_in(run.comment)
    explained = run.chapter.arguments if run.chapter else {}
    for function in run.functions:
        where = f"{path}:{function.line}: {function.name}"
        if len(words) < 2:
            yield f"{where}: no comment; write /** What it does ... [ours] */ on the lines before it, without an empty line between"
            continue
        if not run.chapter or not run.chapter.refused and "efuse" not in run.comment:
            yield (f"{where}: neither the comment nor the chapter says what is refused; end the chapter (/* @chapter name Title) with "
                   "\"Refused: ...\", or with \"Refused: as for NAME.\" of another one")
        for name in function.parameters:
            if not name:
                yield f"{where}: an argument has no name; name it in the declaration"
            elif name not in words and name not in explained:
                yield f"{where}: argument {name} is not in the comment; use the word there, or explain it under \"Arguments:\" of the chapter as \"- {name}: ...\""
    if run.functions and run.comment:
        where = f"{path}:{run.functions[0].line}: {run.functions[0].name}"
        sources, known = run.sources(), {f.name for f in run.functions} & guide
        if not sources:
            yield f"{where}: the comment does not end with [guide] (the guide of 0.039 has it), [0.16] (ODE has it) or [ours]; an addition ends with [ours]"
        elif ("guide" in sources) != bool(known):
            yield f"{where}: [guide] does not agree with the names that the guide has (tests/abi/guide_names.inc); use [0.16] or [ours] for others"


def faults_of_entries(path, run, foreign):
    """What keeps the entries of a run's functions from standing on their own. `foreign`: the arguments' names in this header."""
    common, own = run.items()
    seen = {}
    for function in run.functions:
        where = f"{path}:{function.line}: {function.name}"
        if len(run.functions) > 1 and not own.get(function.name):
            yield f"{where}: no text of its own; its comment speaks of several functions: give each an item \"- {function.name}: ...\", or a comment"
            continue
        text = run.text_of(function.name)
        words = " ".join(own.get(function.name, "").split())
        if words and words in seen:
            yield f"{where}: the text of {seen[words]}; say what is different about it"
        seen[words] = function.name
        plain_text = re.sub(r"\b\w+\(.*?\)|`[^`]*`|\b\w+(?:->|\.|::)\w+|\[[^\]]*\]", " ", text)
        for name in sorted((names_in(plain_text) & foreign) - set(function.parameters) - WORDS):
            if len(name) == 1:  # a symbol of a formula
                continue
            yield f"{where}: the text names {name}, which it does not take but others of the header do; reword, write `{name}`, or add it to WORDS"
        place = PLACES.search(text)
        if place:
            yield f"{where}: '{' '.join(place[0].split())}' points to another place of the page; entries stand alone: name the function instead"
        for refused in re.findall(r"Refused: (.*)", text, re.S):
            for clause in header_docs.clauses(" ".join(refused.split()))[0]:
                if not header_docs.applies(clause, function):
                    yield f"{where}: refuses what it does not take: {clause}; write \"[{function.name[:8]}...] clause\" in the chapter for those that do"


def foreign_refusals(path, run, chapters):
    """Clauses in a function's "Refused" that name an object which it does not take."""
    for function in run.functions:
        if not run.chapter:
            continue
        for clause in header_docs.held(function, run.chapter, chapters, run.text_of(function.name)):
            for name, kind in () if clause.startswith("[") else header_docs.OBJECTS:
                if re.search(name, clause) and not re.search(kind, function.types):
                    yield f"{path}:{function.line}: {function.name}: refuses what it does not take: {clause}; write \"[{function.name[:8]}...] clause\" in the chapter for those that do"


def dead_clauses(path, chapter, functions):
    """Clauses of a chapter's refusals that none of its functions can have."""
    for clause in header_docs.clauses(chapter.refused)[0]:
        if functions and not re.match(r"as for ", clause) and not any(header_docs.applies(clause, one) for one in functions):
            yield f"{path}: chapter {chapter.name}: no function can refuse: {clause}; take the clause out of its \"Refused:\""


def main():
    arguments = [a for a in sys.argv[1:] if not a.startswith("-")]
    paths = [pathlib.Path(a).resolve() for a in arguments] or HEADERS
    guide, declared, faults, commented = guide_names(), {}, [], 0
    chapters = all_chapters()
    for path in paths:
        if path.name.startswith(WITHOUT_FUNCTIONS):
            continue
        shown = path.relative_to(ROOT) if path.is_relative_to(ROOT) else path
        runs = header_docs.runs(path.read_text(encoding="utf-8"))
        known = chapters | {one.name: one for one in header_docs.chapters(path.read_text(encoding="utf-8"))}
        foreign = {name for run in runs for function in run.functions for name in function.parameters if name}
        for chapter in header_docs.chapters(path.read_text(encoding="utf-8")):
            members = [one for run in runs if run.chapter for one in run.functions
                       if run.chapter.name == chapter.name or f"as for {chapter.name}" in run.chapter.refused]
            faults += dead_clauses(shown, chapter, members)
        for run in runs:
            faults += faults_of(shown, run, guide)
            faults += faults_of_entries(shown, run, foreign)
            faults += foreign_refusals(shown, run, known)
            commented += bool(run.functions and run.comment)
            for function in run.functions:
                if function.name in declared:
                    faults.append(f"{shown}:{function.line}: {function.name}: also in {declared[function.name]}; declare it once")
                declared[function.name] = shown
    print("\n".join(faults))
    print(f"{len(declared)} public functions in {len(paths)} headers, {commented} comments, {len(faults)} faults")
    return bool(faults) or not declared


if __name__ == "__main__":
    sys.exit(main())
