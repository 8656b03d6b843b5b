// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Dry friction f and armature b of tendons. A mass m on a slide that moves a tendon by c times its way falls with
// (m g - c f) / (m + c^2 b), or hangs where c f is more than m g; of a spatial tendon, whose forces act from step to step, too.
#include "robot_in_contact.h"

#include <cmath>

#include "robots/load.h"
#include "robots/write/write.h"
#include "same_model.h"

namespace {

using namespace epode::robots;

constexpr double kG = 9.81;

std::string hung(const std::string& tendon)
{
    return "<mujoco><worldbody><site name='top' pos='0 0 1'/><body name='b'><joint name='z' type='slide' "
           "axis='0 0 1'/>"
           "<geom size='0.1' mass='1'/><site name='eye'/></body></worldbody><tendon>" +
           tendon + "</tendon></mujoco>";
}
std::string fixed(const std::string& words)
{
    return hung("<fixed name='t' " + words + "><joint joint='z' coef='2'/></fixed>");
}
std::string spatial(const std::string& words)
{
    return hung("<spatial name='t' " + words + "><site site='top'/><site site='eye'/></spatial>");
}

class TendonInertia : public RobotInContact {
  protected:
    double speed(const std::string& text, double time = 0.4, double h = 0.001)
    {
        load(text);
        dWorldSetGravity(world, 0, 0, dReal(-kG));
        step(int(time / h + 0.5), h);
        return -velocities()[0];
    }
};

TEST_F(TendonInertia, of_sums_of_coordinates_brakes_and_holds)
{
    EXPECT_NEAR(speed(fixed("frictionloss='3'")), (kG - 6) * 0.4, fine(1e-6));
    EXPECT_NEAR(speed(fixed("frictionloss='6'")), 0, fine(1e-9));
    EXPECT_NEAR(speed(fixed("armature='0.5'")), kG / 3 * 0.4, fine(1e-6));
}

TEST_F(TendonInertia, of_paths_brakes_and_holds_without_creep)
{
    EXPECT_NEAR(speed(spatial("frictionloss='5'")), (kG - 5) * 0.4,
                5.1e-3);  // the first step, from rest, has none
    EXPECT_NEAR(speed(spatial("frictionloss='12'"), 1), 0, fine(1e-9));
    dReal z = 1;
    dRobotGetPositions(robot, &z, 1);
    EXPECT_NEAR(double(z), 0, fine(1e-4));  // of the first steps
}

// The error is of first order in the step: what the first one does not know.
TEST_F(TendonInertia, of_paths_is_felt_as_mass)
{
    EXPECT_NEAR(speed(spatial("armature='2'"), 0.4, 1e-3), kG / 3 * 0.4, 0.01);
    EXPECT_NEAR(speed(spatial("armature='2'"), 0.4, 1e-4), kG / 3 * 0.4, 0.001);
    EXPECT_NEAR(speed(spatial("armature='200'"), 0.4, 1e-3), kG / 201 * 0.4, 0.01);
}

TEST_F(TendonInertia, goes_on_with_the_same_bits_after_its_state_was_given_back)
{
    load(spatial("frictionloss='4' armature='0.7'"));
    dWorldSetGravity(world, 0, 0, dReal(-kG));
    step(20);
    std::vector<unsigned char> bytes(dWorldGetStateSize(world));
    ASSERT_EQ(dWorldGetState(world, bytes.data(), bytes.size()), 1);
    std::vector<dReal> numbers(size_t(dRobotGetState(robot, nullptr, 0)));
    dRobotGetState(robot, numbers.data(), int(numbers.size()));
    step(20);
    const double once = velocities()[0];
    ASSERT_EQ(dWorldSetState(world, bytes.data(), bytes.size()), 1);
    ASSERT_EQ(dRobotSetState(robot, numbers.data(), int(numbers.size())), 1);
    step(20);
    EXPECT_EQ(velocities()[0], once);
    numbers.back() = dReal(NAN);
    EXPECT_EQ(dRobotSetState(robot, numbers.data(), int(numbers.size())), 0);
}

// mujoco 4.0.0: mj_fullM and qfrc_bias at qpos 0.3 -0.4 0.5 0.7, qvel 1 -2 0.5 1.5.
TEST_F(TendonInertia, is_in_the_mass_matrix_and_in_inverse_dynamics_as_in_mujocos)
{
    load(
        "<mujoco><compiler angle='radian'/><worldbody><site name='w' pos='0.1 0.2 0.3'/><body pos='0 0 1'>"
        "<joint axis='0 0.6 0.8'/><geom size='0.1'/><body pos='0.1 0 0'><joint axis='0 1 0'/><geom "
        "size='0.05'/>"
        "<body pos='0.3 0 0'><joint axis='0 0 1'/><geom size='0.05'/><site name='sb' pos='0.1 0.02 "
        "0'/></body></body>"
        "<body pos='-0.1 0 0'><joint axis='0.8 0 0.6'/><geom size='0.05'/></body></body></worldbody><tendon>"
        "<spatial armature='0.7'><site site='w'/><site site='sb'/></spatial></tendon></mujoco>");
    const double row[4][4] = {{0.1651214756022, 0.1001199619251, 0.0098213514409, 0.0002513274123},
                              {0.1001199619251, 0.1137874381115, 0.0099002254914, 0},
                              {0.0098213514409, 0.0099002254914, 0.002017349398, 0},
                              {0.0002513274123, 0, 0, 0.0005235987756}};
    const double bias[4] = {-1.1997372846473, -1.4933599085721, 0.0036789975754, 0};
    const dReal q[4] = {dReal(0.3), dReal(-0.4), dReal(0.5), dReal(0.7)},
                v[4] = {1, -2, dReal(0.5), dReal(1.5)};
    dReal mass[16], forces[4];
    ASSERT_EQ(dRobotModelGetMassMatrix(model, q, mass, 16), 16);
    ASSERT_EQ(dRobotModelGetInverseDynamics(model, q, v, nullptr, forces, 4), 4);
    const double near = fine(1e-9, 1e-4);
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < 4; ++k) EXPECT_NEAR(double(mass[4 * i + k]), row[i][k], near) << i << k;
        EXPECT_NEAR(double(forces[i]), bias[i], fine(1e-8)) << i;
    }
}

TEST(TendonInertiaFiles, are_written_and_read_again_and_refuse_negative_numbers)
{
    for (const std::string& text :
         {spatial("frictionloss='3' armature='2'"), fixed("frictionloss='3' armature='2'")}) {
        const RobotModel model = load_robot_text("robot.xml", text);
        ASSERT_EQ(model.tendons.at(0).friction, 3);
        EXPECT_EQ(differences(model, load_robot_text("robot.xml", write_mjcf(model, ".").text)),
                  std::vector<std::string>{});
    }
    const RobotModel broken = load_robot_text(
        "robot.xml", hung("\n<fixed name='t' frictionloss='-1'><joint joint='z' coef='1'/></fixed>"));
    ASSERT_TRUE(broken.has_errors());
    EXPECT_EQ(broken.report.back().line, 2);
    EXPECT_EQ(broken.report.back().text, "the tendon 't' has a negative frictionloss or armature");
}

}  // namespace
