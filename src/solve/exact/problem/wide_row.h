// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A row of a coupling in the exact solver: J v is a sum over any number of bodies. In H = 1 + J^T D J its
// bodies form a clique. Rejected: leaving such rows outside H and adding them by Woodbury's formula; where a
// coupling repeats what joints hold, its Schur complement is all rounding, and the refinement diverges.
#pragma once

#include <span>

namespace epode {

// The part that belongs to one dynamic body, in the problem's coordinates.
struct alignas(16) WideTerm6 {
    double J[6];
    int body;
};
using WideJacobian = std::span<const WideTerm6>;

inline double wide_product(WideJacobian row, const double* v)  // J v
{
    double sum = 0;
    for (const WideTerm6& term : row)
        for (int k = 0; k < 6; ++k) sum += term.J[k] * v[6 * term.body + k];
    return sum;
}

inline void add_wide_transposed(WideJacobian row, double s, double* x)  // x += J^T s
{
    for (const WideTerm6& term : row)
        for (int k = 0; k < 6; ++k) x[6 * term.body + k] += term.J[k] * s;
}

}  // namespace epode
