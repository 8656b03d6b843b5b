# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Recordings, pictures, plots and the command."""
import struct
import subprocess
import sys
import zlib
from importlib import resources

import numpy as np
import pytest

import epode

has_page = resources.files("epode").joinpath("replay.html").is_file()
needs_page = pytest.mark.skipif(not has_page, reason="built without the replay page")


@pytest.fixture
def film():
    with epode.World() as world:
        world.plane()
        ball = world.body(mass=1, position=(0, 0, 2), shape=epode.Sphere(0.2), material=epode.Material(bounce=0.5))
        with world.record("A ball") as recording:
            world.step(0.01, steps=50)
            ball.add(epode.Box(0.1, 0.1, 0.1))
            world.body(mass=1, position=(1, 0, 1), shape=epode.Capsule(0.1, 0.2))
            world.step(0.01, steps=30)
            ball.destroy()
            world.step(0.01, steps=20)
        world.step(0.01)
    return recording


def test_a_recording_has_the_states(film):
    assert len(film) == 101
    np.testing.assert_allclose(film.times[[0, 50, -1]], [0, 0.5, 1.0])
    fall = film.trajectory(0)
    assert fall[0, 2] == 2 and np.isnan(fall[-1, 2]) and np.isfinite(fall[80, 2])
    assert film.bodies(0).shape == (1, 13) and film.bodies(60).shape == (2, 13)
    np.testing.assert_allclose((film.kinetic + film.potential)[:50], 2 * 9.81, rtol=0.02)
    assert film.contact_counts.max() >= 1 and film.hash(0) != film.hash(1)
    with pytest.raises(IndexError):
        film.bodies(101)


def test_a_recording_is_a_file_that_the_command_knows(film, tmp_path):
    path = tmp_path / "ball.epr"
    film.save(path)
    again = epode.Recording.load(path)
    assert len(again) == len(film) and [again.hash(i) for i in range(101)] == [film.hash(i) for i in range(101)]
    for ending in ("csv", "glb"):
        film.save(tmp_path / f"ball.{ending}")
        assert (tmp_path / f"ball.{ending}").stat().st_size > 1000
    with pytest.raises(ValueError, match="none of"):
        film.save(tmp_path / "ball.mpg")
    with pytest.raises(OSError):
        film.save(tmp_path / "nowhere" / "ball.epr")
    with pytest.raises(OSError):
        epode.Recording.load(tmp_path / "ball.glb")


@needs_page
def test_a_notebook_shows_the_replay_page(film):
    shown = film._repr_html_()
    assert shown.startswith("<iframe srcdoc=") and "A ball" in shown and "<script" not in shown
    assert film.html().count("<script") >= 2


def size_of(png):
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack(">II", png[16:24])


def pixels_of(png):
    at, data = 8, b""
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        data += png[at + 8:at + 8 + length] if kind == b"IDAT" else b""
        at += 12 + length
    width, height = size_of(png)
    return np.frombuffer(zlib.decompress(data), np.uint8).reshape(height, 1 + 3 * width)[:, 1:].reshape(height, width, 3)


def picture_or_skip(call):
    try:
        return call()
    except RuntimeError as error:
        if "build" in str(error) or "EGL" in str(error):
            pytest.skip(str(error))
        raise


def test_pictures_show_what_there_is(film, tmp_path):
    png = picture_or_skip(lambda: film.picture(tmp_path / "ball.png", state=10, width=320, height=180))
    assert size_of(png) == (320, 180) and (tmp_path / "ball.png").read_bytes() == png
    assert pixels_of(png).std() > 10
    with epode.World() as world:
        empty = pixels_of(world.picture(width=64, height=64, eye=(5, 0, 1), target=(0, 0, 1)))
        mesh = epode.Mesh(np.array([(0, -1, 0), (0, 1, 0), (0, 0, 2)], float), np.array([(0, 1, 2)], np.uint32))
        world.geom(mesh)
        assert np.any(pixels_of(world.picture(width=64, height=64, eye=(5, 0, 1), target=(0, 0, 1))) != empty)
    with pytest.raises(ValueError, match="width"):
        film.picture(width=0)


def test_plots(film):
    pyplot = pytest.importorskip("matplotlib.pyplot")
    pyplot.switch_backend("agg")
    from epode import plot
    assert len(plot.energy(film).lines) == 3 and len(plot.position(film, 0).lines) == 3
    assert plot.contacts(film).get_xlabel() == "time, s" and len(plot.speed(film).lines) == 1
    pyplot.close("all")


def command(*words):
    return subprocess.run([sys.executable, "-m", "epode", *words], capture_output=True, text=True, timeout=120)


needs_command = pytest.mark.skipif(not hasattr(epode.c._c, "run_command"), reason="built without the command")


@needs_command
def test_the_command_has_its_words_and_exit_codes(film, tmp_path):
    assert "pendulum" in command("list").stdout
    run = command("run", "pendulum", "--steps", "50", "--record", str(tmp_path / "a.epr"))
    assert run.returncode == 0, run.stderr
    assert command("replay", str(tmp_path / "a.epr")).returncode == 0
    film.save(tmp_path / "ball.epr")
    assert "101" in command("inspect", str(tmp_path / "ball.epr")).stdout
    assert command("diff", str(tmp_path / "a.epr"), str(tmp_path / "ball.epr")).returncode == 1
    wrong = command("rum")
    assert wrong.returncode == 2 and "run" in wrong.stderr
    assert command("inspect", str(tmp_path / "nothing.epr")).returncode != 0


@needs_command
def test_the_command_steps_with_the_package_s_own_library(tmp_path):
    said = command("--version").stdout
    assert "Epode" in said and "libode.so" not in said
    # What only this library has is found.
    assert command("run", "pile", "--steps", "20", "--world-contacts", "--stepper", "hybrid").returncode == 0
