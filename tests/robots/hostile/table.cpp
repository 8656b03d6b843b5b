// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "table.h"

namespace hostile {
namespace {

template <auto function, typename Type = decltype(function)>
struct Call;

template <auto function, typename Answer, typename... Arguments>
struct Call<function, Answer (*)(Arguments...)> {
    static constexpr std::size_t kCount = sizeof...(Arguments);

    static Result of(const Value* values) { return with(values, std::index_sequence_for<Arguments...>()); }

  private:
    template <std::size_t... i>
    static Result with(const Value* values, std::index_sequence<i...>)
    {
        if constexpr (std::is_void_v<Answer>)
            return function(values[i].as<Arguments>()...), Result{};
        else
            return result_of(function(values[i].as<Arguments>()...));
    }
};

template <Role... roles>
constexpr Role kRoles[] = {roles...};

template <auto function, Role... roles>
constexpr RobotFunction entry(const char* name, unsigned struct_size = 0)
{
    static_assert(sizeof...(roles) == Call<function>::kCount, "a role for each argument");
    return {name, Call<function>::of, kRoles<roles...>, struct_size};
}

using enum Role;
#define FUNCTION(name, ...) entry<name, __VA_ARGS__>(#name)
#define FILLS(type, name, ...) entry<name, __VA_ARGS__>(#name, unsigned(sizeof(type)))

constexpr RobotFunction kAll[] = {
    FILLS(dRobotOptions, dRobotOptionsInit, kFewOutput, kStructSize),
    FUNCTION(dRobotModelLoad, kLoadPath, kOptions),
    FUNCTION(dRobotModelLoadText, kLoadPath, kText, kTextSize, kOptions),
    FUNCTION(dRobotModelSave, kModel, kSavePath),
    FUNCTION(dRobotModelDestroy, kModel),
    FUNCTION(dRobotModelGetReport, kModel, kOutput, kCapacity),
    FUNCTION(dRobotModelHasErrors, kModel),
    FUNCTION(dRobotModelGetLinks, kModel, kOutput, kCapacity),
    FUNCTION(dRobotModelGetJoints, kModel, kOutput, kCapacity),
    FUNCTION(dRobotModelGetActuators, kModel, kOutput, kCapacity),
    FUNCTION(dRobotModelGetNumPositions, kModel),
    FUNCTION(dRobotModelGetNumActuators, kModel),
    FUNCTION(dRobotModelGetNumStarts, kModel),
    FUNCTION(dRobotModelFindLink, kModel, kName),
    FUNCTION(dRobotModelFindJoint, kModel, kName),
    FUNCTION(dRobotModelFindActuator, kModel, kName),
    FUNCTION(dRobotModelGetReference, kModel, kOutput, kCapacity),
    FUNCTION(dRobotModelGetStart, kModel, kNumber, kOutput, kCapacity),
    FUNCTION(dRobotModelGetStartName, kModel, kNumber),
    FUNCTION(dRobotModelGetPoses, kModel, kPositions, kPositionCount, kOutput, kCapacity),
    FUNCTION(dRobotModelGetNumVelocities, kModel),
    FUNCTION(dRobotModelGetJacobian, kModel, kPositions, kNumber, kPointOrNone, kOutput, kCapacity),
    FUNCTION(dRobotModelGetConstraints, kModel, kPositions, kOutputOrNone, kOutputOrNone, kCapacity),
    FUNCTION(dRobotModelGetGravity, kModel, kFewOutput),
    FUNCTION(dRobotModelGetStepsize, kModel),
    FUNCTION(dRobotModelGetMassMatrix, kModel, kPositions, kOutput, kCapacity),
    FUNCTION(dRobotModelGetInverseDynamics, kModel, kPositions, kVelocitiesOrNone, kVelocitiesOrNone, kOutput,
             kCapacity),
    FUNCTION(dRobotModelGetFluidForces, kModel, kPositions, kVelocities, kOutput, kCapacity),
    FUNCTION(dRobotModelFindTendon, kModel, kName),
    FUNCTION(dRobotModelGetTendons, kModel, kPositions, kOutputOrNone, kOutputOrNone, kCapacity),
    FUNCTION(dRobotModelFindFrame, kModel, kName, kFewOutput),
    FUNCTION(dRobotTargetInit, kFewOutput, kAnyNumber),
    FILLS(dRobotInverseOptions, dRobotInverseOptionsInit, kFewOutput, kStructSize),
    FUNCTION(dRobotModelGetInverse, kModel, kTargets, kTargetCount, kInverseOptions, kPositionInOut, kResult),
    FUNCTION(dRobotCreate, kWorld, kSpaceOrNone, kModel, kPointOrNone, kTurnOrNone),
    FUNCTION(dRobotDestroy, kRobot),
    FUNCTION(dRobotGetBody, kRobot, kNumber),
    FUNCTION(dRobotGetJoint, kRobot, kNumber),
    FUNCTION(dRobotSetPositions, kRobot, kPositions, kPositionCount),
    FUNCTION(dRobotGetPositions, kRobot, kOutput, kCapacity),
    FUNCTION(dRobotSetVelocities, kRobot, kVelocities, kVelocityCount),
    FUNCTION(dRobotGetVelocities, kRobot, kOutput, kCapacity),
    FUNCTION(dRobotSetControl, kRobot, kNumber, kReal),
    FUNCTION(dRobotSetTarget, kRobot, kNumber, kReal, kNotNegative, kNotNegative),
    FUNCTION(dRobotAddFluidForces, kRobot, kNotNegative),
    FUNCTION(dRobotAddForces, kRobot, kPositive),
    FUNCTION(dRobotGetControl, kRobot, kNumber),
    FUNCTION(dRobotModelGetNumMocap, kModel),
    FUNCTION(dRobotModelGetMocap, kModel, kNumber),
    FUNCTION(dRobotSetMocap, kRobot, kNumber, kPointOrNone, kTurnOrNone),
    FUNCTION(dRobotGetState, kRobot, kOutput, kCapacity),
    FUNCTION(dRobotSetState, kRobot, kPositions, kPositionCount),
    FUNCTION(dRobotSetActivation, kRobot, kNumber, kReal),
    FUNCTION(dRobotGetActivation, kRobot, kNumber),
    FUNCTION(dRobotUpdateSensors, kRobot, kPositive),
    FUNCTION(dRobotGetDriveForces, kRobot, kOutput, kCapacity),
    FUNCTION(dRobotGetImu, kRobot, kNumber, kFrameOrNone, kOutputOrNone, kOutputOrNone),
    FUNCTION(dRobotSetForceSensor, kRobot, kNumber, kMode),
    FUNCTION(dRobotGetForceTorque, kRobot, kNumber, kFrameOrNone, kOutputOrNone, kOutputOrNone),
    FUNCTION(dRobotGetTouch, kRobot, kNumber, kTouch),
    FUNCTION(dRobotCastRays, kRobot, kNumber, kFrameOrNone, kSpace, kRayCount, kDirections, kDistance,
             kRangeOutput, kOutputOrNone),
    FILLS(dRobotCamera, dRobotCameraInit, kFewOutput, kStructSize),
    FUNCTION(dRobotTakePicture, kRobot, kNumber, kFrameOrNone, kSpace, kCamera, kOutputOrNone, kOutputOrNone,
             kOutputOrNone),
    FUNCTION(dRobotModelGetSensors, kModel, kOutput, kCapacity),
    FUNCTION(dRobotReadSensor, kRobot, kNumber, kSpaceOrNone, kOutput, kCapacity),
    FILLS(dDecompositionOptions, dDecompositionOptionsInit, kFewOutput, kStructSize),
    FUNCTION(dCreateConvexDecomposition, kSpaceOrNone, kCorners, kCornerCount, kTriangles, kTriangleCount,
             kDecomposition, kOutput, kGeomCapacity, kDecompositionReport),
    FILLS(dBatchOptions, dBatchOptionsInit, kFewOutput, kStructSize),
    FUNCTION(dBatchCreate, kModel, kBatchSize, kBatchOptions),
    FUNCTION(dBatchDestroy, kBatch),
    FUNCTION(dBatchGetNumCopies, kBatch),
    FUNCTION(dBatchGetNumberSize, kBatch),
    FUNCTION(dBatchGetNumThreads, kBatch),
    FUNCTION(dBatchGetSize, kBatch, kQuantity),
    FUNCTION(dBatchGetSensor, kBatch, kNumber, kOutputOrNone),
    FUNCTION(dBatchRead, kBatch, kQuantity, kFirstCopy, kCopyCount, kOutput),
    FUNCTION(dBatchWrite, kBatch, kQuantity, kFirstCopy, kCopyCount, kCopyValues),
    FUNCTION(dBatchGetParameterSize, kBatch, kParameter),
    FUNCTION(dBatchReadParameter, kBatch, kParameter, kFirstCopy, kCopyCount, kOutput),
    FUNCTION(dBatchWriteParameter, kBatch, kParameter, kFirstCopy, kCopyCount, kCopyValues),
    FUNCTION(dBatchJacobian, kBatch, kBatchLink, kPointOrNone, kFirstCopy, kCopyCount, kOutput),
    FUNCTION(dBatchGetTangentSize, kBatch),
    FUNCTION(dBatchLinearise, kBatch, kMethod, kHalf, kFirstCopy, kCopyCount, kOutput, kOutput),
    FUNCTION(dBatchLineariseParameter, kBatch, kMethod, kHalf, kParameter, kFirstCopy, kCopyCount, kOutput),
    FUNCTION(dBatchBind, kBatch, kQuantity, kBound),
    FUNCTION(dBatchStep, kBatch, kStepCount),
    FUNCTION(dBatchReset, kBatch, kMask),
    FUNCTION(dBatchCastRays, kBatch, kNumber, kRayAxes, kRayCount, kOriginsOrNone, kDirections, kDistance,
             kFirstCopy, kCopyCount, kOutput, kOutputOrNone),
    FUNCTION(dBatchCountBad, kBatch),
};

}  // namespace

std::span<const RobotFunction> robot_functions() { return kAll; }

}  // namespace hostile
