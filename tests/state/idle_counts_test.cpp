// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// For how many steps, and how long, a body must still be idle before it sleeps is of the state; how long it must be in all is a setting and is
// not. So a state does not depend on the settings of the day, even where a count equals its setting.
#include "scene.h"

namespace epode::states {
namespace {

class IdleCounts : public testing::Test {
  protected:
    IdleCounts()
    {
        dWorldSetAutoDisableSteps(world, 10);
        dWorldSetAutoDisableTime(world, 0);
    }
    ~IdleCounts() override { dWorldDestroy(world); }

    void take(const Bytes& state) const
    {
        ASSERT_EQ(dWorldSetState(world, state.data(), state.size()), 1) << Messages::last();
        EXPECT_EQ(difference(state_of(world), state), "");
    }
    // Steps from now on, with all idle, until the body sleeps.
    int steps_to_sleep(dBodyID body) const
    {
        dBodySetAutoDisableFlag(body, 1);
        int steps = 0;
        for (; steps < 100 && dBodyIsEnabled(body); ++steps) dWorldStep(world, dReal(0.01));
        return steps;
    }

    const Messages messages;
    const dWorldID world = dWorldCreate();
};

TEST_F(IdleCounts, that_a_setting_comes_to_equal_are_taken_and_kept)
{
    const dBodyID body = dBodyCreate(world);  // has 10 steps left
    dBodySetAutoDisableSteps(body, 4);
    const Bytes state = state_of(world);
    dBodySetAutoDisableDefaults(body);  // 10 again
    take(state);
}

TEST_F(IdleCounts, that_equal_their_setting_survive_another_one)
{
    dWorldSetAutoDisableSteps(world, 4);
    dWorldSetAutoDisableTime(world, dReal(0.5));
    const dBodyID body = dBodyCreate(world);  // has 4 steps and 0.5 s left
    const Bytes state = state_of(world);
    dBodySetAutoDisableSteps(body, 60);
    dBodySetAutoDisableTime(body, 3);
    take(state);
}

TEST_F(IdleCounts, of_watched_bodies_survive_another_setting)
{
    dWorldSetAutoDisableFlag(world, 1);
    dWorldSetAutoDisableTime(world, dReal(0.5));
    const dBodyID body = dBodyCreate(world);
    const Bytes state = state_of(world);
    for (int i = 0; i < 3; ++i) dWorldStep(world, dReal(0.01));
    dBodySetAutoDisableTime(body, 3);
    take(state);
}

TEST_F(IdleCounts, decide_when_a_body_sleeps_that_a_state_brings)
{
    dWorldUseDefaults(world, dDefaultsOde);
    dWorldSetAutoDisableSteps(world, 4);
    const dBodyID body = dBodyCreate(world);
    dJointAttach(dJointCreateBall(world, nullptr), body, nullptr);
    const Bytes state = state_of(world);
    const int few = steps_to_sleep(body);
    EXPECT_LT(few, 10);
    dBodySetAutoDisableSteps(body, 60);
    dBodyEnable(body);
    take(state);
    EXPECT_EQ(steps_to_sleep(body), few);
}

TEST_F(IdleCounts, are_in_differences_of_states_and_in_copies)
{
    dWorldSetAutoDisableSteps(world, 4);
    const dBodyID body = dBodyCreate(world);
    const Bytes whole = state_of(world);
    dBodySetPosition(body, 1, 2, 3);
    const Bytes other = state_of(world);
    ASSERT_EQ(dWorldSetState(world, whole.data(), whole.size()), 1);
    Bytes delta(dWorldGetStateDelta(world, other.data(), other.size(), nullptr, 0));
    dWorldGetStateDelta(world, other.data(), other.size(), delta.data(), delta.size());
    dBodySetAutoDisableSteps(body, 60);
    ASSERT_EQ(dWorldSetStateDelta(world, other.data(), other.size(), delta.data(), delta.size()), 1);
    EXPECT_EQ(difference(state_of(world), whole), "");
    dSpaceID none = nullptr;
    const dWorldID clone = dWorldClone(world, &none, nullptr, 0);
    ASSERT_NE(clone, nullptr);
    EXPECT_EQ(difference(state_of(clone), whole), "");
    dWorldDestroy(clone);
}

}  // namespace
}  // namespace epode::states
