// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints that cannot hold together leave an error that no step removes: the solvers share it out. Only joints
// that close a loop (or connect two bodies twice) can contradict each other: those of a component of the graph
// of bodies and joints that has a cycle, what does not move being one node. The error is that of the rows that
// lock, at the pose that the step has left; soft rows keep theirs by intention. Sweeps that have not converged
// leave errors in joints that fit together: where residuals are not small all along it is no more than a note.
// So do loads that come and go, in substeps, whose joints give way a little: an error that grows is theirs. So
// does fast motion: an arm r that rotates at w leaves its circle by r (h w)^2 / 2 in each step, of which the next
// ones remove the share ERP.
#include "diagnose/cause.h"

#include <algorithm>
#include <cmath>

#include "joints/drive_rows.h"
#include "rows/row_writer.h"

namespace epode {
namespace {

constexpr Real kGapOpen = Real(1e-3), kGapTorn = Real(1e-2);  // m, rad
constexpr Real kPersists = Real(0.97);                        // of the error, after a step; ERP removes more
constexpr double kSolved = 1e-6;                              // residual of the step
constexpr int kPatience = 10;                                 // steps
constexpr Real kMotion = 2;                                   // times the error that motion explains

constexpr Real kLeastErp = Real(0.05);

struct LockedError {
    Real worst = 0;      // m or rad
    Real by_motion = 0;  // what fast rotation explains
};

Real drift_of(const Body* body, Vec3 arm, Real h)
{
    return body ? length(arm) * length2(body->angular_velocity()) * h * h / 2 : 0;
}

LockedError locked_error(Joint& joint, const StepInfo& info)
{
    Row rows[kMaxBlockRows];
    RowWriter out(rows, info);
    joint.type->emit(joint, out);
    LockedError error;
    for (int i = 0; i < out.count(); ++i) {
        const Row& row = rows[i];
        if (row.kind != RowKind::kLock || row.soft || row.erp < kLeastErp) continue;
        error.worst = std::max(error.worst, std::fabs(row.error));
        const Real drift =
            drift_of(joint.body1(), row.ang1, info.h) + drift_of(joint.body2(), row.ang2, info.h);
        error.by_motion = std::max(error.by_motion, drift / row.erp);
    }
    return error;
}

bool takes_part(const StepFacts& facts, const Joint& joint)
{
    for (const JointNode& node : joint.node)
        if (node.body && !StepFacts::of(facts.before, *node.body)) return false;
    return acting(joint) && !is_contact(joint);
}

// Node of the graph: 0 is what does not move.
int node_of(const Body* body) { return body && !body->kinematic() ? body->place + 1 : 0; }

int root_of(std::span<GraphNode> nodes, int i)
{
    while (nodes[std::size_t(i)].parent != i)
        i = nodes[std::size_t(i)].parent = nodes[std::size_t(nodes[std::size_t(i)].parent)].parent;
    return i;
}

void mark_loops(const StepFacts& facts, std::span<GraphNode> nodes)
{
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = {int(i), false};
    for (const Joint& joint : facts.world.joints) {
        if (!takes_part(facts, joint)) continue;
        const int a = root_of(nodes, node_of(joint.body1())), b = root_of(nodes, node_of(joint.body2()));
        GraphNode& kept = nodes[std::size_t(std::min(a, b))];
        kept.loop = kept.loop || nodes[std::size_t(std::max(a, b))].loop || a == b;
        nodes[std::size_t(std::max(a, b))].parent = std::min(a, b);
    }
}

}  // namespace

bool closes_loop(const StepFacts& facts, const Joint& joint)
{
    return takes_part(facts, joint) &&
           facts.graph[std::size_t(root_of(facts.graph, node_of(joint.body1())))].loop;
}

const char* const k_text_of_contradiction =
    "joints that close a loop ask for what no pose can give, and stay open; check anchors, axes and the "
    "pose in which they were attached, leave one out, or give one CFM";

void find_contradiction(const StepFacts& facts)
{
    StepInfo info;
    info.h = facts.h, info.fps = 1 / facts.h, info.erp = facts.world.erp, info.cfm = facts.world.cfm;
    info.inner = true;  // joints keep what they have decided
    const bool solved = facts.report.residual < kSolved;
    mark_loops(facts, facts.graph);
    for (Joint& joint : facts.world.joints) {
        if (joint.place < 0 || std::size_t(joint.place) >= facts.joint_errors.size()) continue;
        JointError& known = facts.joint_errors[std::size_t(joint.place)];
        const bool loops = closes_loop(facts, joint);
        const LockedError locked = loops ? locked_error(joint, info) : LockedError{};
        const Real error = locked.worst;
        const bool persists =
            known.id == to_handle(&joint) && error > kGapOpen && error > kPersists * known.error;
        const bool rests = persists && solved && error < known.error / kPersists;
        known = {to_handle(&joint), error, persists ? known.steps + 1 : 0, rests ? known.at_rest + 1 : 0};
        if (known.steps < kPatience) continue;
        facts.findings.add({.kind = dDiagnosisContradiction,
                            .severity = known.at_rest < kPatience || error < kMotion * locked.by_motion
                                            ? dSeverityNote
                                        : error > kGapTorn ? dSeverityError
                                                           : dSeverityWarning,
                            .body = to_handle(joint.body1()),
                            .other = joint.body2() ? to_handle(joint.body2()) : nullptr,
                            .joint = to_handle(&joint),
                            .figure = double(error),
                            .threshold = double(kGapOpen)});
    }
}

}  // namespace epode
