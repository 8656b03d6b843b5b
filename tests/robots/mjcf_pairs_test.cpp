// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// MJCF's <contact><pair>: two geoms whose contact says its own friction and size, whatever their bits and materials say. Blocks on a
// floor, gravity tilted by 20 degrees: of friction mu they slide with g (sin - mu cos), or stay where that is not above 0.
#include <ode/ext.h>

#include <cmath>

#include "robot_in_contact.h"
#include "robots/load.h"
#include "robots/write/write.h"
#include "same_model.h"

namespace {

using namespace epode::robots;

constexpr double kG = 9.81, kTilt = 0.3490658503988659;

// A floor and three blocks, of which the first has a pair with the floor.
std::string blocks(const std::string& pair, const std::string& geoms = "friction='1'")
{
    std::string out = "<mujoco><worldbody><geom name='floor' type='plane' size='9 9 1' friction='1'/>";
    for (int i = 0; i < 3; ++i) {
        const std::string n = std::to_string(i);
        out += "<body name='b" + n + "' pos='0 " + n + " 0.1'><freejoint/><geom name='g" + n +
               "' type='box' size='0.2 0.2 0.1' mass='2' " + geoms + "/></body>";
    }
    return out + "</worldbody><contact>" + pair + "</contact></mujoco>";
}

class MjcfPairs : public RobotInContact {
  protected:
    // Of the blocks along the slope, after a second from rest; below the floor: how fast they fall.
    std::array<double, 3> speeds(const std::string& text, bool fallen = false)
    {
        load(text);
        dWorldSetGravity(world, 0, 0, dReal(-kG));
        step(100);
        dWorldSetGravity(world, dReal(kG * std::sin(kTilt)), 0, dReal(-kG * std::cos(kTilt)));
        step(500);
        std::array<double, 3> out{};
        for (int i = 0; i < 3; ++i) {
            const dBodyID body = dRobotGetBody(robot, i + 1);
            out[size_t(i)] = double(dBodyGetLinearVel(body)[fallen ? 2 : 0]);
        }
        return out;
    }
};

double sliding(double mu) { return kG * (std::sin(kTilt) - mu * std::cos(kTilt)); }

TEST_F(MjcfPairs, slide_with_their_own_friction_where_the_larger_of_the_geoms_would_hold)
{
    const auto v =
        speeds(blocks("<pair geom1='g0' geom2='floor' friction='0.1 0.1'/>"
                      "<pair geom1='floor' geom2='g1' friction='0.3 0.3' solref='0.02 1'/>"));
    EXPECT_NEAR(v[0], sliding(0.1), 0.01);
    EXPECT_NEAR(v[1], sliding(0.3), 0.02);
    EXPECT_NEAR(v[2], 0, fine(1e-6));
}

TEST_F(MjcfPairs, hold_where_the_geoms_themselves_would_slip_and_slip_with_condim_one)
{
    const auto v =
        speeds(blocks("<pair geom1='floor' geom2='g0' friction='0.5 0.5'/>"
                      "<pair geom1='floor' geom2='g1' condim='1'/>",
                      "friction='0.05' priority='1'"));
    EXPECT_NEAR(v[0], 0, fine(1e-6));
    EXPECT_NEAR(v[1], sliding(0), 0.01);
    EXPECT_NEAR(v[2], sliding(0.05), 0.01);
}

// The first and second are in pairs with the floor, the third is not and falls through it.
TEST_F(MjcfPairs, touch_whatever_their_bits_say_and_with_nothing_else)
{
    const auto v = speeds(blocks("<pair geom1='g0' geom2='floor'/><pair geom1='g1' geom2='floor'/>",
                                 "contype='0' conaffinity='0'"),
                          true);
    EXPECT_NEAR(v[0], 0, fine(1e-4));
    EXPECT_NEAR(v[1], 0, fine(1e-4));
    EXPECT_LT(v[2], -9);
}

TEST(MjcfPairFiles, are_written_and_read_again)
{
    const RobotModel model = load_robot_text(
        "robot.xml",
        blocks("<pair name='p' geom1='g0' geom2='floor' condim='6' friction='0.1 0.1 0.2 0.3 0.3' "
               "solref='0.01 0.9' solimp='0.8 0.9 0.01'/>",
               "contype='0' conaffinity='0'"));
    ASSERT_FALSE(model.has_errors());
    ASSERT_EQ(model.pairs.size(), 1u);
    EXPECT_EQ(model.pairs[0].dimensions, 6);
    EXPECT_DOUBLE_EQ(model.pairs[0].rolling_friction, 0.3);
    const RobotModel again = load_robot_text("robot.xml", write_mjcf(model, ".").text);
    EXPECT_EQ(differences(model, again), std::vector<std::string>{});
}

TEST(MjcfPairFiles, that_name_no_geom_are_errors_with_their_line)
{
    const RobotModel model = load_robot_text("robot.xml", blocks("\n<pair geom1='g0' geom2='flor'/>"));
    ASSERT_TRUE(model.has_errors());
    const auto& line = model.report.back();
    EXPECT_EQ(line.line, 2);
    EXPECT_EQ(line.text, "a pair of the geoms 'g0' and 'flor'; one is not there");
}

// MuJoCo's pairs touch there; a joint's two links never do in ours: an entry that is ignored.
TEST(MjcfPairFiles, of_links_that_a_joint_connects_are_ignored_with_a_line)
{
    const RobotModel model = load_robot_text(
        "robot.xml",
        "<mujoco><worldbody><body><freejoint/><geom name='a' size='0.1'/><body><joint/><geom name='b' "
        "size='0.1'/></body></body></worldbody><contact><pair geom1='a' geom2='b'/></contact></mujoco>");
    EXPECT_FALSE(model.has_errors());
    EXPECT_TRUE(model.pairs.empty());
    EXPECT_EQ(model.report.back().note, Note::kIgnored);
}

}  // namespace
