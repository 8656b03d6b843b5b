// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The passes over packed rows, once per kind of machine: the same text (row_kernels.inc) compiled for the
// baseline, AVX2 and AVX-512, with the same bits as result. The processor is queried as in contact_kernels.h.
// Plain pointers and counts for the reason given there.
#pragma once

#include <span>

namespace epode {

// Rows between the same one or two bodies, four to a pack. `J` holds per pack the columns of body a, then
// those of body b if there is one, four rows side by side.
struct RowGroup {
    const double* J;
    int a, b;          // bodies; b = -1: only one
    int first, count;  // packs
    int pair;          // where its blocks of H are
};

// The blocks of H = M + J^T D J to which a pair of bodies contributes, 6x6 by columns: H[a][a] and H[b][b],
// whose lower triangles count, and H[a][b] or, transposed, H[b][a].
struct PairBlocks {
    double *aa, *bb, *ab;
    bool transposed;
};

// One side of the box per row: slack s > 0 from the bound, multiplier z >= 0. Without a bound, `present` and
// z are 0 and s is 1.
struct InteriorSide {
    double *s, *z, *present;
    double* inv_s;
    double *t, *kept;  // target change of s z, and the same before a corrector
};

struct InteriorRows {
    const RowGroup* groups;
    int group_count;
    const double *c, *C, *d, *inv_d, *weight_min;
    double *p, *lo, *hi;  // bounds: 0 if there is none
    InteriorSide lower, upper;
    double *r2, *e, *D, *dp;
};

struct RowKernels {
    const char* name;
    // out = J v
    void (*products)(const RowGroup* groups, int count, const double* v, double* out);
    // x += J^T s
    void (*add_transposed)(const RowGroup* groups, int count, const double* s, double* x);

    // H += J^T D J
    void (*assemble)(const RowGroup* groups, int count, const double* D, const PairBlocks* blocks);

    // Takes a step along the direction and computes the residuals there at velocities v: r2, D and r1 += J^T
    // p. Returns the worst of |r2| and min(s d, z), and the sum of s z d.
    struct Residuals {
        double worst, products;
    };
    Residuals (*advance)(const InteriorRows& rows, double step, const double* v, double* r1);

    // t = target/d - s z - second ds dz with the present direction; x += J^T D e
    void (*aim)(const InteriorRows& rows, double target, double second, double* x);
    // Changes t so that products that would leave [1/10, 10] of the target at step `wanted` come back.
    void (*centre)(const InteriorRows& rows, double target, double wanted, double* x);

    // Computes the rest of the direction from dv. `shrink`: the largest -ds/s or -dz/z; `first`, `second`:
    // the change of the sum of s z d per step and per square of the step.
    struct Direction {
        double shrink, first, second;
    };
    Direction (*finish)(const InteriorRows& rows, const double* dv);
};

// The kernels that this machine can run; the first is the baseline, the last the fastest.
std::span<const RowKernels* const> row_kernels();

}  // namespace epode
