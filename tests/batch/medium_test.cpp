// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Air and water: in closed form, and against dWorldStep.
#include "models.h"

#include <ode/ext.h>

namespace epode::tests {
namespace {

// A swimmer of three links in a wind.
const char* const kSwimmer =
    R"(<mujoco><compiler angle="radian"/><option density="800" viscosity="0.3" wind="1 -0.5 0.2" gravity="0 0 0"/>
<worldbody><body name="a" pos="0 0 1"><freejoint/><geom type="capsule" fromto="0 0 0 .3 0 0" size=".04" density="1000" contype="0" conaffinity="0"/>
<body name="b" pos=".3 0 0"><joint name="j" axis="0 0 1"/><geom type="capsule" fromto="0 0 0 .3 .1 0" size=".03" density="1000" contype="0" conaffinity="0"/>
<body name="c" pos=".3 .1 0"><joint name="k" axis="0 1 0.3"/><geom type="box" pos=".1 0 0" size=".1 .02 .05" density="1000" contype="0" conaffinity="0"/></body></body></body>
</worldbody></mujoco>)";

// From rest, where only the wind acts.
TEST(BatchMedium, blows_as_in_worlds)
{
    if (sizeof(dReal) == 4) GTEST_SKIP() << "differences of this size are rounding in floats";
    dInitODE2(0);
    const dRobotModelID model = model_of(kSwimmer);
    Dice dice(21);
    const dReal h = dReal(1e-5);
    for (int i = 0; i < 50; ++i) {
        const auto q = any_positions(model, dice);
        const dWorldID world = dWorldCreate();
        const dSpaceID space = dSimpleSpaceCreate(nullptr);
        dWorldSetERP(world, 0), dWorldSetCFM(world, 0);
        const dRobotID robot = dRobotCreate(world, space, model, nullptr, nullptr);
        dRobotSetPositions(robot, reals_of(q).data(), 9);
        EXPECT_EQ(dRobotAddForces(robot, h), 3);
        dWorldStep(world, h);
        std::vector<dReal> want(8);
        dRobotGetVelocities(robot, want.data(), 8);
        dRobotDestroy(robot), dSpaceDestroy(space), dWorldDestroy(world);
        Copies<double> copies(model, 1, h);
        copies.write(dBatchPositions, q), dBatchStep(copies.id, 1);
        const auto v = copies.read(dBatchVelocities);
        for (size_t k = 0; k < 8; ++k) EXPECT_NEAR(v[k], double(want[k]), 1e-9) << i;
    }
    dRobotModelDestroy(model);
    dCloseODE();
}

// A box sinks at the speed at which 2 rho r r v^2 is its weight; turning stops, and never makes energy.
TEST(BatchMedium, carries_what_sinks)
{
    const dRobotModelID model = model_of(
        R"(<mujoco><option density="1000"/><worldbody><body><freejoint/><geom type="box" size=".1 .2 .3" mass="30" contype="0" conaffinity="0"/></body></worldbody></mujoco>)");
    Copies<double> copies(model, 2, dReal(0.002));
    copies.write_one(dBatchVelocities, 1, {0, 0, 0, 30, 20, 10});
    dBatchStep(copies.id, 3000);
    const auto v = copies.read(dBatchVelocities);
    EXPECT_NEAR(v[2], -std::sqrt(30 * 9.81 / (2 * 1000 * 0.1 * 0.2)), 1e-9);
    EXPECT_EQ(dBatchCountBad(copies.id), 0);
    for (size_t k = 9; k < 12; ++k) EXPECT_LT(std::fabs(v[k]), 1);
    dRobotModelDestroy(model);
}

}  // namespace
}  // namespace epode::tests
