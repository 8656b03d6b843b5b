// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Free rows satisfy w = J v + C p - c = 0. With D = 1/C on them and 0 elsewhere, eliminating p (the Schur
// complement of the KKT system) gives H dv = r. p is carried as an unknown of its own through the refinement
// of the KKT system and never recomputed as (c - J v)/C, which would cost eps/C of it (8 digits at ODE's
// CFM):
//
//   r1 = M (v* - v) + J^T p,  r2 = c - J v - C p   (free rows)
//   dv = H^-1 (r1 + J^T D r2),  dp = D (r2 - J dv)
//
// Where C is below 1e-11 d, D uses 1e-11 d instead. Refinement against the true C converges for consistent
// redundant rows and leaves inconsistent ones with that compliance.
//
// All wrong rows are flipped while their number falls (Portugal, Judice & Vicente 1994). When it does not,
// neighbouring rows are overreacting to each other; then only rows that share no body are flipped, the most
// violated first. Distant clusters so progress at the same time, each by nearly single steps. On 46 first
// phases of moving walls and piles this settles 33, flipping all of them 20; the least violated first settles
// 26, one per pair of bodies 32. The last resort is one row at a time, the last of the wrong ones (Murty's
// rule, which is finite for this positive definite problem).
#include "solve/exact/active_set.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

constexpr double kFeasible = 1e-11;  // relative tolerance of a sign, in units of the problem's velocity scale
constexpr int kRoundsWithoutGain = 8;  // rounds without a new minimum
constexpr int kRefinements = 8;        // of refinement
constexpr int kFew = 16;               // so few wrong rows never end the search

// Guesses that settle have less than 0.4 of their rows wrong at first, 0.3 after one round, and fewer than
// two rounds before. With friction, where rows have two bounds, 0.2 after one round and 0.6 of two rounds
// before; guesses that improve more slowly mostly end in a cycle. Of 70 phases of walls, piles and pyramids
// without friction 63 settle within 40 rounds; this gives up the other 7 after 18 rounds in all, and 5 more.
// Of 70 with friction 21 settle; the others and 9 of them are given up after 75 rounds in all.
bool hopeless(int wrong, const int* before, int count, bool friction, int round)
{
    if (wrong <= kFew || 64 * wrong <= count) return false;
    if (round == 0) return wrong > 0.4 * count;
    return wrong > (friction ? 0.2 : 0.3) * count || (round > 1 && wrong > (friction ? 0.6 : 1) * before[1]);
}

bool any_two_bounds(const PackedRows& rows)
{
    for (std::size_t i = 0; i < std::size_t(rows.count()); ++i)
        if (rows.tag[i] != BoxState::kFixed && rows.lo[i] > -HUGE_VAL && rows.hi[i] < HUGE_VAL) return true;
    return false;
}

}  // namespace

bool ActiveSet::prepare(const ExactProblem& problem, int places, Arena& arena)
{
    D_ = arena.take<double>(places);
    w_ = arena.take<double>(places);
    scratch_ = arena.take<double>(places);
    wrong_ = arena.take<int>(places);
    touched_ = arena.take<bool>(problem.unknowns() / 6);
    r_ = arena.take<double>(problem.unknowns());
    return !arena.failed();
}

bool ActiveSet::solve(ExactProblem& problem, PackedRows& rows, std::span<double> v,
                      const ActiveSetSettings& settings, int& rounds)
{
    int fewest = rows.count() + 1, since = 0;
    int before[2] = {};  // wrong rows one and two rounds ago
    const bool friction = any_two_bounds(rows);
    rows.velocities(problem, r_, v);
    for (int round = 0; round < settings.rounds; ++round) {
        if (problem.gives_up()) return false;
        ++rounds;
        settle(rows);
        rows.factor(problem, D_);
        refine(problem, rows, v);
        const int wrong = find_wrong(problem, rows, v);
        if (wrong == 0) return true;
        since = wrong < fewest ? 0 : since + 1;
        fewest = std::min(fewest, wrong);
        const bool give_up =
            since >= kRoundsWithoutGain || hopeless(wrong, before, rows.count(), friction, round);
        if (give_up && !settings.persistent) return false;
        before[1] = before[0], before[0] = wrong;
        if (since == 0)
            for (int k = 0; k < wrong; ++k) flip(rows, wrong_[std::size_t(k)]);
        else if (since < kRoundsWithoutGain)
            flip_apart(problem, rows, wrong);
        else
            flip(rows, wrong_[std::size_t(wrong) - 1]);
    }
    return false;
}

// Impulses of bound rows are set to their bounds; free rows get their weights.
void ActiveSet::settle(PackedRows& rows)
{
    for (std::size_t i = 0; i < std::size_t(rows.count()); ++i) {
        D_[i] = 0;
        switch (rows.tag[i]) {
            case BoxState::kFixed:
                break;
            case BoxState::kLower:
                rows.p[i] = rows.lo[i];
                break;
            case BoxState::kUpper:
                rows.p[i] = rows.hi[i];
                break;
            case BoxState::kFree:
                D_[i] = 1 / std::max(rows.C[i], rows.weight_min[i]);
                break;
        }
    }
}

void ActiveSet::refine(ExactProblem& problem, PackedRows& rows, std::span<double> v)
{
    const double small = 1e-15 * problem.scale();
    const auto n = std::size_t(rows.count());
    const std::span<double> w = w_.first(n), scratch = scratch_.first(n);
    double before = HUGE_VAL;
    for (int pass = 0; pass < kRefinements; ++pass) {
        rows.momentum_change(problem, v, r_);
        rows.products(v, w);
        for (std::size_t i = 0; i < n; ++i) {
            w[i] = rows.c[i] - w[i] - rows.C[i] * rows.p[i];
            scratch[i] = rows.p[i] + D_[i] * w[i];
        }
        rows.add_transposed(scratch, r_);
        problem.solve(r_);
        rows.products(r_, scratch);
        for (std::size_t i = 0; i < n; ++i) rows.p[i] += D_[i] * (w[i] - scratch[i]);
        double change = 0;
        for (std::size_t i = 0; i < v.size(); ++i) {
            v[i] += r_[i];
            change = std::max(change, std::fabs(r_[i]));
        }
        // Corrections shrink by about the same factor each time: stop when the next one would be below
        // rounding, or when they stop shrinking. The first pass mostly moves v and proves nothing.
        if (pass > 0 && (change >= 0.5 * before || change * (change / before) <= small)) break;
        if (change == 0) break;
        before = change;
    }
}

// Stores in w_ by how much each row is wrong, as a velocity.
int ActiveSet::find_wrong(const ExactProblem& problem, const PackedRows& rows, std::span<const double> v)
{
    const double tolerance = kFeasible * problem.scale();
    rows.products(v, w_);
    int count = 0;
    for (std::size_t i = 0; i < std::size_t(rows.count()); ++i) {
        const double w = w_[i] + rows.C[i] * rows.p[i] - rows.c[i];
        switch (rows.tag[i]) {
            case BoxState::kFixed:
                w_[i] = 0;
                break;
            case BoxState::kLower:
                w_[i] = -w;
                break;
            case BoxState::kUpper:
                w_[i] = w;
                break;
            case BoxState::kFree:
                w_[i] = rows.d[i] * std::max(rows.lo[i] - rows.p[i], rows.p[i] - rows.hi[i]);
                break;
        }
        if (w_[i] > tolerance) wrong_[std::size_t(count++)] = int(i);
    }
    return count;
}

void ActiveSet::flip_apart(const ExactProblem& problem, PackedRows& rows, int wrong)
{
    const std::span<int> order = wrong_.first(std::size_t(wrong));
    std::sort(order.begin(), order.end(), [this](int x, int y) {
        const double by_x = w_[std::size_t(x)], by_y = w_[std::size_t(y)];
        return by_x != by_y ? by_x > by_y : x < y;
    });
    std::fill(touched_.begin(), touched_.end(), false);
    for (const int place : order) {
        const ExactRow& row = problem.row(rows.row(place));
        bool& a = touched_[std::size_t(row.a)];
        bool& b = row.b >= 0 ? touched_[std::size_t(row.b)] : a;
        if (a || b) continue;
        a = b = true;
        flip(rows, place);
    }
}

// Flips a wrong guess.
void ActiveSet::flip(PackedRows& rows, int place)
{
    const auto i = std::size_t(place);
    BoxState::Tag& tag = rows.tag[i];
    tag = tag != BoxState::kFree   ? BoxState::kFree
          : rows.p[i] < rows.lo[i] ? BoxState::kLower
                                   : BoxState::kUpper;
}

}  // namespace epode
