// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The plane joint: three rows against the world, three motors behind them, and what a step makes of it.
#include <gtest/gtest.h>

#include "rig.h"

namespace epode::test {
namespace {

constexpr Real kStep = Real(0.01);
constexpr Real kStepped = kSingle ? Real(5e-3) : Real(1e-6);  // the default CFM's softness

struct Plane2DTest : testing::Test {
    Rig rig;
    dJointID joint = dJointCreatePlane2D(rig.id(), nullptr);
    Body* body = rig.body({2, 3, Real(0.1)}, turn({1, 2, 3}, 1));
    void SetUp() override { Rig::join(joint, body); }
};

TEST_F(Plane2DTest, holds_height_and_the_two_rates_of_tilt)
{
    EXPECT_EQ(dJointGetType(joint), dJointTypePlane2D);
    const std::vector<Row> rows = rig.emit(joint).rows;
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0].lin1, (Vec3{0, 0, 1}));
    EXPECT_NEAR(rig.c(rows[0]), -2, 1e-5) << "erp/h times the height";
    const Vec3 axes[2] = {{1, 0, 0}, {0, 1, 0}};
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(length2(rows[std::size_t(i) + 1].lin1), 0);
        EXPECT_EQ(rows[std::size_t(i) + 1].ang1, axes[i]);
        EXPECT_EQ(rig.c(rows[std::size_t(i) + 1]), 0);
    }
    for (const Row& r : rows) {
        EXPECT_EQ(r.lo, -kInf);
        EXPECT_EQ(r.hi, kInf);
        EXPECT_EQ(r.kind, RowKind::kLock);
    }
}

TEST_F(Plane2DTest, adds_a_row_for_each_motor_with_force)
{
    dJointSetPlane2DXParam(joint, dParamFMax, 1);
    dJointSetPlane2DXParam(joint, dParamVel, 4);
    dJointSetPlane2DYParam(joint, dParamFMax, 2);
    dJointSetPlane2DYParam(joint, dParamVel, 5);
    dJointSetPlane2DAngleParam(joint, dParamFMax, 3);
    dJointSetPlane2DAngleParam(joint, dParamVel, 6);
    dJointSetPlane2DAngleParam(joint, dParamHiStop, 0);
    const std::vector<Row> rows = rig.emit(joint).rows;
    ASSERT_EQ(rows.size(), 6u);
    EXPECT_EQ(rows[3].lin1, (Vec3{1, 0, 0}));
    EXPECT_EQ(rows[4].lin1, (Vec3{0, 1, 0}));
    EXPECT_EQ(rows[5].ang1, (Vec3{0, 0, 1}));
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(rows[std::size_t(i) + 3].hi, i + 1);
        EXPECT_EQ(rows[std::size_t(i) + 3].lo, -i - 1);
        EXPECT_EQ(rig.c(rows[std::size_t(i) + 3]), i + 4);
    }
}

TEST_F(Plane2DTest, refuses_what_is_no_plane_joint_and_no_number)
{
    const dJointID other = dJointCreateNull(rig.id(), nullptr);
    dJointSetPlane2DXParam(other, dParamFMax, 1);
    dJointSetPlane2DXParam(nullptr, dParamFMax, 1);
    dJointSetPlane2DYParam(joint, dParamFMax, -1);
    dJointSetPlane2DAngleParam(joint, dParamFMax, std::numeric_limits<Real>::quiet_NaN());
    EXPECT_EQ(rig.emit(joint).rows.size(), 3u);
}

TEST_F(Plane2DTest, corrects_height_and_stops_tilting_in_a_step)
{
    Rig::place(body, {0, 0, Real(0.1)});
    Rig::velocity(body, {}, {1, 1, 1});
    dWorldStep(rig.id(), kStep);
    EXPECT_NEAR(body->velocity().z, -2, kStepped);
    EXPECT_LT(length(body->angular_velocity() - Vec3{0, 0, 1}), kStepped);
}

TEST_F(Plane2DTest, keeps_a_pushed_body_in_the_plane)
{
    Rig::place(body, {});
    dWorldSetGravity(rig.id(), 0, 0, -10);
    for (int i = 0; i < 200; ++i) {
        dBodyAddForceAtPos(to_handle(body), 1, 2, 3, Real(0.3), Real(-0.2), Real(0.5));
        dWorldStep(rig.id(), kStep);
    }
    const Vec3 p = body->position();
    EXPECT_NEAR(p.z, 0, kStepped);
    EXPECT_NEAR(p.x, 0.5 * kStep * kStep * 200 * 201, 1e-3) << "free along x";
    EXPECT_NEAR(body->rotation().column(2).z, 1, 1e-5) << "upright";
}

}  // namespace
}  // namespace epode::test
