// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The arithmetic of the sparse factor, once per kind of machine: the same text (front_kernels.inc) compiled
// for the baseline, AVX2 and AVX-512. Every number results from the same operations in the same order, so the
// bits agree.
//
// A front is an array of 6x6 blocks, each stored by columns: block (i, c) at 36 (i width + c); the rows i
// below the columns follow those of the columns. A row of blocks is then one matrix of 6 rows, stored by
// columns, in the order in which products read it.
#pragma once

#include <span>

#include "solve/exact/factor/symbolic.h"

namespace epode {

// The lists of a SymbolicFactor as plain pointers, for the reason given in contact_kernels.h. `entries`:
// where rows find their numbers in a vector; the symbolic factor's entries, or its rows where it has none.
struct FrontLists {
    const Front* fronts;
    const int* entries;
    const FrontUpdate* updates;
    const int* places;
};

// Fronts begin .. end - 1 of a symbolic factor, or of `which` if that is not null.
struct FrontRange {
    const int* which;
    int begin, end;
};

// `x` has six numbers per column of the symbolic factor.
struct FrontKernels {
    const char* name;

    // Turns H into L: lower triangles with reciprocal diagonal. Returns how many pivots had to be replaced.
    int (*factor)(const FrontLists& lists, FrontRange range, double* blocks);
    // The two parts of that for one front: its own columns, and the columns `from` .. `to` - 1 of the rows
    // below that its outer product changes.
    int (*factor_columns)(const FrontLists& lists, int front, double* blocks);
    void (*subtract_outer)(const FrontLists& lists, int front, int from, int to, double* blocks);
    // Adds the blocks of a border to the fronts that own its rows.
    void (*add_border)(const FrontLists& lists, int border, double* blocks);
    // x = L^-1 x
    void (*forward)(const FrontLists& lists, FrontRange range, const double* blocks, double* x);
    // x = L^-T x, in reverse
    void (*backward)(const FrontLists& lists, FrontRange range, const double* blocks, double* x);
};

// The kernels that this machine can run; the first is the baseline, the last the fastest.
std::span<const FrontKernels* const> front_kernels();

}  // namespace epode
