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

#include "solve/symbolic.h"

namespace epode {

// The lists of a FactorPlan as plain pointers, for the reason given in contact_kernels.h.
struct FrontLists {
    const Front* fronts;
    const int* rows;
    const FrontUpdate* updates;
    const int* places;
};

// On fronts begin .. end - 1 of a plan. `x` has six numbers per column.
struct FrontKernels {
    const char* name;

    // H becomes L: lower triangles with reciprocal diagonal. Returns how many pivots had to be replaced.
    int (*factor)(const FrontLists& lists, int begin, int end, double* blocks);
    // x = L^-1 x
    void (*forward)(const FrontLists& lists, int begin, int end, const double* blocks, double* x);
    // x = L^-T x, fronts in reverse
    void (*backward)(const FrontLists& lists, int begin, int end, const double* blocks, double* x);
};

// Those that this machine can run; the first is the baseline, the last the fastest.
std::span<const FrontKernels* const> front_kernels();

}  // namespace epode
