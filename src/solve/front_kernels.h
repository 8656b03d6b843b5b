// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The arithmetic of the sparse factor, once per kind of machine: the same text (front_kernels.inc) compiled
// for the baseline and for AVX2. Every number is computed by the same operations in the same order whatever
// the width, so the bits agree.
//
// A front is an array of 6x6 blocks, each column by column: block (i, c) at 36 (i width + c), rows i below
// the columns after those of the columns. A row of blocks is then one matrix of 6 rows, column by column,
// which is how products want to read it.
#pragma once

#include <span>

namespace epode {

// Plain pointers and counts, for the reason given in contact_kernels.h. `rows` counts all rows of a front.
struct FrontKernels {
    const char* name;

    // The lower triangle of the columns becomes L with reciprocal diagonal, the rows below B L^-T. Returns
    // how many pivots had to be replaced.
    int (*factor)(double* front, int width, int rows);

    // target(places[i], places[j]) -= B_i B_j^T for rows j < columns, i >= j of the `count` rows at `from`.
    void (*update)(const double* from, int width, int columns, int count, const int* places, double* target,
                   int target_width);

    // L y = x for the front's columns at `own`, then x_i -= B_i y for the rows below, at x + 6 below[i].
    void (*forward)(const double* front, int width, int rows, const int* below, double* own, double* x);
    // The transposed, in reverse.
    void (*backward)(const double* front, int width, int rows, const int* below, double* own,
                     const double* x);
};

// Those that this machine can run; the first is the baseline, the last the fastest.
std::span<const FrontKernels* const> front_kernels();

}  // namespace epode
