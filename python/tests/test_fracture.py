# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Bodies that break, as a user of Python meets them."""
import pickle

import numpy as np
import pytest

import epode

H = 1 / 60


def bricks(world, n=(3, 3, 1), size=(0.3, 0.3, 0.05), centre=(0, 0, 0)):
    places = np.stack(np.meshgrid(*(np.arange(k) - (k - 1) / 2 for k in n), indexing="ij"), axis=-1).reshape(-1, 3)
    return [world.geom(epode.Box(*size), position=place * size + centre) for place in places]


def shoot(world, position, velocity, mass=2.0, radius=0.1):
    ball = world.body(mass=mass, shape=epode.Sphere(radius), position=position, velocity=velocity)
    ball.linear_damping = ball.angular_damping = 0
    return ball


def motion(bodies):
    """Momentum and angular momentum about the origin."""
    momentum = sum(b.mass * b.velocity for b in bodies)
    spin = sum(b.rotation @ b.inertia @ b.rotation.T @ b.angular_velocity + b.mass * np.cross(b.position, b.velocity) for b in bodies)
    return np.concatenate([momentum, spin])


def play(world, steps):
    broken = 0
    for _ in range(steps):
        broken += world.break_fractures()
        world.step(H)
    return broken


@pytest.mark.parametrize("phase", range(3))
@pytest.mark.parametrize("share", [0.999, 1.001])
def test_it_breaks_where_the_impulse_passes_the_strength(share, phase):
    """J = m M / (m + M) v of a ball that sticks to a free pane."""
    world = epode.World(defaults="game", gravity=(0, 0, 0))
    pane = world.fracture(bricks(world), density=2500)
    body, = pane.bodies
    body.linear_damping = body.angular_damping = 0
    assert body.mass == pytest.approx(2500 * 0.9 * 0.9 * 0.05) and body.geoms == list(pane.parts)
    m, M, v = 2.0, body.mass, 6.0
    pane.strength = share * m * M / (m + M) * v
    ball = shoot(world, (0, 0, 0.225 + 0.04 * phase), (0, 0, -v))
    broken = play(world, 20)
    assert broken == (share < 1) and len(pane.bodies) == (9 if share < 1 else 1)
    assert body.alive == (share > 1)
    if share > 1:
        assert ball.velocity[2] == pytest.approx(-(v - m * M / (m + M) * v / m), abs=1e-4)


def test_momentum_goes_over_to_the_pieces():
    world = epode.World(defaults="game", gravity=(0, 0, 0))
    densities = [1000.0 + 500 * (i % 3) for i in range(8)]
    block = world.fracture(bricks(world, (2, 2, 2), (0.3, 0.2, 0.1)), density=densities)
    body, = block.bodies
    assert body.mass == pytest.approx(sum(densities) * 0.3 * 0.2 * 0.1)
    body.velocity, body.angular_velocity = (1, 2, 3), (4, -5, 6)
    before = motion([body])
    assert block.break_up() == 7
    assert motion(block.bodies) == pytest.approx(before, abs=1e-10) and len(world.bodies) == 8
    assert all(part.body.geoms == [part] for part in block.parts)
    assert not body.alive and body not in list(world.bodies) and body.geoms == []


def test_a_hole_is_as_large_as_the_radius_and_what_is_left_stays_together():
    world = epode.World(defaults="game")
    world.plane()
    wall = world.fracture(bricks(world, (1, 7, 7), (0.2, 0.2, 0.2), (0, 0, 0.7)), density=2000, strength=60, radius=0.25)
    wall.bodies[0].kinematic = True
    ball = shoot(world, (-2, 0, 0.7), (20, 0, 1), mass=10)
    with world.record() as film:
        assert play(world, 60) >= 1
    largest = max(wall.bodies, key=lambda body: len(body.geoms))
    assert largest.kinematic and 30 <= len(largest.geoms) < 49 and largest.position == pytest.approx([0, 0, 0.7], abs=0.1)
    flown = [body for body in wall.bodies if body is not largest]
    assert 3 <= len(flown) <= 19 and all(not body.kinematic for body in flown) and ball.position[0] > 0.3
    assert len(film) == 61 and len(film.bodies(0)) == 2 and len(film.bodies(-1)) == len(world.bodies)


def test_breaks_are_taken_back_and_happen_again_with_the_same_bits():
    world = epode.World(defaults="game")
    world.plane()
    wall = world.fracture(bricks(world, (1, 5, 5), (0.2, 0.2, 0.2), (0, 0, 0.5)), density=2000, strength=60, radius=0.25)
    body, = wall.bodies
    body.kinematic = True
    shoot(world, (-2, 0, 0.5), (20, 0, 1), mass=10)
    world.history = 60
    assert play(world, 40) >= 1 and not body.alive
    after, pieces = world.bodies.position, wall.bodies
    world.roll_back(40)
    assert body.alive and wall.bodies == (body,) and len(body.geoms) == 25 and all(part.body is body for part in wall.parts)
    assert not any(piece.alive for piece in pieces)
    assert play(world, 40) >= 1
    assert np.array_equal(world.bodies.position, after) and len(wall.bodies) == len(pieces)


def test_a_fracture_that_was_made_is_taken_back():
    world = epode.World(defaults="game")
    world.history = 10
    parts = bricks(world)
    world.step(H)
    pane = world.fracture(parts)
    world.step(H)
    world.roll_back(1)
    assert pane.bodies == () and all(part.body is None and part.alive for part in parts) and len(world.bodies) == 0
    again = world.fracture(parts)
    assert len(again.bodies) == 1


def test_copies_break_as_the_original_does():
    world = epode.World(defaults="game")
    world.plane()
    wall = world.fracture(bricks(world, (1, 5, 5), (0.2, 0.2, 0.2), (0, 0, 0.5)), density=2000, strength=40, radius=0.25)
    for i in range(2):
        shoot(world, (-2 - 2 * i, 0.2 * i, 0.5), (20 + 10 * i, 0, 1), mass=10)
    assert play(world, 8) >= 1  # some pieces, and one more blow to come
    copies = [world.clone(), pickle.loads(pickle.dumps(world))]
    broken = [play(one, 40) for one in (world, *copies)]
    assert broken[0] >= 1 and broken == [broken[0]] * 3
    for copy in copies:
        twin, = copy.fractures
        assert np.array_equal(copy.bodies.position, world.bodies.position) and len(twin.bodies) == len(wall.bodies)
        assert [len(body.geoms) for body in twin.bodies] == [len(body.geoms) for body in wall.bodies]
        assert twin.strength == 40 and twin.radius == 0.25
    world.destroy()
    play(copies[0], 10)


def test_parts_that_are_destroyed_are_left_out():
    world = epode.World(defaults="game", gravity=(0, 0, 0))
    pane = world.fracture(bricks(world))
    pane.parts[4].destroy()
    assert len(pane.parts) == 8 and pane.alive and world.break_fractures() == 0
    assert pane.break_up(center=(0.3, 0.3, 0), radius=0.1) >= 1
    pane.destroy()
    assert not pane.alive and world.fractures == () and len(world.bodies) == 0 and world.geoms == []
    assert world.break_fractures() == 0


def test_a_body_with_geoms_that_are_no_parts_stays_whole():
    world = epode.World(defaults="game", gravity=(0, 0, 0))
    pane = world.fracture(bricks(world), strength=0.1)
    body, = pane.bodies
    body.add(epode.Sphere(0.1), offset=(0, 0, -2))
    with pytest.raises(epode.RefusedError, match=r"Fracture\.break_up"):
        pane.break_up()
    shoot(world, (0, 0, 0.2), (0, 0, -5))
    with pytest.raises(epode.RefusedError, match=r"World\.break_fractures"):
        play(world, 20)
    assert pane.bodies == (body,) and body.alive and len(body.geoms) == 10


def test_mistakes_are_refused_by_name_and_change_nothing():
    world, other = epode.World(), epode.World()
    parts = bricks(world, (2, 1, 1))
    for bad, kind, said in ((lambda: world.fracture([]), epode.RefusedError, r"World\.fracture"),
                            (lambda: world.fracture([parts[0], parts[0]]), epode.RefusedError, "two parts"),
                            (lambda: world.fracture(parts, density=-1), epode.RefusedError, "density"),
                            (lambda: world.fracture(parts, density=[1, 2, 3]), ValueError, "shape"),
                            (lambda: world.fracture(parts, strength=-1), ValueError, "strength is -1; 0 or more"),
                            (lambda: world.fracture(parts, radius=float("nan")), ValueError, "radius is nan"),
                            (lambda: world.fracture([world.plane()]), epode.RefusedError, "World"),
                            (lambda: world.fracture(["geom"]), TypeError, "parts: geoms"),
                            (lambda: world.fracture(bricks(other)), epode.RefusedError, "another world")):
        with pytest.raises(kind, match=said):
            bad()
    assert len(world.bodies) == 0 and world.fractures == () and all(part.body is None for part in parts)
    pane = world.fracture(parts)
    with pytest.raises(epode.RefusedError, match="on a body"):
        world.fracture(parts)
    with pytest.raises(ValueError, match="strength"):
        pane.strength = float("nan")
    with pytest.raises(epode.RefusedError, match="none of this Fracture"):
        pane.break_up(world.body(mass=1))
    with pytest.raises(ValueError, match="center: 3 numbers"):
        pane.break_up(center=(1, 2))
    with pytest.raises(ValueError, match="rows of"):
        epode.c.dFractureUpdate(world._handle, [(pane._list(), 1.0)])
    assert len(pane.bodies) == 1 and "2 parts in 1 bodies" in repr(pane)
    world.destroy()
    assert not pane.alive
    with pytest.raises(epode.DeadHandleError):
        world.break_fractures()
