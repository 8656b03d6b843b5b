// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A world in which everybody sleeps does nothing in a step; what a program does to it meanwhile must be seen
// in the next one all the same, and what it reads must go on.
#include <gtest/gtest.h>

#include <vector>

#include "ode/ext.h"
#include "ode/ode.h"

namespace {

class SettledContacts : public testing::Test {
  protected:
    static constexpr int kBoxes = 12;

    void SetUp() override
    {
        world_ = dWorldCreate();
        space_ = dHashSpaceCreate(nullptr);
        dWorldSetGravity(world_, 0, 0, dReal(-9.81));
        dWorldSetContactSpace(world_, space_);
        ground_ = dCreateBox(space_, 100, 100, 1);
        dGeomSetPosition(ground_, 0, 0, dReal(-0.5));
        for (int i = 0; i < kBoxes; ++i) {
            const dBodyID body = dBodyCreate(world_);
            dMass mass;
            dMassSetBox(&mass, 1, 1, 1, 1);
            dBodySetMass(body, &mass);
            dBodySetPosition(body, 3 * i, 0, dReal(0.5));
            const dGeomID geom = dCreateBox(space_, 1, 1, 1);
            dGeomSetBody(geom, body);
            bodies_.push_back(body), geoms_.push_back(geom);
        }
        step(20);
        for (const dBodyID body : bodies_) dBodyDisable(body);
        step(5);
    }
    void TearDown() override
    {
        dWorldDestroy(world_);
        dSpaceDestroy(space_);
    }

    void step(int times)
    {
        for (int i = 0; i < times; ++i) dWorldQuickStep(world_, dReal(1) / 60);
    }
    int count(dContactEventKind kind) const
    {
        std::vector<dContactEvent> events(1000);
        const int all = dWorldGetContactEvents(world_, events.data(), int(events.size()));
        int found = 0;
        for (int i = 0; i < all; ++i) found += events[std::size_t(i)].kind == kind;
        return found;
    }
    int awake() const
    {
        int number = 0;
        for (const dBodyID body : bodies_) number += dBodyIsEnabled(body);
        return number;
    }
    // All of the pairs of one box, or of all, have ended in one step, and no other has changed.
    void expect_ended(int pairs)
    {
        step(1);
        EXPECT_EQ(count(dContactEnd), pairs);
        EXPECT_EQ(count(dContactPersist), kBoxes - pairs);
        step(1);
        EXPECT_EQ(count(dContactEnd), 0);
        EXPECT_EQ(count(dContactPersist), kBoxes - pairs);
    }

    dWorldID world_;
    dSpaceID space_;
    dGeomID ground_;
    std::vector<dBodyID> bodies_;
    std::vector<dGeomID> geoms_;
};

TEST_F(SettledContacts, are_kept_and_reported_with_their_forces)
{
    std::vector<dWorldContact> before(100), after(100);
    const int points = dWorldGetContacts(world_, before.data(), 100);
    ASSERT_GE(points, 3 * kBoxes);
    for (int i = 0; i < 50; ++i) {
        step(1);
        ASSERT_EQ(count(dContactPersist), kBoxes);
        ASSERT_EQ(count(dContactBegin) + count(dContactEnd), 0);
    }
    ASSERT_EQ(dWorldGetContacts(world_, after.data(), 100), points);
    double force = 0;
    for (int i = 0; i < points; ++i) {
        EXPECT_EQ(before[std::size_t(i)].normal_force, after[std::size_t(i)].normal_force);
        force += double(after[std::size_t(i)].normal_force);
    }
    EXPECT_NEAR(force, kBoxes * 9.81, 0.05 * kBoxes * 9.81);
    EXPECT_EQ(awake(), 0);
}

TEST_F(SettledContacts, end_when_the_ground_is_taken_away)
{
    dGeomSetPosition(ground_, 0, 0, -50);
    expect_ended(kBoxes);
}

TEST_F(SettledContacts, end_when_the_ground_is_destroyed)
{
    dGeomDestroy(ground_);
    expect_ended(kBoxes);
}

TEST_F(SettledContacts, end_when_a_geom_is_disabled_and_the_box_falls_once_awake)
{
    dGeomDisable(geoms_[4]);
    expect_ended(1);
    dBodyEnable(bodies_[4]);
    step(20);
    EXPECT_LT(dBodyGetPosition(bodies_[4])[2], 0);
    EXPECT_EQ(awake(), 1);
}

TEST_F(SettledContacts, end_by_collide_bits)
{
    dGeomSetCategoryBits(geoms_[2], 2);
    dGeomSetCollideBits(geoms_[2], 0);
    dGeomSetCollideBits(ground_, 1);
    expect_ended(1);
}

TEST_F(SettledContacts, end_when_the_box_is_moved_or_made_kinematic)
{
    dBodySetPosition(bodies_[1], 3, 0, 9);
    dBodySetKinematic(bodies_[3]);
    expect_ended(2);
    EXPECT_EQ(awake(), 0);
}

TEST_F(SettledContacts, end_when_the_box_shrinks)
{
    dGeomBoxSetLengths(geoms_[6], dReal(0.2), dReal(0.2), dReal(0.2));
    expect_ended(1);
}

TEST_F(SettledContacts, end_when_a_geom_leaves_the_space_and_come_back_with_it)
{
    dSpaceRemove(space_, geoms_[8]);
    expect_ended(1);
    dSpaceAdd(space_, geoms_[8]);
    dBodyEnable(bodies_[8]);
    step(2);
    EXPECT_EQ(count(dContactPersist), kBoxes);
    EXPECT_NEAR(dBodyGetPosition(bodies_[8])[2], 0.5, 0.01);
}

TEST_F(SettledContacts, wake_what_a_shot_hits_and_nothing_else)
{
    const dBodyID shot = dBodyCreate(world_);
    dBodySetPosition(shot, 15, -3, dReal(0.5));
    dBodySetLinearVel(shot, 0, 10, 0);
    const dGeomID ball = dCreateSphere(space_, dReal(0.3));
    dGeomSetBody(ball, shot);
    step(30);
    EXPECT_EQ(awake(), 1);
    EXPECT_EQ(dBodyIsEnabled(bodies_[5]), 1);
    EXPECT_GT(dBodyGetPosition(bodies_[5])[1], 0.1);
    EXPECT_NEAR(dBodyGetPosition(bodies_[4])[1], dBodyGetPosition(bodies_[6])[1], 1e-6);
}

TEST_F(SettledContacts, wake_through_a_joint)
{
    const dBodyID puller = dBodyCreate(world_);
    dBodySetPosition(puller, 27, 0, 2);
    dBodySetLinearVel(puller, 0, 0, 5);
    const dJointID joint = dJointCreateFixed(world_, nullptr);
    dJointAttach(joint, puller, bodies_[9]);
    dJointSetFixed(joint);
    step(2);
    EXPECT_EQ(dBodyIsEnabled(bodies_[9]), 1);
    EXPECT_EQ(awake(), 1);
    EXPECT_GT(dBodyGetPosition(bodies_[9])[2], 0.51);
}

}  // namespace
