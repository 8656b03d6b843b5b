// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What <gazebo> elements of a URDF become: frictions, gravity, pairs that do not touch, springs, sensors; and their reports.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include "robots/build.h"
#include "robots/load.h"
#include "robots/sensors.h"
#include "robots/write/write.h"

using namespace epode::robots;

namespace {

// Two boxes on a slider that goes up, and what is said of them.
RobotModel read(const std::string& gazebo)
{
    const std::string inertial =
        "<inertial><mass value='1'/><inertia ixx='0.01' iyy='0.01' izz='0.01' ixy='0' ixz='0' "
        "iyz='0'/></inertial>"
        "<collision><geometry><box size='0.1 0.1 0.1'/></geometry></collision>";
    return load_robot_text(
        "robot.urdf",
        "<robot name='r'><link name='world'/><link name='one'>" + inertial + "</link><link name='two'>" +
            inertial +
            "</link><joint name='lift' type='prismatic'><parent link='world'/><child link='one'/>"
            "<axis xyz='0 0 1'/><limit lower='-10' upper='10' effort='100' velocity='1'/></joint>"
            "<joint name='slide' type='prismatic'><parent link='one'/><child link='two'/>"
            "<origin xyz='0 0 1'/><axis xyz='0 0 1'/>"
            "<limit lower='-10' upper='10' effort='100' velocity='1'/></joint>" +
            gazebo + "</robot>");
}

bool has_note(const RobotModel& model, Note note, const std::string& text)
{
    for (const ReportLine& line : model.report)
        if (line.note == note && line.text.find(text) != std::string::npos) return true;
    return false;
}

TEST(Gazebo, friction_is_that_of_the_first_direction)
{
    const RobotModel same = read("<gazebo reference='one'><mu1>0.3</mu1><mu2>0.3</mu2></gazebo>");
    ASSERT_FALSE(same.has_errors());
    EXPECT_EQ(same.links[1].shapes[0].friction, 0.3);
    EXPECT_EQ(same.links[2].shapes[0].friction, 1);
    EXPECT_FALSE(has_note(same, Note::kApproximated, "both directions"));
    const RobotModel two = read("<gazebo reference='one'><mu1>0.3</mu1><mu2>0.6</mu2><kp>1e6</kp></gazebo>");
    EXPECT_TRUE(has_note(two, Note::kApproximated, "both directions"));
    EXPECT_TRUE(has_note(two, Note::kApproximated, "link kp: contacts are rigid"));
    EXPECT_EQ(read("<gazebo reference='one'><mu1 value='0.4'/></gazebo>").links[1].shapes[0].friction, 0.4);
    const RobotModel negative = read("<gazebo reference='one'><mu1>-1</mu1></gazebo>");
    EXPECT_TRUE(has_note(negative, Note::kIgnored, "<mu1> in <gazebo>"));
    EXPECT_EQ(negative.links[1].shapes[0].friction, 1);
}

// A slip is refused with what is wanted, as it is outside of <gazebo>.
TEST(Gazebo, broken_values_are_errors)
{
    const char* const wrong[][2] = {
        {"<mu1>slippery</mu1>", "<mu1> in <gazebo> is 'slippery', wanted 1 finite number"},
        {"<mu1/>", "wanted 1 finite number"},
        {"<mu1>1 2</mu1>", "wanted 1 finite number"},
        {"<mu1>nan</mu1>", "wanted 1 finite number"},
        {"<kp>stiff</kp>", "<kp> in <gazebo> is 'stiff'"},
        {"<turnGravityOff>maybe</turnGravityOff>", "is 'maybe', wanted true or false"},
        {"<selfCollide/>", "wanted true or false"},
        {"<sensor name='s' type='imu'><pose>1 2</pose></sensor>", "wanted 6 finite numbers"}};
    for (const auto& [text, why] : wrong) {
        const RobotModel model = read(std::string("\n<gazebo reference='one'>") + text + "</gazebo>");
        ASSERT_TRUE(model.has_errors()) << text;
        EXPECT_TRUE(has_note(model, Note::kError, why)) << text << model.report.back().text;
        EXPECT_EQ(model.report.back().line, 2);
    }
    EXPECT_TRUE(has_note(read("<gazebo reference='slide'><springStiffness>x</springStiffness></gazebo>"),
                         Note::kError, "<springStiffness>"));
    EXPECT_TRUE(read("<gazebo reference='one'><gravity> 0 </gravity></gazebo>").links[1].is_weightless);
}

// The upper box is weightless: the lower falls by g t^2 / 2 and the upper stays, to the step's first order.
TEST(Gazebo, gravity_is_turned_off_link_by_link)
{
    const RobotModel model = read(
        "<gazebo reference='two'><turnGravityOff>true</turnGravityOff></gazebo>"
        "<gazebo reference='one'><turnGravityOff>false</turnGravityOff></gazebo>");
    ASSERT_TRUE(model.links[2].is_weightless);
    ASSERT_FALSE(model.links[1].is_weightless);
    dInitODE2(0);
    const dWorldID world = dWorldCreate();
    dWorldSetGravity(world, 0, 0, dReal(-9.81));
    {
        const Robot robot(std::make_shared<const Prepared>(model), world, nullptr, {}, {});
        for (int i = 0; i < 500; ++i) dWorldStep(world, dReal(0.001));
        EXPECT_NEAR(double(dBodyGetPosition(robot.body(1))[2]), -9.81 * 0.125, 5e-3);
        EXPECT_NEAR(double(dBodyGetPosition(robot.body(2))[2]), 1, 1e-4);
    }
    dWorldDestroy(world);
    dCloseODE();
    // What holds it: the weight of one box.
    EXPECT_NEAR(inverse_dynamics(model, {0, 0}, {0, 0}, {0, 0}, model.gravity)[0], 9.81, 1e-12);
}

TEST(Gazebo, a_link_that_does_not_collide_is_kept_from_all_others)
{
    const RobotModel model = read("<gazebo reference='two'><selfCollide>false</selfCollide></gazebo>");
    ASSERT_EQ(model.excluded.size(), 1u);
    EXPECT_EQ(model.excluded[0], (std::array<int, 2>{1, 2}));
    EXPECT_TRUE(read("<gazebo reference='two'><selfCollide>true</selfCollide></gazebo>").excluded.empty());
}

TEST(Gazebo, springs_of_joints_are_read)
{
    const RobotModel model = read(
        "<gazebo "
        "reference='slide'><springStiffness>40</springStiffness><springReference>0.1</springReference>"
        "<implicitSpringDamper>true</implicitSpringDamper><provideFeedback>true</provideFeedback></gazebo>");
    EXPECT_EQ(model.joints[1].stiffness, 40);
    EXPECT_EQ(model.joints[1].spring_reference, 0.1);
    EXPECT_TRUE(model.report.empty());
}

// The accelerometer stands still 0.2 m above its link's origin and is turned by half a turn about x.
TEST(Gazebo, sensors_get_a_frame_and_are_read)
{
    const RobotModel model = read(
        "<gazebo reference='two'><sensor name='imu' type='imu'><pose>0 0 0.2 3.14159265358979 0 "
        "0</pose></sensor>"
        "<sensor name='bump' type='contact'/>"
        "<sensor name='range' "
        "type='ray'><ray><scan><horizontal><samples>1</samples></horizontal></scan></ray></sensor></gazebo>"
        "<gazebo reference='slide'><sensor name='wrist' type='force_torque'/></gazebo>");
    ASSERT_FALSE(model.has_errors());
    std::vector<std::string> kinds;
    for (const Sensor& sensor : model.sensors) kinds.push_back(sensor.kind);
    EXPECT_EQ(kinds,
              (std::vector<std::string>{"accelerometer", "gyro", "touch", "rangefinder", "force", "torque"}));
    Frame frame;
    ASSERT_TRUE(model.frame_named("imu", frame));
    EXPECT_EQ(frame.link, 2);
    EXPECT_EQ(frame.pose.p.z, 0.2);
    ASSERT_TRUE(model.frame_named("range", frame));
    EXPECT_NEAR(rotate(frame.pose.q, {0, 0, 1}).x, 1, 1e-12);
    dInitODE2(0);
    const dWorldID world = dWorldCreate();
    const dSpaceID space = dHashSpaceCreate(nullptr);
    dWorldSetGravity(world, 0, 0, dReal(-9.81));
    {
        Robot robot(std::make_shared<const Prepared>(model), world, space, {}, {});
        Sensors sensors(robot, world);
        for (int joint : {0, 1}) robot.set_servo(joint, {1e6, 1e4, 0});
        for (int i = 0; i < 200; ++i) dWorldStep(world, dReal(0.01)), sensors.update(0.01);
        std::string problem;
        EXPECT_NEAR(sensors.read(0, space, problem)[2], -9.81, 1e-2);
        EXPECT_NEAR(std::fabs(sensors.read(4, space, problem)[2]), 9.81, 2e-2);
    }
    dSpaceDestroy(space);
    dWorldDestroy(world);
    dCloseODE();
}

TEST(Gazebo, what_is_not_read_is_reported_by_name)
{
    const RobotModel model = read(
        "<gazebo><plugin name='p'/></gazebo><gazebo reference='one'><fdir1>1 0 "
        "0</fdir1><material>Gazebo/Grey</material></gazebo>"
        "<gazebo reference='nobody'><mu1>1</mu1></gazebo><gazebo reference='two'><sensor name='eye' "
        "type='camera'/>"
        "<sensor name='scan' "
        "type='gpu_ray'><ray><scan><horizontal><samples>720</samples></horizontal></scan></ray></sensor></"
        "gazebo>");
    ASSERT_FALSE(model.has_errors());
    for (const char* text :
         {"<plugin> in <gazebo>", "<fdir1> in <gazebo> of 'one'", "<mu1> in <gazebo> of 'nobody'",
          "<camera> are listed, not computed by name: dRobotTakePicture",
          "<gpu_ray> are listed, not computed by name: dRobotCastRays"})
        EXPECT_TRUE(has_note(model, Note::kIgnored, text)) << text;
    EXPECT_EQ(model.report.size(), 5u);
    EXPECT_EQ(model.sensors.size(), 2u);
}

TEST(Gazebo, weightless_links_are_written_in_both_formats)
{
    const RobotModel model = read("<gazebo reference='two'><turnGravityOff>1</turnGravityOff></gazebo>");
    EXPECT_TRUE(load_robot_text("r.urdf", write_urdf(model, ".").text).links[2].is_weightless);
    EXPECT_TRUE(load_robot_text("r.xml", write_mjcf(model, ".").text).links[2].is_weightless);
}

}  // namespace
