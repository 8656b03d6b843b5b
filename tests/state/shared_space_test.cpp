// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Worlds whose geoms are in one space: what one of them steps, saves or takes back leaves the others as they are.
#include "scene.h"

namespace epode::states {
namespace {

constexpr dReal kH = dReal(1) / 60;

class SharedSpace : public testing::Test {
  protected:
    SharedSpace()
    {
        for (dWorldID world : {own, other}) {
            dWorldSetGravity(world, 0, 0, dReal(-9.81));
            dWorldSetContactSpace(world, space);
        }
    }
    ~SharedSpace() override { dWorldDestroy(own), dWorldDestroy(other), dSpaceDestroy(space); }
    dBodyID ball(dWorldID world, dReal x, dReal z)
    {
        const dBodyID body = dBodyCreate(world);
        dGeomSetBody(dCreateSphere(space, dReal(0.5)), body);
        dBodySetPosition(body, x, 0, z);
        return body;
    }
    // Steps of the one world that are taken back leave nothing.
    void take_back_steps()
    {
        const Bytes before = state_of(own);
        ASSERT_EQ(dWorldSetHistory(own, 3), 1);
        for (int i = 0; i < 3; ++i) ASSERT_EQ(dWorldQuickStep(own, kH), 1);
        ASSERT_EQ(dWorldRollBack(own, 3), 1);
        EXPECT_TRUE(state_of(own) == before);
    }
    dWorldID own = dWorldCreate(), other = dWorldCreate();
    dSpaceID space = dHashSpaceCreate(nullptr);
};

// It was in the state of the world in whose space it is, and not in that after a roll-back (seed 100 of
// tests/sequences, sequence 511).
TEST_F(SharedSpace, bodies_that_the_program_puts_to_sleep_are_in_the_state_of_their_world_alone)
{
    ball(own, 3, 40);
    dBodyDisable(ball(other, 5, 2));
    dBodyDisable(dBodyCreate(own));  // nowhere in the space
    const Bytes others = state_of(other);
    take_back_steps();
    EXPECT_TRUE(state_of(other) == others);
}

TEST_F(SharedSpace, pairs_at_rest_are_so_again_where_a_space_has_been_put_into_the_space)
{
    dCreatePlane(space, 0, 0, 1, 0);
    const dBodyID mine = ball(own, 0, dReal(0.5));
    const dGeomID box = dCreateBox(space, 1, 1, 1);
    dGeomSetPosition(box, 0, 0, dReal(1.4));
    dWorldSetAutoDisableFlag(own, 1), dBodySetAutoDisableFlag(mine, 1);
    for (int i = 0; i < 200; ++i) dWorldStep(own, kH);
    ASSERT_FALSE(dBodyIsEnabled(mine));
    const dSpaceID inner = dSimpleSpaceCreate(space);
    dGeomSetPosition(box, 0, 0, 3);
    dSpaceRemove(space, box), dSpaceAdd(inner, box);
    take_back_steps();
}

// A step looked for what its own sleepers had lain on, and woke the body that the geom has now.
TEST_F(SharedSpace, a_step_wakes_no_body_of_another_world)
{
    const dGeomID floor = dCreateBox(space, 9, 9, 1);
    dGeomSetPosition(floor, 0, 0, dReal(-0.5));
    const dBodyID first = ball(own, 0, dReal(0.5)), second = ball(other, 3, dReal(0.5));
    for (const dBodyID body : {first, second}) dBodySetAutoDisableFlag(body, 1);
    for (int i = 0; i < 200; ++i) dWorldStep(own, kH);
    for (int i = 0; i < 200; ++i) dWorldStep(other, kH);
    ASSERT_FALSE(dBodyIsEnabled(first));
    ASSERT_FALSE(dBodyIsEnabled(second));
    dGeomSetBody(dBodyGetFirstGeom(first), second);
    dGeomSetPosition(floor, 0, 0, -5);
    dWorldStep(own, kH);
    EXPECT_FALSE(dBodyIsEnabled(second));
}

// What one world is given must not make the other deaf to what happens to the floor of its sleepers.
TEST_F(SharedSpace, sleepers_wake_although_another_world_was_given_a_state)
{
    const dGeomID floor = dCreateBox(space, 9, 9, 1);
    dGeomSetPosition(floor, 0, 0, dReal(-0.5));
    const dBodyID sleeper = ball(own, 0, dReal(0.5)), awake = ball(own, 3, 40);
    ball(other, 2, 30);
    dBodySetAutoDisableFlag(sleeper, 1);
    for (int i = 0; i < 200; ++i) dWorldStep(own, kH);
    ASSERT_FALSE(dBodyIsEnabled(sleeper));
    ASSERT_TRUE(dBodyIsEnabled(awake));
    const Bytes state = state_of(other);
    ASSERT_EQ(dWorldSetState(other, state.data(), state.size()), 1);
    dGeomSetPosition(floor, 0, 0, -5);
    dWorldStep(own, kH);
    EXPECT_TRUE(dBodyIsEnabled(sleeper)) << "it lies on nothing";
}

}  // namespace
}  // namespace epode::states
