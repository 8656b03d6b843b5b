# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The window: under an X server without a screen, in a process of its own, where there is one; else what needs none."""
import importlib.util
import json
import math
import pathlib
import shutil
import subprocess
import sys

import numpy as np
import pytest

import epode
from epode import _controls, _panel, viewer

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


ROBOT = """<mujoco model='arm'><option gravity='0 0 0'/><worldbody><camera name='side' pos='0 -3 1' xyaxes='1 0 0 0 0 1'/>
<body pos='0 0 1'><joint name='lift' type='slide' axis='0 0 1' range='-0.5 0.5'/><geom size='.2' mass='2'/><camera name='hand' pos='0 0 2'/>
<body pos='0.3 0 0'><joint name='turn' axis='0 0 1'/><geom type='capsule' size='.05' fromto='0 0 0 .4 0 0' mass='1'/></body></body></worldbody>
<actuator><position name='height' joint='lift' kp='100' ctrlrange='-0.4 0.4'/><motor name='push' joint='turn'/></actuator></mujoco>"""


def middle_of(number, share):
    """The pixel of a row of the panel at a share of its slider."""
    return _panel._EDGE + share * (_panel.WIDTH - 2 * _panel._EDGE), _panel._EDGE + (number + 0.5) * _panel._ROW


def test_a_slider_follows_the_mouse_between_its_ends_until_it_is_released():
    numbers, clicks = [0.0], []
    slider = _panel.Slider("its", -2.0, 4.0, lambda: numbers[-1], numbers.append)
    panel = _panel.Panel([_panel.Title("of all"), _panel.Button("press", lambda: clicks.append(1)), slider])
    panel.press(*middle_of(1, 0.5))
    assert clicks == [1] and not panel.is_held
    panel.press(*middle_of(2, 0.5))
    assert panel.is_held and numbers[-1] == pytest.approx(1.0)
    for x, wanted in ((middle_of(2, 0.75)[0], 2.5), (-50, -2.0), (9999, 4.0)):
        panel.drag(x)
        assert numbers[-1] == pytest.approx(wanted) and slider.share() == pytest.approx((wanted + 2) / 6)
    numbers.append(0.0)  # a step has moved it
    panel.hold()
    assert numbers[-1] == pytest.approx(4.0)
    panel.release()
    count = len(numbers)
    panel.drag(0)
    panel.hold()
    assert len(numbers) == count and not panel.is_held
    for nowhere in (-100, 10_000):
        panel.press(20, nowhere)
        assert not panel.is_held


def test_a_panel_scrolls_to_its_last_row_and_no_farther():
    panel = _panel.Panel([_panel.Slider(str(i), 0, 1, lambda: 0.5, lambda value: None) for i in range(30)])
    top = panel.pixels(200)
    panel.scroll(-10_000, 200)
    assert panel.offset == panel.height - 200 and (panel.pixels(200) != top).any() and panel.pixels(200).shape == (200, _panel.WIDTH, 3)
    panel.press(20, 200 - _panel._EDGE - 1)
    assert panel.rows[29].held is not None
    panel.scroll(10_000, 200)
    assert panel.offset == 0 and panel.pixels(2000).shape == (2000, _panel.WIDTH, 3)


def test_every_actuator_and_every_joint_has_a_slider_within_its_ends():
    robot = epode.robot.from_text(ROBOT).build()
    rows = _controls.rows_of(robot)
    sliders = {row.text: row for row in rows if isinstance(row, _panel.Slider)}
    assert [row.text for row in rows if isinstance(row, _panel.Title)] == ["arm: controls", "arm: joints"]
    ends = {name: (its.low, its.high) for name, its in sliders.items()}
    assert ends == {"height": (-0.4, 0.4), "push": (-10, 10), "lift": (-0.5, 0.5), "turn": (-math.pi, math.pi)}
    sliders["push"].turn(3.0)
    sliders["lift"].turn(0.25)
    assert list(robot.controls) == [0, 3] and robot.positions[0] == pytest.approx(0.25) == sliders["lift"].read()
    robot.world.step(0.01)
    assert robot.velocities[1] != 0
    turning = robot.velocities[1]
    sliders["lift"].turn(0.1)  # the other joint goes on
    assert robot.velocities[1] == pytest.approx(turning) and robot.velocities[0] == 0
    robot.destroy()
    sliders["push"].turn(1.0)
    assert math.isnan(sliders["push"].read()) and sliders["push"].share() == 0.5


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


ROBOT_PROGRAM = """
import json, sys
import numpy as np
import epode
from epode import _panel
from epode.viewer import Window
sys.path.insert(0, sys.argv[2])
from test_recording import pixels_of
from test_viewer import ROBOT, middle_of

robot = epode.robot.from_text(ROBOT).build()
world, out = robot.world, {}
with Window(world, width=1280, height=720) as window:
    window.draw()
    window.look_at_all()
    names = [getattr(row, "text", "") for row in window._panel.rows]
    window._press(*middle_of(names.index("height"), 0.75), True, False)     # 0.2 of -0.4 to 0.4
    out["control"] = float(robot.controls[0])
    window._release()
    for _ in range(300):
        world.step(0.01)
    out["lifted"] = float(robot.positions[0])
    window._press(*middle_of(names.index("turn"), 0.75), True, False)       # held at a quarter turn, whatever pulls
    robot.control(1, 5)
    for _ in range(50):
        world.step(0.01)
        assert window._panel.is_held
    out["held"] = float(robot.positions[1])
    window._release()
    world.step(0.01)
    world.step(0.01)
    out["free"] = float(robot.velocities[1])
    out["cameras"] = window.cameras
    window.draw()
    free = window.picture()
    seen = []
    for _ in range(3):
        window.next_camera()
        seen.append([window.camera, window.picture() != free])
    out["seen"] = seen
    window.next_camera()
    window._press(700, 400, True, False)
    window._drag(720, 400)
    out["left"] = [window.camera, float(np.linalg.norm(window.eye - (0, -3, 1)))]
    window._release()
    robot.destroy()
    window.draw()
    out["rows"] = len(window._panel.rows)
    out["after"] = window.cameras

world = epode.World(gravity=(0, 0, 0))
ball = world.body(mass=1, shape=epode.Sphere(0.5))
for panel in (True, False):
    with Window(world, width=1280, height=720, panel=panel) as window:
        window.draw()
        window.look_at_all()
        with_ball = pixels_of(window.picture()).astype(int)
        name = "panel" if panel else "alone"
        begin = _panel.WIDTH if panel else 0
        out[name] = []
        for x in (begin + (1280 - begin) / 2, begin + 5):       # in the middle the mouse takes the ball
            window._take(x, 360, True)
            out[name].append(window._hand is not None)
            window._release()
        if panel:
            open(sys.argv[1], "wb").write(window.picture())
        ball.position = 0, 0, 1000
        window.draw()
        rows, columns = np.nonzero(np.abs(with_ball - pixels_of(window.picture())).sum(axis=2) > 30)
        columns = columns[columns >= begin]
        out[name] += [float((columns.min() + columns.max()) / 2), int(columns.min()), int(columns.max()), float((rows.min() + rows.max()) / 2)]
        ball.position = 0, 0, 0
print(json.dumps(out))
"""


@needs_windows
def test_a_window_has_sliders_and_cameras_of_its_robots_and_shows_next_to_the_panel(tmp_path):
    program = tmp_path / "program.py"
    program.write_text(ROBOT_PROGRAM)
    here = str(pathlib.Path(__file__).parent)
    result = subprocess.run(["xvfb-run", "-a", "-s", "-screen 0 1280x800x24 -noreset", sys.executable, str(program), str(tmp_path / "panel.png"), here],
                            capture_output=True, text=True, timeout=300)
    assert result.returncode == 0, result.stderr
    said = json.loads(result.stdout.splitlines()[-1])
    assert said["control"] == pytest.approx(0.2, abs=0.005) and said["lifted"] == pytest.approx(0.2, abs=0.01)
    assert said["held"] == pytest.approx(math.pi / 2, abs=0.05) and said["free"] > 0
    assert said["cameras"] == ["side", "hand"] and said["seen"] == [["side", True], ["hand", True], [None, False]]
    assert said["left"][0] is None and said["left"][1] == pytest.approx(0, abs=0.5)
    assert said["rows"] == 5 and said["after"] == []
    for name, middle in (("panel", 780), ("alone", 640)):
        there, aside, x, first, last, y = said[name]
        assert there and not aside and x == pytest.approx(middle, abs=15) and y == pytest.approx(360, abs=15), said
        assert first > middle - 500 and last < 1280, said
