// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every function of epode/robots.h, epode/robot_sensors.h and epode/batch.h, with what its arguments are for. The test robots_hostile_covers_exports
// fails by name where one is missing.
#pragma once

#include <epode/batch.h>
#include <epode/decomposition.h>
#include <epode/robot_sensors.h>

#include <span>
#include <utility>

#include "../../hostile/table.h"

namespace hostile {

enum class Role {
    kModel,
    kRobot,
    kWorld,
    kSpace,
    kSpaceOrNone,
    kNumber,     // of a part of a model
    kAnyNumber,  // that the function does not look up
    kMode,
    kPositionCount,
    kVelocityCount,
    kCapacity,
    kRayCount,
    kTargetCount,
    kStructSize,
    kReal,
    kPositive,
    kNotNegative,
    kDistance,
    kPositions,
    kVelocities,
    kVelocitiesOrNone,
    kPointOrNone,
    kTurnOrNone,
    kFrameOrNone,
    kDirections,
    kOriginsOrNone,
    kName,
    kLoadPath,
    kSavePath,
    kText,
    kTextSize,
    kOptions,
    kTargets,
    kInverseOptions,
    kResult,
    kCamera,
    kTouch,
    kOutput,        // as many elements as the capacity says
    kOutputOrNone,  // for a few reals, or as many as there are rays or pixels
    kFewOutput,
    kRangeOutput,
    kPositionInOut,
    kCorners,  // of a tetrahedron
    kCornerCount,
    kTriangles,
    kTriangleCount,
    kDecomposition,
    kGeomCapacity,
    kDecompositionReport,
    kBatch,
    kBatchSize,  // how many copies
    kBatchOptions,
    kQuantity,
    kParameter,
    kFirstCopy,
    kCopyCount,
    kMethod,  // of derivatives
    kHalf,    // 0 to 0.5
    kBatchLink,
    kStepCount,
    kCopyValues,
    kBound,
    kMask,
    kRayAxes,
};

struct RobotFunction {
    const char* name;
    Result (*call)(const Value* arguments);
    std::span<const Role> roles;
    unsigned struct_size;  // of what it fills
};

inline constexpr int kMaxArguments = 12;

std::span<const RobotFunction> robot_functions();

}  // namespace hostile
