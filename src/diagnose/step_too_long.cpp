// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A step resolves a rotation, or a swing, of less than about a radian: h |w| for bodies whose inertia is not
// the same about all axes.
#include "diagnose/cause.h"

namespace epode {
namespace {

constexpr Real kFar = 1, kAbsurd = 3;

bool is_round(const Sym3& I) { return I.xx == I.yy && I.yy == I.zz && I.xy == 0 && I.xz == 0 && I.yz == 0; }

}  // namespace

const char* const k_text_of_step_too_long =
    "the body rotates by more than a radian in a step, which cannot be resolved; use a shorter step, "
    "dWorldSetExactRotation(), or limit its spin with dBodySetMaxAngularSpeed()";

void find_step_too_long(const StepFacts& facts)
{
    facts.for_each_body([&](Body& body, const BodyBefore& b) {
        const Real angle = facts.h * length(b.w);
        if (!(angle > kFar) || is_round(body.inertia)) return;
        facts.findings.add({.kind = dDiagnosisStepTooLong,
                            .severity = angle > kAbsurd ? dSeverityError : dSeverityWarning,
                            .body = to_handle(&body),
                            .figure = double(angle),
                            .threshold = double(kFar)});
    });
}

}  // namespace epode
