// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// H = L L^T for symmetric positive definite matrices of 6x6 blocks, one block row per body. The arithmetic is
// in double whatever the library's Real is: weights of 1/CFM leave no digits to spare.
#pragma once

#include <span>

#include "base/arena.h"
#include "solve/exact/factor/front_kernels.h"
#include "solve/exact/factor/symbolic.h"
#include "tasks/tasks.h"

namespace epode {

// Two doubles at a time, which the baseline of x86-64 has. Blocks of six are three of them.
using DoubleLane = double __attribute__((vector_size(16), aligned(8), may_alias));

class BlockCholesky {
  public:
    static constexpr int kBlock = 36;  // doubles of a block, column-major

    // Allocates a matrix of this structure, which must outlive it; false: out of memory.
    bool prepare(const SymbolicFactor& symbolic, const Tasks& tasks, Arena& arena);
    // For tests: uses the kernels of another kind of machine than the best.
    void use(const FrontKernels& kernels) { kernels_ = &kernels; }

    // Where H[a][a] lies and, for a pair in the structure, the block between two bodies. Of a diagonal block
    // the lower triangle counts. `transposed`: the stored block is H[b][a] instead of H[a][b].
    double* diagonal(int body);
    double* between(int a, int b, bool& transposed);

    void clear();                     // H = 0
    int factor();                     // in place; returns how many pivots had to be replaced
    void solve(std::span<double> x);  // x = H^-1 x, six numbers per body in body order

  private:
    FrontLists lists() const;
    // Calls work(t, range) for all fronts of subtrees, in parallel or one after another.
    template <typename Work>
    void for_subtrees(Work work) const;
    template <typename Visit>
    void for_borders(Visit visit);
    int factor_top();

    const SymbolicFactor* symbolic_ = nullptr;
    const FrontKernels* kernels_ = nullptr;
    std::span<double> blocks_;  // of all fronts: H, then L
    std::span<double> work_;    // six numbers per column of the symbolic factor
    std::span<int> bad_;        // pivots, per subtree
    Tasks tasks_;
};

}  // namespace epode
