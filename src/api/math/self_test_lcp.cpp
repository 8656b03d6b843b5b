// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dTestSolveLCP: the two ways in which dWorldStep solves
//
//   w = A p - b,   lo < p < hi -> w = 0,   p = lo -> w >= 0,   p = hi -> w <= 0
//
// on random problems: pivoting on a dense A = B B^T, half of them of half the rank with a little added to the
// diagonal (as friction makes them), and the whole solver on A = J M^-1 J^T + C of bodies with random rows.
// An answer is judged by what it is to fulfil, with w taken from the problem and not from the solver:
//
//   residual = max_i a_i |p_i - clamp(p_i - w_i / a_i, lo_i, hi_i)| / max_i |b_i|,   a_i = A_ii
#include <cmath>
#include <cstdio>

#include "base/check.h"
#include "base/random.h"
#include "ode/misc.h"
#include "solve/exact/small/box_pivoting.h"
#include "solve/solver.h"

using namespace epode;

namespace {

constexpr int kDenseProblems = 100, kDenseRows = 60;
constexpr int kBodyProblems = 50, kBodies = 30, kBlocks = 40, kBlockRows = 3;
constexpr double kDenseLimit = 1e-8, kBodyLimit = kSingle ? 1e-3 : 1e-8;

class Dice {
  public:
    explicit Dice(std::uint64_t key) : random_(key) {}
    double real() { return double(random_.next() >> 11) * 0x1p-52 - 1; }  // -1 ... 1
    Vec3 vec() { return {Real(real()), Real(real()), Real(real())}; }
    int below(int n) { return random_.below(n); }
    // A third each: no bounds, one that pushes only, both ends.
    void bounds(double& lo, double& hi)
    {
        const int kind = below(3);
        lo = kind == 0 ? -HUGE_VAL : kind == 1 ? 0 : -0.5 * std::fabs(real());
        hi = kind == 2 ? 0.5 * std::fabs(real()) : HUGE_VAL;
    }

  private:
    CounterRandom random_;
};

double fault(double p, double w, double a, double lo, double hi)
{
    return a * std::fabs(p - std::fmin(std::fmax(p - w / a, lo), hi));
}

// ---- dense ----

struct DenseProblem {
    std::span<double> A, b, lo, hi;

    bool take(Arena& arena)
    {
        A = arena.take_zeroed<double>(kDenseRows * kDenseRows);
        b = arena.take_zeroed<double>(kDenseRows);
        lo = arena.take_zeroed<double>(kDenseRows);
        hi = arena.take_zeroed<double>(kDenseRows);
        return !arena.failed();
    }
    double& a(int i, int k) const { return A[std::size_t(i * kDenseRows + k)]; }
    void roll(Dice& dice, bool degenerate)
    {
        const int rank = degenerate ? kDenseRows / 2 : kDenseRows;
        for (int column = 0; column < rank; ++column) {
            double v[kDenseRows];
            for (double& x : v) x = dice.real();
            for (int i = 0; i < kDenseRows; ++i)
                for (int k = 0; k < kDenseRows; ++k) a(i, k) += v[i] * v[k];
        }
        for (int i = 0; i < kDenseRows; ++i) {
            const auto at = std::size_t(i);
            if (degenerate) a(i, i) += 1e-3;
            b[at] = dice.real();
            dice.bounds(lo[at], hi[at]);
        }
    }
    double residual(const BoxPivoting& answer) const
    {
        double worst = 0, scale = 0;
        for (int i = 0; i < kDenseRows; ++i) {
            const auto at = std::size_t(i);
            double w = -b[at];
            for (int k = 0; k < kDenseRows; ++k) w += a(i, k) * answer.p(k);
            worst = std::fmax(worst, fault(answer.p(i), w, a(i, i), lo[at], hi[at]));
            scale = std::fmax(scale, std::fabs(b[at]));
        }
        return worst / scale;
    }
};

// Infinite if the solver gave up; NaN never compares as passed either.
double dense_residual(Arena& arena, std::uint64_t seed)
{
    Dice dice(seed);
    DenseProblem problem;
    BoxPivoting pivoting;
    if (!problem.take(arena) || !pivoting.prepare(kDenseRows, arena)) return HUGE_VAL;
    problem.roll(dice, seed % 2 == 0);
    for (int i = 0; i < kDenseRows; ++i) {
        for (int k = 0; k <= i; ++k) pivoting.row(i)[k] = problem.a(i, k);
        const auto at = std::size_t(i);
        pivoting.place(i, problem.lo[at], problem.hi[at], 0, -problem.b[at]);
    }
    return pivoting.settle(1e-13) ? problem.residual(pivoting) : HUGE_VAL;
}

// ---- bodies ----

struct BodyProblem {
    RowSystem system;
    std::span<SolverBody> start;

    bool take(Arena& arena)
    {
        system.h = Real(0.01);
        system.bodies = arena.take_zeroed<SolverBody>(kBodies);
        start = arena.take_zeroed<SolverBody>(kBodies);
        system.rows = arena.take_zeroed<Row>(kBlocks * kBlockRows);
        system.numbers = arena.take_zeroed<RowNumbers>(kBlocks * kBlockRows);
        system.blocks = arena.take_zeroed<RowBlock>(kBlocks);
        return !arena.failed();
    }
    void roll_body(Dice& dice, SolverBody& body)
    {
        const Real mass = Real(1.5 + dice.real());
        body.mass = mass, body.inv_mass = 1 / mass;
        body.inertia = {mass, mass, mass, 0, 0, 0};
        body.inv_inertia = {1 / mass, 1 / mass, 1 / mass, 0, 0, 0};
        body.v = dice.vec(), body.w = dice.vec();
    }
    void roll_row(Dice& dice, Row& row, RowNumbers& numbers)
    {
        double lo, hi;
        dice.bounds(lo, hi);
        row = {};
        row.lin1 = dice.vec(), row.ang1 = dice.vec();
        row.lin2 = dice.vec(), row.ang2 = dice.vec();
        row.lo = Real(lo), row.hi = Real(hi);
        row.kind = lo == -HUGE_VAL ? RowKind::kLock : RowKind::kLimit;
        numbers = {};
        numbers.c = Real(dice.real());
        numbers.C = Real(kSingle ? 1e-2 : 1e-4);
        numbers.lo = row.lo, numbers.hi = row.hi;
    }
    void roll(Dice& dice)
    {
        for (std::size_t i = 0; i < std::size_t(kBodies); ++i) {
            roll_body(dice, system.bodies[i]);
            start[i] = system.bodies[i];
        }
        for (int i = 0; i < kBlocks; ++i) {
            const int first = dice.below(kBodies), second = (first + 1 + dice.below(kBodies - 1)) % kBodies;
            system.blocks[std::size_t(i)] = {kBlockRows * i, kBlockRows, first, second, false, {}};
        }
        for (std::size_t i = 0; i < system.rows.size(); ++i)
            roll_row(dice, system.rows[i], system.numbers[i]);
    }
    // With the velocities that the impulses give to the bodies, not with those of the solver.
    double residual()
    {
        double worst = 0, scale = 0;
        for_rows([&](const Row& row, const RowNumbers& n, SolverBody& a, SolverBody& b) {
            scale = std::fmax(scale, std::fabs(double(n.c - row_velocity(row, a, &b))));
        });
        for_rows([](const Row& row, const RowNumbers& n, SolverBody& a, SolverBody& b) {
            apply_impulse(row, n.p, a, &b);
        });
        for_rows([&](const Row& row, const RowNumbers& n, SolverBody& a, SolverBody& b) {
            const double w = double(row_velocity(row, a, &b) + n.C * n.p - n.c);
            const double inverse_mass = double(inverse_effective_mass(row, a, &b) + n.C);
            worst = std::fmax(worst, fault(double(n.p), w, inverse_mass, double(n.lo), double(n.hi)));
        });
        return worst / scale;
    }
    template <typename Visit>
    void for_rows(Visit&& visit)
    {
        for (const RowBlock& block : system.blocks)
            for (int i = block.first; i < block.first + block.count; ++i)
                visit(system.rows[std::size_t(i)], system.numbers[std::size_t(i)],
                      start[std::size_t(block.body1)], start[std::size_t(block.body2)]);
    }
};

double body_residual(Arena& arena, std::uint64_t seed)
{
    Dice dice(seed);
    BodyProblem problem;
    if (!problem.take(arena)) return HUGE_VAL;
    problem.roll(dice);
    SolveReport report;
    const ExactSettings settings;
    return solve_exactly(problem.system, settings, arena, report) ? problem.residual() : HUGE_VAL;
}

// The worst of `count` problems; one that is not a number is worse than any.
template <typename Residual>
double worst_of(int count, Residual&& residual)
{
    Arena arena;
    double worst = 0;
    for (int i = 0; i < count; ++i) {
        const double r = residual(arena, std::uint64_t(i));
        if (!(r <= worst)) worst = r;
        if (std::isnan(worst)) return HUGE_VAL;
        arena.reset();
    }
    return worst;
}

bool report(const char* what, int count, double worst, double limit)
{
    std::printf("%d %s: worst residual %.1e, %s\n", count, what, worst, worst <= limit ? "passed" : "FAILED");
    return worst <= limit;
}

}  // namespace

// Cold, as nobody waits for it: half the code.
extern "C" [[gnu::cold]] int dTestSolveLCP(void)
{
    std::printf("dTestSolveLCP()\n");
    const bool dense =
        report("dense problems", kDenseProblems, worst_of(kDenseProblems, dense_residual), kDenseLimit);
    const bool bodies =
        report("systems of bodies", kBodyProblems, worst_of(kBodyProblems, body_residual), kBodyLimit);
    return dense && bodies;
}
