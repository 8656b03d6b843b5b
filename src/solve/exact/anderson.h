// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Anderson's acceleration of a fixed point x = g(x): with residuals f = g(x) - x of the last points,
//
//   x <- g - sum_k gamma_k dg_k,   gamma = argmin |f - sum_k gamma_k df_k|
//
// where dg_k and df_k are differences of consecutive points. Where g is affine this is GMRES on x - g(x) = 0
// (Walker, Ni 2011, Anderson acceleration for fixed-point iterations).
#pragma once

#include <span>

#include "base/arena.h"

namespace epode {

class Anderson {
  public:
    // False: out of memory.
    bool prepare(int unknowns, Arena& arena);
    // The next x, not negative. `weights` of the unknowns' residuals: 0 for those that do not matter now.
    void advance(std::span<const double> g, std::span<const double> weights);
    std::span<double> x() { return x_; }

  private:
    static constexpr int kDepth = 6;

    void remember(std::span<const double> g);
    void combine(std::span<const double> weights, double (&gamma)[kDepth]) const;

    int points_ = 0, depth_ = 0;
    std::span<double> x_, g_, f_, dg_[kDepth], df_[kDepth];
};

}  // namespace epode
