// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The parts of joints as fields of dWorldExportDIF, in the frames that joints keep them in: `anchor1` and
// `axis1` in that of the body at node 0, `anchor2` and `axis2` in that of the other one or of the world.
#pragma once

#include "base/streams/dif_writer.h"
#include "joints/limit_motor.h"
#include "joints/parts.h"

namespace epode {

inline void describe(DifWriter& out, const char* name, Vec3 v, int number = 0)
{
    out.list(name, {v.x, v.y, v.z}, number);
}
inline void describe(DifWriter& out, const char* name, Quat q, int number = 0)
{
    out.list(name, {q.w, q.x, q.y, q.z}, number);
}

void describe(DifWriter& out, const AnchorPair& anchor);
void describe(DifWriter& out, const AxisPair& axis);
void describe(DifWriter& out, const OwnSoftness& softness);
// Tables `limit` and `motor`, with a number if it is not zero.
void describe(DifWriter& out, const LimitMotor& motor, int number = 0);
// A name for each of the numbers from 1 on.
void describe(DifWriter& out, std::span<const LimitMotor> motors);

}  // namespace epode
