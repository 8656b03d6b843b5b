// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Closest points of segments and boxes against dense sampling, and the cases where a formula divides by
// nothing.
#include "geometry/closest.h"

#include <gtest/gtest.h>

#include <random>

#include "geometry/root.h"

using namespace epode;

namespace {

constexpr Real kTight = kSingle ? Real(1e-4) : Real(1e-9);

Vec3 random_point(std::mt19937_64& engine)
{
    const auto unit = [&] { return Real(double(engine() >> 11) * 0x1p-52 - 1); };
    const Real x = unit(), y = unit();
    return {x, y, unit()};
}

Real sampled(Vec3 a1, Vec3 a2, Vec3 b1, Vec3 b2)
{
    Real best = kInf;
    for (int i = 0; i <= 100; ++i) {
        const Vec3 p = a1 + (Real(i) / 100) * (a2 - a1);
        best = std::fmin(best, length(p - (b1 + closest_on_segment(b1, b2, p) * (b2 - b1))));
    }
    return best;
}

TEST(Closest, segments_agree_with_sampling)
{
    std::mt19937_64 engine(1);
    for (int i = 0; i < 2000; ++i) {
        Vec3 a1 = random_point(engine), a2 = random_point(engine), b1 = random_point(engine),
             b2 = random_point(engine);
        if (i % 4 == 1) b2 = b1 + Real(0.7) * (a2 - a1);  // parallel
        if (i % 4 == 2) b2 = b1;                          // a point
        if (i % 8 == 3) a2 = a1, b2 = b1;
        Vec3 p, q;
        closest_segment_points(a1, a2, b1, b2, p, q);
        const Real s = closest_on_segment(a1, a2, p), t = closest_on_segment(b1, b2, q);
        EXPECT_LT(length(a1 + s * (a2 - a1) - p), kTight) << "p is on the first segment";
        EXPECT_LT(length(b1 + t * (b2 - b1) - q), kTight);
        const Real reference = sampled(a1, a2, b1, b2);
        EXPECT_LE(length(p - q), reference + kTight);
        EXPECT_GE(length(p - q), reference - Real(0.02));
    }
}

TEST(Closest, parallel_segments_give_an_end_point)
{
    Vec3 p, q;
    closest_segment_points({0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {3, 1, 0}, p, q);
    EXPECT_NEAR(length(p - q), 1, kTight);
    const bool end = q == Vec3{1, 1, 0} || q == Vec3{3, 1, 0} || p == Vec3{0, 0, 0} || p == Vec3{4, 0, 0};
    EXPECT_TRUE(end);
}

TEST(Closest, segment_to_box_agrees_with_sampling)
{
    std::mt19937_64 engine(2);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 half = Real(0.5) * abs(random_point(engine));
        const Vec3 a = Real(2) * random_point(engine);
        Vec3 b = Real(2) * random_point(engine);
        if (i % 3 == 1) b = {b.x, a.y, a.z};
        if (i % 3 == 2) b = {b.x, b.y, a.z};
        const auto gap = [&](Real t) {
            const Vec3 p = a + t * (b - a);
            return length(p - clamp_to_box(p, half));
        };
        const Real found = gap(closest_to_box(a, b, half));
        Real reference = kInf;
        for (int k = 0; k <= 1000; ++k) reference = std::fmin(reference, gap(Real(k) / 1000));
        EXPECT_LE(found, reference + kTight);
    }
}

TEST(Closest, stretch_above_a_face_gives_its_middle)
{
    EXPECT_NEAR(closest_to_box({-2, 0, 3}, {4, 0, 3}, {1, 1, 1}), Real(1) / 3, kTight);
    EXPECT_NEAR(closest_to_box({5, 0, 0}, {5, 0, 0}, {1, 1, 1}), Real(0.5), Real(0.5));
}

TEST(RisingRoot, finds_kinks_and_smooth_roots)
{
    const auto kink = [](Real t) { return t < Real(0.3) ? -1000 * kEpsilon : t - Real(0.3); };
    EXPECT_NEAR(rising_root(kink, Real(0), kink(0), Real(1), kink(1)), Real(0.3), Real(1e-6));
    int calls = 0;
    const auto smooth = [&calls](Real t) { return ++calls, t * t * t + t - 1; };
    const Real root = rising_root(smooth, Real(0), Real(-1), Real(1), Real(1));
    EXPECT_NEAR(root * root * root + root, 1, 16 * kEpsilon);
    EXPECT_LT(calls, 30);
}

}  // namespace
