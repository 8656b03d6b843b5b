// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The linear motor: axes follow the body they are given to, rows drive the centres' relative velocity, stops
// do nothing, momentum and its moment stay.
#include <gtest/gtest.h>

#include "rig.h"

namespace epode::test {
namespace {

constexpr Real kTight = kSingle ? Real(1e-5) : Real(1e-12);
constexpr Real kStepped = kSingle ? Real(5e-3) : Real(1e-6);  // the default CFM's softness

struct LMotorTest : testing::Test {
    Rig rig;
    dJointID joint = dJointCreateLMotor(rig.id(), nullptr);
    Vec3 axis(int i) const
    {
        dVector3 out;
        dJointGetLMotorAxis(joint, i, out);
        return load(out);
    }
};

TEST_F(LMotorTest, begins_without_axes_and_keeps_their_number_in_range)
{
    EXPECT_EQ(dJointGetType(joint), dJointTypeLMotor);
    EXPECT_EQ(dJointGetLMotorNumAxes(joint), 0);
    for (const auto& [given, kept] : {std::pair{2, 2}, {3, 3}, {4, 3}, {-1, 0}}) {
        dJointSetLMotorNumAxes(joint, given);
        EXPECT_EQ(dJointGetLMotorNumAxes(joint), kept);
    }
}

TEST_F(LMotorTest, stores_axes_in_the_frame_they_move_with)
{
    Body* a = rig.body({1, 2, 3}, turn({0, 0, 1}, kPi / 2));
    Body* b = rig.body({0, 1, 0}, turn({1, 0, 0}, kPi / 2));
    Rig::join(joint, a, b);
    dJointSetLMotorAxis(joint, 0, 0, 0, 3, 4);
    dJointSetLMotorAxis(joint, 1, 1, 0, 2, 0);
    dJointSetLMotorAxis(joint, 2, 2, 0, 0, 5);
    EXPECT_LT(length(axis(0) - Vec3{0, Real(0.6), Real(0.8)}), kTight);
    EXPECT_LT(length(axis(1) - Vec3{1, 0, 0}), kTight);
    EXPECT_LT(length(axis(2) - Vec3{0, 1, 0}), kTight);
}

TEST_F(LMotorTest, takes_body_1_where_body_2_is_missing)
{
    Body* a = rig.body({}, turn({0, 0, 1}, kPi / 2));
    Rig::join(joint, a);
    dJointSetLMotorAxis(joint, 0, 2, 0, 1, 0);
    EXPECT_LT(length(axis(0) - Vec3{1, 0, 0}), kTight);
}

TEST_F(LMotorTest, refuses_bad_axes_and_changes_nothing)
{
    Rig::join(joint, rig.body({}));
    dJointSetLMotorAxis(joint, 0, 0, 0, 0, 1);
    for (int i : {-1, 3}) dJointSetLMotorAxis(joint, i, 0, 1, 0, 0);
    for (int rel : {-1, 3}) dJointSetLMotorAxis(joint, 0, rel, 1, 0, 0);
    dJointSetLMotorAxis(joint, 0, 0, 0, 0, 0);
    dJointSetLMotorAxis(joint, 0, 0, std::numeric_limits<Real>::quiet_NaN(), 0, 0);
    dJointSetLMotorAxis(dJointCreateNull(rig.id(), nullptr), 0, 0, 1, 0, 0);
    EXPECT_EQ(axis(0), (Vec3{0, 0, 1}));
}

TEST_F(LMotorTest, writes_a_row_only_where_it_has_an_axis_and_force)
{
    Rig::join(joint, rig.body({1, 0, 0}), rig.body({0, 2, 0}));
    dJointSetLMotorNumAxes(joint, 2);
    dJointSetLMotorParam(joint, dParamFMax, 5);
    EXPECT_TRUE(rig.emit(joint).rows.empty()) << "no axis yet";
    dJointSetLMotorAxis(joint, 0, 0, 1, 0, 0);
    dJointSetLMotorAxis(joint, 1, 0, 0, 1, 0);
    EXPECT_EQ(rig.emit(joint).rows.size(), 1u) << "axis 1 has no force";
    dJointSetLMotorParam(joint, dParamFMax3, 5);
    EXPECT_EQ(rig.emit(joint).rows.size(), 1u) << "axis 2 is not in use";
    dJointSetLMotorParam(joint, dParamFMax2, 5);
    EXPECT_EQ(rig.emit(joint).rows.size(), 2u);
}

TEST_F(LMotorTest, asks_for_its_speed_within_its_force_whatever_the_stops)
{
    Body *a = rig.body({1, 0, 0}), *b = rig.body({0, 2, 0});
    Rig::join(joint, a, b);
    dJointSetLMotorNumAxes(joint, 1);
    dJointSetLMotorAxis(joint, 0, 0, 0, 0, 1);
    dJointSetLMotorParam(joint, dParamVel, 2);
    dJointSetLMotorParam(joint, dParamFMax, 7);
    dJointSetLMotorParam(joint, dParamLoStop, 3);
    dJointSetLMotorParam(joint, dParamHiStop, 4);
    const Emitted e = rig.emit(joint);
    ASSERT_EQ(e.rows.size(), 1u);
    EXPECT_FALSE(e.applied);
    const Row& r = e.rows[0];
    EXPECT_EQ(rig.c(r), 2);
    EXPECT_EQ(r.lo, -7);
    EXPECT_EQ(r.hi, 7);
    EXPECT_EQ(r.lin1, (Vec3{0, 0, 1}));
    EXPECT_EQ(r.lin2, (Vec3{0, 0, -1}));
    const Vec3 couple = Real(0.5) * cross(b->position() - a->position(), r.lin1);
    EXPECT_LT(length(r.ang1 - couple), kTight);
    EXPECT_LT(length(r.ang2 - couple), kTight);
}

TEST_F(LMotorTest, axis_turns_with_its_body)
{
    Body* a = rig.body({});
    Rig::join(joint, a);
    dJointSetLMotorNumAxes(joint, 1);
    dJointSetLMotorParam(joint, dParamFMax, 1);
    dJointSetLMotorAxis(joint, 0, 1, 1, 0, 0);
    Rig::place(a, {}, turn({0, 0, 1}, kPi / 2));
    EXPECT_LT(length(rig.emit(joint).rows[0].lin1 - Vec3{0, 1, 0}), kTight);
    dJointSetLMotorAxis(joint, 0, 0, 1, 0, 0);
    Rig::place(a, {}, turn({0, 0, 1}, 1));
    EXPECT_LT(length(rig.emit(joint).rows[0].lin1 - Vec3{1, 0, 0}), kTight);
}

TEST_F(LMotorTest, drives_a_body_in_one_step_as_far_as_its_force_reaches)
{
    Body* a = rig.body({});
    Rig::join(joint, a);
    dJointSetLMotorNumAxes(joint, 1);
    dJointSetLMotorAxis(joint, 0, 0, 1, 0, 0);
    dJointSetLMotorParam(joint, dParamVel, 2);
    dJointSetLMotorParam(joint, dParamFMax, 50);
    dWorldStep(rig.id(), Real(0.01));
    EXPECT_NEAR(a->velocity().x, 0.5, kStepped) << "50 N for 0.01 s on 1 kg";
    dJointSetLMotorParam(joint, dParamFMax, 1000);
    dWorldStep(rig.id(), Real(0.01));
    EXPECT_NEAR(a->velocity().x, 2, kStepped);
}

}  // namespace
}  // namespace epode::test
