# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The reference of the Python package for the site, from its sources: every public class, method, property and function with its
signature and docstring. The functions of epode.c are those of the C reference; their signatures are in the package's stub."""
import ast
import pathlib
import re

PACKAGE = pathlib.Path(__file__).resolve().parent.parent / "python" / "epode"
RECIPES = PACKAGE.parent / "recipes"
# Module: its part of the page. Names that epode/__init__.py lists are shown as epode.NAME.
MODULES = {"world": "Worlds", "body": "Bodies", "geom": "Geoms", "shapes": "Shapes and materials", "joint": "Joints and drives",
           "character": "Characters", "vehicle": "Vehicles", "fluid": "Fluids", "ragdoll": "Ragdolls", "rope": "Ropes and bridges",
           "fracture": "Fracture", "recording": "Recordings", "viewer": "Windows: epode.viewer", "plot": "Plots: epode.plot",
           "robot": "Robots: epode.robot", "description/_description": "Robots that can be edited: epode.description",
           "description/_starts": "Their start poses", "description/_part": "What their parts share", "description/_links": "Their links and joints",
           "description/_geoms": "Their shapes", "description/_acting": "What acts on them", "description/_tree": "Their elements of MJCF",
           "description/_values": "Their lists of parts", "batch": "Batches of robots", "vector/environment": "Environments: epode.vector",
           "vector/task": "Tasks: epode.vector", "sweep/plan": "Plans of sweeps: epode.sweep", "sweep/sweep": "Sweeps: epode.sweep",
           "enums": "Kinds", "errors": "Errors"}
# A module's classes that have files of their own.
DATA = {"robot": ("_robot_data", "_robots")}


def is_public(name):
    return not name.startswith("_")


def signature(function, skip_self):
    arguments = ast.unparse(function.args)
    if skip_self:
        arguments = re.sub(r"^(self|cls)(, )?", "", arguments)
    returned = f" -> {ast.unparse(function.returns)}" if function.returns else ""
    return f"{function.name}({arguments}){returned}"


def entry(title, text):
    said = "\n".join(line.strip() for line in (text or "").strip().splitlines())
    return f"`{title}`\n: {said.replace(chr(10), chr(10) + '  ') or '-'}\n\n"


# Functions that make a property from its name alone: its text.
MAKERS = {"_column": lambda name: f"The {name.replace('_', ' ')} of each body, as an array.",
          "_place": lambda name: ("A point" if name.startswith("anchor") else "A direction") +
                                 " of the joint, in the world's frame, if its type has it."}


def text_of_call(call):
    """The last string among the arguments, which is a property's text."""
    texts = [a.value for a in [*call.args, *(k.value for k in call.keywords)] if isinstance(a, ast.Constant) and isinstance(a.value, str)]
    maker = MAKERS.get(getattr(call.func, "id", None))
    return maker(texts[-1]) if texts and maker else texts[-1] if texts else None


def documented_values(node):
    """NAME = something(..., "text") in a class, or several of them: properties."""
    if isinstance(node, ast.AnnAssign):
        pairs = [(node.target, node.value)]
    elif isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Tuple) and isinstance(node.value, ast.Tuple):
        pairs = list(zip(node.targets[0].elts, node.value.elts))
    else:
        pairs = [(node.targets[0], node.value)] if isinstance(node, ast.Assign) else []
    for target, value in pairs:
        if isinstance(target, ast.Name) and is_public(target.id) and isinstance(value, ast.Call) and (text := text_of_call(value)):
            yield target.id, text


def members(cls):
    """(title, text) of each member, setters left out."""
    for node in cls.body:
        if isinstance(node, ast.FunctionDef) and (is_public(node.name) or node.name == "__init__" and ast.get_docstring(node)):
            marks = [ast.unparse(d) for d in node.decorator_list]
            if any(m.endswith((".setter", "overload")) for m in marks):
                continue
            returned = f": {ast.unparse(node.returns)}" if node.returns else ""
            yield (node.name + returned if "property" in marks else signature(node, "staticmethod" not in marks)), ast.get_docstring(node)
        elif found := list(documented_values(node)):
            yield from found
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name) and is_public(node.target.id):
            yield ast.unparse(node), ""
        elif isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name) and isinstance(node.value, ast.Attribute):
            yield node.targets[0].id, f"``{ast.unparse(node.value)}``"


def tree_of(name):
    return ast.parse((PACKAGE / f"{name}.py").read_text(encoding="utf-8"))


def module_part(name, title):
    tree = tree_of(name)
    exported = re.findall(r'"(\w+)"', re.search(r"__all__ = \[(.*?)\]", (PACKAGE / "__init__.py").read_text(encoding="utf-8"), re.S)[1])
    part = f"## {title}\n\n{ast.get_docstring(tree)}\n\n"
    for node in [*(node for file in DATA.get(name, ()) for node in tree_of(file).body), *tree.body]:
        prefix = "epode." if getattr(node, "name", None) in exported and "description" not in name else f"epode.{name.split('/')[0]}."
        if isinstance(node, ast.ClassDef) and is_public(node.name):
            bases = f"({', '.join(ast.unparse(b) for b in node.bases)})" if node.bases else ""
            part += f"### {prefix}{node.name}{bases}\n\n{ast.get_docstring(node) or ''}\n\n"
            part += "".join(entry(*member) for member in members(node))
        elif isinstance(node, ast.FunctionDef) and is_public(node.name):
            part += entry(prefix + signature(node, False), ast.get_docstring(node))
    return part


def page():
    """The page python/reference.md."""
    text = ("# The Python package\n\nMade from the package's sources, which have the same texts as `help()`. `epode.c` has "
            "[every C function](../reference/index.rst) by its name: handles are objects, and what a function writes through a pointer is what "
            "it returns; `help(epode.c.dWorldStep)` shows its signature in Python. `epode.ode` has PyODE's names.\n\n")
    text += "".join(module_part(name, title) for name, title in MODULES.items() if (PACKAGE / f"{name}.py").exists())
    return re.sub(r"``([^`]+)``", r"`\1`", text)


def with_recipes(text):
    """A page with the program of each recipe after the line that links to it."""
    def shown(match):
        code = (RECIPES / match[1]).read_text(encoding="utf-8")
        return f"{match[0]}\n\n```python\n{code.split(chr(10), 2)[2]}```\n"
    return re.sub(r"^.*\]\(\.\./\.\./python/recipes/(\w+\.py)\).*$", shown, text, flags=re.M)
