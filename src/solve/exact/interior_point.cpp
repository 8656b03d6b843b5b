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
// Predictor t = -s z, then t = sigma mu/d - s z - ds dz with sigma = (mu_aff/mu)^4; rows are weighted by d =
// J M^-1 J^T + C, so that mu is a velocity squared and rows of different kinds agree. Without a centrality
// corrector (Gondzio, Comput. Optim. Appl. 6, 1996) a few outlying products stall it on sliding stacks; a
// second one gains less than it costs. On 76 problems of walls and piles these constants take 16.6 iterations
// with 43.6 directions, and 16.0 with 47.2 if there may be two correctors. Not better: a second round of the
// second order on the same factor (15.3 with 57.9), none at all (19.0 with 38.0), ds dz weighted by the
// predictor's step squared (Colombo & Gondzio, Comput. Optim. Appl. 41, 2008: 19.2 with 70.9), a start from
// ten sweeps of Gauss-Seidel (15.8), from the last step's friction (17.2), stopping at 1e-8 for the active
// set to finish (15 and two rounds more; from 1e-6 it often does not). At a redundant solution half of the
// iterations go into the split among rows that only C decides, from mu near C p^2 on.
//
// A direction costs two passes over the rows around the solution with H: one computes t, e and J^T D e, the
// other dp and all sums over the direction, since s dz + z ds = t.
#include "solve/exact/interior_point.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

constexpr int kMaxIterations = 60;
constexpr int kPatience = 2;  // iterations without a tenth of progress before recentring
constexpr int kStall = 12;    // and before giving up
constexpr double kStepShare = 0.9999;
constexpr int kCorrectors = 1;
constexpr double kLonger = 0.3;  // step that a corrector tries to gain
constexpr double kLong = 0.95;   // step that needs no corrector
constexpr int kNumbers = 18;     // arrays per place

}  // namespace

bool InteriorPoint::prepare(const ExactProblem& problem, int places, Arena& arena)
{
    places_ = std::size_t(places);
    numbers_ = arena.take<double>(kNumbers * places);
    kept_dp_ = arena.take<double>(places);
    r1_ = arena.take<double>(problem.unknowns());
    dv_ = arena.take<double>(problem.unknowns());
    kept_dv_ = arena.take<double>(problem.unknowns());
    return !arena.failed();
}

bool InteriorPoint::solve(ExactProblem& problem, PackedRows& rows, std::span<double> v, double tolerance,
                          int& iterations)
{
    packed_ = &rows;
    ahead_ = {};  // there is no direction yet, and nothing times what is not a number is none either
    start(problem, v);
    // Progress is counted from these marks; at a degenerate solution the measure only falls like the root of
    // mu.
    double mark = HUGE_VAL, mu_mark = HUGE_VAL, step = 0;
    int stall = 0;
    bool reached = false;
    for (int k = 0;; ++k) {
        if (step > 0)
            for (std::size_t i = 0; i < v.size(); ++i) v[i] += step * dv_[i];
        rows.momentum_change(problem, v, r1_);
        now_ = rows.kernels().advance(rows_, step, v.data(), r1_.data());
        const double measure = now_.worst, mu = complementarity(0);
        reached = measure <= tolerance * problem.scale();
        stall = measure < 0.9 * mark || mu < 0.5 * mu_mark ? 0 : stall + 1;
        if (stall == 0) mark = std::min(mark, measure), mu_mark = std::min(mu_mark, mu);
        if (reached || stall >= kStall || !(measure < HUGE_VAL) || !(mu < HUGE_VAL)) break;
        if (k == kMaxIterations || problem.gives_up()) break;
        ++iterations;
        rows.factor(problem, {rows_.D, std::size_t(rows.count())});
        const bool cramped = stall >= kPatience && step < 0.9;
        const double target = cramped ? recentre(problem) : aim(problem);
        correct_centrality(problem, target);
        step = std::min(1.0, kStepShare * longest_step());
    }
    tag();
    return reached;
}

void InteriorPoint::lay_out()
{
    double* next = numbers_.data();
    const auto array = [&] {
        double* p = next;
        next += places_;
        return p;
    };
    PackedRows& from = *packed_;
    rows_.groups = from.groups.data(), rows_.group_count = int(from.groups.size());
    rows_.c = from.c.data(), rows_.C = from.C.data();
    rows_.d = from.d.data(), rows_.inv_d = from.inv_d.data();
    rows_.weight_min = from.weight_min.data();
    rows_.p = from.p.data();
    rows_.lo = array(), rows_.hi = array();
    for (InteriorSide* side : {&rows_.lower, &rows_.upper})
        *side = {array(), array(), array(), array(), array(), array()};
    rows_.r2 = array(), rows_.e = array(), rows_.D = array(), rows_.dp = array();
}

void InteriorPoint::move_inside(std::size_t i, double scale)
{
    PackedRows& rows = *packed_;
    const bool real = rows.tag[i] != BoxState::kFixed;
    const bool below = real && rows.lo[i] > -HUGE_VAL, above = real && rows.hi[i] < HUGE_VAL;
    const double d = rows.d[i];
    const double margin = std::min(0.5 * (rows.hi[i] - rows.lo[i]), 0.1 * scale / d);
    if (real) rows.p[i] = std::min(std::max(rows.p[i], rows.lo[i] + margin), rows.hi[i] - margin);
    rows_.lo[i] = below ? rows.lo[i] : 0, rows_.hi[i] = above ? rows.hi[i] : 0;
    const auto place = [&](const InteriorSide& side, bool present, double s) {
        side.present[i] = present;
        side.s[i] = present ? s : 1;
        side.z[i] = present ? std::min(0.01 * scale * scale / (d * s), 10 * scale) : 0;
    };
    place(rows_.lower, below, rows.p[i] - rows.lo[i]);
    place(rows_.upper, above, rows.hi[i] - rows.p[i]);
    bounds_ += below + above;
}

void InteriorPoint::start(const ExactProblem& problem, std::span<double> v)
{
    lay_out();
    PackedRows& rows = *packed_;
    const auto n = std::size_t(rows.count());
    bounds_ = 0;
    // Rows with two bounds start in their middle: friction from the last step is often far off.
    for (std::size_t i = 0; i < n; ++i)
        if (rows.lo[i] > -HUGE_VAL && rows.hi[i] < HUGE_VAL) rows.p[i] = 0.5 * (rows.lo[i] + rows.hi[i]);
    // The velocities are those of the impulses before they are moved off their bounds: the momentum that is
    // then missing costs less than hundreds of contacts that all carry an impulse.
    rows.velocities(problem, r1_, v);
    for (std::size_t i = 0; i < n; ++i) move_inside(i, problem.scale());
    // The rows' velocities at this point, with multipliers of the right sign.
    const std::span<double> w(rows_.e, n);
    rows.products(v, w);
    for (std::size_t i = 0; i < n; ++i) {
        w[i] += rows.C[i] * rows.p[i] - rows.c[i];
        if (rows_.lower.present[i] > 0 && w[i] > 0) rows_.lower.z[i] += w[i];
        if (rows_.upper.present[i] > 0 && w[i] < 0) rows_.upper.z[i] -= w[i];
    }
}

// `add_target` computes t and e and adds J^T D e to its argument.
template <typename AddTarget>
void InteriorPoint::direction(ExactProblem& problem, const AddTarget& add_target)
{
    std::copy(r1_.begin(), r1_.end(), dv_.begin());
    add_target(dv_.data());
    problem.solve(dv_);
    ahead_ = packed_->kernels().finish(rows_, dv_.data());
}

// Mean of s z over all bounds after a step of the present direction, as velocity squared.
double InteriorPoint::complementarity(double step) const
{
    if (bounds_ == 0) return 0;
    const double sum = now_.products + step * (ahead_.first + step * ahead_.second);
    return std::max(0.0, sum) / bounds_;
}

// The longest step for which all slacks and multipliers stay positive.
double InteriorPoint::longest_step() const
{
    return ahead_.shrink > kStepShare ? 1 / ahead_.shrink : 1 / kStepShare;
}

// Predictor and corrector; returns the target complementarity.
double InteriorPoint::aim(ExactProblem& problem)
{
    const RowKernels& kernels = packed_->kernels();
    direction(problem, [&](double* x) { kernels.aim(rows_, 0, 0, x); });
    const double mu = complementarity(0);
    const double reach = std::min(1.0, longest_step());
    const double ratio = mu > 0 ? complementarity(reach) / mu : 0;
    const double target = ratio * ratio * ratio * ratio * mu;
    direction(problem, [&](double* x) { kernels.aim(rows_, target, 1, x); });
    return target;
}

// If predictor and corrector stop making progress, a few products are far from the mean: step back towards
// the centre.
double InteriorPoint::recentre(ExactProblem& problem)
{
    const double target = 0.5 * complementarity(0);
    direction(problem, [&](double* x) { packed_->kernels().aim(rows_, target, 0, x); });
    return target;
}

// Gondzio's correctors: where a longer step would leave products far from the target, aim at the nearest
// bound of [1/10, 10] of it instead. Each costs one more solution with the same factor. They are kept only
// while they lengthen the step.
void InteriorPoint::correct_centrality(ExactProblem& problem, double target)
{
    for (int k = 0; k < kCorrectors && longest_step() < kLong; ++k) {
        const double step = longest_step(), wanted = std::min(1.0, step + kLonger);
        const RowKernels::Direction before = ahead_;
        std::copy(dv_.begin(), dv_.end(), kept_dv_.begin());
        std::copy_n(rows_.dp, packed_->count(), kept_dp_.begin());
        direction(problem, [&](double* x) { packed_->kernels().centre(rows_, target, wanted, x); });
        if (longest_step() >= step + 0.1 * kLonger) continue;
        ahead_ = before;
        std::copy(kept_dv_.begin(), kept_dv_.end(), dv_.begin());
        std::copy_n(kept_dp_.begin(), packed_->count(), rows_.dp);
        for (InteriorSide* side : {&rows_.lower, &rows_.upper}) std::swap(side->t, side->kept);
        return;
    }
}

void InteriorPoint::tag()
{
    PackedRows& rows = *packed_;
    for (std::size_t i = 0; i < std::size_t(rows.count()); ++i) {
        if (rows.tag[i] == BoxState::kFixed) continue;
        rows.tag[i] = BoxState::kFree;
        const double d = rows.d[i];
        if (rows_.lower.present[i] > 0 && rows_.lower.s[i] * d < rows_.lower.z[i]) {
            rows.tag[i] = BoxState::kLower;
            rows.p[i] = rows.lo[i];
        } else if (rows_.upper.present[i] > 0 && rows_.upper.s[i] * d < rows_.upper.z[i]) {
            rows.tag[i] = BoxState::kUpper;
            rows.p[i] = rows.hi[i];
        }
    }
}

}  // namespace epode
