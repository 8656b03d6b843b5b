// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A world with more geoms than numbers of 16 bits: its pairs name them by longer ones.
#include "scene.h"

namespace epode::states {
namespace {

TEST(ManyGeoms, have_their_contacts_in_states)
{
    const Messages messages;
    const dWorldID world = dWorldCreate();
    const dSpaceID space = dHashSpaceCreate(nullptr);
    dWorldSetGravity(world, 0, 0, dReal(-9.81)), dWorldSetContactSpace(world, space);
    const int side = 257;
    for (int i = 0; i < side * side; ++i)
        dGeomSetPosition(dCreateSphere(space, dReal(0.4)), dReal(i % side), dReal(i / side), -5);
    dCreatePlane(space, 0, 0, 1, 0);
    for (int i = 0; i < 3; ++i) {
        const dBodyID body = dBodyCreate(world);
        dGeomSetBody(dCreateBox(space, 1, 1, 1), body);
        dBodySetPosition(body, 0, 0, dReal(0.5) + dReal(i));
    }
    const auto steps = [&] {
        for (int i = 0; i < 10; ++i) dWorldStepFast1(world, dReal(0.01), 4);
    };
    steps();
    const Bytes before = state_of(world);
    EXPECT_GT(dWorldGetContacts(world, nullptr, 0), 8);
    steps();
    const Bytes after = state_of(world);
    ASSERT_EQ(dWorldSetState(world, before.data(), before.size()), 1) << Messages::last();
    EXPECT_EQ(difference(state_of(world), before), "");
    steps();
    EXPECT_EQ(difference(state_of(world), after), "");
    dWorldDestroy(world), dSpaceDestroy(space);
}

}  // namespace
}  // namespace epode::states
