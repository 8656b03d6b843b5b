# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The window: under an X server without a screen, in a process of its own, where there is one; else what needs none."""
import importlib.util
import json
import math
import shutil
import subprocess
import sys

import numpy as np
import pytest

import epode
from epode import viewer

HAS_WINDOWS = importlib.util.find_spec("glfw") is not None and shutil.which("xvfb-run") is not None and hasattr(epode.c._c, "_Painter")
needs_windows = pytest.mark.skipif(not HAS_WINDOWS, reason="wanted: the package glfw, xvfb-run, and a build that draws")


def test_an_eye_turns_about_its_target_and_not_over_the_pole():
    target = np.array([1.0, 2.0, 3.0])
    eye = target + (2, 0, 0)
    np.testing.assert_allclose(viewer.turned(eye, target, math.pi / 2, 0), target + (0, 2, 0), atol=1e-12)
    high = viewer.turned(eye, target, 0, 0.5)
    np.testing.assert_allclose(high - target, (2 * math.cos(0.5), 0, 2 * math.sin(0.5)))
    for up in (9.0, -9.0):
        over = viewer.turned(eye, target, 0, up) - target
        assert np.linalg.norm(over) == pytest.approx(2) and over[0] > 0 and over[2] * up > 0


def test_a_window_without_a_window_system_is_an_exception():
    """Never a crash, and nothing else of the package needs one."""
    code = ("import epode, epode.viewer\nw = epode.World()\nw.plane()\n"
            "try: epode.viewer.Window(w)\nexcept (ImportError, RuntimeError) as e: print('refused:', e)\nw.step(0.01)\n"
            "try: epode.viewer.Window(w, width=0)\nexcept (ValueError, RuntimeError, ImportError): print('twice')")
    env = {"PATH": "/usr/bin:/bin", "HOME": "/tmp"}
    result = subprocess.run([sys.executable, "-W", "ignore", "-c", code], capture_output=True, text=True, env=env, timeout=120)
    assert result.returncode == 0 and "refused:" in result.stdout and "twice" in result.stdout, result.stderr


PROGRAM = """
import json, sys, zlib
import numpy as np
import epode
from epode.viewer import Window

world = epode.World()
world.plane()
ball = world.body(mass=1, position=(0, 0, 3), shape=epode.Sphere(0.5))
out = {}
with Window(world, width=320, height=240, title="a test") as window:
    first = window.picture()
    for _ in range(60):
        world.step(0.01)
        assert window.draw()
    out["states"] = window.state
    out["moved"] = first != window.picture()
    window.look_at_all()
    open(sys.argv[1], "wb").write(window.picture())
    window._key(window._glfw.KEY_SPACE)
    window._key(window._glfw.KEY_LEFT)
    out["paused"], out["back"] = window.paused, window.state
    world.step(0.01)
    window.draw()
    out["still"] = window.state
    before = window.eye.copy()
    window._zoom(0.5)
    out["nearer"] = float(np.linalg.norm(window.eye - window.target) / np.linalg.norm(before - window.target))
    window._pan(10, 5)
    window._key(window._glfw.KEY_HOME)
    out["home"] = bool(np.linalg.norm(window.eye - before) > 0)
    window._key(window._glfw.KEY_ESCAPE)
    out["open"] = window.draw()
out["after"] = window.draw()
film = world.record()
world.step(0.01, steps=200)
film.stop()
with Window(film, width=200, height=200) as window:
    import time
    begin = time.perf_counter()
    while window.state < 10 and time.perf_counter() - begin < 60:
        window.draw()
    out["played"] = window.state
with Window(world, width=64, height=64) as window:      # a world that goes under a window
    world.destroy()
    try:
        window.draw()
    except epode.DeadHandleError:
        out["dead"] = True
print(json.dumps(out))
"""


@needs_windows
def test_a_window_shows_a_world_and_a_recording(tmp_path):
    program = tmp_path / "program.py"
    program.write_text(PROGRAM)
    result = subprocess.run(["xvfb-run", "-a", "-s", "-screen 0 640x480x24 -noreset", sys.executable, str(program), str(tmp_path / "window.png")],
                            capture_output=True, text=True, timeout=300)
    assert result.returncode == 0, result.stderr
    said = json.loads(result.stdout.splitlines()[-1])
    assert said["states"] == 60 and said["moved"] and said["paused"] and said["back"] == 59 == said["still"]
    assert said["nearer"] == pytest.approx(0.5) and said["home"] and not said["open"] and not said["after"]
    assert said["played"] >= 10 and said["dead"]
    from test_recording import pixels_of
    pixels = pixels_of((tmp_path / "window.png").read_bytes())
    assert pixels.shape == (240, 320, 3) and pixels.std() > 10
