# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Copies of worlds: clones, pickles, files."""
import copy
import multiprocessing
import pickle
import subprocess
import sys

import numpy as np
import pytest

import epode


def machine():
    """A bit of everything that Python makes."""
    world = epode.World()
    ground = world.plane(material=epode.Material(friction=0.4))
    world.geom(epode.Mesh(np.array([(-5, -5, -1), (5, -5, -1), (0, 5, -1)], float), np.array([(0, 1, 2)], np.uint32)))
    world.geom(epode.HeightField(np.zeros((5, 5)), 4, 4), position=(20, 0, 0))
    bodies = [world.body(density=300, shape=epode.Box(0.4, 0.4, 0.4), position=(0.05 * i, 0, 0.5 + 0.5 * i)) for i in range(4)]
    arm = world.body(mass=1, shape=epode.Capsule(0.05, 0.5), position=(2, 0, 1))
    arm.add(epode.Sphere(0.1), offset=(0, 0, 0.3))
    hinge = world.joint("hinge", arm, anchor=(2, 0, 1.3), axis=(0, 1, 0))
    hinge.set_drive(stiffness=50, damping=1, target=1)
    world.joint("ball", bodies[0], arm, anchor=(1, 0, 1))
    world.step(0.01, steps=30)
    return world, ground


def states(world):
    return world.bodies.get("position", "quaternion", "velocity", "angular_velocity")


@pytest.mark.parametrize("copied", [epode.World.clone, copy.copy, copy.deepcopy, lambda world: pickle.loads(pickle.dumps(world))],
                         ids=["clone", "copy", "deepcopy", "pickle"])
def test_a_copy_goes_on_with_the_same_bits(copied):
    world, ground = machine()
    twin = copied(world)
    assert twin is not world and len(twin.bodies) == len(world.bodies) and len(twin.geoms) == len(world.geoms)
    assert [j.type for j in twin.joints] == [j.type for j in world.joints]
    np.testing.assert_array_equal(states(world), states(twin))
    for one in (world, twin):
        one.step(0.01, steps=100)
    np.testing.assert_array_equal(states(world), states(twin))
    assert twin.geoms[0].material.friction == 0.4 and type(twin.geoms[0].shape) is type(ground.shape)
    arm = twin.bodies[4]
    assert [type(g.shape).__name__ for g in arm.geoms] == ["Capsule", "Sphere"] and arm.geoms[1].body is arm
    assert twin.joints[1].body1 is twin.bodies[0] and twin.joints[0].drive().target == 1
    world.destroy()
    twin.step(0.01)
    twin.bodies[0].destroy()
    twin.step(0.01)


def test_a_clone_has_no_function_of_the_original():
    world, _ = machine()
    called = []
    world.on_pair(lambda a, b: called.append(1) or True)
    twin = world.clone()
    world.destroy()
    twin.step(0.01)
    assert called == []


def test_a_damaged_pickle_is_refused():
    world, _ = machine()
    rebuild, (file, *others) = world.__reduce__()
    with pytest.raises(epode.RefusedError):
        rebuild(file[:-100] + b"x" * 100, *others)


def run(world):
    world.step(0.01, steps=50)
    return states(world)


def test_worlds_go_to_other_processes():
    world, _ = machine()
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        there = pool.apply(run, (world,))
    np.testing.assert_array_equal(there, run(world))


@pytest.mark.skipif(not hasattr(epode.c._c, "run_command"), reason="built without the command")
def test_the_command_runs_a_file_of_a_world(tmp_path):
    world, _ = machine()
    world.save_file(tmp_path / "machine.epw")
    result = subprocess.run([sys.executable, "-m", "epode", "info", str(tmp_path / "machine.epw")], capture_output=True, text=True)
    assert result.returncode == 0 and "5" in result.stdout, result.stderr
