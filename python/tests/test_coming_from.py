# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The pages "Coming from ...": programs side by side, theirs and ours. A section of a page (###) has a block of theirs, after a line that
begins with their name, one of ours, after a line that begins with Epode, and says to what the printed numbers agree. A block after a
line that ends in `NAME`: is that file. Ours is always run, theirs where they are installed; each prints what its comments say, and the
two columns of comments agree as the page says."""
import contextlib
import importlib.util
import io
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import pytest

import epode

HERE = Path(__file__).parent
GUIDE = Path(__file__).parent.parent.parent / "docs" / "guide"
THEIRS = {"from_mujoco": ("MuJoCo", "mujoco"), "from_pybullet": ("PyBullet", "pybullet"), "from_gazebo": ("Gazebo", None)}
BLOCK = re.compile(r"^([^\n]+)\n+```(\w+)\n(.*?)^```$", re.S | re.M)
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


class Program(NamedTuple):
    page: str
    title: str
    theirs: str | None
    ours: str
    agree: float | None


def sections(page):
    text = (GUIDE / f"{page}.md").read_text(encoding="utf-8")
    for part in re.split(r"^### ", text, flags=re.M)[1:]:
        title, _, body = part.partition("\n")
        yield title, re.split(r"^## ", body, flags=re.M)[0]


def files(page):
    """The files that the page shows, by name."""
    text = (GUIDE / f"{page}.md").read_text(encoding="utf-8")
    return {found[1]: block for line, _, block in BLOCK.findall(text) if (found := re.search(r"`([\w.]+)`:$", line))}


def programs():
    for page, (name, _) in THEIRS.items():
        for title, body in sections(page):
            blocks = [(line, code) for line, language, code in BLOCK.findall(body) if language == "python"]
            theirs = [code for line, code in blocks if line.startswith(name)]
            ours = [code for line, code in blocks if line.startswith("Epode")]
            agree = re.search(r"agree to ([\d.e-]+\d)", body)
            assert len(ours) == 1 and len(theirs) <= 1, (page, title)
            yield Program(page, title, theirs[0] if theirs else None, ours[0], float(agree[1]) if agree else None)


PROGRAMS = list(programs())


def printed(code):
    return " ".join(re.findall(r"# prints: (.*)$", code, re.M)).split()


def put_files(page, folder):
    """The page's files, and what the command makes of those that wheels do not read."""
    for name, text in files(page).items():
        (folder / name).write_text(text, encoding="utf-8")
    if (HERE / page).is_dir():
        shutil.copytree(HERE / page, folder, dirs_exist_ok=True)


def run(program, code, folder):
    """What a program of ours prints, run in a folder that has the page's files."""
    put_files(program.page, folder)
    out = io.StringIO()
    with contextlib.chdir(folder), contextlib.redirect_stdout(out):
        try:
            exec(compile(code, f"{program.page}: {program.title}", "exec"), {"__name__": "__main__"})
        except (RuntimeError, OSError) as error:
            if any(word in str(error) for word in ("build", "EGL", "page")):
                pytest.skip(str(error))  # pictures and pages that this build does not make
            raise
    return out.getvalue().split()


def run_apart(program, code, folder):
    """What a program of theirs prints, run in a process of its own: their numbers of clients and ways to draw are the process's."""
    put_files(program.page, folder)
    done = subprocess.run([sys.executable, "-c", code], cwd=folder, capture_output=True, text=True, env={**os.environ, "MUJOCO_GL": "egl"})
    if "Renderer(" in code and done.returncode != 0:
        pytest.skip("MuJoCo finds no OpenGL here")
    assert done.returncode == 0, done.stderr
    return done.stdout.split()


def names(program):
    return f"{program.page}: {program.title}"


@pytest.mark.parametrize("page", THEIRS)
def test_what_a_page_begins_with_runs(page, tmp_path):
    text = (GUIDE / f"{page}.md").read_text(encoding="utf-8").split("\n## ")[0]
    blocks = re.findall(r"^```python\n(.*?)^```", text, re.S | re.M)
    assert len(blocks) == 1 and len(run(Program(page, "the beginning", None, blocks[0], None), blocks[0], tmp_path)) >= 2


@pytest.mark.parametrize("program", PROGRAMS, ids=names)
def test_our_program_prints_what_the_page_says(program, tmp_path):
    assert printed(program.ours) and run(program, program.ours, tmp_path) == printed(program.ours)


@pytest.mark.parametrize("program", [one for one in PROGRAMS if one.theirs and THEIRS[one.page][1]], ids=names)
def test_their_program_prints_what_the_page_says(program, tmp_path):
    module = THEIRS[program.page][1]
    if importlib.util.find_spec(module) is None:
        pytest.skip(f"{module} is not installed")
    assert printed(program.theirs) and run_apart(program, program.theirs, tmp_path) == printed(program.theirs)


@pytest.mark.parametrize("program", [one for one in PROGRAMS if one.theirs and THEIRS[one.page][1]], ids=names)
def test_numbers_agree_as_the_page_says(program):
    mine, others = ([float(n) for n in NUMBER.findall(" ".join(printed(code)))] for code in (program.ours, program.theirs))
    words, other_words = (NUMBER.sub("", " ".join(printed(code))).split() for code in (program.ours, program.theirs))
    assert program.agree is not None and mine == pytest.approx(others, abs=program.agree) and words == other_words


def command():
    """The command of a build that reads SDF: CI's, or None."""
    for path in (os.environ.get("EPODE_COMMAND"), GUIDE.parent.parent / "build" / "release" / "bin" / "epode"):
        if path and Path(path).exists():
            return str(path)
    return None


def test_commands_of_the_page_run_and_convert_to_the_file_of_these_tests(tmp_path):
    epode_command, page = command(), "from_gazebo"
    if epode_command is None:
        pytest.skip("no command is built here")
    put_files(page, tmp_path)
    (tmp_path / "lab.xml").unlink()
    text = (GUIDE / f"{page}.md").read_text(encoding="utf-8")
    lines = [shlex.split(line, comments=True) for block in re.findall(r"^```sh\n(.*?)^```$", text, re.S | re.M)
             for line in block.splitlines() if line.startswith("epode ")]
    assert len(lines) >= 6
    for words in lines:
        done = subprocess.run([epode_command, *words[1:]], cwd=tmp_path, capture_output=True, text=True)
        if "does not read SDF" in done.stderr + done.stdout:
            pytest.skip("the command does not read SDF")
        assert done.returncode == 0, (words, done.stdout, done.stderr)
    assert (tmp_path / "lab.xml").read_text() == (HERE / page / "lab.xml").read_text()


@pytest.mark.parametrize("page", THEIRS)
def test_a_page_has_ten_programs_a_table_and_what_is_missing(page):
    text = (GUIDE / f"{page}.md").read_text(encoding="utf-8")
    assert sum(one.page == page for one in PROGRAMS) >= 10
    assert len(re.findall(r"^\| `", text, re.M)) >= 20 and "\n## What we have not" in text
    assert f"`{page}.md`" not in text and f"({page}.md)" in (GUIDE / "migrate.md").read_text(encoding="utf-8") and epode.__name__ in text
