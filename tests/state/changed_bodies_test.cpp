// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Geoms that touched in the last step and that the program has since put on one body, on none, or on a body of another world: the
// state, the file and the clone of such a world are accepted, as it is.
#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <cstdarg>
#include <vector>

namespace {

constexpr dReal kChangedStep = dReal(0.01);

int changed_bodies_refusals = 0;
void count_changed_bodies_refusal(int, const char*, va_list) { ++changed_bodies_refusals; }

// A box on a ball on a plane, which have met.
class ChangedBodies : public ::testing::Test {
  protected:
    ChangedBodies()
    {
        dInitODE2(0);
        changed_bodies_refusals = 0;
        dSetDebugHandler(count_changed_bodies_refusal);
        world_ = dWorldCreate(), other_ = dWorldCreate(), space_ = dHashSpaceCreate(nullptr);
        dWorldSetGravity(world_, 0, 0, -10);
        dWorldSetContactSpace(world_, space_);
        dCreatePlane(space_, 0, 0, 1, 0);
        for (dGeomID* geom : {&ball_, &box_}) {
            *geom = geom == &ball_ ? dCreateSphere(space_, dReal(0.5)) : dCreateBox(space_, 1, 1, 1);
            dGeomSetBody(*geom, dBodyCreate(world_));
            dBodySetPosition(dGeomGetBody(*geom), 0, 0, geom == &ball_ ? dReal(0.499) : dReal(1.498));
        }
        for (int i = 0; i < 3; ++i) dWorldStepFast1(world_, kChangedStep, 4);
    }
    ~ChangedBodies() override
    {
        dSpaceDestroy(space_), dWorldDestroy(world_), dWorldDestroy(other_);
        dSetDebugHandler(nullptr);
        dCloseODE();
    }

    void expect_state()
    {
        std::vector<unsigned char> state(dWorldGetStateSize(world_));
        ASSERT_GT(dWorldGetState(world_, state.data(), state.size()), 0);
        EXPECT_EQ(dWorldSetState(world_, state.data(), state.size()), 1);
        EXPECT_EQ(changed_bodies_refusals, 0);
    }
    // By a file and by a clone.
    void expect_copies()
    {
        std::vector<unsigned char> saved(dWorldSaveToBuffer(world_, nullptr, nullptr, 0));
        ASSERT_EQ(dWorldSaveToBuffer(world_, nullptr, saved.data(), saved.size()), saved.size());
        for (const bool clone : {false, true}) {
            dSpaceID space = nullptr;
            const dWorldID copy = clone ? dWorldClone(world_, &space, nullptr, 0)
                                        : dWorldLoadFromBuffer(saved.data(), saved.size(), &space);
            ASSERT_NE(copy, nullptr) << (clone ? "clone" : "file");
            EXPECT_EQ(dWorldStepFast1(copy, kChangedStep, 4), 1);
            dSpaceDestroy(space), dWorldDestroy(copy);
        }
        EXPECT_EQ(changed_bodies_refusals, 0);
    }

    dWorldID world_, other_;
    dSpaceID space_;
    dGeomID ball_, box_;
};

TEST_F(ChangedBodies, that_are_one_leave_a_state_and_copies)
{
    ASSERT_GT(dWorldGetContacts(world_, nullptr, 0), 1);
    dGeomSetBody(box_, dGeomGetBody(ball_));
    expect_state(), expect_copies();
    dGeomSetBody(box_, dBodyCreate(world_));
    expect_state(), expect_copies();
}

TEST_F(ChangedBodies, that_are_none_leave_a_state_and_copies)
{
    dGeomSetBody(ball_, nullptr);
    expect_state(), expect_copies();
    dGeomSetBody(box_, nullptr);
    expect_state(), expect_copies();
}

TEST_F(ChangedBodies, of_another_world_leave_a_state)
{
    dGeomSetBody(ball_, dBodyCreate(other_));
    expect_state();
    dGeomSetBody(ball_, dGeomGetBody(box_));
    expect_state(), expect_copies();
}

TEST_F(ChangedBodies, that_are_destroyed_leave_a_state_and_copies)
{
    dBodyDestroy(dGeomGetBody(ball_));
    expect_state(), expect_copies();
}

}  // namespace
