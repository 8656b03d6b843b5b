// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What readers make of files whose masses and poses are known in closed form.
#include <gtest/gtest.h>

#include "robots/geometry.h"
#include "robots/load.h"

namespace {

using namespace epode::robots;

const std::string kModels = EPODE_MODELS;
constexpr double kPi = 3.14159265358979323846;

std::string report_of(const RobotModel& model)
{
    std::string out;
    for (const ReportLine& line : model.report)
        out += std::string(name_of(line.note)) + " " + std::to_string(line.line) + ": " + line.text + "\n";
    return out;
}

const Link& link_of(const RobotModel& model, const std::string& name)
{
    const int number = model.link_named(name);
    EXPECT_GE(number, 0) << name;
    return model.links[size_t(std::max(0, number))];
}

TEST(Urdf, welds_fixed_links_and_adds_their_masses)
{
    const RobotModel model = load_robot(kModels + "/arm.urdf");
    ASSERT_FALSE(model.has_errors()) << report_of(model);
    // Pedestal and world, upper, fore with tool, two fingers.
    ASSERT_EQ(model.links.size(), 5u);
    EXPECT_EQ(model.link_named("tool"), model.link_named("fore"));
    const Link& fore = link_of(model, "fore");
    EXPECT_NEAR(fore.mass, 1.5, 1e-12);
    EXPECT_NEAR(fore.centre.x, (1 * 0.2 + 0.5 * 0.4) / 1.5, 1e-12);
    // fore's own tensor is turned by a quarter: its 0.004 is along x. Then Steiner: 1 * 0.5 / 1.5 * 0.2^2.
    EXPECT_NEAR(fore.inertia[0][0], 0.004 + 0.001, 1e-12);
    EXPECT_NEAR(fore.inertia[1][1], 0.02 + 0.001 + 0.04 / 3, 1e-12);
}

TEST(Urdf, reads_limits_dynamics_mimic_and_transmission)
{
    const RobotModel model = load_robot(kModels + "/arm.urdf");
    ASSERT_EQ(model.joints.size(), 4u) << report_of(model);
    const Joint& shoulder = model.joints[0];
    EXPECT_TRUE(shoulder.limited);
    EXPECT_EQ(shoulder.low, -2);
    EXPECT_EQ(shoulder.max_force, 100);
    EXPECT_EQ(shoulder.damping, 0.5);
    EXPECT_EQ(shoulder.friction, 0.2);
    EXPECT_FALSE(model.joints[1].limited);
    ASSERT_EQ(model.couplings.size(), 1u);
    EXPECT_EQ(model.couplings[0].terms[1].factor, 1);
    ASSERT_EQ(model.actuators.size(), 1u);
    EXPECT_EQ(model.actuators[0].name, "elbow");
}

// A file without <transmission> says nothing of motors: each joint with an axis has one, within its effort, unless it follows another.
TEST(Urdf, has_a_motor_on_each_joint_where_it_names_no_transmission)
{
    const std::string link =
        "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' "
        "iyz='0'/></inertial></link>";
    const std::string text = "<robot name='r'><link name='world'/><link name='a'>" + link +
                             "<link name='b'>" + link + "<link name='c'>" + link +
                             "<joint name='shoulder' type='revolute'><parent link='world'/><child "
                             "link='a'/><limit effort='30' velocity='1' lower='-1' upper='1'/></joint>"
                             "<joint name='lift' type='prismatic'><parent link='a'/><child link='b'/><limit "
                             "effort='0' velocity='1' lower='-1' upper='1'/></joint>"
                             "<joint name='finger' type='continuous'><parent link='b'/><child "
                             "link='c'/><mimic joint='shoulder'/></joint></robot>";
    const RobotModel model = load_robot_text("r.urdf", text);
    ASSERT_FALSE(model.has_errors()) << report_of(model);
    ASSERT_EQ(model.actuators.size(), 2u);
    for (size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(model.actuators[i].kind, "motor");
        EXPECT_EQ(model.actuators[i].joint, int(i));
        EXPECT_EQ(model.actuators[i].name, model.joints[i].name);
    }
    EXPECT_EQ(model.actuators[0].force_low, -30);
    EXPECT_EQ(model.actuators[0].force_high, 30);
    EXPECT_GT(model.actuators[1].force_high, 1e6);
}

TEST(Urdf, reports_what_it_leaves_out_with_its_line)
{
    const RobotModel model = load_robot(kModels + "/arm.urdf");
    EXPECT_NE(report_of(model).find("ignored 40: <plugin> in <gazebo>"), std::string::npos)
        << report_of(model);
    EXPECT_NE(report_of(model).find("'pedestal' has no mass: it is fixed to the world"), std::string::npos);
    LoadOptions strict;
    strict.strict = true;
    EXPECT_TRUE(load_robot(kModels + "/arm.urdf", strict).has_errors());
}

TEST(Urdf, forward_kinematics_is_that_of_a_two_link_arm)
{
    const RobotModel model = load_robot(kModels + "/arm.urdf");
    std::vector<double> q = reference_positions(model);
    q[0] = 0.3, q[1] = -0.7;
    const Pose fore = forward_kinematics(model, q)[size_t(model.link_named("fore"))];
    const Vec tip = fore * Vec{0.4, 0, 0};
    // About y a positive angle turns x down.
    EXPECT_NEAR(tip.x, 0.6 * std::cos(0.3) + 0.4 * std::cos(-0.4), 1e-12);
    EXPECT_NEAR(tip.z, 0.5 - 0.6 * std::sin(0.3) - 0.4 * std::sin(-0.4), 1e-12);
}

TEST(Urdf, scales_meshes)
{
    const RobotModel model = load_robot(kModels + "/arm.urdf");
    ASSERT_EQ(model.meshes.size(), 1u) << report_of(model);
    EXPECT_EQ(model.meshes[0].vertices.size(), 8u);
    EXPECT_EQ(model.meshes[0].triangles.size(), 12u);
    EXPECT_NEAR(std::fabs(model.meshes[0].vertices[0].y), 0.05, 1e-12);
}

TEST(Urdf, reads_a_spherical_joint_as_a_ball)
{
    const char* text = R"(<robot name="r"><link name="a"/><link name="b"><inertial><mass value="1"/>
        <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
        <joint name="j" type="spherical"><parent link="a"/><child link="b"/></joint></robot>)";
    const RobotModel model = load_robot_text("r.urdf", text);
    ASSERT_FALSE(model.has_errors());
    const int joint = model.joint_named("j");
    ASSERT_GE(joint, 0);
    EXPECT_EQ(model.joints[size_t(joint)].kind, JointKind::kBall);
}

TEST(Mjcf, reads_the_time_of_a_step)
{
    const auto with = [](const std::string& option) {
        return load_robot_text(
            "r.xml", "<mujoco>" + option +
                         "<worldbody><body><freejoint/><geom size='.1'/></body></worldbody></mujoco>");
    };
    EXPECT_EQ(with("<option timestep='0.01'/>").stepsize, 0.01);
    EXPECT_EQ(with("").stepsize, 0);
    for (const char* bad : {"0", "-0.1", "nan", "1e60"})
        EXPECT_TRUE(with(std::string("<option timestep='") + bad + "'/>").has_errors()) << bad;
}

TEST(Mjcf, classes_hand_down_and_elements_override)
{
    const RobotModel model = load_robot(kModels + "/walker.xml");
    ASSERT_FALSE(model.has_errors()) << report_of(model);
    const Joint& hip = model.joints[size_t(model.joint_named("hip"))];
    EXPECT_EQ(hip.damping, 0.4);
    EXPECT_EQ(hip.armature, 0.02);
    EXPECT_NEAR(hip.spring_reference, 5 * kPi / 180, 1e-15);
    EXPECT_NEAR(hip.low, -kPi / 3, 1e-15);
    EXPECT_TRUE(hip.limited);
    EXPECT_EQ(hip.axis.y, 1);
    const Joint& lift = model.joints[size_t(model.joint_named("lift"))];
    EXPECT_EQ(lift.damping, 0.1);
    EXPECT_EQ(lift.stiffness, 0);
    EXPECT_EQ(link_of(model, "ball").shapes[0].friction, 0.9);
}

// A <joint type="free"> has its class's armature, a <freejoint> has none.
TEST(Mjcf, free_joints_have_an_armature_where_their_class_says_so)
{
    const std::string head = "<mujoco><default><joint armature='0.1'/></default><worldbody><body>",
                      foot = "<geom size='0.1'/></body></worldbody></mujoco>";
    const RobotModel model = load_robot_text("x.xml", head + "<joint type='free'/>" + foot);
    ASSERT_FALSE(model.has_errors()) << report_of(model);
    EXPECT_EQ(model.joints[0].armature, 0.1);
    EXPECT_NE(report_of(model).find("approximated 1: armature"), std::string::npos) << report_of(model);
    EXPECT_EQ(load_robot_text("x.xml", head + "<freejoint/>" + foot).joints[0].armature, 0);
}

TEST(Mjcf, free_bodies_that_are_to_be_aligned_are_reported)
{
    const auto lines = [](const std::string& compiler, const std::string& joint) {
        return load_robot_text("robot.xml",
                               "<mujoco><compiler " + compiler + "/><worldbody><body><" + joint +
                                   "/><geom size='0.1' pos='1 0 0'/></body></worldbody></mujoco>",
                               {})
            .report.size();
    };
    EXPECT_EQ(lines("", "freejoint"), 0u);
    EXPECT_EQ(lines("", "freejoint align='true'"), 1u);
    EXPECT_EQ(lines("alignfree='true'", "freejoint"), 1u);
    EXPECT_EQ(lines("alignfree='true'", "freejoint align='false'"), 0u);
}

TEST(Mjcf, masses_come_from_geoms)
{
    const RobotModel model = load_robot(kModels + "/walker.xml");
    const Link& thigh = link_of(model, "thigh");
    const double r = 0.04, l = 0.4, shaft = kPi * r * r * l * 1000, ball = 4 * kPi / 3 * r * r * r * 1000;
    EXPECT_NEAR(thigh.mass, shaft + ball, 1e-9);
    EXPECT_NEAR(thigh.centre.z, 0.2, 1e-12);
    EXPECT_NEAR(thigh.inertia[2][2], shaft * r * r / 2 + 0.4 * ball * r * r, 1e-9);
    const Link& foot = link_of(model, "foot");
    EXPECT_NEAR(foot.mass, 2000 * 0.001, 1e-9);
    EXPECT_NEAR(foot.inertia[0][0], foot.mass * 0.01 / 6, 1e-9);
    EXPECT_NEAR(link_of(model, "tail").inertia[1][2], 0.0003, 1e-15);
    EXPECT_NEAR(link_of(model, "trunk").mass, 4, 1e-12);
}

TEST(Mjcf, reads_actuators_tendons_equalities_and_keys)
{
    const RobotModel model = load_robot(kModels + "/walker.xml");
    EXPECT_EQ(model.coordinates, 15);
    ASSERT_EQ(model.actuators.size(), 3u);
    EXPECT_EQ(model.actuators[0].gear, 20);
    EXPECT_EQ(model.actuators[0].high, 1);
    EXPECT_EQ(model.actuators[1].bias_position, 1000);
    EXPECT_EQ(model.actuators[1].bias_velocity, 10);
    ASSERT_EQ(model.tendons.size(), 1u);
    EXPECT_EQ(model.actuators[2].tendon, 0);
    ASSERT_EQ(model.couplings.size(), 1u);
    EXPECT_EQ(model.couplings[0].offset, 0.1);
    EXPECT_EQ(model.couplings[0].terms[1].factor, -2);
    ASSERT_EQ(model.starts.size(), 1u);
    EXPECT_EQ(model.starts[0].positions.size(), 15u);
    EXPECT_EQ(model.excluded.size(), 1u);
    EXPECT_EQ(model.gravity.z, -10);
}

// The joint's value at the pose of the file is its reference.
TEST(Mjcf, reference_is_the_coordinate_of_the_pose_in_the_file)
{
    const RobotModel model = load_robot(kModels + "/walker.xml");
    const std::vector<double> q = reference_positions(model);
    EXPECT_NEAR(q[1], 10 * kPi / 180, 1e-15);
    const Pose trunk = forward_kinematics(model, q)[size_t(model.link_named("trunk"))];
    EXPECT_NEAR(trunk.p.z, 0.5, 1e-12);
    EXPECT_NEAR(trunk.q.w, 1, 1e-12);
    const Pose thigh = forward_kinematics(model, q)[size_t(model.link_named("thigh"))];
    const Vec down = rotate(thigh.q, {0, 0, 1});
    EXPECT_NEAR(down.x, 1, 1e-12);
}

TEST(Geometry, turns_and_matrices_agree)
{
    const Quat q = turn_of_rpy({0.3, -0.5, 1.2});
    const Quat again = turn_of(matrix_of(q));
    EXPECT_NEAR(std::fabs(q.w * again.w + q.x * again.x + q.y * again.y + q.z * again.z), 1, 1e-12);
    const Vec x = rotate(turn_of_rpy({0, 0, kPi / 2}), {1, 0, 0});
    EXPECT_NEAR(x.y, 1, 1e-12);
    const Vec z = rotate(turn_of_z({0.3, -0.2, -0.9}), {0, 0, 1});
    EXPECT_NEAR(cross(z, {0.3, -0.2, -0.9}).x, 0, 1e-12);
    EXPECT_LT(z.z, 0);
}

TEST(Geometry, principal_moments_are_those_before_the_turn)
{
    const Matrix turned = rotated({{{3, 0, 0}, {0, 1, 0}, {0, 0, 2}}}, turn_of_rpy({0.3, -0.5, 1.2}));
    const auto m = principal_moments(turned);
    EXPECT_NEAR(m[0], 1, 1e-12);
    EXPECT_NEAR(m[1], 2, 1e-12);
    EXPECT_NEAR(m[2], 3, 1e-12);
}

}  // namespace
