// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints that break: at the load that statics gives, at the end of the step that brought it, in every way to
// step; what broke is reported, and may be repaired.
#include "drive_ways.h"

namespace epode::physics {
namespace {

struct Breakable : testing::TestWithParam<Way> {
    Sim sim;
    dBodyID arm = sim.body({1, 0, 0}, 2);
    dJointID joint = dJointCreateFixed(sim.world, nullptr);

    // 2 kg on an arm of 1 m: 20 N, and 20 N m where it is held.
    Breakable()
    {
        sim.gravity(0, 0, -10);
        dJointAttach(joint, arm, nullptr);
        dJointSetFixed(joint);
    }
    // The same through a hinge that may not turn, since its stops are equal.
    dJointID hold_by_hinge()
    {
        dJointDestroy(joint);
        joint = dJointCreateHinge(sim.world, nullptr);
        dJointAttach(joint, arm, nullptr);
        dJointSetHingeAnchor(joint, 0, 0, 0);
        dJointSetHingeAxis(joint, 0, 1, 0);
        dJointSetHingeParam(joint, dParamLoStop, 0);
        dJointSetHingeParam(joint, dParamHiStop, 0);
        return joint;
    }
};

TEST_P(Breakable, lets_go_above_its_force)
{
    ASSERT_EQ(dJointSetBreakLimits(joint, real(20.5), 0), 1);
    step(sim, GetParam(), 0.01, 50);
    EXPECT_EQ(dJointIsBroken(joint), 0);
    EXPECT_NEAR(position(arm).z, 0, 1e-3);
    dBodyAddForce(arm, 0, 0, -2);
    step(sim, GetParam(), 0.01);
    EXPECT_EQ(dJointIsBroken(joint), 1);
    EXPECT_EQ(dJointIsEnabled(joint), 0);
    EXPECT_NEAR(velocity(arm).z, 0, 1e-3) << "it has acted in the step in which it broke";
    dJointID broken[2] = {nullptr, nullptr};
    EXPECT_EQ(dWorldGetBrokenJoints(sim.world, broken, 2), 1);
    EXPECT_EQ(broken[0], joint);
    step(sim, GetParam(), 0.01);
    EXPECT_NEAR(velocity(arm).z, -0.1, 1e-3);
    EXPECT_EQ(dWorldGetBrokenJoints(sim.world, nullptr, 0), 0) << "told once";
    dJointEnable(joint);
    EXPECT_EQ(dJointIsBroken(joint), 0);
}

TEST_P(Breakable, lets_go_above_its_torque_about_the_anchor)
{
    hold_by_hinge();
    ASSERT_EQ(dJointSetBreakLimits(joint, 0, real(20.5)), 1);
    step(sim, GetParam(), 0.01, 100);
    EXPECT_EQ(dJointIsBroken(joint), 0);
    dBodyAddForce(arm, 0, 0, -2);
    step(sim, GetParam(), 0.01);
    EXPECT_EQ(dJointIsBroken(joint), 1);
}

TEST_P(Breakable, a_chain_breaks_at_the_link_with_the_largest_load)
{
    Sim chain;
    chain.gravity(0, 0, -10);
    std::vector<dJointID> links;
    dBodyID before = nullptr;
    for (int i = 0; i < 5; ++i) {
        dBodyID link = chain.body({0, 0, -double(i)}, 1, 0.1);
        dJointID j = dJointCreateBall(chain.world, nullptr);
        dJointAttach(j, link, before);
        dJointSetBallAnchor(j, 0, 0, real(0.5 - i));
        links.push_back(j), before = link;
    }
    dWorldSetQuickStepNumIterations(chain.world, 100);
    step(chain, GetParam(), 0.01, 100);  // until what is new has settled
    for (dJointID j : links) dJointSetBreakLimits(j, real(45), 0);
    step(chain, GetParam(), 0.01);
    EXPECT_EQ(dJointIsBroken(links[0]), 1) << "50 N";
    for (std::size_t i = 1; i < 5; ++i) EXPECT_EQ(dJointIsBroken(links[i]), 0) << 50 - 10 * i << " N";
}

INSTANTIATE_TEST_SUITE_P(Ways, Breakable, testing::ValuesIn(kWays), way_name);

TEST(BreakLimits, are_read_back_and_refused)
{
    Sim sim;
    Messages messages;
    dJointID joint = dJointCreateBall(sim.world, nullptr);
    dReal force = 0, torque = 0;
    EXPECT_EQ(dJointGetBreakLimits(joint, &force, &torque), 0);
    EXPECT_EQ(force, dInfinity);
    EXPECT_EQ(dJointSetBreakLimits(joint, 3, 4), 1);
    EXPECT_EQ(dJointGetBreakLimits(joint, &force, &torque), 1);
    EXPECT_EQ(force, 3);
    EXPECT_EQ(torque, 4);
    EXPECT_EQ(messages.count(), 0);
    EXPECT_EQ(dJointSetBreakLimits(joint, -1, 4), 0);
    const dContact contact = make_contact({0, 0, 0}, {0, 0, 1}, 0);
    EXPECT_EQ(dJointSetBreakLimits(dJointCreateContact(sim.world, sim.contacts, &contact), 1, 1), 0);
    EXPECT_EQ(dWorldGetBrokenJoints(sim.world, nullptr, 3), 0);
    EXPECT_EQ(messages.count(), 3);
}

}  // namespace
}  // namespace epode::physics
