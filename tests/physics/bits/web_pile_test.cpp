// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The pile that tests/wasm/module_test.mjs builds through JavaScript: there and here 200 steps end in this
// hash.
#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <cstdint>
#include <cstring>
#include <vector>

namespace epode::physics {
namespace {

// FNV-1a
std::uint64_t hash_of(const std::vector<dReal>& numbers)
{
    std::uint64_t all = 0xcbf29ce484222325u;
    for (const dReal& number : numbers) {
        unsigned char bytes[sizeof number];
        std::memcpy(bytes, &number, sizeof number);
        for (unsigned char byte : bytes) all = (all ^ byte) * 0x100000001b3u;
    }
    return all;
}

dBodyID add(dWorldID world, dSpaceID space, int i)
{
    const dBodyID body = dBodyCreate(world);
    const bool round = i % 3 == 0;
    dMass mass;
    round ? dMassSetSphere(&mass, 500, 0.25) : dMassSetBox(&mass, 500, 0.5, 0.4, 0.3);
    dBodySetMass(body, &mass);
    dGeomSetBody(round ? dCreateSphere(space, 0.25) : dCreateBox(space, 0.5, 0.4, 0.3), body);
    dBodySetPosition(body, 0.55 * (i % 4) + 0.03125 * (i % 5), 0.55 * (i / 4 % 4), 0.5 + 0.5 * (i / 16));
    return body;
}

TEST(WebPile, ends_in_the_hash_that_a_browser_sees)
{
    if (sizeof(dReal) != 8) GTEST_SKIP() << "the hash is that of double precision";
    const dWorldID world = dWorldCreate();
    const dSpaceID space = dHashSpaceCreate(nullptr);
    dWorldUseDefaults(world, dDefaultsGame);
    dWorldSetGravity(world, 0, 0, -9.81);
    dWorldSetContactSpace(world, space);
    dCreatePlane(space, 0, 0, 1, 0);
    std::vector<dBodyID> bodies;
    for (int i = 0; i < 80; ++i) bodies.push_back(add(world, space, i));
    for (int i = 0; i < 200; ++i) ASSERT_EQ(dWorldStepHybrid(world, 1.0 / 60), 1);
    std::vector<dReal> states(13 * bodies.size());
    const unsigned fields = dStatePosition | dStateQuaternion | dStateLinearVel | dStateAngularVel;
    ASSERT_EQ(dBodiesGetStates(bodies.data(), int(bodies.size()), fields, states.data(), 0), 1);
    EXPECT_EQ(hash_of(states), 0x2c7e7610140ca364u);
    dWorldDestroy(world);
    dSpaceDestroy(space);
}

}  // namespace
}  // namespace epode::physics
