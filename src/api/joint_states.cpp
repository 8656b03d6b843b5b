// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Positions and rates of many joints as arrays: what the functions of each type return, side by side.
#include "base/check.h"
#include "base/float_environment.h"
#include "dynamics/world.h"
#include "ode/ode.h"
#include "ode/state.h"

using namespace epode;

namespace {

using Getter = dReal (*)(dJointID);

struct Coordinate {
    Getter value, rate;
};

template <int i>
dReal motor_angle(dJointID joint)
{
    return dJointGetAMotorAngle(joint, i);
}
template <int i>
dReal motor_rate(dJointID joint)
{
    return dJointGetAMotorAngleRate(joint, i);
}

constexpr Coordinate kHinge[] = {{dJointGetHingeAngle, dJointGetHingeAngleRate}};
constexpr Coordinate kSlider[] = {{dJointGetSliderPosition, dJointGetSliderPositionRate}};
constexpr Coordinate kUniversal[] = {{dJointGetUniversalAngle1, dJointGetUniversalAngle1Rate},
                                     {dJointGetUniversalAngle2, dJointGetUniversalAngle2Rate}};
constexpr Coordinate kHinge2[] = {{dJointGetHinge2Angle1, dJointGetHinge2Angle1Rate},
                                  {dJointGetHinge2Angle2, dJointGetHinge2Angle2Rate}};
constexpr Coordinate kPiston[] = {{dJointGetPistonPosition, dJointGetPistonPositionRate},
                                  {dJointGetPistonAngle, dJointGetPistonAngleRate}};
constexpr Coordinate kPR[] = {{dJointGetPRPosition, dJointGetPRPositionRate},
                              {dJointGetPRAngle, dJointGetPRAngleRate}};
constexpr Coordinate kPU[] = {{dJointGetPUAngle1, dJointGetPUAngle1Rate},
                              {dJointGetPUAngle2, dJointGetPUAngle2Rate},
                              {dJointGetPUPosition, dJointGetPUPositionRate}};
constexpr Coordinate kMotor[] = {
    {motor_angle<0>, motor_rate<0>}, {motor_angle<1>, motor_rate<1>}, {motor_angle<2>, motor_rate<2>}};

std::span<const Coordinate> coordinates_of(const Joint& joint)
{
    switch (joint.type->number) {
        case dJointTypeHinge:
            return kHinge;
        case dJointTypeSlider:
            return kSlider;
        case dJointTypeUniversal:
            return kUniversal;
        case dJointTypeHinge2:
            return kHinge2;
        case dJointTypePiston:
            return kPiston;
        case dJointTypePR:
            return kPR;
        case dJointTypePU:
            return kPU;
        case dJointTypeAMotor:
            return kMotor;
        default:
            return {};
    }
}

bool all_live(const dJointID* joints, int count)
{
    for (int i = 0; i < count; ++i)
        if (!from_handle<Joint>(joints[i])) return false;
    return true;
}

void fill(dJointID joint, std::span<const Coordinate> own, Getter Coordinate::*get, dReal* row, int stride)
{
    for (int i = 0; i < stride; ++i) row[i] = i < int(own.size()) ? (own[std::size_t(i)].*get)(joint) : 0;
}

}  // namespace

extern "C" int dJointsGetStates(const dJointID* joints, int count, dReal* value, dReal* rate, int stride)
{
    const FloatEnvironment floats;
    EPODE_USER(count >= 0 && (joints || count == 0) && stride >= 1 && all_live(joints, count), 0);
    for (int i = 0; i < count; ++i) {
        const std::span<const Coordinate> own = coordinates_of(*from_handle<Joint>(joints[i]));
        const std::ptrdiff_t at = std::ptrdiff_t(stride) * i;
        if (value) fill(joints[i], own, &Coordinate::value, value + at, stride);
        if (rate) fill(joints[i], own, &Coordinate::rate, rate + at, stride);
    }
    return 1;
}
