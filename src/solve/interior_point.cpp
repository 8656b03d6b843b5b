// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Mehrotra's predictor-corrector (SIAM J. Optim. 2, 1992). Per finite bound a slack s, a variable of its own
// (p - lo loses all digits near the end), and a multiplier z:
//
//   r1 = M (v* - v) + J^T p      r2 = c - J v - C p + zl - zu
//   rl = p - lo - sl             ru = hi - p - su
//   ds_l = dp + rl,  ds_u = ru - dp,  dz = (t - z ds)/s
//   theta = C + zl/sl + zu/su,  D = 1/theta,  e = r2 + (tl - zl rl)/sl - (tu - zu ru)/su
//   H dv = r1 + J^T D e,  dp = D (e - J dv)
//
// Predictor t = -s z with step a, then t = sigma mu/d - s z - a^2 ds dz with sigma = (mu_aff/mu)^3 (the
// second order counts for as much as the predictor could go: Colombo & Gondzio, Comput. Optim. Appl. 41,
// 2008); rows are weighted by d = J M^-1 J^T + C, so that mu is a velocity squared and rows of different
// kinds agree. Without the centrality correctors (Gondzio, Comput. Optim. Appl. 6, 1996) a few outlying
// products stall it on sliding stacks.
#include "solve/interior_point.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

constexpr int kMostIterations = 60;
constexpr int kPatience = 2;  // iterations without a tenth of progress before recentring
constexpr int kStall = 12;    // and before giving up
constexpr double kStepShare = 0.995;
constexpr int kCorrectors = 3;
constexpr double kLonger = 0.3;  // step that a corrector tries to gain

}  // namespace

bool InteriorPoint::prepare(const ExactProblem& problem, Arena& arena)
{
    rows_ = arena.take<RowState>(problem.row_count());
    D_ = arena.take<double>(problem.row_count());
    r1_ = arena.take<double>(problem.unknowns());
    dv_ = arena.take<double>(problem.unknowns());
    return !arena.failed();
}

bool InteriorPoint::solve(ExactProblem& problem, BoxState& state, double tolerance, int& iterations)
{
    start(problem, state);
    // Progress is counted from these marks; at a degenerate solution the measure only falls like the root of
    // mu.
    double mark = HUGE_VAL, mu_mark = HUGE_VAL, step = 1;
    int stall = 0;
    bool reached = false;
    for (int k = 0; k < kMostIterations; ++k) {
        const double measure = residuals(problem, state), mu = complementarity(problem, 0);
        reached = measure <= tolerance * problem.scale();
        stall = measure < 0.9 * mark || mu < 0.5 * mu_mark ? 0 : stall + 1;
        if (stall == 0) mark = std::min(mark, measure), mu_mark = std::min(mu_mark, mu);
        if (reached || stall >= kStall || !(measure < HUGE_VAL)) break;
        ++iterations;
        factor(problem, state);
        const bool cramped = stall >= kPatience && step < 0.9;
        const double target = cramped ? recentre(problem, state) : aim(problem, state);
        correct_centrality(problem, state, target);
        step = std::min(1.0, kStepShare * longest_step());
        advance(state, step);
    }
    tag(problem, state);
    return reached;
}

// Predictor and corrector; returns the complementarity aimed at.
double InteriorPoint::aim(ExactProblem& problem, const BoxState& state)
{
    for (RowState& row : rows_)
        for (Side* side : {&row.lower, &row.upper}) side->t = -side->s * side->z;
    direction(problem, state);
    const double mu = complementarity(problem, 0);
    const double reach = std::min(1.0, longest_step());
    const double affine = complementarity(problem, reach);
    const double ratio = mu > 0 ? affine / mu : 0;
    const double target = ratio * ratio * ratio * mu;
    for (std::size_t i = 0; i < rows_.size(); ++i)
        for (Side* side : {&rows_[i].lower, &rows_[i].upper})
            side->t =
                target / problem.row(int(i)).d - side->s * side->z - reach * reach * side->ds * side->dz;
    direction(problem, state);
    return target;
}

// Where predictor and corrector no longer get on, a few products are far off the mean: back towards the
// middle.
double InteriorPoint::recentre(ExactProblem& problem, const BoxState& state)
{
    const double target = 0.5 * complementarity(problem, 0);
    for (std::size_t i = 0; i < rows_.size(); ++i)
        for (Side* side : {&rows_[i].lower, &rows_[i].upper})
            side->t = target / problem.row(int(i)).d - side->s * side->z;
    direction(problem, state);
    return target;
}

void InteriorPoint::start(const ExactProblem& problem, BoxState& state)
{
    const double scale = problem.scale();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        RowState& row = rows_[i];
        row = {};
        const double d = problem.row(int(i)).d;
        if (state.tag[i] == BoxState::kFixed) {
            state.p[i] = state.lo[i];
            continue;
        }
        row.lower.present = state.lo[i] > -HUGE_VAL;
        row.upper.present = state.hi[i] < HUGE_VAL;
        const double margin = std::min(0.5 * (state.hi[i] - state.lo[i]), 0.1 * scale / d);
        state.p[i] = std::min(std::max(state.p[i], state.lo[i] + margin), state.hi[i] - margin);
        const auto place = [&](Side& side, double s) {
            side.s = side.present ? s : 1;
            side.z = side.present ? std::min(0.01 * scale * scale / (d * s), 10 * scale) : 0;
        };
        place(row.lower, state.p[i] - state.lo[i]);
        place(row.upper, state.hi[i] - state.p[i]);
    }
    problem.velocities(state.p, state.v);
    // What the rows' velocities lack at this point, multipliers of the right sign take over.
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (state.tag[i] == BoxState::kFixed) continue;
        const ExactRow& row = problem.row(int(i));
        const double w = ExactProblem::jv(row, state.v.data()) + row.C * state.p[i] - row.c;
        if (rows_[i].lower.present && w > 0) rows_[i].lower.z += w;
        if (rows_[i].upper.present && w < 0) rows_[i].upper.z -= w;
    }
}

double InteriorPoint::residuals(const ExactProblem& problem, const BoxState& state)
{
    problem.momentum_change(state.v, r1_);
    double worst = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const ExactRow& row = problem.row(int(i));
        if (state.p[i] != 0) ExactProblem::add_jt(row, state.p[i], r1_.data());
        if (state.tag[i] == BoxState::kFixed) continue;
        RowState& x = rows_[i];
        x.r2 = row.c - ExactProblem::jv(row, state.v.data()) - row.C * state.p[i] + x.lower.z - x.upper.z;
        x.lower.r = x.lower.present ? state.p[i] - state.lo[i] - x.lower.s : 0;
        x.upper.r = x.upper.present ? state.hi[i] - state.p[i] - x.upper.s : 0;
        worst = std::max(worst, std::fabs(x.r2));
        for (const Side* side : {&x.lower, &x.upper})
            if (side->present) worst = std::max(worst, std::min(side->s * row.d, side->z));
    }
    return worst;
}

// Mean of s z over all bounds after a step of the present direction, as velocity squared.
double InteriorPoint::complementarity(const ExactProblem& problem, double step) const
{
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i)
        for (const Side* side : {&rows_[i].lower, &rows_[i].upper}) {
            if (!side->present) continue;
            sum += (side->s + step * side->ds) * (side->z + step * side->dz) * problem.row(int(i)).d;
            ++count;
        }
    return count ? sum / count : 0;
}

void InteriorPoint::factor(ExactProblem& problem, const BoxState& state)
{
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const ExactRow& row = problem.row(int(i));
        const RowState& x = rows_[i];
        const double theta = row.C + x.lower.z / x.lower.s + x.upper.z / x.upper.s;
        D_[i] = state.tag[i] == BoxState::kFixed ? 0 : 1 / std::max(theta, row.weight_min);
    }
    problem.factor(D_);
}

void InteriorPoint::direction(ExactProblem& problem, const BoxState& state)
{
    std::copy(r1_.begin(), r1_.end(), dv_.begin());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (state.tag[i] == BoxState::kFixed) continue;
        RowState& x = rows_[i];
        x.e = x.r2;
        if (x.lower.present) x.e += (x.lower.t - x.lower.z * x.lower.r) / x.lower.s;
        if (x.upper.present) x.e -= (x.upper.t - x.upper.z * x.upper.r) / x.upper.s;
        ExactProblem::add_jt(problem.row(int(i)), D_[i] * x.e, dv_.data());
    }
    problem.solve(dv_);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (state.tag[i] == BoxState::kFixed) continue;
        RowState& x = rows_[i];
        x.dp = D_[i] * (x.e - ExactProblem::jv(problem.row(int(i)), dv_.data()));
        const auto finish = [](Side& side, double ds) {
            if (!side.present) return;
            side.ds = ds;
            side.dz = (side.t - side.z * ds) / side.s;
        };
        finish(x.lower, x.dp + x.lower.r);
        finish(x.upper, x.upper.r - x.dp);
    }
}

// Gondzio's correctors: where a longer step would leave products far from the target, aim at the nearest
// bound of [1/10, 10] of it instead; each costs one more solution with the same factor. They are kept only
// while they lengthen the step.
void InteriorPoint::correct_centrality(ExactProblem& problem, const BoxState& state, double target)
{
    double step = longest_step();
    for (int k = 0; k < kCorrectors && step < 1; ++k) {
        const double wanted = std::min(1.0, step + kLonger);
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            const double aim = target / problem.row(int(i)).d;
            for (Side* side : {&rows_[i].lower, &rows_[i].upper}) {
                side->kept = side->t;
                if (!side->present) continue;
                const double product = (side->s + wanted * side->ds) * (side->z + wanted * side->dz);
                const double inside = std::min(std::max(product, 0.1 * aim), 10 * aim);
                side->t += std::max(inside - product, -10 * aim);
            }
        }
        direction(problem, state);
        const double longer = longest_step();
        if (longer < step + 0.1 * kLonger) {
            for (RowState& row : rows_) row.lower.t = row.lower.kept, row.upper.t = row.upper.kept;
            direction(problem, state);
            return;
        }
        step = longer;
    }
}

// Up to which all slacks and multipliers stay positive.
double InteriorPoint::longest_step() const
{
    double step = 1 / kStepShare;
    for (const RowState& row : rows_)
        for (const Side* side : {&row.lower, &row.upper}) {
            if (!side->present) continue;
            if (side->ds < 0) step = std::min(step, -side->s / side->ds);
            if (side->dz < 0) step = std::min(step, -side->z / side->dz);
        }
    return step;
}

void InteriorPoint::advance(BoxState& state, double step)
{
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        RowState& x = rows_[i];
        if (state.tag[i] == BoxState::kFixed) continue;
        state.p[i] += step * x.dp;
        for (Side* side : {&x.lower, &x.upper}) {
            if (!side->present) continue;
            side->s += step * side->ds;
            side->z += step * side->dz;
        }
    }
    for (std::size_t i = 0; i < state.v.size(); ++i) state.v[i] += step * dv_[i];
}

void InteriorPoint::tag(const ExactProblem& problem, BoxState& state) const
{
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const RowState& x = rows_[i];
        if (state.tag[i] == BoxState::kFixed) continue;
        const double d = problem.row(int(i)).d;
        state.tag[i] = BoxState::kFree;
        if (x.lower.present && x.lower.s * d < x.lower.z) {
            state.tag[i] = BoxState::kLower;
            state.p[i] = state.lo[i];
        } else if (x.upper.present && x.upper.s * d < x.upper.z) {
            state.tag[i] = BoxState::kUpper;
            state.p[i] = state.hi[i];
        }
    }
}

}  // namespace epode
