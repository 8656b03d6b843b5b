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
constexpr double kUnsolved = 1e-3, kUnsolvedTorn = 1e-2;

void add(Neighbours& n, const Body* other)
{
    if (other && other->kinematic()) other = nullptr;
    if (n.any && other != n.first) n.two = true;
    if (!n.any) n.first = other, n.any = true;
    if (other && (!n.heaviest || other->mass.mass > n.heaviest->mass.mass)) n.heaviest = other;
}

void join(const StepFacts& facts, const Body* a, const Body* b)
{
    if (a) add(facts.neighbours[std::size_t(a->place)], b);
    if (b) add(facts.neighbours[std::size_t(b->place)], a);
}

}  // namespace

const char* const k_text_of_mass_ratio =
    "a light body carries one that is far heavier, and the iterations do not carry the load through it; step "
    "with dWorldStep() or dWorldStepHybrid(), or make the masses more alike";

void find_mass_ratio(const StepFacts& facts)
{
    for (Neighbours& one : facts.neighbours) one = {};
    for (const Joint& joint : facts.world.joints)
        if (acting(joint) && !is_contact(joint)) join(facts, joint.body1(), joint.body2());
    for (const Touch& touch : facts.touches) join(facts, touch.a, touch.b);
    facts.for_each_body([&](Body& body, const BodyBefore&) {
        const Neighbours& all = facts.neighbours[std::size_t(body.place)];
        const Real ratio = all.two && all.heaviest ? all.heaviest->mass.mass / body.mass.mass : 0;
        if (!(ratio > kRatio)) return;
        const bool unsolved = facts.report.residual > kUnsolved;
        const bool torn =
            unsolved && std::max(facts.report.joint_error, facts.report.penetration) > kUnsolvedTorn;
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
