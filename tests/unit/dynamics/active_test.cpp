// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a step looks at, counted: bodies and joints that sleep are none of it, whoever put them to sleep, and
// come back in one step with all that joints connect with what has woken, but with nothing else.
#include "dynamics/active.h"

#include <gtest/gtest.h>

#include <vector>

#include "ode/ext.h"
#include "ode/ode.h"

namespace epode {
namespace {

class Chains : public testing::Test {
  protected:
    static constexpr int kChains = 40, kLinks = 5;

    void SetUp() override
    {
        id_ = dWorldCreate();
        dWorldSetAutoDisableFlag(id_, 1);
        for (int chain = 0; chain < kChains; ++chain) {
            dBodyID before = nullptr;
            for (int i = 0; i < kLinks; ++i) {
                const dBodyID body = dBodyCreate(id_);
                dBodySetPosition(body, 3 * chain, 0, -i);
                const dJointID joint = dJointCreateBall(id_, nullptr);
                dJointAttach(joint, before, body);
                dJointSetBallAnchor(joint, 3 * chain, 0, dReal(0.5) - i);
                links_.push_back(before = body);
            }
        }
    }
    void TearDown() override { dWorldDestroy(id_); }

    void step(int times)
    {
        for (int i = 0; i < times; ++i) dWorldQuickStep(id_, dReal(1) / 60);
    }
    int active_bodies() const { return world().bodies.active_count(); }
    int active_joints() const { return world().joints.active_count(); }
    dBodyID link(int chain, int i) const { return links_[std::size_t(chain * kLinks + i)]; }
    World& world() const { return *from_handle<World>(id_); }

    dWorldID id_;
    std::vector<dBodyID> links_;
};

TEST_F(Chains, that_sleep_are_none_of_a_step)
{
    EXPECT_EQ(active_bodies(), kChains * kLinks);
    EXPECT_EQ(active_joints(), kChains * kLinks);
    step(30);
    EXPECT_EQ(dBodyIsEnabled(link(0, 0)), 0);
    EXPECT_EQ(active_bodies(), 0);
    EXPECT_EQ(active_joints(), 0);
}

TEST_F(Chains, come_back_one_by_one)
{
    step(30);
    dBodyEnable(link(7, 2));
    dBodySetLinearVel(link(7, 2), 1, 0, 0);
    EXPECT_EQ(active_bodies(), 1);
    EXPECT_EQ(active_joints(), 2);
    step(1);
    EXPECT_EQ(active_bodies(), kLinks);
    EXPECT_EQ(active_joints(), kLinks);
    for (int i = 0; i < kLinks; ++i) EXPECT_EQ(dBodyIsEnabled(link(7, i)), 1);
    EXPECT_EQ(dBodyIsEnabled(link(6, 2)), 0);
}

TEST_F(Chains, that_the_program_puts_to_sleep_leave_at_once)
{
    dWorldSetAutoDisableFlag(id_, 0);
    for (const dBodyID body : links_) dBodySetAutoDisableFlag(body, 0);
    for (int chain = 0; chain < kChains; chain += 2)
        for (int i = 0; i < kLinks; ++i) dBodyDisable(link(chain, i));
    step(1);
    EXPECT_EQ(active_bodies(), kChains / 2 * kLinks);
    step(1);
    EXPECT_EQ(active_joints(), kChains / 2 * kLinks);
}

// Half of a chain that is put to sleep is woken by the other half in the same step.
TEST_F(Chains, stay_where_an_awake_body_reaches_them)
{
    dWorldSetGravity(id_, 0, 0, dReal(-9.81));
    dBodySetLinearVel(link(3, 4), 2, 0, 0);
    for (int i = 0; i < 4; ++i) dBodyDisable(link(3, i));
    step(1);
    for (int i = 0; i < kLinks; ++i) EXPECT_EQ(dBodyIsEnabled(link(3, i)), 1);
    EXPECT_GE(active_bodies(), kLinks);
}

TEST_F(Chains, are_reached_through_joints_that_come_and_go)
{
    step(30);
    const dBodyID newcomer = dBodyCreate(id_);
    dBodySetAutoDisableFlag(newcomer, 0);
    const dJointID joint = dJointCreateBall(id_, nullptr);
    dJointAttach(joint, newcomer, link(9, 0));
    dJointDisable(joint);
    step(2);
    EXPECT_EQ(active_bodies(), 1);
    dJointEnable(joint);
    step(1);
    EXPECT_EQ(active_bodies(), 1 + kLinks);
    dJointDestroy(joint);
    EXPECT_EQ(active_joints(), kLinks);
    step(30);
    EXPECT_EQ(active_bodies(), 1);
    EXPECT_EQ(active_joints(), 0);
    dBodyDestroy(newcomer);
    EXPECT_EQ(active_bodies(), 0);
}

// Also with world-managed contacts: once all sleep, nobody is looked at, whatever lies there.
TEST(ActiveBodies, are_none_when_all_sleep_on_contacts_of_the_world)
{
    const dWorldID id = dWorldCreate();
    const dSpaceID space = dHashSpaceCreate(nullptr);
    dWorldSetGravity(id, 0, 0, dReal(-9.81));
    dWorldSetContactSpace(id, space);
    dCreatePlane(space, 0, 0, 1, 0);
    std::vector<dBodyID> boxes;
    for (int i = 0; i < 30; ++i) {
        boxes.push_back(dBodyCreate(id));
        dBodySetPosition(boxes.back(), 2 * (i % 6), 2 * (i / 6), dReal(0.5));
        dGeomSetBody(dCreateBox(space, 1, 1, 1), boxes.back());
    }
    const World& world = *from_handle<World>(id);
    const auto step = [&](int times) {
        for (int i = 0; i < times; ++i) dWorldQuickStep(id, dReal(1) / 60);
    };
    step(10);
    EXPECT_EQ(world.bodies.active_count(), 30);
    for (const dBodyID box : boxes) dBodyDisable(box);
    step(1);
    EXPECT_EQ(world.bodies.active_count(), 0);
    step(3);
    dBodyEnable(boxes[7]);
    EXPECT_EQ(world.bodies.active_count(), 1);
    step(1);
    EXPECT_EQ(dBodyIsEnabled(boxes[7]), 1);
    EXPECT_EQ(dBodyIsEnabled(boxes[8]), 0);
    dWorldDestroy(id);
    dSpaceDestroy(space);
}

}  // namespace
}  // namespace epode
