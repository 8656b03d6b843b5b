# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Ropes and bridges as a user of Python meets them."""
import pickle

import numpy as np
import pytest

import epode

H = 1 / 60


@pytest.fixture
def world():
    with epode.World(defaults="game") as w:
        yield w


def hang(world, mass, **settings):
    """A load at rest on a rope from the origin down to z = -5."""
    load = world.body(mass=mass, shape=epode.Sphere(0.25), position=(0, 0, -5.25))
    return load, world.rope((0, 0, 0), (0, 0, -5), last=load, mass=5, links=50, **settings)


def test_a_rigid_rope_keeps_its_length_under_a_thousand_times_a_link(world):
    load, rope = hang(world, 100)
    load.velocity = (0.5, 0, 0)
    longest = 0.0
    for _ in range(180):
        world.step(H)
        longest = max(longest, float(np.linalg.norm(rope.points[-1])))
        assert rope.gap < 1e-3
    assert longest == pytest.approx(5, abs=2e-3) and load.position[0] != 0


def test_an_elastic_rope_stretches_by_its_share_under_its_load(world):
    """Each of the 51 joints takes its part of the stretch, under the load and the links below it."""
    load, rope = hang(world, 100, stretch=0.05, load=1000.0)
    for body in (*rope.bodies, load):
        body.auto_disable = False
        body.linear_damping = 0.02
    rope.joints[0].feedback, rope.joints[-1].feedback
    world.step(H, steps=1800)
    tensions = [9.81 * (100 + 5 * below / 50) for below in range(50, -1, -1)]
    stretch = sum(0.05 * 5 / 51 * tension / 1000 for tension in tensions)
    assert -rope.points[-1][2] - 5 == pytest.approx(stretch - 0.05 * 5 / 51 * tensions[-1] / 1000, rel=0.01)
    assert -load.position[2] - 5.25 == pytest.approx(stretch, rel=0.01)
    assert rope.joints[0].feedback.f1[2] == pytest.approx(tensions[0], rel=0.01)
    assert rope.joints[-1].feedback.f1[2] == pytest.approx(-tensions[-1], rel=0.01)


def test_a_long_rope_hangs_in_a_catenary(world):
    """y = a cosh(x / a): span 4 and length 5 have a = 1.6915 and a sag of 1.3159 by Newton's method."""
    rope = world.rope((-2, 0, 0), (2, 0, 0), length=5, links=50, mass=3)
    for body in rope.bodies:
        body.linear_damping = body.angular_damping = 0.05
    world.step(H, steps=1200)
    a = 1.5
    for _ in range(50):
        f, slope = 2 * a * np.sinh(2 / a) - 5, 2 * np.sinh(2 / a) - 4 / a * np.cosh(2 / a)
        a -= f / slope
    sag = a * (np.cosh(2 / a) - 1)
    assert rope.points.shape == (51, 3) and -rope.points[:, 2].min() == pytest.approx(sag, rel=0.01)
    assert np.linalg.norm(np.diff(rope.points, axis=0), axis=1).sum() == pytest.approx(5, rel=1e-3)


def test_a_bridge_of_forty_planks_carries_half_a_ton(world):
    bridge = world.rope((-10, 0, 0), (10, 0, 0), links=40, length=20.4, width=1.5, radius=0.03, mass=600)
    assert isinstance(bridge.bodies[0].geoms[0].shape, epode.Box) and bridge.joints[5].type == "hinge"
    for body in bridge.bodies:
        body.linear_damping = body.angular_damping = 0.05
    world.step(H, steps=120)
    middle = float(bridge.points[:, 2].min())
    load = world.body(mass=500, shape=epode.Box(0.8, 0.8, 0.8), position=(0, 0, middle + 0.45))
    worst = 0.0
    for _ in range(360):
        world.step(H)
        worst = max(worst, bridge.gap)
    assert worst < 1e-3 and middle - 0.5 < load.position[2] and np.abs(world.bodies.velocity).max() < 0.02


def test_ends_are_fastened_to_bodies_the_world_or_nothing(world):
    post = world.body(mass=1, shape=epode.Sphere(0.1), position=(0, 0, 0), kinematic=True)
    rope = world.rope((0, 0, 0), (2, 0, 0), links=10, first=post, ends=epode.RopeEnds.FROM, material=epode.Material(friction=0.2))
    assert rope.joints[0].body2 is post and rope.joints[0].body1 is rope.bodies[0] and rope.joints[-1] is None
    assert len(rope.joints) == 11 and len(world.joints) == 10 and rope.bodies[3].geoms[0].material.friction == 0.2
    assert rope.points == pytest.approx(np.linspace((0, 0, 0), (2, 0, 0), 11)) and world.ropes == (rope,)
    post.velocity = (0, 0, 1)
    world.step(H, steps=30)
    assert rope.points[0] == pytest.approx([0, 0, 0.5], abs=0.01) and rope.points[-1][2] < -1  # it swings down
    loose = world.rope((0, 5, 0), (2, 5, 0), links=10, ends=epode.RopeEnds.LOOSE)
    assert loose.joints[0] is None and loose.joints[-1] is None
    world.step(H, steps=30)
    assert loose.points[:, 2] == pytest.approx(np.full(11, loose.points[0][2]), abs=1e-6) and loose.points[0][2] < -1


def test_copies_go_on_with_the_same_bits_and_steps_are_taken_back(world):
    world.history = 60
    load, rope = hang(world, 20, stretch=0.02)
    load.velocity = (1, 0, 0)
    world.step(H, steps=20)
    copies = [world.clone(), pickle.loads(pickle.dumps(world))]
    for one in (world, *copies):
        one.step(H, steps=40)
    for copy in copies:
        twin, = copy.ropes
        assert np.array_equal(twin.points, rope.points) and [j and j.type for j in twin.joints] == [j and j.type for j in rope.joints]
    where = rope.points
    rope.destroy()
    assert not rope.alive and world.ropes == () and len(world.bodies) == 1 and world.joints == []
    with pytest.raises(epode.DeadHandleError, match="Rope"):
        rope.points
    world.step(H)
    world.roll_back(1)
    assert rope.alive and np.array_equal(rope.points, where) and rope.joints[-1].body2 is load


def test_mistakes_are_refused_by_name_and_change_nothing(world):
    for settings, said in (({"links": 0}, "links .accepted: 1"), ({"links": 2_000_000_000}, "links"), ({"length": 0.5}, "length below"),
                           ({"mass": 0}, "mass"), ({"radius": 0.2}, "radius of links"), ({"stretch": 0.1, "width": 1}, "stretch of planks"),
                           ({"load": -1}, "load"), ({"length": float("nan")}, "length")):
        with pytest.raises(epode.RefusedError, match=rf"World\.rope\(start=.*{said}"):
            world.rope((0, 0, 0), (1, 0, 0), **settings)
    with pytest.raises(epode.RefusedError, match="nearer than the rope is thick"):
        world.rope((0, 0, 0), (0, 0, 0))
    with pytest.raises(ValueError, match="end: 3 numbers"):
        world.rope((0, 0, 0), (1, 0))
    with pytest.raises(TypeError):
        world.rope((0, 0, 0), (1, 0, 0), links=2.5)
    other = epode.World()
    with pytest.raises(epode.RefusedError, match="another world"):
        world.rope((0, 0, 0), (1, 0, 0), first=other.body(mass=1))
    with pytest.raises(TypeError, match="a Material"):
        world.rope((0, 0, 0), (1, 0, 0), material="ice")
    assert len(world.bodies) == 0 and world.geoms == [] and world.joints == [] and world.ropes == ()
