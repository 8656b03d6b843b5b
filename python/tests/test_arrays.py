# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""States, materials and joints of many objects as arrays, of one world and of several."""
import gc

import numpy as np
import pytest

import epode


@pytest.fixture
def world():
    with epode.World(gravity=(0, 0, 0)) as w:
        for i in range(7):
            w.body(mass=1 + i, position=(i, -i, 2 * i), quaternion=(1, 0.1 * i, 0, 0.2), velocity=(0, i, 1), angular_velocity=(i, 0, 3))
        yield w


PARTS = {"position": 3, "quaternion": 4, "velocity": 3, "angular_velocity": 3, "force": 3, "torque": 3, "enabled": 1}


def test_every_set_of_parts_is_what_its_parts_are(world):
    """All 127 sets: usual ones are read by loops of their own."""
    names = list(PARTS)
    world.bodies.force, world.bodies.torque = (1, 2, 3), (4, 5, 6)
    world.bodies[2].enabled = False
    single = {name: np.array([np.atleast_1d(getattr(body, name)) for body in world.bodies], float) for name in names}
    for number in range(1, 128):
        chosen = [name for i, name in enumerate(names) if number >> i & 1]
        np.testing.assert_array_equal(world.bodies.get(*chosen), np.hstack([single[name] for name in chosen]))


def test_states_fill_an_array_of_the_program(world):
    out = np.full((7, 7), np.nan)
    assert world.bodies.get("position", "quaternion", out=out) is out
    np.testing.assert_array_equal(out, world.bodies.get("position", "quaternion"))
    with pytest.raises(ValueError, match="7 rows of 3"):
        world.bodies.get("position", out=out)
    readonly = np.zeros((7, 3))
    readonly.setflags(write=False)
    for bad in (np.zeros((7, 3), np.float32), np.zeros((7, 6))[:, ::2], readonly, [[0.0] * 3] * 7):
        with pytest.raises(TypeError):
            world.bodies.get("position", out=bad)
    assert not readonly.any()
    with pytest.raises(ValueError, match="speed: no part"):
        world.bodies.get("speed")
    with pytest.raises(ValueError, match="nothing"):
        world.bodies.get()


def test_nothing_is_written_if_one_body_is_gone(world):
    group = epode.BodyGroup(world.bodies)
    world.bodies[6].destroy()
    out = np.full((7, 3), 5.0)
    with pytest.raises(epode.DeadHandleError):
        group.get("position", out=out)
    assert (out == 5).all()


def test_a_group_has_bodies_of_several_worlds():
    worlds = [epode.World() for _ in range(5)]
    group = epode.BodyGroup(w.body(mass=1, position=(i, 0, 0)) for i, w in enumerate(worlds))
    epode.step_worlds(worlds, 0.01, stepper="exact", steps=10)
    assert len(group) == 5 and group[3].world is worlds[3]
    np.testing.assert_array_equal(group.position[:, 0], range(5))
    np.testing.assert_allclose(group.velocity[:, 2], -0.981)
    group.velocity = (1, 0, 0)
    assert worlds[4].bodies[0].velocity[0] == 1
    with pytest.raises(epode.DeadHandleError):
        worlds[2].destroy()
        group.position


def test_states_of_joints_are_arrays():
    world = epode.World(gravity=(0, 0, 0))
    hinges = [world.joint("hinge", world.body(mass=1, angular_velocity=(0, 0, i)), axis=(0, 0, 1)) for i in range(1, 4)]
    slider = world.joint("slider", world.body(mass=1, velocity=(0.5, 0, 0)), axis=(1, 0, 0))
    world.step(0.01, steps=10)
    positions, rates = epode.joint_states([*hinges, slider], 2)
    assert positions.shape == rates.shape == (4, 2) and not positions[:, 1].any()
    np.testing.assert_allclose(positions[:, 0], [joint.position() for joint in (*hinges, slider)], atol=0)
    np.testing.assert_allclose(rates[:, 0], [1, 2, 3, 0.5], rtol=1e-6)
    with pytest.raises(ValueError):
        epode.joint_states(hinges, 4)


def test_materials_of_all_geoms_are_one_array():
    world = epode.World()
    ground = world.plane(material=epode.Material(friction=0.3))
    balls = [world.body(mass=1, position=(i, 0, 1), shape=epode.Sphere(0.2)) for i in range(4)]
    materials = world.materials
    assert materials["friction"].tolist() == [0.3, 0.6, 0.6, 0.6, 0.6] and materials["surface_velocity"].shape == (5, 3)
    materials["bounce"][1:] = 0.5
    materials["surface_velocity"][0] = (2, 0, 0)
    materials["friction_rule"] = epode.CombineRule.MINIMUM
    world.materials = materials
    assert balls[2].geoms[0].material.bounce == 0.5 and ground.material.surface_velocity == (2, 0, 0)
    assert ground.material.friction_rule is epode.CombineRule.MINIMUM
    np.testing.assert_array_equal(world.materials, materials)
    broken = materials.copy()
    broken["friction"] = 0.9
    broken["bounce"][3] = 7
    with pytest.raises(epode.RefusedError, match="^World.materials = .*a bounce above 1"):
        world.materials = broken
    np.testing.assert_array_equal(world.materials, materials)
    with pytest.raises(ValueError):
        world.materials = materials[:2]


def resident():
    with open("/proc/self/statm") as f:
        return int(f.read().split()[1]) * 4096


@pytest.mark.parametrize("kind", ["mesh", "solid mesh", "hull", "heights"])
def test_large_shapes_give_their_memory_back(kind):
    """Each takes some 6 MB and more; two hundred would be a gigabyte."""
    n = 300
    x, y = np.meshgrid(np.arange(n, dtype=float), np.arange(n, dtype=float))
    vertices = np.column_stack([x.ravel(), y.ravel(), np.sin(x * y / 900).ravel()])
    first = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).ravel()
    corners = np.concatenate([np.column_stack([first, first + 1, first + n]), np.column_stack([first + 1, first + n + 1, first + n])])
    cube = np.array([(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)], float)
    rounded = cube[:, None] + 0.3 * np.random.default_rng(1).normal(size=(8, 400, 3))

    def live():
        with epode.World() as world:
            if kind == "mesh":
                world.geom(epode.Mesh(vertices, corners.astype(np.uint32)))
            elif kind == "solid mesh":
                world.geom(epode.Mesh(vertices + 1, corners.astype(np.uint32), solid=False))
                world.rays((150, 150, 10), (0, 0, -1))
            elif kind == "hull":
                world.geom(epode.Convex(rounded.reshape(-1, 3)))
            else:
                world.geom(epode.HeightField(vertices[:, 2].reshape(n, n), 30, 30))
            world.step(0.01)
    for _ in range(5):
        live()
    gc.collect()
    before = resident()
    for _ in range(20):
        live()
    gc.collect()
    assert resident() - before < 20e6, (resident() - before) / 1e6
