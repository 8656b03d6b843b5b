// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Gains that actuators take from default classes, as MuJoCo 4.0 compiles them.
#include <gtest/gtest.h>

#include <string>

#include "robots/load.h"

namespace epode::robots {
namespace {

struct Gains {
    double gain, bias_position, bias_velocity;
    bool operator==(const Gains&) const = default;
};

// Of an actuator of the class c.
Gains gains(const std::string& defaults, const std::string& actuator)
{
    const RobotModel model =
        load_robot_text("robot.xml", "<mujoco><default>" + defaults +
                                         "</default><worldbody><body><joint name='j' type='hinge'/><geom "
                                         "size='.1'/></body></worldbody><actuator><" +
                                         actuator + " class='c' joint='j'/></actuator></mujoco>");
    if (model.actuators.size() != 1) return {-1, -1, -1};
    const Actuator& a = model.actuators[0];
    return {a.gain, a.bias_position, a.bias_velocity};
}

std::ostream& operator<<(std::ostream& out, const Gains& g)
{
    return out << g.gain << ' ' << g.bias_position << ' ' << g.bias_velocity;
}

struct Case {
    const char* defaults;
    Gains position, velocity, motor, general;
};

constexpr Case kCases[] = {
    {"<position kp='20' kv='3'/><default class='c'><velocity kv='2'/></default>",
     {20, 20, 3},
     {2, 0, 2},
     {1, 0, 0},
     {2, 0, 2}},
    {"<position kp='20' kv='3'/><default class='c'><motor gear='2'/></default>",
     {20, 20, 3},
     {1, 0, 1},
     {1, 0, 0},
     {1, 0, 0}},
    {"<velocity kv='2'/><default class='c'><position kp='20'/></default>",
     {20, 20, 0},
     {2, 0, 2},
     {1, 0, 0},
     {20, 20, 0}},
    {"<general gainprm='5' biasprm='0 -5 -1' biastype='affine'/><default class='c'><position "
     "kp='20'/></default>",
     {20, 20, 1},
     {5, 0, 5},
     {1, 0, 0},
     {20, 20, 1}},
    {"<position kp='20' kv='3'/><default class='c'><position kp='30'/></default>",
     {30, 30, 3},
     {1, 0, 1},
     {1, 0, 0},
     {30, 30, 3}},
    {"<position kp='20' kv='3'/><default class='c'><general gainprm='7'/></default>",
     {7, 7, 3},
     {7, 0, 7},
     {1, 0, 0},
     {7, 20, 3}},
    {"<default class='c'><position kp='20'/><velocity kv='2'/></default>",
     {1, 1, 0},
     {2, 0, 2},
     {1, 0, 0},
     {2, 0, 2}},
    {"<default class='c'><velocity kv='2'/><position kp='20'/></default>",
     {20, 20, 0},
     {1, 0, 1},
     {1, 0, 0},
     {20, 20, 0}},
};

TEST(MjcfDefaults, gains_are_of_the_last_kind_that_a_class_names)
{
    for (const Case& c : kCases) {
        EXPECT_EQ(gains(c.defaults, "position"), c.position) << c.defaults;
        EXPECT_EQ(gains(c.defaults, "velocity"), c.velocity) << c.defaults;
        EXPECT_EQ(gains(c.defaults, "motor"), c.motor) << c.defaults;
        EXPECT_EQ(gains(c.defaults, "general"), c.general) << c.defaults;
    }
}

TEST(MjcfDefaults, what_is_no_gain_serves_all_kinds)
{
    const RobotModel model = load_robot_text(
        "robot.xml",
        "<mujoco><default><position kp='20' gear='2' ctrlrange='-1 1'/></default><worldbody><body>"
        "<joint name='j' type='hinge'/><geom size='.1'/></body></worldbody><actuator><motor "
        "joint='j'/></actuator></mujoco>");
    ASSERT_EQ(model.actuators.size(), 1u);
    EXPECT_EQ(model.actuators[0].gear, 2);
    EXPECT_EQ(model.actuators[0].low, -1);
    EXPECT_EQ(model.actuators[0].high, 1);
}

}  // namespace
}  // namespace epode::robots
