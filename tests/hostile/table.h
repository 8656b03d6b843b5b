// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The API as data: every exported function, what its parameters are, and code that calls it. The table is
// written by generate.py from the public headers when the test is built, so a new function is in it without
// anybody's doing, or else named by a test (generate.py says what is then to be done).
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>

#include <ode/cooperative.h>
#include <ode/export-dif.h>
#include <ode/ext.h>
#include <ode/matrix_coop.h>
#include <ode/ode.h>
#include <ode/threading_impl.h>

namespace hostile {

// What a parameter takes; values.cpp has a list of values for each of them.
enum class Kind {
    kWorld,
    kBody,
    kJoint,
    kGroup,
    kGeom,
    kSpace,
    kHeightfieldData,
    kFluid,
    kThreading,
    kThreadPool,
    kCooperative,
    kRequirements,
    kContainer,
    kTriMeshData,
    kReal,
    kInt,
    kSize,
    kBufferSize,
    kParameterNumber,
    kLength,
    kSampleCount,
    kContactFlags,
    kSkip,
    kStructSize,
    kVertexStride,
    kVertexCount,
    kTriangleStride,
    kCornerCount,
    kThreadCount,
    kBehaviour,
    kFaceCount,
    kPointCount,
    kVector3,
    kVector4,
    kVector6,
    kQuaternion,
    kMatrix3,
    kMatrix4,
    kReals,
    kRows,
    kIndices,
    kRealPointer,
    kIntPointer,
    kMass,
    kContact,
    kContacts,
    kQueryHits,
    kWorldList,
    kBodyList,
    kJointHandles,
    kMaterial,
    kQueryFilter,
    kDrive,
    kDriveBuffer,
    kEventSettings,
    kEventSettingsBuffer,
    kCharacterSettings,
    kCharacterSettingsBuffer,
    kCharacterReport,
    kFluidSettings,
    kFluidSettingsBuffer,
    kVehicleSettings,
    kVehicleSettingsBuffer,
    kVehicleWheel,
    kVehicleWheelBuffer,
    kVehicleControls,
    kVehicleControlsBuffer,
    kVehicleReport,
    kVehicleWheelReport,
    kBones,
    kBoneBuffer,
    kPose,
    kRopeSettings,
    kFractureParts,
    kFractures,
    kGeomClass,
    kWorldReport,
    kIslandReport,
    kLedger,
    kThreadingFunctions,
    kReserveInfo,
    kMemoryFunctions,
    kState,
    kStateDelta,
    kStateBuffer,
    kStopwatch,
    kFile,
    kText,
    kSpacePointer,
    kSavePath,
    kLoadPath,
    kWorldFile,
    kFormat,
    kData,
    kControl,
    kBlock,
    kJointList,
    kFeedback,
    kBytes,
    kShorts,
    kFloats,
    kDoubles,
    kFacePlanes,
    kFacePoints,
    kFaces,
    kFaceBuffer,
    kVertices,
    kCorners,
    kExtraData,
    kSizePointer,
    kBytesPointer,
    kMessageFunction,
    kAllocFunction,
    kReallocFunction,
    kFreeFunction,
    kNearCallback,
    kHeightCallback,
    kFluidSurface,
    kFluidCurrent,
    kContactFilter,
    kManifoldFunction,
    kCollider,
    kMovedCallback,
    kReadyCallback,
    kTriCallback,
    kTriArrayCallback,
    kTriRayCallback,
    kTriMergeCallback,
};
inline constexpr int kKinds = int(Kind::kTriMergeCallback) + 1;

// Flags of a parameter.
enum : unsigned {
    kMayBeNull = 1,  // null means "none"
    kNotRead = 2,    // whatever it is, nothing looks at it
    kAnyNumber = 4,  // a number that is handed on, NaN included
    kInput = 8,      // an array that an object is made of: NaN must not get in
};

// Flags of a function.
enum : unsigned { kReader = 1 };  // tells a part of an object's state and changes none

struct Parameter {
    Kind kind;
    const char* name;
    unsigned flags;
};

// What makes a value worth refusing.
enum class Trait { kFine, kStrange, kNull, kNaN, kBad };  // kBad: always refused
inline constexpr int kTraits = int(Trait::kBad) + 1;

struct Value {
    Trait trait = Trait::kFine;
    const char* text = "";
    union {
        dReal real;
        long long integer;
        void* pointer;
        void (*function)();
    };

    template <typename T>
    T as() const
    {
        if constexpr (std::is_floating_point_v<T>) {
            return T(real);
        } else if constexpr (std::is_pointer_v<T>) {
            if constexpr (std::is_function_v<std::remove_pointer_t<T>>)
                return reinterpret_cast<T>(function);
            else
                return reinterpret_cast<T>(pointer);
        } else {
            return static_cast<T>(integer);
        }
    }
};

struct Result {
    enum class Type { kNothing, kReal, kInteger, kPointer } type = Type::kNothing;
    double real = 0;
    long long integer = 0;
    const void* pointer = nullptr;
};

template <typename T>
Result result_of(T value)
{
    Result r;
    if constexpr (std::is_floating_point_v<T>) {
        r.type = Result::Type::kReal;
        r.real = value;
    } else if constexpr (std::is_pointer_v<T>) {
        r.type = Result::Type::kPointer;
        r.pointer = reinterpret_cast<const void*>(value);
    } else {
        r.type = Result::Type::kInteger;
        r.integer = static_cast<long long>(value);
    }
    return r;
}

struct Function {
    const char* name;
    Result (*call)(const Value* arguments);
    const Parameter* parameters;
    int count;
    unsigned flags;

    std::span<const Parameter> all() const { return {parameters, std::size_t(count)}; }
};

inline constexpr int kMostParameters = 16;

// One that is declared and never called.
struct Absent {
    const char* name;
    const char* reason;
    bool excused;  // on purpose, else nobody has told how
};

std::span<const Function> functions();
// Of every joint type but contacts.
using CreateJoint = dJointID (*)(dWorldID, dJointGroupID);
std::span<const CreateJoint> joint_makers();
std::span<const Absent> absent_functions();

}  // namespace hostile
