// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Kinematics and dynamics of a model against closed forms, differences, and a world that moves.
#include <epode/robots.h>
#include <gtest/gtest.h>
#include <ode/ext.h>

#include <cmath>

#include "robots/kinematics.h"
#include "robots/load.h"

namespace {

using namespace epode::robots;

const std::string kModels = EPODE_MODELS;

// A two-link arm that turns about y: M11 = I1 + I2 + m1 c1^2 + m2 (l^2 + c2^2 + 2 l c2 cos q2) and so on.
TEST(RobotKinematics, mass_matrix_of_a_two_link_arm_is_the_textbooks)
{
    const RobotModel model = load_robot_text("arm.xml", R"(<mujoco><worldbody><body>
        <joint axis="0 1 0"/><inertial pos="0.3 0 0" mass="3" diaginertia="0.1 0.1 0.1"/>
        <body pos="0.6 0 0"><joint axis="0 1 0" armature="0.5"/><inertial pos="0.2 0 0" mass="1" diaginertia="0.02 0.02 0.02"/>
        </body></body></worldbody></mujoco>)");
    ASSERT_FALSE(model.has_errors());
    const double q2 = 0.7, l = 0.6, c2 = 0.2;
    const std::vector<double> m = mass_matrix(model, {0.4, q2});
    const double inner = 0.02 + c2 * c2, mixed = inner + l * c2 * std::cos(q2);
    EXPECT_NEAR(m[0], 0.1 + 3 * 0.09 + inner + l * l + 2 * l * c2 * std::cos(q2), 1e-12);
    EXPECT_NEAR(m[1], mixed, 1e-12);
    EXPECT_NEAR(m[2], mixed, 1e-12);
    EXPECT_NEAR(m[3], inner + 0.5, 1e-12);
}

// A column is what a unit acceleration takes, at rest and without gravity: two ways to the same numbers.
TEST(RobotKinematics, columns_of_the_mass_matrix_are_forces_of_unit_accelerations)
{
    for (const char* file : {"/walker.xml", "/arm.urdf"}) {
        const RobotModel model = load_robot(kModels + file);
        std::vector<double> q = reference_positions(model);
        for (const Joint& joint : model.joints)
            if (joint.is_scalar()) q[size_t(joint.position)] += 0.3 + 0.1 * joint.position;
        const size_t n = size_t(number_of_velocities(model));
        const std::vector<double> m = mass_matrix(model, q), rest(n, 0);
        ASSERT_EQ(m.size(), n * n);
        for (size_t j = 0; j < n; ++j) {
            std::vector<double> unit(n, 0);
            unit[j] = 1;
            const std::vector<double> column = inverse_dynamics(model, q, rest, unit, {});
            for (size_t i = 0; i < n; ++i)
                EXPECT_NEAR(m[i * n + j], column[i], 1e-13 * (1 + std::abs(m[i * n + i]) + m[j * n + j]))
                    << file;
        }
    }
}

TEST(RobotKinematics, jacobian_is_the_derivative_of_the_point)
{
    const RobotModel model = load_robot(kModels + "/walker.xml");
    std::vector<double> q = model.starts[0].positions;
    const int foot = model.link_named("foot");
    const Vec point{0.1, -0.2, 0.3};
    const size_t n = size_t(number_of_velocities(model));
    const std::vector<double> j = jacobian(model, q, foot, point);
    const double step = 1e-6;
    for (size_t column = 0; column < 4; ++column) {  // the first four coordinates are hinges and sliders
        std::vector<double> after = q, before = q;
        after[column] += step, before[column] -= step;
        const Vec moved = forward_kinematics(model, after)[size_t(foot)] * point -
                          forward_kinematics(model, before)[size_t(foot)] * point;
        for (int row = 0; row < 3; ++row)
            EXPECT_NEAR(j[size_t(row) * n + column], moved[row] / (2 * step), 1e-8);
    }
}

// What inverse dynamics computes holds an arm still that would fall without it.
TEST(RobotKinematics, gravity_compensation_holds_an_arm)
{
    dInitODE2(0);
    const dWorldID world = dWorldCreate();
    dWorldSetGravity(world, 0, 0, dReal(-9.81));
    const std::string text = R"(<mujoco><worldbody><body><joint name="a" axis="0 1 0"/>
        <inertial pos="0.3 0 0.1" mass="3" diaginertia="0.1 0.1 0.1"/>
        <body pos="0.6 0 0"><joint name="b" axis="0 1 0"/><inertial pos="0.2 0 0" mass="1" diaginertia="0.02 0.02 0.02"/></body>
        </body></worldbody><actuator><motor joint="a"/><motor joint="b"/></actuator></mujoco>)";
    const dRobotModelID model = dRobotModelLoadText("arm.xml", text.data(), text.size(), nullptr);
    const dRobotID robot = dRobotCreate(world, nullptr, model, nullptr, nullptr);
    const dReal start[2] = {dReal(0.4), dReal(-0.9)};
    dReal forces[2], q[2];
    ASSERT_EQ(dRobotSetPositions(robot, start, 2), 1);
    ASSERT_EQ(dRobotModelGetInverseDynamics(model, start, nullptr, nullptr, forces, 2), 2);
    for (int i = 0; i < 2; ++i) dRobotSetControl(robot, i, forces[i]);
    for (int i = 0; i < 500; ++i) dWorldStep(world, dReal(0.002));
    dRobotGetPositions(robot, q, 2);
    for (int i = 0; i < 2; ++i) EXPECT_NEAR(q[i], start[i], sizeof(dReal) == 8 ? 1e-6 : 1e-2);
    dRobotDestroy(robot);
    dRobotModelDestroy(model);
    dWorldDestroy(world);
    dCloseODE();
}

}  // namespace
