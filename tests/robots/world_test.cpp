// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Robots in worlds, through the C API: bodies stand where the model says, drives and couplings act as the file says.
#include <epode/robots.h>
#include <gtest/gtest.h>
#include <ode/ext.h>

#include <cmath>
#include <string>
#include <vector>

namespace {

const std::string kModels = EPODE_MODELS;
// What a library in floats can hold, and one in doubles.
constexpr double kExact = sizeof(dReal) == 8 ? 1e-9 : 1e-5, kFine = sizeof(dReal) == 8 ? 1e-6 : 1e-3;

class RobotTest : public testing::Test {
  protected:
    RobotTest()
    {
        dInitODE2(0);
        world = dWorldCreate();
        space = dHashSpaceCreate(nullptr);
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
    }
    ~RobotTest() override
    {
        if (robot) dRobotDestroy(robot);
        if (model) dRobotModelDestroy(model);
        dSpaceDestroy(space);
        dWorldDestroy(world);
        dCloseODE();
    }
    void load(const std::string& name)
    {
        model = dRobotModelLoad((kModels + "/" + name).c_str(), nullptr);
        ASSERT_NE(model, nullptr);
        ASSERT_EQ(dRobotModelHasErrors(model), 0);
        robot = dRobotCreate(world, space, model, nullptr, nullptr);
        ASSERT_NE(robot, nullptr);
    }
    void load_text(const std::string& text)
    {
        model = dRobotModelLoadText("robot.xml", text.data(), text.size(), nullptr);
        ASSERT_EQ(dRobotModelHasErrors(model), 0);
        robot = dRobotCreate(world, space, model, nullptr, nullptr);
        ASSERT_NE(robot, nullptr);
    }
    std::vector<dReal> positions() const
    {
        std::vector<dReal> q(size_t(dRobotGetPositions(robot, nullptr, 0)));
        dRobotGetPositions(robot, q.data(), int(q.size()));
        return q;
    }
    dReal position_of(const char* joint) const
    {
        std::vector<dRobotJoint> joints(size_t(dRobotModelGetJoints(model, nullptr, 0)));
        dRobotModelGetJoints(model, joints.data(), int(joints.size()));
        return positions()[size_t(joints[size_t(dRobotModelFindJoint(model, joint))].position)];
    }
    void step(int count, dReal h)
    {
        for (int i = 0; i < count; ++i) dWorldStep(world, h);
    }
    dWorldID world;
    dSpaceID space;
    dRobotModelID model = nullptr;
    dRobotID robot = nullptr;
};

// Bodies stand at their links' centres, and the coordinates come back.
void expect_round_trip(RobotTest&, dRobotModelID model, dRobotID robot, const std::vector<dReal>& q)
{
    ASSERT_EQ(dRobotSetPositions(robot, q.data(), int(q.size())), 1);
    const int count = dRobotModelGetLinks(model, nullptr, 0);
    std::vector<dRobotLink> links{size_t(count)};
    std::vector<dReal> poses(7 * size_t(count));
    dRobotModelGetLinks(model, links.data(), count);
    dRobotModelGetPoses(model, q.data(), int(q.size()), poses.data(), count);
    for (int i = 1; i < count; ++i) {
        const dBodyID body = dRobotGetBody(robot, i);
        ASSERT_NE(body, nullptr);
        dVector3 origin;
        dBodyGetRelPointPos(body, -links[size_t(i)].centre[0], -links[size_t(i)].centre[1],
                            -links[size_t(i)].centre[2], origin);
        for (size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(origin[k], poses[7 * size_t(i) + k], kExact) << links[size_t(i)].name;
    }
    std::vector<dReal> back(q.size());
    dRobotGetPositions(robot, back.data(), int(back.size()));
    for (size_t i = 0; i < q.size(); ++i) EXPECT_NEAR(back[i], q[i], kExact) << "coordinate " << i;
}

TEST_F(RobotTest, positions_of_an_arm_come_back)
{
    load("arm.urdf");
    expect_round_trip(*this, model, robot, {dReal(0.4), dReal(-1.1), dReal(0.02), dReal(-0.02)});
}

TEST_F(RobotTest, positions_of_every_kind_of_joint_come_back)
{
    load("walker.xml");
    std::vector<dReal> q(size_t(dRobotModelGetNumPositions(model)));
    ASSERT_EQ(dRobotModelGetStart(model, 0, q.data(), int(q.size())), int(q.size()));
    q[4] = dReal(0.8), q[5] = dReal(0.6);  // the ball joint's quaternion
    expect_round_trip(*this, model, robot, q);
}

// They come back, and a short step moves the coordinates by them.
// Hinges without limits count turns, from where all bodies are set, the small ones between the joints of a link too.
TEST_F(RobotTest, positions_of_several_hinges_of_a_link_come_back_without_a_turn)
{
    load_text(
        "<mujoco><worldbody><body><joint axis='1 0 0'/><joint axis='0 1 0'/><joint axis='0 0 1'/><geom "
        "type='box' "
        "size='.1 .2 .3'/></body></worldbody></mujoco>");
    for (const dReal sign : {1, -1, 1, -1}) {
        const dReal q[3] = {dReal(2.7) * sign, dReal(-1.1), dReal(-2.9) * sign};
        ASSERT_EQ(dRobotSetPositions(robot, q, 3), 1);
        const std::vector<dReal> back = positions();
        for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(back[i], q[i], kExact) << i;
    }
}

TEST_F(RobotTest, velocities_of_every_kind_of_joint_come_back_and_move_them)
{
    load("walker.xml");
    dWorldSetGravity(world, 0, 0, 0);
    std::vector<dReal> q(size_t(dRobotModelGetNumPositions(model)));
    dRobotModelGetStart(model, 0, q.data(), int(q.size()));
    ASSERT_EQ(dRobotSetPositions(robot, q.data(), int(q.size())), 1);
    std::vector<dReal> v(size_t(dRobotModelGetNumVelocities(model)));
    for (size_t i = 0; i < v.size(); ++i) v[i] = dReal(0.3) - dReal(0.1) * dReal(i % 5);
    v[3] = 2 * v[2];  // as the file couples them
    ASSERT_EQ(dRobotSetVelocities(robot, v.data(), int(v.size())), 1);
    std::vector<dReal> back(v.size());
    ASSERT_EQ(dRobotGetVelocities(robot, back.data(), int(back.size())), int(v.size()));
    for (size_t i = 0; i < v.size(); ++i) EXPECT_NEAR(back[i], v[i], kExact) << i;
    if (sizeof(dReal) == 4) return;
    const dReal h = dReal(1e-6);
    step(1, h);
    const std::vector<dReal> after = positions();
    for (size_t i : {0, 1, 2, 3}) EXPECT_NEAR((after[i] - q[i]) / h, v[i], 1e-2) << i;
    for (size_t i : {8, 9, 10}) EXPECT_NEAR((after[i] - q[i]) / h, v[i - 1], 1e-6) << i;
}

// alpha = m g l / (I + m l^2 + armature), from the horizontal.
TEST_F(RobotTest, a_pendulum_falls_as_its_file_says)
{
    load_text(R"(<mujoco><compiler angle="radian"/><worldbody><body>
        <joint name="hinge" axis="0 1 0" armature="0.3"/>
        <inertial pos="0.5 0 0" mass="2" diaginertia="0.1 0.2 0.2"/></body></worldbody></mujoco>)");
    const dReal h = dReal(1e-3);
    dWorldSetCFM(world, 0);  // ODE's softness in floats, 1e-5, takes 1 % of a step of this size
    step(1, h);
    EXPECT_NEAR(dJointGetAxisRate(dRobotGetJoint(robot, 0), 0) / h, 2 * 9.81 * 0.5 / (0.2 + 2 * 0.25 + 0.3),
                kFine);
}

TEST_F(RobotTest, a_motor_exerts_gear_times_control_within_its_range)
{
    load_text(R"(<mujoco><option gravity="0 0 0"/><worldbody><body><joint name="hinge" axis="0 0 1"/>
        <inertial pos="0 0 0" mass="1" diaginertia="2 2 2"/></body></worldbody>
        <actuator><motor name="m" joint="hinge" gear="10" ctrlrange="-0.5 0.5"/></actuator></mujoco>)");
    ASSERT_EQ(dRobotSetControl(robot, dRobotModelFindActuator(model, "m"), 3), 1);
    step(100, dReal(0.01));
    EXPECT_NEAR(dJointGetAxisRate(dRobotGetJoint(robot, 0), 0), 10 * 0.5 / 2, kExact);
}

TEST_F(RobotTest, a_target_holds_the_arm_within_its_effort)
{
    load("arm.urdf");
    const int shoulder = dRobotModelFindJoint(model, "shoulder"),
              elbow = dRobotModelFindJoint(model, "elbow");
    ASSERT_EQ(dRobotSetTarget(robot, shoulder, dReal(-0.5), 5000, 200), 1);
    ASSERT_EQ(dRobotSetTarget(robot, elbow, dReal(0.8), 5000, 200), 1);
    step(3000, dReal(0.001));
    EXPECT_NEAR(position_of("shoulder"), -0.5, 0.01);
    EXPECT_NEAR(position_of("elbow"), 0.8, 0.01);
    EXPECT_LE(std::fabs(dJointGetDriveForce(dRobotGetJoint(robot, shoulder), 0)), 100.0);
}

TEST_F(RobotTest, a_mimic_follows_its_leader)
{
    load("arm.urdf");
    ASSERT_EQ(dRobotSetTarget(robot, dRobotModelFindJoint(model, "left_slide"), dReal(0.03), 500, 20), 1);
    dReal worst = 0;
    for (int i = 0; i < 500; ++i) {
        step(1, dReal(0.002));
        worst = std::max(worst, dReal(std::fabs(position_of("left_slide") + position_of("right_slide"))));
    }
    EXPECT_NEAR(position_of("left_slide"), 0.03, 0.01);
    EXPECT_LE(worst, kFine);
}

TEST_F(RobotTest, a_loop_stays_closed_while_it_turns)
{
    load("fourbar.xml");
    ASSERT_EQ(dRobotSetControl(robot, 0, 2), 1);
    step(2000, dReal(0.001));
    const dBodyID rocker = dRobotGetBody(robot, dRobotModelFindLink(model, "rocker"));
    dVector3 end;
    dBodyGetRelPointPos(rocker, 0, 0, dReal(-0.15), end);
    EXPECT_NEAR(end[0], 0.5, 1e-4);
    EXPECT_NEAR(end[2], 0, 1e-4);
    EXPECT_GT(std::fabs(position_of("crank")), 0.5);
}

TEST_F(RobotTest, a_hinge_stops_at_a_limit_beyond_half_a_turn)
{
    load_text(R"(<mujoco><compiler angle="radian"/><option gravity="0 0 0"/><worldbody><body>
        <joint name="hinge" axis="0 0 1" range="-5 5"/><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/></body></worldbody>
        <actuator><motor name="m" joint="hinge"/></actuator></mujoco>)");
    dRobotSetControl(robot, 0, 4);
    dReal largest = 0;
    for (int i = 0; i < 4000; ++i) {
        step(1, dReal(0.002));
        largest = std::max(largest, position_of("hinge"));
    }
    EXPECT_NEAR(largest, 5, 0.05);
}

// Such limits are stops of the hinge: a program reads them, and takes them off.
TEST_F(RobotTest, limits_beyond_half_a_turn_are_stops_of_the_hinge)
{
    load_text(R"(<mujoco><compiler angle="radian"/><worldbody><body pos="0 0 1">
        <joint name="hinge" axis="0 1 0" range="-0.0175 3.7525"/><geom type="capsule" size=".02" fromto="0 0 0 -.5 0 0" mass="1"/>
        </body></worldbody></mujoco>)");
    const dJointID joint = dRobotGetJoint(robot, dRobotModelFindJoint(model, "hinge"));
    EXPECT_NEAR(double(dJointGetHingeParam(joint, dParamLoStop)), -0.0175, 1e-6);
    EXPECT_NEAR(double(dJointGetHingeParam(joint, dParamHiStop)), 3.7525, 1e-6);
    for (const dReal q : {dReal(3.5), dReal(0), dReal(3.7)}) {
        ASSERT_EQ(dRobotSetPositions(robot, &q, 1), 1);
        EXPECT_NEAR(positions()[0], q, kExact);
    }
    const dReal level = 0;
    dRobotSetPositions(robot, &level, 1);
    step(250, dReal(0.002));
    EXPECT_NEAR(positions()[0], -0.0175, 5e-3) << "held";
    dJointSetHingeParam(joint, dParamLoStop, -dInfinity);
    dJointSetHingeParam(joint, dParamHiStop, dInfinity);
    step(250, dReal(0.002));
    EXPECT_LT(positions()[0], dReal(-1)) << "falls";
}

TEST_F(RobotTest, positions_of_a_wide_range_come_back)
{
    load_text(R"(<mujoco><compiler angle="radian"/><worldbody><body>
        <joint name="hinge" axis="0 0 1" range="-6.28 6.28"/><geom size=".1"/></body></worldbody></mujoco>)");
    for (const dReal q : {4, -4, 6, -6, 1}) {
        ASSERT_EQ(dRobotSetPositions(robot, &q, 1), 1);
        step(1, dReal(0.002));
        EXPECT_NEAR(positions()[0], q, kExact);
    }
}

TEST_F(RobotTest, excluded_and_overlapping_links_do_not_touch)
{
    load("walker.xml");
    const dBodyID trunk = dRobotGetBody(robot, dRobotModelFindLink(model, "trunk"));
    const dBodyID foot = dRobotGetBody(robot, dRobotModelFindLink(model, "foot"));
    const dBodyID ball = dRobotGetBody(robot, dRobotModelFindLink(model, "ball"));
    EXPECT_TRUE(dAreConnected(trunk, foot));
    EXPECT_FALSE(dAreConnected(trunk, ball));
}

TEST_F(RobotTest, a_walker_rests_on_its_floor)
{
    load("walker.xml");
    dWorldSetContactSpace(world, space);
    step(2000, dReal(0.002));
    const dReal* ball = dBodyGetPosition(dRobotGetBody(robot, dRobotModelFindLink(model, "ball")));
    EXPECT_NEAR(ball[2], -0.9, 0.002);
}

TEST_F(RobotTest, a_thousand_robots_come_from_one_model)
{
    load("arm.urdf");
    const dBodyID first = dRobotGetBody(robot, 2);
    for (int i = 0; i < 1000; ++i) {
        const dWorldID other = dWorldCreate();
        const dReal place[3] = {dReal(i), 0, 0};
        const dRobotID one = dRobotCreate(other, nullptr, model, place, nullptr);
        ASSERT_NE(one, nullptr);
        EXPECT_NEAR(dBodyGetPosition(dRobotGetBody(one, 2))[0], dBodyGetPosition(first)[0] + i, 100 * kExact);
        dRobotDestroy(one);
        dWorldDestroy(other);
    }
}

int messages = 0;
void count_message(int, const char*, va_list) { ++messages; }

TEST_F(RobotTest, wrong_arguments_are_refused_with_one_message_each)
{
    load("arm.urdf");
    dSetMessageHandler(&count_message);
    messages = 0;
    const dReal nan[4] = {dReal(NAN), 0, 0, 0};
    dRobotOptions options;
    int calls = 0;
    const auto refused = [&](bool answer) {
        EXPECT_FALSE(answer);
        EXPECT_EQ(messages, ++calls);
    };
    refused(dRobotOptionsInit(&options, 3));
    refused(dRobotOptionsInit(nullptr, sizeof options));
    refused(dRobotModelLoad(nullptr, nullptr));
    refused(dRobotModelGetLinks(nullptr, nullptr, 0));
    refused(dRobotModelGetLinks(model, nullptr, 3));
    refused(dRobotModelGetReport(model, nullptr, -1));
    refused(dRobotModelGetStart(model, 7, nullptr, 0));
    refused(dRobotModelGetPoses(model, nan, 4, nullptr, 0));
    refused(dRobotModelGetPoses(model, nan, 3, nullptr, 0));
    refused(dRobotModelFindLink(model, nullptr));
    refused(dRobotCreate(nullptr, space, model, nullptr, nullptr));
    refused(dRobotCreate(world, space, nullptr, nullptr, nullptr));
    refused(dRobotCreate(world, space, model, nan, nullptr));
    refused(dRobotGetBody(robot, -1));
    refused(dRobotGetJoint(robot, 99));
    refused(dRobotSetPositions(robot, nan, 4));
    refused(dRobotSetPositions(robot, nan, 2));
    refused(dRobotSetControl(robot, 99, 0));
    refused(dRobotSetControl(robot, 0, nan[0]));
    refused(dRobotSetTarget(robot, 0, 0, -1, 0));
    refused(dRobotGetPositions(nullptr, nullptr, 0));
    dSetMessageHandler(nullptr);
}

TEST_F(RobotTest, a_model_with_errors_is_not_built)
{
    dSetMessageHandler(&count_message);
    const std::string text = "<robot name='x'><link name='a'/><link name='a'/></robot>";
    model = dRobotModelLoadText("x.urdf", text.data(), text.size(), nullptr);
    ASSERT_NE(model, nullptr);
    EXPECT_EQ(dRobotModelHasErrors(model), 1);
    EXPECT_EQ(dRobotCreate(world, space, model, nullptr, nullptr), nullptr);
    dSetMessageHandler(nullptr);
}

}  // namespace
