#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""doxygen_filter.py HEADER: the header as Doxygen is to see it (docs/Doxyfile names this as its filter).

Doxygen knows comments of single declarations; ours speak of a run of them (header_docs.py). So each function gets a
copy of its run's comment, with what the chapter says of its arguments and of what is refused, and with the source of
the definition in words. Chapters become Doxygen's groups, the opening `//` lines the description of the file."""
import pathlib
import re
import sys

import check_docs
import header_docs

SOURCE_WORDS = {"guide": "the user guide of ODE 0.039", "0.16": "ODE 0.16", "ours": "this library"}
# What the guide's chapters are about, by the beginnings of the names of ours.
GUIDE_CHAPTERS = {"bod": "rigid body functions", "world": "world", "stepping": "world", "init": "world",
                  "mass": "mass functions", "rotation": "rotation functions", "old_names": "StepFast1"}
# Parts of the manual (docs/parts.dox) by header.
PARTS = {"objects": "dynamics", "contact": "dynamics", "objects_joints": "joint_types", "collision": "collision",
         "collision_space": "collision", "collision_trimesh": "collision", "mass": "mathematics",
         "rotation": "mathematics", "odemath": "mathematics", "matrix": "mathematics", "matrix_coop": "mathematics",
         "misc": "mathematics",
         "report": "dynamics", "step_options": "dynamics", "steppers": "dynamics", "contacts": "dynamics", "shapes": "collision",
         "queries": "collision", "compatibility": "names", "ext": "names", "drawstuff": "drawing"}
GUIDE_JOINTS = "joint types and joint functions"
GUIDE_NAMES = check_docs.guide_names()
CHAPTERS = check_docs.all_chapters()


def escape(text):
    """Signs that Doxygen would take for commands of its own."""
    return re.sub(r"(?<![\w/])#(?=\w)", r"\\#", text.replace("<=", "&le;").replace(">=", "&ge;"))


def linked(refused):
    """What the functions of a chapter refuse, with a link where it says "as for" another chapter."""
    return re.sub(r"as for (\w+)", lambda m: f'as for @ref {m[1]} "{CHAPTERS[m[1]].title}"', escape(header_docs.untagged(refused)))


def source_words(run, function):
    """Where the definition of a function comes from; of the guide also the chapter."""
    sources = run.sources()
    if len(sources) > 1 and function:
        sources = ["guide"] if function in GUIDE_NAMES else [s for s in sources if s != "guide"]
    about = next((title for start, title in GUIDE_CHAPTERS.items() if run.chapter.name.startswith(start)), GUIDE_JOINTS)
    return ", ".join(SOURCE_WORDS[source] + (f" ({about})" if source == "guide" else "") for source in sources)


def comment_of(run, function=None):
    """The comment of one function of a run (or of what is none), with @param lines for what the chapter explains."""
    names = function.parameters if function else []
    lines = [escape(run.text_of(function.name) if function else run.items()[0] or run.said())]
    chapter = run.chapter
    for name in names:
        if chapter and name in chapter.arguments:
            lines.append(f"@param {name} {escape(chapter.arguments[name])}")
    refused = header_docs.refusals(function, chapter, CHAPTERS, run.text_of(function.name)) if function and chapter else ""
    if refused:
        lines.append(f"@par Refused\n{escape(refused)} See also @ref refusals.")
    if run.sources():
        lines.append("@par Defined by\n" + source_words(run, function and function.name))
    return "/** " + "\n".join(lines) + " */\n"


def group_of(chapter, part):
    listed = "".join(f"\n- `{name}`: {escape(meaning)}" for name, meaning in chapter.explained.items())
    text = escape(chapter.text)
    if chapter.refused:
        text += f"\n\n@par Refused\n{linked(chapter.refused)}"
    text += f"\n\n@par Arguments\n{listed}" if listed else ""
    return f"/** @defgroup {chapter.name} {chapter.title}\n@ingroup part_{part}\n{text}\n@{{ */"


def start_of_declaration(blank, offset, floor):
    """Where the declaration begins that names a function at `offset`."""
    cut = max(blank.rfind(mark, floor, offset) for mark in (";", "}"))
    start = max(cut + 1, floor)
    found = re.compile(r"(?:\s|#define[^\n]*\n)*").match(blank, start, offset)
    return found.end() if found else start


def declarations(text, blank, run):
    """Where the macros and one-line types of a run begin; those with a comment of their own behind them are left."""
    for match in re.finditer(r"^(?:[ \t]*#define \w|typedef [^;{]*;)", blank[run.body:run.end], re.M):
        line_end = text.find("\n", run.body + match.end())
        if "/**<" not in text[run.body + match.end():line_end]:
            yield run.body + match.start()


def pieces(text, part):
    """(begin, end, replacement) of everything that changes, in order."""
    blank = header_docs.blank_comments(text)
    head = re.match(r"(?://[^\n]*\n)+", text)
    if head:
        said = "\n".join(line[2:].strip() for line in head.group(0).splitlines()[3:])
        yield head.start(), head.end(), "/** @file\n" + escape(said) + " */\n"
    for chapter in header_docs.chapters(text):
        yield chapter.begin, chapter.end, ("\0" + group_of(chapter, part))
    for run in header_docs.runs(text):
        if not run.comment or run.comment.startswith("@chapter"):
            continue
        if not run.functions:
            found = list(declarations(text, blank, run))
            if len(found) < 2:
                continue
            yield run.begin, run.body, ""
            for at in found:
                yield at, at, comment_of(run)
            continue
        yield run.begin, run.body, ""
        for at in declarations(text, blank, run):
            yield at, at, comment_of(run)
        floor = run.body
        for function in run.functions:
            at = re.compile(r"\b" + function.name + r"\s*\(").search(blank, floor).start()
            start = start_of_declaration(blank, at, floor)
            yield start, start, comment_of(run, function)
            floor = at + len(function.name)


def members(text):
    """Copies comments inside classes to each member of the run."""
    out, comment = [], None
    lines = text.split("\n")
    i = 0
    while i < len(lines):
        line = lines[i]
        if re.match(r" {4}/\*\*(?!<)", line):
            block = [line]
            while "*/" not in lines[i]:
                i += 1
                block.append(lines[i])
            comment, fresh = block, True
            out += block
        elif comment and not line.strip():
            comment = None
            out.append(line)
        elif comment and re.match(r" {4}[A-Za-z~]", line):
            if not fresh:
                out += comment
            fresh = False
            out.append(line)
        else:
            out.append(line)
        i += 1
    return "\n".join(out)


def filtered(text, part):
    result, position, is_open = [], 0, False
    for begin, end, replacement in sorted(pieces(text, part), key=lambda piece: (piece[0], piece[1])):
        result.append(text[position:begin])
        if replacement.startswith("\0"):
            replacement = ("/** @} */\n" if is_open else "") + replacement[1:]
            is_open = True
        result.append(replacement)
        position = max(position, end)
    result.append(text[position:])
    whole = "".join(result)
    if is_open:
        cut = whole.rindex("#ifdef __cplusplus")
        whole = whole[:cut] + "/** @} */\n" + whole[cut:]
    return members(whole)


if __name__ == "__main__":
    header = pathlib.Path(sys.argv[1])
    sys.stdout.write(filtered(header.read_text(encoding="utf-8"), PARTS.get(header.stem, "services")))
