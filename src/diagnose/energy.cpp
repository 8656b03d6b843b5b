// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Energy from nowhere, by the step's energy ledger: what the correction of positions, rigid joints, contacts and
// the integration have added. Work of gravity, of the program and of drives is not among it, so worlds with
// motors are judged like others. Below half of what bodies have, are given in the step or gain in thirty steps of
// falling, nothing is said: piles settle with as much.
#include <cmath>

#include "diagnose/cause.h"

namespace epode {
namespace {

constexpr double kGain = 0.5;
constexpr double kMaxFigure = 1e9;

double from_nowhere(const dEnergyLedger& l)
{
    return l.correction + l.joints + l.integration + l.impacts + l.friction;
}

}  // namespace

const char* const k_text_of_energy =
    "a step made energy out of nothing; look at the causes before this one, try a shorter step, or step with "
    "dWorldStep()";

void find_energy(const StepFacts& facts)
{
    double mass = 0, fastest = 0;
    Body* quickest = nullptr;
    facts.for_each_body([&](Body& body, const BodyBefore& b) {
        mass += double(body.mass.mass);
        const double speed = double(length2(body.velocity() - b.v));
        if (speed > fastest) fastest = speed, quickest = &body;
    });
    const double fall = 30 * double(length(facts.world.gravity) * facts.h);
    const double given = std::fabs(facts.ledger.drives) + std::fabs(facts.ledger.forces);
    const double scale = facts.ledger.kinetic_before + given + 0.5 * mass * fall * fall;
    const double gain = from_nowhere(facts.ledger);
    if (!quickest || !(gain > kGain * scale)) return;
    facts.findings.add({.kind = dDiagnosisEnergy,
                        .severity = dSeverityWarning,
                        .body = to_handle(quickest),
                        .figure = scale * kMaxFigure > gain ? gain / scale : kMaxFigure,
                        .threshold = kGain});
}

}  // namespace epode
