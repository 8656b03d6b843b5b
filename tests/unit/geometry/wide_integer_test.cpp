// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The two words that stand for 128 bits where a compiler has no such integers, compared with those of one that has.
#include "geometry/hulls/wide_integer.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

namespace epode {
namespace {

#if defined(__SIZEOF_INT128__)

__extension__ typedef __int128 WideInt;

// Of all sizes, and often next to a power of two.
std::int64_t any_size(std::mt19937_64& random)
{
    const std::int64_t number = std::int64_t(random()) >> random() % 64;
    return random() % 3 ? number : (std::int64_t(1) << random() % 63) + std::int64_t(random() % 3) - 1;
}

TEST(WideIntegers, in_two_words_agree_with_the_compilers)
{
    std::mt19937_64 random(1);
    for (int i = 0; i < 200000; ++i) {
        const std::int64_t a = any_size(random), b = any_size(random), c = any_size(random),
                           d = any_size(random);
        const WideInt wide = WideInt(a) * b - WideInt(c) * d;
        const TwoWords two = TwoWords(a) * b - TwoWords(c) * d;
        ASSERT_EQ(double(two), double(wide)) << a << " " << b << " " << c << " " << d;
        ASSERT_EQ(two.sign(), sign(wide));
    }
}

// As a minor of three by three: the first product has two words already.
TEST(WideIntegers, in_two_words_multiply_what_has_two_words)
{
    std::mt19937_64 random(2);
    const auto grid = [&] {
        return std::int64_t(random() % (std::uint64_t(1) << 42)) - (std::int64_t(1) << 41);
    };
    for (int i = 0; i < 200000; ++i) {
        const std::int64_t a = grid(), b = grid(), c = grid(), d = grid(), e = grid(), f = grid();
        const WideInt wide = (WideInt(a) * b - WideInt(c) * d) * e + WideInt(f);
        const TwoWords two = (TwoWords(a) * b - TwoWords(c) * d) * e + TwoWords(f);
        ASSERT_EQ(double(two), double(wide)) << a << " " << b << " " << c << " " << d << " " << e << " " << f;
    }
}

// Half-way between two doubles the even one is taken, and one bit below decides otherwise.
TEST(WideIntegers, in_two_words_round_as_the_compilers)
{
    for (int up = 1; up < 64; ++up)
        for (const std::int64_t below : {-1, 0, 1})
            for (const std::int64_t odd : {0, 1}) {
                const std::int64_t half = (std::int64_t(1) << 54) + 2 + 4 * odd, shift = std::int64_t(1)
                                                                                         << (up - 1);
                const WideInt wide = WideInt(half) * shift + below;
                ASSERT_EQ(double(TwoWords(half) * shift + below), double(wide))
                    << up << " " << below << " " << odd;
                ASSERT_EQ(double(-(TwoWords(half) * shift + below)), -double(wide));
            }
}

#endif

}  // namespace
}  // namespace epode
