// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Vehicles in curves: geometry of steering, the bicycle model, bikes that lean, tracks; and that none of it depends on
// the step or the stepper.
#include "road.h"

#include <algorithm>

#ifdef dIDEDOUBLE  // the bounds are those of doubles

namespace epode::vehicles {
namespace {

class Cornering : public EveryStep {};
INSTANTIATE_TEST_SUITE_P(steps, Cornering, kSteps, step_name);

// cot(outer) - cot(inner) = t / L, and their mean is that of the bicycle model.
TEST(Steering, points_all_axles_to_one_centre)
{
    Road road;
    road.flat();
    const dBodyID car = road.car();
    drive(car, 0, 0, 0.5);
    road.run(car, 1, 1.0 / 60);
    const double left = wheel(car, 0).steer, right = wheel(car, 1).steer;
    EXPECT_GT(left, right);
    EXPECT_NEAR(1 / std::tan(right) - 1 / std::tan(left), kTrack / kBase, 1e-6);
    EXPECT_NEAR((1 / std::tan(right) + 1 / std::tan(left)) / 2, 1 / std::tan(0.3), 1e-6);
    EXPECT_NEAR(report(car).curvature, std::tan(0.3) / kBase, 1e-6);
    EXPECT_EQ(wheel(car, 2).steer, 0);
    dVehicleSettings s = plain_settings();
    s.ackermann = 0;
    ASSERT_EQ(dVehicleSetSettings(car, &s), 1);
    road.run(car, 0.1, 1.0 / 60);
    EXPECT_EQ(wheel(car, 0).steer, wheel(car, 1).steer);
    EXPECT_NEAR(wheel(car, 0).steer, 0.3, 1e-6);
}

TEST(Steering, is_as_fast_as_it_says)
{
    Road road;
    road.flat();
    const dBodyID car = road.car();
    drive(car, 0, 0, 1);
    road.run(car, 0.1, 1.0 / 60);
    EXPECT_NEAR(report(car).steer, 0.2, 1e-6);
    road.run(car, 0.5, 1.0 / 60);
    EXPECT_NEAR(report(car).steer, 0.6, 1e-6);
}

// Slowly: the radius of the geometry.
TEST_P(Cornering, follows_its_wheels_when_it_is_slow)
{
    Road road;
    road.flat();
    const dBodyID car = road.car({}, plain_settings(), 1);
    dVehicleSetGear(car, 0);
    drive(car, 0, 0, 0.5);
    road.run(car, 3, h());
    const double yaw = dBodyGetAngularVel(car)[2], v = speed(car);
    // The centre of mass is L/2 before the rear axle.
    const double R = std::hypot(1 / report(car).curvature, kBase / 2);
    EXPECT_NEAR(v / yaw, R, 0.01 * R);
}

// r = v delta / (L + K v^2), K = L/g (1/c_f - 1/c_r) / L of the bicycle model, where c is what is left of the stiffness in the slip
// that a_y = v r takes.
TEST_P(Cornering, understeers_as_its_tyres_say)
{
    for (const double rear : {12.0, 16.0, 10.0}) {
        Road road;
        road.flat();
        const dBodyID car = road.car({}, plain_settings(), 20);
        dVehicleSetGear(car, 0);
        for (int i = 0; i < 4; ++i) {
            dVehicleWheel w;
            w.struct_size = sizeof w;
            dVehicleGetWheel(car, i, &w);
            w.stiffness_y = dReal(i < 2 ? 12 : rear);
            ASSERT_EQ(dVehicleSetWheel(car, i, &w), 1);
        }
        drive(car, 0, 0, 0.01 / 0.6);
        road.run(car, 6, h());
        const double v = speed(car), yaw = dBodyGetAngularVel(car)[2], a = v * yaw;
        // a / g = c alpha (1 - z + z^2/3), z = c alpha / 3
        const auto slip = [&](double c) {
            double alpha = a / kG / c;
            for (int i = 0; i < 50; ++i) {
                const double z = c * alpha / 3;
                alpha = a / kG / (c * (1 - z + z * z / 3));
            }
            return alpha;
        };
        const double delta = kBase * yaw / v + slip(12) - slip(rear);
        EXPECT_NEAR(delta, 0.01, 2e-4) << rear;
        EXPECT_NEAR(-wheel(car, 2).slip_angle, slip(rear), 0.03 * slip(rear)) << rear;
    }
}

// No more than mu g, whatever it steers.
TEST_P(Cornering, slides_at_the_limit_of_friction)
{
    Road road;
    road.flat();
    const dBodyID car = road.car({}, plain_settings(), 25);
    dVehicleSetGear(car, 0);
    road.run(car, 0.5, h());
    drive(car, 0, 0, 1);
    double largest = 0;
    for (double t = 0; t < 2; t += h()) {
        const double vx = dBodyGetLinearVel(car)[0], vy = dBodyGetLinearVel(car)[1];
        road.run(car, h(), h());
        largest = std::max(largest,
                           std::hypot(dBodyGetLinearVel(car)[0] - vx, dBodyGetLinearVel(car)[1] - vy) / h());
        for (int i = 0; i < 4; ++i) {
            const dVehicleWheelReport w = wheel(car, i);
            EXPECT_LE(std::hypot(w.force_x, w.force_y), w.load * (1 + 1e-4));
        }
    }
    EXPECT_GT(largest, 0.7 * kG);
    EXPECT_LT(largest, 1.05 * kG);
    EXPECT_GT(dBodyGetRotation(car)[10], 0.9);  // upright
}

struct End {
    double x, y, yaw, v;
};

End slalom(double h, int stepper, int cast = dWheelRay)
{
    Road road;
    road.flat();
    Wheels wheels;
    wheels.like.cast = cast;
    dVehicleSettings s;
    dVehicleSettingsInit(&s, sizeof s);
    const dBodyID car = road.car(wheels, s, 0);
    for (int i = 0; i * h < 8 - h / 2; ++i) {
        const double t = i * h;
        drive(car, t < 5 ? 0.5 : 0, t > 6 ? 0.6 : 0, 0.15 * std::sin(1.5 * t));
        dVehicleUpdate(car, dReal(h));
        step_by(road.world, h, stepper);
    }
    const dReal* R = dBodyGetRotation(car);
    return {x_of(car), dBodyGetPosition(car)[1], std::atan2(R[4], R[0]), speed(car)};
}

TEST(Convergence, goes_the_same_way_with_every_step_size)
{
    const End fine = slalom(1.0 / 2000, 0);
    double before = 1e9;
    for (const double h : {1.0 / 60, 1.0 / 240, 1.0 / 1000}) {
        const End end = slalom(h, 0);
        const double off = std::hypot(end.x - fine.x, end.y - fine.y);
        EXPECT_LT(off, h * 60 * 0.015 * fine.x);
        EXPECT_NEAR(end.yaw, fine.yaw, h * 60 * 0.06);
        EXPECT_LT(off, 0.6 * before);
        before = off;
    }
    EXPECT_GT(fine.x, 40);
}

TEST(Convergence, goes_the_same_way_with_every_stepper_and_kind_of_wheel)
{
    const End exact = slalom(1.0 / 60, 0);
    for (int stepper = 1; stepper < kSteppers; ++stepper) {
        const End end = slalom(1.0 / 60, stepper);
        EXPECT_LT(std::hypot(end.x - exact.x, end.y - exact.y), 0.02) << stepper;
    }
    for (const int cast : {dWheelSphere, dWheelCylinder}) {
        const End end = slalom(1.0 / 60, 0, cast);
        EXPECT_LT(std::hypot(end.x - exact.x, end.y - exact.y), cast == dWheelSphere ? 0.1 : 0.4) << cast;
    }
}

dBodyID bike(const Road& road, double speed, const dVehicleSettings* given = nullptr)
{
    dVehicleSettings s = plain_settings();
    if (given) s = *given;
    s.kind = dVehicleBike, s.steer_speed = dReal(0.1);
    const dBodyID body = dBodyCreate(road.world);
    dMass m;
    dMassSetBoxTotal(&m, 220, dReal(1.6), dReal(0.3), dReal(0.8));
    dBodySetMass(body, &m);
    const dGeomID geom = dCreateBox(road.space, dReal(1.2), dReal(0.2), dReal(0.4));
    dGeomSetBody(geom, body);
    dGeomSetOffsetPosition(geom, 0, 0, dReal(0.1));
    dBodySetPosition(body, 0, 0, dReal(0.65));
    dBodySetLinearVel(body, dReal(speed), 0, 0);
    EXPECT_EQ(dVehicleCreate(body, &s), 1);
    for (int i = 0; i < 2; ++i) {
        dVehicleWheel w = Wheels().like;
        w.position[0] = dReal(i ? -0.7 : 0.7), w.position[2] = dReal(-0.35);
        w.axle = i, w.steer = dReal(i == 0), w.drive = dReal(i == 1), w.travel = dReal(0.15);
        w.stiffness = 20000, w.bump_damping = w.rebound_damping = 1500, w.nominal_load = 1000,
        w.brake_torque = 200, w.radius = dReal(0.3), w.brake_torque = 200;
        EXPECT_EQ(dVehicleAddWheel(body, &w), i + 1);
    }
    return body;
}

// tan(lean) = v r / g, that is v^2 / (R g), to the inside.
TEST_P(Cornering, leans_a_bike_into_its_curve)
{
    for (const double steer : {0.03, -0.04}) {
        Road road;
        road.flat();
        const dBodyID body = bike(road, 15);
        dVehicleSetGear(body, 0);
        road.run(body, 1, h());  // the wheels turn
        drive(body, 0, 0, steer);
        road.run(body, 4, h());
        const double v = speed(body), yaw = dBodyGetAngularVel(body)[2], lean = report(body).lean;
        EXPECT_GT(std::fabs(lean), 0.15);
        EXPECT_NEAR(std::tan(lean), -v * yaw / kG, 0.02 * std::fabs(std::tan(lean)));
        EXPECT_EQ(report(body).wheels_on_ground, 2);
        drive(body, 0, 0, 0);
        road.run(body, 3, h());
        EXPECT_NEAR(report(body).lean, 0, 1e-2);
        drive(body, 0, 1, 0);
        road.run(body, 6, h());
        EXPECT_NEAR(report(body).lean, 0, 1e-3);  // and stands
        EXPECT_LT(speed(body), 1e-3);
    }
}

// A rider looks 6 m ahead at a sine of 2 m and 36 m, and leans by about 0.5 rad to and fro. Unless leans have a bounded
// acceleration the wheels slide away under the bike at 60 Hz.
struct Slalom {
    double x, largest_lean, largest_error;
};

Slalom ride_slalom(double h)
{
    Road road;
    road.flat();
    dVehicleSettings s = plain_settings();
    s.kind = dVehicleBike;
    const dBodyID body = bike(road, 14, &s);
    dVehicleGetSettings(body, &s);
    s.steer_speed = 1;
    dMass light;
    dMassSetBoxTotal(&light, 170, dReal(1.1), dReal(0.25), dReal(0.45));
    dBodySetMass(body, &light);
    dVehicleSetSettings(body, &s);
    dVehicleSetGear(body, 0);
    road.run(body, 1, h);  // the wheels turn
    const auto path = [](double x) { return x < 27 ? 0 : 2 * std::sin(M_PI * (x / 18 - 1.5)); };
    Slalom out{};
    for (int i = 0; i < int(6 / h); ++i) {
        const dReal* p = dBodyGetPosition(body);
        dVector3 goal;
        dBodyGetPosRelPoint(body, p[0] + 6, dReal(path(p[0] + 6)), p[2], goal);
        const double bend = 2 * goal[1] / (goal[0] * goal[0] + goal[1] * goal[1]);
        drive(body, 0, 0, std::clamp(1.4 * bend / s.max_steer, -1.0, 1.0));
        dVehicleUpdate(body, dReal(h));
        dWorldStepHybrid(road.world, dReal(h));
        out.x = p[0];
        out.largest_lean = std::max(out.largest_lean, std::fabs(double(report(body).lean)));
        if (p[0] > 36) out.largest_error = std::max(out.largest_error, std::fabs(double(p[1]) - path(p[0])));
    }
    return out;
}

TEST(Bikes, hold_themselves_in_a_slalom_at_any_step_size)
{
    const Slalom fine = ride_slalom(1.0 / 480);
    for (const double h : {1.0 / 60, 1.0 / 120}) {
        const Slalom coarse = ride_slalom(h);
        EXPECT_GT(coarse.largest_lean, 0.25);
        EXPECT_LT(coarse.largest_lean, 0.7);
        EXPECT_LT(coarse.largest_error, 1);
        EXPECT_NEAR(coarse.x, fine.x, 0.02 * fine.x);
        EXPECT_NEAR(coarse.largest_lean, fine.largest_lean,
                    0.2 * fine.largest_lean);  // the rider steers once a step
    }
}

TEST(Bikes, fall_without_their_rider)
{
    Road road;
    road.flat();
    dVehicleSettings s = plain_settings();
    s.lean_frequency = 0;
    const dBodyID body = bike(road, 0, &s);
    dBodySetAngularVel(body, dReal(0.05), 0, 0);
    road.run(body, 3, 1.0 / 60);
    EXPECT_GT(std::fabs(report(body).lean), 0.8);
}

dBodyID tank(const Road& road)
{
    dVehicleSettings s = plain_settings();
    s.kind = dVehicleTracked, s.differential = dDifferentialLocked, s.final_ratio = 15;
    const dBodyID body = road.chassis(0.75);
    EXPECT_EQ(dVehicleCreate(body, &s), 1);
    for (int i = 0; i < 8; ++i) {
        dVehicleWheel w = Wheels().like;
        w.position[0] = dReal(1.2 - 0.8 * (i / 2)), w.position[1] = dReal(i % 2 ? -0.9 : 0.9),
        w.position[2] = dReal(kHub);
        w.axle = i / 2, w.stiffness = 20000, w.nominal_load = 1500, w.brake_torque = 500;
        EXPECT_EQ(dVehicleAddWheel(body, &w), i + 1);
    }
    return body;
}

TEST_P(Cornering, turns_tracks_on_the_spot)
{
    for (const int way : {1, -1}) {
        Road road;
        road.flat();
        const dBodyID body = tank(road);
        drive(body, 0.5, 0, way);
        road.run(body, 3, h());
        const double left = wheel(body, 0).spin, right = wheel(body, 1).spin,
                     yaw = dBodyGetAngularVel(body)[2];
        EXPECT_GT(way * yaw, 0.3);
        EXPECT_NEAR(right, -left, 0.02 * std::fabs(right));
        EXPECT_EQ(wheel(body, 2).spin, left);
        EXPECT_LT(std::hypot(x_of(body), dBodyGetPosition(body)[1]), 0.3);
        // The treads slip a little while they drag themselves sideways.
        EXPECT_LT(way * yaw, way * (right - left) * kRadius / 1.8);
        EXPECT_GT(way * yaw, 0.5 * way * (right - left) * kRadius / 1.8);
        drive(body, 0, 1, 0);
        road.run(body, 3, h());
        EXPECT_NEAR(dBodyGetAngularVel(body)[2], 0, 1e-3);
    }
    Road road;
    road.flat();
    const dBodyID body = tank(road);
    drive(body, 0.5);
    road.run(body, 3, h());
    EXPECT_GT(x_of(body), 3);
    EXPECT_NEAR(dBodyGetPosition(body)[1], 0, 1e-6);
}

}  // namespace
}  // namespace epode::vehicles
#endif
