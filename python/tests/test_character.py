# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Characters as a user of Python meets them."""
import math
import pickle

import numpy as np
import pytest

import epode

H = 1 / 60


@pytest.fixture
def world():
    with epode.World() as w:
        w.plane()
        yield w


def walk(character, velocity, seconds):
    for _ in range(round(seconds / H)):
        character.walk(velocity, H)
        character.world.step(H)


def stairs(world, steps=5, rise=0.2, tread=0.4, start=1.0):
    for i in range(steps):
        world.geom(epode.Box(tread, 4, (i + 1) * rise), position=(start + (i + 0.5) * tread, 0, (i + 1) * rise / 2))
    world.geom(epode.Box(4, 4, steps * rise), position=(start + steps * tread + 2, 0, steps * rise / 2))


@pytest.mark.parametrize("shape", ["capsule", "cylinder", "box"])
def test_a_character_of_each_shape_climbs_stairs(world, shape):
    stairs(world)
    hero = world.character(shape=shape)
    walk(hero, (2, 0, 0), 2)
    assert hero.on_ground and hero.feet[2] == pytest.approx(1.0, abs=0.02)
    assert hero.ground is world.geoms[-2] and hero.ground_normal == pytest.approx([0, 0, 1])
    assert hero.velocity == pytest.approx([2, 0, 0], abs=1e-6) and not hero.hit_wall


def test_a_jump_has_the_height_of_its_speed(world):
    hero = world.character()
    walk(hero, (0, 0, 0), 0.1)
    assert hero.walk((0, 0, 0), H, jump=4.0) == epode.CharacterState.IN_AIR
    top = 0.0
    for _ in range(60):
        top = max(top, hero.feet[2])
        hero.walk((0, 0, 0), H)
    assert top == pytest.approx(4**2 / (2 * 9.81), rel=0.01) and hero.on_ground


def test_a_character_has_settings(world):
    hero = world.character(radius=0.25, height=1.6, feet=(1, 2, 0), slope_limit=0.5, step_height=0.2, mass=50, max_force=100)
    assert (hero.radius, hero.height, hero.slope_limit, hero.step_height, hero.mass, hero.max_force) == (0.25, 1.6, 0.5, 0.2, 50, 100)
    assert hero.feet == pytest.approx([1, 2, 0]) and hero.up == pytest.approx([0, 0, 1]) and hero.position[2] == pytest.approx(0.8, abs=0.02)
    assert hero.shape == epode.Capsule(0.25, 1.6 - 0.5) and hero in world.geoms
    assert hero.state == epode.CharacterState.NOT_MOVED
    hero.gravity = 1.6
    assert hero.gravity == 1.6 and hero.feet == pytest.approx([1, 2, 0])


def test_refusals_name_the_call(world):
    with pytest.raises(epode.RefusedError, match=r"World\.character\(.*radius=-1.*radius \(accepted: above 0"):
        world.character(radius=-1)
    with pytest.raises(TypeError, match="a character has no speed: .*slope_limit"):
        world.character(speed=3)
    with pytest.raises(ValueError, match="no character is a 'sphere': capsule, cylinder, box"):
        world.character(shape="sphere")
    with pytest.raises(epode.RefusedError, match=r"World\.character"):
        world.character(step_height=-1)
    assert len(world.geoms) == 1
    hero = world.character()
    with pytest.raises(epode.RefusedError, match=r"Character\.walk\(velocity=\(1, 0, 0\), h=2.*h \(accepted"):
        hero.walk((1, 0, 0), 2)
    with pytest.raises(epode.RefusedError, match=r"Character\.max_force = -2"):
        hero.max_force = -2
    with pytest.raises(ValueError, match="velocity: 3 numbers are expected"):
        hero.move((1, 0), H)
    with pytest.raises(TypeError, match="a function of"):
        hero.filter = 3
    assert hero.max_force == 500 and hero.filter is None


def test_it_crouches_and_stands_up_where_nothing_is_above(world):
    world.geom(epode.Box(2, 2, 0.1), position=(2, 0, 1.35))
    hero = world.character()
    assert hero.set_height(1.1) and hero.height == pytest.approx(1.1)
    walk(hero, (2, 0, 0), 1)
    assert hero.feet[0] == pytest.approx(2, abs=0.05) and not hero.set_height(1.8)
    walk(hero, (2, 0, 0), 1)
    assert hero.set_height(1.8) and hero.height == pytest.approx(1.8)


def test_it_rides_what_turns(world):
    table = world.body(shape=epode.Cylinder(2, 0.2), mass=100, position=(0, 0, 0.3), kinematic=True, angular_velocity=(0, 0, 0.5))
    hero = world.character(feet=(1, 0, 0.4))
    turned = 0.0
    for _ in range(120):
        hero.walk((0, 0, 0), H)
        turned += hero.turn
        world.step(H)
    hero.walk((0, 0, 0), H)
    turned += hero.turn
    assert hero.ground is table.geoms[0] and turned == pytest.approx(1.0, abs=0.02)
    assert hero.feet[:2] == pytest.approx([math.cos(1), math.sin(1)], abs=0.02)
    assert np.linalg.norm(hero.ground_velocity) == pytest.approx(0.5, abs=0.01)


def test_a_filter_makes_one_way_platforms(world):
    platform = world.geom(epode.Box(4, 4, 0.2), position=(0, 0, 1.1))
    hero = world.character(height=1.0)
    hero.filter = lambda other, velocity: other is not platform or hero.ground is platform or (velocity[2] <= 0 and hero.feet[2] > 1.15)
    walk(hero, (0, 0, 0), 0.1)
    hero.walk((0, 0, 0), H, jump=6.0)
    walk(hero, (0, 0, 0), 1.5)
    assert hero.ground is platform and hero.feet[2] == pytest.approx(1.2, abs=0.02)
    hero.filter = lambda other, velocity: other is not platform
    walk(hero, (0, 0, 0), 1)
    assert hero.feet[2] == pytest.approx(0, abs=0.02)


def test_an_exception_in_a_filter_is_raised_after_the_move(world):
    hero = world.character(filter=lambda other, velocity: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        hero.walk((1, 0, 0), H)
    assert np.isfinite(hero.feet).all()


def test_it_pushes_with_a_bounded_force(world):
    light, heavy = (world.body(shape=epode.Box(0.5, 0.5, 0.5), mass=mass, position=(1, y, 0.25)) for mass, y in ((20, -2), (2000, 2)))
    pushers = [world.character(feet=(0.2, y, 0)) for y in (-2, 2)]
    for _ in range(120):
        for pusher in pushers:
            pusher.walk((1, 0, 0), H)
        world.step(H)
    assert light.position[0] > 1.5 and heavy.position[0] == pytest.approx(1, abs=0.01)


def test_copies_go_on_with_the_same_bits(world):
    stairs(world)
    hero = world.character(shape="cylinder", max_force=200)
    hero.filter = lambda other, velocity: True
    walk(hero, (2, 0.1, 0), 1)
    state = world.save()
    copies = [world.clone(), pickle.loads(pickle.dumps(world))]
    walk(hero, (2, 0.1, 0), 1)
    after = hero.feet
    for copy in copies:
        twin = copy.geoms[-1]
        assert isinstance(twin, epode.Character) and twin.max_force == 200 and twin.shape == hero.shape
        walk(twin, (2, 0.1, 0), 1)
        assert np.array_equal(twin.feet, after) and twin.ground is copy.geoms[world.geoms.index(hero.ground)]
    assert copies[0].geoms[-1].filter is hero.filter and copies[1].geoms[-1].filter is None
    world.load(state)
    walk(hero, (2, 0.1, 0), 1)
    assert np.array_equal(hero.feet, after)


def test_filters_outlive_the_world_they_came_from():
    world = epode.World()
    world.plane()
    calls = []
    world.character(filter=lambda other, velocity: calls.append(other) or True)
    copy = world.clone()
    world.destroy()
    copy.geoms[-1].walk((1, 0, 0), H)
    assert set(calls) == {copy.geoms[0]}


def test_steps_with_characters_are_taken_back(world):
    world.history = 60
    hero = world.character()
    walk(hero, (1, 0, 0), 0.5)
    where = hero.feet
    walk(hero, (1, 0, 0), 0.5)
    world.roll_back(30)
    assert np.array_equal(hero.feet, where)
    hero.destroy()
    with pytest.raises(epode.DeadHandleError):
        hero.walk((1, 0, 0), H)
    assert not hero.alive and hero not in world.geoms
