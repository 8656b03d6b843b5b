// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "solve/exact/small/box_phases.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

constexpr double kMaxTrusted = 1e8;  // times the problem's velocity scale, of an impulse to start from

void guess(const ExactProblem& problem, std::size_t i, double p, bool near, BoxState& state)
{
    const double lo = state.lo[i], hi = state.hi[i], d = problem.row(int(i)).d;
    // The last step's impulse only saves time; one of a different magnitude would cost digits instead.
    if (!(std::fabs(p) * d <= kMaxTrusted * problem.scale())) p = 0;
    state.p[i] = std::min(std::max(p, lo), hi);
    // A range narrower than the rounding of the impulse leaves no freedom.
    if (!((hi - lo) * d > 1e-13 * problem.scale())) {
        state.tag[i] = BoxState::kFixed;
        state.p[i] = state.lo[i];
    } else if ((near || (lo > -HUGE_VAL && lo < 0 && hi < HUGE_VAL && p != 0)) && (p <= lo || p >= hi)) {
        state.tag[i] = p <= lo ? BoxState::kLower : BoxState::kUpper;
    } else {
        state.tag[i] = BoxState::kFree;
    }
}

}  // namespace

bool bound_without_friction(const ExactProblem& problem, const RowSystem& system, BoxState& state)
{
    bool friction = false;
    for (std::size_t i = 0; i < state.p.size(); ++i) {
        const RowNumbers& n = system.numbers[i];
        const bool empty = !(problem.row(int(i)).d > 0);
        friction |= n.parent >= 0;
        state.lo[i] = n.parent >= 0 || empty ? 0 : double(n.lo);
        state.hi[i] = n.parent >= 0 || empty ? 0 : double(n.hi);
        guess(problem, i, double(n.p), system.nearly_solved, state);
    }
    return friction;
}

void freeze_friction(const ExactProblem& problem, const RowSystem& system, BoxState& state)
{
    for (std::size_t i = 0; i < state.p.size(); ++i) {
        const RowNumbers& n = system.numbers[i];
        if (n.parent < 0) continue;
        const double normal = std::fabs(state.p[std::size_t(n.parent)]);
        // An infinite coefficient without normal impulse means no friction, as in ODE.
        state.hi[i] = normal > 0 && problem.row(int(i)).d > 0 ? double(n.hi) * normal : 0;
        state.lo[i] = -state.hi[i];
        guess(problem, i, double(n.p), system.nearly_solved, state);
    }
}

}  // namespace epode
