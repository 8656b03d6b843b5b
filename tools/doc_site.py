#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Puts the sources of the site together in build/site-src, from what is there: the Markdown of docs/, a page for each
chapter of the reference (from Doxygen's XML in build/site-xml, through breathe), and a gallery of the pictures in
out/gallery (replays go to build/site-extra). A mark <!-- live: scene=arch&friction=0.5 | What is seen. --> of a page becomes that scene of the
playground, running, where the playground has been built (wasm/playground/build); with "live in
its place:" it takes the place of the picture above it. Links to files that are no pages (sources, scripts) become plain text, since the site stands alone.

doc_site.py            writes build/site-src
doc_site.py --check    every public function of include/ode has its entry in the built pages of build/site"""
import argparse
import html
import pathlib
import re
import shutil
import sys
import xml.etree.ElementTree as ElementTree

import check_docs
import doc_python
import header_docs

ROOT = pathlib.Path(__file__).resolve().parent.parent
DOCS, SOURCE, XML, SITE = ROOT / "docs", ROOT / "build/site-src", ROOT / "build/site-xml/xml", ROOT / "build/site"
GALLERY, EXTRA = ROOT / "out/gallery", ROOT / "build/site-extra"
PLAYGROUND, SCENES = ROOT / "build/wasm/web/index.html", ROOT / "wasm/playground/src/scenes"
LIVE = re.compile(r"^(?:(?P<still>!\[[^\]]*\]\([^)\s]+\)\n\n)<!-- live in its place|<!-- live): (?P<link>[\w&=.-]+) \| (?P<words>.+) -->$", re.M)
# The first page of Doxygen's own manual; here docs/guide and the parts below stand for it.
LEFT_OUT = ("reference.md",)


def plain_links(text, page):
    """Markdown with links to what is not in the site turned into text."""
    def kept(match):
        target = match[2].split("#")[0]
        place = (page.parent / target).resolve()
        if not target or re.match(r"\w+:", target) or place.is_relative_to(DOCS) and place.suffix != ".py":  # notebooks are no pages
            return match[0]
        return match[1] if match[1].startswith("`") else f"`{match[1]}`"
    return re.sub(r"(?<!!)\[([^\]]+)\]\(([^)\s]+)\)", kept, text)


def check_live(link, page):
    """The scene of a mark and its sliders must be the playground's."""
    given = dict(part.split("=", 1) for part in link.split("&"))
    scene = SCENES / f"{given.pop('scene', '')}.mjs"
    text = scene.read_text(encoding="utf-8") if scene.exists() else ""
    unknown = [name for name in given if name != "stepper" and f"{name}: slider(" not in text]
    if not text or unknown:
        raise SystemExit(f"{page}: live: {link}: " + (f"no slider {', '.join(unknown)}" if text else "no such scene"))


def with_scenes(text, page):
    """Markdown with its live marks as frames that run the playground's scenes."""
    def frame(match):
        check_live(match["link"], page)
        if not PLAYGROUND.exists():
            return match["still"] or ""
        up = "../" * len(page.relative_to(DOCS).parent.parts)
        link, words = match["link"].replace("&", "&amp;"), html.escape(match["words"])
        return (f'<figure class="live"><iframe loading="lazy" title="{words}" src="{up}playground.html#embed=1&amp;{link}"></iframe>'
                f'<figcaption>{words} <a href="{up}playground.html#{link}">Whole page</a></figcaption></figure>')
    return LIVE.sub(frame, text)


def copy_pages():
    for page in sorted(DOCS.rglob("*.md")):
        if page.name in LEFT_OUT:
            continue
        place = SOURCE / page.relative_to(DOCS)
        place.parent.mkdir(parents=True, exist_ok=True)
        text = with_scenes(doc_python.with_recipes(page.read_text(encoding="utf-8")), page)
        place.write_text(plain_links(text, page), encoding="utf-8")
    for folder in DOCS.rglob("images"):
        shutil.copytree(folder, SOURCE / folder.relative_to(DOCS))
    shutil.copytree(DOCS / "site" / "_static", SOURCE / "_static")
    (SOURCE / "python" / "reference.md").write_text(doc_python.page(), encoding="utf-8")


def mend_xml():
    """Doxygen writes the type of a typedef of a function as `void()`, which breathe cannot put together again."""
    for file in XML.glob("*.xml"):
        text = file.read_text(encoding="utf-8")
        mended = text.replace("()</type>", "</type>")
        if mended != text:
            file.write_text(mended, encoding="utf-8")


def list_the_rest():
    """Pages that the first page does not list come last in its menu, so that a new one is never lost."""
    index = SOURCE / "index.md"
    text = index.read_text(encoding="utf-8")
    listed = set(re.findall(r"^[\w/-]+$", text, re.M))
    rest = [str(page.relative_to(SOURCE).with_suffix("")) for page in sorted(SOURCE.rglob("*.md"))]
    rest = [page for page in rest if page not in listed and page != "index"]
    if rest:
        text = re.sub(r"(:caption: More\n:hidden:\n)", lambda found: found[1] + "".join(f"{page}\n" for page in rest), text)
        index.write_text(text, encoding="utf-8")


def heading(title, mark):
    return f"{title}\n{mark * len(title)}\n\n"


def groups_of(compound):
    """Names and titles of the groups inside a part, in order."""
    tree = ElementTree.parse(XML / f"{compound}.xml").getroot().find("compounddef")
    inner = [(one.get("refid"), one.text) for one in tree.findall("innergroup")]
    return tree.findtext("title"), [(ref, title, ElementTree.parse(XML / f"{ref}.xml").getroot()
                                     .find("compounddef").findtext("compoundname")) for ref, title in inner]


def parts():
    """The parts of the manual in the order of docs/parts.dox."""
    names = re.findall(r"@defgroup (part_\w+)", (DOCS / "parts.dox").read_text(encoding="utf-8"))
    for name in names:
        yield name, *groups_of("group__" + name.replace("_", "__"))


def chapters_and_functions():
    """The chapters of the headers by name, and the names of all functions."""
    chapters, functions = {}, set()
    for path in check_docs.HEADERS:
        text = path.read_text(encoding="utf-8")
        chapters |= {chapter.name: chapter for chapter in header_docs.chapters(text)}
        if not path.name.startswith(check_docs.WITHOUT_FUNCTIONS):
            functions.update(function.name for run in header_docs.runs(text) for function in run.functions)
    return chapters, functions


def linked(text, functions):
    """A comment's text as reStructuredText: functions and chapters become links, other signs stand for themselves."""
    def piece(found):
        if found["chapter"]:
            return f"\\ :doc:`{found['words']} <{found['chapter']}>`\\ "
        if found["code"]:
            return f"\\ ``{found['code']}``\\ "
        if found["name"]:
            return f"\\ :cpp:func:`{found['name']}`\\ " if found["name"] in functions else found["name"]
        return "\\" + found["sign"]
    parts_of = r'@ref (?P<chapter>\w+) "(?P<words>[^"]+)"|`(?P<code>[^`]+)`|\b(?P<name>d[A-Z]\w*)|(?P<sign>[\\*`|_])'
    return re.sub(parts_of, piece, " ".join(text.split()))


def said_of(chapter, functions, titles):
    """What a chapter says of all its functions. (Breathe would part the list of arguments from its heading.)"""
    if not chapter:
        return ""
    said = "".join(linked(paragraph, functions) + "\n\n" for paragraph in chapter.text.split("\n\n"))
    refused = re.sub(r"as for (\w+)", lambda m: f'as for @ref {m[1]} "{titles[m[1]]}"', header_docs.untagged(chapter.refused))
    said += f"**Refused:** {linked(refused, functions)}\n\n" if refused else ""
    named = {}  # arguments that mean the same share a line
    for name, meaning in chapter.explained.items():
        named.setdefault(meaning, []).append(f"``{name}``")
    return said + "".join(f"- {', '.join(names)}: {linked(meaning, functions)}\n" for meaning, names in named.items()) + "\n"


def write_reference():
    chapters, functions = chapters_and_functions()
    folder = SOURCE / "reference"
    folder.mkdir(parents=True)
    index = heading("API reference", "=")
    index += ("Every public name, from the comments of the headers in ``include/ode``, by chapters. Programs include "
              "``<ode/ode.h>``; what is this library's alone is in ``<ode/ext.h>``. Under *Defined by* each function "
              "names where its meaning was fixed first.\n\nWhat holds everywhere: SI units if the program keeps to "
              "them; the world's frame, right-handed, unless a text says otherwise; vectors of 3 reals and one of "
              "padding, matrices by rows padded to 4 reals, quaternions (w, x, y, z); handles are opaque and 0 is "
              "\"none\"; ``dReal`` is double, or float in ``libode_single``. What is refused everywhere: "
              ":doc:`/errors`. What each number dParam... of a joint means, its unit, default, and which types take it: "
              ":doc:`/guide/joint_parameters`.\n\n")
    for name, title, groups in parts():
        index += f".. toctree::\n   :caption: {title}\n   :maxdepth: 1\n\n"
        for _, group_title, group in groups:
            index += f"   {group}\n"
            page = heading(group_title, "=") + said_of(chapters.get(group), functions, {name: one.title for name, one in chapters.items()})
            page += f".. doxygengroup:: {group}\n   :content-only:\n   :members:\n"
            (folder / f"{group}.rst").write_text(page, encoding="utf-8")
        index += "\n"
    index += ".. toctree::\n   :caption: C++ classes\n   :maxdepth: 1\n\n   classes\n"
    (folder / "classes.rst").write_text(classes_page(), encoding="utf-8")
    (folder / "index.rst").write_text(index, encoding="utf-8")


def classes_page():
    """The wrappers of odecpp: members call the C function of their name, so a list of the headers is what they need."""
    page = heading("C++ classes", "=")
    page += ("Each object of a class owns one object of the C interface and destroys it at its end; each member calls "
             "the C function of its name, so ``body.addForce(...)`` is ``dBodyAddForce(body, ...)``. They are in "
             "``ode/odecpp.h`` and ``ode/odecpp_collision.h``, included by ``<ode/ode.h>`` in C++; those with this "
             "library's additions are in ``ode/odecpp_ext.h``, shapes beyond ODE's in ``ode/odecpp_shapes.h``.\n\n"
             ".. list-table::\n   :header-rows: 1\n\n   * - class\n     - members\n")
    for file in sorted(XML.glob("classd*.xml")):
        tree = ElementTree.parse(file).getroot().find("compounddef")
        name = tree.findtext("compoundname")
        members = []
        for member in tree.iter("memberdef"):
            said = member.findtext("name")
            if member.get("kind") == "function" and member.get("prot") == "public" and said not in members:
                members.append(said)
        members = [m for m in members if not m.startswith(("operator", "~")) and m != name]
        if members:
            page += f"   * - ``{name}``\n     - {', '.join(f'``{m}``' for m in members)}\n"
    return page


def demo_words(name):
    """What the head of a demo says of it."""
    program = ROOT / "demos" / f"{name}.cpp"
    head = re.match(r"(?://[^\n]*\n)+", program.read_text(encoding="utf-8")) if program.exists() else None
    return " ".join(line[2:].strip() for line in head[0].splitlines()[3:]) if head else ""


def scene_words():
    """The scenes' descriptions by name."""
    texts = (file.read_text(encoding="utf-8") for file in sorted((ROOT / "scenes").rglob("*.cpp")))
    return dict(pair for text in texts for pair in re.findall(r'\.name = "([^"]+)",\s*\.description = "([^"]+)"', text))


def picture(file, words, more=""):
    place = pathlib.Path("gallery") / ("scenes" if file.parent.name == "scenes" else "demos") / file.name
    (SOURCE / place).parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(file, SOURCE / place)
    return f"### {file.stem}\n\n{words}{more}\n\n![{file.stem}]({place})\n\n"


def write_gallery():
    """Pictures and replays, as many as are there: scripts/docs --gallery makes them."""
    shutil.rmtree(EXTRA, ignore_errors=True)
    (EXTRA / "replays").mkdir(parents=True)
    if PLAYGROUND.exists():
        shutil.copy(PLAYGROUND, EXTRA / "playground.html")
    page = ("# Gallery\n\nPictures by the library's own renderer, without a screen; replays play in this browser. `demos/gallery`, "
            "`epode run SCENE --picture FILE` and `--html FILE` make them ([recordings](recording.md)).\n\n"
            "![A brick wall hit by a cannon ball](images/wall.png)\n\n")
    scenes = {name: GALLERY / "scenes" / f"{name}.png" for name in scene_words()}
    if any(file.exists() for file in scenes.values()):
        page += "## Scenes\n\n"
    for name, words in scene_words().items():
        replay = scenes[name].with_suffix(".html")
        if replay.exists():
            shutil.copy(replay, EXTRA / "replays" / replay.name)
        if scenes[name].exists():
            page += picture(scenes[name], words[0].upper() + words[1:] + ".",
                            f' <a href="replays/{replay.name}">Play it</a>.' if replay.exists() else "")
    demos = sorted(GALLERY.glob("*.png"))
    page += "## Demos\n\n" if demos else ""
    page += "".join(picture(file, demo_words(file.stem)) for file in demos)
    (SOURCE / "gallery.md").write_text(page, encoding="utf-8")


def check():
    """Names without an entry (an anchor of their own) in the built pages."""
    entries = set()
    for page in sorted((SITE / "reference").glob("*.html")):
        text = page.read_text(encoding="utf-8")
        entries.update(re.findall(r'<span class="sig-name descname"><span class="n"><span class="pre">(\w+)<', text))
    declared = chapters_and_functions()[1]
    missing = sorted(declared - entries)
    print("\n".join(f"no entry: {name}" for name in missing))
    print(f"{len(declared)} public functions, {len(declared) - len(missing)} have an entry in {SITE}")
    return bool(missing) or not declared


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--check", action="store_true")
    if parser.parse_args().check:
        return check()
    shutil.rmtree(SOURCE, ignore_errors=True)
    SOURCE.mkdir(parents=True)
    mend_xml()
    copy_pages()
    write_reference()
    write_gallery()
    list_the_rest()
    return 0


if __name__ == "__main__":
    sys.exit(main())
