// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies that the program has made or moved since the step before are in each other deeper than their motion
// brings them in a step, and deeper than half of the thinner one's half thickness: they were put there.
#include "diagnose/cause.h"

#include <algorithm>

namespace epode {
namespace {

constexpr Real kDeep = Real(0.5);

bool was_placed(const StepFacts& facts, const Body* body)
{
    const BodyBefore* now = body && !body->kinematic() ? StepFacts::of(facts.before, *body) : nullptr;
    const BodyBefore* end = now ? StepFacts::of(facts.after_last, *body) : nullptr;
    return now && (!end || !(end->x == now->x));
}

}  // namespace

const char* const k_text_of_overlap =
    "bodies start inside each other and are pushed apart; place them apart, or limit the correcting velocity "
    "with dWorldSetContactMaxCorrectingVel()";

void find_overlap(const StepFacts& facts)
{
    for (const Touch& touch : facts.touches) {
        if (!was_placed(facts, touch.a) && !was_placed(facts, touch.b)) continue;
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
