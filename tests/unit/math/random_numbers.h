// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Repeatable random arguments for property tests.
#pragma once

#include <cmath>
#include <vector>

#include "base/random.h"
#include "math/pose.h"

namespace epode {

class RandomNumbers {
  public:
    explicit RandomNumbers(std::uint64_t key) : source_(key) {}

    double unit() { return double(source_.next() >> 11) / 9007199254740992.0; }  // [0, 1)
    Real in(Real low, Real high) { return low + (high - low) * Real(unit()); }
    Real signed_power(Real decades)  // +-10^[-decades, decades]
    {
        const Real size = Real(std::pow(10.0, double(in(-decades, decades))));
        return unit() < 0.5 ? -size : size;
    }
    Vec3 vec() { return {in(-1, 1), in(-1, 1), in(-1, 1)}; }
    Vec3 direction()
    {
        for (;;) {
            Vec3 v = vec();
            if (length2(v) > Real(0.01) && normalize(v)) return v;
        }
    }
    Quat rotation()
    {
        for (;;) {
            Quat q = {in(-1, 1), in(-1, 1), in(-1, 1), in(-1, 1)};
            if (q.w * q.w + length2(q.vec()) > Real(0.01) && normalize(q)) return q;
        }
    }
    int below(int n) { return source_.below(n); }

    // n x n, well conditioned, rows of `stride`; the padding is zero.
    std::vector<Real> positive_definite(int n, int stride)
    {
        std::vector<Real> factor(std::size_t(n) * std::size_t(n));
        for (Real& x : factor) x = in(-1, 1);
        std::vector<Real> A(std::size_t(n) * std::size_t(stride));
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                double sum = i == j ? n : 0.0;
                for (int k = 0; k < n; ++k)
                    sum += double(factor[std::size_t(i * n + k)]) * double(factor[std::size_t(j * n + k)]);
                A[std::size_t(i * stride + j)] = Real(sum);
            }
        return A;
    }

  private:
    CounterRandom source_;
};

}  // namespace epode
