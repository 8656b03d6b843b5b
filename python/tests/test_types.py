# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The package as a type checker sees it: stubs that are made from the headers, and the package's own annotations."""
import ast
import importlib.util
import re
import subprocess
import sys
from importlib import resources
from pathlib import Path

import pytest

from epode import c

HERE = Path(__file__).parent
needs_mypy = pytest.mark.skipif(importlib.util.find_spec("mypy") is None, reason="mypy is not installed")


def mypy(tmp_path, *arguments):
    return subprocess.run([sys.executable, "-m", "mypy", "--cache-dir", str(tmp_path), *arguments], capture_output=True, text=True,
                          cwd=tmp_path)


@needs_mypy
def test_package_and_recipes_pass_a_type_checker(tmp_path):
    recipes = sorted((HERE.parent / "recipes").glob("*.py"))
    result = mypy(tmp_path, "--strict", "-p", "epode")
    assert result.returncode == 0, result.stdout
    if recipes:
        result = mypy(tmp_path, "--strict", *map(str, recipes))
        assert result.returncode == 0, result.stdout


@needs_mypy
def test_a_type_checker_finds_wrong_use(tmp_path):
    wrong = tmp_path / "wrong.py"
    wrong.write_text("import epode\nfrom epode import c\nw = epode.World(gravity='down', weight=3)\nc.dWorldStep(w, '0.1')\n"
                     "w.body(mass=1).position + 'x'\nw.geoms[0].aabb = 3\n")
    result = mypy(tmp_path, str(wrong))
    assert result.stdout.count("error:") >= 4, result.stdout


# What stubtest says of every extension module by nanobind: its functions and classes are of types of their own. A Value that is
# only read may be set to Never, which stubtest takes for setting.
NATURE = re.compile(r"is not a function|metaclass differs|disjoint base|__init__ is inconsistent, stub does not have \*args|"
                    r"epode\._handle\.Value\.|(Body\.joint_count|epode\.(character\.Character|vehicle\.(Vehicle|Wheel))\.\w+) is read-only|epode\._c\.FloatArray |(FloatArray|epode\.world\.Contacts) is inconsistent, runtime is not a type|\[mypy\] section")


@needs_mypy
def test_stubs_are_what_there_is_at_run_time(tmp_path):
    """Every name, and whether it may be set."""
    empty = tmp_path / "mypy.ini"
    empty.write_text("[mypy]\n")
    result = subprocess.run([sys.executable, "-m", "mypy.stubtest", "epode", "--concise", "--mypy-config-file", str(empty)],
                            capture_output=True, text=True, cwd=tmp_path)
    said = (result.stdout + result.stderr).splitlines()
    assert len(said) > 100, said  # it has looked
    assert [line for line in said if not NATURE.search(line)] == []


def tree_of_types():
    return ast.parse(resources.files("epode").joinpath("_c.pyi").read_text())


def test_stubs_have_every_function_with_its_text():
    functions = {node.name: node for node in tree_of_types().body if isinstance(node, ast.FunctionDef)}
    for name, how in c.coverage().items():
        if not how.startswith("left out"):
            node = functions[name]
            assert node.returns is not None and all(a.annotation is not None for a in node.args.args), name
            assert ast.get_docstring(node), name
            assert getattr(c, name).__doc__.startswith(f"{name}("), name
    classes = {node.name for node in tree_of_types().body if isinstance(node, ast.ClassDef)}
    assert {n for n in dir(c) if n.startswith("d") and isinstance(getattr(c, n), type)} <= classes


def test_signatures_written_by_hand_are_those_of_the_binding():
    functions = {node.name: node for node in tree_of_types().body if isinstance(node, ast.FunctionDef)}
    source = "".join((HERE.parent / "src" / name).read_text() for name in ("written.cpp", "arrays.cpp", "assemblies.cpp", "callbacks.cpp"))
    for name, how in c.coverage().items():
        bound = re.search(rf'"{name}",((?:(?!m\.def).)*?)TEXT\({name}\)', source, re.S)
        if how == "written" and bound:  # the ways to build heights share one macro
            assert re.findall(r'"(\w+)"_a', bound[1]) == [a.arg for a in functions[name].args.args], name
