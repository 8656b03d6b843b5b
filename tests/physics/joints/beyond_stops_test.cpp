// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints that begin beyond their stops. In the presets they are brought back at the worlds' correcting velocity and have no
// speed of it, however small the steps; with ODE's values they are thrown by ERP / h of the error, as ODE throws them.
//
// A hinge is turned by h v about its body's centre too, which opens it by (h v)^2 l / 2; its ERP closes that by a velocity of
// h ERP v^2 l / 2, 0.025 h for v = 1 rad/s and l = 0.25 m, a few times in succession: kOpened h bounds what is left.
#include <ode/ext.h>

#include <algorithm>

#include "rig.h"

namespace epode::physics {
namespace {

constexpr double kLow = 0.25, kOpened = 0.1;

using Step = int (*)(dWorldID, dReal);
struct Case {
    int preset;
    Step step;
    double h;
};

// A rod on a hinge of the world, or a carriage on a slide, at 0; the stop is at kLow.
struct Beyond {
    explicit Beyond(int preset, bool hinge, double low = kLow)
    {
        dWorldUseDefaults(world, preset);
        body = dBodyCreate(world);
        dMass mass;
        dMassSetCapsuleTotal(&mass, 1, 1, real(0.02), real(0.5));
        dBodySetMass(body, &mass);
        dBodySetPosition(body, real(0.25), 0, 0);
        joint = hinge ? dJointCreateHinge(world, nullptr) : dJointCreateSlider(world, nullptr);
        dJointAttach(joint, body, nullptr);
        if (hinge)
            dJointSetHingeAnchor(joint, 0, 0, 0), dJointSetHingeAxis(joint, 0, 1, 0);
        else
            dJointSetSliderAxis(joint, 1, 0, 0);
        for (const auto set : {hinge ? dJointSetHingeParam : dJointSetSliderParam}) {
            set(joint, dParamHiStop, 3);
            set(joint, dParamLoStop, real(low));
        }
    }
    ~Beyond() { dWorldDestroy(world); }
    double position() const { return double(dJointGetAxisPosition(joint, 0)); }
    double rate() const { return std::fabs(double(dJointGetAxisRate(joint, 0))); }

    dWorldID world = dWorldCreate();
    dBodyID body;
    dJointID joint;
};

TEST(BeyondStops, joints_come_back_without_a_speed_in_the_presets)
{
    for (const int preset : {dDefaultsGame, dDefaultsRobot})
        for (const Step step : {Step(dWorldStep), Step(dWorldStepHybrid), Step(dWorldQuickStep)})
            for (const bool hinge : {true, false})
                for (const double h : {1.0 / 60, 1.0 / 240, 0.001}) {
                    Beyond at(preset, hinge);
                    double fastest = 0;
                    for (int i = 0; i * h < 2; ++i)
                        step(at.world, real(h)), fastest = std::max(fastest, at.rate());
                    EXPECT_LE(fastest, kOpened * h + tol(0, 1e-2)) << preset << ' ' << hinge << ' ' << h;
                    EXPECT_LE(at.rate(), kOpened * h + tol(1e-5, 1e-3)) << preset << ' ' << hinge << ' ' << h;
                    EXPECT_NEAR(at.position(), kLow, 2 * kOpened * h + tol(1e-4, 2e-3))
                        << preset << ' ' << hinge << ' ' << h;
                }
}

// ERP / h of the error is 5 rad/s at 10 ms and 50 at 1 ms. The row's CFM C takes of it what it yields under the impulse that
// makes it, v (1 + C m / h) = ERP/h error: with behaviour 0.16 the default is literal, 1e-5 in floats.
TEST(BeyondStops, joints_are_thrown_as_ode_throws_them_with_its_values)
{
    for (const double h : {0.01, 0.001}) {
        Beyond at(dDefaultsOde, false);
        dWorldStep(at.world, real(h));
        EXPECT_NEAR(at.rate(), 0.2 * kLow / h, tol(1e-6, 1e-3) / h);
    }
}

TEST(BeyondStops, joints_are_thrown_as_ode_throws_them_with_its_behaviour)
{
    Beyond at(dDefaultsGame, false);
    dWorldSetBehaviour(at.world, dBehaviour016);
    dWorldStep(at.world, real(0.001));
    EXPECT_NEAR(at.rate(), 0.2 * kLow / 0.001 / (1 + tol(1e-10, 1e-5) * 1 / 0.001), tol(1e-3, 1e-2));
}

// 1 rad takes a second, longer than idle bodies stay awake.
TEST(BeyondStops, bodies_do_not_sleep_on_their_way_back)
{
    Beyond at(dDefaultsGame, true, 1);
    for (int i = 0; i < 180; ++i) dWorldStepHybrid(at.world, real(1.0 / 60));
    EXPECT_NEAR(at.position(), 1, 3 * kOpened / 60);
}

// What pushes the joint off its stop is not held back while it is brought back.
TEST(BeyondStops, motors_leave_stops_freely)
{
    Beyond at(dDefaultsGame, false);
    dBodyAddForce(at.body, 3, 0, 0);
    dWorldStepHybrid(at.world, real(0.01));
    EXPECT_NEAR(at.rate(), 0.03, tol(1e-9, 1e-5));
}

}  // namespace
}  // namespace epode::physics
