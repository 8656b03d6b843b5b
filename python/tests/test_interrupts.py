# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Ctrl-C ends every call that makes many steps between two of them, however long a step takes, and what has been made stays."""
import subprocess
import sys

import pytest

import epode
from epode._portions import portions

BEGIN = """
import os, signal, threading, time
import numpy as np
import epode
signal.signal(signal.SIGINT, signal.default_int_handler)  # shells have what they start in the background ignore it
crates = "".join(f"<body pos='{i % 7 * .3} {i // 7 * .3} {1 + i * .1}'><freejoint/><geom type='box' size='.1 .1 .1'/></body>" for i in range(30))
model = epode.robot.from_text("<mujoco><worldbody><geom type='plane' size='9 9 1'/>" + crates + "</worldbody></mujoco>")
robots = epode.Robots([model.build(epode.World()) for _ in range(3)])
worlds = robots.worlds
world = worlds[0]
batch = epode.Batch(model, 64)
film = world.record()
timer = threading.Timer(1.0, lambda: os.kill(os.getpid(), signal.SIGINT))
timer.start()
begin = time.perf_counter()
try:
    {call}
    print("went on to the end")
except KeyboardInterrupt:
    print("interrupted", time.perf_counter() - begin, len(film), np.isfinite(world.bodies[-1].position).all())
"""


@pytest.mark.parametrize("call", ["world.step(0.01, steps=10**7)", "epode.step_worlds(worlds, 0.01, steps=10**7, threads=1)",
                                  "robots.step(0.01, steps=10**7)", "batch.step(10**7)",
                                  "batch.rollout(np.zeros((64, 3, 0)), steps=10**7)"])
def test_a_long_call_ends_between_two_steps(call):
    result = subprocess.run([sys.executable, "-W", "ignore", "-c", BEGIN.replace("{call}", call)], capture_output=True, text=True, timeout=300)
    assert result.returncode == 0, result.stderr
    word, seconds, states, is_finite = result.stdout.split()
    assert word == "interrupted" and float(seconds) < 30 and is_finite == "True"  # busy machines: minutes and hours would be the fault
    assert "batch" in call or int(states) > 1


def test_portions_add_up_and_grow_to_a_twentieth_of_a_second(monkeypatch):
    now = [0.0]
    monkeypatch.setattr("epode._portions.time.perf_counter", lambda: now[0])
    made = []
    for portion in portions(3000):
        made.append(portion)
        now[0] += 0.001 * portion
    assert sum(made) == 3000 and made[:3] == [1, 8, 50] and max(made) == 50
    assert list(portions(0)) == [] and list(portions(-1)) == []
    slow = []
    for portion in portions(5):
        slow.append(portion)
        now[0] += portion
    assert slow == [1] * 5


def test_many_steps_have_the_bits_of_one_call_each():
    def fallen(step):
        worlds = [epode.World() for _ in range(2)]
        for i, world in enumerate(worlds):
            world.plane()
            world.body(mass=1, position=(0, 0, 1 + i), angular_velocity=(1, 2, 3), shape=epode.Box(0.2, 0.3, 0.4))
        step(worlds)
        return [world.bodies[0].position.tobytes() for world in worlds]
    assert fallen(lambda worlds: epode.step_worlds(worlds, 0.01, steps=300)) == fallen(
        lambda worlds: [epode.step_worlds(worlds, 0.01) for _ in range(300)])
