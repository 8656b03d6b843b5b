// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Vehicles that go straight: engine, gears, brakes, the air.
#include "road.h"

#ifdef dIDEDOUBLE  // the bounds are those of doubles

namespace epode::vehicles {
namespace {

class Driving : public EveryStep {};
INSTANTIATE_TEST_SUITE_P(steps, Driving, kSteps, step_name);

// An engine of the same torque at every speed, so that forces have closed forms.
dVehicleSettings flat_engine(double torque)
{
    dVehicleSettings s = plain_settings();
    s.torque_points = 2;
    s.engine_speeds[0] = 0, s.engine_speeds[1] = 1000;
    s.engine_torques[0] = s.engine_torques[1] = dReal(torque);
    return s;
}

// v^2 / (2 mu g) with all wheels locked, and with ABS, which leaves 99 % of mu.
TEST_P(Driving, stops_in_the_distance_of_the_books)
{
    for (const int abs : {0, 1}) {
        Road road;
        road.flat();
        Wheels wheels;
        wheels.like.brake_torque = 20000;
        dVehicleSettings s = plain_settings();
        s.abs = abs;
        const dBodyID car = road.car(wheels, s, 25);
        dVehicleSetGear(car, 0);
        road.run(car, 1, h());  // the wheels turn
        const double x = x_of(car), v = speed(car);
        drive(car, 0, 1);
        double slowest = 1e9;
        for (double t = 0; t < 5; t += h()) {
            dVehicleUpdate(car, dReal(h()));
            dWorldStep(road.world, dReal(h()));
            if (speed(car) > 5) slowest = std::min(slowest, double(wheel(car, 0).spin));
        }
        // The brakes stop the wheels, too, where these turn.
        const double a = abs ? 0.99 * kG * kMass / (kMass + 4 / (kRadius * kRadius)) : kG;
        EXPECT_NEAR(x_of(car) - x, v * v / (2 * a), 0.02 * v * v / (2 * a)) << abs;
        EXPECT_LT(speed(car), 1e-3);
        if (abs) {
            EXPECT_GT(slowest, 5);
        } else {
            EXPECT_NEAR(slowest, 0, 0.1);
        }
    }
}

// After a stop with locked wheels it goes back by what its springs were pitched and by what treads give back that have slid: 2 - 2^(2/3) of
// the deflection with which they begin to (vehicles/tyre.h).
TEST_P(Driving, rocks_back_a_little_from_locked_wheels)
{
    Road road;
    road.flat();
    Wheels wheels;
    wheels.like.brake_torque = 20000;
    const dBodyID car = road.car(wheels, plain_settings(), 20);
    dVehicleSetGear(car, 0);
    road.run(car, 1, h());
    drive(car, 0, 1);
    double farthest = x_of(car), backward = 0;
    for (double t = 0; t < 5; t += h()) {
        road.run(car, h(), h());
        farthest = std::max(farthest, x_of(car));
        backward = std::min(backward, double(dBodyGetLinearVel(car)[0]));
    }
    const double high = Road::height(wheels.like),
                 pitch = kMass * kG * high / (kBase * kBase * wheels.like.stiffness);
    const double tread = (2 - std::cbrt(4)) * 3 * wheels.like.relaxation / wheels.like.stiffness_x;
    EXPECT_NEAR(farthest - x_of(car), high * pitch + tread, 0.002);
    EXPECT_GT(backward, -0.5);
    EXPECT_LT(speed(car), 1e-3);
}

// m' v' = -f m g with m' = m + sum I / R^2.
TEST_P(Driving, coasts_down_by_rolling_resistance)
{
    Road road;
    road.flat();
    Wheels wheels;
    wheels.like.rolling_resistance = dReal(0.02);
    const dBodyID car = road.car(wheels, plain_settings(), 20);
    dVehicleSetGear(car, 0);
    road.run(car, 2, h());
    const double v = speed(car);
    road.run(car, 10, h());
    const double a = 0.02 * kMass * kG / (kMass + 4 / (kRadius * kRadius));
    EXPECT_NEAR(v - speed(car), 10 * a, 0.005 * 10 * a);
    road.run(car, 100, 1.0 / 60);
    EXPECT_LT(speed(car), 1e-4);  // and it does not roll back
}

// (m + sum I/R^2 + I_e G^2 / R^2) a = T G / R in each gear.
TEST_P(Driving, accelerates_in_each_gear_as_its_ratio_says)
{
    for (const int gear : {-1, 1, 2, 3, 4, 5}) {
        Road road;
        road.flat();
        dVehicleSettings s = flat_engine(100);
        const double G = (gear < 0 ? -s.reverse_ratio : s.gear_ratios[gear - 1]) * s.final_ratio,
                     v0 = gear < 0 ? -5 : 10;
        const dBodyID car = road.car({}, s, v0);
        dVehicleSetGear(car, gear);
        drive(car, 1);
        road.run(car, 2, h());  // until the clutch holds
        const double v = dBodyGetLinearVel(car)[0], w = report(car).engine_speed;
        EXPECT_NEAR(w, wheel(car, 2).spin * G, 1e-3 * w);
        road.run(car, 1, h());
        const double m = kMass + 4 / (kRadius * kRadius) + s.engine_inertia * G * G / (kRadius * kRadius);
        EXPECT_NEAR(dBodyGetLinearVel(car)[0] - v, 100 * G / kRadius / m,
                    std::fabs(0.015 * 100 * G / kRadius / m))
            << gear;
        EXPECT_EQ(report(car).gear, gear);
    }
}

// T G / R = c v^2 + f m g.
TEST(DrivingFast, reaches_the_speed_at_which_drag_takes_the_drive)
{
    Road road;
    road.flat();
    dVehicleSettings s = flat_engine(150);
    s.drag = dReal(0.5);
    Wheels wheels;
    wheels.like.rolling_resistance = dReal(0.015);
    const dBodyID car = road.car(wheels, s, 45);
    dVehicleSetGear(car, 5);
    drive(car, 1);
    road.run(car, 200, 1.0 / 60);
    const double G = s.gear_ratios[4] * s.final_ratio;
    EXPECT_NEAR(speed(car), std::sqrt((150 * G / kRadius - 0.015 * kMass * kG) / 0.5), 0.05);
    EXPECT_NEAR(dBodyGetPosition(car)[1], 0, 1e-6);
}

// On a slope of 20 % the handbrake of the rear wheels holds it, asleep or not; released, it rolls.
TEST_P(Driving, stays_parked_on_a_slope_without_creeping)
{
    for (const bool sleeps : {false, true}) {
        Road road(std::atan(0.2), dDefaultsGame);
        road.flat();
        dWorldSetAutoDisableFlag(road.world, sleeps);
        Wheels wheels;
        wheels.like.handbrake_torque = 3000;
        const dBodyID car = road.car(wheels);
        dVehicleSetGear(car, 0);
        drive(car, 0, 0, 0, 1);
        road.run(car, 6, h());
        const double x = x_of(car), z = z_of(car);
        EXPECT_EQ(dBodyIsEnabled(car), !sleeps);
        road.run(car, h() < 0.002 ? 10 : 60, h());
        EXPECT_NEAR(x_of(car), x, 1e-6);
        EXPECT_NEAR(z_of(car), z, 1e-6);
        EXPECT_EQ(report(car).wheels_on_ground, 4);
        drive(car, 0);
        road.run(car, 1, h());
        EXPECT_EQ(dBodyIsEnabled(car), 1);
        EXPECT_NEAR(x_of(car) - x, -0.5 * kG * std::sin(std::atan(0.2)), 0.15);
    }
}

// Across the slope the tyres hold it by themselves, the more so at rest.
TEST(DrivingSlowly, stays_parked_across_a_slope)
{
    Road road;
    dWorldSetGravity(road.world, 0, dReal(-kG * 0.3), dReal(-kG * 0.95));
    road.flat();
    const dBodyID car = road.car();
    dVehicleSetGear(car, 0);
    road.run(car, 6, 1.0 / 60);
    const double y = dBodyGetPosition(car)[1];
    road.run(car, 60, 1.0 / 60);
    EXPECT_NEAR(dBodyGetPosition(car)[1], y, 1e-5);
    EXPECT_NEAR(x_of(car), 0, 1e-4);
}

TEST(Gearbox, shifts_up_and_down_by_itself_and_rests_at_idle)
{
    Road road;
    road.flat();
    dVehicleSettings s;
    dVehicleSettingsInit(&s, sizeof s);
    const dBodyID car = road.car({}, s);
    drive(car, 1);
    int highest = 0, before = 1;
    for (int i = 0; i < 60 * 30; ++i) {
        road.run(car, 1.0 / 60, 1.0 / 60);
        const dVehicleReport r = report(car);
        EXPECT_LE(std::abs(r.gear - before), 1);
        before = r.gear, highest = std::max(highest, r.gear);
        EXPECT_LT(r.engine_speed, 1.03 * 650);
        EXPECT_TRUE(!r.is_shifting || r.clutch_torque == 0);
    }
    EXPECT_GE(highest, 4);
    drive(car, 0, 1);
    road.run(car, 20, 1.0 / 60);
    EXPECT_EQ(report(car).gear, 1);
    EXPECT_NEAR(report(car).engine_speed, 90, 1);
    EXPECT_LT(speed(car), 1e-3);
}

// Full throttle with ten times the torque that the rear tyres take: they spin, and it drives at what they hold.
TEST_P(Driving, shifts_by_the_speed_of_the_road_while_its_wheels_spin)
{
    Road road;
    road.flat();
    dVehicleSettings s;
    dVehicleSettingsInit(&s, sizeof s);
    for (int i = 0; i < s.torque_points; ++i) s.engine_torques[i] *= 5;
    s.clutch_torque *= 5, s.drag = 0;
    const dBodyID car = road.car({}, s);
    road.run(car, 1, h());
    drive(car, 1);
    int shifts = 0, before = 1;
    for (double t = 0; t < 4; t += h()) {
        road.run(car, h(), h());
        const dVehicleReport r = report(car);
        shifts += r.gear != before, before = r.gear;
        EXPECT_TRUE(t < 0.5 || t > 1.5 || std::max(wheel(car, 2).slip, wheel(car, 3).slip) > 1) << t;
    }
    // The load of the rear axle grows by m a z / base.
    const double high = Road::height(Wheels{}.like), a = kG / 2 / (1 - high / kBase);
    EXPECT_LE(shifts, 2);
    EXPECT_GT(speed(car), 0.85 * a * 4);  // without drive while it shifts and starts
    EXPECT_LT(speed(car), a * 4 + 1);
}

// Ice under the left wheels: an open differential gives the right one no more than the left one has.
TEST(Differentials, divide_the_torque_as_their_kind_says)
{
    double force[4] = {};
    for (const int kind : {dDifferentialOpen, dDifferentialLimited, dDifferentialLocked}) {
        Road road;
        const dGeomID ice = dCreateBox(road.space, 200, 10, 1), tar = dCreateBox(road.space, 200, 10, 1);
        dGeomSetPosition(ice, 0, 5, dReal(-0.5)), dGeomSetPosition(tar, 0, -5, dReal(-0.5));
        dMaterial slippery;
        dMaterialInit(&slippery, sizeof slippery);
        slippery.friction = dReal(0.06);  // a tenth of the default's
        dGeomSetMaterial(ice, &slippery);
        dVehicleSettings s = flat_engine(150);
        s.differential = kind, s.lock_torque = 400;
        const dBodyID car = road.car({}, s);
        drive(car, 1);
        road.run(car, 1.5, 1.0 / 240);
        const dVehicleWheelReport left = wheel(car, 2), right = wheel(car, 3);
        EXPECT_NEAR(left.force_x, 0.1 * left.load, 0.03 * left.load);
        force[kind] = right.force_x;
        EXPECT_TRUE(kind != dDifferentialLocked || std::fabs(left.spin - right.spin) < 1e-2 * right.spin);
        EXPECT_TRUE(kind != dDifferentialOpen || left.spin > 3 * right.spin);
    }
    EXPECT_LT(force[dDifferentialOpen], 2 * 0.1 * 3600);  // the left one speeds up, which takes torque too
    EXPECT_NEAR(force[dDifferentialLimited] - force[dDifferentialOpen], 2 * 400 / kRadius,
                0.1 * 2 * 400 / kRadius);
    EXPECT_GT(force[dDifferentialLocked], force[dDifferentialLimited]);
}

// Shafts, tyres and brakes are solved together to the end, whatever the driver does; sweeps alone leave 5e-5 rad/s at 60 Hz.
TEST_P(Driving, keeps_what_is_locked_at_one_speed)
{
    for (const double brakes : {0.3, 1.0}) {
        Road road;
        road.flat();
        dVehicleSettings s;
        dVehicleSettingsInit(&s, sizeof s);
        s.differential = s.centre_differential = dDifferentialLocked;
        Wheels wheels;
        wheels.like.drive = 1;
        const dBodyID car = road.car(wheels, s);
        double apart = 0, fastest = 0;
        for (double t = 0; t < 10; t += h()) {
            const int phase = int(t / 2) % 4;
            drive(car, phase < 2, phase == 3 ? brakes : 0, 0.5 * std::sin(t));
            road.run(car, h(), h());
            apart = std::max(apart, std::fabs(double(wheel(car, 2).spin - wheel(car, 3).spin)));
            fastest = std::max(fastest, double(wheel(car, 2).spin));
        }
        EXPECT_LT(apart, 1e-9) << brakes;
        EXPECT_GT(fastest, 20);
    }
}

// All four wheels: the front ones share by their weights.
TEST(Differentials, share_the_drive_between_axles_by_weights)
{
    Road road;
    road.flat();
    Wheels wheels;
    wheels.like.drive = 1;
    const dBodyID car = road.car(wheels, flat_engine(100), 10);
    for (const int i : {0, 1}) {
        dVehicleWheel w;
        w.struct_size = sizeof w;
        ASSERT_EQ(dVehicleGetWheel(car, i, &w), 1);
        w.drive = 3;
        ASSERT_EQ(dVehicleSetWheel(car, i, &w), 1);
    }
    dVehicleSetGear(car, 3);
    drive(car, 1);
    road.run(car, 2, 1.0 / 240);
    const double v = speed(car);
    road.run(car, 0.1, 1.0 / 240);
    const double a = (speed(car) - v) / 0.1;
    for (int i = 0; i < 4; ++i) {
        // Of the torque each wheel takes I w' for itself.
        const double own = a / (kRadius * kRadius);
        const double all = wheel(car, 0).force_x + wheel(car, 1).force_x + wheel(car, 2).force_x +
                           wheel(car, 3).force_x + 4 * own;
        EXPECT_NEAR(wheel(car, i).force_x + own, all * (i < 2 ? 3.0 : 1.0) / 8, 0.02 * all);
    }
}

// The car and the plate that it stands on have the momentum that they had, while it starts, turns and brakes.
TEST_P(Driving, gives_the_ground_what_it_gets)
{
    Road road;
    const dGeomID floor = dCreatePlane(road.space, 0, 0, 1, -1);
    dMaterial smooth;
    dMaterialInit(&smooth, sizeof smooth);
    smooth.friction = 0, smooth.priority = 1;
    dGeomSetMaterial(floor, &smooth);
    const dBodyID plate = dBodyCreate(road.world);
    dMass m;
    dMassSetBoxTotal(&m, 3000, 60, 60, 1);
    dBodySetMass(plate, &m);
    dGeomSetBody(dCreateBox(road.space, 60, 60, 1), plate);
    dBodySetPosition(plate, 0, 0, dReal(-0.5));
    const dBodyID car = road.car();
    road.run(car, 1, h());
    const auto momentum = [&](int axis) {
        return kMass * dBodyGetLinearVel(car)[axis] + 3000 * dBodyGetLinearVel(plate)[axis];
    };
    const double px = momentum(0), py = momentum(1);
    double fastest = 0;
    for (int phase = 0; phase < 4; ++phase) {
        drive(car, phase < 2 ? 0.6 : 0, phase == 3, phase == 1 ? 0.5 : phase == 2 ? -0.5 : 0);
        road.run(car, 1, h());
        fastest = std::max(fastest, speed(car));
        EXPECT_NEAR(momentum(0), px, 1e-6);
        EXPECT_NEAR(momentum(1), py, 1e-6);
    }
    EXPECT_GT(fastest, 2);
    EXPECT_GT(std::fabs(dBodyGetPosition(plate)[0]), 0.5);
}

}  // namespace
}  // namespace epode::vehicles
#endif
