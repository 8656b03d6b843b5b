// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Own trigonometry against the C library's in extended precision, in units of the last place of the result.
#include "math/trig.h"

#include <gtest/gtest.h>

#include <cmath>

#include "random_numbers.h"

namespace epode {
namespace {

double ulps(Real got, long double truth)
{
    const Real nearest = std::fabs(Real(truth));
    const Real step = std::nextafter(nearest, kInf) - nearest;
    return double(std::fabs((long double)(got)-truth) / (long double)(step));
}

constexpr double kBound = 2;

// MinGW-w64's functions of long doubles are the processor's own, whose pi has 66 bits: no reference.
#if defined(_WIN32)
constexpr bool kHasReference = false;
#else
constexpr bool kHasReference = true;
#endif

TEST(Trig, sine_and_cosine_are_within_two_last_places)
{
    if (!kHasReference) GTEST_SKIP();
    RandomNumbers random(1);
    for (Real range :
         {Real(0.01), Real(0.8), Real(3.2), Real(100), Real(1e4), Real(1e6), Real(1e8), Real(1e12)}) {
        double worst_sin = 0, worst_cos = 0;
        for (int i = 0; i < 100000; ++i) {
            Real x = random.in(-range, range);
            // Every fourth argument next to a multiple of pi/2, where the phase cancels.
            if (i % 4 == 0) x = std::floor(x / (kPi / 2)) * (kPi / 2) + random.in(-1, 1) * Real(1e-7);
            worst_sin = std::fmax(worst_sin, ulps(sin(x), std::sin((long double)(x))));
            worst_cos = std::fmax(worst_cos, ulps(cos(x), std::cos((long double)(x))));
        }
        EXPECT_LT(worst_sin, kBound) << "range " << range;
        EXPECT_LT(worst_cos, kBound) << "range " << range;
    }
}

TEST(Trig, sine_and_cosine_stay_on_the_unit_circle_at_any_size)
{
    RandomNumbers random(2);
    for (int i = 0; i < 10000; ++i) {
        const Real x = random.signed_power(kSingle ? 30 : 100);
        EXPECT_LE(std::fabs(sin(x)), 1 + kEpsilon);
        EXPECT_LE(std::fabs(cos(x)), 1 + kEpsilon);
        EXPECT_NEAR(sin(x) * sin(x) + cos(x) * cos(x), 1, 4 * kEpsilon);
        EXPECT_EQ(sin(-x), -sin(x));
        EXPECT_EQ(cos(-x), cos(x));
    }
    EXPECT_TRUE(std::isnan(sin(std::numeric_limits<Real>::quiet_NaN())));
    EXPECT_TRUE(std::isnan(cos(kInf)));
}

TEST(Trig, arc_functions_are_within_two_last_places)
{
    if (!kHasReference) GTEST_SKIP();
    RandomNumbers random(3);
    double worst_atan = 0, worst_acos = 0;
    for (int i = 0; i < 200000; ++i) {
        const Real y = random.signed_power(Real(i % 12)), x = random.signed_power(1);
        worst_atan = std::fmax(worst_atan, ulps(atan2(y, x), std::atan2((long double)(y), (long double)(x))));
        const Real near_one = 1 - std::exp(random.in(-34, 0));
        const Real c = i % 3 ? random.in(-1, 1) : i % 2 ? near_one : -near_one;
        worst_acos = std::fmax(worst_acos, ulps(acos(c), std::acos((long double)(c))));
    }
    EXPECT_LT(worst_atan, kBound);
    EXPECT_LT(worst_acos, kBound);
}

TEST(Trig, arc_tangent_knows_all_quadrants_and_axes)
{
    EXPECT_EQ(atan2(0, 0), 0);
    EXPECT_EQ(atan2(0, 2), 0);
    EXPECT_EQ(atan2(0, -2), kPi);
    EXPECT_EQ(atan2(3, 0), kPi / 2);
    EXPECT_EQ(atan2(-3, 0), -kPi / 2);
    EXPECT_NEAR(atan2(1, 1), kPi / 4, 2 * kEpsilon);
    EXPECT_NEAR(atan2(1, -1), 3 * kPi / 4, 4 * kEpsilon);
    EXPECT_NEAR(atan2(-1, -1), -3 * kPi / 4, 4 * kEpsilon);
}

TEST(Trig, arc_cosine_clamps_its_argument)
{
    EXPECT_EQ(acos(1), 0);
    EXPECT_EQ(acos(Real(1.5)), 0);
    EXPECT_EQ(acos(-1), kPi);
    EXPECT_EQ(acos(-7), kPi);
    EXPECT_EQ(acos(0), kPi / 2);
}

TEST(Trig, sinc_is_smooth_through_zero)
{
    EXPECT_EQ(sinc(0), 1);
    RandomNumbers random(4);
    for (int i = 0; i < 20000; ++i) {
        const Real x = random.signed_power(4) * Real(1e-4);
        EXPECT_LT(ulps(sinc(x), std::sin((long double)(x)) / (long double)(x)), kBound) << x;
    }
}

}  // namespace
}  // namespace epode
