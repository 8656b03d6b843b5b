// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Forces of a program's contacts: what the contacts under a resting box give it is its weight, however the
// program orders geoms and bodies.
#include "record/preload/contact_forces.h"

#include <gtest/gtest.h>

namespace epode::record {
namespace {

class ContactForcesTest : public ::testing::Test {
  protected:
    void SetUp() override
    {
        dInitODE2(0);
        world_ = dWorldCreate();
        space_ = dSimpleSpaceCreate(nullptr);
        group_ = dJointGroupCreate(0);
        dWorldSetGravity(world_, 0, 0, -10);
        floor_ = dCreatePlane(space_, 0, 0, 1, 0);
        lower_ = box(0.5);
        upper_ = box(1.5);
    }
    void TearDown() override
    {
        dJointGroupDestroy(group_);
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
    }

    dGeomID box(dReal z)
    {
        dMass mass;
        dMassSetBoxTotal(&mass, 2, 1, 1, 1);
        dBodyID body = dBodyCreate(world_);
        dBodySetMass(body, &mass);
        dBodySetPosition(body, 0, 0, z);
        dGeomID geom = dCreateBox(space_, 1, 1, 1);
        dGeomSetBody(geom, body);
        return geom;
    }

    // Joints for where the two touch; the joint's bodies in the order of the geoms, or in the other one: the
    // normal, which points into the joint's first body, is then turned round.
    void touch(dGeomID a, dGeomID b, bool crossed)
    {
        dContact contact[8] = {};
        const int count = dCollide(a, b, 8, &contact[0].geom, sizeof(dContact));
        for (int i = 0; i < count; ++i) {
            contact[i].surface.mu = 1;
            if (crossed) dNegateVector3(contact[i].geom.normal);
            dJointID joint = dJointCreateContact(world_, group_, &contact[i]);
            dGeomID first = crossed ? b : a, second = crossed ? a : b;
            dJointAttach(joint, dGeomGetBody(first), dGeomGetBody(second));
            forces_.add(joint, group_, contact[i].geom);
            last_ = joint;
        }
    }

    // On what has the first geom of the contacts of these two.
    static double sum(const std::vector<ContactSeen>& seen, dGeomID a, dGeomID b)
    {
        double sum = 0;
        for (const ContactSeen& contact : seen) {
            if (contact.geom[0] == a && contact.geom[1] == b) sum += contact.force[2];
        }
        return sum;
    }

    dWorldID world_;
    dSpaceID space_;
    dJointGroupID group_;
    dGeomID floor_, lower_, upper_;
    dJointID last_ = nullptr;
    ContactForces forces_;
};

TEST_F(ContactForcesTest, are_the_weight_they_carry)
{
    for (int order = 0; order < 8; ++order) {
        const bool crossed = order & 1;
        dGeomID a = order & 2 ? floor_ : lower_, b = order & 2 ? lower_ : floor_;
        dGeomID c = order & 4 ? upper_ : lower_, d = order & 4 ? lower_ : upper_;
        touch(a, b, crossed);
        touch(c, d, crossed);
        forces_.ask();
        dWorldStep(world_, 0.01);
        const std::vector<ContactSeen> seen = forces_.take();
        dJointGroupEmpty(group_);
        EXPECT_NEAR(sum(seen, a, b), a == lower_ ? 40 : -40, 1e-3) << order;
        EXPECT_NEAR(sum(seen, c, d), c == upper_ ? 20 : -20, 1e-3) << order;
    }
}

TEST_F(ContactForcesTest, leave_the_programs_own_feedback_alone)
{
    dJointFeedback own{};
    touch(lower_, floor_, false);
    dJointSetFeedback(last_, &own);
    forces_.ask();
    EXPECT_EQ(dJointGetFeedback(last_), &own);
    dWorldStep(world_, 0.01);
    const std::vector<ContactSeen> seen = forces_.take();
    EXPECT_EQ(dJointGetFeedback(last_), &own);
    EXPECT_EQ(seen.back().force[2], double(own.f1[2]));
    EXPECT_GT(seen.back().force[2], 0);
}

TEST_F(ContactForcesTest, of_contacts_that_went_before_the_step_are_none)
{
    touch(lower_, floor_, false);
    forces_.forget(group_);
    dJointGroupEmpty(group_);
    forces_.ask();
    dWorldStep(world_, 0.01);
    for (const ContactSeen& contact : forces_.take()) EXPECT_EQ(contact.force[2], 0);
    touch(lower_, floor_, false);
    forces_.forget(last_);
    forces_.ask();
    dWorldStep(world_, 0.01);
    EXPECT_EQ(forces_.take().back().force[2], 0);
}

}  // namespace
}  // namespace epode::record
