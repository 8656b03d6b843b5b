// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Random numbers that are a function of seed, copy, episode, stream and how many were drawn, so that a copy's do not depend on how many
// copies there are, on threads or on the machine: Philox 4x32-10, of Salmon, Moraes, Dror, Shaw, Parallel random numbers: as easy as
// 1, 2, 3, SC 2011. Normal ones by Marsaglia's polar method, with a logarithm of plain arithmetic: libraries differ in theirs.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace epode::batch {

using Words = std::array<std::uint32_t, 4>;

inline Words philox(Words x, std::array<std::uint32_t, 2> key)
{
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t a = std::uint64_t(0xD2511F53u) * x[0], b = std::uint64_t(0xCD9E8D57u) * x[2];
        x = {std::uint32_t(b >> 32) ^ x[1] ^ key[0], std::uint32_t(b), std::uint32_t(a >> 32) ^ x[3] ^ key[1],
             std::uint32_t(a)};
        key[0] += 0x9E3779B9u, key[1] += 0xBB67AE85u;
    }
    return x;
}

// Of x above 0: 2 artanh((m - 1) / (m + 1)) + e ln 2, x = m 2^e, m within sqrt(1/2) and sqrt(2), where 12 terms are exact to 1e-17.
inline double logarithm(double x)
{
    int exponent;
    double m = std::frexp(x, &exponent);
    if (m < 0.70710678118654752) m *= 2, --exponent;
    const double s = (m - 1) / (m + 1), square = s * s;
    double sum = 0;
    for (int k = 23; k > 0; k -= 2) sum = sum * square + 1.0 / k;
    return 2 * s * sum + exponent * 0.69314718055994531;
}

// Of any x: 2^n e^r, x = n ln 2 + r, |r| at most ln 2 / 2, where 14 terms are exact to 1e-17.
inline double exponential(double x)
{
    if (!(x > -700)) return 0;
    x = x < 700 ? x : 700;
    const double n = std::floor(x * 1.4426950408889634074 + 0.5),
                 r = (x - n * 0.693147180369123816490) - n * 1.90821492927058770002e-10;
    double sum = 1;
    for (int k = 14; k > 0; --k) sum = 1 + sum * r / k;
    return std::ldexp(sum, int(n));
}

class Random {
  public:
    enum Stream : std::uint32_t { kReset, kParameters, kNoise, kCommands };

    Random(std::uint64_t seed, std::uint32_t copy, std::uint32_t episode, Stream stream,
           std::uint32_t step = 0)
        : key_{std::uint32_t(seed), std::uint32_t(seed >> 32)},
          counter_{copy, episode, std::uint32_t(stream) | step << 2, 0}
    {}

    // In 0 ... 1, without 1: 53 bits.
    double uniform()
    {
        if (left_ == 0) words_ = philox(counter_, key_), ++counter_[3], left_ = 4;
        const std::uint64_t high = words_[std::size_t(4 - left_)], low = words_[std::size_t(5 - left_)];
        left_ -= 2;
        return double((high << 32 | low) >> 11) * 0x1p-53;
    }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }

    double normal()
    {
        for (;;) {
            const double x = 2 * uniform() - 1, y = 2 * uniform() - 1, s = x * x + y * y;
            if (s > 0 && s < 1) return x * std::sqrt(-2 * logarithm(s) / s);
        }
    }

  private:
    std::array<std::uint32_t, 2> key_;
    Words counter_, words_{};
    int left_ = 0;
};

}  // namespace epode::batch
