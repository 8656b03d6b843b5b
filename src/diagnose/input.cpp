// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The program set a velocity, or a force that adds one in a step, beyond all that is simulated: above 10 km/s
// positions lose their digits within minutes and nothing is resolved by a step.
#include "diagnose/cause.h"

#include <algorithm>

namespace epode {
namespace {
constexpr Real kHuge = 1e4, kAbsurd = 1e6;  // m/s or rad/s
}

const char* const k_text_of_input =
    "the program set a huge velocity or force; look where it is computed (a division by a small number, "
    "wrong units, a mass of 0.001)";

void find_input(const StepFacts& facts)
{
    facts.for_each_body([&](Body& body, const BodyBefore& b) {
        const BodyBefore* end = StepFacts::of(facts.after_last, body);
        Real size = std::max(length(b.v - (end ? end->v : Vec3{})), length(b.w - (end ? end->w : Vec3{})));
        size = std::max(size, facts.h * body.inv_mass * length(b.force));
        const Sym3& I = body.inv_inertia;
        size = std::max(size, facts.h * std::min(I.xx, std::min(I.yy, I.zz)) * length(b.torque));
        if (!(size > kHuge)) return;
        facts.findings.add({.kind = dDiagnosisInput,
                            .severity = size > kAbsurd ? dSeverityError : dSeverityWarning,
                            .body = to_handle(&body),
                            .figure = double(size),
                            .threshold = double(kHuge)});
    });
}

}  // namespace epode
