// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Dense vectors and row-major matrices behind plain pointers, as ODE's matrix functions hand them in.
// A(p x r) means p rows and r columns; the row stride of an r-column matrix is padded(r) unless said.
// Sums run in eight interleaved parts that are added in a fixed order: the compiler may vectorise them
// without reassociating, so every machine makes the same bits.
#pragma once

#include <cstddef>

#include "base/config.h"

namespace epode {

// ODE's dPAD: rows of one number stay, longer ones are padded to a multiple of four.
constexpr int padded(int columns) { return columns > 1 ? (columns + 3) & ~3 : columns; }

// How many numbers a padded n-column matrix of `rows` rows takes.
constexpr std::size_t padded_size(int rows, int columns)
{
    return std::size_t(rows) * std::size_t(padded(columns));
}

// Row i of a matrix with the given stride; the product is formed in pointer width.
template <typename T>
constexpr T* row_of(T* matrix, int i, int stride)
{
    return matrix + std::ptrdiff_t(i) * stride;
}

Real dot(const Real* a, const Real* b, int n);

// The same sum over vectors whose numbers become known from the front on.
class GrowingDot {
  public:
    void grow(const Real* a, const Real* b, int known);  // the first `known`, whole groups of eight of them
    Real finish(const Real* a, const Real* b, int n);    // dot(a, b, n)

  private:
    Real part_[8] = {};
    int at_ = 0;
};

// y -= s x
void subtract_scaled(Real* y, Real s, const Real* x, int n);

// A(p x r) = B C, B^T C, B C^T. A must not overlap B or C; its padding stays as it is.
void multiply(Real* A, const Real* B, const Real* C, int p, int q, int r);  // B p x q, C q x r
void multiply_transposed_left(Real* A, const Real* B, const Real* C, int p, int q,
                              int r);  // B q x p, C q x r
void multiply_transposed_right(Real* A, const Real* B, const Real* C, int p, int q,
                               int r);  // B p x q, C r x q

// Deletes row and column r of an n x n matrix in place; the stride stays, what falls out is left behind.
void remove_row_and_column(Real* A, int n, int stride, int r);

}  // namespace epode
