// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldsStep: what a world gets does not depend on the other worlds of the call, their order or the number of
// threads; functions of the program are called on its own thread; what may not be stepped is refused whole.
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <thread>

#include "mesh_floors.h"
#include "scenes.h"

namespace epode::physics {
namespace {

using Sims = std::vector<std::unique_ptr<Sim>>;

constexpr int kThreadCounts[] = {1, 2, 3, 8};
constexpr double kH = 0.01;

int number_of(Stepper s)
{
    return s == Stepper::kExact ? dStepperExact : s == Stepper::kQuick ? dStepperQuick : dStepperSubsteps;
}

std::vector<dWorldID> worlds_of(const Sims& sims)
{
    std::vector<dWorldID> worlds;
    for (const auto& sim : sims) worlds.push_back(sim->world);
    return worlds;
}

// One step of all, each with contacts of ODE's way if it does not manage its own.
int step_many(const Sims& sims, int threads, int steps = 1, int* made = nullptr)
{
    for (const auto& sim : sims)
        if (!dWorldGetContactSpace(sim->world)) sim->collide();
    const std::vector<dWorldID> worlds = worlds_of(sims);
    const int stepper = number_of(sims.front()->stepper);
    return dWorldsStep(worlds.data(), int(worlds.size()), real(kH), stepper, sims.front()->substeps, steps,
                       threads, made);
}

void step_alone(Sim& sim)
{
    if (!dWorldGetContactSpace(sim.world)) sim.collide();
    ASSERT_EQ(sim.advance(kH), 1);
}

// A pile of solids, different for each seed, on a plane or on a mesh whose data all such worlds share.
void build_pile(Sim& sim, int seed, dTriMeshDataID floor)
{
    sim.gravity(0, 0, -9.81);
    if (floor)
        dCreateTriMesh(sim.space, floor, nullptr, nullptr, nullptr);
    else
        sim.ground();
    dWorldSetContactSpace(sim.world, sim.space);
    Random random(std::uint32_t(seed) + 7);
    for (int i = 0; i < 4 + seed % 5; ++i) {
        const V3 at{random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), 0.6 + 0.9 * i};
        const dBodyID b = i % 3 == 0   ? sim.box(at, {0.5, 0.6, 0.7}, 1 + i)
                          : i % 3 == 1 ? sim.sphere(at, 0.3, 1)
                                       : sim.capsule(at, 0.2, 0.4, 2);
        velocity(b, random.point(1), random.point(2));
    }
}

dTriMeshDataID flat_floor()
{
    static const float kCorners[] = {-9, -9, 0, 9, -9, 0, 9, 9, 0, -9, 9, 0};
    static const unsigned kTriangles[] = {0, 1, 2, 0, 2, 3};
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSingle(data, kCorners, 12, 4, kTriangles, 6, 12);
    return data;
}

// Worlds of several sorts and sizes.
Sims make_worlds(Stepper stepper, dTriMeshDataID floor)
{
    Sims sims;
    for (int i = 0; i < 9; ++i) {
        sims.push_back(std::make_unique<Sim>(stepper));
        Sim& sim = *sims.back();
        sim.substeps = 4;
        if (i == 4)
            build(sim, Scene::kMachine, 3);
        else if (i == 6)
            build(sim, Scene::kPile, 5);
        else
            build_pile(sim, i, i % 3 == 0 ? floor : nullptr);
        dWorldSetStepThreads(sim.world, 1 + i % 3);
    }
    return sims;
}

std::vector<std::uint64_t> hashes(const Sims& sims)
{
    std::vector<std::uint64_t> out;
    for (const auto& sim : sims) {
        EXPECT_TRUE(finite_state(*sim));
        out.push_back(hash_state(*sim));
    }
    return out;
}

class WorldBatch : public testing::TestWithParam<Stepper> {};

TEST_P(WorldBatch, gives_every_world_the_bits_that_it_gets_alone)
{
    constexpr int kSteps = 40;
    const dTriMeshDataID floor = flat_floor();
    {
        const Sims alone = make_worlds(GetParam(), floor);
        for (int i = 0; i < kSteps; ++i)
            for (const auto& sim : alone) step_alone(*sim);
        const auto expected = hashes(alone);
        for (const int threads : kThreadCounts) {
            Sims sims = make_worlds(GetParam(), floor);
            for (int i = 0; i < kSteps; ++i) {
                if (i == kSteps / 2) std::reverse(sims.begin(), sims.end());
                ASSERT_EQ(step_many(sims, threads), 9);
            }
            std::reverse(sims.begin(), sims.end());
            EXPECT_EQ(hashes(sims), expected) << threads;
        }
        // By twos and ones.
        Sims sims = make_worlds(GetParam(), floor);
        for (int i = 0; i < kSteps; ++i)
            for (std::size_t k = 0; k < sims.size(); k += 2) {
                Sims some;
                some.push_back(std::move(sims[k]));
                if (k + 1 < sims.size()) some.push_back(std::move(sims[k + 1]));
                ASSERT_EQ(step_many(some, 2), int(some.size()));
                for (std::size_t m = 0; m < some.size(); ++m) sims[k + m] = std::move(some[m]);
            }
        EXPECT_EQ(hashes(sims), expected);
    }
    dGeomTriMeshDataDestroy(floor);
}

TEST_P(WorldBatch, makes_several_steps_as_so_many_calls)
{
    Sims one, many;
    for (Sims* sims : {&one, &many})
        for (int i = 0; i < 5; ++i) {
            sims->push_back(std::make_unique<Sim>(GetParam()));
            build_pile(*sims->back(), i, nullptr);
        }
    for (int i = 0; i < 30; ++i) ASSERT_EQ(step_many(one, 3), 5);
    int made[5] = {};
    for (int i = 0; i < 3; ++i) ASSERT_EQ(step_many(many, 2, 10, made), 5);
    for (const int m : made) EXPECT_EQ(m, 10);
    EXPECT_EQ(hashes(many), hashes(one));
}

// ---- working memory

int g_large_blocks = 0;
void* count_large(dsizeint size)
{
    g_large_blocks += size >= 64 * 1024;
    return std::malloc(size);
}

// Blocks that could be working memory, in the first steps of 32 worlds.
int large_blocks(Stepper stepper, bool in_one_call)
{
    Sims sims;
    for (int i = 0; i < 32; ++i) {
        sims.push_back(std::make_unique<Sim>(stepper));
        build_pile(*sims.back(), i % 3, nullptr);
    }
    g_large_blocks = 0;
    dSetAllocHandler(count_large);
    if (in_one_call)
        EXPECT_EQ(step_many(sims, 1, 3), 32);
    else
        for (const auto& sim : sims) step_alone(*sim);
    dSetAllocHandler(nullptr);
    return g_large_blocks;
}

TEST_P(WorldBatch, lends_working_memory_instead_of_taking_some_for_each_world)
{
    EXPECT_GE(large_blocks(GetParam(), false), 32) << "a world that is stepped alone has its own";
    EXPECT_LE(large_blocks(GetParam(), true), 4);
}

// Memory that the program has set up for a world is used for that world, and for no other.
TEST_P(WorldBatch, leaves_the_memory_of_a_world_with_a_manager_to_it)
{
    Sims sims, twins;
    for (Sims* to : {&sims, &twins})
        for (int i = 0; i < 6; ++i) {
            to->push_back(std::make_unique<Sim>(GetParam()));
            build_pile(*to->back(), i, nullptr);
        }
    static int taken;
    taken = 0;
    dWorldStepMemoryFunctionsInfo functions{};
    functions.struct_size = sizeof functions;
    functions.alloc_block = [](dsizeint size) {
        ++taken;
        return std::malloc(size);
    };
    functions.free_block = [](void* block, dsizeint) { std::free(block); };
    ASSERT_EQ(dWorldSetStepMemoryManager(sims[0]->world, &functions), 1);
    const dWorldID others[] = {sims[1]->world, sims[2]->world};
    const int stepper = number_of(GetParam()), substeps = sims[0]->substeps;
    ASSERT_EQ(dWorldsStep(others, 2, real(kH), stepper, substeps, 1, 2, nullptr), 2);
    ASSERT_EQ(dWorldsStep(worlds_of(twins).data() + 1, 2, real(kH), stepper, substeps, 1, 1, nullptr), 2);
    EXPECT_EQ(taken, 0);
    for (int i = 0; i < 20; ++i) ASSERT_EQ(step_many(sims, 1 + i % 3), 6);
    EXPECT_GE(taken, 1);
    for (int i = 0; i < 20; ++i) ASSERT_EQ(step_many(twins, 1), 6);
    EXPECT_EQ(hashes(sims), hashes(twins));
}

// ---- worlds that share

// Worlds whose bodies are in one space: what moves in one meets, by continuous collision, what others moved.
Sims sharing_worlds(Stepper stepper, dSpaceID shared)
{
    Sims sims;
    for (int i = 0; i < 4; ++i) {
        sims.push_back(std::make_unique<Sim>(stepper));
        Sim& sim = *sims.back();
        sim.gravity(0, 0, -9.81);
        const dBodyID ball = sim.sphere({0.05 * i, 0, 1.0 + i}, 0.2, 1);
        velocity(ball, {0, 0, i % 2 ? -60.0 : 20.0});
        const dGeomID geom = dBodyGetFirstGeom(ball);
        dSpaceRemove(sim.space, geom);
        dSpaceAdd(shared, geom);
        dGeomSetContinuous(geom, dContinuousOn);
        if (i == 3) dWorldUseSharedWorkingMemory(sim.world, sims[1]->world);
    }
    return sims;
}

TEST_P(WorldBatch, steps_worlds_that_share_in_the_order_of_the_array)
{
    const auto run = [](int threads) {
        const dSpaceID shared = dHashSpaceCreate(nullptr);
        dSpaceSetCleanup(shared, 0);
        std::vector<std::uint64_t> result;
        {
            const Sims sims = sharing_worlds(GetParam(), shared);
            for (int i = 0; i < 20; ++i) {
                if (threads == 0)
                    for (const auto& sim : sims) step_alone(*sim);
                else
                    EXPECT_EQ(step_many(sims, threads), 4);
            }
            result = hashes(sims);
            while (dSpaceGetNumGeoms(shared)) dGeomDestroy(dSpaceGetGeom(shared, 0));
        }
        dSpaceDestroy(shared);
        return result;
    };
    const auto expected = run(0);
    for (const int threads : kThreadCounts) EXPECT_EQ(run(threads), expected) << threads;
}

// ---- functions of the program

struct Calls {
    std::thread::id caller;
    int elsewhere = 0;
    std::vector<dWorldID> order;
    dWorldID victim = nullptr;
    int refused = 0;
};
Calls* g_calls = nullptr;

void note_call(dBodyID body)
{
    if (std::this_thread::get_id() != g_calls->caller) ++g_calls->elsewhere;
    g_calls->order.push_back(dBodyGetWorld(body));
    if (!g_calls->victim) return;
    // No world of the batch may go, or be stepped, before the call is over.
    const Messages messages;
    dWorldDestroy(g_calls->victim);
    EXPECT_EQ(dWorldStep(g_calls->victim, real(0.01)), 0);
    EXPECT_EQ(dWorldsStep(&g_calls->victim, 1, real(0.01), dStepperExact, 1, 1, 1, nullptr), 0);
    g_calls->refused += messages.count();
}

int count_filter(void* counter, dGeomID, dGeomID)
{
    if (std::this_thread::get_id() != g_calls->caller) ++g_calls->elsewhere;
    ++*static_cast<int*>(counter);
    return 1;
}

TEST_P(WorldBatch, calls_functions_of_the_program_on_the_callers_thread)
{
    Calls calls;
    calls.caller = std::this_thread::get_id();
    g_calls = &calls;
    Sims sims;
    int asked = 0;
    for (int i = 0; i < 8; ++i) {
        sims.push_back(std::make_unique<Sim>(GetParam()));
        build_pile(*sims.back(), i, nullptr);
        if (i % 3 == 1) dBodySetMovedCallback(sims.back()->bodies[0], note_call);
        if (i == 5) dWorldSetContactFilter(sims.back()->world, count_filter, &asked);
    }
    for (int i = 0; i < 30; ++i) ASSERT_EQ(step_many(sims, 8), 8);
    EXPECT_EQ(calls.elsewhere, 0);
    EXPECT_GT(asked, 0);
    ASSERT_EQ(calls.order.size(), 90u);  // worlds 1, 4 and 7
    for (std::size_t i = 0; i < 90; ++i) EXPECT_EQ(calls.order[i], sims[1 + 3 * (i % 3)]->world);

    calls.victim = sims[7]->world;
    calls.order.clear();
    ASSERT_EQ(step_many(sims, 2), 8);
    EXPECT_EQ(calls.refused, 9);
    calls.victim = nullptr;
    ASSERT_EQ(step_many(sims, 2), 8);
}

// ---- what is refused

TEST_P(WorldBatch, refuses_all_or_nothing)
{
    Sims sims;
    for (int i = 0; i < 3; ++i) {
        sims.push_back(std::make_unique<Sim>(GetParam()));
        build_pile(*sims.back(), i, nullptr);
    }
    const auto before = hashes(sims);
    const dWorldID gone = dWorldCreate();
    dWorldDestroy(gone);
    const int number = number_of(GetParam()), n = 4;
    const dWorldID a = sims[0]->world, b = sims[1]->world, c = sims[2]->world;
    int made[3] = {7, 7, 7};
    const auto refused = [&](std::initializer_list<dWorldID> list, double h, int stepper, int iterations,
                             int steps, int threads) {
        const Messages messages;
        const std::vector<dWorldID> worlds(list);
        const int done = dWorldsStep(worlds.data(), int(worlds.size()), real(h), stepper, iterations, steps,
                                     threads, made);
        return done == 0 && messages.count() == 1;
    };
    EXPECT_TRUE(refused({a, b, a}, kH, number, n, 1, 2));
    EXPECT_TRUE(refused({a, nullptr, c}, kH, number, n, 1, 2));
    EXPECT_TRUE(refused({a, gone, c}, kH, number, n, 1, 2));
    EXPECT_TRUE(refused({a, b, c}, 0, number, n, 1, 2));
    EXPECT_TRUE(refused({a, b, c}, std::nan(""), number, n, 1, 2));
    EXPECT_TRUE(refused({a, b, c}, kH, 99, n, 1, 2));
    EXPECT_TRUE(refused({a, b, c}, kH, -1, n, 1, 2));
    EXPECT_TRUE(refused({a, b, c}, kH, dStepperSubsteps, 0, 1, 2));
    EXPECT_TRUE(refused({a, b, c}, kH, number, n, 0, 2));
    EXPECT_TRUE(refused({a, b, c}, kH, number, n, 1, -1));
    EXPECT_TRUE(refused({a, b, c}, kH, number, n, 1, 65));
    {
        const Messages messages;
        EXPECT_EQ(dWorldsStep(nullptr, 2, real(kH), number, n, 1, 1, made), 0);
        EXPECT_EQ(dWorldsStep(&a, -1, real(kH), number, n, 1, 1, made), 0);
        EXPECT_EQ(messages.count(), 2);
        EXPECT_EQ(dWorldsStep(nullptr, 0, real(kH), number, n, 1, 1, nullptr), 0);
        EXPECT_EQ(messages.count(), 2);
    }
    EXPECT_EQ(hashes(sims), before);
    for (const int m : made) EXPECT_EQ(m, 7);
    EXPECT_EQ(step_many(sims, 2), 3);  // none is left marked
}

int g_blocks_left = 0;
void* some_blocks(dsizeint size) { return g_blocks_left-- > 0 ? std::malloc(size) : nullptr; }
void give_back(void* block, dsizeint) { std::free(block); }

TEST_P(WorldBatch, goes_on_when_one_world_finds_no_memory)
{
    Sims sims, twins;
    for (Sims* to : {&sims, &twins})
        for (int i = 0; i < 3; ++i) {
            to->push_back(std::make_unique<Sim>(GetParam()));
            build_pile(*to->back(), i, nullptr);
        }
    dWorldStepMemoryFunctionsInfo functions{};
    functions.struct_size = sizeof functions;
    functions.alloc_block = some_blocks;
    functions.free_block = give_back;
    g_blocks_left = 0;
    ASSERT_EQ(dWorldSetStepMemoryManager(sims[1]->world, &functions), 1);
    const std::uint64_t before = hash_state(*sims[1]);
    int made[3] = {};
    {
        const Messages messages;
        EXPECT_EQ(step_many(sims, 2, 3, made), 2);
        EXPECT_EQ(messages.count(), 1);
    }
    EXPECT_EQ(made[0], 3);
    EXPECT_EQ(made[1], 0);
    EXPECT_EQ(made[2], 3);
    EXPECT_EQ(hash_state(*sims[1]), before);
    g_blocks_left = 1000;
    Sims late;
    late.push_back(std::move(sims[1]));
    EXPECT_EQ(step_many(late, 2, 3), 1);
    sims[1] = std::move(late[0]);
    EXPECT_EQ(step_many(twins, 1, 3), 3);
    EXPECT_EQ(hashes(sims), hashes(twins));
}

INSTANTIATE_TEST_SUITE_P(Steppers, WorldBatch, testing::ValuesIn(kSteppers), case_name);

}  // namespace
}  // namespace epode::physics
