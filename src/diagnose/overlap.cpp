// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies that did not touch in the step before are in each other deeper than their motion brings them in a
// step, and deeper than half of the thinner one's half thickness: they were put there.
#include "diagnose/cause.h"

#include <algorithm>

namespace epode {
namespace {

constexpr Real kDeep = Real(0.5);

bool is_new(const StepFacts& facts, const Body* body)
{
    return body && !body->kinematic() && !StepFacts::of(facts.after_last, *body);
}

}  // namespace

const char* const k_text_of_overlap =
    "bodies start inside each other and are pushed apart; place them apart, or limit the correcting velocity "
    "with dWorldSetContactMaxCorrectingVel()";

void find_overlap(const StepFacts& facts)
{
    for (const Touch& touch : facts.touches) {
        if (!is_new(facts, touch.a) && !is_new(facts, touch.b)) continue;
        Real half = extent_of(*touch.a).half_thickness;
        if (touch.b) half = std::min(half, extent_of(*touch.b).half_thickness);
        const Real moved = std::max(approach_of(facts, touch), Real(0)) * facts.h;
        if (!(touch.depth > kDeep * half) || touch.depth < 2 * moved) continue;
        facts.findings.add({.kind = dDiagnosisOverlap,
                            .severity = touch.depth > half ? dSeverityError : dSeverityWarning,
                            .body = to_handle(touch.a),
                            .other = touch.b ? to_handle(touch.b) : nullptr,
                            .figure = double(touch.depth / half),
                            .threshold = double(kDeep)});
    }
}

}  // namespace epode
