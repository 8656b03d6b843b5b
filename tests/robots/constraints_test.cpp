// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Couplings and loops of a model: their derivative, and inverse kinematics that keeps them, on grippers whose fingers are
// parallelograms, so that every coordinate is a formula of the crank's angle.
#include <epode/robots.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "robots/constraints.h"
#include "robots/kinematics.h"
#include "robots/load.h"

using namespace epode::robots;

namespace {

constexpr bool kIsDouble = sizeof(dReal) == 8;
constexpr double kFine = kIsDouble ? 1e-9 : 2e-4;

// A hinge, a ball and a free body, a weld between the last two and a connection and a coupling between the first ones.
const char* const kLoops =
    "<mujoco><compiler angle='radian'/><worldbody>"
    "<body name='arm'><joint name='h' axis='0 1 0'/><geom size='0.1'/>"
    "<body name='slide' pos='0.5 0 0'><joint name='s' type='slide' axis='1 0 1'/><geom size='0.1'/>"
    "<body name='hand' pos='0.2 0.1 0'><joint name='b' type='ball'/><geom size='0.1'/></body></body></body>"
    "<body name='free' pos='0 0 1'><freejoint/><geom size='0.1'/></body></worldbody>"
    "<equality><weld body1='hand' body2='free' relpose='0.1 0.2 0.3 0.8 0.6 0 0'/>"
    "<connect body1='slide' body2='free' anchor='0.1 0 0.2'/>"
    "<joint joint1='s' joint2='h' polycoef='0.1 0.4 0 0 0'/></equality></mujoco>";

TEST(Constraints, jacobian_is_the_derivative_of_the_errors)
{
    const RobotModel model = load_robot_text("loops.xml", kLoops);
    ASSERT_FALSE(model.has_errors());
    const size_t n = size_t(number_of_velocities(model));
    std::vector<double> v(n);
    for (size_t k = 0; k < n; ++k) v[k] = 0.3 * std::cos(double(k));
    const std::vector<double> q = moved_positions(model, reference_positions(model), v);
    const std::vector<double> c = constraint_errors(model, q), rows = constraint_jacobian(model, q);
    ASSERT_EQ(c.size(), 10u);
    ASSERT_EQ(rows.size(), 10 * n);
    const double h = 1e-6;
    for (size_t k = 0; k < n; ++k) {
        std::vector<double> unit(n, 0);
        unit[k] = h;
        const std::vector<double> after = constraint_errors(model, moved_positions(model, q, unit));
        unit[k] = -h;
        const std::vector<double> before = constraint_errors(model, moved_positions(model, q, unit));
        for (size_t i = 0; i < 10; ++i)
            EXPECT_NEAR((after[i] - before[i]) / (2 * h), rows[i * n + k], 1e-8)
                << "row " << i << " velocity " << k;
    }
}

class ConstrainedInverse : public testing::Test {
  protected:
    ConstrainedInverse() { dInitODE2(0); }
    ~ConstrainedInverse() override
    {
        if (model) dRobotModelDestroy(model);
        dCloseODE();
    }
    void load(const std::string& path)
    {
        model = dRobotModelLoad(path.c_str(), nullptr);
        ASSERT_EQ(dRobotModelHasErrors(model), 0);
        q.resize(size_t(dRobotModelGetNumPositions(model)));
        dRobotModelGetReference(model, q.data(), int(q.size()));
    }
    int reach(const char* link, double x, double y, double z)
    {
        dRobotTarget target;
        dRobotTargetInit(&target, dRobotModelFindLink(model, link));
        target.orientation_weight = 0;
        target.position[0] = dReal(x), target.position[1] = dReal(y), target.position[2] = dReal(z);
        return dRobotModelGetInverse(model, &target, 1, nullptr, q.data(), nullptr);
    }
    double at(const char* joint) const
    {
        std::vector<dRobotJoint> joints(size_t(dRobotModelGetJoints(model, nullptr, 0)));
        dRobotModelGetJoints(model, joints.data(), int(joints.size()));
        return double(q[size_t(joints[size_t(dRobotModelFindJoint(model, joint))].position)]);
    }
    double constraint_error() const
    {
        std::vector<dReal> errors(size_t(dRobotModelGetConstraints(model, q.data(), nullptr, nullptr, 0)));
        dRobotModelGetConstraints(model, q.data(), errors.data(), nullptr, int(errors.size()));
        double sum = 0;
        for (dReal error : errors) sum += double(error) * double(error);
        return std::sqrt(sum);
    }
    dRobotModelID model = nullptr;
    std::vector<dReal> q;
};

TEST_F(ConstrainedInverse, a_four_bar_loop_stays_closed)
{
    load(EPODE_MODELS "/fourbar.xml");
    for (double angle : {0.3, -0.8, 1.2}) {
        ASSERT_EQ(reach("coupler", 0.3 * std::sin(angle), 0, 0.3 * std::cos(angle)), 1) << angle;
        EXPECT_NEAR(at("crank"), angle, kFine);
        EXPECT_NEAR(at("coupler"), -angle, kFine);
        EXPECT_NEAR(at("rocker"), angle, kFine);
    }
}

TEST_F(ConstrainedInverse, a_gripper_of_four_bars_follows_its_mimic)
{
    load(EPODE_DEMOS "/fourbar_gripper.xml");
    for (double angle : {-0.5, -1.1, 0.4}) {
        ASSERT_EQ(reach("left_finger", 0, 0.03 - 0.08 * std::sin(angle), 0.42 + 0.08 * std::cos(angle)), 1)
            << angle;
        for (const char* joint : {"left_crank", "left_follower", "right_finger"})
            EXPECT_NEAR(at(joint), angle, kFine) << joint;
        for (const char* joint : {"right_crank", "right_follower", "left_finger"})
            EXPECT_NEAR(at(joint), -angle, kFine) << joint;
    }
}

// Above its reach the crank points up, and the loops are closed all the same.
TEST_F(ConstrainedInverse, loops_hold_where_the_target_is_out_of_reach)
{
    load(EPODE_DEMOS "/fourbar_gripper.xml");
    for (dReal& value : q) value = dReal(0.1);
    ASSERT_EQ(reach("left_finger", 0.2, 0.03, 1), 2);
    EXPECT_LE(constraint_error(), kIsDouble ? 1e-12 : 1e-6);
    EXPECT_NEAR(at("left_crank"), 0, 1e-3);
    EXPECT_NEAR(at("right_crank"), 0, 1e-3);
}

TEST_F(ConstrainedInverse, mimicking_fingers_move_together)
{
    load(EPODE_MODELS "/arm.urdf");
    const std::vector<dReal> wanted{dReal(0.4), dReal(-1.1), dReal(0.02), dReal(-0.02)};
    ASSERT_EQ(q.size(), wanted.size());
    const int rows = dRobotModelGetConstraints(model, wanted.data(), nullptr, nullptr, 0);
    ASSERT_EQ(rows, 1);
    std::vector<dReal> jacobian(4);
    ASSERT_EQ(dRobotModelGetConstraints(model, q.data(), nullptr, jacobian.data(), 1), 1);
    std::vector<dReal> poses(7 * size_t(dRobotModelGetLinks(model, nullptr, 0)));
    const int finger = dRobotModelGetLinks(model, nullptr, 0) - 1;  // the one that mimics
    dRobotModelGetPoses(model, wanted.data(), 4, poses.data(), finger + 1);
    std::vector<dRobotLink> links(size_t(finger) + 1);
    dRobotModelGetLinks(model, links.data(), finger + 1);
    const dReal* p = &poses[7 * size_t(finger)];
    q = {dReal(0.3), dReal(-1), dReal(0.01), dReal(0.01)};
    const int found = reach(links[size_t(finger)].name, double(p[0]), double(p[1]), double(p[2]));
    EXPECT_LE(constraint_error(), kIsDouble ? 1e-9 : 1e-5);
    EXPECT_EQ(found, 1);
}

}  // namespace
