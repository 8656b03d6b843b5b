#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Epode's package and MuJoCo's bindings, in the same minutes: python_peers.py, in an environment that has both (pip install mujoco).
Time is that of the process's CPU, the least of some rounds in turn, since the machine may be busy: import (beyond numpy's), all poses
and velocities of 1,000 bodies read, a step of one body, 100,000 rays, and the speed of two threads with two worlds."""
import subprocess
import sys
import threading
import time

import numpy as np


def least(function, rounds, repeats):
    """Seconds of one call."""
    best = float("inf")
    for _ in range(rounds):
        begin = time.process_time()
        for _ in range(repeats):
            function()
        best = min(best, (time.process_time() - begin) / repeats)
    return best


def import_seconds(module):
    code = f"import numpy, time; t = time.thread_time(); import {module}; print(time.thread_time() - t)"
    return min(float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout) for _ in range(7))


def epode_figures():
    import epode
    world = epode.World(contacts=False, gravity=(0, 0, 0))
    for i in range(1000):
        world.body(mass=1, position=(i, 0, 0))
    bodies, names = world.bodies, ("position", "quaternion", "velocity", "angular_velocity")
    yield "poses of 1,000 bodies", least(lambda: bodies.get("position", "quaternion"), 20, 200)
    poses = bodies.get("position", "quaternion")
    yield "... into an array", least(lambda: bodies.get("position", "quaternion", out=poses), 20, 200)
    positions = bodies.get("position")
    yield "... positions alone", least(lambda: bodies.get("position", out=positions), 20, 200)
    states = bodies.get(*names)
    yield "poses and velocities read", least(lambda: bodies.get(*names), 20, 200)
    yield "poses and velocities set", least(lambda: bodies.set(states, *names), 20, 100)
    one = epode.World()
    one.body(mass=1)
    yield "a step of one body", least(lambda: one.step(0.002), 20, 2000)
    scene = epode.World()
    scene.plane()
    for x, y, z in boxes():
        scene.geom(epode.Box(1, 1, 1), position=(x, y, z))
    origins, directions = rays()
    yield "100,000 rays", least(lambda: scene.rays(origins, directions, threads=1), 3, 1)


def mujoco_figures():
    import mujoco
    free = "".join(f'<body pos="{i} 0 0"><freejoint/><geom size=".1" contype="0" conaffinity="0"/></body>' for i in range(1000))
    model = mujoco.MjModel.from_xml_string(f'<mujoco><option gravity="0 0 0"/><worldbody>{free}</worldbody></mujoco>')
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    # qpos holds positions and quaternions, qvel velocities: the copy is what a program keeps.
    yield "poses of 1,000 bodies", least(lambda: data.qpos.copy(), 20, 200)
    poses = data.qpos.copy()
    yield "... into an array", least(lambda: np.copyto(poses, data.qpos), 20, 200)
    rows, positions = data.qpos.reshape(1000, 7), np.zeros((1000, 3))
    yield "... positions alone", least(lambda: np.copyto(positions, rows[:, :3]), 20, 200)
    yield "poses and velocities read", least(lambda: (data.qpos.copy(), data.qvel.copy()), 20, 200)
    qpos, qvel = data.qpos.copy(), data.qvel.copy()

    def put():
        data.qpos[:] = qpos
        data.qvel[:] = qvel
    yield "poses and velocities set", least(put, 20, 100)
    ball = mujoco.MjModel.from_xml_string('<mujoco><worldbody><body><freejoint/><geom size=".1"/></body></worldbody></mujoco>')
    state = mujoco.MjData(ball)
    yield "a step of one body", least(lambda: mujoco.mj_step(ball, state), 20, 2000)
    geoms = "".join(f'<geom type="box" size=".5 .5 .5" pos="{x} {y} {z}"/>' for x, y, z in boxes())
    scene = mujoco.MjModel.from_xml_string(f'<mujoco><worldbody><geom type="plane" size="0 0 1"/>{geoms}</worldbody></mujoco>')
    data2 = mujoco.MjData(scene)
    mujoco.mj_forward(scene, data2)
    origins, directions = rays()
    count = len(origins)
    where, distance = np.full(count, -1, np.int32), np.zeros(count)
    normals = np.zeros((count, 3)).reshape(-1)

    def cast():
        try:
            mujoco.mj_multiRay(scene, data2, origins[0], directions.reshape(-1), None, 1, -1, where, distance, normals, count, 1e10)
        except TypeError:
            mujoco.mj_multiRay(scene, data2, origins[0], directions.reshape(-1), None, 1, -1, where, distance, count, 1e10)
    yield "100,000 rays", least(cast, 3, 1)


def boxes():
    return np.random.default_rng(1).uniform((-20, -20, 0), (20, 20, 3), (100, 3))


def rays(count=100_000):
    """From one point, so that both have a call for all of them."""
    directions = np.random.default_rng(2).normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    return np.broadcast_to(np.array((0.0, 0.0, 5.0)), (count, 3)), directions


def two_threads():
    """How much faster two threads with a world each are than one thread with both."""
    import epode

    def pile():
        world = epode.World()
        world.plane()
        for i in range(200):
            world.body(mass=1, position=(i % 6 * 0.9, i // 6 % 6 * 0.9, 0.5 + i // 36), shape=epode.Box(1, 1, 1))
        return world

    def work(world):
        world.step(0.01, stepper="quick", steps=100)
    best = {"one": float("inf"), "two": float("inf")}
    for _ in range(5):
        worlds = [pile(), pile()]
        begin = time.perf_counter()
        for world in worlds:
            work(world)
        best["one"] = min(best["one"], time.perf_counter() - begin)
        threads = [threading.Thread(target=work, args=(world,)) for world in (pile(), pile())]
        begin = time.perf_counter()
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        best["two"] = min(best["two"], time.perf_counter() - begin)
    return best["one"] / best["two"]


if __name__ == "__main__":
    print(f"{'import, beyond numpy':28} epode {1e3 * import_seconds('epode'):10.1f} ms   mujoco {1e3 * import_seconds('mujoco'):10.1f} ms")
    for (what, ours), (_, theirs) in zip(epode_figures(), mujoco_figures()):
        print(f"{what:28} epode {1e6 * ours:10.1f} us   mujoco {1e6 * theirs:10.1f} us   {theirs / ours:6.2f} times as fast")
    print(f"two threads, two worlds: {two_threads():.2f} times one thread")
