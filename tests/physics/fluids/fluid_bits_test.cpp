// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Worlds with fluids repeat themselves: on any number of threads, from a state, as a clone, from a file, after steps taken back.
#include <cstring>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "golden/golden.h"
#include "pool.h"

namespace epode::physics {
namespace {

// A hundred solids of all densities dropped into water, with contacts, sleep and a current.
struct Harbour {
    Pool pool;
    std::vector<dBodyID> bodies;

    explicit Harbour(int threads = 1)
    {
        dWorldUseDefaults(pool.world, dDefaultsGame);
        dWorldSetGravity(pool.world, 0, 0, real(-kG));
        dWorldSetContactSpace(pool.world, pool.space);
        dWorldSetStepThreads(pool.world, threads);
        dCreatePlane(pool.space, 0, 0, 1, -2);
        dFluidSettings s;
        dFluidSettingsInit(&s, sizeof s);
        s.current[0] = real(0.3);
        dFluidSetSettings(pool.fluid, &s);
        Random random(9);
        for (int i = 0; i < 100; ++i) {
            const double a = random.uniform(0.2, 0.5), b = random.uniform(0.2, 0.5),
                         density = random.uniform(200, 1500);
            const dBodyID body = i % 4 == 0   ? pool.box(a, b, a, density, 0)
                                 : i % 4 == 1 ? pool.ball(a / 2, density, 0)
                                              : round(i % 4 == 2, a / 2, b, density);
            dBodySetPosition(body, real(0.6 * (i % 10)), real(0.6 * (i / 10)), real(random.uniform(0.3, 1)));
            bodies.push_back(body);
        }
    }
    dBodyID round(bool capsule, double r, double l, double density) const
    {
        dMass m;
        if (capsule)
            dMassSetCapsule(&m, real(density), 3, real(r), real(l));
        else
            dMassSetCylinder(&m, real(density), 3, real(r), real(l));
        return pool.body(capsule ? dCreateCapsule(pool.space, real(r), real(l))
                                 : dCreateCylinder(pool.space, real(r), real(l)),
                         m, 0);
    }
    void steps(int count) const { step_world(pool.world, count); }
    static void step_world(dWorldID world, int count)
    {
        for (int i = 0; i < count; ++i) ASSERT_EQ(dWorldStepHybrid(world, real(1.0 / 60)), 1);
    }
    std::vector<unsigned char> state() const { return state_of(pool.world); }
    static std::vector<unsigned char> state_of(dWorldID world)
    {
        std::vector<unsigned char> bytes(dWorldGetStateSize(world));
        EXPECT_EQ(dWorldGetState(world, bytes.data(), bytes.size()), 1);
        return bytes;
    }
    std::uint64_t hash() const
    {
        std::uint64_t h = 14695981039346656037u;
        const auto add = [&](const dReal* v, int n) {
            for (int i = 0; i < n; ++i) {
                unsigned char bytes[sizeof(dReal)];
                std::memcpy(bytes, v + i, sizeof bytes);
                for (const unsigned char b : bytes) h = (h ^ b) * 1099511628211u;
            }
        };
        for (const dBodyID body : bodies)
            add(dBodyGetPosition(body), 3), add(dBodyGetQuaternion(body), 4), add(dBodyGetLinearVel(body), 3);
        return h;
    }
};

TEST(FluidBits, are_golden_on_any_number_of_threads)
{
    if (kSingle) GTEST_SKIP() << "the literal is that of doubles";
    for (const int threads : {1, 2, 3}) {
        const Harbour harbour(threads);
        harbour.steps(200);
        EXPECT_TRUE(golden::is_golden("physics/fluids", harbour.hash())) << threads;
    }
}

TEST(FluidBits, go_on_the_same_from_a_state)
{
    const Harbour harbour;
    harbour.steps(150);
    const auto before = harbour.state();
    harbour.steps(150);
    const auto after = harbour.state();
    EXPECT_NE(before, after);
    ASSERT_EQ(dWorldSetState(harbour.pool.world, before.data(), before.size()), 1);
    harbour.steps(150);
    EXPECT_EQ(harbour.state(), after);
}

TEST(FluidBits, go_on_the_same_in_a_clone_and_from_a_file)
{
    const Harbour harbour;
    harbour.steps(100);
    dSpaceID space = harbour.pool.space;
    const dWorldID clone = dWorldClone(harbour.pool.world, &space, nullptr, 0);
    ASSERT_NE(clone, nullptr);
    std::vector<unsigned char> file(dWorldSaveToBuffer(harbour.pool.world, harbour.pool.space, nullptr, 0));
    ASSERT_GT(file.size(), 0u);
    dWorldSaveToBuffer(harbour.pool.world, harbour.pool.space, file.data(), file.size());
    dSpaceID loaded_space = nullptr;
    const dWorldID loaded = dWorldLoadFromBuffer(file.data(), file.size(), &loaded_space);
    ASSERT_NE(loaded, nullptr);
    EXPECT_EQ(dWorldGetNumFluids(loaded), 1);
    harbour.steps(100);
    Harbour::step_world(clone, 100), Harbour::step_world(loaded, 100);
    EXPECT_EQ(Harbour::state_of(clone), harbour.state());
    EXPECT_EQ(Harbour::state_of(loaded), harbour.state());
    dWorldDestroy(clone), dWorldDestroy(loaded);
    dSpaceDestroy(space), dSpaceDestroy(loaded_space);
}

TEST(FluidBits, come_back_when_steps_are_taken_back)
{
    const Harbour harbour;
    ASSERT_EQ(dWorldSetHistory(harbour.pool.world, 50), 1);
    harbour.steps(60);
    const auto before = harbour.state();
    harbour.steps(40);
    const auto after = harbour.state();
    ASSERT_EQ(dWorldRollBack(harbour.pool.world, 40), 1);
    EXPECT_EQ(harbour.state(), before);
    harbour.steps(40);
    EXPECT_EQ(harbour.state(), after);
}

TEST(FluidBits, state_of_a_world_with_another_number_of_fluids_is_refused)
{
    const Harbour harbour;
    harbour.steps(10);
    const auto before = harbour.state();
    const dFluidID second = dFluidCreate(harbour.pool.world);
    EXPECT_EQ(dWorldSetState(harbour.pool.world, before.data(), before.size()), 0);
    dFluidDestroy(second);
    EXPECT_EQ(dWorldSetState(harbour.pool.world, before.data(), before.size()), 1);
}

// Of many worlds stepped together, too: those with functions take turns on the caller's thread.
TEST(FluidBits, call_functions_on_the_callers_thread)
{
    struct Seen {
        std::thread::id caller = std::this_thread::get_id();
        int calls = 0, elsewhere = 0;
    };
    const auto listen = [](void* data, const dVector3, dReal) -> dReal {
        auto& seen = *static_cast<Seen*>(data);
        ++seen.calls;
        if (std::this_thread::get_id() != seen.caller) ++seen.elsewhere;
        return 0;
    };
    std::vector<Seen> seen(16);
    std::vector<std::unique_ptr<Pool>> pools;
    std::vector<dWorldID> worlds;
    for (Seen& one : seen) {
        pools.push_back(std::make_unique<Pool>());
        for (int i = 0; i < 20; ++i) pools.back()->ball(0.1, 500, 0);
        dFluidSetSurface(pools.back()->fluid, listen, &one);
        worlds.push_back(pools.back()->world);
    }
    ASSERT_EQ(dWorldsStep(worlds.data(), 16, real(0.01), dStepperExact, 20, 10, 4, nullptr), 16);
    for (const Seen& one : seen) {
        EXPECT_GT(one.calls, 0);
        EXPECT_EQ(one.elsewhere, 0);
    }
}

}  // namespace
}  // namespace epode::physics
