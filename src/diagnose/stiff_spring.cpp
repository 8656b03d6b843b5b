// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The program's own spring, f = -k x - d v, is held constant over a step. It overshoots when h^2 k/m > 2 and is
// unstable from 4 on (semi-implicit Euler); of a damper the same with 2 h d/m. Two forces of consecutive steps
// show it: f reverses, and with df between them k is at least -df.dx / dx^2, d at least -df.dv / dv^2.
#include "diagnose/cause.h"

#include <algorithm>

namespace epode {
namespace {

constexpr Real kStiff = 2, kUnstable = 4;

Real slope(Vec3 df, Vec3 d)
{
    const Real size = length2(d);
    return size > 0 ? std::max(-dot(df, d) / size, Real(0)) : 0;
}

// The larger of h^2 k/m and 2 h d/m; 0: the force did not reverse.
Real stiffness(Vec3 f, Vec3 before, Vec3 dx, Vec3 dv, Real inv_mass, Real h)
{
    if (!(dot(f, before) < 0)) return 0;
    const Vec3 df = f - before;
    const Real spring = h * h * inv_mass * slope(df, dx), damper = 2 * h * inv_mass * slope(df, dv);
    return std::max(spring, damper);
}

}  // namespace

const char* const k_text_of_stiff_spring =
    "the program's force on the body reverses from step to step: a spring or damper too stiff for this "
    "step; use a drive (dJointSetDrive) or a joint's ERP and CFM, which are implicit, or a shorter step";

void find_stiff_spring(const StepFacts& facts)
{
    facts.for_each_body([&](Body& body, const BodyBefore& b) {
        const BodyBefore* last = StepFacts::of(facts.last, body);
        if (!last || body.vehicle) return;  // the forces of wheels are implicit
        const Sym3& I = body.inv_inertia;
        const Real inv_inertia = std::min(I.xx, std::min(I.yy, I.zz));
        const Real stretch =
            stiffness(b.force, last->force, b.x - last->x, b.v - last->v, body.inv_mass, facts.h);
        const Real twist =
            stiffness(b.torque, last->torque, facts.h * b.w, b.w - last->w, inv_inertia, facts.h);
        const Real figure = std::max(stretch, twist);
        if (!(figure > kStiff)) return;
        facts.findings.add({.kind = dDiagnosisStiffSpring,
                            .severity = figure > kUnstable ? dSeverityError : dSeverityWarning,
                            .body = to_handle(&body),
                            .figure = double(figure),
                            .threshold = double(kStiff)});
    });
}

}  // namespace epode
