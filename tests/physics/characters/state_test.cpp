// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Characters in states, histories, clones and files: they go on with the same bits. And the same bits on every
// machine and thread count: a literal hash.
#include "golden/golden.h"
#include "stage.h"

#include <cstring>

namespace epode::characters {
namespace {

constexpr double kH = 1.0 / 60;

// A character on stairs, slopes, a turning platform and among bodies.
struct Course : Stage {
    explicit Course(int bodies = 6) : Stage(dDefaultsGame)
    {
        floor();
        for (int i = 1; i <= 5; ++i) box({1 + 0.4 * i + 5, 3, 0.125 * i}, {10, 2, 0.25 * i});
        platform = heavy_box({0, 0, 0.1}, {3, 3, 0.2}, 100);
        dBodySetKinematic(platform);
        dBodySetAngularVel(platform, 0, 0, dReal(0.8));
        for (int i = 0; i < bodies; ++i) heavy_box({1.5 + 0.7 * i, -1.5, 0.3}, {0.6, 0.6, 0.6}, 15);
        first = add({0.5, 0, 0.3});
        dCharacterSettings s = usual();
        s.shape = dBoxClass;
        second = add({-1, 2, 0}, s);
    }
    void steps(int from, int to)
    {
        for (int i = from; i < to; ++i) {
            // Along a square, for the cosine is not the same everywhere.
            const int side = i / 25 % 4, way = side < 2 ? 1 : -1;
            if (i % 50 == 20) dCharacterSetHeight(first, i % 100 == 20 ? dReal(1.1) : dReal(1.8));
            walk(first, {side % 2 ? 0.3 : 2.5 * way, side % 2 ? 2.5 * way : -0.2, 0}, i % 40 == 7 ? 4 : 0,
                 kH);
            walk(second, {2, i / 60 % 2 ? 0.5 : -0.4, 0}, 0, kH);
            dWorldStep(world, dReal(kH));
        }
    }
    dBodyID platform;
    dGeomID first, second;
};

std::uint64_t hash_of(std::initializer_list<dGeomID> characters)
{
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const dGeomID c : characters) {
        dCharacterReport r = report(c);
        r.ground = nullptr;  // an address
        dVector3 p;
        dCharacterGetPosition(c, p);
        const auto add = [&](const dReal* numbers, int count) {
            for (int i = 0; i < count; ++i)
                for (std::size_t k = 0; k < sizeof(dReal); ++k)
                    hash = (hash ^ reinterpret_cast<const unsigned char*>(numbers + i)[k]) * 0x100000001b3u;
        };
        add(p, 3), add(r.velocity, 3), add(r.ground_pos, 3), add(r.ground_normal, 3), add(&r.turn, 1);
    }
    return hash;
}

TEST(CharacterStates, go_on_with_the_same_bits_from_a_state)
{
    Course a;
    a.steps(0, 130);
    std::vector<unsigned char> state(dWorldGetStateSize(a.world));
    ASSERT_EQ(dWorldGetState(a.world, state.data(), state.size()), 1);
    a.steps(130, 300);
    const std::uint64_t hash = hash_of({a.first, a.second});
    ASSERT_EQ(dWorldSetState(a.world, state.data(), state.size()), 1);
    EXPECT_NE(hash_of({a.first, a.second}), hash);
    a.steps(130, 300);
    EXPECT_EQ(hash_of({a.first, a.second}), hash);
    Course b;
    ASSERT_EQ(dWorldSetState(b.world, state.data(), state.size()), 1);
    b.steps(130, 300);
    EXPECT_EQ(hash_of({b.first, b.second}), hash);
}

TEST(CharacterStates, are_taken_back_with_steps_even_when_destroyed)
{
    Course a;
    a.steps(0, 100);
    ASSERT_EQ(dWorldSetHistory(a.world, 60), 1);
    a.steps(100, 140);
    const std::uint64_t hash = hash_of({a.first, a.second});
    a.steps(100, 110);
    dGeomDestroy(a.second);
    const dGeomID second = a.second;
    a.second = a.add({1, 1, 3});
    a.steps(110, 120);
    ASSERT_EQ(dWorldRollBack(a.world, 60), 1);
    EXPECT_EQ(dGeomIsCharacter(second), 1);
    a.second = second;
    a.steps(100, 140);
    EXPECT_EQ(hash_of({a.first, a.second}), hash);
}

TEST(CharacterStates, are_in_clones_and_files)
{
    Course a;
    a.steps(0, 130);
    for (const bool file : {false, true}) {
        dSpaceID space = a.space;
        dWorldID copy;
        std::vector<unsigned char> bytes;
        if (file) {
            bytes.resize(dWorldSaveToBuffer(a.world, a.space, nullptr, 0));
            ASSERT_EQ(dWorldSaveToBuffer(a.world, a.space, bytes.data(), bytes.size()), bytes.size());
            copy = dWorldLoadFromBuffer(bytes.data(), bytes.size(), &space);
        } else {
            copy = dWorldClone(a.world, &space, nullptr, 0);
        }
        ASSERT_TRUE(copy);
        std::vector<dGeomID> found;
        for (int i = dSpaceGetNumGeoms(space); i-- > 0;)
            if (const dGeomID g = dSpaceGetGeom(space, i); dGeomIsCharacter(g)) found.push_back(g);
        ASSERT_EQ(found.size(), 2u);
        if (std::fabs(feet(found[0]).x - feet(a.first).x) > 1e-12) std::swap(found[0], found[1]);
        Course b;
        b.steps(0, 130);
        EXPECT_EQ(hash_of({found[0], found[1]}), hash_of({b.first, b.second}));
        struct Ids {
            dWorldID world;
            dGeomID first, second;
        } kept{b.world, b.first, b.second};
        std::swap(b.world, copy), b.first = found[0], b.second = found[1];
        b.steps(130, 250);
        const std::uint64_t hash = hash_of({b.first, b.second});
        std::swap(b.world, copy), b.first = kept.first, b.second = kept.second;
        b.steps(130, 250);
        EXPECT_EQ(hash, hash_of({b.first, b.second}));
        dSpaceDestroy(space), dWorldDestroy(copy);
    }
}

TEST(CharacterStates, of_a_world_without_characters_are_refused)
{
    Course a;
    std::vector<unsigned char> state(dWorldGetStateSize(a.world));
    ASSERT_EQ(dWorldGetState(a.world, state.data(), state.size()), 1);
    dSetDebugHandler([](int, const char*, va_list) {});
    Course b;
    dGeomDestroy(b.second);
    dCreateBox(b.space, dReal(0.6), dReal(0.6), dReal(1.8));
    EXPECT_EQ(dWorldSetState(b.world, state.data(), state.size()), 0);
    dSetDebugHandler(nullptr);
}

#ifdef dIDEDOUBLE
TEST(CharacterBits, are_the_same_everywhere)
{
    for (const int threads : {1, 3}) {
        Course a(0);  // without the solvers, which have hashes of their own
        dWorldSetStepThreads(a.world, threads);
        a.steps(0, 400);
        EXPECT_TRUE(golden::is_golden("physics/characters", hash_of({a.first, a.second})));
    }
}
#endif

}  // namespace
}  // namespace epode::characters
