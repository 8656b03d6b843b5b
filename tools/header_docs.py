# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Reads the documentation of the public headers, for check_docs.py (is anything missing?) and doxygen_filter.py
(the reference manual).

The convention of include/ode: a comment that opens with two stars speaks of everything from it to the next empty
line or the next comment of its own, a *run*: a setter and its getter, the eight ways to add a force. It names every
argument and ends with where the definition comes from, in brackets:
  [guide]  the user guide of ODE 0.039     [0.16]  the behaviour of ODE 0.16     [ours]  this library
In a run of several functions each has an item of its own, "- name: text", after what is true of them all: an entry of
the manual is the function's item and what is common, and stands on its own.
A comment that opens with "@chapter name Title" begins a chapter of the manual. Its paragraph "Arguments:" explains,
one "- name, name: text" each, arguments that mean the same in all functions from there to the end of the file; a run
need not repeat them. Its paragraph "Refused: clause; clause. Consequence." tells what the functions of the chapter
refuse. A clause belongs to those that have an argument of a kind it names (KINDS), or whose names begin with one of
the words before it in brackets, "[dGeomSet, dJointSet*Param] moving ..." (with "!" before it: do not); "as for NAME"
stands for another chapter's. Who may be given NULL says so in its text, and refuses no null pointer."""
import dataclasses
import fnmatch
import glob
import os
import re

SOURCES = ("guide", "0.16", "ours")
_COMMENT = re.compile(r"/\*.*?\*/", re.S)
_FUNCTION = re.compile(r"\b(?P<name>[A-Za-z_]\w*)\s*\((?P<args>[^()]*(?:\([^()]*\)[^()]*)*)\)\s*(?:;|\{)")


@dataclasses.dataclass
class Function:
    name: str
    parameters: list  # names; "" where the declaration leaves one out
    line: int
    types: str = ""  # the parameters as they are declared
    answers: bool = False  # returns something


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

    def said(self):
        """The comment without its sources."""
        return re.sub(r"\s*\[[\w., ]+\]\s*$", "", self.comment) if self.sources() else self.comment

    def items(self):
        """(what is common, {name: the text of that function alone})."""
        names = "|".join(function.name for function in self.functions)
        pieces = re.split(rf"^- ({names}): ", self.said(), flags=re.M) if names else [self.said()]
        return pieces[0].strip(), {name: text.strip() for name, text in zip(pieces[1::2], pieces[2::2])}

    def text_of(self, name):
        """What the entry of one function says."""
        common, own = self.items()
        return "\n\n".join(piece for piece in (own.get(name, ""), common) if piece)


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


_TAG = r"\[([\w, *!]+)\]"
_VECTORS = r"dVector\w+|dMatrix\w+|dQuaternion"
# What a clause of refusals may name, and what a function must take to be able to refuse it.
KINDS = (
    (r"\bworlds?\b", r"dWorldID"),
    (r"\bbod(?:y|ies)\b", r"dBodyID"),
    (r"\bgeoms?\b", r"dGeomID"),
    (r"\bspaces?\b", r"dSpaceID"),
    (r"\bjoints?\b", r"dJointID\s+\w"),
    (r"\bgroups?\b", r"dJointGroupID"),
    (r"\bdata\b", r"dTriMeshDataID|dHeightfieldDataID"),
    (r"\bimplementation\b", r"dThreadingImplementationID"),
    (r"\bpool\b", r"dThreadingThreadPoolID"),
    (r"\brequirements\b", r"dResourceRequirementsID"),
    (r"\bresources\b", r"dResourceContainerID"),
    (r"\bnull\b|\bNULL\b", rf"\*|\[|{_VECTORS}"),
    (r"\bnskip\b", r"\bnskip\b"),
    (r"\browSkip\b", r"\browSkip\b"),
    (r"^n that\b", r"\bint n\b"),
    (r"\bnot finite\b|\bno finite\b|\bno numbers?\b",
     rf"const\s+(?:dReal|float|double|void|{_VECTORS}|dMass|dMaterial|dContact)\b|(?:^|,)\s*(?:dReal|float|double)\s+\w+\s*(?=,|$)"),
    (r"\b(?:sizes?|stepsize)\b", r"\bdReal\b"),
)


def applies(clause, function):
    """Whether a clause of refusals can hold for a function: it has an argument of a kind that the clause names."""
    tagged = re.match(_TAG, clause)
    words = [word.strip() for word in tagged[1].split(",")] if tagged else []
    if any(word[0] == "!" and fnmatch.fnmatchcase(function.name, word[1:] + "*") for word in words):
        return False
    wanted = [word for word in words if word[0] != "!"]
    if wanted:
        return any(fnmatch.fnmatchcase(function.name, word + "*") for word in wanted)
    needed = [kind for word, kind in KINDS if re.search(word, clause)]
    types = re.sub(r"(?<!const )\bvoid\s*\*\s*\w+", "", function.types)  # a pointer of the program's own may be null
    return not needed or any(re.search(kind, types) for kind in needed)


OBJECTS = KINDS[:11]


def narrowed(clause, function):
    """A clause like "a space or geom that is 0" with those objects alone that the function takes."""
    listed = re.match(r"(?:an? )?(\w+(?:, (?:an? )?\w+)*(?:,? or (?:an? )?\w+)?) (that (?:is|are) .*)", clause, re.S)
    if not listed or clause.startswith("["):
        return clause
    words = re.split(r",? or (?:an? )?|, (?:an? )?", listed[1])
    kinds = {word: kind for word in words for name, kind in OBJECTS if re.fullmatch(name, word)}
    if len(kinds) < len(words):
        return clause
    taken = [word for word in words if re.search(kinds[word], function.types)]
    if not taken:
        return clause
    many = ("data", "requirements", "resources")
    names = [word if word in many else f"{'an' if word[0] in 'aeiou' else 'a'} {word}" for word in taken]
    held_back = re.sub(r"^that (?:is|are)", "that are" if taken[-1] in many else "that is", listed[2])
    return ", ".join(names[:-1]) + (" or " if names[1:] else "") + names[-1] + " " + held_back


def clauses(refused):
    """The clauses of a "Refused:", and what follows from a refusal."""
    head, dot, tail = re.match(r"((?:[^.(]|\([^)]*\)|\.(?!\s|$))*)(\.?)\s*(.*)", refused, re.S).groups()
    return [clause.strip() for clause in re.split(r";(?![^(]*\))", head) if clause.strip()], tail.strip()


ALLOWS_NULL = r"\bNULL\b|\b0: none\b|(?<!Neither pointer )\bmay be (?:0|null)\b|pointer is skipped"


def held(function, chapter, chapters_of, text=""):
    """The clauses of its chapter that can hold for a function, those of another chapter where it says "as for"."""
    result = []
    for clause in clauses(chapter.refused)[0]:
        other = re.match(r"as for (\w+)$", clause)
        for one in clauses(chapters_of[other[1]].refused)[0] if other else [clause]:
            says_so = re.match(r"(?:a )?null pointer", one) and re.search(ALLOWS_NULL, text)
            if applies(one, function) and not says_so and not re.match(r"(?:what|as|the rest as) each function", one):
                result.append(narrowed(one, function))
    return result


def consequence(function, chapter, chapters_of):
    """What follows from a refusal: of what answers nothing, nothing about answers."""
    tail = clauses(chapter.refused)[1]
    other = re.match(r"as for (\w+)", chapter.refused)
    if not tail and other:
        tail = clauses(chapters_of[other[1]].refused)[1]
    if function.answers:
        return tail.replace("getters answer 0", "the answer is 0")
    tail = re.sub(r"(?:,? and|;)? ?(?:getters answer|the answer is|[Tt]he answer is then) 0(?: then)?", "", tail)
    return "" if tail.strip() == "." else tail


def refusals(function, chapter, chapters_of, text=""):
    """What a function refuses, in words."""
    result = [untagged(clause) for clause in held(function, chapter, chapters_of, text)]
    if not result:
        return ""
    said, tail = "; ".join(result), consequence(function, chapter, chapters_of)
    return said[0].upper() + said[1:] + "." + (" " + tail if tail else "")


def untagged(refused):
    """The words of a "Refused:" without the names of functions that its clauses belong to."""
    return re.sub(_TAG + r"\s*", "", refused)


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
        found.append(Function(match["name"], parameters(match["args"]), line_of(offset + match.start("name")),
                              match["args"], not re.search(r"\bvoid\s*$", head)))
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


def texts(folder):
    """{function: its entry in the manual} of all headers of a folder."""
    found = {}
    for path in sorted(glob.glob(os.path.join(folder, "*.h"))):
        with open(path, encoding="utf-8") as f:
            for run in runs(f.read()):
                for function in run.functions:
                    found.setdefault(function.name, run.text_of(function.name))
    return found
