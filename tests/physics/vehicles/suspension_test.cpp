// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Vehicles on their springs: loads, frequencies, damping, roll.
#include "road.h"

#ifdef dIDEDOUBLE  // the bounds are those of doubles

namespace epode::vehicles {
namespace {

class Suspension : public EveryStep {};
INSTANTIATE_TEST_SUITE_P(steps, Suspension, kSteps, step_name);

// N_front = m g b / (2 L), and each spring is compressed by N / k.
TEST_P(Suspension, shares_the_weight_by_the_lever_rule)
{
    Road road;
    road.flat();
    Wheels wheels;
    wheels.front = 1.1, wheels.rear = -1.5;
    const dBodyID car = road.car(wheels);
    road.run(car, 12, h());
    // It leans a little forward, so that the levers are those to the contacts.
    const double b = x_of(car) - wheel(car, 2).ground_pos[0], a = wheel(car, 0).ground_pos[0] - x_of(car);
    const double pitch_cosine = dBodyGetRotation(car)[10];
    EXPECT_NEAR(b, 1.5, 0.01);
    for (int i = 0; i < 4; ++i) {
        const dVehicleWheelReport w = wheel(car, i);
        EXPECT_NEAR(w.load, kMass * kG * (i < 2 ? b : a) / (2 * (a + b)), 1e-3);
        EXPECT_NEAR(w.compression, w.load * pitch_cosine / 30000, 1e-7);
    }
    EXPECT_NEAR(dBodyGetLinearVel(car)[2], 0, 1e-6);
}

// z'' = -(4 k / m) z - (4 d / m) z': zero crossings and the ratio of maxima against the solution.
double period_of(const Road& road, dBodyID car, double rest, double h, int periods, double* ratio, int how)
{
    double before = z_of(car) - rest, first = -1, last = 0, peak = 0, first_peak = 0;
    int crossings = 0;
    for (double t = 0; t < 60; t += h) {
        dVehicleUpdate(car, dReal(h));
        step_by(road.world, h, how);
        const double z = z_of(car) - rest;
        peak = std::max(peak, z);
        if (before < 0 && z >= 0) {
            last = t + h * (-before) / (z - before);
            if (first < 0) first = last;
            if (crossings == 1) first_peak = peak;
            peak = 0;
            if (++crossings == periods + 1) break;
        }
        before = z;
        if (crossings == periods && z < 0 && peak > 0) *ratio = peak / first_peak;
    }
    return (last - first) / periods;
}

TEST_P(Suspension, bounces_with_its_natural_frequency_in_every_stepper)
{
    for (int how = 0; how < kSteppers; ++how) {
        Road road;
        road.flat();
        Wheels wheels;
        wheels.like.bump_damping = wheels.like.rebound_damping = 0;
        const dBodyID car = road.car(wheels);
        const double rest = z_of(car), omega = std::sqrt(4 * 30000 / kMass);
        dBodySetPosition(car, 0, 0, dReal(rest + 0.03));
        double ratio = 0;
        const double period = period_of(road, car, rest, h(), 8, &ratio, how);
        EXPECT_NEAR(period * omega / (2 * M_PI), 1, 2e-3) << how;
        EXPECT_NEAR(ratio, 1, 0.01) << how;  // of maxima seven periods apart: no damping by the numbers
    }
}

TEST_P(Suspension, is_damped_as_its_dampers_say)
{
    for (int how = 0; how < kSteppers; ++how) {
        Road road;
        road.flat();
        Wheels wheels;
        const double d = 1200;  // zeta = 0.2
        wheels.like.bump_damping = wheels.like.rebound_damping = dReal(d);
        const dBodyID car = road.car(wheels);
        const double rest = z_of(car), omega = std::sqrt(4 * 30000 / kMass),
                     zeta = 4 * d / (2 * kMass * omega);
        dBodySetPosition(car, 0, 0, dReal(rest + 0.05));
        double ratio = 0;
        const double period = period_of(road, car, rest, h(), 2, &ratio, how),
                     damped = omega * std::sqrt(1 - zeta * zeta);
        EXPECT_NEAR(period * damped / (2 * M_PI), 1, 5e-3) << how;
        EXPECT_NEAR(std::log(ratio), -zeta * omega * 2 * M_PI / damped, 0.03) << how;
    }
}

// In a curve of a = v r: (K - m g c) phi = m a c with c the height of the centre of mass, of springs k and bars b, K = sum over axles
// of 2 (k + 2 b) (t/2)^2.
TEST_P(Suspension, rolls_in_curves_by_springs_and_anti_roll_bars)
{
    for (const double bar : {0.0, 15000.0}) {
        Road road;
        road.flat();
        Wheels wheels;
        wheels.like.anti_roll = dReal(bar);
        const dBodyID car = road.car(wheels, plain_settings(), 15);
        dVehicleSetGear(car, 0);
        const double c = z_of(car);
        drive(car, 0, 0, 0.04);
        road.run(car, 4, h());
        const dReal* R = dBodyGetRotation(car);
        const double roll = std::asin(double(R[9])), a = speed(car) * dBodyGetAngularVel(car)[2];
        const double K = 2 * 2 * (30000 + 2 * bar) * kTrack * kTrack / 4;
        EXPECT_GT(a, 1.5);
        EXPECT_NEAR(roll, kMass * a * c / (K - kMass * kG * c), 0.03 * roll);
    }
}

// Stiffness, damping and loads that no step can follow: it comes to rest all the same.
TEST(SuspensionExtremes, come_to_rest_with_any_stiffness_and_damping)
{
    for (const double h : {1.0 / 20, 1.0 / 60})
        for (const double k : {3e3, 3e4, 3e6, 3e9})
            for (const double d : {1e3, 1e5, 1e8}) {
                if (k > 1e6 && d < 1e4) continue;  // nothing there damps it in time
                Road road;
                road.flat();
                Wheels wheels;
                wheels.like.stiffness = dReal(k),
                wheels.like.bump_damping = wheels.like.rebound_damping = dReal(d);
                const dBodyID car = road.car(wheels);
                dBodySetPosition(car, 0, 0, dReal(0.8));
                road.run(car, 20, h);
                EXPECT_LT(std::fabs(dBodyGetLinearVel(car)[2]), 0.05) << k << " " << d;
                EXPECT_LT(speed(car), 1e-3) << k << " " << d;
            }
}

TEST(SuspensionLayouts, stand_on_two_to_thirty_two_wheels)
{
    for (const int count : {3, 4, 6, 8, 16, 32}) {
        Road road;
        road.flat();
        const dBodyID body = road.chassis(0.75);
        ASSERT_EQ(dVehicleCreate(body, nullptr), 1);
        for (int i = 0; i < count; ++i) {
            dVehicleWheel w = Wheels().like;
            const bool single = count == 3 && i == 2;
            w.position[0] = dReal(count == 3 ? (i < 2 ? 1 : -1) : 1.8 - 3.6 * (i / 2) / (count / 2 - 1));
            w.position[1] = dReal(single ? 0 : i % 2 ? -0.75 : 0.75), w.position[2] = dReal(kHub);
            w.axle = i / 2, w.stiffness = dReal(120000.0 / count);
            w.bump_damping = w.rebound_damping = dReal(12000.0 / count);
            ASSERT_EQ(dVehicleAddWheel(body, &w), i + 1);
        }
        drive(body, 0, 1);
        road.run(body, 10, 1.0 / 60);
        double sum = 0;
        for (int i = 0; i < count; ++i) sum += wheel(body, i).load;
        EXPECT_NEAR(sum, kMass * kG, 1e-3 * kMass * kG) << count;
        EXPECT_LT(speed(body), 1e-4);
    }
}

}  // namespace
}  // namespace epode::vehicles
#endif
