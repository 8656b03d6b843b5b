// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Numbers that are zero by default are left out, as ODE does.
#include "joints/describe.h"

namespace epode {

void describe(DifWriter& out, const AnchorPair& anchor)
{
    for (int i = 0; i < 2; ++i) describe(out, "anchor", anchor.local[i], i + 1);
}

void describe(DifWriter& out, const AxisPair& axis)
{
    for (int i = 0; i < 2; ++i) describe(out, "axis", axis.local[i], i + 1);
}

void describe(DifWriter& out, const OwnSoftness& softness)
{
    out.real("erp", softness.erp);
    out.real("cfm", softness.cfm);
}

void describe(DifWriter& out, const LimitMotor& motor, int number)
{
    out.open("limit", number);
    out.real("low_stop", motor.lo);
    out.real("high_stop", motor.hi);
    if (motor.bounce != 0) out.real("bounce", motor.bounce);
    out.open("ODE");
    out.real("stop_erp", motor.stop_erp);
    out.real("stop_cfm", motor.stop_cfm);
    out.close();
    out.close();
    out.open("motor", number);
    if (motor.vel != 0) out.real("vel", motor.vel);
    if (motor.fmax != 0) out.real("fmax", motor.fmax);
    out.open("ODE");
    out.real("fudge_factor", motor.fudge);
    out.real("normal_cfm", motor.cfm);
    out.close();
    out.close();
}

void describe(DifWriter& out, std::span<const LimitMotor> motors)
{
    for (std::size_t i = 0; i < motors.size(); ++i) describe(out, motors[i], int(i) + 1);
}

}  // namespace epode
