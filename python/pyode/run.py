# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Runs PyODE's tests and tutorials in the folder of its source, which scripts/test-pyode has prepared. The tutorials draw with
pygame and OpenGL: here these are stand-ins that draw nothing and end the program after some frames."""
import io
import os
import random
import re
import runpy
import sys
import time
import types
import unittest
from contextlib import redirect_stdout

sys.path.insert(0, os.getcwd())
FRAMES = 1200


class Nothing(types.ModuleType):
    """A module, function or object whose every attribute and result is nothing, too."""

    __all__: list = []

    def __init__(self, name="nothing"):
        super().__init__(name)
        self.__path__ = []

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return Nothing(name)

    def __call__(self, *_, **__):
        return Nothing()

    def __setitem__(self, key, value):
        pass

    def __or__(self, _):
        return self

    __ror__ = __mul__ = __rmul__ = __or__


class Glut:
    """Calls what the program would call between two pictures."""

    def __init__(self):
        self.idle = None

    def loop(self):
        for _ in range(FRAMES):
            self.idle()


def stand_ins():
    glut = Glut()
    names = {"OpenGL": Nothing()}
    for name in ("OpenGL.GL", "OpenGL.GLU", "OpenGL.GLUT", "cgtypes"):
        module = names[name] = Nothing(name)
        module.__all__ = sorted(drawing_names())
        for one in module.__all__:
            setattr(module, one, Nothing(one))
    names["OpenGL.GLUT"].glutIdleFunc = lambda f: setattr(glut, "idle", f)
    names["OpenGL.GLUT"].glutMainLoop = glut.loop
    pygame, frames = Nothing("pygame"), iter(range(FRAMES))
    pygame.init = lambda: (1, 0)
    pygame.QUIT, pygame.KEYDOWN, pygame.KEYUP, pygame.MOUSEBUTTONDOWN, pygame.K_w, pygame.K_a = range(6)
    pygame.event = Nothing("event")

    def events():
        frame = next(frames, None)
        keys = {10: pygame.K_w, 400: pygame.K_a}  # drive, then turn
        if frame is None:
            return [types.SimpleNamespace(type=pygame.QUIT)]
        return [types.SimpleNamespace(type=pygame.KEYDOWN, key=keys[frame])] if frame in keys else []
    pygame.event.get = events
    pygame.mouse = Nothing("mouse")
    pygame.mouse.get_pos = lambda: (0, 0)
    names["pygame"], names["pygame.locals"] = pygame, Nothing("locals")
    names["pygame.locals"].__all__ = ["QUIT", "KEYDOWN"]
    names["pygame.locals"].QUIT, names["pygame.locals"].KEYDOWN = pygame.QUIT, pygame.KEYDOWN
    return names


def drawing_names():
    """The names of OpenGL and cgtypes that the tutorials use."""
    found = {"mat4", "vec3", "quat"}
    for file in os.listdir("examples"):
        if file.endswith(".py"):
            with open(os.path.join("examples", file), encoding="utf-8") as f:
                found.update(re.findall(r"\b(?:gl|GL)\w+", f.read()))
    return found


def tutorial(name):
    def run(self):
        random.seed(3)
        self.enterContext(redirect_stdout(io.StringIO()))
        sys.modules.update(stand_ins())
        sys.path.insert(0, "examples")
        self.addCleanup(sys.path.remove, "examples")
        runpy.run_path(os.path.join("examples", name), run_name="__main__")
    return run


class Tutorials(unittest.TestCase):
    """Each runs to its end."""


for file in sorted(os.listdir("examples")):
    if file.endswith(".py"):
        setattr(Tutorials, f"test_{file[:-3]}", tutorial(file))


if __name__ == "__main__":
    time.sleep = lambda _: None
    loader = unittest.TestLoader()
    suite = unittest.TestSuite([loader.discover("tests"), loader.loadTestsFromTestCase(Tutorials)])
    result = unittest.TextTestRunner().run(suite)
    bad = len(result.failures) + len(result.errors)
    print(f"pyode: {result.testsRun - bad - len(result.skipped)} passed, {bad} failed, {len(result.skipped)} skipped")
    sys.exit(bad > 0)
