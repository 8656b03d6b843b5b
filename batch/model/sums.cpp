// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See sums.h. The rows of a sum are in lanes/sums.h.
#include "batch/model/sums.h"

#include <algorithm>
#include <set>

#include "batch/model/loops.h"
#include "robots/bend.h"

namespace epode::batch {

using namespace robots;

namespace {

constexpr double kNoBound = 1e30;

// Returns where they begin.
int add_terms(BatchModel& out, const std::vector<Coupling::Term>& terms, std::set<int>& moved)
{
    const int first = int(out.sum_terms.size());
    for (const Coupling::Term& term : terms) {
        if (term.factor == 0) continue;
        const BatchJoint& joint = out.joints[size_t(term.joint)];
        out.sum_terms.push_back({joint.dof, joint.position, int(out.numbers.size())});
        out.numbers.push_back(term.factor);
        const Dof& dof = out.dofs[size_t(joint.dof)];
        moved.insert(&out.chains[size_t(dof.chain)], &out.chains[size_t(dof.chain)] + dof.depth + 1);
    }
    return first;
}

void add_bend(BatchModel& out, const RobotModel& model, const Bend& bend, BatchSum& sum, std::set<int>& moved)
{
    sum.first_inner = add_terms(out, bend.inner, moved);
    sum.inner = int(out.sum_terms.size()) - sum.first_inner;
    if (bend.powers.empty()) return;
    double zero = 0;
    for (const Coupling::Term& term : bend.inner)
        zero += term.factor * model.joints[size_t(term.joint)].reference;
    sum.curve = int(out.numbers.size());
    out.numbers.push_back(zero);
    for (size_t i = 0; i + 1 < curve_number::kCount; ++i)
        out.numbers.push_back(i < bend.powers.size() ? bend.powers[i] : 0);
}

struct Acts {
    double low = -kNoBound, high = kNoBound, rest = 0, stiffness = 0, damping = 0, limit = kNoBound;
};

void add_sum(BatchModel& out, const RobotModel& model, BatchSum sum, const std::vector<Coupling::Term>& terms,
             const Bend& bend, const Acts& acts, bool is_driven)
{
    std::set<int> moved;
    sum.first_term = add_terms(out, terms, moved);
    sum.terms = int(out.sum_terms.size()) - sum.first_term;
    add_bend(out, model, bend, sum, moved);
    const std::vector<int> wide = widened(out, {moved.begin(), moved.end()});
    moved.insert(wide.begin(), wide.end());
    sum.support = int(out.sum_dofs.size()), sum.width = int(moved.size());
    sum.places = add_places(out, {moved.begin(), moved.end()});
    out.sum_dofs.insert(out.sum_dofs.end(), moved.begin(), moved.end());
    sum.first = int(out.numbers.size());
    out.numbers.insert(out.numbers.end(),
                       {acts.low, acts.high, acts.rest, acts.stiffness, acts.damping, acts.limit});
    if (sum.is_equality || acts.low > -kNoBound || acts.high < kNoBound) sum.stop = out.sum_rows++;
    if (is_driven) sum.drive = out.sum_rows++;
    out.sums.push_back(sum);
}

void add_tendon(BatchModel& out, const Prepared& prepared, size_t number)
{
    const Tendon& tendon = prepared.model().tendons[number];
    Acts acts{std::max(tendon.low, -kNoBound),
              std::min(tendon.high, kNoBound),
              prepared.rests()[number][0],
              tendon.stiffness,
              tendon.damping,
              kNoBound};
    bool is_driven = tendon.stiffness > 0 || tendon.damping > 0;
    for (const Actuator& a : prepared.model().actuators) {
        if (a.tendon != int(number) || (a.bias_position == 0 && a.bias_velocity == 0)) continue;
        is_driven = true;
        acts.limit = std::min(acts.limit, std::fabs(a.gear) * std::max(-a.force_low, a.force_high));
    }
    add_sum(out, prepared.model(), {}, tendon.terms, {}, acts, is_driven);
}

}  // namespace

std::vector<int> add_sums(BatchModel& out, const Prepared& prepared)
{
    const RobotModel& model = prepared.model();
    for (const Coupling& coupling : model.couplings) {
        BatchSum sum;
        sum.is_equality = true;
        Acts acts;
        acts.low = acts.high = coupling.offset;
        add_sum(out, model, sum, coupling.terms, bend_of(model, coupling), acts, false);
    }
    std::vector<int> of_tendons(model.tendons.size(), -1);
    for (size_t i = 0; i < model.tendons.size(); ++i) {
        if (!model.tendons[i].path.empty()) continue;
        of_tendons[i] = int(out.sums.size());
        add_tendon(out, prepared, i);
    }
    return of_tendons;
}

}  // namespace epode::batch
