// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A light body on the load path: it touches or is jointed to two others (or one and the world), one of them a
// hundred times as heavy. Exact solvers carry that; sweeps do not, which the residual of the step shows.
#include "diagnose/cause.h"

#include <algorithm>

namespace epode {
namespace {

constexpr Real kRatio = 100;
constexpr double kUnsolved = 1e-3, kTorn = 1e-2;

// What a body hangs on: its heaviest neighbour, and whether it has another one.
struct Neighbours {
    const Body* heaviest = nullptr;
    const Body* first = nullptr;
    bool any = false, two = false;

    void add(const Body* other)
    {
        if (other && other->kinematic()) other = nullptr;
        if (any && other != first) two = true;
        if (!any) first = other, any = true;
        if (other && (!heaviest || other->mass.mass > heaviest->mass.mass)) heaviest = other;
    }
};

}  // namespace

const char* const k_text_of_mass_ratio =
    "a light body carries one that is far heavier, and the iterations do not carry the load through it; step "
    "with dWorldStep() or dWorldStepHybrid(), or make the masses more alike";

void find_mass_ratio(const StepFacts& facts)
{
    facts.for_each_body([&](Body& body, const BodyBefore&) {
        Neighbours all;
        for (const JointNode* n = body.joints; n; n = n->next)
            if (acting(*n->joint)) all.add(n->joint->node[n == &n->joint->node[0] ? 1 : 0].body);
        for (const Touch& t : facts.touches)
            if (t.a == &body || t.b == &body) all.add(t.a == &body ? t.b : t.a);
        const Real ratio = all.two && all.heaviest ? all.heaviest->mass.mass / body.mass.mass : 0;
        if (!(ratio > kRatio)) return;
        const bool unsolved = facts.report.residual > kUnsolved;
        const bool torn = unsolved && std::max(facts.report.joint_error, facts.report.penetration) > kTorn;
        facts.findings.add({.kind = dDiagnosisMassRatio,
                            .severity = torn       ? dSeverityError
                                        : unsolved ? dSeverityWarning
                                                   : dSeverityNote,
                            .body = to_handle(&body),
                            .other = to_handle(all.heaviest),
                            .figure = double(ratio),
                            .threshold = double(kRatio)});
    });
}

}  // namespace epode
