// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Equalities of tendons with a path: errors and their derivatives against MuJoCo 4.0's numbers, Atwood's machine, a held load, momenta, states,
// files.
#include "robot_in_contact.h"

#include <cmath>

#include "robots/constraints.h"
#include "robots/load.h"
#include "robots/write/write.h"
#include "same_model.h"

namespace {

using namespace epode::robots;

constexpr double kG = 9.81;

const char* const kTied =
    "<mujoco><compiler angle='radian'/><worldbody><site name='top' pos='.1 .2 .9'/><site name='hook' "
    "pos='-.3 .1 .8'/>"
    "<body name='a' pos='0 0 .5'><joint name='j' axis='0 .6 .8'/><geom type='box' size='.1 .2 .05' mass='2' "
    "pos='.1 0 0'/>"
    "<site name='s' pos='.1 .05 0'/><body name='b' pos='.3 0 .1'><joint name='k' axis='1 0 0'/>"
    "<geom type='box' size='.05 .1 .2' mass='.5'/><site name='eye' pos='.1 0 "
    ".1'/></body></body></worldbody><tendon>"
    "<spatial name='t'><site site='top'/><site site='eye'/></spatial><spatial name='u'><site "
    "site='hook'/><site "
    "site='s'/></spatial><fixed name='f'><joint joint='j' coef='2'/><joint joint='k' "
    "coef='-.5'/></fixed></tendon>"
    "<equality><tendon name='tu' tendon1='t' tendon2='u' polycoef='.1 .7 .3'/><tendon tendon1='u' "
    "polycoef='.05'/>"
    "<tendon tendon1='f' tendon2='t' polycoef='.02 -1.5'/><tendon tendon1='t' "
    "tendon2='f'/></equality></mujoco>";

// mujoco 4.0.0: efc_pos and efc_J after mj_forward at qpos 0.3 -0.4.
TEST(Ties, have_errors_and_derivatives_as_mujocos)
{
    const RobotModel model = load_robot_text("robot.xml", kTied);
    ASSERT_FALSE(model.has_errors());
    const std::vector<double> q{0.3, -0.4};
    const double errors[] = {-0.08832341184506924, -0.054215946475881974, 0.7930961368248295,
                             -0.7912692421167804};
    const double rows[] = {
        0.10305989585896871, 0.010016627387482931, -0.023999381820410698, 0.0,
        2.12948155497531,    -0.4849750589187756,  -1.9136789633497933,   0.5100166273874829};
    const std::vector<double> c = constraint_errors(model, q), j = constraint_jacobian(model, q);
    ASSERT_EQ(c.size(), 4u);
    ASSERT_EQ(j.size(), 8u);
    for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(c[i], errors[i], 1e-9) << i;
    for (size_t i = 0; i < 8; ++i) EXPECT_NEAR(j[i], rows[i], 1e-9) << i;
}

TEST(Ties, are_written_and_read_again)
{
    const RobotModel model = load_robot_text("robot.xml", kTied);
    ASSERT_EQ(model.ties.size(), 4u);
    EXPECT_EQ(differences(model, load_robot_text("robot.xml", write_mjcf(model, ".").text)),
              std::vector<std::string>{});
    EXPECT_FALSE(write_urdf(model, ".").lost.empty());
}

class TiesInWorlds : public RobotInContact {
  protected:
    // Two weights on vertical slides under the hooks that their strings hang from, 1 m long.
    void hang(double left, double right, const std::string& equality)
    {
        const auto weight = [](const std::string& name, const std::string& x, double mass) {
            return "<site name='hook" + name + "' pos='" + x + " 0 2'/><body name='" + name + "' pos='" + x +
                   " 0 1'><joint name='" + name + "' type='slide' axis='0 0 1'/><geom size='.1' mass='" +
                   std::to_string(mass) + "'/><site name='at" + name + "'/></body>";
        };
        load(
            "<mujoco><worldbody>" + weight("l", "0", left) + weight("r", "1", right) +
            "</worldbody><tendon><spatial name='tl'><site site='hookl'/><site site='atl'/></spatial><spatial "
            "name='tr'><site site='hookr'/><site site='atr'/></spatial><fixed name='fr'><joint joint='r' "
            "coef='1'/></fixed></tendon><equality>" +
            equality + "</equality></mujoco>");
        dWorldSetGravity(world, 0, 0, dReal(-kG));
    }
    std::vector<double> positions()
    {
        std::vector<dReal> out(size_t(dRobotGetPositions(robot, nullptr, 0)));
        dRobotGetPositions(robot, out.data(), int(out.size()));
        return {out.begin(), out.end()};
    }
};

// Atwood's machine: one string grows by what the other loses.
TEST_F(TiesInWorlds, move_as_atwoods_machine_does)
{
    for (const char* equality : {"<tendon tendon1='tl' tendon2='tr' polycoef='0 -1'/>",
                                 "<tendon tendon1='tl' tendon2='fr' polycoef='0 1'/>"}) {
        hang(1, 2, equality);
        step(500, 0.001);
        const std::vector<double> v = velocities(), q = positions();
        EXPECT_NEAR(v[0], kG / 3 * 0.5, fine(0.02)) << equality;  // the first steps learn what holds
        EXPECT_NEAR(v[0] + v[1], 0, fine(1e-6, 1e-3)) << equality;
        EXPECT_NEAR(q[0] + q[1], 0, fine(1e-4, 1e-3)) << equality;
    }
}

// A string of fixed length holds a weight where it asks, without creep.
TEST_F(TiesInWorlds, hold_a_load_at_the_length_that_is_asked)
{
    hang(3, 1, "<tendon tendon1='tl' polycoef='0.05'/><tendon tendon1='tr' polycoef='0'/>");
    step(2000, 0.002);
    EXPECT_NEAR(positions()[0], -0.05, fine(1e-8, 1e-4));
    EXPECT_NEAR(positions()[1], 0, fine(1e-8, 1e-4));
    EXPECT_NEAR(velocities()[0], 0, fine(1e-8, 1e-4));
}

// L - 1 = 0.5 (K - 1) + 2 (K - 1)^2, on the curve and not on its tangent.
TEST_F(TiesInWorlds, follow_their_curves)
{
    hang(1, 1, "<tendon tendon1='tl' tendon2='tr' polycoef='0 .5 2'/><tendon tendon1='tr' polycoef='.2'/>");
    step(3000, 0.002);
    EXPECT_NEAR(positions()[1], -0.2, fine(1e-7, 1e-3));
    EXPECT_NEAR(positions()[0], -(0.5 * 0.2 + 2 * 0.04), fine(1e-7, 1e-3));
}

// A tie within a free robot is no force from outside.
TEST_F(TiesInWorlds, within_a_free_robot_leave_its_momentum)
{
    load(
        "<mujoco><option gravity='0 0 0'/><worldbody><body name='a'><freejoint/><geom size='.1' mass='1'/>"
        "<site name='p' pos='0 0 .1'/><body name='b' pos='.4 0 0'><joint name='j' axis='0 1 0'/><geom "
        "size='.1' mass='.5' "
        "pos='.1 0 0'/><site name='q' pos='.2 0 .1'/></body></body></worldbody><tendon><spatial "
        "name='t'><site site='p'/>"
        "<site site='q'/></spatial></tendon><equality><tendon tendon1='t' "
        "polycoef='-.1'/></equality></mujoco>");
    step(1000, 0.001);
    double p[3] = {};
    for (int link = 1; link < 3; ++link) {
        dMass mass;
        dBodyGetMass(dRobotGetBody(robot, link), &mass);
        for (int i = 0; i < 3; ++i)
            p[i] += double(mass.mass) * double(dBodyGetLinearVel(dRobotGetBody(robot, link))[i]);
    }
    for (double its : p) EXPECT_NEAR(its, 0, fine(1e-9, 1e-4));
    dReal length[1];
    const std::vector<double> q = positions();
    const std::vector<dReal> reals(q.begin(), q.end());
    dRobotModelGetTendons(model, reals.data(), length, nullptr, 1);
    EXPECT_NEAR(double(length[0]), 0.5, fine(1e-6, 1e-3));
}

// With its own numbers a robot goes on as if nothing had happened.
TEST_F(TiesInWorlds, go_on_from_a_state)
{
    hang(1, 2, "<tendon tendon1='tl' tendon2='tr' polycoef='0 -1'/>");
    step(100, 0.001);
    std::vector<char> bytes(dWorldGetStateSize(world));
    std::vector<dReal> numbers(size_t(dRobotGetState(robot, nullptr, 0)));
    dWorldGetState(world, bytes.data(), bytes.size());
    dRobotGetState(robot, numbers.data(), int(numbers.size()));
    step(50, 0.001);
    const std::vector<double> after = velocities();
    dWorldSetState(world, bytes.data(), bytes.size());
    EXPECT_EQ(dRobotSetState(robot, numbers.data(), int(numbers.size())), 1);
    step(50, 0.001);
    EXPECT_EQ(velocities(), after);
}

TEST(TieFiles, name_tendons_that_are_not_there)
{
    const RobotModel model = load_robot_text("robot.xml",
                                             "<mujoco><worldbody><body><joint name='j'/><geom "
                                             "size='.1'/></body></worldbody><tendon><fixed name='f'><joint "
                                             "joint='j' coef='1'/></fixed></tendon><equality>\n<tendon "
                                             "tendon1='f' tendon2='no'/></equality></mujoco>");
    EXPECT_TRUE(model.ties.empty());
    EXPECT_EQ(model.report.back().line, 2);
}

}  // namespace
