// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Forces of a medium (robots/fluid.h): motions of lone boxes that have closed forms, forces of a jointed robot that MuJoCo computes, and
// media so dense that a step would turn every motion round.
#include <epode/robots.h>
#include <gtest/gtest.h>
#include <ode/ext.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "robot_in_world.h"
#include "robots/fluid.h"
#include "robots/kinematics.h"
#include "robots/load.h"
#include "robots/write/write.h"
#include "same_model.h"

namespace {

using namespace epode::robots;

constexpr bool kSingle = sizeof(dReal) == 4;
constexpr double kPi = 3.14159265358979323846, kG = 9.81;

std::string in_medium(const std::string& medium, const std::string& bodies)
{
    return "<mujoco><compiler angle='radian'/><option " + medium + "/><worldbody>" + bodies +
           "</worldbody></mujoco>";
}

class Fluid : public RobotInWorld {
  protected:
    void steps(int count, double h)
    {
        for (int i = 0; i < count; ++i) {
            EXPECT_GT(dRobotAddFluidForces(robot, dReal(h)), 0);
            dWorldStep(world, dReal(h));
        }
    }
    double speed(int axis) const { return double(dBodyGetLinearVel(dRobotGetBody(robot, 1))[axis]); }
    double spin(int axis) const { return double(dBodyGetAngularVel(dRobotGetBody(robot, 1))[axis]); }
};

// m v' = m g - 2 rho a b v^2: v = u tanh(g t / u), u^2 = m g / (2 rho a b). The step is of first order.
TEST_F(Fluid, of_a_density_brings_a_falling_box_to_its_speed)
{
    load(in_medium("density='1.2'",
                   "<body><freejoint/><geom type='box' size='0.3 0.2 0.1' mass='2'/></body>"));
    dWorldSetGravity(world, 0, 0, -dReal(kG));
    const double u = std::sqrt(2 * kG / (2 * 1.2 * 0.3 * 0.2)), h = 1e-3;
    for (int second = 1; second <= 5; ++second) {
        steps(1000, h);
        EXPECT_NEAR(-speed(2), u * std::tanh(kG * second / u), 2e-3 * u) << second;
    }
    steps(20000, h);
    EXPECT_NEAR(-speed(2), u, kSingle ? 1e-3 : 1e-9);
}

// A ball's box has half sides of sqrt(0.6) R: v = v0 exp(-6 pi beta r t / m), w = w0 exp(-8 pi beta r^3 t / I).
TEST_F(Fluid, of_a_viscosity_stops_a_ball_exponentially)
{
    const double radius = 0.1, mass = 0.5, beta = 0.2, r = std::sqrt(0.6) * radius, h = 1e-4;
    load(in_medium("viscosity='0.2'", "<body><freejoint/><geom size='0.1' mass='0.5'/></body>"));
    const dReal start[] = {1, 2, -1, 3, -1, 2};
    dRobotSetVelocities(robot, start, 6);
    steps(5000, h);
    const double v = std::exp(-6 * kPi * beta * r * 0.5 / mass),
                 w = std::exp(-8 * kPi * beta * r * r * r * 0.5 / (0.4 * mass * radius * radius));
    const double near = 2e-4;
    const double speeds[] = {v, 2 * v, -v}, spins[] = {3 * w, -w, 2 * w};
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(speed(i), speeds[i], near) << i;
        EXPECT_NEAR(spin(i), spins[i], near) << i;
    }
}

// I w' = -k w^2, k = rho r_z (r_x^4 + r_y^4) / 2: w = w0 / (1 + k w0 t / I).
TEST_F(Fluid, of_a_density_brakes_a_spinning_box)
{
    load(in_medium("density='1000'",
                   "<body><freejoint/><geom type='box' size='0.3 0.2 0.1' mass='12'/></body>"));
    const double k = 1000 * 0.1 * (std::pow(0.3, 4) + std::pow(0.2, 4)) / 2,
                 inertia = 12.0 / 3 * (0.09 + 0.04);
    const dReal start[] = {0, 0, 0, 0, 0, 4};
    dRobotSetVelocities(robot, start, 6);
    steps(20000, 1e-4);
    EXPECT_NEAR(spin(2), 4 / (1 + k * 4 * 2 / inertia), 2e-3);
}

// One step of half a second in pitch: it stops, and no more.
TEST_F(Fluid, of_one_large_step_stops_a_ball)
{
    load(in_medium("viscosity='1e6'", "<body><freejoint/><geom size='0.1' mass='0.5'/></body>"));
    const dReal start[] = {1, 2, -1, 3, -1, 2};
    dRobotSetVelocities(robot, start, 6);
    steps(1, 0.5);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(speed(i), 0, kSingle ? 1e-6 : 1e-14);
        EXPECT_NEAR(spin(i), 0, kSingle ? 1e-6 : 1e-14);
    }
}

// Wherever the robot's world is turned, the wind turns with it.
TEST_F(Fluid, that_moves_takes_bodies_with_it)
{
    const std::string text = in_medium("density='1000' viscosity='100' wind='1 0 0'",
                                       "<body><freejoint/><geom size='0.1'/></body>");
    model = dRobotModelLoadText("robot.xml", text.data(), text.size(), nullptr);
    const dQuaternion quarter = {dReal(std::sqrt(0.5)), 0, 0, dReal(std::sqrt(0.5))};
    robot = dRobotCreate(world, nullptr, model, nullptr, quarter);
    ASSERT_NE(robot, nullptr);
    steps(20000, 0.01);
    EXPECT_NEAR(speed(1), 1, 1e-4);
    EXPECT_NEAR(speed(0), 0, 1e-6);
}

TEST_F(Fluid, is_none_where_the_file_has_none)
{
    load(in_medium("wind='1 0 0'", "<body><freejoint/><geom size='0.1'/></body>"));
    EXPECT_EQ(dRobotAddFluidForces(robot, dReal(0.01)), 0);
    dWorldStep(world, dReal(0.01));
    EXPECT_EQ(speed(0), 0);
    EXPECT_EQ(dRobotAddFluidForces(robot, -1), 0);
}

// A chain of every kind of joint, with a link that is fixed to another one, of shapes turned anyhow.
const std::string kChain =
    "<body name='a' pos='0 0 1'><freejoint/><geom type='box' size='0.1 0.2 0.05' euler='0.3 0.2 0.1'/>"
    "<body name='b' pos='0.2 0 0'><joint type='ball'/><geom type='capsule' size='0.04' fromto='0 0 0 0.3 0.1 "
    "0.2'/>"
    "<body name='c' pos='0.3 0.1 0.2'><joint axis='0 1 1'/><inertial pos='0.1 0 0' mass='0.7' quat='0.8 0.1 "
    "0.5 0.2' diaginertia='0.01 0.02 0.025'/>"
    "<body name='f' pos='0 0.1 0' quat='0.9 0.1 0.3 0.2'><geom type='ellipsoid' size='0.05 0.1 0.15'/></body>"
    "<body name='d' pos='0.1 0 0'><joint type='slide' axis='1 0 1'/><joint axis='1 0 0'/><geom size='0.06'/>"
    "<geom type='cylinder' size='0.03 0.2' pos='0.1 0 0'/></body></body></body></body>";
const std::string kWater = "density='1000' viscosity='0.3' wind='0.5 -0.2 0.1'";

struct Moment {
    std::vector<double> positions, velocities;
};

Moment random_moment(const RobotModel& model, std::mt19937& random)
{
    std::normal_distribution<double> normal;
    Moment out{reference_positions(model), {}};
    for (const Joint& joint : model.joints) {
        double* q = &out.positions[size_t(joint.position)];
        const int skipped = joint.kind == JointKind::kFree ? 3 : 0;
        double norm = 0;
        for (int i = 0; i < joint.coordinates(); ++i) q[i] = normal(random);
        if (joint.is_scalar()) continue;
        for (int i = skipped; i < skipped + 4; ++i) norm += q[i] * q[i];
        for (int i = skipped; i < skipped + 4; ++i) q[i] /= std::sqrt(norm);
    }
    for (int i = 0; i < number_of_velocities(model); ++i) out.velocities.push_back(normal(random));
    return out;
}

// What MuJoCo 4.0 has: qfrc_passive of this file.
TEST(FluidModel, exerts_what_mu_jo_co_computes)
{
    const RobotModel model = load_robot_text("r.xml", in_medium(kWater, kChain));
    const double root = std::sqrt(0.8 * 0.8 + 0.4 * 0.4 + 0.4 * 0.4 + 0.2 * 0.2);
    const std::vector<double> q{0.1, -0.2, 0.3,  0.8 / root, 0.4 / root, -0.4 / root, 0.2 / root,
                                0.5, 0.5,  -0.1, 0.7,        0.6,        -0.1,        0.9},
        v{0.5, -1, 0.8, 2, -1, 0.3, 1.5, -0.7, 0.2, -2, 0.4, 1.1},
        theirs{-55.2284668508,  272.250384321,  -27.41423949767, -81.52631656169,
               8.696498666149,  31.43268659732, -17.31315235517, 75.35377678887,
               -34.95132535028, 8.259395426336, -62.54045748826, -0.008987275930871};
    const std::vector<double> mine = fluid_forces(model, q, v);
    ASSERT_EQ(mine.size(), theirs.size());
    for (size_t k = 0; k < mine.size(); ++k) EXPECT_NEAR(mine[k], theirs[k], 1e-9 * 272) << k;
}

// The link that is fixed to another keeps the box that the file gave it.
TEST(FluidModel, merged_links_resist_as_they_do_apart)
{
    LoadOptions apart;
    apart.keep_fixed = true;
    const std::string text = in_medium(kWater, kChain);
    const RobotModel one = load_robot_text("r.xml", text), other = load_robot_text("r.xml", text, apart);
    ASSERT_FALSE(one.has_errors() || other.has_errors());
    ASSERT_EQ(one.links.size() + 1, other.links.size());
    std::mt19937 random(1);
    for (int i = 0; i < 20; ++i) {
        const auto [q, v] = random_moment(one, random);
        const std::vector<double> a = fluid_forces(one, q, v), b = fluid_forces(other, q, v);
        for (size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-9 * (1 + std::fabs(b[k]))) << k;
    }
}

TEST(FluidModel, is_written_and_read_again)
{
    LoadOptions apart;
    apart.keep_fixed = true;
    const RobotModel model = load_robot_text("r.xml", in_medium(kWater, kChain), apart);
    const RobotModel again = load_robot_text("r.xml", write_mjcf(model, ".").text, apart);
    EXPECT_TRUE(differences(model, again).empty()) << differences(model, again)[0];
    std::mt19937 random(2);
    const auto [q, v] = random_moment(model, random);
    const std::vector<double> a = fluid_forces(model, q, v), b = fluid_forces(again, q, v);
    for (size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-9 * (1 + std::fabs(b[k]))) << k;
}

// Where bodies bear them, they have the power that the model's forces have along its velocities.
TEST_F(Fluid, has_the_same_power_in_a_world_and_in_the_model)
{
    load(in_medium(kWater, kChain));
    const RobotModel plain = load_robot_text("r.xml", in_medium(kWater, kChain));
    std::mt19937 random(3);
    for (int i = 0; i < 20; ++i) {
        const auto [q, v] = random_moment(plain, random);
        const std::vector<dReal> at(q.begin(), q.end()), moving(v.begin(), v.end());
        ASSERT_EQ(dRobotSetPositions(robot, at.data(), int(at.size())), 1);
        ASSERT_EQ(dRobotSetVelocities(robot, moving.data(), int(moving.size())), 1);
        std::vector<dReal> forces(v.size());
        ASSERT_EQ(dRobotModelGetFluidForces(model, at.data(), moving.data(), forces.data(), int(v.size())),
                  int(v.size()));
        ASSERT_EQ(dRobotAddFluidForces(robot, 0), 5);
        double mine = 0, theirs = 0, size = 0;
        for (size_t k = 0; k < v.size(); ++k) mine += double(forces[k]) * v[k];
        for (int link = 1; link < dRobotModelGetLinks(model, nullptr, 0); ++link) {
            const dBodyID body = dRobotGetBody(robot, link);
            for (int k = 0; k < 3; ++k) {
                const double force = double(dBodyGetForce(body)[k] * dBodyGetLinearVel(body)[k]),
                             torque = double(dBodyGetTorque(body)[k] * dBodyGetAngularVel(body)[k]);
                theirs += force + torque, size += std::fabs(force) + std::fabs(torque);
            }
            dBodySetForce(body, 0, 0, 0), dBodySetTorque(body, 0, 0, 0);
        }
        EXPECT_NEAR(mine, theirs, (kSingle ? 1e-4 : 1e-9) * size);
    }
}

// With the wind off, no step of any size adds to the motion, however dense the medium: the largest velocity falls to nothing.
TEST_F(Fluid, however_dense_only_stops)
{
    load(in_medium("density='1e7' viscosity='1e4'", kChain));
    const RobotModel plain = load_robot_text("r.xml", in_medium(kWater, kChain));
    std::mt19937 random(4);
    for (const double h : {0.001, 0.01, 0.1}) {
        const auto [q, v] = random_moment(plain, random);
        const std::vector<dReal> at(q.begin(), q.end()), moving(v.begin(), v.end());
        dRobotSetPositions(robot, at.data(), int(at.size()));
        dRobotSetVelocities(robot, moving.data(), int(moving.size()));
        steps(200, h);
        std::vector<dReal> left(v.size());
        dRobotGetVelocities(robot, left.data(), int(left.size()));
        for (const dReal its : left) EXPECT_LT(std::fabs(double(its)), 1e-3) << h;
    }
}

}  // namespace
