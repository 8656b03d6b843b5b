// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Pieces begin in the order of their numbers (tasks/tasks.h). So a piece that another waits for is in the
// hands of a running thread, and the first waits for none.
#include "solve/exact/factor/shared_ldlt.h"

#include <algorithm>
#include <atomic>

#include "base/threads/spin.h"
#include "math/ldlt.h"

namespace epode {
namespace {

// Posting a job and waiting for it takes about ten microseconds. Work below these sizes takes one thread less
// than about a hundred.
constexpr int kMinFactor = 128, kMinSolve = 1024, kMinScale = 1 << 18;
constexpr int kBlock = 64;       // numbers of b in a piece of a solution
constexpr int kChunk = 1 << 14;  // numbers in a piece of a scaling

// Rows in a piece of a factorisation: a row of L is loaded once for all of them, but the work that remains
// when the piece before is done grows with their square.
int rows_of_piece(int n) { return std::clamp(n / 100, 4, 16); }

// How far a thread has come, for those that depend on it.
class Progress {
  public:
    void reach(int mark) { mark_.store(mark, std::memory_order_release); }
    // Waits until it is beyond `mark`, and returns where it is.
    int beyond(int mark) const
    {
        int now;
        for (int spins = 0; (now = mark_.load(std::memory_order_acquire)) <= mark; ++spins)
            if (spins >= kSpins) yield_core();
        return now;
    }

  private:
    static constexpr int kSpins = 1000;
    std::atomic<int> mark_{0};
};

int pieces_of(int n, int size) { return (n + size - 1) / size; }

// Row i of L D in columns from ... to - 1, which needs these rows of L.
void substitute(const Real* A, Real* row, int stride, int from, int to)
{
    for (int j = from; j < to; ++j) row[j] -= dot(row_of(A, j, stride), row, j);
}

}  // namespace

void factor_ldlt(Real* A, Real* d, int n, int stride, const Tasks& tasks)
{
    if (tasks.workers() == 1 || n < kMinFactor) return factor_ldlt(A, d, n, stride);
    const int size = rows_of_piece(n);
    Progress rows;  // of L that are known
    tasks.for_each(pieces_of(n, size), [&](int piece, int) {
        const int first = piece * size, end = std::min(first + size, n);
        for (int j = 0; j < first;) {
            const int known = std::min(rows.beyond(j), first);
            for (; j < known; ++j)
                for (int i = first; i < end; ++i) substitute(A, row_of(A, i, stride), stride, j, j + 1);
        }
        for (int i = first; i < end; ++i) {
            substitute(A, row_of(A, i, stride), stride, first, i);
            scale_ldlt_row(row_of(A, i, stride), d, i);
            rows.reach(i + 1);
        }
    });
}

void solve_unit_lower(const Real* L, Real* b, int n, int stride, const Tasks& tasks)
{
    if (tasks.workers() == 1 || n < kMinSolve) return solve_unit_lower(L, b, n, stride);
    Progress solved;
    tasks.for_each(pieces_of(n, kBlock), [&](int piece, int) {
        const int first = piece * kBlock, end = std::min(first + kBlock, n);
        GrowingDot sums[kBlock];
        for (int known = 0; known < first;) {
            known = std::min(solved.beyond(known), first);
            for (int i = first; i < end; ++i) sums[i - first].grow(row_of(L, i, stride), b, known);
        }
        for (int i = first; i < end; ++i) b[i] -= sums[i - first].finish(row_of(L, i, stride), b, i);
        solved.reach(end);
    });
}

void solve_unit_lower_transposed(const Real* L, Real* b, int n, int stride, const Tasks& tasks)
{
    if (tasks.workers() == 1 || n < kMinSolve) return solve_unit_lower_transposed(L, b, n, stride);
    Progress solved;  // numbers, from the end of b
    tasks.for_each(pieces_of(n, kBlock), [&](int piece, int) {
        const int end = n - piece * kBlock, first = std::max(end - kBlock, 0);
        for (int i = n - 1; i >= end;) {
            const int known = n - std::min(solved.beyond(n - 1 - i), n - end);
            for (; i >= known; --i)
                subtract_scaled(b + first, b[i], row_of(L, i, stride) + first, end - first);
        }
        for (int i = end - 1; i > first; --i)
            subtract_scaled(b + first, b[i], row_of(L, i, stride) + first, i - first);
        solved.reach(n - first);
    });
}

void scale_vector(Real* a, const Real* d, int n, const Tasks& tasks)
{
    const auto scale = [&](int from, int to) {
        for (int i = from; i < to; ++i) a[i] *= d[i];
    };
    if (tasks.workers() == 1 || n < kMinScale) return scale(0, n);
    tasks.for_each(pieces_of(n, kChunk),
                   [&](int piece, int) { scale(piece * kChunk, std::min(n, (piece + 1) * kChunk)); });
}

void solve_ldlt(const Real* L, const Real* d, Real* b, int n, int stride, const Tasks& tasks)
{
    solve_unit_lower(L, b, n, stride, tasks);
    scale_vector(b, d, n, tasks);
    solve_unit_lower_transposed(L, b, n, stride, tasks);
}

}  // namespace epode
