// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is written reads back as the same model, or moves as it does where the format has other words for it.
#include <gtest/gtest.h>

#include <algorithm>

#include "robots/kinematics.h"
#include "robots/load.h"
#include "robots/write/write.h"
#include "same_model.h"

namespace {

using namespace epode::robots;

const std::string kModels = EPODE_MODELS;

RobotModel read_again(const WrittenRobot& written, const std::string& ending, const LoadOptions& options = {})
{
    RobotModel model = load_robot_text(kModels + "/written." + ending, written.text, options);
    EXPECT_FALSE(model.has_errors()) << written.text;
    for (const ReportLine& line : model.report)
        if (line.note == Note::kError) ADD_FAILURE() << line.text;
    return model;
}

std::string joined(const std::vector<std::string>& lines)
{
    std::string out;
    for (const std::string& line : lines) out += line + "\n";
    return out;
}

void expect_round_trip(const std::string& name, const LoadOptions& options)
{
    const RobotModel model = load_robot(kModels + "/" + name, options);
    const bool is_urdf = model.format == "URDF";
    const WrittenRobot written = is_urdf ? write_urdf(model, kModels) : write_mjcf(model, kModels);
    const RobotModel again = read_again(written, is_urdf ? "urdf" : "xml", options);
    EXPECT_EQ(joined(differences(model, again)), "") << name << "\n" << written.text;
}

TEST(Write, own_format_gives_the_same_model)
{
    LoadOptions whole;
    whole.keep_fixed = true;
    for (const char* name : {"arm.urdf", "walker.xml", "fourbar.xml"}) {
        expect_round_trip(name, {});
        expect_round_trip(name, whole);
    }
}
// What <gazebo> elements say: robots/read/gazebo.cpp.
TEST(Write, a_urdf_keeps_what_gazebo_adds_to_it)
{
    const char* const text = R"(<robot name="rover">
      <link name="base"><inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
        <collision><geometry><box size="1 1 1"/></geometry></collision></link>
      <link name="wheel"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
        <collision><geometry><sphere radius="0.2"/></geometry></collision></link>
      <link name="flap"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
        <collision><geometry><box size="0.1 0.2 0.3"/></geometry></collision></link>
      <joint name="axle" type="continuous"><parent link="base"/><child link="wheel"/><origin xyz="0.5 0 0.1" rpy="0 0.3 0"/></joint>
      <joint name="hinge" type="revolute"><parent link="base"/><child link="flap"/><origin xyz="-1 0 2"/>
        <axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="5" velocity="3"/></joint>
      <gazebo reference="wheel"><mu1>0.35</mu1><mu2>0.35</mu2></gazebo>
      <gazebo reference="flap"><turnGravityOff>true</turnGravityOff><selfCollide>false</selfCollide></gazebo>
      <gazebo reference="hinge"><springStiffness>7</springStiffness><springReference>0.25</springReference></gazebo>
      <gazebo reference="base">
        <sensor name="imu" type="imu"><pose>0.1 0.2 0.3 0.4 0.5 0.6</pose></sensor>
        <sensor name="eye" type="ray"><pose>0 0 1 0 0.2 0</pose></sensor>
        <sensor name="camera" type="camera"/>
      </gazebo>
      <gazebo reference="flap"><sensor name="bump" type="contact"/></gazebo>
      <gazebo reference="hinge"><sensor name="load" type="force_torque">
        <force_torque><measure_direction>parent_to_child</measure_direction></force_torque></sensor></gazebo>
    </robot>)";
    const RobotModel model = load_robot_text("robot.urdf", text, {});
    ASSERT_EQ(model.sensors.size(), 7u);
    ASSERT_EQ(model.excluded.size(), 2u);
    const WrittenRobot written = write_urdf(model, kModels);
    EXPECT_EQ(joined(differences(model, read_again(written, "urdf"))), "") << written.text;
    for (const std::string& lost : written.lost) EXPECT_EQ(lost.find("sensor"), std::string::npos) << lost;
}

// What MJCF has no words for stands in its <custom>.
TEST(Write, mjcf_keeps_what_a_urdf_means_by_its_contacts_speeds_and_forces)
{
    const char* const text = R"(<robot name="rover">
      <link name="base"><inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
      <link name="flap"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
      <joint name="hinge" type="revolute"><parent link="base"/><child link="flap"/>
        <axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="5" velocity="3"/></joint>
      <gazebo reference="hinge"><sensor name="load" type="force_torque"/></gazebo></robot>)";
    const RobotModel model = load_robot_text("robot.urdf", text, {});
    const WrittenRobot written = write_mjcf(model, kModels);
    const RobotModel again = read_again(written, "xml");
    EXPECT_EQ(joined(differences(model, again)), "") << written.text;
    ASSERT_EQ(again.joints.size(), 2u);
    EXPECT_EQ(again.joints[1].max_velocity, 3);
    EXPECT_FALSE(again.touches_itself);
    EXPECT_FALSE(again.largest_friction);
    ASSERT_EQ(again.sensors.size(), 2u);
    for (const Sensor& sensor : again.sensors) EXPECT_FALSE(sensor.is_on_child) << sensor.name;
}

TEST(Write, sensors_of_subtrees_are_on_bodies)
{
    const char* const text =
        "<mujoco><worldbody><body name='a'><joint/><geom size='1'/></body></worldbody><sensor>"
        "<subtreecom name='c' body='a'/><subtreelinvel name='v' body='a'/></sensor></mujoco>";
    const RobotModel model = load_robot_text("robot.xml", text, {});
    ASSERT_EQ(model.sensors.size(), 2u);
    const WrittenRobot written = write_mjcf(model, kModels);
    EXPECT_EQ(joined(differences(model, read_again(written, "xml"))), "") << written.text;
    EXPECT_TRUE(written.lost.empty());
}

#ifdef EPODE_HAVE_SDF
TEST(Write, an_sdf_is_the_same_in_mjcf) { expect_round_trip("geared.sdf", {}); }
#endif

// A joint of one model, by its name in the other; coordinates there count from the reference.
std::vector<double> positions_for(const RobotModel& from, const std::vector<double>& q, const RobotModel& to,
                                  bool from_reference)
{
    std::vector<double> out = reference_positions(to);
    for (const Joint& joint : from.joints) {
        const int its = to.joint_named(joint.name);
        if (its < 0 || !joint.is_scalar()) continue;
        const double shift = from_reference ? joint.reference : 0;
        out[size_t(to.joints[size_t(its)].position)] = q[size_t(joint.position)] - shift;
    }
    return out;
}

// Where the centres of mass of all links are.
void expect_same_centres(const RobotModel& a, const std::vector<double>& q, const RobotModel& b,
                         const std::vector<double>& p)
{
    const std::vector<Pose> one = forward_kinematics(a, q), two = forward_kinematics(b, p);
    for (size_t i = 1; i < a.links.size(); ++i) {
        const int number = b.link_named(a.links[i].name);
        ASSERT_GE(number, 0) << a.links[i].name;
        const Vec x = one[i] * a.links[i].centre, y = two[size_t(number)] * b.links[size_t(number)].centre;
        EXPECT_LT(length(x - y), 1e-12) << a.links[i].name;
        EXPECT_NEAR(a.links[i].mass, b.links[size_t(number)].mass, 1e-12);
    }
}

std::vector<double> some_positions(const RobotModel& model)
{
    std::vector<double> q = reference_positions(model);
    for (const Joint& joint : model.joints)
        if (joint.is_scalar()) q[size_t(joint.position)] = 0.3 + 0.2 * joint.position;
    return q;
}

TEST(Write, an_arm_is_the_same_in_mjcf)
{
    const RobotModel model = load_robot(kModels + "/arm.urdf");
    const WrittenRobot written = write_mjcf(model, kModels);
    const RobotModel again = read_again(written, "xml");
    const std::vector<double> q = some_positions(model);
    expect_same_centres(model, q, again, positions_for(model, q, again, false));
    ASSERT_EQ(again.couplings.size(), 1u);
    EXPECT_EQ(again.couplings[0].terms[1].factor, 1);
    EXPECT_EQ(again.actuators.size(), 1u);
    EXPECT_NE(joined(written.lost).find("links that overlap"), std::string::npos) << joined(written.lost);
}

// Anchors outside of the link's origin, references, two joints on a link, a ball: urdf.cpp's head says what becomes of them.
TEST(Write, a_walker_moves_the_same_in_urdf)
{
    const RobotModel model = load_robot(kModels + "/walker.xml");
    const WrittenRobot written = write_urdf(model, kModels);
    const RobotModel again = read_again(written, "urdf");
    const std::vector<double> q = some_positions(model);
    expect_same_centres(model, q, again, positions_for(model, q, again, true));
    EXPECT_NE(joined(written.lost).find("armatures of joints"), std::string::npos) << joined(written.lost);
    EXPECT_NE(joined(written.lost).find("pairs that do not touch"), std::string::npos);
}

TEST(Write, upright_axes_keep_their_rotation)
{
    RobotModel model = load_robot(kModels + "/arm.urdf");
    for (double pitch : {1.5707963267948966, -1.5707963267948966, 1.5707963})
        for (double roll : {0.0, 0.4, -2.0}) {
            model.links[1].pose.q = turn_of_rpy({roll, pitch, 0.7});
            const RobotModel again = read_again(write_urdf(model, kModels), "urdf");
            EXPECT_EQ(joined(differences(model, again)), "");
        }
}

TEST(Write, files_are_saved_by_their_ending)
{
    const RobotModel model = load_robot(kModels + "/fourbar.xml");
    const std::string path = testing::TempDir() + "/epode_saved.xml";
    std::vector<std::string> lost;
    std::string problem;
    ASSERT_TRUE(save_robot(model, path, lost, problem)) << problem;
    EXPECT_EQ(joined(differences(model, load_robot(path))), "");
    EXPECT_FALSE(save_robot(model, testing::TempDir() + "/a.txt", lost, problem));
    EXPECT_NE(problem.find(".urdf, .xml and .mjcf"), std::string::npos);
    EXPECT_FALSE(save_robot(model, "/nowhere/a.urdf", lost, problem));
    EXPECT_FALSE(save_robot(load_robot("/nowhere/a.urdf"), path, lost, problem));
}

}  // namespace
