// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// MJCF in worlds: limits of balls, mocap bodies, exclusions of what is fixed to the world, limits that are violated, priorities, words
// that are none. python/tests/test_mjcf.py compares with MuJoCo.
#include <ode/ext.h>

#include <cmath>

#include "robot_in_world.h"
#include "robots/load.h"
#include "robots/write/write.h"

namespace {

using epode::robots::load_robot_text;
using epode::robots::RobotModel;

class MjcfActs : public RobotInWorld {
  protected:
    void step(int count, double h = 0.002)
    {
        for (int i = 0; i < count; ++i) dWorldStep(world, dReal(h));
    }
};

std::string error_of(const std::string& text)
{
    for (const auto& line : load_robot_text("robot.xml", text).report)
        if (line.note == epode::robots::Note::kError) return std::to_string(line.line) + ": " + line.text;
    return {};
}

TEST_F(MjcfActs, a_ball_stops_where_its_angle_is_the_limit)
{
    load(
        "<mujoco><compiler angle='radian'/><worldbody><body pos='0 0 1'><joint type='ball' range='0 0.5'/>"
        "<geom type='capsule' size='0.02' fromto='0 0 0 0.5 0 0' mass='1'/></body></worldbody></mujoco>");
    const dReal velocities[3] = {1, -2, dReal(0.5)};
    dRobotSetVelocities(robot, velocities, 3);
    step(500);
    dReal q[4];
    dRobotGetPositions(robot, q, 4);
    EXPECT_NEAR(2 * std::acos(std::min(1.0, std::fabs(double(q[0])))), 0.5, 0.01);
}

TEST_F(MjcfActs, a_ball_with_a_spring_swings_as_a_pendulum_of_torsion_about_any_axis)
{
    const double k = 2, moment = 0.4 * 10 * 0.01;  // a solid ball of 10 kg and 0.1 m about its centre
    load(
        "<mujoco><worldbody><body><joint type='ball' stiffness='2'/><geom size='0.1' "
        "mass='10'/></body></worldbody></mujoco>");
    const double w0 = 0.3, omega = std::sqrt(k / moment), t = 0.4;
    const double n = std::sqrt(1 + 4 + 4);
    const dReal velocities[3] = {dReal(w0 / n), dReal(2 * w0 / n), dReal(-2 * w0 / n)};
    dRobotSetVelocities(robot, velocities, 3);
    step(int(t / 1e-4 + 0.5), 1e-4);
    dReal q[4];
    dRobotGetPositions(robot, q, 4);
    const double angle = w0 / omega * std::sin(omega * t);
    EXPECT_NEAR(double(q[1]), std::sin(angle / 2) / n, 2e-4);
    EXPECT_NEAR(double(q[3]), -2 * std::sin(angle / 2) / n, 2e-4);
}

TEST_F(MjcfActs, what_is_welded_to_a_mocap_body_stands_with_it_and_goes_where_it_is_put)
{
    dWorldSetGravity(world, 0, 0, dReal(-9.81));
    load(
        "<mujoco><worldbody><body name='target' mocap='true' pos='0 0 1'/><body name='hand' pos='0.1 0 "
        "1'><freejoint/>"
        "<geom size='0.05'/></body></worldbody><equality><weld body1='target' "
        "body2='hand'/></equality></mujoco>");
    ASSERT_EQ(dRobotModelGetNumMocap(model), 1);
    const int link = dRobotModelGetMocap(model, 0);
    EXPECT_EQ(link, dRobotModelFindLink(model, "target"));
    step(200);
    dReal q[7];
    dRobotGetPositions(robot, q, 7);
    EXPECT_NEAR(double(q[0]), 0.1, 1e-6);
    EXPECT_NEAR(double(q[2]), 1, 1e-6);
    const dReal there[3] = {0, dReal(0.2), dReal(1.1)}, turned[4] = {1, 0, 0, 1};
    EXPECT_EQ(dRobotSetMocap(robot, link, there, turned), 1);
    EXPECT_EQ(dRobotSetMocap(robot, dRobotModelFindLink(model, "hand"), there, nullptr), 0);
    step(2000);
    dRobotGetPositions(robot, q, 7);
    EXPECT_NEAR(double(q[0]), 0, 1e-3);
    EXPECT_NEAR(double(q[1]), 0.3, 1e-3);
    EXPECT_NEAR(double(q[2]), 1.1, 1e-3);
}

TEST(MjcfWords, that_are_none_are_errors_with_the_nearest_one)
{
    EXPECT_NE(error_of("<mujoco><worldbody>\n<body><freejoint/><geom sizze='1'/></body></worldbody></mujoco>")
                  .find("2: <geom> has no attribute 'sizze'; did you mean 'size'?"),
              std::string::npos);
    EXPECT_NE(error_of("<mujoco><worldbody><bdoy/></worldbody></mujoco>").find("did you mean 'body'?"),
              std::string::npos);
    EXPECT_NE(
        error_of("<mujoco><worldbody><geom name='a' size='1'/><geom name='a' size='1'/></worldbody></mujoco>")
            .find("'a'"),
        std::string::npos);
    EXPECT_EQ(error_of("<mujoco><compiler exactmeshinertia='true'/><worldbody><geom name='a' size='1'/><site "
                       "name='a'/></worldbody></mujoco>"),
              "");
}

// They stand apart, and are written again.
TEST(MjcfExclusions, of_a_body_fixed_to_the_world_concern_it_alone)
{
    const std::string text =
        "<mujoco><worldbody><geom size='1'/><body name='torso'><geom size='0.5'/></body><body "
        "name='arm'><freejoint/><geom "
        "size='0.1'/></body></worldbody><contact><exclude body1='torso' body2='arm'/></contact></mujoco>";
    for (const RobotModel& model :
         {load_robot_text("robot.xml", text),
          load_robot_text("robot.xml", write_mjcf(load_robot_text("robot.xml", text), ".").text)}) {
        ASSERT_FALSE(model.has_errors());
        ASSERT_EQ(model.still.size(), 1u);
        EXPECT_EQ(model.excluded_still, (std::vector<std::array<int, 2>>{{1, 1}}));
        int apart = 0;
        for (const auto& shape : model.links[0].shapes) apart += shape.still == 1;
        EXPECT_EQ(apart, 1);
        EXPECT_EQ(model.links[0].shapes.size(), 2u);
    }
}

TEST_F(MjcfActs, a_violated_limit_does_not_throw_the_faster_the_smaller_the_step_is)
{
    for (const double h : {1e-2, 1e-3, 1e-4}) {
        load(
            "<mujoco><compiler angle='radian'/><worldbody><body><joint axis='0 1 0' range='0.25 3'/>"
            "<geom type='capsule' size='0.02' fromto='0 0 0 0.5 0 0' mass='1'/></body></worldbody></mujoco>");
        step(int(0.1 / h), h);
        dReal v;
        dRobotGetVelocities(robot, &v, 1);
        EXPECT_NEAR(double(v), 5, 0.3) << h;  // 20/s of 0.25 rad
    }
}

// v = exp(-d t / m) of its centre and exp(-d t / I) of its turn; friction takes f t / m off, and holds what it stops.
TEST_F(MjcfActs, dampers_and_friction_of_a_free_joint_brake_a_ball_as_in_closed_form)
{
    const double mass = 2, moment = 0.4 * mass * 0.01, damping = 0.02, friction = 0.01, t = 0.5;
    const double kFine = sizeof(dReal) == 8 ? 1e-5 : 1e-3;
    const dReal v[6] = {1, -2, 0, 0, 0, 3};
    const auto after = [&](const std::string& words) {
        load("<mujoco><worldbody><body><joint type='free' " + words +
             "/><geom size='0.1' mass='2'/></body></worldbody></mujoco>");
        dRobotSetVelocities(robot, v, 6);
        for (int i = 0; i < 5000; ++i) dRobotAddForces(robot, dReal(1e-4)), dWorldStep(world, dReal(1e-4));
        std::array<dReal, 6> out{};
        dRobotGetVelocities(robot, out.data(), 6);
        return out;
    };
    const auto slow = after("damping='0.02'");
    EXPECT_NEAR(double(slow[0]), std::exp(-damping * t / mass), kFine);
    EXPECT_NEAR(double(slow[1]), -2 * std::exp(-damping * t / mass), kFine);
    EXPECT_NEAR(double(slow[5]), 3 * std::exp(-damping * t / moment), 1e-3);
    const auto braked = after("frictionloss='0.01'");
    EXPECT_NEAR(double(braked[0]), 1 - friction * t / mass, kFine);
    EXPECT_NEAR(double(braked[2]), 0, kFine);
    EXPECT_NEAR(double(braked[5]), 3 - friction * t / moment, 10 * kFine);
    EXPECT_NEAR(double(after("frictionloss='20'")[1]), 0, kFine);
}

}  // namespace
