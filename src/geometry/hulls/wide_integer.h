// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Integers of 128 bits for exact minors: the compiler's where it has them (64-bit processors), elsewhere two words, modulo 2^128 as
// those are.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace epode {

// value = high * 2^64 + low, in two's complement.
class TwoWords {
  public:
    constexpr TwoWords(std::int64_t value) : high_(std::uint64_t(value >> 63)), low_(std::uint64_t(value)) {}

    friend constexpr TwoWords operator+(TwoWords a, TwoWords b)
    {
        const std::uint64_t low = a.low_ + b.low_;
        return {a.high_ + b.high_ + (low < a.low_ ? 1 : 0), low};
    }
    friend constexpr TwoWords operator-(TwoWords a) { return TwoWords{~a.high_, ~a.low_} + TwoWords(1); }
    friend constexpr TwoWords operator-(TwoWords a, TwoWords b) { return a + -b; }
    friend constexpr TwoWords operator*(TwoWords a, TwoWords b)
    {
        const TwoWords low = product(a.low_, b.low_);
        return {low.high_ + a.high_ * b.low_ + a.low_ * b.high_, low.low_};
    }
    constexpr int sign() const { return is_negative() ? -1 : (high_ | low_) != 0; }
    // The nearest double, of two the even one. Bits below the 64 leading ones count as one that is set.
    explicit operator double() const
    {
        const TwoWords size = is_negative() ? -*this : *this;
        const double sign = is_negative() ? -1 : 1;
        if (size.high_ == 0) return sign * double(size.low_);
        const int shift = std::countl_zero(size.high_);
        const std::uint64_t below = size.low_ << shift;
        const std::uint64_t above = shift == 0 ? size.high_ : size.high_ << shift | size.low_ >> (64 - shift);
        return sign * std::ldexp(double(above | (below != 0 ? 1u : 0u)), 64 - shift);
    }

  private:
    constexpr TwoWords(std::uint64_t high, std::uint64_t low) : high_(high), low_(low) {}
    constexpr bool is_negative() const { return high_ >> 63 != 0; }
    static constexpr TwoWords product(std::uint64_t a, std::uint64_t b)
    {
        const std::uint64_t a0 = std::uint32_t(a), a1 = a >> 32, b0 = std::uint32_t(b), b1 = b >> 32;
        const std::uint64_t first = a0 * b0, second = a1 * b0 + (first >> 32),
                            third = a0 * b1 + std::uint32_t(second);
        return {a1 * b1 + (second >> 32) + (third >> 32), third << 32 | std::uint32_t(first)};
    }

    std::uint64_t high_, low_;
};

#if defined(__SIZEOF_INT128__)
__extension__ typedef __int128 Int128;
inline int sign(Int128 x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
#else
using Int128 = TwoWords;
inline int sign(Int128 x) { return x.sign(); }
#endif

}  // namespace epode
