// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A real body has I1 + I2 >= I3 for its principal moments, so that none is larger than tr(I)/2. And its radius
// of gyration, k = sqrt(tr(I) / 2m), lies within its shapes: what reaches R has 0.05 R < k < R.
#include "diagnose/cause.h"

#include <algorithm>
#include <cmath>

#include "diagnose/text.h"

namespace epode {
namespace {

constexpr Real kLargest = 2, kSmallest = Real(0.05);
constexpr Real kSlack = Real(1e-4);  // of a flat body, whose moments are rounded
constexpr Real kTiny = Real(1e-6);
constexpr int kMaxIterations = 60;

// The largest root of det(x 1 - I) by Newton's method, which comes down to it from the trace without overshooting.
Real largest_moment(const Sym3& I)
{
    const Real t = I.xx + I.yy + I.zz;
    const Real s = I.xx * I.yy + I.yy * I.zz + I.zz * I.xx - I.xy * I.xy - I.yz * I.yz - I.xz * I.xz;
    const Real d = determinant(full(I));
    Real x = t;
    for (int i = 0; i < kMaxIterations; ++i) {
        const Real slope = (3 * x - 2 * t) * x + s;
        const Real step = slope > 0 ? (((x - t) * x + s) * x - d) / slope : 0;
        if (!(step > kTiny * t)) break;
        x -= step;
    }
    return x;
}

}  // namespace

const char* const k_text_of_inertia =
    "the body's inertia is not of the size of its geoms: it rotates far too easily or hardly at all; set the "
    "mass with dMassSetBox() and its sisters for the shape it has";

const char* const k_text_of_unphysical_inertia =
    "the body's inertia is not that of any real body: its largest moment is larger than the sum of the other "
    "two, so it tumbles as nothing does; check the order and units of the numbers, or set the mass with "
    "dMassSetBox() and its sisters";

void find_inertia(const StepFacts& facts)
{
    facts.for_each_body([&](Body& body, const BodyBefore&) {
        const Sym3& I = body.inertia;
        const Real reach = extent_of(body).reach;
        const Real k = std::sqrt((I.xx + I.yy + I.zz) / (2 * body.mass.mass));
        Finding one{.kind = dDiagnosisInertia, .severity = dSeverityWarning, .body = to_handle(&body)};
        one.threshold = double(kLargest), one.figure = reach > 0 ? double(k / reach) : 0;
        const Real largest = largest_moment(I), others = I.xx + I.yy + I.zz - largest;
        if (largest > (1 + kSlack) * others) {
            one.threshold = kUnphysical, one.figure = double(largest / std::max(others, kTiny * largest));
            return facts.findings.add(one);
        }
        if (reach > 0 && k < kSmallest * reach)
            one.figure = double(reach / k), one.threshold = double(1 / kSmallest);
        if (one.figure > one.threshold) facts.findings.add(one);
    });
}

}  // namespace epode
