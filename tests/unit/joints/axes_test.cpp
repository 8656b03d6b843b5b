// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joint axes: J v is the derivative of the position, by finite differences along motions that the joint's own
// rows allow; J is a pair of equal and opposite wrenches; positions have the sign of the type's own readings.
#include <gtest/gtest.h>

#include "ode/ext.h"
#include "ode/ode.h"
#include "rig.h"

namespace epode::test {
namespace {

constexpr Real kTiny = sizeof(Real) == 8 ? Real(1e-6) : Real(1e-3);

struct AxisRig : Rig {
    Body* a = body({Real(0.3), Real(-0.2), Real(0.5)}, turn({1, 2, 3}, Real(0.7)));
    Body* b = body({Real(-0.4), Real(0.6), Real(0.1)}, turn({-2, 1, 1}, Real(-1.1)));

    enum class Attach { kBoth, kFirst, kSecond };
    void join(dJointID j, Attach how)
    {
        attach(*from_handle<Joint>(j), how == Attach::kSecond ? nullptr : a,
               how == Attach::kFirst  ? nullptr
               : how == Attach::kBoth ? b
                                      : a);
    }

    // Moves both bodies along the velocities for a time.
    static void move(Body* body, Vec3 x, Quat q, Real t)
    {
        const Vec3 w = body->angular_velocity();
        place(body, x + t * body->velocity(), turn(w, t * length(w)) * q);
    }

    // Rate of the axis against the difference of its positions, about a motion in which all of the joint's
    // own rows stand still: that of one free direction after the other.
    void check(dJointID j, int axis, Vec3 v1, Vec3 w1, Vec3 v2, Vec3 w2, Real close)
    {
        velocity(a, v1, w1), velocity(b, v2, w2);
        const Vec3 xa = a->position(), xb = b->position();
        const Quat qa = a->orientation(), qb = b->orientation();
        const Real rate = dJointGetAxisRate(j, axis);
        move(a, xa, qa, kTiny), move(b, xb, qb, kTiny);
        const Real after = dJointGetAxisPosition(j, axis);
        move(a, xa, qa, -kTiny), move(b, xb, qb, -kTiny);
        const Real before = dJointGetAxisPosition(j, axis);
        place(a, xa, qa), place(b, xb, qb);
        EXPECT_NEAR(rate, (after - before) / (2 * kTiny), close) << "axis " << axis;
    }
};

constexpr Real kClose = sizeof(Real) == 8 ? Real(1e-8) : Real(5e-3);
using Attach = AxisRig::Attach;

TEST(JointAxes, a_type_without_axes_has_none)
{
    AxisRig rig;
    for (dJointID j : {dJointCreateBall(rig.id(), nullptr), dJointCreateFixed(rig.id(), nullptr)}) {
        EXPECT_EQ(dJointGetNumAxes(j), 0);
        EXPECT_EQ(dJointGetAxisPosition(j, 0), 0);
    }
}

TEST(JointAxes, a_hinge_reads_as_its_own_functions)
{
    for (const Attach how : {Attach::kBoth, Attach::kFirst, Attach::kSecond}) {
        AxisRig rig;
        dJointID j = dJointCreateHinge(rig.id(), nullptr);
        rig.join(j, how);
        dJointSetHingeAnchor(j, 1, 0, 0);
        dJointSetHingeAxis(j, 0, 0, 1);
        ASSERT_EQ(dJointGetNumAxes(j), 1);
        AxisRig::place(rig.a, rig.a->position(), turn({0, 0, 1}, Real(0.4)) * rig.a->orientation());
        EXPECT_NEAR(dJointGetAxisPosition(j, 0), dJointGetHingeAngle(j), kClose);
        EXPECT_NEAR(std::fabs(dJointGetAxisPosition(j, 0)), 0.4, kClose);
        rig.check(j, 0, {}, {0, 0, 2}, {}, {0, 0, -1}, kClose);
    }
}

TEST(JointAxes, sliding_axes_count_the_turning_of_the_pair)
{
    for (const Attach how : {Attach::kBoth, Attach::kFirst, Attach::kSecond}) {
        AxisRig rig;
        const Vec3 v{Real(0.5), 1, Real(-0.3)}, w{Real(0.2), Real(-0.4), Real(0.9)};
        const bool two = how == Attach::kBoth;
        // Both bodies as one that turns, one of them sliding on it.
        const Vec3 xa = rig.a->position(), xb = rig.b->position();
        const auto rigid = [&](Vec3 x) { return v + cross(w, x); };
        const Vec3 s{0, Real(0.6), Real(0.8)};
        dJointID slider = dJointCreateSlider(rig.id(), nullptr);
        rig.join(slider, how);
        dJointSetSliderAxis(slider, s.x, s.y, s.z);
        if (two) rig.check(slider, 0, rigid(xa) + s, w, rigid(xb), w, kClose);
        if (!two) rig.check(slider, 0, s, {}, {}, {}, kClose);
        EXPECT_NEAR(dJointGetAxisPosition(slider, 0), dJointGetSliderPosition(slider), kClose);
        dJointID piston = dJointCreatePiston(rig.id(), nullptr);
        rig.join(piston, how);
        dJointSetPistonAnchor(piston, 1, 1, 0);
        dJointSetPistonAxis(piston, s.x, s.y, s.z);
        if (two) rig.check(piston, 0, rigid(xa) + s, w, rigid(xb), w, kClose);
        rig.check(piston, 1, {}, s, {}, {}, kClose);
        EXPECT_NEAR(dJointGetAxisPosition(piston, 0), dJointGetPistonPosition(piston), kClose);
        EXPECT_NEAR(dJointGetAxisPosition(piston, 1), dJointGetPistonAngle(piston), kClose);
        dJointID pr = dJointCreatePR(rig.id(), nullptr);
        rig.join(pr, how);
        dJointSetPRAnchor(pr, 1, 1, 0);
        dJointSetPRAxis1(pr, s.x, s.y, s.z);
        dJointSetPRAxis2(pr, 1, 0, 0);
        if (two) rig.check(pr, 0, rigid(xa) + s, w, rigid(xb), w, kClose);
        rig.check(pr, 1, {}, {1, 0, 0}, {}, {}, kClose);
        EXPECT_NEAR(dJointGetAxisPosition(pr, 0), dJointGetPRPosition(pr), kClose);
    }
}

// The bodies turn about both axes at once; the frame of axis 1 is body 1's, that of axis 2 is body 2's.
TEST(JointAxes, crossed_axes_are_distinguished)
{
    for (const Attach how : {Attach::kBoth, Attach::kFirst, Attach::kSecond}) {
        AxisRig rig;
        const Vec3 a1{1, 0, 0}, a2{0, Real(0.6), Real(0.8)};
        const bool swapped = how == Attach::kSecond;
        const Vec3 of_a = swapped ? a2 : a1, of_b = swapped ? a1 : a2,
                   w = Real(0.7) * of_a - Real(0.3) * of_b;
        dJointID j = dJointCreateUniversal(rig.id(), nullptr);
        rig.join(j, how);
        dJointSetUniversalAxis1(j, a1.x, a1.y, a1.z);
        dJointSetUniversalAxis2(j, a2.x, a2.y, a2.z);
        dJointID pu = dJointCreatePU(rig.id(), nullptr);
        rig.join(pu, how);
        dJointSetPUAxis1(pu, a1.x, a1.y, a1.z);
        dJointSetPUAxis2(pu, a2.x, a2.y, a2.z);
        for (int i = 0; i < 2; ++i) {
            rig.check(j, i, {}, w, {}, {}, kClose);
            rig.check(pu, i, {}, w, {}, {}, kClose);
        }
        EXPECT_EQ(dJointGetAxisPosition(j, 1), dJointGetUniversalAngle2(j));
    }
}

TEST(JointAxes, hinge2_has_rates_of_axes_that_are_not_perpendicular)
{
    AxisRig rig;
    dJointID j = dJointCreateHinge2(rig.id(), nullptr);
    rig.join(j, Attach::kBoth);
    const dReal a1[4] = {0, 0, 1, 0}, a2[4] = {0, Real(0.8), Real(0.6), 0};
    dJointSetHinge2Axes(j, a1, a2);
    const Vec3 u1{0, 0, 1}, u2{0, Real(0.8), Real(0.6)};
    for (int i = 0; i < 2; ++i) rig.check(j, i, {}, Real(0.7) * u1 + Real(0.4) * u2, {}, {}, kClose);
}

TEST(JointAxes, motors_have_euler_angles_and_distances)
{
    for (const Attach how : {Attach::kBoth, Attach::kFirst, Attach::kSecond}) {
        AxisRig rig;
        dJointID j = dJointCreateAMotor(rig.id(), nullptr);
        rig.join(j, how);
        dJointSetAMotorMode(j, dAMotorEuler);
        dJointSetAMotorAxis(j, 0, 1, 1, 0, 0);
        dJointSetAMotorAxis(j, 2, 2, 0, 0, 1);
        AxisRig::place(rig.a, rig.a->position(), turn({1, 2, -1}, Real(0.5)) * rig.a->orientation());
        for (int i = 0; i < 3; ++i)
            rig.check(j, i, {}, {Real(0.3), Real(-0.5), Real(0.8)}, {}, {}, 10 * kClose);
        dJointID l = dJointCreateLMotor(rig.id(), nullptr);
        EXPECT_EQ(dJointGetNumAxes(l), 0);
        rig.join(l, how);
        dJointSetLMotorNumAxes(l, 2);
        dJointSetLMotorAxis(l, 0, 0, 0, 1, 0);
        EXPECT_EQ(dJointGetNumAxes(l), 2);
        rig.check(l, 0, {1, 2, 3}, {}, {2, -1, 1}, {}, kClose);
    }
}

// Momentum: what J pushes body 1 with, it pushes body 2 against.
TEST(JointAxes, every_axis_pushes_and_turns_both_bodies_alike)
{
    AxisRig rig;
    const dReal a1[4] = {0, 0, 1, 0}, a2[4] = {0, Real(0.8), Real(0.6), 0};
    std::vector<dJointID> joints{
        dJointCreateHinge(rig.id(), nullptr),     dJointCreateSlider(rig.id(), nullptr),
        dJointCreateUniversal(rig.id(), nullptr), dJointCreatePR(rig.id(), nullptr),
        dJointCreatePU(rig.id(), nullptr),        dJointCreatePiston(rig.id(), nullptr),
        dJointCreateHinge2(rig.id(), nullptr),    dJointCreateAMotor(rig.id(), nullptr),
        dJointCreateLMotor(rig.id(), nullptr)};
    for (dJointID id : joints) {
        rig.join(id, Attach::kBoth);
        if (dJointGetType(id) == dJointTypeHinge2) dJointSetHinge2Axes(id, a1, a2);
        if (dJointGetType(id) == dJointTypeAMotor) dJointSetAMotorMode(id, dAMotorEuler);
        if (dJointGetType(id) == dJointTypeAMotor) dJointSetAMotorAxis(id, 0, 1, 1, 0, 0);
        if (dJointGetType(id) == dJointTypeAMotor) dJointSetAMotorAxis(id, 2, 2, 0, 0, 1);
        if (dJointGetType(id) == dJointTypeLMotor) dJointSetLMotorNumAxes(id, 1);
        if (dJointGetType(id) == dJointTypeLMotor) dJointSetLMotorAxis(id, 0, 1, 0, 1, 0);
        const Joint& j = *from_handle<Joint>(id);
        for (int i = 0; i < dJointGetNumAxes(id); ++i) {
            const Jacobian J = j.type->axis(j, i).J;
            const Vec3 moment =
                J.ang1 + J.ang2 + cross(rig.a->position(), J.lin1) + cross(rig.b->position(), J.lin2);
            EXPECT_NEAR(length(J.lin1 + J.lin2), 0, kClose) << j.type->name << " " << i;
            EXPECT_NEAR(length(moment), 0, kClose) << j.type->name << " " << i;
        }
    }
}

TEST(JointAxes, a_continuous_axis_counts_turns)
{
    AxisRig rig;
    dJointID j = dJointCreateHinge(rig.id(), nullptr);
    rig.join(j, Attach::kFirst);
    dJointSetHingeAnchor(j, rig.a->pos[0], rig.a->pos[1], rig.a->pos[2]);
    dJointSetHingeAxis(j, 0, 0, 1);
    EXPECT_EQ(dJointGetAxisContinuous(j, 0), 0);
    EXPECT_EQ(dJointSetAxisContinuous(j, 0, 1), 1);
    EXPECT_EQ(dJointGetAxisContinuous(j, 0), 1);
    AxisRig::velocity(rig.a, {}, {0, 0, 10});
    for (int i = 0; i < 100; ++i) dWorldStep(rig.id(), Real(0.02));
    // A step turns by 2 atan(h w / 2).
    EXPECT_NEAR(dJointGetAxisPosition(j, 0), 100 * 2 * std::atan(Real(0.1)), 100 * kClose);
    dJointSetAxisContinuous(j, 0, 0);
    EXPECT_LT(std::fabs(dJointGetAxisPosition(j, 0)), Real(3.2));
}

}  // namespace
}  // namespace epode::test
