// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A joint without bodies that is attached to none once more, after a state was made: what is saved then can be loaded.
#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <vector>

namespace {

TEST(UnattachedJoint, is_saved_as_it_stands_when_it_is_attached_to_nothing)
{
    dInitODE2(0);
    for (const auto create : {dJointCreatePlane2D, dJointCreateDBall, dJointCreateHinge}) {
        const dWorldID world = dWorldCreate();
        const dJointID joint = create(world, nullptr);
        std::vector<unsigned char> state(dWorldGetStateSize(world));
        ASSERT_GT(dWorldGetState(world, state.data(), state.size()), 0);
        dJointAttach(joint, nullptr, nullptr);
        std::vector<unsigned char> saved(dWorldSaveToBuffer(world, nullptr, nullptr, 0));
        ASSERT_EQ(dWorldSaveToBuffer(world, nullptr, saved.data(), saved.size()), saved.size());
        const dWorldID loaded = dWorldLoadFromBuffer(saved.data(), saved.size(), nullptr);
        EXPECT_NE(loaded, nullptr);
        if (loaded) dWorldDestroy(loaded);
        dWorldDestroy(world);
    }
    dCloseODE();
}

}  // namespace
