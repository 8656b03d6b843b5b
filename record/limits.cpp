// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One table line for each freedom that can be asked where it is.
#include "view/limits.h"

#include <cmath>

namespace epode::view {

namespace {

using Parameter = dReal (*)(dJointID, int);
using Where = dReal (*)(dJointID);

struct Freedom {
    dJointType type;
    bool turns;
    int axis, low, high;
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
    {dJointTypePiston, false, 0, dParamLoStop, dParamHiStop, dJointGetPistonParam, dJointGetPistonPosition},
};

}  // namespace

std::vector<Limit> limits_of(dJointID joint)
{
    std::vector<Limit> limits;
    for (const Freedom& f : kFreedoms) {
        if (f.type != dJointGetType(joint)) continue;
        const double low = double(f.parameter(joint, f.low)), high = double(f.parameter(joint, f.high));
        if (!(low <= high) || (!std::isfinite(low) && !std::isfinite(high))) continue;
        limits.push_back({f.turns, f.axis, low, high, double(f.value(joint))});
    }
    return limits;
}

}  // namespace epode::view
