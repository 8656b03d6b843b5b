# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Vehicles, and functions of manifolds, as a user of Python meets them."""
import pickle

import numpy as np
import pytest

import epode

H = 1 / 60


def car(world, **settings):
    vehicle = world.vehicle(shape=epode.Box(4, 1.6, 0.5), mass=1200, position=(0, 0, 0.65), **settings)
    for i in range(4):
        vehicle.add_wheel((1.3 if i < 2 else -1.3, -0.75 if i % 2 else 0.75, -0.4), axle=i // 2, steer=float(i < 2), drive=float(i >= 2),
                          handbrake_torque=3000.0 * (i >= 2))
    return vehicle


def drive(vehicle, seconds):
    for _ in range(round(seconds / H)):
        vehicle.update(H)
        vehicle.world.step(H)


@pytest.fixture
def world():
    with epode.World() as w:
        w.plane()
        yield w


def test_a_car_drives_off_shifts_and_brakes(world):
    vehicle = car(world)
    vehicle.throttle = 1
    drive(vehicle, 10)
    assert vehicle.speed == pytest.approx(39, abs=1) and vehicle.gear == 4 and vehicle.wheels_on_ground == 4
    assert abs(vehicle.position[1]) < 0.01
    vehicle.control(throttle=0, brake=1)
    drive(vehicle, 8)
    assert vehicle.speed == pytest.approx(0, abs=0.01)


def test_wheels_report_what_they_do(world):
    vehicle = car(world)
    drive(vehicle, 2)
    assert vehicle.wheel_values("load") == pytest.approx(np.full(4, 300 * 9.81), rel=0.02)
    assert vehicle.wheel_values("hub").shape == (4, 3) and vehicle.wheel_values("hub")[:, 2] == pytest.approx(np.full(4, 0.33), abs=0.01)
    wheel = vehicle.wheels[2]
    assert wheel == vehicle.wheels[2] and wheel.on_ground and wheel.ground is world.geoms[0]
    assert wheel.compression == pytest.approx(300 * 9.81 / 30000, rel=0.05) and wheel.ground_normal == pytest.approx([0, 0, 1])
    assert vehicle.wheel_values("drive").tolist() == [0, 0, 1, 1]
    with pytest.raises(ValueError, match="wheels have no numbers called 'colour'"):
        vehicle.wheel_values("colour")


def test_settings_are_kept(world):
    vehicle = car(world, kind=epode.VehicleKind.CAR, max_steer=0.5, differential=epode.Differential.LOCKED, automatic=False, abs=True,
                  engine_curve=[(0, 100), (300, 200), (600, 150)], gear_ratios=(3, 2, 1))
    assert vehicle.max_steer == 0.5 and vehicle.differential is epode.Differential.LOCKED and vehicle.abs and not vehicle.automatic
    assert vehicle.engine_curve.tolist() == [[0, 100], [300, 200], [600, 150]] and vehicle.gear_ratios.tolist() == [3, 2, 1]
    wheel = vehicle.wheels[0]
    wheel.stiffness, wheel.cast, wheel.position = 50000, epode.WheelCast.SPHERE, (1.4, 0.8, -0.4)
    assert (wheel.stiffness, wheel.cast) == (50000, epode.WheelCast.SPHERE) and wheel.position == pytest.approx([1.4, 0.8, -0.4])
    assert vehicle.forward == pytest.approx([1, 0, 0]) and vehicle.kind is epode.VehicleKind.CAR
    vehicle.gear = 2
    drive(vehicle, 0.5)
    assert vehicle.gear == 2


def test_refusals_name_the_call(world):
    with pytest.raises(epode.RefusedError, match=r"World\.vehicle"):
        car(world, max_steer=3)
    assert world.bodies.position.shape == (0, 3) and len(world.geoms) == 1
    with pytest.raises(TypeError, match="a vehicle has no doors"):
        world.vehicle(mass=3, doors=4)
    with pytest.raises(ValueError, match="engine_curve: 2 to 16 rows"):
        world.vehicle(mass=3, engine_curve=[1, 2])
    with pytest.raises(ValueError, match="gear_ratios: 1 to 10 numbers"):
        world.vehicle(mass=3, gear_ratios=[])
    vehicle = car(world)
    with pytest.raises(TypeError, match="a wheel has no spokes"):
        vehicle.add_wheel((0, 0, 0), spokes=32)
    with pytest.raises(epode.RefusedError, match=r"Vehicle\.add_wheel\(position=\(0, 0, 0\)"):
        vehicle.add_wheel((0, 0, 0), radius=-1)
    with pytest.raises(epode.RefusedError, match=r"Vehicle\.throttle = 2"):
        vehicle.throttle = 2
    with pytest.raises(epode.RefusedError, match=r"Vehicle\.update\(h=0"):
        vehicle.update(0)
    assert len(vehicle.wheels) == 4 and vehicle.throttle == 0


def test_copies_go_on_with_the_same_bits(world):
    vehicle = car(world, differential=epode.Differential.LIMITED)
    vehicle.control(throttle=0.7, steer=0.2)
    drive(vehicle, 2)
    state, copies = world.save(), [world.clone(), pickle.loads(pickle.dumps(world))]
    drive(vehicle, 2)
    after = vehicle.position
    for copy in copies:
        twin = copy.geoms[-1].body
        assert isinstance(twin, epode.Vehicle) and twin.throttle == 0.7 and twin.differential is epode.Differential.LIMITED
        drive(twin, 2)
        assert np.array_equal(twin.position, after) and twin.gear == vehicle.gear
        assert np.array_equal(twin.wheel_values("spin"), vehicle.wheel_values("spin"))
    world.load(state)
    drive(vehicle, 2)
    assert np.array_equal(vehicle.position, after)


def test_a_bike_leans_and_tracks_turn_on_the_spot(world):
    bike = world.vehicle(kind=epode.VehicleKind.BIKE, shape=epode.Box(1.4, 0.3, 0.5), mass=250, position=(0, 0, 0.55), steer_speed=0.1)
    for x in (0.7, -0.7):
        bike.add_wheel((x, 0, -0.25), axle=int(x < 0), steer=float(x > 0), drive=float(x < 0), travel=0.15, stiffness=20000)
    bike.velocity, bike.steer = (12, 0, 0), 0.05
    drive(bike, 4)
    lean = np.arctan(bike.speed * bike.angular_velocity[2] / 9.81)
    assert lean > 0.1 and bike.lean == pytest.approx(-lean, rel=0.03)

    tank = world.vehicle(kind=epode.VehicleKind.TRACKED, shape=epode.Box(4, 2, 0.6), mass=1200, position=(50, 50, 0.75), final_ratio=15,
                         differential=epode.Differential.LOCKED, automatic=False)
    for i in range(8):
        tank.add_wheel((1.2 - 0.8 * (i // 2), 0.9 if i % 2 == 0 else -0.9, -0.4), axle=i // 2, drive=1.0, stiffness=20000, nominal_load=1500)
    tank.control(throttle=0.5, steer=1)
    drive(tank, 3)
    assert tank.angular_velocity[2] > 0.3 and np.linalg.norm(tank.velocity) < 0.5
    assert tank.wheels[1].spin > 5 and tank.wheels[0].spin == pytest.approx(-tank.wheels[1].spin, rel=0.05)


def test_destroyed_vehicles_raise(world):
    vehicle = car(world)
    vehicle.destroy()
    with pytest.raises(epode.DeadHandleError):
        vehicle.update(H)
    with pytest.raises(epode.DeadHandleError):
        vehicle.wheels


def test_a_function_sees_and_changes_manifolds(world):
    ground = world.geoms[0]
    belt = world.body(shape=epode.Box(0.5, 0.5, 0.5), mass=1, position=(0, 0, 0.25))
    ghost = world.body(shape=epode.Box(0.5, 0.5, 0.5), mass=1, position=(2, 0, 0.25))
    seen = set()

    def change(one, other, manifold):
        seen.add((one, other, manifold.count))
        assert manifold.pos.shape == (manifold.count, 3) and manifold.depth.shape == (manifold.count,)
        if one is ghost.geoms[0]:
            manifold.accept = 0
        else:
            manifold.surface_velocity, manifold.friction = (-1, 0, 0), 1.0
    world.on_manifold(change)
    world.step(H, steps=60)
    assert (belt.geoms[0], ground, 4) in seen
    assert belt.velocity == pytest.approx([1, 0, 0], abs=0.02) or belt.velocity == pytest.approx([-1, 0, 0], abs=0.02)
    assert ghost.position[2] < -3
    world.on_manifold(None)
    world.step(H, steps=60)
    assert belt.velocity == pytest.approx([0, 0, 0], abs=0.02)


def test_an_exception_in_a_function_of_manifolds_is_raised_after_the_step(world):
    world.body(shape=epode.Sphere(0.5), mass=1, position=(0, 0, 0.5))
    world.on_manifold(lambda one, other, manifold: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        world.step(H)
    copy = world.clone()
    world.destroy()
    copy.step(H)
