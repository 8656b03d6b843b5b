// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Products are built row by row as sums of scaled rows (B C, B^T C) or as inner products of rows (B C^T):
// all three walk memory forwards. Blocking for caches would pay only from several hundred columns on,
// which nothing in the library or its clients reaches.
#include "math/dense.h"

#include <algorithm>
#include <cstring>

namespace epode {
namespace {

void add_scaled(Real* y, Real s, const Real* x, int n)
{
    for (int i = 0; i < n; ++i) y[i] += s * x[i];
}

}  // namespace

Real dot(const Real* a, const Real* b, int n)
{
    constexpr int kParts = 8;
    Real part[kParts] = {};
    int i = 0;
    for (; i + kParts <= n; i += kParts)
        for (int k = 0; k < kParts; ++k) part[k] += a[i + k] * b[i + k];
    for (int k = 0; i + k < n; ++k) part[k] += a[i + k] * b[i + k];
    return ((part[0] + part[4]) + (part[2] + part[6])) + ((part[1] + part[5]) + (part[3] + part[7]));
}

void GrowingDot::grow(const Real* a, const Real* b, int known)
{
    Real part[8];
    std::copy_n(part_, 8, part);  // registers: the members might be what a and b point to
    int i = at_;
    for (; i + 8 <= known; i += 8)
        for (int k = 0; k < 8; ++k) part[k] += a[i + k] * b[i + k];
    std::copy_n(part, 8, part_);
    at_ = i;
}

Real GrowingDot::finish(const Real* a, const Real* b, int n)
{
    grow(a, b, n);
    for (int k = 0; at_ + k < n; ++k) part_[k] += a[at_ + k] * b[at_ + k];
    return ((part_[0] + part_[4]) + (part_[2] + part_[6])) + ((part_[1] + part_[5]) + (part_[3] + part_[7]));
}

void subtract_scaled(Real* y, Real s, const Real* x, int n)
{
    for (int i = 0; i < n; ++i) y[i] -= s * x[i];
}

void multiply(Real* A, const Real* B, const Real* C, int p, int q, int r)
{
    for (int i = 0; i < p; ++i) {
        Real* out = row_of(A, i, padded(r));
        const Real* b = row_of(B, i, padded(q));
        std::fill_n(out, r, Real(0));
        for (int k = 0; k < q; ++k) add_scaled(out, b[k], row_of(C, k, padded(r)), r);
    }
}

void multiply_transposed_left(Real* A, const Real* B, const Real* C, int p, int q, int r)
{
    for (int i = 0; i < p; ++i) {
        Real* out = row_of(A, i, padded(r));
        std::fill_n(out, r, Real(0));
        for (int k = 0; k < q; ++k) add_scaled(out, row_of(B, k, padded(p))[i], row_of(C, k, padded(r)), r);
    }
}

void multiply_transposed_right(Real* A, const Real* B, const Real* C, int p, int q, int r)
{
    for (int i = 0; i < p; ++i) {
        Real* out = row_of(A, i, padded(r));
        const Real* b = row_of(B, i, padded(q));
        for (int j = 0; j < r; ++j) out[j] = dot(b, row_of(C, j, padded(q)), q);
    }
}

void remove_row_and_column(Real* A, int n, int stride, int r)
{
    const std::size_t left = sizeof(Real) * std::size_t(r);
    const std::size_t right = sizeof(Real) * std::size_t(n - 1 - r);
    for (int i = 0; i < n - 1; ++i) {
        Real* to = row_of(A, i, stride);
        const Real* from = row_of(A, i < r ? i : i + 1, stride);
        if (from != to && left) std::memcpy(to, from, left);
        if (right) std::memmove(to + r, from + r + 1, right);
    }
}

}  // namespace epode
