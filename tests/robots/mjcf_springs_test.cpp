// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// MJCF: springs and dampers that a file states by what they do to the robot's masses, springs of tendons, and activations, which are
// written again.
#include <gtest/gtest.h>

#include "robots/load.h"
#include "robots/write/write.h"
#include "same_model.h"

namespace {

using namespace epode::robots;

const std::string kArm =
    "<mujoco><worldbody><body><joint name='a' axis='0 1 0'/><inertial pos='.3 0 0' mass='4' diaginertia='.02 "
    ".03 "
    ".04'/><body pos='.5 0 0'><joint name='b' axis='0 1 0' armature='0.3'/>"
    "<joint name='s' type='slide' axis='1 0 0' springdamper='0.1 0.7'/>"
    "<inertial pos='.2 0 0.1' mass='2' diaginertia='.02 .03 .04'/></body></body></worldbody>"
    "<tendon><fixed name='t' springlength='0.4' stiffness='2'><joint joint='a' coef='1'/><joint joint='b' "
    "coef='2'/></fixed></tendon><actuator>";

RobotModel with_actuators(const std::string& actuators)
{
    return load_robot_text("robot.xml", kArm + actuators + "</actuator></mujoco>");
}

// The numbers are those of MuJoCo 4.0's compiler.
TEST(MjcfSprings, of_a_time_constant_are_those_of_the_masses)
{
    const RobotModel model = with_actuators(
        "<position joint='a' kp='100' dampratio='0.7' gear='3'/><position tendon='t' kp='10' "
        "dampratio='1'/>");
    ASSERT_FALSE(model.has_errors());
    EXPECT_TRUE(model.report.empty());
    EXPECT_NEAR(model.joints[2].stiffness, 388.800527187, 1e-8);
    EXPECT_NEAR(model.joints[2].damping, 38.1024516643, 1e-9);
    EXPECT_NEAR(model.actuators[0].bias_velocity, 5.03829239365, 1e-10);
    EXPECT_NEAR(model.actuators[1].bias_velocity, 2.0018859033, 1e-9);
}

TEST(MjcfSprings, of_tendons_rest_where_the_file_says)
{
    const RobotModel model = with_actuators("");
    EXPECT_TRUE(model.tendons[0].has_rest);
    EXPECT_EQ(model.tendons[0].rest, 0.4);
    const RobotModel again = load_robot_text("robot.xml", write_mjcf(model, ".").text);
    EXPECT_EQ(again.tendons[0].rest, 0.4);
}

// Couplings of tendons name them again; one of three joints, from nowhere, gets a tendon of its own.
TEST(MjcfSprings, equalities_of_tendons_are_written_again)
{
    const std::string text =
        "</actuator><tendon><fixed name='u'><joint joint='s' coef='-2'/></fixed></tendon>"
        "<equality><tendon tendon1='u' tendon2='t' polycoef='0.1 0.5 0 0 0'/><tendon tendon1='t' "
        "polycoef='0.3'/></equality><actuator>";
    RobotModel model = with_actuators(text);
    ASSERT_FALSE(model.has_errors()) << model.report[0].text;
    ASSERT_EQ(model.couplings.size(), 2u);
    const RobotModel again = load_robot_text("robot.xml", write_mjcf(model, ".").text);
    const std::vector<std::string> found = differences(model, again);
    EXPECT_TRUE(found.empty()) << found[0];
    model.couplings[0].tendons = {-1, -1};
    const WrittenRobot written = write_mjcf(model, ".");
    const RobotModel other = load_robot_text("robot.xml", written.text);
    ASSERT_EQ(other.couplings.size(), 2u) << written.text;
    ASSERT_EQ(other.couplings[0].terms.size(), 3u);
    for (size_t i = 0; i < 3; ++i)
        EXPECT_EQ(other.couplings[0].terms[i].factor, model.couplings[0].terms[i].factor);
    EXPECT_EQ(other.couplings[0].offset, model.couplings[0].offset);
}

// force = area pressure + b0 + b1 q + b2 q'.
TEST(MjcfSprings, cylinders_are_general_actuators)
{
    const RobotModel model = with_actuators(
        "<cylinder joint='b' area='0.3' bias='1 2 3' timeconst='0.2'/><cylinder joint='b' diameter='0.3'/>");
    ASSERT_EQ(model.actuators.size(), 2u);
    EXPECT_EQ(model.actuators[0].gain, 0.3);
    EXPECT_EQ(model.actuators[0].bias, 1);
    EXPECT_EQ(model.actuators[0].bias_position, -2);
    EXPECT_EQ(model.actuators[0].bias_velocity, -3);
    EXPECT_NEAR(model.actuators[1].gain, 3.14159265358979 * 0.15 * 0.15, 1e-12);
}

TEST(MjcfSprings, activations_are_written_again)
{
    const RobotModel model = with_actuators(
        "<cylinder joint='b' timeconst='0.2'/><position joint='a' kp='3' timeconst='0.4'/>"
        "<general joint='a' dyntype='integrator' actrange='-1 2' actearly='true'/>"
        "<general joint='a' dyntype='filter' dynprm='0.05 1'/><motor joint='a'/>");
    ASSERT_EQ(model.actuators.size(), 5u);
    const WrittenRobot written = write_mjcf(model, ".");
    const RobotModel again = load_robot_text("robot.xml", written.text);
    const std::vector<std::string> found = differences(model, again);
    EXPECT_TRUE(found.empty()) << found[0];
    for (const char* text :
         {"dyntype=\"filter\" dynprm=\"0.2\"", "dyntype=\"filterexact\" dynprm=\"0.4\"", "dynprm=\"0.05 1\"",
          "dyntype=\"integrator\" actearly=\"true\" actlimited=\"true\" actrange=\"-1 2\""})
        EXPECT_NE(written.text.find(text), std::string::npos) << text << "\n" << written.text;
    EXPECT_EQ(model.report.size(), 1u) << "filters act where dRobotAddForces is called: said once";
    EXPECT_TRUE(model.actuators[4].activation.empty());
}

// Whatever the order of the options.
TEST(MjcfSprings, are_switched_off_by_flags)
{
    const std::string robot =
        "<worldbody><body><joint name='a' type='slide' stiffness='3' damping='2' frictionloss='1' range='-1 "
        "1'/>"
        "<geom size='0.1'/></body></worldbody><tendon><fixed stiffness='4' damping='5' range='-1 1'><joint "
        "joint='a' coef='1'/></fixed></tendon><equality><joint joint1='a'/></equality><actuator><motor "
        "joint='a' "
        "ctrlrange='-1 1'/></actuator>";
    const auto with = [&](const std::string& flags) {
        return load_robot_text(
            "robot.xml",
            "<mujoco><option><flag " + flags + "/></option><option gravity='0 0 -5'/>" + robot + "</mujoco>");
    };
    const RobotModel on = with("gravity='enable' spring='enable'"),
                     off = with("gravity='disable' spring='disable' damper='disable' clampctrl='disable'"),
                     free = with("constraint='disable'"), powerless = with("actuation='disable'");
    EXPECT_EQ(on.gravity.z, -5);
    EXPECT_EQ(on.joints[0].stiffness, 3);
    EXPECT_EQ(off.gravity.z, 0);
    EXPECT_EQ(off.joints[0].stiffness + off.joints[0].damping, 0);
    EXPECT_EQ(off.tendons[0].stiffness + off.tendons[0].damping, 0);
    EXPECT_EQ(off.actuators[0].high, kInfinity);
    EXPECT_EQ(off.joints[0].friction, 1);
    EXPECT_EQ(off.couplings.size(), 1u);
    EXPECT_FALSE(free.joints[0].limited);
    EXPECT_EQ(free.joints[0].friction, 0);
    EXPECT_EQ(free.tendons[0].high, kInfinity);
    EXPECT_TRUE(free.couplings.empty());
    EXPECT_TRUE(free.links[1].shapes.empty());
    ASSERT_EQ(powerless.report.size(), 1u);
    EXPECT_EQ(powerless.report[0].note, Note::kIgnored);
}

TEST(MjcfSprings, that_are_polynomials_are_their_first_coefficient_and_said_to_be)
{
    const auto with = [&](const std::string& attributes) {
        return load_robot_text("robot.xml", "<mujoco><worldbody><body><joint " + attributes +
                                                "/><geom size='0.1'/></body></worldbody></mujoco>");
    };
    EXPECT_TRUE(with("stiffness='3 0' damping='2'").report.empty());
    const RobotModel model = with("stiffness='3 1'");
    EXPECT_EQ(model.joints[0].stiffness, 3);
    ASSERT_EQ(model.report.size(), 1u);
    EXPECT_EQ(model.report[0].text, "joint stiffness as its first coefficient");
}

}  // namespace
