// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Cholesky's factor L of a small symmetric matrix A = L L^T, dense, in memory of the caller; and sums over its rows.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

namespace epode {

inline double product(const double* a, const double* b, std::size_t n)
{
    double sum[4] = {};
    std::size_t i = 0;
    for (; i + 4 <= n; i += 4)
        for (std::size_t k = 0; k < 4; ++k) sum[k] += a[i + k] * b[i + k];
    for (; i < n; ++i) sum[0] += a[i] * b[i];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

class DenseFactor {
  public:
    DenseFactor() = default;
    // n rows of n; the lower half of A is read, and L is written there by factor().
    DenseFactor(std::span<double> values, int n) : values_(values), n_(n) {}

    int size() const { return n_; }
    double* row(int i) { return values_.data() + std::size_t(i) * std::size_t(n_); }
    const double* row(int i) const { return values_.data() + std::size_t(i) * std::size_t(n_); }

    // False: A is not positive definite.
    bool factor()
    {
        for (int i = 0; i < n_; ++i) {
            double* const its = row(i);
            for (int k = 0; k < i; ++k) its[k] = (its[k] - product(its, row(k), std::size_t(k))) / row(k)[k];
            const double d = its[i] - product(its, its, std::size_t(i));
            if (!(d > 0)) return false;
            its[i] = std::sqrt(d);
        }
        return true;
    }

    // x <- A^-1 x
    void solve(std::span<double> x) const
    {
        for (int i = 0; i < n_; ++i)
            x[std::size_t(i)] = (x[std::size_t(i)] - product(row(i), x.data(), std::size_t(i))) / row(i)[i];
        for (int i = n_; i-- > 0;) {
            double sum = x[std::size_t(i)];
            for (int k = i + 1; k < n_; ++k) sum -= row(k)[i] * x[std::size_t(k)];
            x[std::size_t(i)] = sum / row(i)[i];
        }
    }

  private:
    std::span<double> values_;
    int n_ = 0;
};

}  // namespace epode
