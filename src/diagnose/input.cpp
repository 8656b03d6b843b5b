// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The program set a velocity, or a force that adds one in a step, beyond all that is simulated: above 10 km/s
// positions lose their digits within minutes and nothing is resolved by a step. Or it called a function with a
// number that is not finite, or with another argument that was refused, so that the world lacks what was meant.
#include "diagnose/cause.h"

#include <algorithm>

#include "diagnose/text.h"
#include "dynamics/joint.h"

namespace epode {
namespace {
constexpr Real kHuge = 1e4, kAbsurd = 1e6;  // m/s or rad/s
}

const char* const k_text_of_input =
    "the program set a huge velocity or force; look where it is computed (a division by a small number, "
    "wrong units, a mass of 0.001)";

const char* const k_text_of_refusal =
    "was called with an argument that was refused (not finite, huge, out of range, or a handle of nothing), "
    "so it "
    "changed nothing; look where the argument is computed";

namespace {

template <typename Object, typename Id>
Id living(Id id)
{
    return from_handle<Object>(id) ? id : nullptr;
}

void find_refusals(const StepFacts& facts)
{
    for (const Refusal& one : facts.refusals) {
        int same = 0;
        for (const Refusal& other : facts.refusals) same += other.call == one.call;
        if (!name_of_call(one.call)) continue;
        facts.findings.add({.kind = dDiagnosisInput,
                            .severity = dSeverityWarning,
                            .body = living<Body>(one.body),
                            .joint = living<Joint>(one.joint),
                            .figure = double(same),
                            .call = one.call});
    }
}

}  // namespace

void find_input(const StepFacts& facts)
{
    find_refusals(facts);
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
