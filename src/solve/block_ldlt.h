// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The small systems of one joint: A x = b with A symmetric positive semidefinite, at most 6x6, A = L D L^T.
// A pivot that has lost all its digits belongs to a row that repeats others (a hinge whose stop coincides
// with its axis rows, say); its unknown becomes zero, which is a solution whenever one exists.
#pragma once

#include "base/config.h"
#include "rows/row.h"

namespace epode {

struct BlockLdlt {
    Real L[kMaxJointRows][kMaxJointRows];  // strict lower triangle
    Real inverse[kMaxJointRows];           // 1/D, or 0

    // Reads the lower triangle of A.
    void factor(const Real (&A)[kMaxJointRows][kMaxJointRows], int n)
    {
        Real D[kMaxJointRows];
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < i; ++j) {
                Real s = A[i][j];
                for (int k = 0; k < j; ++k) s -= L[i][k] * D[k] * L[j][k];
                L[i][j] = s * inverse[j];
            }
            Real s = A[i][i];
            for (int k = 0; k < i; ++k) s -= L[i][k] * L[i][k] * D[k];
            const bool sound = s > 64 * kEpsilon * A[i][i];
            D[i] = sound ? s : 0;
            inverse[i] = sound ? 1 / s : 0;
        }
    }

    void solve(Real* x, int n) const
    {
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < i; ++j) x[i] -= L[i][j] * x[j];
        for (int i = 0; i < n; ++i) x[i] *= inverse[i];
        for (int i = n; i-- > 0;)
            for (int j = i + 1; j < n; ++j) x[i] -= L[j][i] * x[j];
    }
};

}  // namespace epode
