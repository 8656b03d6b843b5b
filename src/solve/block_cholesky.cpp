// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Right-looking: column k is finished, then its outer product is subtracted from the columns to its right.
// Fill is confined to the structure, since the rows of column k below j are a subset of the rows of column j
// for every j among them. A pivot that is not positive (H is positive definite: this is rounding) is replaced
// by a huge one, which freezes that variable; refinement by the caller repairs the rest.
// The inner product of two blocks is the whole cost: C -= A B^T, 216 multiply-subtracts on two-wide lanes.
#include "solve/block_cholesky.h"

#include <algorithm>
#include <cmath>

#include "solve/ordering.h"

namespace epode {
namespace {

constexpr int kB = BlockCholesky::kBlock;
using Lane = DoubleLane;

// C -= A B^T, all 6x6 column-major.
void subtract_product(double* C, const double* A, const double* B)
{
    const Lane* a = reinterpret_cast<const Lane*>(A);
    for (int c = 0; c < 6; ++c) {
        Lane* out = reinterpret_cast<Lane*>(C + 6 * c);
        Lane s0 = out[0], s1 = out[1], s2 = out[2];
        for (int t = 0; t < 6; ++t) {
            const double b = B[6 * t + c];
            s0 -= a[3 * t] * b;
            s1 -= a[3 * t + 1] * b;
            s2 -= a[3 * t + 2] * b;
        }
        out[0] = s0, out[1] = s1, out[2] = s2;
    }
}

// Lower triangle of the symmetric block becomes L; its diagonal holds reciprocals.
int factor_block(double* H)
{
    int bad = 0;
    for (int c = 0; c < 6; ++c) {
        double pivot = H[6 * c + c];
        for (int t = 0; t < c; ++t) pivot -= H[6 * t + c] * H[6 * t + c];
        if (!(pivot > 0) || !(pivot < 1e300)) pivot = 1e300, ++bad;
        const double inverse = 1 / std::sqrt(pivot);
        H[6 * c + c] = inverse;
        for (int r = c + 1; r < 6; ++r) {
            double s = H[6 * c + r];
            for (int t = 0; t < c; ++t) s -= H[6 * t + r] * H[6 * t + c];
            H[6 * c + r] = s * inverse;
        }
    }
    return bad;
}

// X = X L^-T, column-major, L with reciprocal diagonal.
void solve_right(double* X, const double* L)
{
    Lane* x = reinterpret_cast<Lane*>(X);
    for (int c = 0; c < 6; ++c) {
        Lane s0 = x[3 * c], s1 = x[3 * c + 1], s2 = x[3 * c + 2];
        for (int t = 0; t < c; ++t) {
            const double l = L[6 * t + c];
            s0 -= x[3 * t] * l;
            s1 -= x[3 * t + 1] * l;
            s2 -= x[3 * t + 2] * l;
        }
        const double d = L[6 * c + c];
        x[3 * c] = s0 * d, x[3 * c + 1] = s1 * d, x[3 * c + 2] = s2 * d;
    }
}

// y -= L x
void subtract_times(double* y, const double* L, const double* x)
{
    const Lane* l = reinterpret_cast<const Lane*>(L);
    Lane* out = reinterpret_cast<Lane*>(y);
    Lane s0 = out[0], s1 = out[1], s2 = out[2];
    for (int c = 0; c < 6; ++c) {
        s0 -= l[3 * c] * x[c];
        s1 -= l[3 * c + 1] * x[c];
        s2 -= l[3 * c + 2] * x[c];
    }
    out[0] = s0, out[1] = s1, out[2] = s2;
}

// y -= L^T x
void subtract_transposed_times(double* y, const double* L, const double* x)
{
    const Lane* l = reinterpret_cast<const Lane*>(L);
    const Lane* in = reinterpret_cast<const Lane*>(x);
    for (int c = 0; c < 6; ++c) {
        const Lane s = l[3 * c] * in[0] + l[3 * c + 1] * in[1] + l[3 * c + 2] * in[2];
        y[c] -= s[0] + s[1];
    }
}

void solve_lower(double* x, const double* L)
{
    for (int c = 0; c < 6; ++c) {
        x[c] *= L[6 * c + c];
        for (int r = c + 1; r < 6; ++r) x[r] -= L[6 * c + r] * x[c];
    }
}

void solve_lower_transposed(double* x, const double* L)
{
    for (int c = 5; c >= 0; --c) {
        double s = x[c];
        for (int r = c + 1; r < 6; ++r) s -= L[6 * c + r] * x[r];
        x[c] = s * L[6 * c + c];
    }
}

}  // namespace

bool BlockCholesky::analyse(int n, std::span<const BodyPair> pairs, Arena& arena)
{
    n_ = n;
    BodyGraph graph;
    auto order = arena.take<int>(n);
    if (arena.failed() || !build_body_graph(n, pairs, arena, graph) ||
        !order_minimum_degree(graph, arena, order) || !find_structure(graph, order, arena, structure_))
        return false;
    diagonal_ = arena.take<double>(kB * n);
    lower_ = arena.take<double>(kB * structure_.first[std::size_t(n)]);
    work_ = arena.take<double>(6 * n);
    return !arena.failed();
}

double* BlockCholesky::between(int a, int b, bool& transposed)
{
    int row = structure_.position[std::size_t(a)], column = structure_.position[std::size_t(b)];
    transposed = row < column;
    if (transposed) std::swap(row, column);
    const int* first = structure_.rows.data() + structure_.first[std::size_t(column)];
    const int* last = structure_.rows.data() + structure_.first[std::size_t(column) + 1];
    return lower_.data() + kB * (std::lower_bound(first, last, row) - structure_.rows.data());
}

void BlockCholesky::clear()
{
    std::fill(diagonal_.begin(), diagonal_.end(), 0.0);
    std::fill(lower_.begin(), lower_.end(), 0.0);
}

int BlockCholesky::factor()
{
    bad_pivots_ = 0;
    for (int k = 0; k < n_; ++k) {
        eliminate_column(k);
        subtract_outer(k);
    }
    return bad_pivots_;
}

void BlockCholesky::eliminate_column(int k)
{
    double* L = diagonal_.data() + kB * k;
    bad_pivots_ += factor_block(L);
    for (int e = structure_.first[std::size_t(k)]; e < structure_.first[std::size_t(k) + 1]; ++e)
        solve_right(lower_.data() + kB * e, L);
}

void BlockCholesky::subtract_outer(int k)
{
    const int begin = structure_.first[std::size_t(k)], end = structure_.first[std::size_t(k) + 1];
    const int* rows = structure_.rows.data();
    for (int e = begin; e < end; ++e) {
        const int j = rows[e];
        const double* Ljk = lower_.data() + kB * e;
        subtract_product(diagonal_.data() + kB * j, Ljk, Ljk);
        int target = structure_.first[std::size_t(j)];
        for (int f = e + 1; f < end; ++f) {
            while (rows[target] != rows[f]) ++target;
            subtract_product(lower_.data() + kB * target, lower_.data() + kB * f, Ljk);
        }
    }
}

void BlockCholesky::solve(std::span<double> x)
{
    for (int body = 0; body < n_; ++body)
        std::copy_n(x.data() + 6 * body, 6, work_.data() + 6 * structure_.position[std::size_t(body)]);
    for (int k = 0; k < n_; ++k) {
        double* xk = work_.data() + 6 * k;
        solve_lower(xk, diagonal_.data() + kB * k);
        for (int e = structure_.first[std::size_t(k)]; e < structure_.first[std::size_t(k) + 1]; ++e)
            subtract_times(work_.data() + 6 * structure_.rows[std::size_t(e)], lower_.data() + kB * e, xk);
    }
    for (int k = n_ - 1; k >= 0; --k) {
        double* xk = work_.data() + 6 * k;
        for (int e = structure_.first[std::size_t(k)]; e < structure_.first[std::size_t(k) + 1]; ++e)
            subtract_transposed_times(xk, lower_.data() + kB * e,
                                      work_.data() + 6 * structure_.rows[std::size_t(e)]);
        solve_lower_transposed(xk, diagonal_.data() + kB * k);
    }
    for (int body = 0; body < n_; ++body)
        std::copy_n(work_.data() + 6 * structure_.position[std::size_t(body)], 6, x.data() + 6 * body);
}

}  // namespace epode
