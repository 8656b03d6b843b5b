// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Couplings that are no straight lines: derivatives, worlds that follow the curve, also where it is flat at the reference, energies,
// states, files.
#include "robot_in_contact.h"

#include <cmath>

#include "robots/constraints.h"
#include "robots/load.h"
#include "robots/write/write.h"
#include "same_model.h"

namespace {

using namespace epode::robots;

// A slide that follows a hinge, and a sum of two joints that follows another one.
std::string bent(const std::string& equality)
{
    return "<mujoco><compiler angle='radian'/><worldbody>"
           "<body><joint name='turn' axis='0 1 0' ref='0.2'/><geom type='capsule' fromto='0 0 0 .4 0 0' "
           "size='.02' mass='1'/></body>"
           "<body pos='0 1 0'><joint name='lift' type='slide' axis='0 0 1'/><geom size='.1' "
           "mass='.5'/></body>"
           "<body pos='0 2 0'><joint name='free' type='slide' axis='1 0 0'/><geom size='.1' "
           "mass='1'/></body></worldbody>"
           "<tendon><fixed name='one'><joint joint='lift' coef='2'/></fixed>"
           "<fixed name='two'><joint joint='turn' coef='.5'/><joint joint='free' coef='1'/></fixed></tendon>"
           "<equality>" +
           equality + "</equality></mujoco>";
}

const char* const kCurves[] = {"<joint joint1='lift' joint2='turn' polycoef='.1 .5 .3 -.2 .1'/>",
                               "<joint joint1='lift' joint2='turn' polycoef='0 0 .4'/>",
                               "<tendon tendon1='one' tendon2='two' polycoef='.05 .3 .2'/>"};

// c is sum f q - p(x) - offset by hand, and C its difference quotient.
TEST(Bends, have_the_errors_of_their_curves_and_their_derivatives)
{
    for (const char* curve : kCurves) {
        const RobotModel model = load_robot_text("robot.xml", bent(curve));
        ASSERT_FALSE(model.has_errors()) << curve;
        EXPECT_EQ(model.report.back().note, Note::kChanged);
        const std::vector<double> q{0.9, -0.3, 0.4}, row = constraint_jacobian(model, q);
        ASSERT_EQ(row.size(), 3u);
        constexpr double kStep = 1e-6;
        for (size_t k = 0; k < 3; ++k) {
            std::vector<double> more = q, less = q;
            more[k] += kStep, less[k] -= kStep;
            EXPECT_NEAR(row[k],
                        (constraint_errors(model, more)[0] - constraint_errors(model, less)[0]) / (2 * kStep),
                        1e-8);
        }
    }
    const double x = 0.7, y = 0.5 * x + 0.4;
    const auto error = [](const char* curve) {
        return constraint_errors(load_robot_text("robot.xml", bent(curve)), {0.9, -0.3, 0.4})[0];
    };
    EXPECT_NEAR(error(kCurves[0]), -0.3 - (.1 + x * (.5 + x * (.3 + x * (-.2 + x * .1)))), 1e-12);
    EXPECT_NEAR(error(kCurves[2]), 2 * -0.3 - (.05 + y * (.3 + y * .2)), 1e-12);
}

TEST(Bends, are_written_and_read_again)
{
    for (const char* curve : kCurves) {
        const RobotModel model = load_robot_text("robot.xml", bent(curve));
        EXPECT_EQ(differences(model, load_robot_text("robot.xml", write_mjcf(model, ".").text)),
                  std::vector<std::string>{});
    }
}

class BendsInWorlds : public RobotInContact {
  protected:
    double error()
    {
        std::vector<dReal> q(3);
        dRobotGetPositions(robot, q.data(), 3);
        return constraint_errors(read, {q.begin(), q.end()})[0];
    }
    void make(const char* curve)
    {
        read = load_robot_text("robot.xml", bent(curve));
        load(bent(curve));
        dWorldUseDefaults(world, dDefaultsRobot);
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
    }
    RobotModel read;
};

// The tangent of each step misses the curve by its bend times half the square of what the step moves, and the next one takes that back.
TEST_F(BendsInWorlds, follow_the_curve_wherever_they_go)
{
    for (const char* curve : kCurves) {
        make(curve);
        double worst = 0;
        for (int i = 0; i < 2000; ++i) {
            step(1, 0.001);
            if (i > 0) worst = std::max(worst, std::fabs(error()));
        }
        EXPECT_LT(worst, fine(1e-4, 1e-3)) << curve;
        EXPECT_GT(std::fabs(velocities()[0]) + std::fabs(velocities()[1]), 1e-3) << curve;  // it moves
    }
}

// Without dRobotAddForces a world holds the tangent where the positions were set.
TEST_F(BendsInWorlds, hold_the_tangent_where_they_were_set)
{
    make(kCurves[0]);
    const double x = 0.5, lift = .1 + x * (.5 + x * (.3 + x * (-.2 + x * .1)));
    const std::vector<dReal> q{dReal(0.2 + x), dReal(lift), 0};
    dRobotSetPositions(robot, q.data(), 3);
    dWorldSetGravity(world, 0, 0, 0);
    for (int i = 0; i < 100; ++i) dWorldStep(world, dReal(0.001));
    EXPECT_NEAR(error(), 0, fine(1e-9, 1e-5));
    EXPECT_NEAR(velocities()[0], 0, fine(1e-9, 1e-4));
}

TEST_F(BendsInWorlds, go_on_from_a_state)
{
    make(kCurves[0]);
    step(100, 0.001);
    std::vector<char> bytes(dWorldGetStateSize(world));
    dWorldGetState(world, bytes.data(), bytes.size());
    step(50, 0.001);
    const std::vector<double> after = velocities();
    ASSERT_EQ(dWorldSetState(world, bytes.data(), bytes.size()), 1);
    step(50, 0.001);
    EXPECT_EQ(velocities(), after);
}

}  // namespace
