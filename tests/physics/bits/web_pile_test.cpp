// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The pile that tests/wasm/module_test.mjs builds through JavaScript: there and here 200 steps end in the
// golden hash physics/web_pile.
#include <vector>

#include "golden/golden.h"
#include "rig.h"

namespace epode::physics {
namespace {

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
    if (kSingle) GTEST_SKIP() << "the hash is that of double precision";
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
    EXPECT_TRUE(golden::is_golden("physics/web_pile",
                                  hash_reals(states.data(), int(states.size()), 0xcbf29ce484222325u)));
    dWorldDestroy(world);
    dSpaceDestroy(space);
}

}  // namespace
}  // namespace epode::physics
