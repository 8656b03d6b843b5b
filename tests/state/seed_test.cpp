// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldQuickStep draws from dRand in a world with the behaviour of ODE 0.16, and there alone: states of such
// worlds hold its seed, those of others leave it as it is.
#include "scene.h"

namespace epode::states {
namespace {

constexpr int kSteps = 20;

std::vector<dReal> places(const Scene& scene)
{
    std::vector<dReal> all;
    for (const dBodyID body : scene.bodies) {
        const dReal* p = dBodyGetPosition(body);
        all.insert(all.end(), p, p + 3);
    }
    return all;
}

class StateSeed : public testing::Test {
  protected:
    StateSeed()
    {
        dWorldSetBehaviour(scene.world, dBehaviour016);
        dRandSetSeed(7);
        scene.steps(60);
        begin = scene.save(), seed = dRandGetSeed();
        scene.steps(kSteps);
        end = scene.save();
    }
    const Messages messages;
    Scene scene{{.stepper = Stepper::kQuick, .world_contacts = false, .piles = 3}};
    Bytes begin, end;
    unsigned long seed = 0;
};

TEST_F(StateSeed, is_given_back)
{
    EXPECT_NE(dRandGetSeed(), seed) << "nothing was drawn";
    dRandSetSeed(12345);
    ASSERT_TRUE(scene.load(begin)) << Messages::last();
    EXPECT_EQ(dRandGetSeed(), seed);
    scene.steps(kSteps);
    EXPECT_EQ(difference(scene.save(), end), "");
    const auto there = places(scene);
    ASSERT_TRUE(scene.load(begin));
    dRandSetSeed(12345);
    scene.steps(kSteps);
    EXPECT_NE(places(scene), there) << "steps do not depend on it";
}

TEST_F(StateSeed, is_taken_back_with_steps)
{
    ASSERT_TRUE(scene.load(begin));
    ASSERT_EQ(dWorldSetHistory(scene.world, kSteps), 1);
    scene.steps(kSteps);
    ASSERT_EQ(dWorldRollBack(scene.world, kSteps), 1) << Messages::last();
    EXPECT_EQ(dRandGetSeed(), seed);
    scene.steps(kSteps);
    EXPECT_EQ(difference(scene.save(), end), "");
}

TEST_F(StateSeed, is_in_files)
{
    ASSERT_TRUE(scene.load(begin));
    Bytes file(dWorldSaveToBuffer(scene.world, scene.space, nullptr, 0));
    ASSERT_EQ(dWorldSaveToBuffer(scene.world, scene.space, file.data(), file.size()), file.size());
    dRandSetSeed(12345);
    dSpaceID space = nullptr;
    const dWorldID copy = dWorldLoadFromBuffer(file.data(), file.size(), &space);
    ASSERT_TRUE(copy) << Messages::last();
    EXPECT_EQ(dRandGetSeed(), seed);
    EXPECT_EQ(difference(state_of(copy), begin), "");
    dWorldDestroy(copy), dSpaceDestroy(space);
}

TEST_F(StateSeed, is_left_alone_by_what_is_refused)
{
    Bytes damaged = begin;
    damaged[damaged.size() / 2] ^= 1;
    dRandSetSeed(12345);
    EXPECT_FALSE(scene.load(damaged));
    EXPECT_EQ(dRandGetSeed(), 12345u);
}

TEST_F(StateSeed, is_left_alone_by_other_worlds)
{
    Scene other({.stepper = Stepper::kQuick, .world_contacts = false, .piles = 3});
    other.steps(3);
    const Bytes own = other.save();
    dRandSetSeed(12345);
    for (const Bytes* state : {&own, static_cast<const Bytes*>(&begin)}) {
        ASSERT_TRUE(other.load(*state)) << Messages::last();
        EXPECT_EQ(dRandGetSeed(), 12345u);
    }
}

}  // namespace
}  // namespace epode::states
