// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A step resolves a rotation, or a swing, of less than about a radian: h |w| for bodies whose inertia is not
// the same about all axes; and h sqrt(F r / I) for a body that carries the force F on the arm r through its
// joints, which swings about the load's line like a pendulum (the whip: step/island/positions/tension has the derivation).
// A step that holds the directions of forces fixed lets it swing through its rest position ever farther. Of this
// only a joint that has come open is proof, above three radians; substeps turn the forces along, and the
// projection raises the inertia. In loops joints may pull on each other for nothing, so they are left out.
#include "diagnose/cause.h"

#include <algorithm>
#include <cmath>

#include "joints/drive_rows.h"
#include "rows/row_writer.h"

namespace epode {
namespace {

constexpr Real kTurnFar = 1, kTurnAbsurd = 3;
constexpr double kOpen = 1e-2, kTorn = 1e-1;  // m, of a joint

bool is_round(const Sym3& I) { return I.xx == I.yy && I.yy == I.zz && I.xy == 0 && I.xz == 0 && I.yz == 0; }

// Adds h |P| r of a joint, P = h F, to the bodies that it holds.
void add_load(const StepFacts& facts, const StepInfo& info, Joint& joint)
{
    Row rows[kMaxBlockRows];
    RowWriter out(rows, info);
    joint.type->emit(joint, out);
    if (joint.impulse_rows != out.count()) return;
    Vec3 P;
    Real arm[2] = {0, 0};
    for (int i = 0; i < out.count(); ++i) {
        if (rows[i].lin1 == Vec3{}) continue;
        P += impulses(joint)[i] * rows[i].lin1;
        arm[0] = std::max(arm[0], length(rows[i].ang1));
        arm[1] = std::max(arm[1], length(rows[i].ang2));
    }
    for (int k = 0; k < 2; ++k)
        if (const Body* body = joint.node[k].body)
            facts.swings[std::size_t(body->place)] += facts.h * length(P) * arm[k];
}

bool has_substeps(const StepFacts& facts)
{
    return std::any_of(facts.islands.begin(), facts.islands.end(), [](const dIslandStepReport& island) {
        return island.method == dIslandMethodSubsteps || island.method == dIslandMethodSubstepsExactJoints;
    });
}

void find_whips(const StepFacts& facts)
{
    if (facts.world.projection_iterations > 0 || facts.world.exact_substeps > 1 || has_substeps(facts))
        return;
    StepInfo info;
    info.h = facts.h, info.fps = 1 / facts.h, info.erp = facts.world.erp, info.cfm = facts.world.cfm;
    info.inner = true;  // joints keep what they have decided
    std::fill(facts.swings.begin(), facts.swings.end(), Real(0));
    for (Joint& joint : facts.world.joints)
        if (acting(joint) && !is_contact(joint) && joint.impulse_rows > 0 && !closes_loop(facts, joint))
            add_load(facts, info, joint);
    facts.for_each_body([&](Body& body, const BodyBefore&) {
        const Sym3& I = body.inertia;
        const Real angle =
            std::sqrt(facts.swings[std::size_t(body.place)] / std::max(I.xx, std::max(I.yy, I.zz)));
        if (!(angle > kTurnFar)) return;
        const double open = angle > kTurnAbsurd ? facts.report.joint_error : 0;
        facts.findings.add({.kind = dDiagnosisStepTooLong,
                            .severity = open > kTorn   ? dSeverityError
                                        : open > kOpen ? dSeverityWarning
                                                       : dSeverityNote,
                            .body = to_handle(&body),
                            .figure = double(angle),
                            .threshold = double(kTurnFar)});
    });
}

}  // namespace

const char* const k_text_of_step_too_long =
    "the body rotates, or would swing under the load of its joints, by more than a radian in a step, which "
    "is "
    "not resolved; use a shorter step or dWorldStepHybrid(); for fast spin dWorldSetExactRotation() or "
    "dBodySetMaxAngularSpeed(), for light links under heavy loads dWorldSetStepProjection()";

void find_step_too_long(const StepFacts& facts)
{
    find_whips(facts);
    facts.for_each_body([&](Body& body, const BodyBefore& b) {
        const Real angle = facts.h * length(b.w);
        if (!(angle > kTurnFar) || is_round(body.inertia)) return;
        facts.findings.add({.kind = dDiagnosisStepTooLong,
                            .severity = angle > kTurnAbsurd ? dSeverityError : dSeverityWarning,
                            .body = to_handle(&body),
                            .figure = double(angle),
                            .threshold = double(kTurnFar)});
    });
}

}  // namespace epode
