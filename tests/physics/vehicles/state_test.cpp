// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Vehicles in states, histories, clones and files: they go on with the same bits. And the same bits on every machine and
// thread count: a literal hash.
#include "golden/golden.h"
#include "road.h"

#include <algorithm>

namespace epode::vehicles {
namespace {

constexpr double kFrame = 1.0 / 60;

// Two cars, among crates and over a kerb; the second has cylinders as wheels and four driven.
struct Course : Road {
    explicit Course(bool crates = true) : Road(0, dDefaultsGame)
    {
        flat();
        dGeomSetPosition(dCreateBox(space, 2, 20, dReal(0.12)), 12, 0, 0);
        for (int i = 0; i < 4 && crates; ++i) {
            const dBodyID body = dBodyCreate(world);
            dMass m;
            dMassSetBoxTotal(&m, 40, 1, 1, dReal(0.8));
            dBodySetMass(body, &m);
            dGeomSetBody(dCreateBox(space, 1, 1, dReal(0.8)), body);
            dBodySetPosition(body, dReal(18 + 2 * i), dReal(0.4 * i), dReal(0.4));
        }
        dVehicleSettings s;
        dVehicleSettingsInit(&s, sizeof s);
        first = car({}, s);
        Wheels wheels;
        wheels.like.cast = dWheelCylinder, wheels.like.drive = 1, wheels.like.anti_roll = 8000;
        s.differential = dDifferentialLimited;
        second = car(wheels, s);
        dBodySetPosition(second, 0, 5, dBodyGetPosition(second)[2]);
    }
    void steps(int from, int to)
    {
        for (int i = from; i < to; ++i) {
            drive(first, i % 70 < 50 ? 0.8 : 0, i % 70 > 60, i / 40 % 2 ? 0.2 : -0.1);
            drive(second, 0.5, 0, i / 30 % 2 ? -0.15 : 0.15, i % 90 > 80);
            dVehicleUpdate(first, dReal(kFrame));
            dVehicleUpdate(second, dReal(kFrame));
            dWorldStep(world, dReal(kFrame));
        }
    }
    dBodyID first, second;
};

std::uint64_t hash_of(std::initializer_list<dBodyID> cars)
{
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&](const dReal* numbers, int count) {
        for (std::size_t k = 0; k < sizeof(dReal) * std::size_t(count); ++k)
            hash = (hash ^ reinterpret_cast<const unsigned char*>(numbers)[k]) * 0x100000001b3u;
    };
    for (const dBodyID car : cars) {
        const dVehicleReport r = report(car);
        add(dBodyGetPosition(car), 3), add(dBodyGetLinearVel(car), 3), add(&r.engine_speed, 3),
            add(&r.steer, 3);
        for (int i = 0; i < dVehicleGetNumWheels(car); ++i) {
            const dVehicleWheelReport w = wheel(car, i);
            add(w.ground_pos, 3), add(&w.steer, 10);
        }
    }
    return hash;
}

TEST(VehicleStates, go_on_with_the_same_bits_from_a_state)
{
    Course a;
    a.steps(0, 130);
    std::vector<unsigned char> state(dWorldGetStateSize(a.world));
    ASSERT_EQ(dWorldGetState(a.world, state.data(), state.size()), 1);
    a.steps(130, 300);
    const std::uint64_t hash = hash_of({a.first, a.second});
    ASSERT_EQ(dWorldSetState(a.world, state.data(), state.size()), 1);
    EXPECT_NE(hash_of({a.first, a.second}), hash);
    EXPECT_NE(wheel(a.first, 0).ground, nullptr);
    a.steps(130, 300);
    EXPECT_EQ(hash_of({a.first, a.second}), hash);
    Course b;
    ASSERT_EQ(dWorldSetState(b.world, state.data(), state.size()), 1);
    b.steps(130, 300);
    EXPECT_EQ(hash_of({b.first, b.second}), hash);
}

TEST(VehicleStates, are_taken_back_with_steps_even_when_destroyed)
{
    Course a;
    a.steps(0, 100);
    ASSERT_EQ(dWorldSetHistory(a.world, 60), 1);
    a.steps(100, 140);
    const std::uint64_t hash = hash_of({a.first, a.second});
    a.steps(140, 145);
    const dBodyID second = a.second;
    dBodyDestroy(second);
    for (int i = 0; i < 5; ++i) dWorldStep(a.world, dReal(kFrame));
    ASSERT_EQ(dWorldRollBack(a.world, 50), 1);
    EXPECT_EQ(dBodyIsVehicle(second), 1);
    a.steps(100, 140);
    EXPECT_EQ(hash_of({a.first, a.second}), hash);
}

TEST(VehicleStates, are_in_clones_and_files)
{
    Course a;
    a.steps(0, 130);
    const std::uint64_t now = hash_of({a.first, a.second});
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
        std::vector<dBodyID> all(std::size_t(dWorldGetBodies(copy, nullptr, 0))), found;
        dWorldGetBodies(copy, all.data(), int(all.size()));
        for (const dBodyID body : all)
            if (dBodyIsVehicle(body)) found.push_back(body);
        ASSERT_EQ(found.size(), 2u);
        if (hash_of({found[0], found[1]}) != now) std::swap(found[0], found[1]);
        EXPECT_EQ(hash_of({found[0], found[1]}), now);
        dVehicleWheel w;
        w.struct_size = sizeof w;
        dVehicleGetWheel(found[1], 0, &w);
        EXPECT_EQ(w.anti_roll, 8000);
        Course b;
        b.steps(0, 130);
        struct Ids {
            dWorldID world;
            dBodyID first, second;
        } kept{b.world, b.first, b.second};
        b.world = copy, b.first = found[0], b.second = found[1];
        b.steps(130, 250);
        const std::uint64_t hash = hash_of({b.first, b.second});
        b.world = kept.world, b.first = kept.first, b.second = kept.second;
        b.steps(130, 250);
        EXPECT_EQ(hash, hash_of({b.first, b.second}));
        dSpaceDestroy(space), dWorldDestroy(copy);
    }
}

TEST(VehicleStates, of_a_world_without_vehicles_are_refused)
{
    Course a;
    std::vector<unsigned char> state(dWorldGetStateSize(a.world));
    ASSERT_EQ(dWorldGetState(a.world, state.data(), state.size()), 1);
    dSetDebugHandler([](int, const char*, va_list) {});
    Course b;
    const dVehicleWheel fifth = [] {
        dVehicleWheel w = Wheels().like;
        w.axle = 7;
        return w;
    }();
    ASSERT_EQ(dVehicleAddWheel(b.second, &fifth), 5);
    const std::uint64_t hash = hash_of({b.first, b.second});
    EXPECT_EQ(dWorldSetState(b.world, state.data(), state.size()), 0);
    EXPECT_EQ(hash_of({b.first, b.second}), hash);
    dSetDebugHandler(nullptr);
}

#ifdef dIDEDOUBLE
TEST(VehicleBits, are_the_same_everywhere)
{
    for (const int threads : {1, 3}) {
        Course a(false);
        dWorldSetStepThreads(a.world, threads);
        a.steps(0, 400);
        EXPECT_TRUE(golden::is_golden("physics/vehicles", hash_of({a.first, a.second})));
    }
}
#endif

}  // namespace
}  // namespace epode::vehicles
