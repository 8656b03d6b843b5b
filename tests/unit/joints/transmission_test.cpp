// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Transmission: slip is the integral of J v in every mode and pose; gears turn as gears do, whichever way
// their axes point; a chain pulls; play, changes of gear, full turns; what cannot mesh does nothing.
#include <gtest/gtest.h>

#include "ode/objects.h"
#include "row_lines.h"

namespace epode::test {
namespace {

constexpr Real kNear = kSingle ? Real(1e-4) : Real(1e-11);
constexpr Vec3 kX{1, 0, 0}, kZ{0, 0, 1};

struct Gear : testing::Test {
    Rig rig;
    Dice dice;
    Body* a = rig.body({0, 0, 0});
    Body* b = rig.body({3, 0, 0});
    dJointID j = dJointCreateTransmission(rig.id(), nullptr);
    dVector3 r = {0, 0, 0, 0};

    void SetUp() override { Rig::join(j, a, b); }
    void anchors(Vec3 p, Vec3 q)
    {
        dJointSetTransmissionAnchor1(j, p.x, p.y, p.z);
        dJointSetTransmissionAnchor2(j, q.x, q.y, q.z);
    }
    void parallel(Vec3 n, Vec3 p, Vec3 q, Real ratio)
    {
        dJointSetTransmissionMode(j, dTransmissionParallelAxes);
        dJointSetTransmissionAxis(j, n.x, n.y, n.z);
        anchors(p, q);
        dJointSetTransmissionRatio(j, ratio);
    }
    void bevel(Vec3 n1, Vec3 n2, Vec3 p, Vec3 q)
    {
        dJointSetTransmissionMode(j, dTransmissionIntersectingAxes);
        dJointSetTransmissionAxis1(j, n1.x, n1.y, n1.z);
        dJointSetTransmissionAxis2(j, n2.x, n2.y, n2.z);
        anchors(p, q);
    }
    void chain(Vec3 n, Vec3 p, Vec3 q, Real r1, Real r2)
    {
        dJointSetTransmissionMode(j, dTransmissionChainDrive);
        dJointSetTransmissionAxis(j, n.x, n.y, n.z);
        anchors(p, q);
        dJointSetTransmissionRadius1(j, r1);
        dJointSetTransmissionRadius2(j, r2);
    }
    Row row() const { return rig.emit(j).rows.at(0); }
    // J v of the one row.
    Real slip_rate() const
    {
        const Row x = row();
        return dot(x.lin1, a->velocity()) + dot(x.ang1, a->angular_velocity()) + dot(x.lin2, b->velocity()) +
               dot(x.ang2, b->angular_velocity());
    }
    static void spin(Body* body, Vec3 axis, Real angle) { spin_around(body, body->position(), axis, angle); }
    static void spin_around(Body* body, Vec3 centre, Vec3 axis, Real angle)
    {
        const Quat q = turn(axis, angle);
        Rig::place(body, centre + to_matrix(q) * (body->position() - centre), q * body->orientation());
    }
};

TEST_F(Gear, jacobian_is_the_derivative_of_slip_wherever_the_wheels_are_and_however_far_they_turned)
{
    for (int trial = 0; trial < 10; ++trial) {
        const Vec3 n = dice.unit(), m = dice.unit(), p = dice.vector();
        const Vec3 q = p + Real(2) * normalized_or(cross(n, dice.unit()), kX) + dice.next() * n;
        for (const bool intersecting : {false, true}) {
            Rig::place(a, dice.vector(), dice.rotation());
            Rig::place(b, dice.vector(), dice.rotation());
            intersecting ? bevel(n, m, p, q) : parallel(n, p, q, Real(1.5));
            EXPECT_NEAR(row().error, 0, 1000 * kEpsilon);
            spin_around(a, p, n, Real(0.4));
            spin_around(b, q, intersecting ? m : n, Real(-0.3));
            expect_exact_derivative(rig, j, a, b);
            expect_momentum(rig, j, a, b);
        }
    }
}

TEST_F(Gear, chain_turns_both_wheels_and_makes_no_momentum)
{
    for (int trial = 0; trial < 10; ++trial) {
        const Vec3 n = dice.unit(), p = dice.vector();
        const Vec3 q = p + Real(2) * normalized_or(cross(n, dice.unit()), kX) + dice.next() * n;
        Rig::place(a, p, dice.rotation());
        Rig::place(b, q, dice.rotation());
        chain(n, p, q, Real(0.7), Real(0.4));
        EXPECT_NEAR(row().error, 0, 1000 * kEpsilon);
        Rig::velocity(a, {}, 4 * n);
        Rig::velocity(b, {}, 7 * n);
        EXPECT_NEAR(slip_rate(), 0, kNear);
        spin(a, n, Real(0.2));
        EXPECT_NEAR(std::fabs(row().error), 0.14, kNear);
        spin(b, n, Real(0.35));
        EXPECT_NEAR(row().error, 0, kNear);
        expect_momentum(rig, j, a, b);
    }
}

// Turning together as wheels do leaves no slip, wherever the contact is and however the axes point.
TEST_F(Gear, every_bevel_gear_runs_without_slip)
{
    for (const Real side1 : {Real(-1), Real(1)})
        for (const Real side2 : {Real(-1), Real(1)})
            for (const Vec3 n2 : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{Real(0.6), 0, Real(0.8)},
                                  Vec3{Real(0.6), 0, Real(-0.8)}}) {
                // Contact at c = (+-2, 0, 0); the spoke of wheel 2 lies in the plane y = 0 across n2.
                const Vec3 c = {2 * side1, 0, 0}, spoke = cross(Vec3{0, 1, 0}, n2);
                Rig::place(a, {0, 0, 0});
                Rig::place(b, c - 3 * side2 * spoke);
                bevel(kZ, n2, {0, 0, 0}, b->position());
                EXPECT_NEAR(row().error, 0, kNear);
                EXPECT_NEAR(dJointGetTransmissionRadius1(j), 2, kNear);
                EXPECT_NEAR(dJointGetTransmissionRatio(j), 2 / Real(3), kNear);
                // Rims move alike: w1 z x 2 s1 x = w2 n2 x 3 s2 spoke, both along y; n2 x spoke = y.
                const Real w1 = 3, w2 = 2 * side1 * side2;
                Rig::velocity(a, {}, w1 * kZ);
                Rig::velocity(b, {}, w2 * n2);
                EXPECT_NEAR(slip_rate(), 0, kNear);
                spin(a, kZ, Real(0.1) * w1);
                spin(b, n2, Real(0.1) * w2);
                EXPECT_NEAR(row().error, 0, kNear);
                spin(b, n2, Real(0.1));
                EXPECT_NEAR(std::fabs(row().error), 0.3, kNear);
                expect_exact_derivative(rig, j, a, b);
            }
}

TEST_F(Gear, a_chain_pulls)
{
    for (const Real ahead : {Real(0.1), Real(-0.1)}) {
        Rig::place(a, {1, 2, 3});
        Rig::place(b, {1, 5, 3});
        chain(kZ, {1, 2, 3}, {1, 5, 3}, 1, Real(0.5));
        row();
        spin(a, kZ, ahead);
        const Row x = row();
        const Vec3 force = x.error * x.lin1;  // the sense in which the row pushes body 1
        EXPECT_GT(force.y, 0) << "towards body 2";
        EXPECT_LT(ahead * (x.error * x.ang1.z), 0) << "and back";
        dJointGetTransmissionContactPoint1(j, r);
        EXPECT_NEAR(length(load(r) - a->position()), 1, kNear);
        EXPECT_NEAR(dot(load(r) - a->position(), x.lin1), 0, kNear) << "a tangent";
    }
}

TEST_F(Gear, counts_full_turns)
{
    parallel(kZ, {0, 0, 0}, {3, 0, 0}, 2);
    row();
    for (int i = 0; i < 100; ++i) {
        // 2 rad a step: found again through the velocity.
        Rig::velocity(a, {}, {0, 0, 200});
        Rig::velocity(b, {}, {0, 0, -400});
        spin(a, kZ, 2);
        spin(b, kZ, -4);
        EXPECT_NEAR(row().error, 0, 1000 * kNear);
    }
    EXPECT_NEAR(dJointGetTransmissionAngle1(j), -200, 1000 * kNear);
    EXPECT_NEAR(dJointGetTransmissionAngle2(j), 400, 1000 * kNear);
}

TEST_F(Gear, play_lets_go_and_then_pushes_one_way)
{
    parallel(kZ, {0, 0, 0}, {3, 0, 0}, 2);
    dJointSetTransmissionBacklash(j, Real(0.1));
    Row x = row();
    EXPECT_EQ(x.lo, 0);
    EXPECT_EQ(x.hi, 0);
    spin(a, kZ, Real(0.04));
    EXPECT_EQ(row().error, 0);
    spin(a, kZ, Real(0.04));  // 2 m * 0.08 = 0.16 m
    x = row();
    EXPECT_NEAR(std::fabs(x.error), 0.06, kNear);
    EXPECT_EQ(x.error > 0 ? x.lo : x.hi, 0);
    EXPECT_EQ(x.error > 0 ? x.hi : -x.lo, kInf);
    EXPECT_LT(x.error * x.ang1.z, 0) << "turns body 1 back";
    dJointSetTransmissionBacklash(j, -1);
    EXPECT_EQ(dJointGetTransmissionBacklash(j), Real(0.1));
}

TEST_F(Gear, changing_gear_does_not_jerk)
{
    parallel(kZ, {0, 0, 0}, {3, 0, 0}, 2);
    row();
    spin(a, kZ, 1);
    spin(b, kZ, -2);
    EXPECT_NEAR(row().error, 0, kNear);
    dJointSetTransmissionRatio(j, Real(0.5));
    EXPECT_NEAR(row().error, 0, kNear);
    EXPECT_NEAR(dJointGetTransmissionRadius1(j), 1, kNear);
    EXPECT_NEAR(dJointGetTransmissionAngle1(j), -1, kNear) << "angles go on";
    spin(a, kZ, Real(0.2));
    spin(b, kZ, Real(-0.1));
    EXPECT_NEAR(row().error, 0, kNear);
    dJointSetTransmissionAnchor1(j, 0, 0, 0);
    row();
    EXPECT_NEAR(dJointGetTransmissionAngle1(j), 0, kNear) << "new wheels";
}

TEST_F(Gear, inner_poses_do_not_count_as_steps)
{
    parallel(kZ, {0, 0, 0}, {3, 0, 0}, 2);
    row();
    rig.info.inner = true;
    spin(a, kZ, Real(0.1));
    EXPECT_NEAR(std::fabs(row().error), 0.2, kNear);
    EXPECT_NEAR(dJointGetTransmissionAngle1(j), 0, kNear);
    rig.info.inner = false;
    EXPECT_NEAR(std::fabs(row().error), 0.2, kNear);
    EXPECT_NEAR(dJointGetTransmissionAngle1(j), -0.1, kNear);
}

TEST_F(Gear, wheels_that_cannot_touch_do_nothing)
{
    parallel(kZ, {0, 0, 0}, {0, 0, 2}, 1);
    EXPECT_EQ(rig.emit(j).rows.size(), 0u);
    bevel(kZ, kZ, {0, 0, 0}, {3, 0, 0});
    EXPECT_EQ(rig.emit(j).rows.size(), 0u);
    dJointSetTransmissionMode(j, dTransmissionChainDrive);
    const dJointID bare = dJointCreateTransmission(rig.id(), nullptr);
    Rig::join(bare, a, b);
    dJointSetTransmissionMode(bare, dTransmissionChainDrive);
    EXPECT_EQ(rig.emit(bare).rows.size(), 0u);
    // Wheels larger than their distance: the nearest thing to a tangent, and finite.
    chain(kZ, {0, 0, 0}, {3, 0, 0}, 5, Real(0.5));
    const Row x = row();
    EXPECT_TRUE(usable(x.error) && usable(length(x.ang1)));
}

TEST_F(Gear, refuses_what_its_mode_does_not_have)
{
    parallel(kZ, {0, 0, 0}, {3, 0, 0}, 2);
    dJointSetTransmissionAxis1(j, 1, 0, 0);
    dJointSetTransmissionRadius1(j, 5);
    dJointSetTransmissionRatio(j, 0);
    dJointSetTransmissionRatio(j, -1);
    dJointSetTransmissionMode(j, 3);
    dJointSetTransmissionAxis(j, 0, 0, 0);
    EXPECT_EQ(dJointGetTransmissionRatio(j), 2);
    EXPECT_EQ(dJointGetTransmissionRadius1(j), 0);
    EXPECT_EQ(dJointGetTransmissionMode(j), dTransmissionParallelAxes);
    dJointGetTransmissionAxis(j, r);
    EXPECT_EQ(r[2], 1);
    dJointSetTransmissionMode(j, dTransmissionIntersectingAxes);
    dJointSetTransmissionAxis(j, 1, 0, 0);
    dJointSetTransmissionRatio(j, 7);
    r[2] = 9;
    dJointGetTransmissionAxis(j, r);
    EXPECT_EQ(r[2], 9);
    EXPECT_EQ(dJointGetTransmissionRatio(j), 2);
    dJointSetTransmissionMode(j, dTransmissionChainDrive);
    dJointSetTransmissionRadius2(j, -1);
    EXPECT_EQ(dJointGetTransmissionRadius2(j), 0);
    const dJointID ball = dJointCreateBall(rig.id(), nullptr);
    EXPECT_EQ(dJointGetTransmissionRatio(ball) + dJointGetTransmissionAngle1(ball), 0);
}

}  // namespace
}  // namespace epode::test
