// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Positions and rates of many joints as arrays: what dJointGetAxisPosition and dJointGetAxisRate return.
#include "base/check.h"
#include "base/float_environment.h"
#include "dynamics/world.h"
#include "joints/drive_rows.h"
#include "ode/ode.h"
#include "ode/state.h"

using namespace epode;

namespace {

bool all_live(const dJointID* joints, int count)
{
    for (int i = 0; i < count; ++i)
        if (!from_handle<Joint>(joints[i])) return false;
    return true;
}

void fill(const Joint& joint, Real (*get)(const Joint&, int), dReal* row, int stride)
{
    const int axes = joint.attached() ? axis_count(joint) : 0;
    for (int i = 0; i < stride; ++i) row[i] = i < axes ? get(joint, i) : 0;
}

}  // namespace

extern "C" int dJointsGetStates(const dJointID* joints, int count, dReal* value, dReal* rate, int stride)
{
    const FloatEnvironment floats;
    EPODE_USER(count >= 0 && (joints || count == 0) && stride >= 1 && all_live(joints, count), 0);
    for (int i = 0; i < count; ++i) {
        const Joint& joint = *from_handle<Joint>(joints[i]);
        const std::ptrdiff_t at = std::ptrdiff_t(stride) * i;
        if (value) fill(joint, axis_position, value + at, stride);
        if (rate) fill(joint, axis_rate, rate + at, stride);
    }
    return 1;
}
