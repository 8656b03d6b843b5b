// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A contact is found once in a step. What approaches by more than a thickness per step is found so deep
// that the normal may point to the wrong side, or not at all.
#include "diagnose/cause.h"

#include <algorithm>

#include "collide/geom.h"
#include "ode/shapes.h"
#include "step/common/link.h"

namespace epode {
namespace {

constexpr Real kFast = 2;

bool is_continuous(const Body* body)
{
    bool any = false;
    if (body) for_each_geom(*body, [&](Geom& geom) { any = any || geom.continuous == dContinuousOn; });
    return any;
}

}  // namespace

const char* const k_text_of_impact =
    "the bodies meet so fast that a step carries one through its thickness; use dGeomSetContinuous(), "
    "a shorter step or thicker geoms";

void find_impact(const StepFacts& facts)
{
    for (const Touch& touch : facts.touches) {
        Real half = extent_of(*touch.a).half_thickness;
        if (touch.b) half = std::min(half, extent_of(*touch.b).half_thickness);
        const Real figure = approach_of(facts, touch) * facts.h / half;
        if (!(figure > kFast) || is_continuous(touch.a) || is_continuous(touch.b)) continue;
        facts.findings.add({.kind = dDiagnosisImpact,
                            .severity = figure > 2 * kFast ? dSeverityError : dSeverityWarning,
                            .body = to_handle(touch.a),
                            .other = touch.b ? to_handle(touch.b) : nullptr,
                            .figure = double(figure),
                            .threshold = double(kFast)});
    }
}

}  // namespace epode
