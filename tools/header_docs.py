# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Reads the documentation of the public headers, for check_docs.py (is anything missing?) and doxygen_filter.py
(the reference manual).

The convention of include/ode: a comment that opens with two stars speaks of everything from it to the next empty
line or the next comment of its own, a *run*: a setter and its getter, the eight ways to add a force. It names every
argument and ends with where the definition comes from, in brackets:
  [guide]  the user guide of ODE 0.039     [0.16]  the behaviour of ODE 0.16     [ours]  this library
A comment that opens with "@chapter name Title" begins a chapter of the manual. Its paragraph "Arguments:" explains,
one "- name, name: text" each, arguments that mean the same in all functions from there to the end of the file; a run
need not repeat them. Its paragraph "Refused: ..." tells what every function of the chapter refuses."""
import dataclasses
import re

SOURCES = ("guide", "0.16", "ours")
_COMMENT = re.compile(r"/\*.*?\*/", re.S)
_FUNCTION = re.compile(r"\b(?P<name>[A-Za-z_]\w*)\s*\((?P<args>[^()]*(?:\([^()]*\)[^()]*)*)\)\s*(?:;|\{)")


@dataclasses.dataclass
class Function:
    name: str
    parameters: list  # names; "" where the declaration leaves one out
    line: int


@dataclasses.dataclass
class Run:
    comment: str  # without stars; "" where there is none
    begin: int  # offsets in the file's text: of the comment (or the first declaration) ...
    body: int  # ... of what it speaks of
    end: int
    functions: list
    chapter: object  # a Chapter, or None

    def sources(self):
        found = re.search(r"\[([\w., ]+)\]\s*$", self.comment)
        names = [name.strip() for name in found.group(1).split(",")] if found else []
        return names if names and all(name in SOURCES for name in names) else []


@dataclasses.dataclass
class Chapter:
    name: str
    title: str
    text: str
    arguments: dict  # name: what it means, of this chapter and those before it in the file
    explained: dict  # those of this chapter alone
    refused: str
    begin: int
    end: int


def chapters(text):
    """The chapters of a header's text, in order."""
    result, arguments = [], {}
    for match in _COMMENT.finditer(text):
        head = re.match(r"@chapter (\w+) ([^\n]+)\n?(.*)", plain(match.group(0)), re.S)
        if not head:
            continue
        refused, said, explained = "", [], {}
        for paragraph in re.split(r"\n\s*\n", head[3].strip()):
            if paragraph.startswith("Arguments:"):
                for names, meaning in re.findall(r"^- ([\w, ]+?): (.*?)(?=\n- |\Z)", paragraph, re.S | re.M):
                    explained |= {name.strip(): " ".join(meaning.split()) for name in names.split(",")}
            else:
                words, _, refusals = paragraph.partition("Refused: ")
                refused = " ".join(refusals.split()) or refused
                said.append(words.strip())
        arguments |= explained
        result.append(Chapter(head[1], head[2], "\n\n".join(said).strip(), dict(arguments), explained, refused,
                              match.start(), match.end()))
    return result


def plain(comment):
    """The text of a comment without its frame."""
    text = re.sub(r"^/\*\*?<?|\*/$", "", comment)
    return re.sub(r"\n[ \t]*(?:\* ?)?", "\n", text).strip()


def parameters(arguments):
    names = []
    depth, piece = 0, ""
    for c in arguments + ",":
        if c == "," and depth == 0:
            names.append(_parameter(piece.strip()))
            piece = ""
            continue
        depth += (c == "(") - (c == ")")
        piece += c
    return [name for name in names if name is not None]


def _parameter(piece):
    if piece in ("", "void", "..."):
        return None
    callback = re.search(r"\(\s*\*\s*(\w*)\s*\)\s*\(", piece)
    if callback:
        return callback.group(1)
    words = re.findall(r"\w+", re.sub(r"\[[^\]]*\]", "", piece))
    unnamed = len([w for w in words if w not in ("const", "struct", "unsigned", "signed", "long")]) < 2
    return "" if unnamed and not (len(words) > 1 and words[-2] in ("unsigned", "long")) else words[-1]


def blank_comments(text):
    """The text with comments and the bodies of functions blanked out, all offsets kept."""
    hide = lambda found: re.sub(r"[^\n]", " ", found.group(0))
    text = re.sub(r"//[^\n]*", hide, _COMMENT.sub(hide, text))
    body = re.compile(r"\)(?: const)?\s*\{")
    position = 0
    while found := body.search(text, position):
        end, depth = found.end(), 1
        while end < len(text) and depth:
            depth += {"{": 1, "}": -1}.get(text[end], 0)
            end += 1
        text = text[:found.end()] + re.sub(r"[^\n]", " ", text[found.end():end - 1]) + text[end - 1:]
        position = end
    return text


def _functions(code, offset, line_of):
    found = []
    for match in _FUNCTION.finditer(code):
        head = code[:match.start()].rsplit(";", 1)[-1].rsplit("}", 1)[-1]
        declared = re.search(r"\b(?:ODE_(?:API|PURE_INLINE|INLINE)|DS_API)\b", head)
        if not declared or "typedef" in head or "#define" in head.rsplit("\n", 1)[-1]:
            continue
        found.append(Function(match["name"], parameters(match["args"]), line_of(offset + match.start("name"))))
    return found


def _own_comments(text):
    """Comments that stand at the beginning of a line, without those that belong to what is before them."""
    for match in _COMMENT.finditer(text):
        if text[:match.start()].endswith(("\n", "\n    ")) and not match.group(0).startswith("/**<"):
            yield match


def _end_of_run(text, blank, body, comments):
    """The next empty line or comment, but not one inside braces."""
    stop = body
    while True:
        gap = re.compile(r"\n[ \t]*\n").search(text, stop + 1)
        stop = min([gap.start() if gap else len(text)] + [m.start() for m in comments if m.start() > max(body, stop)])
        inside = blank.count("{", body, stop) > blank.count("}", body, stop)
        if stop == len(text) or not inside or 'extern "C" {' in text[body:stop]:
            return stop


def runs(text):
    """The runs of a header's text, in order; declarations without a comment make a run of their own."""
    parts, blank = chapters(text), blank_comments(text)
    comments = list(_own_comments(text))
    line_of = lambda offset: text.count("\n", 0, offset) + 1
    result, position = [], 0
    while True:
        code = re.compile(r"\S").search(blank, position)
        comment = next((m for m in comments if m.start() >= position), None)
        if not code:
            return result
        begin = body = code.start()
        said = ""
        if comment and comment.start() < code.start():
            speaks = comment.group(0).startswith("/**") and not blank[comment.end():code.start()].count("\n\n")
            if not speaks or any(comment.end() <= m.start() < code.start() for m in comments):
                position = comment.end()
                continue
            begin, body, said = comment.start(), comment.end(), plain(comment.group(0))
        stop = _end_of_run(text, blank, body, comments)
        part = next((c for c in reversed(parts) if c.begin < begin), None)
        result.append(Run(said, begin, body, stop, _functions(blank[body:stop], body, line_of), part))
        position = stop
