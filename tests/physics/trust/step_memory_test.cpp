// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The working memory of steps as clients manage it: whose functions give it, the reserve, sharing between
// worlds and its lifetime, giving it back; and that none of this is seen in a single bit of a motion.
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <map>
#include <mutex>

#include "scenes.h"

namespace epode::physics {
namespace {

// A step memory manager that keeps books: open blocks by size, calls that overlap, frees that do not fit.
struct Manager {
    static inline std::map<void*, dsizeint> open;
    static inline std::atomic<int> inside{0};
    static inline int taken = 0, wrong = 0, overlaps = 0, allowed = 0;

    Manager()
    {
        open.clear();
        taken = wrong = overlaps = 0;
        allowed = 1 << 30;
    }
    static dsizeint total()
    {
        dsizeint sum = 0;
        for (const auto& [block, size] : open) sum += size;
        return sum;
    }
    struct Entry {
        Entry() { overlaps += inside.fetch_add(1) != 0; }
        ~Entry() { inside.fetch_sub(1); }
    };
    static void* take(dsizeint size)
    {
        const Entry entry;
        if (allowed-- <= 0) return nullptr;
        void* block = std::malloc(size);
        open[block] = size;
        ++taken;
        return block;
    }
    static void* shrink(void* block, dsizeint, dsizeint)
    {
        ++wrong;
        return block;
    }
    static void give(void* block, dsizeint size)
    {
        const Entry entry;
        const auto found = open.find(block);
        if (found == open.end() || found->second != size) {
            ++wrong;
            return;
        }
        open.erase(found);
        std::free(block);
    }
    static dWorldStepMemoryFunctionsInfo functions()
    {
        return {sizeof(dWorldStepMemoryFunctionsInfo), &take, &shrink, &give};
    }
    static void use(dWorldID world)
    {
        const dWorldStepMemoryFunctionsInfo info = functions();
        ASSERT_EQ(dWorldSetStepMemoryManager(world, &info), 1);
    }
};

int reserve(dWorldID world, float factor, unsigned minimum)
{
    const dWorldStepReserveInfo info = {sizeof info, factor, minimum};
    return dWorldSetStepMemoryReservationPolicy(world, &info);
}

class StepMemoryOf : public testing::TestWithParam<Stepper> {};
INSTANTIATE_TEST_SUITE_P(Steppers, StepMemoryOf, testing::ValuesIn(kSteppers), case_name);

TEST_P(StepMemoryOf, comes_from_the_manager_and_settles_on_one_block)
{
    const Manager books;
    {
        Sim sim(GetParam());
        Manager::use(sim.world);
        build(sim, Scene::kMachine);
        for (int i = 0; i < 60; ++i)
            ASSERT_EQ(sim.advance(0.01), 1);  // methods take turns until contacts rest
        EXPECT_GT(Manager::taken, 0);
        EXPECT_EQ(Manager::open.size(), 1u) << "blocks that were chained are replaced by one";
        const int taken = Manager::taken;
        for (int i = 0; i < 50; ++i) sim.advance(0.01);
        EXPECT_EQ(Manager::taken, taken) << "a warm step asks for nothing";
        dWorldCleanupWorkingMemory(sim.world);
        EXPECT_TRUE(Manager::open.empty()) << "cleanup really gives the blocks back";
        ASSERT_EQ(sim.advance(0.01), 1);
        EXPECT_FALSE(Manager::open.empty()) << "and keeps the manager";
    }
    EXPECT_TRUE(Manager::open.empty());
    EXPECT_EQ(Manager::wrong, 0) << "each block goes back with the size it was asked with; none is shrunk";
}

TEST_P(StepMemoryOf, is_not_seen_in_the_motion)
{
    const auto run = [](int how) {
        Sim sim(GetParam()), host;
        if (how == 1) {
            Manager::use(sim.world);
            EXPECT_EQ(reserve(sim.world, 1, 0), 1);
        } else if (how == 2) {
            EXPECT_EQ(dWorldUseSharedWorkingMemory(sim.world, host.world), 1);
        }
        build(sim, Scene::kPile, 5);
        if (how == 2) build(host, Scene::kWall, 2);
        for (int i = 0; i < 60; ++i) {
            sim.step(0.01);
            if (how == 2) host.step(0.01);
            if (how == 1 && i % 7 == 0) dWorldCleanupWorkingMemory(sim.world);
        }
        return hash_state(sim);
    };
    const Manager books;
    const std::uint64_t plain = run(0);
    EXPECT_EQ(run(1), plain) << "with a client's blocks, of no reserve, given back now and then";
    EXPECT_TRUE(Manager::open.empty());
    EXPECT_EQ(run(2), plain) << "with memory that another world writes to in between";
}

TEST_P(StepMemoryOf, that_cannot_be_had_is_a_step_not_made)
{
    const Manager books;
    Sim sim(GetParam());
    Manager::use(sim.world);
    build(sim, Scene::kMachine);
    const std::uint64_t before = hash_state(sim);
    Manager::allowed = 0;
    EXPECT_EQ(sim.advance(0.01), 0);
    EXPECT_EQ(hash_state(sim), before) << "nothing was changed";
    Manager::allowed = 1 << 30;
    EXPECT_EQ(sim.advance(0.01), 1);
    EXPECT_NE(hash_state(sim), before);
}

TEST(StepMemory, reserve_sets_the_size_of_the_blocks)
{
    const auto size = [](float factor, unsigned minimum) {
        const Manager books;
        Sim sim(Stepper::kQuick);
        Manager::use(sim.world);
        EXPECT_EQ(reserve(sim.world, factor, minimum), 1);
        build(sim, Scene::kMachine);
        for (int i = 0; i < 3; ++i) sim.advance(0.01);
        return double(Manager::total());
    };
    const double needed = size(1, 0);
    EXPECT_GT(needed, 1000);
    // What is not multiplied, the books of the memory, is small.
    const double twice = size(2, 0), thrice = size(3, 0);
    EXPECT_NEAR(thrice - twice, twice - needed, 0.02 * needed);
    EXPECT_NEAR(thrice / needed, 3, 0.1);
    const double large = size(1, 1u << 20);
    EXPECT_GE(large, 1 << 20) << "no block has less than the minimum";
    EXPECT_LT(large, (1 << 20) + 4096);
}

TEST(StepMemory, reserve_that_cannot_be_had_is_done_without)
{
    const Manager books;
    Sim sim(Stepper::kQuick);
    Manager::use(sim.world);
    EXPECT_EQ(reserve(sim.world, 1e30f, 0), 1);
    build(sim, Scene::kMachine);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(sim.advance(0.01), 1);
}

TEST(StepMemory, lives_as_long_as_one_of_the_worlds_that_share_it)
{
    const Manager books;
    Sim other;
    {
        Sim first;
        Manager::use(first.world);
        EXPECT_EQ(dWorldUseSharedWorkingMemory(other.world, first.world), 1);
        build(first, Scene::kMachine);
        build(other, Scene::kMachine);
        for (int i = 0; i < 5; ++i) first.advance(0.01);
        const int taken = Manager::taken;
        EXPECT_GT(taken, 0);
        for (int i = 0; i < 5; ++i) other.advance(0.01);
        EXPECT_EQ(Manager::taken, taken) << "the other world needs no more than the first";
    }
    EXPECT_FALSE(Manager::open.empty());
    const int taken = Manager::taken;
    EXPECT_EQ(other.advance(0.01), 1);
    EXPECT_EQ(Manager::taken, taken) << "and keeps the memory of a world that is gone";
    EXPECT_EQ(dWorldUseSharedWorkingMemory(other.world, nullptr), 1);
    EXPECT_TRUE(Manager::open.empty()) << "let go by its last world";
    EXPECT_EQ(other.advance(0.01), 1);
    EXPECT_EQ(Manager::taken, taken) << "whose settings begin again";
    EXPECT_EQ(Manager::wrong, 0);
}

TEST(StepMemory, cleanup_by_one_world_keeps_what_all_share_usable)
{
    const Manager books;
    Sim a, b;
    Manager::use(a.world);
    EXPECT_EQ(dWorldUseSharedWorkingMemory(b.world, a.world), 1);
    build(a, Scene::kMachine);
    build(b, Scene::kMachine);
    a.advance(0.01);
    dWorldCleanupWorkingMemory(b.world);
    EXPECT_TRUE(Manager::open.empty());
    EXPECT_EQ(a.advance(0.01) + b.advance(0.01), 2);
    EXPECT_EQ(hash_state(a) == hash_state(b), false) << "two steps against one";
    EXPECT_EQ(b.advance(0.01), 1);
    EXPECT_EQ(hash_state(a), hash_state(b));
}

TEST(StepMemory, blocks_go_back_where_they_came_from)
{
    const Manager books;
    Sim sim(Stepper::kQuick);
    build(sim, Scene::kMachine);
    Manager::use(sim.world);
    sim.advance(0.01);
    EXPECT_FALSE(Manager::open.empty());
    EXPECT_EQ(dWorldSetStepMemoryManager(sim.world, nullptr), 1);
    for (int i = 0; i < 3; ++i) sim.advance(0.01);
    dWorldCleanupWorkingMemory(sim.world);
    EXPECT_TRUE(Manager::open.empty());
    const int taken = Manager::taken;
    sim.advance(0.01);
    EXPECT_EQ(Manager::taken, taken) << "NULL brings dAlloc back";
    Manager::use(sim.world);
    dWorldCleanupWorkingMemory(sim.world);
    EXPECT_EQ(Manager::wrong, 0) << "blocks of dAlloc never reach the manager";
}

TEST(StepMemory, manager_is_called_by_one_thread_at_a_time)
{
    const Manager books;
    {
        Sim sim(Stepper::kQuick);
        Manager::use(sim.world);
        EXPECT_EQ(reserve(sim.world, 1, 0), 1);
        dWorldSetStepThreads(sim.world, 4);
        sim.gravity(0, 0, -9.81);
        for (int chain = 0; chain < 200; ++chain)
            for (int i = 0; i < 5; ++i) {
                sim.body({10.0 * chain, double(i), 0});
                if (i == 0) continue;
                const dJointID joint = dJointCreateBall(sim.world, nullptr);
                dJointAttach(joint, sim.bodies[sim.bodies.size() - 2], sim.bodies.back());
                dJointSetBallAnchor(joint, real(10.0 * chain), real(i - 0.5), 0);
            }
        for (int i = 0; i < 5; ++i) {
            ASSERT_EQ(sim.advance(0.01), 1);
            dWorldCleanupWorkingMemory(sim.world);
        }
        EXPECT_GT(Manager::taken, 5);
    }
    EXPECT_TRUE(Manager::open.empty());
    EXPECT_EQ(Manager::overlaps, 0);
    EXPECT_EQ(Manager::wrong, 0);
}

struct Nested {
    static inline dWorldID self, sharing;
    static inline int answers[4];
    static void moved(dBodyID)
    {
        answers[0] = dWorldStep(sharing, real(0.01));
        answers[1] = dWorldUseSharedWorkingMemory(sharing, nullptr);
        answers[2] = reserve(sharing, 2, 0);
        answers[3] = dWorldSetStepMemoryManager(self, nullptr);
        dWorldCleanupWorkingMemory(self);
    }
};

TEST(StepMemory, in_use_by_a_step_is_left_alone)
{
    Sim sim, sharing;
    EXPECT_EQ(dWorldUseSharedWorkingMemory(sharing.world, sim.world), 1);
    Nested::self = sim.world;
    Nested::sharing = sharing.world;
    std::fill_n(Nested::answers, 4, 7);
    dBodySetMovedCallback(sim.body({}), &Nested::moved);
    Messages messages;
    EXPECT_EQ(sim.advance(0.01), 1);
    for (int answer : Nested::answers) EXPECT_EQ(answer, 0);
    EXPECT_EQ(messages.count(), 5);
    EXPECT_EQ(sharing.advance(0.01), 1);
}

TEST(StepMemory, bad_settings_are_refused)
{
    Sim a, b;
    Messages messages;
    int refusals = 0;
    const auto refused = [&](int answer) {
        EXPECT_EQ(answer, 0);
        EXPECT_EQ(messages.count(), ++refusals) << messages.last();
    };
    refused(reserve(a.world, 0.5f, 0));
    refused(reserve(a.world, NAN, 0));
    refused(reserve(a.world, HUGE_VALF, 0));
    refused(reserve(nullptr, 2, 0));
    const dWorldStepReserveInfo small = {sizeof small - 1, 2, 0};
    refused(dWorldSetStepMemoryReservationPolicy(a.world, &small));
    dWorldStepMemoryFunctionsInfo info = Manager::functions();
    refused(dWorldSetStepMemoryManager(nullptr, &info));
    info.struct_size = 8;
    refused(dWorldSetStepMemoryManager(a.world, &info));
    info = Manager::functions();
    info.alloc_block = nullptr;
    refused(dWorldSetStepMemoryManager(a.world, &info));
    info = Manager::functions();
    info.free_block = nullptr;
    refused(dWorldSetStepMemoryManager(a.world, &info));
    refused(dWorldUseSharedWorkingMemory(a.world, a.world));
    refused(dWorldUseSharedWorkingMemory(nullptr, a.world));
    EXPECT_EQ(dWorldUseSharedWorkingMemory(a.world, b.world), 1) << "nothing above has given it memory";
    refused(dWorldUseSharedWorkingMemory(a.world, b.world));
    dWorldCleanupWorkingMemory(nullptr);
    EXPECT_EQ(messages.count(), refusals + 1);
}

}  // namespace
}  // namespace epode::physics
