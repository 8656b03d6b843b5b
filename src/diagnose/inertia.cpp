// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A real body has I1 + I2 >= I3 for its principal moments: tr(I)/2 - I is positive semidefinite. And its radius
// of gyration, k = sqrt(tr(I) / 2m), lies within its shapes: what reaches R has 0.05 R < k < R.
#include "diagnose/cause.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

constexpr Real kLargest = 2, kSmallest = Real(0.05);

bool is_physical(const Sym3& I)
{
    const Real t = (I.xx + I.yy + I.zz) / 2, slack = Real(1e-5) * t;
    const Real a = t - I.xx + slack, b = t - I.yy + slack, c = t - I.zz + slack;
    const Mat3 S = {{a, -I.xy, -I.xz}, {-I.xy, b, -I.yz}, {-I.xz, -I.yz, c}};
    return a >= 0 && a * b - I.xy * I.xy >= 0 && dot(S.row0, cross(S.row1, S.row2)) >= 0;
}

}  // namespace

const char* const k_text_of_inertia =
    "the body's inertia is not that of a real body, or not of the size of its geoms: it rotates far too "
    "easily or hardly at all; set the mass with dMassSetBox() and its sisters for the shape it has";

void find_inertia(const StepFacts& facts)
{
    facts.for_each_body([&](Body& body, const BodyBefore&) {
        const Sym3& I = body.inertia;
        const Real reach = extent_of(body).reach;
        const Real k = std::sqrt((I.xx + I.yy + I.zz) / (2 * body.mass.mass));
        Finding one{.kind = dDiagnosisInertia, .severity = dSeverityWarning, .body = to_handle(&body)};
        one.threshold = double(kLargest), one.figure = reach > 0 ? double(k / reach) : 0;
        if (!is_physical(I)) return facts.findings.add(one);
        if (reach > 0 && k < kSmallest * reach)
            one.figure = double(reach / k), one.threshold = double(1 / kSmallest);
        if (one.figure > one.threshold) facts.findings.add(one);
    });
}

}  // namespace epode
