// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Impulses and forces that wake, by momentum and angular momentum.
#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <cmath>

namespace epode::physics {
namespace {

struct Yard {
    Yard() { dInitODE(), world = dWorldCreate(), space = dHashSpaceCreate(nullptr); }
    ~Yard() { dSpaceDestroy(space), dWorldDestroy(world), dCloseODE(); }
    Yard(const Yard&) = delete;
    Yard& operator=(const Yard&) = delete;
    dBodyID crate(double x, double y, double z, double mass = 4) const
    {
        const dBodyID body = dBodyCreate(world);
        dMass m;
        dMassSetBoxTotal(&m, dReal(mass), 1, 2, 3);
        dBodySetMass(body, &m);
        dGeomSetBody(dCreateBox(space, 1, 2, 3), body);
        dBodySetPosition(body, dReal(x), dReal(y), dReal(z));
        return body;
    }
    dWorldID world;
    dSpaceID space;
};

TEST(Impulses, give_momentum_and_angular_momentum_at_once_and_wake)
{
    Yard yard;
    const dBodyID body = yard.crate(1, 2, 3);
    dMatrix3 R;
    dRFromAxisAndAngle(R, 1, 2, 3, dReal(0.7));
    dBodySetRotation(body, R);
    dBodyDisable(body);
    const dVector3 J = {3, -2, 5}, at = {2, 2, 4};
    dBodyApplyImpulse(body, J, at);
    EXPECT_EQ(dBodyIsEnabled(body), 1);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(4 * dBodyGetLinearVel(body)[i], J[i], 1e-5);
    // L = R I R^T w must be r x J, r = (1, 0, 1).
    const double expected[3] = {0 * J[2] - 1 * J[1], 1 * J[0] - 1 * J[2], 1 * J[1] - 0 * J[0]};
    dMass m;
    dBodyGetMass(body, &m);
    const dReal* w = dBodyGetAngularVel(body);
    const dReal* Q = dBodyGetRotation(body);
    for (int i = 0; i < 3; ++i) {
        double L = 0;
        for (int k = 0; k < 3; ++k)
            for (int j = 0; j < 3; ++j) L += Q[4 * i + k] * m.I[4 * k + k] * Q[4 * j + k] * w[j];
        EXPECT_NEAR(L, expected[i], 1e-5);
    }
    const dVector3 turn = {0, 0, 2};
    dBodyApplyAngularImpulse(body, turn);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(4 * dBodyGetLinearVel(body)[i], J[i], 1e-5);
}

TEST(Impulses, do_nothing_to_kinematic_bodies)
{
    Yard yard;
    const dBodyID body = yard.crate(0, 0, 0);
    dBodySetKinematic(body);
    const dVector3 J = {3, 0, 0};
    dBodyApplyImpulse(body, J, nullptr);
    EXPECT_EQ(dBodyGetLinearVel(body)[0], 0);
}

TEST(Forces, that_are_applied_wake_and_act_for_one_step)
{
    Yard yard;
    const dBodyID body = yard.crate(0, 0, 0);
    dBodyDisable(body);
    const dVector3 F = {8, 0, 0};
    dBodyApplyForce(body, F, nullptr);
    for (int i = 0; i < 5; ++i) dWorldStep(yard.world, dReal(0.01));
    EXPECT_NEAR(dBodyGetLinearVel(body)[0], 8 * 0.01 / 4, 1e-6);
    dBodyDisable(body);
    const dVector3 v = {0, 1, 0};
    dBodySetVelocities(body, v, nullptr, 0);
    EXPECT_EQ(dBodyIsEnabled(body), 0);
    dBodySetVelocities(body, v, nullptr, 1);
    EXPECT_EQ(dBodyIsEnabled(body), 1);
    EXPECT_EQ(dBodyGetLinearVel(body)[1], 1);
}

// 10 N in each of 1,200 steps of 1/60 s would be 20 s x 10 N / 10 kg = 20 m/s at once.
TEST(Forces, on_a_sleeping_body_do_not_add_up_unless_the_world_acts_as_ode)
{
    for (const bool as_ode : {false, true}) {
        Yard yard;
        dWorldSetBehaviour(yard.world, as_ode ? dBehaviour016 : dBehaviour1);
        const dBodyID body = yard.crate(0, 0, 0, 10);
        dBodyDisable(body);
        for (int i = 0; i < 1200; ++i) {
            dBodyAddForce(body, 10, 0, 0);
            dWorldStep(yard.world, dReal(1.0 / 60));
        }
        dBodyEnable(body);
        dWorldStep(yard.world, dReal(1.0 / 60));
        EXPECT_NEAR(dBodyGetLinearVel(body)[0], as_ode ? 20 : 0, 1e-3);
    }
}

TEST(RadialImpulses, fall_off_with_the_distance_and_stop_at_the_radius)
{
    for (const int falloff : {int(dFalloffNone), int(dFalloffLinear), int(dFalloffQuadratic)}) {
        Yard yard;
        const dBodyID near = yard.crate(2.5, 0, 0), far = yard.crate(-9, 0, 0);
        const dVector3 centre = {};
        EXPECT_EQ(dSpaceApplyRadialImpulse(yard.space, centre, 8, 20, falloff, 0, nullptr), 1);
        const double left = 1 - 2.0 / 8;  // its face is at x = 2
        const double expected = falloff == dFalloffNone ? 1 : falloff == dFalloffLinear ? left : left * left;
        EXPECT_NEAR(4 * dBodyGetLinearVel(near)[0], 20 * expected, 1e-4);
        EXPECT_NEAR(dBodyGetLinearVel(near)[1], 0, 1e-6);
        EXPECT_EQ(dBodyGetLinearVel(far)[0], 0);
    }
}

TEST(RadialImpulses, do_not_reach_what_is_hidden)
{
    for (const int occlusion : {0, 1}) {
        Yard yard;
        const dBodyID open = yard.crate(-3, 0, 0), hidden = yard.crate(3, 0, 0);
        const dGeomID wall = dCreateBox(yard.space, dReal(0.2), 8, 8);
        dGeomSetPosition(wall, 1, 0, 0);
        const dVector3 centre = {};
        EXPECT_EQ(dSpaceApplyRadialImpulse(yard.space, centre, 8, 20, dFalloffNone, occlusion, nullptr),
                  2 - occlusion);
        EXPECT_NEAR(4 * dBodyGetLinearVel(open)[0], -20, 1e-4);
        EXPECT_NEAR(4 * dBodyGetLinearVel(hidden)[0], occlusion ? 0 : 20, 1e-4);
    }
}

// A charge on the ground, whose plane is not in its own way.
TEST(RadialImpulses, of_a_charge_on_the_ground_lift_what_stands_there)
{
    Yard yard;
    dCreatePlane(yard.space, 0, 0, 1, 0);
    const dBodyID crate = yard.crate(2, 0, dReal(1.5));
    const dVector3 centre = {};
    EXPECT_EQ(dSpaceApplyRadialImpulse(yard.space, centre, 5, 10, dFalloffNone, 1, nullptr), 1);
    const dReal* v = dBodyGetLinearVel(crate);
    EXPECT_NEAR(4 * v[0], 10 * 0.8, 1e-4);  // along (2, 0, 1.5)
    EXPECT_NEAR(4 * v[2], 10 * 0.6, 1e-4);
}

TEST(Impulses, that_no_velocity_can_have_are_refused_and_change_nothing)
{
    Yard yard;
    const dBodyID body = yard.crate(0, 0, 0, 1e-6);
    dBodyDisable(body);
    const dVector3 huge = {dReal(sizeof(dReal) == 4 ? 1e17 : 1e99), 0, 0};
    dSetMessageHandler([](int, const char*, va_list) {});
    dBodyApplyImpulse(body, huge, nullptr);
    dSetMessageHandler(nullptr);
    EXPECT_EQ(dBodyGetLinearVel(body)[0], 0);
    EXPECT_EQ(dBodyIsEnabled(body), 0);
}

}  // namespace
}  // namespace epode::physics
