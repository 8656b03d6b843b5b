// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Double ball and double hinge: what is kept, from which frames, and what is not while nothing has been set.
#include <gtest/gtest.h>

#include "ode/objects.h"
#include "row_lines.h"

namespace epode::test {
namespace {

constexpr Real kNear = kSingle ? Real(1e-5) : Real(1e-12);

struct RodEnds : testing::Test {
    Rig rig;
    Body* a = rig.body({0, 0, 0});
    Body* b = rig.body({2, 0, 0});
    dJointID ball = dJointCreateDBall(rig.id(), nullptr);
    dJointID hinge = dJointCreateDHinge(rig.id(), nullptr);
    dVector3 r = {0, 0, 0, 0};
};

TEST_F(RodEnds, measure_on_attaching_and_on_setting)
{
    Rig::join(ball, a, b);
    EXPECT_EQ(dJointGetDBallDistance(ball), 2);
    dJointSetDBallAnchor1(ball, Real(0.5), 0, 0);
    EXPECT_EQ(dJointGetDBallDistance(ball), 1.5);
    Rig::place(b, {Real(2.1), 0, 0});
    EXPECT_EQ(dJointGetDBallDistance(ball), 1.5) << "the one to keep";
    const Row row = rig.emit(ball).rows.at(0);
    EXPECT_NEAR(row.error, -0.1, kNear);
    EXPECT_NEAR(row.lin1.x, -1, kNear);
    dJointSetDBallDistance(ball, Real(1.7));
    EXPECT_NEAR(rig.emit(ball).rows.at(0).error, 0.1, kNear);
    dJointSetDBallDistance(ball, -1);
    dJointSetDBallDistance(ball, kInf);
    EXPECT_EQ(dJointGetDBallDistance(ball), Real(1.7));
}

TEST_F(RodEnds, belong_to_the_bodies_as_the_client_counts_them)
{
    Rig::join(ball, nullptr, a);
    dJointSetDBallAnchor1(ball, 0, 5, 0);
    dJointSetDBallAnchor2(ball, 0, 1, 0);
    Rig::place(a, {1, 0, 0});
    dJointGetDBallAnchor1(ball, r);
    EXPECT_EQ(r[0], 0) << "the world's";
    dJointGetDBallAnchor2(ball, r);
    EXPECT_EQ(r[0], 1);
}

TEST_F(RodEnds, given_before_the_bodies_are_in_frames_to_come)
{
    dJointSetDBallAnchor1(ball, 1, 0, 0);
    dJointSetDBallAnchor2(ball, 0, 1, 0);
    EXPECT_NEAR(dJointGetDBallDistance(ball), std::sqrt(Real(2)), kNear);
    Rig::join(ball, a, b);
    dJointGetDBallAnchor2(ball, r);
    EXPECT_EQ(r[0], 2);
    EXPECT_EQ(r[1], 1);
}

TEST_F(RodEnds, in_one_place_part_along_their_velocity)
{
    Rig::join(ball, a, b);
    dJointSetDBallAnchor1(ball, 1, 1, 0);
    dJointSetDBallAnchor2(ball, 1, 1, 0);
    EXPECT_NEAR(rig.emit(ball).rows.at(0).lin1.x, 1, kNear) << "at rest: x";
    Rig::velocity(a, {0, 3, 0});
    EXPECT_NEAR(rig.emit(ball).rows.at(0).lin1.y, 1, kNear);
    dJointSetDBallDistance(ball, Real(0.1));
    EXPECT_NEAR(rig.emit(ball).rows.at(0).error, 0.1, kNear);
}

TEST_F(RodEnds, have_softness_of_their_own)
{
    Rig::join(ball, a, b);
    Rig::join(hinge, a, b);
    dJointSetDHingeAxis(hinge, 0, 0, 1);
    dJointSetDBallParam(ball, dParamCFM, Real(0.25));
    dJointSetDHingeParam(hinge, dParamERP, Real(0.75));
    dJointSetDHingeParam(hinge, dParamCFM, Real(0.25));
    EXPECT_EQ(rig.emit(ball).rows.at(0).cfm, Real(0.25));
    const std::vector<Row> rows = rig.emit(hinge).rows;
    ASSERT_EQ(rows.size(), 4u);
    for (const Row& row : rows) EXPECT_EQ(row.erp, Real(0.75));
    EXPECT_EQ(rows[0].cfm, Real(0.25));
    EXPECT_EQ(rows[3].cfm, rig.info.cfm);
    EXPECT_EQ(dJointGetDHingeParam(hinge, dParamERP), Real(0.75));
    EXPECT_EQ(dJointGetDHingeParam(hinge, dParamLoStop), 0);
}

TEST_F(RodEnds, of_a_double_hinge_without_axis_keep_their_distance_alone)
{
    Rig::join(hinge, a, b);
    EXPECT_EQ(rig.emit(hinge).rows.size(), 1u);
    dJointSetDHingeAxis(hinge, 0, 0, 0);
    EXPECT_EQ(rig.emit(hinge).rows.size(), 1u) << "a zero axis is refused";
    dJointGetDHingeAxis(hinge, r);
    EXPECT_EQ(r[0] + r[1] + r[2], 0);
    dJointSetDHingeAxis(hinge, 0, 0, 2);
    EXPECT_EQ(rig.emit(hinge).rows.size(), 4u);
    EXPECT_EQ(dJointGetDHingeDistance(hinge), 2);
}

// Turned about the axis and out of line: the rod's row is no longer that of the setting.
TEST_F(RodEnds, of_a_double_hinge_keep_jacobian_and_momentum_exact_in_any_position)
{
    Dice dice;
    for (int trial = 0; trial < 10; ++trial) {
        const Vec3 x = dice.vector();
        Rig::place(a, x, dice.rotation());
        Rig::place(b, x + Vec3{1, 1, 0}, dice.rotation());
        Rig::join(hinge, a, b);
        const Vec3 n = dice.unit(), across = normalized_or(cross(n, dice.unit()), {1, 0, 0});
        const Vec3 p = dice.vector(), q = p + Real(1.2) * across;
        dJointSetDHingeAxis(hinge, n.x, n.y, n.z);
        dJointSetDHingeAnchor1(hinge, p.x, p.y, p.z);
        dJointSetDHingeAnchor2(hinge, q.x, q.y, q.z);
        const Quat both = turn(n, dice.next());
        Rig::place(b, p + to_matrix(both) * (b->position() - p), both * b->orientation());
        for (const Row& row : rig.emit(hinge).rows) EXPECT_NEAR(row.error, 0, 200 * kEpsilon);
        expect_exact_derivative(rig, hinge, a, b);
        expect_momentum(rig, hinge, a, b);
    }
}

}  // namespace
}  // namespace epode::test
