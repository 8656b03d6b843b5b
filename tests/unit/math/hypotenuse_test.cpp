// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The root of a sum of squares: exact triangles, within an ulp, and the same bits on every machine.
#include "math/hypotenuse.h"
#include "golden/golden.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "math/double_double.h"

namespace epode {
namespace {

TEST(Hypotenuse, of_right_triangles_is_exact)
{
    EXPECT_EQ(hypotenuse(3.0, -4.0), 5);
    EXPECT_EQ(hypotenuse(-5.0, 12.0), 13);
    EXPECT_EQ(hypotenuse(3e300, 4e300), 5e300);
    EXPECT_EQ(hypotenuse(3 * 0x1p-900, 4 * 0x1p-900), 5 * 0x1p-900);
    EXPECT_EQ(hypotenuse(0.0, 0.0), 0);
    EXPECT_EQ(hypotenuse(0.0, -2.0), 2);
    EXPECT_EQ(hypotenuse(3.0f, 4.0f), 5);
}

// The golden hash is that of x86-64; the square is compared in 106 bits.
TEST(Hypotenuse, is_within_an_ulp_and_has_the_same_bits_everywhere)
{
    std::uint64_t hash = 0, state = 1;
    const auto next = [&] {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return double(state >> 11) * 0x1p-53;
    };
    for (int i = 0; i < 100000; ++i) {
        const double x = next(), y = next() * (i % 2 ? 1 : 1e-3), h = hypotenuse(x, y);
        const DoubleDouble error = two_product(h, h) - (two_product(x, x) + two_product(y, y));
        ASSERT_LT(std::fabs(error.hi), 2 * h * h * std::numeric_limits<double>::epsilon());
        std::uint64_t bits;
        std::memcpy(&bits, &h, sizeof bits);
        hash = (hash ^ bits) * 0x100000001b3u;
    }
    EXPECT_TRUE(golden::is_golden("unit/hypotenuse", hash));
}

}  // namespace
}  // namespace epode
