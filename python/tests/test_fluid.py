# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Water as a user of Python meets it."""
import pickle

import numpy as np
import pytest

import epode


def crate(world, **where):
    return world.body(shape=epode.Box(1, 1, 0.5), density=600, **where)


def settle(world):
    for _ in range(1500):
        world.step(1 / 60)


@pytest.fixture
def world():
    with epode.World() as w:
        yield w


def test_a_crate_floats_as_deep_as_it_is_dense(world):
    water = world.fluid()
    body = crate(world, position=(0, 0, 0.3))
    settle(world)
    volume, centre = water.submerged(body)
    assert volume == pytest.approx(0.3, abs=1e-3) and centre[2] == pytest.approx(-0.15, abs=1e-3)
    assert water.submerged(body.geoms[0])[0] == volume
    force, torque = body.fluid_force
    assert force == pytest.approx([0, 0, 300 * 9.81], abs=10) and torque == pytest.approx([0, 0, 0], abs=10)


def test_a_fluid_has_settings_planes_and_currents(world):
    water = world.fluid(plane=(0, 0, 2, 6), density=1200, current=(0.5, 0, 0), drag=0.3, linear_drag=400, angular_drag=2)
    assert world.fluids == (water,)
    assert (water.density, water.drag, water.linear_drag, water.angular_drag) == (1200, pytest.approx(0.3), 400, 2)
    assert water.plane == pytest.approx([0, 0, 1, 3]) and water.current == pytest.approx([0.5, 0, 0])
    body = crate(world, position=(0, 0, 3.3))
    settle(world)
    assert body.position[2] == pytest.approx(3.25 - 0.25, abs=1e-3) and body.velocity[0] == pytest.approx(0.5, abs=1e-3)
    assert water.time == pytest.approx(25)
    with pytest.raises(epode.RefusedError):
        water.density = -1
    with pytest.raises(TypeError):
        world.fluid(depth=3)
    assert len(world.fluids) == 1


def test_functions_move_the_surface_and_the_fluid(world):
    times = []
    water = world.fluid()
    water.surface(lambda place, time: times.append(time) or 2.0)
    water.flow(lambda place, time: (0, 1, 0))
    body = crate(world, position=(0, 0, 2))
    settle(world)
    assert body.position[2] == pytest.approx(1.95, abs=1e-3) and body.velocity[1] == pytest.approx(1, abs=1e-3)
    assert times[0] == 0 and times[-1] == pytest.approx(25 - 1 / 60)
    water.surface(None)
    settle(world)
    assert body.position[2] == pytest.approx(-0.05, abs=1e-3)


def test_an_exception_in_a_surface_is_raised_after_the_step(world):
    water = world.fluid()
    water.surface(lambda place, time: 1 / 0)
    crate(world)
    with pytest.raises(ZeroDivisionError):
        world.step(1 / 60)


def test_a_volume_restricts_a_fluid(world):
    pool = world.geom(epode.Box(4, 4, 4), position=(2, 0, -2))
    water = world.fluid()
    water.volume = pool
    assert water.volume is pool
    inside, outside = crate(world, position=(2, 0, -1)), crate(world, position=(-2, 0, -1))
    assert water.submerged(inside)[0] == pytest.approx(0.5) and water.submerged(outside)[0] == 0
    water.volume = None
    assert water.volume is None and water.submerged(outside)[0] == pytest.approx(0.5)


def test_clones_and_pickles_have_their_fluids(world):
    world.fluid(density=1100)
    crate(world, position=(0, 0, 0.2))
    for _ in range(50):
        world.step(1 / 60)
    copies = [world.clone(), pickle.loads(pickle.dumps(world))]
    for _ in range(50):
        world.step(1 / 60)
    for copy in copies:
        assert [fluid.density for fluid in copy.fluids] == [1100]
        for _ in range(50):
            copy.step(1 / 60)
        assert np.array_equal(copy.bodies.position, world.bodies.position)


def test_destroyed_fluids_raise(world):
    water = world.fluid()
    body = crate(world)
    water.destroy()
    water.destroy()
    assert world.fluids == ()
    with pytest.raises(epode.DeadHandleError):
        water.density = 3
    world.step(0.1)
    assert body.velocity[2] == pytest.approx(-0.981)
    with epode.World() as other:
        gone = other.fluid()
    with pytest.raises(epode.DeadHandleError):
        gone.time
