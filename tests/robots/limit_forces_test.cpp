// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sensors of limits' forces, by statics: what rests on a limit presses on it with its weight, over the arm. MuJoCo's are the same where its
// softness has come to rest; and the clock.
#include "robot_in_contact.h"

#include <cmath>

#include "robots/load.h"
#include "robots/write/write.h"
#include "same_model.h"

namespace {

using namespace epode::robots;

constexpr double kG = 9.81;

class LimitForces : public RobotInContact {
  protected:
    void settle(const std::string& body, const std::string& more)
    {
        load("<mujoco><compiler angle='radian'/><worldbody><site name='hook' pos='0 0 3'/>" + body +
             "</worldbody>" + more + "</mujoco>");
        dWorldSetGravity(world, 0, 0, dReal(-kG));
        step(1500);
    }
};

const char* const kRod =
    "<body name='rod' pos='0 0 1'><joint name='j' axis='0 1 0' range='-1 0.3'/><geom pos='0.5 0 0' size='.1' "
    "mass='2'/></body>";

// A rod that hangs at the limit 0.3 below the level: m g l cos 0.3.
TEST_F(LimitForces, of_hinges_bear_the_weight_over_its_arm)
{
    settle(kRod, "<sensor><jointlimitfrc joint='j'/><jointlimitpos joint='j'/></sensor>");
    EXPECT_NEAR(sensor(0).at(0), 2 * kG * 0.5 * std::cos(0.3), fine(1e-3));
    EXPECT_NEAR(sensor(1).at(0), 0, fine(1e-4));
    const dReal up = -0.5;
    dRobotSetPositions(robot, &up, 1);
    step(1);
    EXPECT_EQ(sensor(0).at(0), 0);
}

TEST_F(LimitForces, of_slides_with_soft_limits_bear_the_weight)
{
    settle(
        "<body pos='0 0 1'><joint name='j' type='slide' axis='0 0 1' range='-.1 1' solreflimit='.02 "
        "1'/><geom size='.1' mass='3'/></body>",
        "<sensor><jointlimitfrc joint='j' cutoff='20'/><jointlimitfrc joint='j'/></sensor>");
    EXPECT_EQ(sensor(0).at(0), dReal(20));
    EXPECT_NEAR(sensor(1).at(0), 3 * kG, fine(1e-2));
}

// A sum of two slides, s = a + 2 b >= -0.1, bears both weights with one force: f = m_a g and 2 f = m_b g.
TEST_F(LimitForces, of_fixed_tendons_act_along_the_sum)
{
    settle(
        "<body pos='0 0 1'><joint name='a' type='slide' axis='0 0 1'/><geom size='.1' mass='1'/></body>"
        "<body pos='1 0 1'><joint name='b' type='slide' axis='0 0 1'/><geom size='.1' mass='2'/></body>",
        "<tendon><fixed name='t' range='-.1 1'><joint joint='a' coef='1'/><joint joint='b' "
        "coef='2'/></fixed></tendon><sensor><tendonlimitfrc tendon='t'/></sensor>");
    EXPECT_NEAR(sensor(0).at(0), kG, fine(1e-2));
}

TEST_F(LimitForces, of_spatial_tendons_bear_the_weight)
{
    settle(
        "<body pos='0 0 1'><joint name='a' type='slide' axis='0 0 1'/><geom size='.1' mass='4'/><site "
        "name='s'/></body>",
        "<tendon><spatial name='t' range='0 2.1'><site site='hook'/><site site='s'/></spatial></tendon>"
        "<sensor><tendonlimitfrc tendon='t'/></sensor>");
    EXPECT_NEAR(sensor(0).at(0), 4 * kG, fine(1e-3));
}

// The sum of the steps; it goes on when the robot is put elsewhere, and back with its state.
TEST_F(LimitForces, and_a_clock_count_steps)
{
    settle(kRod, "<sensor><clock name='t'/></sensor>");
    EXPECT_NEAR(sensor(0).at(0), 3, fine(1e-9, 1e-4));
    std::vector<dReal> numbers(size_t(dRobotGetState(robot, nullptr, 0)));
    dRobotGetState(robot, numbers.data(), int(numbers.size()));
    step(10, 0.1);
    EXPECT_NEAR(sensor(0).at(0), 4, fine(1e-9, 1e-4));
    EXPECT_EQ(dRobotSetState(robot, numbers.data(), int(numbers.size())), 1);
    EXPECT_NEAR(sensor(0).at(0), 3, fine(1e-9, 1e-4));
}

TEST(LimitForceFiles, are_written_and_read_again)
{
    const RobotModel model = load_robot_text(
        "robot.xml",
        std::string("<mujoco><worldbody>") + kRod +
            "</worldbody><sensor><clock/><jointlimitfrc joint='j' cutoff='3'/></sensor></mujoco>");
    ASSERT_EQ(model.sensors.size(), 2u);
    EXPECT_EQ(differences(model, load_robot_text("robot.xml", write_mjcf(model, ".").text)),
              std::vector<std::string>{});
}

}  // namespace
