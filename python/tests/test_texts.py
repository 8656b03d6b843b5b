# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Every sample runs: docstrings of all modules, and the Python blocks of the pages; every public name has a text, and an entry
in the reference."""
import doctest
import importlib
import inspect
import pkgutil
import re
import sys
from pathlib import Path

import pytest

import epode

ROOT = Path(__file__).parent.parent.parent
PAGES = [ROOT / "docs/python/index.md", ROOT / "docs/guide/robots.md", ROOT / "docs/guide/howto/ragdolls.md", ROOT / "python/README.md", ROOT / "README.md"]
MODULES = ["epode"] + [f"epode.{m.name}" for m in pkgutil.iter_modules(epode.__path__) if not m.name.startswith("_")]


@pytest.mark.parametrize("name", MODULES)
def test_samples_of_docstrings_run(name):
    if name == "epode.plot":
        pytest.importorskip("matplotlib")
    assert doctest.testmod(importlib.import_module(name)).failed == 0


def blocks():
    for page in PAGES:
        if page.exists():
            for number, code in enumerate(re.findall(r"^```python\n(.*?)^```", page.read_text(), re.S | re.M)):
                yield pytest.param(code, id=f"{page.parent.name}/{page.name}:{number}")


@pytest.mark.parametrize("code", list(blocks()))
def test_samples_of_pages_run_and_print_what_they_say(code, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(ROOT if "demos/" in code else tmp_path)
    try:
        exec(compile(code, "sample", "exec"), {"__name__": "__main__"})
    except RuntimeError as error:
        if "build" in str(error) or "EGL" in str(error):
            pytest.skip(str(error))
        raise
    except OSError as error:
        if "page" in str(error):
            pytest.skip(str(error))
        raise
    expected = [line.strip() for line in re.findall(r"# prints: (.*)$", code, re.M)]
    assert not expected or capsys.readouterr().out.splitlines() == expected


def public_names():
    """(name in the reference, object) of what a program may use."""
    for module in map(importlib.import_module, MODULES):
        if module.__name__ in ("epode.c", "epode.ode"):
            continue
        for name, one in vars(module).items():
            if not name.startswith("_") and (inspect.isclass(one) or inspect.isfunction(one)) and (
                    one.__module__ == module.__name__ or one.__module__.startswith("epode.description._") and name in getattr(module, "__all__", ())):
                yield module, name, one


def test_every_public_name_has_a_text():
    for module, name, one in public_names():
        assert inspect.getdoc(one), f"{module.__name__}.{name}"
        if inspect.isclass(one):
            for member, what in vars(one).items():
                if not member.startswith("_") and (inspect.isfunction(what) or isinstance(what, property)):
                    assert inspect.getdoc(what), f"{module.__name__}.{name}.{member}"


def test_every_public_name_has_an_entry_in_the_reference():
    sys.path.insert(0, str(ROOT / "tools"))
    import doc_python
    page = doc_python.page()
    for module, name, one in public_names():
        short = module.__name__.removeprefix("epode.")
        wanted = f"epode.{name}" if name in epode.__all__ and getattr(epode, name) is one else f"epode.{short}.{name}"
        at = re.search(rf"^(### |`){re.escape(wanted)}\b", page, re.M)
        assert at, wanted
        if inspect.isclass(one):
            part = page[at.end():].split("\n### ", 1)[0]
            for member, what in vars(one).items():
                if not member.startswith("_") and (inspect.isfunction(what) or isinstance(what, (property, classmethod))):
                    assert re.search(rf"^`{member}\b", part, re.M), f"{wanted}.{member}"
