// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A joint takes the world's ERP and CFM when it is created, and keeps them: states, differences of states, histories
// and files carry what it has, whatever the world's are when they are loaded.
#include "scene.h"

namespace epode::states {
namespace {

struct Kind {
    const char* name;
    dJointID (*create)(dWorldID, dJointGroupID);
    void (*set)(dJointID, int, dReal);
    dReal (*get)(dJointID, int);
    std::vector<int> parameters;
};

const std::vector<int> kStops = {dParamCFM, dParamStopERP, dParamStopCFM}, kOwn = {dParamERP, dParamCFM};
const std::vector<int> kSuspension = {dParamSuspensionERP, dParamSuspensionCFM};
const Kind kKinds[] = {
    {"ball", dJointCreateBall, dJointSetBallParam, dJointGetBallParam, kOwn},
    {"hinge", dJointCreateHinge, dJointSetHingeParam, dJointGetHingeParam, kStops},
    {"slider", dJointCreateSlider, dJointSetSliderParam, dJointGetSliderParam, kStops},
    {"universal", dJointCreateUniversal, dJointSetUniversalParam, dJointGetUniversalParam, kStops},
    {"hinge2", dJointCreateHinge2, dJointSetHinge2Param, dJointGetHinge2Param, kSuspension},
    {"fixed", dJointCreateFixed, dJointSetFixedParam, dJointGetFixedParam, kOwn},
    {"piston", dJointCreatePiston, dJointSetPistonParam, dJointGetPistonParam, kStops},
    {"PR", dJointCreatePR, dJointSetPRParam, dJointGetPRParam, kStops},
    {"PU", dJointCreatePU, dJointSetPUParam, dJointGetPUParam, kStops},
    {"AMotor", dJointCreateAMotor, dJointSetAMotorParam, dJointGetAMotorParam, kStops},
    {"LMotor", dJointCreateLMotor, dJointSetLMotorParam, dJointGetLMotorParam, kStops},
    {"DBall", dJointCreateDBall, dJointSetDBallParam, dJointGetDBallParam, kOwn},
    {"DHinge", dJointCreateDHinge, dJointSetDHingeParam, dJointGetDHingeParam, kOwn},
    {"transmission", dJointCreateTransmission, dJointSetTransmissionParam, dJointGetTransmissionParam, kOwn}};

constexpr dReal kErp = dReal(0.3), kCfm = dReal(0.002), kOtherErp = dReal(0.6), kOtherCfm = dReal(0.05);

class Softness : public testing::TestWithParam<Kind> {
  protected:
    Softness()
    {
        soften(kErp, kCfm);
        dJointAttach(joint, dBodyCreate(world), dBodyCreate(world));
    }
    ~Softness() override { dWorldDestroy(world); }
    void soften(dReal erp, dReal cfm) const { dWorldSetERP(world, erp), dWorldSetCFM(world, cfm); }
    void spoil() const
    {
        for (int parameter : GetParam().parameters) GetParam().set(joint, parameter, dReal(0.9));
    }
    void expect_own(dJointID its, const char* where) const
    {
        for (int parameter : GetParam().parameters) {
            const bool erp =
                parameter == dParamERP || parameter == dParamStopERP || parameter == dParamSuspensionERP;
            EXPECT_EQ(GetParam().get(its, parameter), erp ? kErp : kCfm)
                << where << ", parameter " << parameter;
        }
    }

    const dWorldID world = dWorldCreate();
    const dJointID joint = make();

  private:
    dJointID make() const
    {
        dWorldSetERP(world, kErp), dWorldSetCFM(world, kCfm);
        return GetParam().create(world, nullptr);
    }
};

TEST_P(Softness, is_in_a_state_whatever_the_worlds_is_by_then)
{
    const Bytes state = state_of(world);
    for (const bool spoilt : {false, true}) {
        soften(kOtherErp, kOtherCfm);
        if (spoilt) spoil();
        ASSERT_EQ(dWorldSetState(world, state.data(), state.size()), 1);
        expect_own(joint, "a state");
        EXPECT_TRUE(state_of(world) == state);
    }
}

TEST_P(Softness, is_in_a_difference_of_states_whatever_the_worlds_is)
{
    const Bytes whole = state_of(world);
    spoil(), soften(kOtherErp, kOtherCfm);
    const Bytes other = state_of(world);
    ASSERT_EQ(dWorldSetState(world, whole.data(), whole.size()), 1);
    expect_own(joint, "the whole state");
    Bytes delta(dWorldGetStateDelta(world, other.data(), other.size(), nullptr, 0));
    ASSERT_GT(delta.size(), 0u);
    dWorldGetStateDelta(world, other.data(), other.size(), delta.data(), delta.size());
    soften(dReal(0.8), dReal(0.09)), spoil();
    ASSERT_EQ(dWorldSetStateDelta(world, other.data(), other.size(), delta.data(), delta.size()), 1);
    expect_own(joint, "a difference");
}

TEST_P(Softness, is_in_a_file_and_a_clone_of_a_world_that_has_another)
{
    soften(kOtherErp, kOtherCfm);
    Bytes file(dWorldSaveToBuffer(world, nullptr, nullptr, 0));
    dWorldSaveToBuffer(world, nullptr, file.data(), file.size());
    dSpaceID none = nullptr;
    for (const dWorldID copy :
         {dWorldLoadFromBuffer(file.data(), file.size(), &none), dWorldClone(world, &none, nullptr, 0)}) {
        ASSERT_NE(copy, nullptr);
        dJointID its = nullptr;
        ASSERT_EQ(dWorldGetJoints(copy, &its, 1), 1);
        expect_own(its, "a copy");
        dWorldDestroy(copy);
    }
}

TEST_P(Softness, comes_back_from_a_history_with_a_joint_that_was_destroyed)
{
    dWorldSetHistory(world, 4);
    for (int i = 0; i < 2; ++i) ASSERT_EQ(dWorldStep(world, dReal(0.01)), 1);
    soften(kOtherErp, kOtherCfm);
    spoil();
    dJointDestroy(joint);
    ASSERT_EQ(dWorldRollBack(world, 1), 1);
    expect_own(joint, "a history");
}

INSTANTIATE_TEST_SUITE_P(Joints, Softness, testing::ValuesIn(kKinds),
                         [](const auto& its) { return std::string(its.param.name); });

}  // namespace
}  // namespace epode::states
