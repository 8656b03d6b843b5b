// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints through the features of gz-physics, against closed forms.
#include "tests/gazebo/engine.h"

namespace {

constexpr double kMoment = 0.1;

// A link on a joint to the world, without gravity.
std::string jointed(const std::string& type, const std::string& axes, const std::string& more = "")
{
    return "<joint name='j' type='" + type + "'><parent>world</parent><child>a</child>" + axes + more +
           "</joint>";
}
std::string axis(const std::string& xyz, const std::string& more = "", const std::string& name = "axis")
{
    return "<" + name + "><xyz>" + xyz + "</xyz>" + more + "</" + name + ">";
}

class Jointed : public Gazebo {
  protected:
    JointPtr make(const std::string& joint, const std::string& pose = "0 0 1 0 0 0")
    {
        world_ = world_of("<model name='m'>" + link("a", pose, "", 2, kMoment) + joint + "</model>");
        world_->SetGravity(Vec3(0, 0, 0));
        return world_->GetModel("m")->GetJoint("j");
    }
    WorldPtr world_;
};

TEST_F(Jointed, positions_of_every_kind_are_the_files_own)
{
    const struct {
        const char *type, *axes, *more;
        std::vector<double> at;
    } kinds[] = {
        {"revolute", "<axis><xyz>0 0 1</xyz></axis>", "", {4.5}},
        {"continuous", "<axis><xyz>0 1 0</xyz></axis>", "", {-2}},
        {"prismatic", "<axis><xyz>1 0 0</xyz></axis>", "", {0.7}},
        {"universal", "<axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 1 0</xyz></axis2>", "", {0.4, -0.6}},
        {"revolute2", "<axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 1 0</xyz></axis2>", "", {0.3, 1.1}},
        {"ball", "", "", {0.2, -0.3, 0.5}},
        {"screw", "<axis><xyz>0 0 1</xyz></axis>", "<thread_pitch>-4</thread_pitch>", {1.5}}};
    for (const auto& kind : kinds) {
        const JointPtr joint = make(jointed(kind.type, kind.axes, kind.more));
        ASSERT_TRUE(joint) << kind.type;
        ASSERT_EQ(joint->GetDegreesOfFreedom(), kind.at.size()) << kind.type;
        for (std::size_t i = 0; i < kind.at.size(); ++i) joint->SetPosition(i, kind.at[i]);
        for (std::size_t i = 0; i < kind.at.size(); ++i)
            EXPECT_NEAR(joint->GetPosition(i), kind.at[i], 1e-9) << kind.type << i;
        if (kind.type == std::string("ball")) continue;  // velocities are not derivatives of its positions
        std::vector<double> before;
        for (std::size_t i = 0; i < kind.at.size(); ++i) joint->SetVelocity(i, 0.1 + double(i));
        for (std::size_t i = 0; i < kind.at.size(); ++i) {
            EXPECT_NEAR(joint->GetVelocity(i), 0.1 + double(i), 1e-9) << kind.type << i;
            before.push_back(joint->GetPosition(i));
        }
        step(world_, 1);
        // Rates are derivatives of positions, with their sign.
        for (std::size_t i = 0; i < kind.at.size(); ++i)
            EXPECT_NEAR((joint->GetPosition(i) - before[i]) / 1e-3, 0.1 + double(i), 0.02) << kind.type << i;
    }
}

TEST_F(Jointed, child_stands_where_positions_put_it)
{
    const JointPtr joint = make(jointed("universal", axis("1 0 0") + axis("0 1 0", "", "axis2")));
    joint->SetPosition(0, 0.5), joint->SetPosition(1, -0.8);
    const Eigen::Matrix3d turn =
        (Eigen::AngleAxisd(0.5, Vec3::UnitX()) * Eigen::AngleAxisd(-0.8, Vec3::UnitY())).toRotationMatrix();
    const auto pose = world_->GetModel("m")->GetLink("a")->FrameDataRelativeToWorld().pose;
    EXPECT_LT((pose.linear() - turn).norm(), 1e-9);
    const JointPtr screw = make(jointed("screw", axis("0 0 1"), "<thread_pitch>-4</thread_pitch>"));
    screw->SetPosition(0, 2);
    EXPECT_NEAR(place(world_->GetModel("m")->GetLink("a")).z(), 1 + 2 / 4.0, 1e-9);
    screw->SetVelocity(0, 1);
    step(world_, 1000);
    const double z = place(world_->GetModel("m")->GetLink("a")).z();
    EXPECT_NEAR(z - 1, screw->GetPosition(0) / 4, 1e-4);
    EXPECT_GT(screw->GetPosition(0), 2.5);
}

TEST_F(Jointed, forces_last_a_step)
{
    const JointPtr joint = make(jointed("revolute", axis("0 0 1")));
    for (int i = 0; i < 100; ++i) joint->SetForce(0, 0.3), step(world_, 1);
    EXPECT_NEAR(joint->GetVelocity(0), 0.3 / kMoment * 0.1, 1e-6);
    EXPECT_NEAR(joint->GetAcceleration(0), 0.3 / kMoment, 1e-4);
    EXPECT_NEAR(joint->GetForce(0), 0.3, 1e-6);
    step(world_, 100);
    EXPECT_NEAR(joint->GetVelocity(0), 0.3 / kMoment * 0.1, 1e-6);
    EXPECT_NEAR(joint->GetForce(0), 0, 1e-9);
    joint->SetMaxEffort(0, 0.1);
    for (int i = 0; i < 100; ++i) joint->SetForce(0, 5), step(world_, 1);
    EXPECT_NEAR(joint->GetVelocity(0), 0.4 / kMoment * 0.1, 1e-6);
}

TEST_F(Jointed, velocity_commands_keep_their_limits)
{
    const JointPtr joint =
        make(jointed("revolute", axis("0 0 1", "<limit><effort>2</effort><velocity>3</velocity></limit>")));
    joint->SetVelocityCommand(0, 2);
    step(world_, 50);  // 2 N m on 0.1 kg m^2: 20 rad/s^2
    EXPECT_NEAR(joint->GetVelocity(0), 1, 0.03);
    step(world_, 100);
    EXPECT_NEAR(joint->GetVelocity(0), 2, 1e-6);
    joint->SetVelocityCommand(0, 50);
    step(world_, 500);
    EXPECT_NEAR(joint->GetVelocity(0), 3, 1e-6);
    joint->SetForce(0, 0);  // ends the command
    joint->SetVelocity(0, 1);
    step(world_, 100);
    EXPECT_NEAR(joint->GetVelocity(0), 1, 1e-6);
}

TEST_F(Jointed, stops_damping_friction_and_springs)
{
    JointPtr joint =
        make(jointed("prismatic", axis("1 0 0", "<limit><lower>-1</lower><upper>0.2</upper></limit>")));
    joint->SetVelocity(0, 2);
    step(world_, 500);
    EXPECT_NEAR(joint->GetPosition(0), 0.2, 1e-3);
    joint->SetMaxPosition(0, 0.5);
    joint->SetVelocity(0, 2);
    step(world_, 500);
    EXPECT_NEAR(joint->GetPosition(0), 0.5, 1e-3);

    joint = make(jointed("revolute", axis("0 0 1", "<dynamics><damping>0.2</damping></dynamics>")));
    joint->SetVelocity(0, 1);
    step(world_, 500);
    EXPECT_NEAR(joint->GetVelocity(0), std::exp(-0.2 * 0.5 / kMoment), 1e-3);

    joint = make(jointed("revolute", axis("0 0 1", "<dynamics><friction>0.05</friction></dynamics>")));
    for (int i = 0; i < 100; ++i) joint->SetForce(0, 0.04), step(world_, 1);
    EXPECT_NEAR(joint->GetVelocity(0), 0, 1e-6);
    for (int i = 0; i < 100; ++i) joint->SetForce(0, 0.15), step(world_, 1);
    EXPECT_NEAR(joint->GetVelocity(0), 0.1 / kMoment * 0.1, 1e-3);

    const std::string spring =
        "<dynamics><spring_stiffness>10</spring_stiffness><spring_reference>0.5</spring_reference>"
        "<damping>2</damping></dynamics>";
    joint = make(jointed("revolute", axis("0 0 1", spring)));
    step(world_, 3000);
    EXPECT_NEAR(joint->GetPosition(0), 0.5, 1e-4);
}

TEST_F(Jointed, wrench_is_what_the_parent_exerts)
{
    // 2 kg, 0.5 m out along x of a joint that holds it level.
    const JointPtr joint = make(
        "<joint name='j' type='fixed'><pose>-0.5 0 0 0 0 0</pose><parent>world</parent>"
        "<child>a</child></joint>");
    world_->SetGravity(Vec3(0, 0, -kGravity));
    step(world_, 20);
    const auto wrench = joint->GetTransmittedWrench();
    EXPECT_LT((wrench.force - Vec3(0, 0, 2 * kGravity)).norm(), 1e-4);
    EXPECT_LT((wrench.torque - Vec3(0, -2 * kGravity * 0.5, 0)).norm(), 1e-4);
    EXPECT_NEAR(joint->FrameDataRelativeToWorld().pose.translation().x(), -0.5, 1e-6);
    EXPECT_LT((joint->GetTransformToChild().translation() - Vec3(0.5, 0, 0)).norm(), 1e-12);
}

TEST_F(Gazebo, mimic_follows_its_leader)
{
    const std::string mimic = "<mimic joint='lead'><multiplier>-2</multiplier><offset>0.1</offset></mimic>";
    const std::string gripper =
        "<model name='m'>" + link("a", "0 0 1 0 0 0") + link("b", "0 1 1 0 0 0") +
        "<joint name='follow' type='prismatic'><parent>world</parent><child>b</child>" +
        axis("1 0 0", mimic) +
        "</joint><joint name='lead' type='revolute'><parent>world</parent><child>a</child>" + axis("0 0 1") +
        "</joint></model>";
    const WorldPtr world = world_of(gripper);
    world->SetGravity(Vec3(0, 0, 0));
    const JointPtr lead = world->GetModel("m")->GetJoint("lead"),
                   follow = world->GetModel("m")->GetJoint("follow");
    lead->SetVelocityCommand(0, 0.5);
    step(world, 1000);
    EXPECT_NEAR(lead->GetPosition(0), 0.5, 0.06);
    EXPECT_NEAR(follow->GetPosition(0), -2 * lead->GetPosition(0) + 0.1, 1e-3);
    EXPECT_NEAR(follow->GetVelocity(0), -2 * lead->GetVelocity(0), 1e-4);
}

TEST_F(Gazebo, attaches_and_detaches)
{
    const std::string ball = "<sphere><radius>0.1</radius></sphere>";
    const WorldPtr world = world_of(body("a", "0 0 1 0 0 0", ball) + body("b", "0.5 0 1 0 0 0", ball));
    const LinkPtr a = link_of(world, "a"), b = link_of(world, "b");
    const auto held = a->AttachFixedJoint(nullptr, "hook");
    ASSERT_TRUE(held);
    const auto arm = b->AttachRevoluteJoint(a, "arm", Vec3(0, 1, 0));
    ASSERT_TRUE(arm);
    EXPECT_FALSE(a->FindFreeGroup());
    arm->SetTransformFromParent(Pose3(Eigen::Translation3d(0, 0, 0.5)));
    EXPECT_LT((place(b) - Vec3(0, 0, 1.5)).norm(), 1e-9);
    step(world, 200);
    EXPECT_LT((place(a) - Vec3(0, 0, 1)).norm(), 1e-4);
    held->Detach();
    EXPECT_TRUE(a->FindFreeGroup());
    step(world, 500);
    EXPECT_NEAR(a->FrameDataRelativeToWorld().linearVelocity.z(), -kGravity * 0.5, 0.3);
    EXPECT_FALSE(a->AttachFixedJoint(a, "itself"));
}

TEST_F(Gazebo, loops_of_joints_hold)
{
    // Four bars in a square, closed, that hang on the world.
    std::string loop = "<model name='m'>";
    const char* poses[] = {"0.5 0 2 0 0 0", "1 0.5 2 0 0 0", "0.5 1 2 0 0 0", "0 0.5 2 0 0 0"};
    for (int i = 0; i < 4; ++i) loop += link("b" + std::to_string(i), poses[i]);
    const auto hinge = [](int i, const char* pose) {
        const std::string from = "b" + std::to_string(i), to = "b" + std::to_string((i + 1) % 4);
        return "<joint name='j" + std::to_string(i) + "' type='revolute'><pose relative_to='__model__'>" +
               pose + "</pose><parent>" + from + "</parent><child>" + to + "</child>" + axis("0 0 1") +
               "</joint>";
    };
    loop +=
        hinge(0, "1 0 2 0 0 0") + hinge(1, "1 1 2 0 0 0") + hinge(2, "0 1 2 0 0 0") + hinge(3, "0 0 2 0 0 0");
    loop += "<joint name='hook' type='fixed'><parent>world</parent><child>b0</child></joint></model>";
    const WorldPtr world = world_of(loop);
    ASSERT_EQ(world->GetModel("m")->GetJointCount(), 5u);
    step(world, 500);
    for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(place(world->GetModel("m")->GetLink("b" + std::to_string(i))).z(), 2, 1e-3) << i;
}

}  // namespace
