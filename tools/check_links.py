#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Checks the links of every Markdown file of the tree: a linked file exists, and a linked heading is in it. Links to other
sites are not followed, and neither are links into the generated reference (reference/NAME.rst), whose chapters must exist.
A file that is named in `code`, such as `step/common/undo` or `bench/charts`, exists too, with any ending; so documents follow when
files are renamed. Notes of the past (docs/notes) may name what is gone.

check_links.py [FILE...]    exit code 1 if a link is broken"""
import pathlib
import re
import shutil
import subprocess
import sys

import check_docs
import header_docs

ROOT = pathlib.Path(__file__).resolve().parent.parent
INLINE = re.compile(r"\[(?:[^\[\]]|\[[^\]]*\])*\]\(([^)\s]+)(?:\s+\"[^\"]*\")?\)")
NAMED = re.compile(r"^\[[^\]]+\]:\s*(\S+)", re.M)
FOLDERS = {one.name for one in [*ROOT.iterdir(), *(ROOT / "src").iterdir()] if one.is_dir()} - {"build", "out", "node_modules"}
EXAMPLES = {"src/joints/types/rope.cpp"}  # of a recipe: what a reader adds
PLACE = re.compile(r"`([\w.-]+(?:/[\w.-]+)+)(?: [^`]*)?`")
CODE = re.compile(r"^```.*?^```$|`[^`\n]+`", re.S | re.M)


def anchors(text):
    """The names that GitHub and Sphinx give to headings: lower case, spaces as hyphens, other signs left out."""
    found = set()
    for title in re.findall(r"^#{1,6}\s+(.*?)\s*$", re.sub(r"^```.*?^```$", "", text, flags=re.S | re.M), re.M):
        title = re.sub(r"\[([^\]]+)\]\([^)]*\)", r"\1", title)
        base = re.sub(r"[^\w\- ]", "", title.replace("`", "").lower()).replace(" ", "-")
        name, count = base, 0
        while name in found:
            count += 1
            name = f"{base}-{count}"
        found.add(name)
    return found


def chapters():
    texts = (path.read_text(encoding="utf-8") for path in check_docs.HEADERS)
    return {chapter.name for text in texts for chapter in header_docs.chapters(text)} | {"index", "classes"}


def broken(page, known_chapters):
    """What is wrong with each broken link of the page."""
    text = page.read_text(encoding="utf-8")
    prose = CODE.sub("", text)
    for target in INLINE.findall(prose) + NAMED.findall(prose):
        place, _, heading = target.partition("#")
        if re.match(r"\w+:", target):
            continue
        file = (page.parent / place).resolve() if place else page
        if file.parent == ROOT / "docs/reference" and file.suffix == ".rst":
            if file.stem not in known_chapters:
                yield f"{target}: no chapter of that name in include/"
        elif not file.exists():
            yield f"{target}: no such file"
        elif heading and file.suffix == ".md" and heading not in anchors(file.read_text(encoding="utf-8")):
            yield f"{target}: no such heading"


def is_there(place, folder):
    bases = (ROOT, ROOT / "src", ROOT / "include", folder)
    return any(next(base.glob(place + ending), None) for base in bases for ending in ("", ".*"))


def missing_files(page):
    """Files named in code that do not exist. Blocks of code are left out: they may name a reader's files."""
    text = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.S | re.M)
    for place in sorted(set(PLACE.findall(text))):
        folders = place.split("/")
        if folders[0] in FOLDERS and place not in EXAMPLES and not is_there(place, page.parent):
            yield f"`{place}`: no such file"


def broken_in(page, known):
    yield from broken(page, known)
    if not page.is_relative_to(ROOT / "docs/notes"):
        yield from missing_files(page)


def pages():
    """The Markdown files that git knows or does not ignore; where there is no git, those of docs and the top."""
    if shutil.which("git"):
        listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "*.md"], cwd=ROOT, capture_output=True, text=True)
        if listed.stdout:
            # Templates are pages only when scripts/new-joint and scripts/new-geom have filled them in.
            return [ROOT / name for name in listed.stdout.split()
                    if (ROOT / name).exists() and not name.startswith("tools/templates/")]
    return sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")])


def main():
    known = chapters()
    files = [pathlib.Path(one).resolve() for one in sys.argv[1:]] or pages()
    faults = [f"{page.relative_to(ROOT) if page.is_relative_to(ROOT) else page}: {fault}" for page in files for fault in broken_in(page, known)]
    print("\n".join(faults))
    print(f"{len(files)} pages, {len(faults)} broken links or missing files")
    return bool(faults) or not files


if __name__ == "__main__":
    sys.exit(main())
