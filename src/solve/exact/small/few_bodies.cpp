// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See few_bodies.h; the refinement is that of active_set.cpp.
#include "solve/exact/small/few_bodies.h"

#include <algorithm>
#include <cmath>

#include "simd/lanewise.h"
#include "solve/exact/small/box_phases.h"

namespace epode {
namespace {

constexpr double kFeasible = 1e-11;  // relative tolerance of a sign, in units of the problem's velocity scale
constexpr double kClearly = 1e-6;    // the same before refinement
constexpr double kNear = 0.015;      // of the range between two bounds: rows this near to a bound begin on it
constexpr double kShift = 1e-3;      // of the scale: the load has been shifted by friction
constexpr int kFlipAll = 2;          // rounds in which all wrong rows are flipped

// When an island of one, two or three bodies is given up: after so many rounds, or when so many rows are
// wrong. A round costs the cube of the bodies; the cost of pivoting does not depend on how many rows are
// wrong. Measured on tumbling boxes and on pile-20.
constexpr struct Patience {
    int rounds, wrong;
} kPatience[] = {{16, 1000}, {6, 5}, {6, 1}};

constexpr int kMaxPasses = 8;
constexpr double kRoundWork = 0.05;    // microseconds of a row or an unknown in a round
constexpr double kContraction = 1e-3;  // of a pass, until one has been measured

// The upper half of sum x x^T s, three lanes a row without those left of the diagonal.
struct OuterSum {
    DoubleLane of[12] = {};

    void add(const double* x, double s)
    {
        const auto* lane = reinterpret_cast<const DoubleLane*>(x);
        const DoubleLane a = lane[0], b = lane[1], c = lane[2];
        for (int i = 0, k = 0; i < 6; ++i) {
            const double sx = s * x[i];
            if (i < 2) of[k++] += a * sx;
            if (i < 4) of[k++] += b * sx;
            of[k++] += c * sx;
        }
    }
};

// H = L D L^T in place, with D and D L^T in the upper half.
template <int Lanes, class Rows>
void factor_lanes(Rows& H, double* inverse)
{
#pragma GCC unroll 6
    for (int k = 0; k < 2 * Lanes; ++k) {
        const DoubleLane* from = H[k];
        inverse[k] = 1 / from[k / 2][k % 2];
        if (k % 2 == 0) {
            const double f = from[k / 2][1] * inverse[k];
            for (int q = k / 2; q < Lanes; ++q) H[k + 1][q] -= from[q] * f;
        }
#pragma GCC unroll 3
        for (int i = k / 2 + 1; i < Lanes; ++i) {
            const double f = from[i][0] * inverse[k], g = from[i][1] * inverse[k];
            DoubleLane *even = H[2 * i], *odd = H[2 * i + 1];
            for (int q = i; q < Lanes; ++q) {
                const DoubleLane column = from[q];
                even[q] -= column * f, odd[q] -= column * g;
            }
        }
    }
}

// x = H^-1 x
template <int Lanes, class Rows>
void solve_lanes(const Rows& H, const double* inverse, DoubleLane* out)
{
    DoubleLane x[Lanes];
    std::copy_n(out, Lanes, x);
#pragma GCC unroll 6
    for (int k = 0; k < 2 * Lanes; ++k) {
        const double f = x[k / 2][k % 2] * inverse[k];
        for (int q = (k + 1) / 2; q < Lanes; ++q) x[q] -= H[k][q] * f;
        x[k / 2][k % 2] = f;
    }
#pragma GCC unroll 6
    for (int k = 2 * Lanes - 1; k >= 0; --k) {
        const double own = x[k / 2][k % 2];
        x[k / 2][k % 2] = 0;
        DoubleLane sum{};
        for (int q = (k + 1) / 2; q < Lanes; ++q) sum += H[k][q] * x[q];
        x[k / 2][k % 2] = own - inverse[k] * (sum[0] + sum[1]);
    }
    std::copy_n(x, Lanes, out);
}

// One number per unknown; those of a single body, which is the first, stay in registers.
template <int Lanes>
struct Unknowns {
    DoubleLane of[Lanes];

    EPODE_LANEWISE explicit Unknowns(std::span<const double> x)
    {
        std::copy_n(reinterpret_cast<const DoubleLane*>(x.data()), Lanes, of);
    }
    EPODE_LANEWISE void store(std::span<double> x) const
    {
        std::copy_n(of, Lanes, reinterpret_cast<DoubleLane*>(x.data()));
    }

    // J x
    EPODE_LANEWISE double along(const ExactRow& row) const
    {
        if constexpr (Lanes > 3) return ExactProblem::jv(row, reinterpret_cast<const double*>(of));
        return six_dot(reinterpret_cast<const DoubleLane*>(row.J), of);
    }
    // += J^T s
    EPODE_LANEWISE void add(const ExactRow& row, double s)
    {
        if constexpr (Lanes > 3) return ExactProblem::add_jt(row, s, reinterpret_cast<double*>(of));
        const auto* J = reinterpret_cast<const DoubleLane*>(row.J);
        for (int q = 0; q < 3; ++q) of[q] += J[q] * s;
    }
};

}  // namespace

SmallResult FewBodies::solve(RowSystem& system, double enough, Arena& arena, SolveReport& report,
                             WorkMeter* work)
{
    if (!prepare(system, work, arena)) return SmallResult::kNoMemory;
    const bool friction = bound_without_friction(problem_, system, state_);
    std::copy(state_.p.begin(), state_.p.end(), begun_.begin());
    if (!settle(report.iterations)) return SmallResult::kNotSolved;
    if (friction) {
        freeze_friction(problem_, system, state_);
        if (warm_ && has_shifted()) {
            for (std::size_t i = 0; i < begun_.size(); ++i)
                if (system.numbers[i].parent < 0) state_.p[i] = begun_[i];
        }
        if (!settle(report.iterations)) return SmallResult::kNotSolved;
    }
    const double residual = problem_.residual(state_, v_);
    if (!(residual <= enough)) return SmallResult::kNotSolved;
    problem_.store(system, state_.p, v_);
    report.method = dIslandMethodDense;
    report.factorisations += factorisations_;
    report.residual = Real(residual);
    return SmallResult::kSolved;
}

bool FewBodies::prepare(const RowSystem& system, WorkMeter* work, Arena& arena)
{
    const int m = int(system.rows.size());
    if (!problem_.build(system, work, arena)) return false;
    n_ = problem_.unknowns();
    for (std::span<double>* rows : {&state_.lo, &state_.hi, &state_.p, &D_, &w_, &weight_, &begun_})
        *rows = arena.take<double>(m);
    state_.tag = arena.take<BoxState::Tag>(m);
    v_ = arena.take<double>(n_);
    base_ = arena.take<double>(n_);
    rows_ = arena.take<int>(m);
    if (arena.failed()) return false;
    warm_ = false;
    for (int i = 0; i < m; ++i) {
        warm_ |= system.numbers[std::size_t(i)].p != 0;
        const ExactRow& row = problem_.row(i);
        D_[std::size_t(i)] = 0;
        weight_[std::size_t(i)] = 1 / std::max(row.C, row.weight_min);
    }
    return true;
}

bool FewBodies::settle(int& rounds)
{
    by_bodies([&](auto lanes) { begin<lanes>(); });
    const Patience& patience = kPatience[n_ / 6 - 1];
    for (round_ = 0; round_ < patience.rounds; ++round_) {
        ++rounds;
        factor();
        if (refine() && correct(kFeasible) == 0) return true;
        if (wrong_ > patience.wrong) return false;
    }
    return false;
}

// Friction shifts the load of a moving body from one contact to another: then all impulses of the last step
// are nearer to this step's than its frictionless load with the last step's friction.
bool FewBodies::has_shifted() const
{
    for (const int i : open_) {
        const double change = state_.p[std::size_t(i)] - begun_[std::size_t(i)];
        if (problem_.row(i).d * std::fabs(change) > kShift * problem_.scale()) return true;
    }
    return false;
}

// Lists the rows that may move; computes velocities without them and with the present impulses, and chooses
// sides.
template <int Lanes>
void FewBodies::begin()
{
    Unknowns<Lanes> v(problem_.free_motion());
    std::size_t count = 0;
    for (int i = 0; i < problem_.row_count(); ++i) {
        const double p = state_.p[std::size_t(i)];
        if (state_.tag[std::size_t(i)] != BoxState::kFixed)
            rows_[count++] = i;
        else if (p != 0)
            v.add(problem_.row(i), p);
    }
    open_ = rows_.first(count);
    v.store(base_);
    for (const int i : open_) v.add(problem_.row(i), state_.p[std::size_t(i)]);
    v.store(v_);
    choose(v);
}

// Chooses the side on which a row's own step ends, or nearly: the bounds of friction change with the load,
// and sliding contacts continue to slide.
template <class Velocities>
void FewBodies::choose(const Velocities& v)
{
    for (const int at : open_) {
        const auto i = std::size_t(at);
        const ExactRow& row = problem_.row(at);
        const double w = v.along(row) + row.C * state_.p[i] - row.c;
        const double q = state_.p[i] - w / row.d, lo = state_.lo[i], hi = state_.hi[i];
        const double near = lo < 0 && hi - lo < HUGE_VAL ? kNear * (hi - lo) : 0;
        state_.tag[i] = q < lo + near ? BoxState::kLower : q > hi - near ? BoxState::kUpper : BoxState::kFree;
    }
}

// Impulses of bound rows on their bounds, weights for the others, and H = L D L^T of these.
void FewBodies::factor()
{
    ++factorisations_;
    problem_.count_work(kRoundWork * (n_ + int(open_.size())));
    for (const int i : open_) {
        const auto k = std::size_t(i);
        const BoxState::Tag tag = state_.tag[k];
        D_[k] = tag == BoxState::kFree ? weight_[k] : 0;
        if (tag == BoxState::kLower) state_.p[k] = state_.lo[k];
        if (tag == BoxState::kUpper) state_.p[k] = state_.hi[k];
    }
    for (int i = 0; i < n_; ++i) {
        std::fill_n(H_[i], n_ / 2, DoubleLane{});
        H_[i][i / 2] = i % 2 ? DoubleLane{0, 1} : DoubleLane{1, 0};
    }
    const int m = problem_.row_count();
    for (int first = 0, last = 0; first < m; first = last) {
        const ExactRow& row = problem_.row(first);
        for (last = first; last < m; ++last)
            if (problem_.row(last).a != row.a || problem_.row(last).b != row.b) break;
        add_rows(first, last);
    }
    by_bodies([&](auto lanes) { factor_lanes<lanes>(H_, inverse_); });
}

// H += J^T D J of rows of the same bodies.
void FewBodies::add_rows(int first, int last)
{
    const ExactRow& one = problem_.row(first);
    const auto add_half = [&](int body, int half) {
        OuterSum sum;
        for (int i = first; i < last; ++i)
            if (D_[std::size_t(i)] > 0) sum.add(problem_.row(i).J + 6 * half, D_[std::size_t(i)]);
        for (int i = 0, k = 0; i < 6; ++i)
            for (int q = i / 2; q < 3; ++q) H_[6 * body + i][3 * body + q] += sum.of[k++];
    };
    add_half(one.a, 0);
    if (one.b < 0) return;
    add_half(one.b, 1);
    const bool swapped = one.b < one.a;
    const int above = swapped ? one.b : one.a, right = swapped ? one.a : one.b;
    for (int i = first; i < last; ++i) {
        const double D = D_[std::size_t(i)];
        if (!(D > 0)) continue;
        const double* J = problem_.row(i).J;
        const double* x = J + (swapped ? 6 : 0);
        const auto* y = reinterpret_cast<const DoubleLane*>(J + (swapped ? 0 : 6));
        for (int r = 0; r < 6; ++r)
            for (int q = 0; q < 3; ++q) H_[6 * above + r][3 * right + q] += y[q] * (D * x[r]);
    }
}

// Newton's step on the free rows until it is rounding, as ActiveSet::refine. False: the first step was enough
// to find and flip rows on the wrong side.
bool FewBodies::refine()
{
    const double small = 1e-15 * problem_.scale();
    double before = HUGE_VAL;
    for (int pass = 0; pass < kMaxPasses; ++pass) {
        double largest = 0;
        by_bodies([&](auto lanes) { largest = improve<lanes>(); });
        if (largest >= 0.5 * before) return true;
        if (largest * (pass > 0 ? largest / before : kContraction) <= small) return true;
        if (pass == 0 && correct(kClearly) > 0) return false;
        before = largest;
    }
    return true;
}

// One step; returns the largest change of a velocity.
template <int Lanes>
double FewBodies::improve()
{
    Unknowns<Lanes> v(v_), r(base_);
    for (int q = 0; q < Lanes; ++q) r.of[q] -= v.of[q];
    for (const int i : open_) {
        const auto k = std::size_t(i);
        const ExactRow& row = problem_.row(i);
        double impulse = state_.p[k];
        if (D_[k] > 0) {
            w_[k] = row.c - v.along(row) - row.C * impulse;
            impulse += D_[k] * w_[k];
        }
        r.add(row, impulse);
    }
    solve_lanes<Lanes>(H_, inverse_, r.of);
    for (const int i : open_) {
        const auto k = std::size_t(i);
        if (D_[k] > 0) state_.p[k] += D_[k] * (w_[k] - r.along(problem_.row(i)));
    }
    double largest = 0;
    for (int q = 0; q < Lanes; ++q) {
        v.of[q] += r.of[q];
        largest = std::max({largest, std::fabs(r.of[q][0]), std::fabs(r.of[q][1])});
    }
    v.store(v_);
    return largest;
}

// Flips rows that are on the wrong side by more than this share of the scale: all of them in the first
// rounds, then the worst; returns how many rows are wrong.
int FewBodies::correct(double share)
{
    double worst = share * problem_.scale();
    const bool all = round_ < kFlipAll;
    int last = -1;
    wrong_ = 0;
    for (const int at : open_) {
        const auto i = std::size_t(at);
        const BoxState::Tag tag = state_.tag[i];
        const ExactRow& row = problem_.row(at);
        double by;
        if (tag == BoxState::kFree) {
            by = row.d * std::max(state_.lo[i] - state_.p[i], state_.p[i] - state_.hi[i]);
        } else {
            const double w = ExactProblem::jv(row, v_.data()) + row.C * state_.p[i] - row.c;
            by = tag == BoxState::kLower ? -w : w;
        }
        if (!(by > worst)) continue;
        ++wrong_;
        last = at;
        if (all)
            state_.flip(at);
        else
            worst = by;
    }
    if (!all && last >= 0) state_.flip(last);
    return wrong_;
}

}  // namespace epode
