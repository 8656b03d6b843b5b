// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The arithmetic of the sparse factor, once per kind of machine: the same text (front_kernels.inc) compiled
// for the baseline, AVX2 and AVX-512. Every number is computed by the same operations in the same order
// whatever the width, so the bits agree.
//
// A front is an array of 6x6 blocks, each column by column: block (i, c) at 36 (i width + c), rows i below
// the columns after those of the columns. A row of blocks is then one matrix of 6 rows, column by column,
// which is how products want to read it.
#pragma once

#include <span>

#include "solve/exact/factor/symbolic.h"

namespace epode {

// The lists of a SymbolicFactor as plain pointers, for the reason given in contact_kernels.h. `entries` are where
// rows find their numbers in a vector: its entries, or rows where it has none.
struct FrontLists {
    const Front* fronts;
    const int* entries;
    const FrontUpdate* updates;
    const int* places;
};

// Fronts begin .. end - 1 of a symbolic, or of `which` if that is not null.
struct FrontRange {
    const int* which;
    int begin, end;
};

// `x` has six numbers per column of the symbolic factor.
struct FrontKernels {
    const char* name;

    // H becomes L: lower triangles with reciprocal diagonal. Returns how many pivots had to be replaced.
    int (*factor)(const FrontLists& lists, FrontRange range, double* blocks);
    // The two parts of that for one front: its own columns, and the columns `from` .. `to` - 1 of the rows
    // below that have to be changed by its outer product.
    int (*factor_columns)(const FrontLists& lists, int front, double* blocks);
    void (*subtract_outer)(const FrontLists& lists, int front, int from, int to, double* blocks);
    // The blocks of a border go to the fronts that own its rows.
    void (*add_border)(const FrontLists& lists, int border, double* blocks);
    // x = L^-1 x
    void (*forward)(const FrontLists& lists, FrontRange range, const double* blocks, double* x);
    // x = L^-T x, in reverse
    void (*backward)(const FrontLists& lists, FrontRange range, const double* blocks, double* x);
};

// Those that this machine can run; the first is the baseline, the last the fastest.
std::span<const FrontKernels* const> front_kernels();

}  // namespace epode
