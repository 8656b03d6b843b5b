#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The code speaks the field's language: words of the glossary's left column (CONTRIBUTING.md, "Language and names") are refused
everywhere in FOLDERS.

  check_words.py            faults; exit status 1 if there are any
  check_words.py --count    a table of all folders, by word
  check_words.py --list X   every place of the word, or of the folder, X
  check_words.py --root D   judges the tree D instead of this one (tests/docs/planted_words.sh)

A word is looked for in *names* (files and identifiers, cut at capitals and underscores: `dQueryThing` is query, thing) and in *text* (comments,
strings, documents). Common English such as "most" or "room" is looked for in names alone. Of include/ode, only what ends with [ours] is read.
Also judged: entries of public functions over eight lines, and commit subjects over 72 characters."""
import argparse
import bisect
import collections
import fnmatch
import pathlib
import re
import subprocess
import sys

import header_docs

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("src", "include", "record", "robots", "view", "viewer", "scenes", "cli", "bench", "tests", "docs", "python", "rust", "demos", "drawstuff",
           "scripts", "tools", "packaging", "cmake", "CMakeLists.txt", "README.md")
C_LIKE = {".c", ".h", ".cpp", ".inc", ".rs", ".js", ".mjs", ".css", ".html"}
HASH_LIKE = {".py", ".sh", ".txt", ".cmake", ".in", ""}

LEFT_OUT = ("tests/docs/planted_words.sh", "tools/check_words.py", "docs/notes/entries_compared.md",
            "rust/epode/LICENSE", "rust/epode-sys/LICENSE", "python/LICENSE",
            "rust/epode-sys/src/ode.rs", "rust/epode-sys/src/robots.rs",  # the headers' texts, those that are judged there and ODE's
            "packaging/debian/copyright")  # have such words on purpose, or quote a licence
MAX_ENTRY = 8
# Subjects after this commit keep to 72 characters.
SUBJECTS_AFTER = "bbac8e805f0feb477e6fcbbff972bed7d0f9b042"
MAX_SUBJECT = 72


class Word:
    """A word of the house: patterns of names (lower case, joined by underscores) and of text, and the folders that it is looked for in."""

    def __init__(self, word, names="", text="", only=""):
        self.word, self.only = word, only
        self.names = re.compile(rf"(?:^|_)(?:{names})(?:_|$)") if names else None
        self.text = text.replace(" ", r"\s+") if text else ""


WORDS = [
    Word("managed contacts", "managed", r"(?<!world-)managed contacts?|contacts that (?:the|a|its) world manages"),
    Word("patch", "patch|patches", r"patch(?:es)?"),
    Word("small steps", "small_steps?", r"small steps"),
    Word("push", "push(?:es)?$", ""),
    Word("careful set", "careful(?:_set)?", r"careful set"),
    Word("wide solve", "wide_solve", r"wide solves?"),
    Word("plan", "plans?", r"plan caches?|plans? of (?:the |a )?factors?"),
    Word("questions", "questions?", r"questions?"),
    Word("thing", "things?", ""),
    Word("member", "members?", "", "src/query src/collide bench"),
    Word("foresight", "foresight|foreseen", r"foresight|foreseen"),
    Word("parting", "parting|partings|parted", r"parting|pair parting"),
    Word("harvest", "harvest(?:s|ed)?", r"harvest(?:s|ed)?"),
    Word("underpart", "underparts?", r"underparts?"),
    Word("press", "press", "", "src"),
    Word("looks out", "looks_out", r"looks? out"),
    Word("heap", "heaps?", r"heaps?"),
    Word("room", "rooms?$", r"(?:has|have|had) (?:no )?room"),
    Word("most", "most$", ""),
    Word("wish", "wish(?:es|ed)?", r"wish(?:es|ed)?"),
    Word("told", "told|tells?|asks(?!_for)|hears?|heard", r"hears?|is told|are told"),
    Word("finished bodies", "finished_bod(?:y|ies)", r"finished bod(?:y|ies)"),
    Word("ways", "ways|way_past", r"expected ways?|ways? expected", "src include"),
    Word("ground", "ground|grounds", "", "src"),
    Word("stays, comes, goes", "stays|comes|coming|goes|going", "", "src"),
    Word("anew", "anew", r"anew"),
    Word("beside", "beside", r"beside"),
    Word("sort", "sort_of|sorts$", "", "src"),
    Word("meeting", "meetings?|making|makings", "", "src"),
    Word("shelf", "shelf|shelves", "", "src"),
    Word("levers", "levers?", "", "src"),
    Word("there, sure", "k_there|k_sure", "", "src"),
    Word("ties", "ties$", "", "src"),
    Word("hire, dismiss", "hire|hired|dismiss", "", "src"),
    Word("reckon", "reckon(?:ed|s)?", r"reckon(?:ed|s|ing)?"),
    Word("dear", "dear|dearer", r"dear(?:er|est)?"),
    Word("shall", "shall", r"shall"),
    Word("of no size", "", r"of no size|has it anyway|so it is"),
]

# (path, word, a pattern of the line or "", reason). Names of ODE's own functions are left out everywhere.
EXCEPTIONS = [
    ("*", "push", r"\.push\(|->push\(|push_back|[#_ ]pragma|push\(", "the operation of a list"),
    ("*", "heap", r"(?:push|pop|make)_heap|[Hh]eap (?:memory|block|alloc)|the heap\b", "memory, and the data structure"),
    ("tests/memory/*", "heap", "", "heap memory is what these tests are about"),
    ("src/bvh/*", "heap", "", "the data structure"),
    ("src/characters/*", "ground", "", "what a character stands on: the field's term"),
    ("src/state/world_state.*", "ground", r"visit_ground|dGeomID ground|from_handle<Geom>\(ground\)", "what a wheel or a character stands on"),
    ("src/vehicles/*", "ground", "", "what a wheel stands on: the field's term"),
    ("src/dynamics/forces/vehicle.*", "ground", "", "what a wheel stands on"),
    ("src/collide/character.*", "ground", "", "what a character stands on"),
    ("src/state/shift_origin.cpp", "ground", "", "what a wheel or a character stands on"),
    ("src/state/world_state.cpp", "ground", r"character|vehicle|visit_ground|grounds|wheel|ground = number|known = ground|\*ground", "what a character stands on"),
    ("src/step/*", "small steps", r"[Ff]ast1|StepFast", "the 0.039 guide's stepper"),
    ("cli/*", "plan", "", "the plan of a run: steps, stepper, threads"),
    ("demos/stage.*", "plan", "", "the plan of a demo: what it builds, does and claims"),
    ("python/epode/sweep/*", "plan", "", "the plan of a sweep: what is run, as in the design of experiments"),
    ("python/tests/test_sweep.py", "plan", "", "the plan of a sweep"),
    ("bench/sweep/*", "plan", "", "the plan of a sweep"),
    ("docs/notebooks/sweeps.py", "plan", "", "the plan of a sweep"),
    ("src/api/*", "member", r"->|\.", "members of a C structure"),
    ("bench/main.cpp", "member", r"CLI::IsMember", "CLI11's name"),
    ("docs/architecture.md", "room", "", "the rooms of the house: folders"),
    ("tools/check_layers.py", "room", "", "the rooms of the house: folders"),
    ("*", "dear", r"Dear ImGui", "the library's name"),
    ("src/simd/*", "most", "at_most", "the comparison of lanes"),
    ("src/solve/*", "most", "at_most", "the comparison of lanes, and of one number"),
    ("src/solve/substeps/substep_solver.h", "small steps", "Small Steps in Physics Simulation", "the title of a paper"),
    ("tests/cpp/guide/*", "thing", "", "programs of the 0.039 guide, quoted"),
    ("bench/engines*", "ground", "", "the ground of a scene"),
]


class Text:
    """A file cut into names and text, all offsets kept."""

    C = re.compile(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.[^'\n]*|[^'\\\n])'", re.S)
    HASH = re.compile(r"#[^\n]*|\"\"\".*?\"\"\"|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*'", re.S)
    FRAME = re.compile(r"(?m)^[ \t]*(?://+|/?\*+/?|#+)|//|/\*+<?|\*/")
    BLANK = re.compile(r"[^\n]")

    def __init__(self, path, content):
        self.lines = [-1] + [found.start() for found in re.finditer("\n", content)]
        self.content = content
        kind = self.C if path.suffix in C_LIKE else self.HASH if path.suffix in HASH_LIKE else None
        if kind is None:
            self.code, self.text = "", content
            return
        pieces, words, position = [], [], 0
        for found in kind.finditer(content):
            between = content[position:found.start()]
            pieces += [between, self.BLANK.sub(" ", found[0])]
            included = content[content.rfind("\n", 0, found.start()) + 1:found.start()].lstrip().startswith("#")
            words += [self.BLANK.sub(" ", between), self.BLANK.sub(" ", found[0]) if included else found[0]]
            position = found.end()
        self.code = "".join(pieces) + content[position:]
        self.text = self.FRAME.sub(lambda frame: " " * len(frame[0]), "".join(words))

    def line(self, offset):
        return bisect.bisect_left(self.lines, offset)

    def line_text(self, number):
        return self.content.split("\n", number)[number - 1]


def ours(content):
    """The parts of a header of ODE's that are additions; the rest blanked out."""
    keep = [(run.begin, run.end) for run in header_docs.runs(content) if "ours" in run.sources()]
    blank, position = [], 0
    for begin, end in keep:
        blank += [Text.BLANK.sub(" ", content[position:begin]), content[begin:end]]
        position = end
    return "".join(blank) + Text.BLANK.sub(" ", content[position:])


def folder_of(name):
    pieces = name.split("/")
    return "/".join(pieces[:2]) if pieces[0] in ("src", "tests", "include") and len(pieces) > 2 else pieces[0]


def subwords(identifier):
    cut = re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", identifier)
    return cut.lower().strip("_")


def concerns(word, name):
    return not word.only or any(name.startswith(only) for only in word.only.split())


class Judge:
    def __init__(self, root):
        self.root = root
        read = lambda name: (root / name).read_text() if (root / name).exists() else ""
        self.foreign = set(re.findall(r"\w+", read("tests/abi/debian_functions.txt") + read("tests/abi/guide_names.inc")))
        self.known = {}
        self.all_text = re.compile(r"\b(?:" + "|".join(f"(?P<w{i}>{w.text})" for i, w in enumerate(WORDS) if w.text) + r")\b", re.I)
        self.found = []  # (name, line, word, what stands there)

    def words_of(self, identifier):
        if identifier not in self.known:
            joined = subwords(identifier)
            self.known[identifier] = [] if identifier in self.foreign else [w for w in WORDS if w.names and w.names.search(joined)]
        return self.known[identifier]

    def note(self, name, number, word, what, line):
        if not concerns(word, name):
            return
        if any(fnmatch.fnmatch(name, glob) and key == word.word and re.search(pattern, line) for glob, key, pattern, _ in EXCEPTIONS):
            return
        self.found.append((name, number, word.word, what))

    def read(self, name):
        path = self.root / name
        for word in self.words_of(path.stem):
            self.note(name, 0, word, path.name, path.name)
        content = path.read_text(encoding="utf-8", errors="replace")
        text = Text(path, ours(content) if name.startswith("include/") else content)
        for found in re.finditer(r"[A-Za-z_]\w*", text.code):
            for word in self.words_of(found[0]):
                number = text.line(found.start())
                self.note(name, number, word, found[0], text.line_text(number))
        for found in self.all_text.finditer(text.text):
            number = text.line(found.start())
            self.note(name, number, WORDS[int(found.lastgroup[1:])], " ".join(found[0].split()), text.line_text(number))


def files(root):
    listed = subprocess.run(["git", "-C", root, "ls-files", *FOLDERS], capture_output=True, text=True).stdout.split()
    listed = listed or [str(p.relative_to(root)) for f in FOLDERS for p in (root / f).rglob("*") if p.is_file()]
    suffixes = C_LIKE | HASH_LIKE | {".md"}
    return [name for name in sorted(listed) if pathlib.Path(name).suffix in suffixes and name not in LEFT_OUT and (root / name).is_file()]


def long_entries(root):
    """(header, line, function, lines) of each entry that is too long: its own text and what is common."""
    for path in sorted((root / "include").glob("*/*.h")):
        for run in header_docs.runs(path.read_text(encoding="utf-8")):
            for function in run.functions:
                lines = len([line for line in run.text_of(function.name).splitlines() if line.strip()])
                if lines > MAX_ENTRY:
                    yield str(path.relative_to(root)), function.line, function.name, lines


def long_subjects(root, after):
    log = subprocess.run(["git", "-C", root, "log", "--no-merges", "--format=%h %s", f"{after}..HEAD"], capture_output=True, text=True)
    for line in log.stdout.splitlines():  # without history there is nothing to judge
        commit, _, subject = line.partition(" ")
        if len(subject) > MAX_SUBJECT:
            yield f"{commit}: the subject has {len(subject)} characters, at most {MAX_SUBJECT} are read in a log: {subject}"


def glossary_gaps(root):
    page = (root / "CONTRIBUTING.md").read_text() if (root / "CONTRIBUTING.md").exists() else ""
    left = "\n".join(line.split("|")[1] for line in page.splitlines() if line.startswith("| "))
    for word in WORDS:
        if word.word not in left:
            yield f"CONTRIBUTING.md: the glossary lacks '{word.word}', which check_words.py refuses"


def print_counts(found, entries):
    by_folder = collections.defaultdict(collections.Counter)
    for name, _, word, _ in found:
        by_folder[folder_of(name)][word] += 1
    for folder, counts in sorted(by_folder.items()):
        print(f"{folder:20}{sum(counts.values()):6}  " + ", ".join(f"{word} {n}" for word, n in counts.most_common()))
    totals = collections.Counter(word for _, _, word, _ in found)
    print(f"{'all':20}{len(found):6}  " + ", ".join(f"{word} {n}" for word, n in totals.most_common()))
    headers = collections.Counter(header for header, *_ in entries)
    print(f"entries over {MAX_ENTRY} lines: {len(entries)}: " + ", ".join(f"{header} {n}" for header, n in headers.most_common()))


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--count", action="store_true")
    arguments.add_argument("--list", metavar="X")
    arguments.add_argument("--root", type=pathlib.Path, default=ROOT)
    arguments.add_argument("--after", metavar="COMMIT", default=SUBJECTS_AFTER, help="judge subjects after this commit")
    options = arguments.parse_args()
    judge = Judge(options.root)
    judged = 0
    for judged, name in enumerate(files(options.root), 1):
        judge.read(name)
    entries = list(long_entries(options.root))
    if options.list:
        for name, number, word, what in judge.found:
            if options.list in (word, folder_of(name)):
                print(f"{name}:{number}: {what} ({word})")
        return 0
    if options.count:
        print_counts(judge.found, entries)
        return 0
    faults = [f"{name}:{number}: {what}: a word of the house ({word}); CONTRIBUTING.md's glossary has the field's"
              for name, number, word, what in judge.found]
    faults += [f"{header}:{line}: {function}: its entry has {lines} lines; at most {MAX_ENTRY}, the rest belongs in the guide"
               for header, line, function, lines in entries]
    faults += list(long_subjects(options.root, options.after)) + list(glossary_gaps(options.root))
    print("\n".join(faults) if faults else f"words: ok ({judged} files)")
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main())
