// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// PR, PU and piston, whose anchors may part: readings, and the promises of the joint contract where they have
// parted, which the pose of setting does not show.
#include <gtest/gtest.h>

#include "ode/objects.h"
#include "row_lines.h"

namespace epode::test {
namespace {

// Two of the functions are deprecated, and tested all the same.
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

constexpr Real kNear = kSingle ? Real(1e-5) : Real(1e-12);
constexpr Vec3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

struct Sliding : testing::Test {
    Rig rig;
    Dice dice;
    Body* a = rig.body({0, 0, 0});
    Body* b = rig.body({2, 0, 0});
    dVector3 r = {0, 0, 0, 0};

    void scatter()
    {
        for (Body* body : {a, b}) {
            const Vec3 x = dice.vector();
            Rig::place(body, x, dice.rotation());
        }
    }
    void shift(Body* body, Vec3 d) const { Rig::place(body, body->position() + d, body->orientation()); }

    // Slides b by `amount` along the slide of the joint.
    void part(Vec3 slide, Real amount) { shift(b, amount * slide); }

    dJointID pr(Vec3 slide, Vec3 turn, Vec3 anchor, Body* first, Body* second)
    {
        const dJointID j = dJointCreatePR(rig.id(), nullptr);
        Rig::join(j, first, second);
        dJointSetPRAnchor(j, anchor.x, anchor.y, anchor.z);
        dJointSetPRAxis1(j, slide.x, slide.y, slide.z);
        dJointSetPRAxis2(j, turn.x, turn.y, turn.z);
        return j;
    }
    dJointID pu(Vec3 axis1, Vec3 axis2, Vec3 slide, Vec3 anchor, Body* first, Body* second)
    {
        const dJointID j = dJointCreatePU(rig.id(), nullptr);
        Rig::join(j, first, second);
        dJointSetPUAnchor(j, anchor.x, anchor.y, anchor.z);
        dJointSetPUAxis1(j, axis1.x, axis1.y, axis1.z);
        dJointSetPUAxis2(j, axis2.x, axis2.y, axis2.z);
        dJointSetPUAxis3(j, slide.x, slide.y, slide.z);
        return j;
    }
    dJointID piston(Vec3 axis, Vec3 anchor, Body* first, Body* second)
    {
        const dJointID j = dJointCreatePiston(rig.id(), nullptr);
        Rig::join(j, first, second);
        dJointSetPistonAnchor(j, anchor.x, anchor.y, anchor.z);
        dJointSetPistonAxis(j, axis.x, axis.y, axis.z);
        return j;
    }
    Vec3 perpendicular(Vec3 n) { return normalized_or(cross(n, dice.unit()), {0, 1, 0}); }
    void expect_sound(dJointID j) const
    {
        for (const Row& row : rig.emit(j).rows) EXPECT_NEAR(row.error, 0, 200 * kEpsilon);
        expect_exact_derivative(rig, j, a, b);
        expect_momentum(rig, j, a, b);
    }
};

TEST_F(Sliding, separated_anchors_keep_jacobian_and_momentum_exact)
{
    for (int trial = 0; trial < 10; ++trial) {
        scatter();
        const Vec3 s = dice.unit(), n = perpendicular(s), m = perpendicular(n);
        const dJointID joints[] = {pr(s, n, dice.vector(), a, b), pu(n, m, s, dice.vector(), a, b),
                                   piston(s, dice.vector(), a, b)};
        part(s, Real(0.7));
        for (const dJointID j : joints) expect_sound(j);
    }
}

TEST_F(Sliding, motors_make_no_momentum_with_separated_anchors)
{
    scatter();
    const Vec3 s = dice.unit(), n = perpendicular(s), m = perpendicular(n);
    const dJointID r1 = pr(s, n, dice.vector(), a, b), u = pu(n, m, s, dice.vector(), a, b),
                   p = piston(s, dice.vector(), a, b);
    part(s, Real(-0.4));
    for (int group = 0; group < 3; ++group) {
        dJointSetPRParam(r1, group * dParamGroup + dParamFMax, 1);
        dJointSetPUParam(u, group * dParamGroup + dParamFMax, 1);
        dJointSetPistonParam(p, group * dParamGroup + dParamFMax, 1);
    }
    EXPECT_EQ(rig.emit(r1).rows.size(), 6u);
    EXPECT_EQ(rig.emit(u).rows.size(), 6u);
    EXPECT_EQ(rig.emit(p).rows.size(), 6u);
    for (const dJointID j : {r1, u, p}) expect_momentum(rig, j, a, b);
}

// A PR joint whose axes are not perpendicular locks four motions all the same, and those of its own.
TEST_F(Sliding, pr_with_skew_axes_is_sound)
{
    scatter();
    const dJointID j = pr(kX, {1, 1, 0}, {0, 0, 0}, a, b);
    part(kX, Real(0.5));
    expect_sound(j);
    const dJointID parallel = pr(kX, kX, {0, 0, 0}, a, b);
    part(kX, Real(0.5));
    expect_sound(parallel);
    std::vector<Line> lines = equality_lines(rig.emit(parallel).rows);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::vector<Line> others = lines;
        others.erase(others.begin() + std::ptrdiff_t(i));
        EXPECT_GT(size(outside_span(others, lines[i])), 0.1) << i;
    }
}

// Rates are the derivatives of what they are the rates of, but for what ODE leaves out: the turning of a PR
// joint's body 1, and that a PU joint's body 2 turns about its own centre, which ODE counts the other way
// round.
TEST_F(Sliding, rates_of_positions_are_their_derivatives_while_these_do_not_turn)
{
    const Real t = kSingle ? Real(1e-3) : Real(1e-6);
    for (int trial = 0; trial < 10; ++trial) {
        scatter();
        const Vec3 s = dice.unit(), n = perpendicular(s), m = perpendicular(n);
        const dJointID r1 = pr(s, n, dice.vector(), a, b), u = pu(n, m, s, dice.vector(), a, b);
        part(s, Real(0.6));
        Vec3 v[2], w[2];
        for (int i = 0; i < 2; ++i) v[i] = dice.vector(), w[i] = dice.vector();
        Body* bodies[2] = {a, b};
        const bool of_pr = trial % 2 != 0;
        w[of_pr ? 0 : 1] = {};
        for (int i = 0; i < 2; ++i) Rig::velocity(bodies[i], v[i], w[i]);
        const Real rate_r = dJointGetPRPositionRate(r1), rate_u = dJointGetPUPositionRate(u);
        const Real at_r = dJointGetPRPosition(r1), at_u = dJointGetPUPosition(u);
        for (int i = 0; i < 2; ++i)
            Rig::place(bodies[i], bodies[i]->position() + t * v[i],
                       turn(normalized_or(w[i], kX), t * length(w[i])) * bodies[i]->orientation());
        if (of_pr) {
            EXPECT_NEAR((dJointGetPRPosition(r1) - at_r) / t, rate_r, kDifference);
        } else {
            EXPECT_NEAR((dJointGetPUPosition(u) - at_u) / t, rate_u, kDifference);
        }
    }
}

TEST_F(Sliding, rates_count_spins_as_ode_does)
{
    Rig::place(a, {0, 0, 0});
    Rig::place(b, {Real(0.5), 2, 0}, turn(kZ, kPi / 2));
    const dJointID r1 = pr(kX, kZ, {1, 0, 0}, a, b), u = pu(kY, kZ, kX, {1, 0, 0}, a, b);
    Rig::velocity(a, {});
    Rig::velocity(b, {}, {0, 0, 3});  // its anchor, 2 below its centre, goes along x at 6
    EXPECT_NEAR(dJointGetPRPositionRate(r1), -6, kNear);
    EXPECT_NEAR(dJointGetPUPositionRate(u), 6, kNear);
    Rig::velocity(a, {}, {0, 0, 5});
    EXPECT_NEAR(dJointGetPRPositionRate(r1), -6, kNear);
}

TEST_F(Sliding, positions_and_angles_grow_with_body_1_and_change_sign_with_the_order)
{
    for (const bool reversed : {false, true}) {
        Rig::place(a, {0, 0, 0});
        Rig::velocity(a, {0, 0, 0});
        Body *first = reversed ? nullptr : a, *second = reversed ? a : nullptr;
        const dJointID r1 = pr(kX, kZ, {0, 0, 0}, first, second), p = piston(kX, {0, 0, 0}, first, second),
                       u = pu(kY, kZ, kX, {0, 0, 0}, first, second);
        const Real sign = reversed ? -1 : 1;
        Rig::place(a, {Real(0.5), 0, 0});
        Rig::velocity(a, {3, 0, 0}, {0, 0, 2});
        for (const Real position :
             {dJointGetPRPosition(r1), dJointGetPistonPosition(p), dJointGetPUPosition(u)})
            EXPECT_NEAR(position, sign * Real(0.5), kNear);
        for (const Real rate :
             {dJointGetPRPositionRate(r1), dJointGetPistonPositionRate(p), dJointGetPUPositionRate(u)})
            EXPECT_NEAR(rate, sign * 3, kNear);
        Rig::place(a, {0, 0, 0}, turn(kZ, Real(0.3)));
        EXPECT_NEAR(dJointGetPRAngle(r1), sign * Real(0.3), kNear);
        EXPECT_NEAR(dJointGetPRAngleRate(r1), sign * 2, kNear);
        Rig::place(a, {0, 0, 0}, turn(kX, Real(0.3)));
        Rig::velocity(a, {}, {4, 0, 0});
        EXPECT_NEAR(dJointGetPistonAngle(p), sign * Real(0.3), kNear);
        EXPECT_NEAR(dJointGetPistonAngleRate(p), sign * 4, kNear);
    }
}

// What the original does not do: attached as (0, B), away from the anchor, errors point back.
TEST_F(Sliding, reversed_to_the_world_pulls_back_to_the_line)
{
    Rig::place(a, {0, 0, 0}, turn({1, 2, 3}, 1));
    const dJointID joints[] = {pr(kX, kZ, {0, 0, 1}, nullptr, a), piston(kX, {0, 0, 1}, nullptr, a),
                               pu(kY, kZ, kX, {0, 0, 1}, nullptr, a)};
    shift(a, {Real(0.7), Real(0.1), Real(-0.2)});
    for (const dJointID j : joints) {
        Vec3 pull;
        for (const Row& row : rig.emit(j).rows) pull += row.error * row.lin1;
        EXPECT_NEAR(pull.x, 0, 10 * kNear);
        EXPECT_NEAR(pull.y, -0.1, 10 * kNear);
        EXPECT_NEAR(pull.z, 0.2, 10 * kNear);
    }
}

TEST_F(Sliding, offsets_read_as_given)
{
    for (const bool reversed : {false, true}) {
        Rig::place(a, {0, 0, 0}, turn({1, 2, 3}, 1));
        Body *first = reversed ? nullptr : a, *second = reversed ? a : b;
        const dJointID p = piston(kZ, {1, 0, 0}, first, second), u = pu(kX, kY, kZ, {1, 0, 0}, first, second);
        dJointSetPistonAnchorOffset(p, 1, 2, 3, Real(0.1), Real(0.2), Real(0.3));
        dJointSetPUAnchorOffset(u, 1, 2, 3, Real(0.1), Real(0.2), Real(0.3));
        EXPECT_NEAR(dJointGetPistonPosition(p), 0.3, 10 * kNear);
        EXPECT_NEAR(dJointGetPUPosition(u), 0.3, 10 * kNear);
        dJointSetPUAnchorDelta(u, 1, 2, 3, Real(0.1), Real(0.2), Real(0.3));
        EXPECT_NEAR(dJointGetPUPosition(u), reversed ? 0.3 : -0.3, 10 * kNear);
    }
}

TEST_F(Sliding, piston_force_pushes_the_bodies_apart_without_turning_the_pair)
{
    const dJointID j = piston(kX, {1, Real(0.5), 0}, a, b);
    dJointAddPistonForce(j, 3);
    EXPECT_NEAR(a->facc[0], 3, kNear);
    EXPECT_NEAR(b->facc[0], -3, kNear);
    EXPECT_NEAR(a->tacc[2], -1.5, kNear);
    EXPECT_NEAR(a->tacc[2] + b->tacc[2], 0, kNear);
    const dJointID reversed = piston(kX, {0, 0, 0}, nullptr, b);
    dJointAddPistonForce(reversed, 2);
    EXPECT_NEAR(b->facc[0], -5, kNear);
}

TEST_F(Sliding, pr_torque_turns_about_the_second_axis)
{
    const dJointID j = pr(kX, kZ, {0, 0, 0}, a, b);
    dJointAddPRTorque(j, 2);
    EXPECT_NEAR(a->tacc[2], 2, kNear);
    EXPECT_NEAR(b->tacc[2], -2, kNear);
}

TEST_F(Sliding, refuses_bad_numbers_and_other_joints)
{
    const dJointID p = piston(kX, {1, 0, 0}, a, b);
    dJointSetPistonAxis(p, 0, 0, 0);
    dJointSetPistonAnchorOffset(p, 1, 2, 3, kInf, 0, 0);
    dJointSetPistonAxisDelta(p, 1, 0, 0, 0, kInf, 0);
    dJointSetPistonParam(p, dParamVel, kInf);
    dJointAddPistonForce(p, kInf);
    dJointGetPistonAnchor(p, r);
    EXPECT_EQ(r[0], 1);
    EXPECT_EQ(dJointGetPistonPosition(p), 0);
    EXPECT_EQ(dJointGetPistonParam(p, dParamVel), 0);
    EXPECT_EQ(a->facc[0], 0);
    EXPECT_EQ(dJointGetPRPosition(p) + dJointGetPUPosition(p), 0);
    const dJointID loose = dJointCreatePU(rig.id(), nullptr);
    dJointSetPUAnchor(loose, 1, 2, 3);
    EXPECT_EQ(dJointGetPUPosition(loose) + dJointGetPUAngle1(loose) + dJointGetPUPositionRate(loose), 0);
    EXPECT_EQ(dJointGetPRAngle(dJointCreatePR(rig.id(), nullptr)), 0);
}

}  // namespace
}  // namespace epode::test
