// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What steps compute from numbers that setters accept may go beyond what setters accept. States, files and clones
// carry it as long as it is finite.
#include <cmath>

#include "scene.h"

namespace epode::states {
namespace {

// Spring and feed-forward of a drive exert 1e100 N each, on a carriage as heavy.
class ComputedNumbers : public testing::TestWithParam<Stepper> {};

TEST_P(ComputedNumbers, beyond_the_limit_of_setters_are_in_states_files_and_clones)
{
    constexpr dReal kLargest = sizeof(dReal) == 8 ? dReal(1e100) : dReal(1e18);
    const dWorldID world = dWorldCreate();
    const dBodyID carriage = dBodyCreate(world);
    dMass mass;
    dMassSetSphereTotal(&mass, kLargest, 1);
    dBodySetMass(carriage, &mass);
    const dJointID rail = dJointCreateSlider(world, nullptr);
    dJointAttach(rail, carriage, nullptr);
    dJointSetSliderAxis(rail, 0, 0, 1);
    dDrive drive;
    dDriveInit(&drive, sizeof drive);
    drive.stiffness = drive.target = std::sqrt(kLargest), drive.force = kLargest;
    ASSERT_EQ(dJointSetDrive(rail, 0, &drive), 1);
    step_with(GetParam(), world, dReal(1e-3), 4);
    ASSERT_GT(std::abs(dJointGetDriveForce(rail, 0)), kLargest);
    ASSERT_TRUE(std::isfinite(dJointGetDriveForce(rail, 0)));

    const Bytes state = state_of(world);
    EXPECT_EQ(dWorldSetState(world, state.data(), state.size()), 1);
    EXPECT_TRUE(state_of(world) == state);
    Bytes file(dWorldSaveToBuffer(world, nullptr, nullptr, 0));
    ASSERT_EQ(dWorldSaveToBuffer(world, nullptr, file.data(), file.size()), file.size());
    dSpaceID none = nullptr;
    for (const dWorldID copy :
         {dWorldLoadFromBuffer(file.data(), file.size(), &none), dWorldClone(world, &none, nullptr, 0)}) {
        ASSERT_NE(copy, nullptr);
        EXPECT_TRUE(state_of(copy) == state);
        dWorldDestroy(copy);
    }
    dWorldDestroy(world);
}

INSTANTIATE_TEST_SUITE_P(Steppers, ComputedNumbers, testing::ValuesIn(kSteppers),
                         [](const auto& its) { return std::string(name_of(its.param)); });

}  // namespace
}  // namespace epode::states
