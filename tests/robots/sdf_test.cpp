// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// SDF: libsdformat's own translation of a URDF is the same robot; loops, gearboxes, frames and limits of a text of our own.
#include <gtest/gtest.h>

#include "robots/kinematics.h"
#include "robots/load.h"

#ifdef EPODE_HAVE_SDF
#include <sdf/sdf.hh>

namespace {

using namespace epode::robots;

const std::string kModels = EPODE_MODELS;

std::string report_of(const RobotModel& model)
{
    std::string out;
    for (const ReportLine& line : model.report)
        out += std::string(name_of(line.note)) + " " + std::to_string(line.line) + ": " + line.text + "\n";
    return out;
}

const std::string kInertial =
    "<inertial><mass>2</mass><pose>0 0 0.1 0 0 "
    "0</pose><inertia><ixx>0.02</ixx><iyy>0.02</iyy><izz>0.01</izz></inertia></inertial>";
std::string link(const std::string& name, const std::string& pose, const std::string& more = "")
{
    return "<link name='" + name + "'><pose>" + pose + "</pose>" + kInertial + more + "</link>\n";
}
std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                  const std::string& child, const std::string& more = "")
{
    return "<joint name='" + name + "' type='" + type + "'><parent>" + parent + "</parent><child>" + child +
           "</child>" + more + "</joint>\n";
}
RobotModel load(const std::string& inside, const LoadOptions& options = {})
{
    return load_robot_text(kModels + "/text.sdf",
                           "<sdf version='1.7'><model name='m'>\n" + inside + "</model></sdf>", options);
}

// Mass matrix of the joints of both, in the order of the first.
std::vector<double> mass_matrix_of(const RobotModel& model, const RobotModel& order)
{
    std::vector<double> q = reference_positions(model), out;
    std::vector<size_t> numbers;
    size_t count = 0;
    std::vector<size_t> first;
    for (const Joint& its : model.joints) first.push_back(count), count += size_t(velocities_of(its));
    for (const Joint& its : order.joints) {
        if (!its.is_scalar()) continue;
        const int number = model.joint_named(its.name);
        EXPECT_GE(number, 0) << its.name;
        if (number < 0) return {};
        q[size_t(model.joints[size_t(number)].position)] = 0.1 * double(its.position) - 0.2;
        numbers.push_back(first[size_t(number)]);
    }
    const std::vector<double> whole = mass_matrix(model, q);
    for (size_t i : numbers)
        for (size_t k : numbers) out.push_back(whole[i * count + k]);
    return out;
}

// libsdformat reads URDF too, and it leaves out links without a mass.
const std::string kUrdf = R"(<robot name="r"><link name="world"/>
<link name="base"><inertial><origin xyz="0 0.1 0.2" rpy="0.1 0.2 0.3"/><mass value="3"/>
<inertia ixx="0.3" iyy="0.25" izz="0.2" ixy="0.01" ixz="0.02" iyz="0.03"/></inertial></link>
<link name="arm"><inertial><origin xyz="0.3 0 0" rpy="0.4 0 0"/><mass value="2"/>
<inertia ixx="0.1" iyy="0.2" izz="0.2" ixy="0" ixz="0.01" iyz="0"/></inertial></link>
<link name="tool"><inertial><mass value="0.5"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="slide"><inertial><mass value="0.7"/><inertia ixx="0.01" iyy="0.02" izz="0.015" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="ground" type="fixed"><parent link="world"/><child link="base"/><origin xyz="1 2 3" rpy="0.3 -0.2 0.1"/></joint>
<joint name="turn" type="revolute"><parent link="base"/><child link="arm"/><origin xyz="0.1 0.2 0.3" rpy="1 0.5 -0.3"/>
<axis xyz="0 0.6 0.8"/><limit lower="-1" upper="2" effort="100" velocity="3"/></joint>
<joint name="weld" type="fixed"><parent link="arm"/><child link="tool"/><origin xyz="0.5 0 0.1" rpy="0 0.3 0"/></joint>
<joint name="push" type="prismatic"><parent link="tool"/><child link="slide"/><origin xyz="0 0.2 0" rpy="0.2 0.3 0.4"/>
<axis xyz="1 0 0"/><limit lower="0" upper="1" effort="10" velocity="1"/></joint></robot>)";

TEST(Sdf, libsdformats_translation_of_a_urdf_is_the_same_robot)
{
    const RobotModel urdf = load_robot_text("r.urdf", kUrdf);
    sdf::Console::Instance()->SetQuiet(true);
    const sdf::SDFPtr document = std::make_shared<sdf::SDF>();
    sdf::Errors errors;
    sdf::init(document);
    ASSERT_TRUE(sdf::readString(kUrdf, document, errors));
    const RobotModel model = load_robot_text("r.sdf", document->ToString());
    ASSERT_FALSE(model.has_errors()) << report_of(model);
    const std::vector<double> a = mass_matrix_of(urdf, urdf), b = mass_matrix_of(model, urdf);
    ASSERT_EQ(a.size(), 4u);
    ASSERT_EQ(b.size(), 4u);
    for (size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-12) << i;
    const Joint& turn = model.joints[size_t(model.joint_named("turn"))];
    EXPECT_EQ(turn.low, -1);
    EXPECT_EQ(turn.max_force, 100);
    EXPECT_EQ(turn.max_velocity, 3);
}

TEST(Sdf, a_file_has_all_that_its_text_says)
{
    const RobotModel model = load_robot(kModels + "/geared.sdf");
    ASSERT_FALSE(model.has_errors()) << report_of(model);
    EXPECT_EQ(model.links.size(), 7u);
    EXPECT_EQ(model.coordinates, 7 + 1 + 1 + 1 + 2 + 4);
    EXPECT_EQ(model.closures.size(), 2u);
    EXPECT_EQ(model.actuators.size(), 4u);  // a motor on each axis but the gear's
    const Link& base = model.links[size_t(model.link_named("base"))];
    ASSERT_EQ(base.shapes.size(), 2u);
    EXPECT_EQ(base.shapes[0].friction, 0.7);
    EXPECT_EQ(model.meshes[size_t(base.shapes[1].mesh)].scale.y, -0.1);
    EXPECT_NEAR(base.visuals[0].color[1], 0.2, 1e-6);
}

TEST(Sdf, poses_limits_drives_and_frames)
{
    const RobotModel model =
        load(link("base", "0 0 1 0 0 0") + link("arm", "0.5 0 1 0 0 1.5707963267948966") +
             joint("j", "revolute", "base", "arm",
                   "<pose>0 0.2 0 0 0 0</pose><axis><xyz expressed_in='__model__'>0 1 "
                   "0</xyz><limit><lower>-1</lower><upper>2</upper>"
                   "<effort>7</effort></limit><dynamics><damping>0.3</damping><friction>0.1</"
                   "friction><spring_stiffness>4</spring_stiffness>"
                   "<spring_reference>0.2</spring_reference></dynamics></axis>") +
             "<frame name='tool' attached_to='arm'><pose>0 0 0.3 0 0 0</pose></frame>");
    ASSERT_FALSE(model.has_errors()) << report_of(model);
    ASSERT_EQ(model.joints.size(), 2u);
    const Joint& j = model.joints[1];
    EXPECT_EQ(j.low, -1);
    EXPECT_EQ(j.high, 2);
    EXPECT_EQ(j.max_force, 7);
    EXPECT_EQ(j.damping, 0.3);
    EXPECT_EQ(j.stiffness, 4);
    EXPECT_EQ(j.spring_reference, 0.2);
    EXPECT_EQ(j.friction, 0.1);
    EXPECT_NEAR(j.axis.x, 1, 1e-12);  // y of the model is x of the arm
    EXPECT_NEAR(j.anchor.y, 0.2, 1e-12);
    const Pose arm = forward_kinematics(model, reference_positions(model))[2];
    EXPECT_NEAR(arm.p.x, 0.5, 1e-12);
    EXPECT_NEAR(arm.p.z, 1, 1e-12);
    EXPECT_EQ(model.link_named("tool"), 2);
    EXPECT_NEAR(model.links[2].centre.z, 0.1, 1e-12);
}

TEST(Sdf, loops_close_and_gearboxes_couple)
{
    const std::string axis = "<axis><xyz>0 1 0</xyz></axis>", back = "<axis><xyz>0 -1 0</xyz></axis>";
    const RobotModel model =
        load(link("base", "0 0 0 0 0 0") + link("a", "0 0 1 0 0 0") + link("b", "1 0 1 0 0 0") +
             joint("ja", "revolute", "base", "a", axis) + joint("jb", "revolute", "base", "b", back) +
             joint("loop", "revolute", "a", "b", axis) +
             joint("gears", "gearbox", "a", "b",
                   axis + "<axis2><xyz>0 1 "
                          "0</xyz></axis2><gearbox_ratio>3</gearbox_ratio><gearbox_reference_body>base</"
                          "gearbox_reference_body>"));
    ASSERT_FALSE(model.has_errors()) << report_of(model);
    EXPECT_EQ(model.closures.size(), 2u);
    EXPECT_NEAR(model.closures[0].pose2.p.x, 1, 1e-12);
    ASSERT_EQ(model.couplings.size(), 1u);
    EXPECT_EQ(model.couplings[0].terms[0].factor, -1);  // jb turns the other way
    EXPECT_EQ(model.couplings[0].terms[1].factor, 3);
}

TEST(Sdf, a_model_without_self_collision_touches_others_alone)
{
    const std::string ball =
        "<collision name='c'><geometry><sphere><radius>0.1</radius></sphere></geometry></collision>";
    const Shape shape = load(link("a", "0 0 0 0 0 0", ball)).links[1].shapes.at(0);
    EXPECT_EQ(shape.category & shape.collide, 0u);
    EXPECT_NE(shape.collide & 1, 0u);
    const Shape other =
        load(link("a", "0 0 0 0 0 0", ball) + "<self_collide>1</self_collide>").links[1].shapes.at(0);
    EXPECT_NE(other.category & other.collide, 0u);
}

TEST(Sdf, what_is_wrong_is_refused)
{
    EXPECT_NE(
        report_of(load("<include><uri>model://x</uri></include>")).find("error 2: <include> is not read"),
        std::string::npos);
    EXPECT_NE(report_of(load(link("a", "0 0 0 0 0 0") + link("a", "0 0 0 0 0 0"))).find("error"),
              std::string::npos);
    EXPECT_NE(
        report_of(load(link("a", "0 0 0 0 0 0") + joint("j", "revolute", "a", "nobody"))).find("nobody"),
        std::string::npos);
    EXPECT_NE(report_of(load(link("a", "0 0 0 0 0 0") + link("b", "0 0 0 0 0 0") +
                             joint("j", "screw", "a", "b", "<axis><xyz>0 0 1</xyz></axis>")))
                  .find("has a type that is not read"),
              std::string::npos);
    const std::string ring = joint("j", "ball", "a", "b") + joint("k", "ball", "b", "a");
    EXPECT_NE(
        report_of(load(link("a", "0 0 0 0 0 0") + link("b", "0 0 0 0 0 0") + ring)).find("ring of joints"),
        std::string::npos);
}

}  // namespace

#endif
