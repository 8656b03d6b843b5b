// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// NAME: a body that hangs on it stays there in every stepper, and bad numbers are refused.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <cmath>
#include <limits>

namespace {

constexpr dReal kH = dReal(0.005);

int step_exactly(dWorldID world) { return dWorldStep(world, kH); }
int step_by_sweeps(dWorldID world) { return dWorldQuickStep(world, kH); }
int step_fast(dWorldID world) { return dWorldStepFast1(world, kH, 10); }

class NAMETest : public testing::TestWithParam<int (*)(dWorldID)> {
  protected:
    dWorldID world = dWorldCreate();
    dBodyID body = dBodyCreate(world);
    dJointID joint = dJointCreateNAME(world, nullptr);

    NAMETest()
    {
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
        dBodySetPosition(body, 1, 0, 0);
        dJointAttach(joint, body, nullptr);
        dJointSetNAMEAnchor(joint, 0, 0, 0);
    }
    ~NAMETest() override { dWorldDestroy(world); }
};

TEST_P(NAMETest, holds_the_anchor_of_a_swinging_body)
{
    dVector3 anchor;
    for (int i = 0; i < 400; ++i) {
        ASSERT_EQ(GetParam()(world), 1);
        dJointGetNAMEAnchor(joint, anchor);
        ASSERT_LT(std::hypot(anchor[0], anchor[1], anchor[2]), 0.03);
    }
    EXPECT_LT(dBodyGetPosition(body)[2], -0.1) << "it has swung";
}

TEST_P(NAMETest, refuses_what_is_no_number)
{
    dJointSetNAMEAnchor(joint, 0, std::numeric_limits<dReal>::quiet_NaN(), 0);
    dVector3 anchor = {7, 7, 7, 0};
    dJointGetNAMEAnchor(joint, anchor);
    EXPECT_EQ(anchor[1], 0);
}

INSTANTIATE_TEST_SUITE_P(Steppers, NAMETest, testing::Values(step_exactly, step_by_sweeps, step_fast));

}  // namespace
