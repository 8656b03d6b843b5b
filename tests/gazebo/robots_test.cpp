// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Robots through the features of gz-physics: a cart on two driven wheels, and a gripper whose second finger mimics the first.
#include "tests/gazebo/engine.h"

namespace {

constexpr double kRadius = 0.1, kTrack = 0.4;

class Robots : public Gazebo {
  protected:
    static std::string wheel(const std::string& name, double y)
    {
        // Round across too: the track is known where a flat rim rubs along its width.
        return link(name, "0 " + std::to_string(y) + " 0.1 0 0 0", "<sphere><radius>0.1</radius></sphere>",
                    0.5, 0.002);
    }
    static std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                             const std::string& child, const std::string& axis)
    {
        return "<joint name='" + name + "' type='" + type + "'><parent>" + parent + "</parent><child>" +
               child + "</child><axis>" + axis + "</axis></joint>";
    }
};

TEST_F(Robots, cart_drives_as_its_wheels_turn)
{
    const std::string ice = "<surface><friction><ode><mu>0</mu></ode></friction></surface>";
    const std::string y = "<xyz expressed_in='__model__'>0 1 0</xyz>";
    const WorldPtr world = world_of(
        plane() + "<model name='cart'>" + link("body", "0 0 0.15 0 0 0", box(0.1), 4, 0.05) +
        wheel("left", 0.2) + wheel("right", -0.2) +
        link("caster", "0.3 0 0.05 0 0 0", "<sphere><radius>0.05</radius></sphere>", 0.5, 0.001, ice) +
        link("tail", "-0.3 0 0.05 0 0 0", "<sphere><radius>0.05</radius></sphere>", 0.5, 0.001, ice) +
        "<joint name='front' type='fixed'><parent>body</parent><child>caster</child></joint>"
        "<joint name='back' type='fixed'><parent>body</parent><child>tail</child></joint>" +
        joint("l", "revolute", "body", "left", y) + joint("r", "revolute", "body", "right", y) + "</model>");
    const ModelPtr cart = world->GetModel("cart");
    const LinkPtr body = cart->GetLink("body");
    step(world, 200);
    cart->GetJoint("l")->SetVelocityCommand(0, 5), cart->GetJoint("r")->SetVelocityCommand(0, 5);
    step(world, 500);
    const double from = place(body).x();
    step(world, 1000);
    // v = r w.
    EXPECT_NEAR(place(body).x() - from, kRadius * 5, 0.01);
    EXPECT_NEAR(place(body).y(), 0, 0.01);
    cart->GetJoint("l")->SetVelocityCommand(0, 2), cart->GetJoint("r")->SetVelocityCommand(0, 4);
    step(world, 500);
    const auto data = body->FrameDataRelativeToWorld();
    // v = r (w_l + w_r) / 2; the cart turns at r (w_r - w_l) / track.
    EXPECT_NEAR(data.linearVelocity.norm(), kRadius * 3, 0.01);
    EXPECT_NEAR(data.angularVelocity.z(), kRadius * 2 / kTrack, 0.02);
}

TEST_F(Robots, gripper_lifts_what_it_holds)
{
    const auto finger = [](const std::string& name, const char* pose) {
        return link(name, pose, "<box><size>0.02 0.06 0.1</size></box>", 0.2, 0.001);
    };
    const std::string effort = "<limit><effort>20</effort></limit>";
    const std::string mimic = "<mimic joint='left'><multiplier>1</multiplier><offset>0</offset></mimic>";
    const WorldPtr world =
        world_of(plane() + "<model name='arm'>" + link("hand", "0 0 0.5 0 0 0", "", 1, 0.01) +
                 finger("one", "-0.1 0 0.1 0 0 0") + finger("two", "0.1 0 0.1 0 0 0") +
                 joint("lift", "prismatic", "world", "hand", "<xyz>0 0 1</xyz>") +
                 joint("left", "prismatic", "hand", "one", "<xyz>1 0 0</xyz>" + effort) +
                 joint("right", "prismatic", "hand", "two", "<xyz>-1 0 0</xyz>" + mimic) + "</model>" +
                 "<model name='load'>" + link("l", "0.005 0 0.05 0 0 0", box(0.1), 0.5, 0.001) + "</model>");
    const ModelPtr arm = world->GetModel("arm");
    const LinkPtr load = link_of(world, "load");
    arm->GetJoint("lift")->SetVelocityCommand(0, 0);
    arm->GetJoint("left")->SetVelocityCommand(0, 0.1);
    step(world, 1000);
    EXPECT_NEAR(arm->GetJoint("left")->GetPosition(0), 0.04, 2e-3);
    EXPECT_NEAR(arm->GetJoint("right")->GetPosition(0), arm->GetJoint("left")->GetPosition(0), 1e-3);
    EXPECT_NEAR(place(load).x(), 0, 2e-3);  // pushed to the middle
    arm->GetJoint("lift")->SetVelocityCommand(0, 0.2);
    step(world, 1000);
    EXPECT_NEAR(place(load).z(), 0.05 + 0.2, 5e-3);
    arm->GetJoint("lift")->SetVelocityCommand(0, 0);
    arm->GetJoint("left")->SetVelocityCommand(0, -0.1);
    step(world, 1000);
    EXPECT_NEAR(place(load).z(), 0.05, 1e-3);  // let go, it lies where it was taken from
}

}  // namespace
