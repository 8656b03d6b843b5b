# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Impulses and forces that wake as a user of Python meets them."""
import numpy as np
import pytest

import epode


@pytest.fixture
def world():
    with epode.World(gravity=(0, 0, 0)) as w:
        yield w


def crate(world, *position):
    body = world.body(mass=4, position=position, shape=epode.Box(1, 1, 1))
    body.enabled = False
    return body


def test_an_impulse_changes_the_momentum_at_once_and_wakes(world):
    body = crate(world, 0, 0, 0)
    body.apply_impulse((8, 0, 0), at=(0, 0.5, 0))
    assert body.enabled and body.velocity == pytest.approx([2, 0, 0])
    inertia = 4 / 6
    assert body.angular_velocity == pytest.approx([0, 0, -4 / inertia])
    body.apply_angular_impulse((0, 0, 4))
    assert body.angular_velocity == pytest.approx([0, 0, 0], abs=1e-9) and body.velocity == pytest.approx([2, 0, 0])
    body.apply_impulse((-8, 0, 0))
    assert body.velocity == pytest.approx([0, 0, 0])


def test_forces_wake_and_velocities_if_asked(world):
    body = crate(world, 0, 0, 0)
    body.apply_force((8, 0, 0))
    world.step(0.01)
    assert body.velocity == pytest.approx([0.02, 0, 0])
    body.enabled = False
    body.apply_torque((0, 0, 1))
    assert body.enabled
    body.enabled = False
    body.set_velocities(angular=(0, 0, 3), wake=False)
    assert not body.enabled and body.velocity[0] == pytest.approx(0.02) and body.angular_velocity[2] == 3
    body.set_velocities((1, 0, 0))
    assert body.enabled and body.velocity[0] == 1 and body.angular_velocity[2] == 3


def test_a_radial_impulse_falls_off_and_stops_at_walls(world):
    near, far, hidden = crate(world, 2.5, 0, 0), crate(world, -20, 0, 0), crate(world, 0, 4.5, 0)
    world.geom(epode.Box(4, 0.2, 4), position=(0, 2, 0))
    assert world.radial_impulse((0, 0, 0), 8, 20, falloff=epode.Falloff.QUADRATIC, occlusion=True) == 1
    assert near.velocity == pytest.approx([20 * (1 - 2 / 8) ** 2 / 4, 0, 0])
    assert not far.enabled and not hidden.enabled
    assert world.radial_impulse((0, 0, 0), 8, 20) == 2
    assert hidden.velocity == pytest.approx([0, 20 * (1 - 4 / 8) / 4, 0])
    with pytest.raises(epode.RefusedError):
        world.radial_impulse((0, 0, 0), 0, 20)
    assert np.all(far.velocity == 0)
