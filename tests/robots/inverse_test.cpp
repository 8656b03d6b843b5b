// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Inverse kinematics of an arm of seven axes, from the user's side: what forward kinematics reaches is found again,
// what cannot be reached is approached as near as geometry allows, and said to be out of reach.
#include <epode/robots.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace {

constexpr bool kIsDouble = sizeof(dReal) == 8;

class RobotInverse : public testing::Test {
  protected:
    RobotInverse()
    {
        dInitODE2(0);
        model = dRobotModelLoad(EPODE_DEMOS "/arm.urdf", nullptr);
        joints.resize(size_t(dRobotModelGetJoints(model, nullptr, 0)));
        dRobotModelGetJoints(model, joints.data(), int(joints.size()));
        dReal frame[7];
        const int link = dRobotModelFindFrame(model, "pen", frame);
        dRobotTargetInit(&target, link);
        std::copy_n(frame, 3, target.point);
        std::copy_n(frame + 3, 4, target.point_q);
        result.struct_size = sizeof result;
        dRobotInverseOptionsInit(&options, sizeof options);
    }
    ~RobotInverse() override
    {
        dRobotModelDestroy(model);
        dCloseODE();
    }
    // Where the pen's tip is, and how it is turned.
    void pose_at(const std::vector<dReal>& q, dReal* position, dReal* turn) const
    {
        std::vector<dReal> poses(7 * size_t(dRobotModelGetLinks(model, nullptr, 0)));
        dRobotModelGetPoses(model, q.data(), int(q.size()), poses.data(), int(poses.size() / 7));
        const dReal* its = &poses[7 * size_t(target.link)];
        dMatrix3 r;
        dQtoR(its + 3, r);
        dVector3 p;
        dMultiply0_331(p, r, target.point);
        for (int i = 0; i < 3; ++i) position[i] = its[i] + p[i];
        dQMultiply0(turn, its + 3, target.point_q);
    }
    std::vector<dReal> random_positions()
    {
        std::vector<dReal> q;
        for (const dRobotJoint& joint : joints)
            q.push_back(joint.low + (joint.high - joint.low) * dReal(random() % 100000) / 100000);
        return q;
    }
    void expect_within_limits(const std::vector<dReal>& q) const
    {
        for (size_t i = 0; i < joints.size(); ++i) {
            EXPECT_GE(q[i], joints[i].low);
            EXPECT_LE(q[i], joints[i].high);
        }
    }
    // 1: reached, 2: not.
    int solve(std::vector<dReal>& q)
    {
        return dRobotModelGetInverse(model, &target, 1, &options, q.data(), &result);
    }

    std::mt19937 random{7};
    dRobotModelID model;
    std::vector<dRobotJoint> joints;
    dRobotTarget target;
    dRobotInverseOptions options;
    dRobotInverseResult result{};
};

TEST_F(RobotInverse, finds_two_hundred_poses_that_the_arm_reaches)
{
    int starts = 0;
    for (int i = 0; i < 200; ++i) {
        pose_at(random_positions(), target.position, target.q);
        std::vector<dReal> q(7, 0);
        ASSERT_EQ(solve(q), 1) << i;
        starts += result.starts;
        expect_within_limits(q);
        dVector3 place;
        dQuaternion turn;
        pose_at(q, place, turn);
        dReal alike = 0;
        for (int k = 0; k < 4; ++k) alike += turn[k] * target.q[k];
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(place[k], target.position[k], kIsDouble ? 1e-9 : 1e-5);
        EXPECT_LT(result.residual, kIsDouble ? 1e-9 : 1e-4);
        EXPECT_NEAR(std::fabs(alike), 1, kIsDouble ? 1e-12 : 1e-5);
    }
    RecordProperty("starts_of_200", starts);
    EXPECT_LT(starts, 1000);
}

TEST_F(RobotInverse, same_arguments_give_the_same_bits)
{
    pose_at(random_positions(), target.position, target.q);
    std::vector<dReal> one(7, 0), two(7, 0);
    solve(one), solve(two);
    EXPECT_EQ(one, two);
}

// The shoulder stands at (0, 0, 0.31), and the tip of the stretched arm 0.99 m from it.
TEST_F(RobotInverse, points_at_what_is_out_of_reach)
{
    target.orientation_weight = 0;
    const dReal far[3] = {2, 1, 1};
    std::copy_n(far, 3, target.position);
    std::vector<dReal> q(7, dReal(0.3));
    EXPECT_EQ(solve(q), 2);
    EXPECT_EQ(result.is_reached, 0);
    const double away = std::sqrt(4 + 1 + 0.69 * 0.69), reach = 0.2 + 0.2 + 0.2 + 0.2 + 0.03 + 0.16;
    EXPECT_NEAR(result.position_error, away - reach, kIsDouble ? 1e-9 : 1e-4);
    dVector3 place;
    dQuaternion turn;
    pose_at(q, place, turn);
    for (int k = 0; k < 3; ++k) {
        const double shoulder = k == 2 ? 0.31 : 0;
        EXPECT_NEAR(place[k], shoulder + (double(far[k]) - shoulder) * reach / away, kIsDouble ? 1e-5 : 1e-2);
    }
}

// Stretched upwards, all of three axes agree and two directions are lost.
TEST_F(RobotInverse, leaves_a_singular_position_without_a_jump)
{
    std::vector<dReal> q(7, 0);
    pose_at(q, target.position, target.q);
    target.position[2] -= dReal(0.02);
    options.max_starts = 2;
    EXPECT_EQ(solve(q), 1);
    for (dReal value : q) EXPECT_LT(std::fabs(value), 1.0);
    // Upwards there is nothing: it stays.
    std::vector<dReal> up(7, 0);
    pose_at(up, target.position, target.q);
    target.position[2] += dReal(0.02);
    EXPECT_EQ(solve(up), 2);
    EXPECT_NEAR(result.position_error, 0.02, 1e-3);
    for (dReal value : up) EXPECT_LT(std::fabs(value), 1e-3);
}

TEST_F(RobotInverse, follows_the_posture_where_the_target_leaves_a_choice)
{
    const std::vector<dReal> posture = {dReal(0.4), dReal(0.6), dReal(-0.5), dReal(1.2), dReal(0.3),
                                        dReal(0.5), 0};
    pose_at(posture, target.position, target.q);
    std::vector<dReal> q = {dReal(-0.5), dReal(1.1), dReal(1.2), dReal(1.0),
                            dReal(-1.0), dReal(0.8), dReal(1)};
    std::vector<dReal> free = q;
    ASSERT_EQ(solve(free), 1);
    options.posture = posture.data();
    ASSERT_EQ(solve(q), 1);
    double away = 0, before = 0;
    for (size_t i = 0; i < 7; ++i) {
        away += std::pow(double(q[i] - posture[i]), 2), before += std::pow(double(free[i] - posture[i]), 2);
    }
    EXPECT_GT(before, 0.1);
    EXPECT_LT(std::sqrt(away), kIsDouble ? 1e-5 : 1e-2);  // the posture itself is a solution
}

TEST_F(RobotInverse, locked_joints_stay_and_heavy_ones_move_less)
{
    std::vector<dReal> q = {0, dReal(0.5), 0, dReal(-0.8), 0, dReal(0.3), 0};
    dQuaternion turn;
    pose_at(q, target.position, turn);
    target.position[1] += dReal(0.05);
    target.orientation_weight = 0;
    std::vector<dReal> weights(7, 1);
    weights[0] = 0;
    options.weights = weights.data();
    std::vector<dReal> locked = q, light = q;
    ASSERT_EQ(solve(locked), 1);
    EXPECT_EQ(locked[0], q[0]);
    weights[0] = 10;
    ASSERT_EQ(solve(light), 1);
    EXPECT_GT(std::fabs(light[0]), 10 * std::fabs(light[2]));
}

TEST_F(RobotInverse, says_what_it_refuses)
{
    static int refused;
    refused = 0;
    dSetMessageHandler([](int, const char*, va_list) { ++refused; });
    std::vector<dReal> q(7, 0);
    target.link = 99;
    EXPECT_EQ(solve(q), 0);
    target.link = 1, target.q[0] = 0;
    EXPECT_EQ(solve(q), 0);
    target.q[0] = 1, options.max_starts = 0;
    EXPECT_EQ(solve(q), 0);
    options.max_starts = 1001;
    EXPECT_EQ(solve(q), 0);
    options.max_starts = 1, result.struct_size = 3;
    EXPECT_EQ(solve(q), 0);
    result.struct_size = sizeof result, q[0] = dReal(NAN);
    EXPECT_EQ(solve(q), 0);
    dReal frame[7];
    EXPECT_EQ(dRobotModelFindFrame(model, nullptr, frame), 0);
    EXPECT_EQ(refused, 7);
    EXPECT_EQ(dRobotModelFindFrame(model, "nobody", frame), -1);
    dSetMessageHandler(nullptr);
}

}  // namespace
