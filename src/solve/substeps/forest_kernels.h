// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The arithmetic of joint_forest.h for four bodies side by side, once per kind of machine, with the same bits as result. None of
// the four hangs on another. Triangles are stored by rows. A pivot that is not above zero becomes one, which leaves its row alone.
//
// A solution is products alone, of which many are under way at a time: substitutions in triangles, each of whose numbers waits for the
// one before, took twice the time.
#pragma once

#include <span>

#include "simd/lanes.h"

namespace epode {

struct ForestLanes : LanesOf<double, 4> {};

// What is computed of a body; six numbers and two more, so that four neighbours are read at a time.
struct ForestNode {
    double P[24];  // a triangle; the inverse where nothing hangs on the body
    double f[8], dv[8];
};

// Lanes without a body have P = 1, and those without a parent one that is never moved. Rows that a lane does not have are zero.
struct ForestBatch {
    int rows;     // of the lane that has the most
    bool leaves;  // nothing hangs on any of the four
    ForestNode *body[4], *parent[4];
    ForestLanes *D, *Q;          // triangles
    ForestLanes *A, *B, *T, *Y;  // 6 a row; A and B are J_a and J_b
    ForestLanes* x;              // one a row
};

struct ForestKernels {
    const char* name;
    // Before: A, B, and C in x. After: D, Q, T and Y, and in the parents' P what they carry.
    void (*factor)(const ForestBatch& batch);
    // Before: r in x. After: q in x, and in the parents' f what goes to them.
    void (*eliminate)(const ForestBatch& batch);
    // After: dp in x, and dv, unless all are leaves.
    void (*substitute)(const ForestBatch& batch);
};

// The kernels that this machine can run; the first is the baseline, the last the fastest.
std::span<const ForestKernels* const> forest_kernels();

}  // namespace epode
