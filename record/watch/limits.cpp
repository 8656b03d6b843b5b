// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One table line for each freedom that can be asked where it is.
#include "record/watch/limits.h"

#include <cmath>

namespace epode::record {

namespace {

using Parameter = dReal (*)(dJointID, int);
using Where = dReal (*)(dJointID);

struct Freedom {
    dJointType type;
    bool turns;
    std::uint8_t axis;
    int low, high;
    Parameter parameter;
    Where value;
};

constexpr Freedom kFreedoms[] = {
    {dJointTypeHinge, true, 0, dParamLoStop, dParamHiStop, dJointGetHingeParam, dJointGetHingeAngle},
    {dJointTypeSlider, false, 0, dParamLoStop, dParamHiStop, dJointGetSliderParam, dJointGetSliderPosition},
    {dJointTypeUniversal, true, 0, dParamLoStop, dParamHiStop, dJointGetUniversalParam,
     dJointGetUniversalAngle1},
    {dJointTypeUniversal, true, 1, dParamLoStop2, dParamHiStop2, dJointGetUniversalParam,
     dJointGetUniversalAngle2},
    {dJointTypeHinge2, true, 0, dParamLoStop, dParamHiStop, dJointGetHinge2Param, dJointGetHinge2Angle1},
    {dJointTypePR, false, 0, dParamLoStop, dParamHiStop, dJointGetPRParam, dJointGetPRPosition},
    {dJointTypePR, true, 1, dParamLoStop2, dParamHiStop2, dJointGetPRParam, dJointGetPRAngle},
    {dJointTypePU, true, 0, dParamLoStop, dParamHiStop, dJointGetPUParam, dJointGetPUAngle1},
    {dJointTypePU, true, 1, dParamLoStop2, dParamHiStop2, dJointGetPUParam, dJointGetPUAngle2},
    {dJointTypePiston, false, 0, dParamLoStop, dParamHiStop, dJointGetPistonParam, dJointGetPistonPosition},
};

}  // namespace

void add_limits(dJointID joint, std::uint32_t number, std::vector<Limit>& limits)
{
    const dJointType type = dJointGetType(joint);
    for (const Freedom& f : kFreedoms) {
        if (f.type != type) continue;
        const double low = double(f.parameter(joint, f.low)), high = double(f.parameter(joint, f.high));
        if (!(low <= high) || (!std::isfinite(low) && !std::isfinite(high))) continue;
        limits.push_back({{number, f.turns, f.axis, low, high}, double(f.value(joint))});
    }
}

}  // namespace epode::record
