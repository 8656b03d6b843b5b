// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Triangles: plane, view, prisms.
#include "geometry/triangle.h"

#include <gtest/gtest.h>

#include "../math/random_numbers.h"

namespace epode {
namespace {

constexpr Real kTight = kSingle ? Real(1e-4) : Real(1e-10);

Triangle some(RandomNumbers& dice)
{
    for (;;) {
        Triangle t;
        const Vec3 a = dice.vec(), b = dice.vec(), c = dice.vec();
        if (length(cross(b - a, c - a)) > Real(0.2) && make_triangle(a, b, c, t)) return t;
    }
}

TEST(Triangle, has_its_corners_in_its_plane_counter_clockwise)
{
    RandomNumbers dice(1);
    for (int trial = 0; trial < 100; ++trial) {
        const Triangle t = some(dice);
        EXPECT_NEAR(length(t.n), 1, kTight);
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(t.height(t.v[k]), 0, kTight);
            EXPECT_GT(dot(cross(t.edge(k), t.edge((k + 1) % 3)), t.n), 0);
        }
        EXPECT_NEAR(t.height(t.v[0] + 2 * t.n), 2, kTight);
    }
    Triangle flat;
    EXPECT_FALSE(make_triangle({0, 0, 0}, {1, 1, 1}, {2, 2, 2}, flat)) << "no area";
}

TEST(Triangle, view_gives_the_farthest_corner_and_the_side_that_is_seen)
{
    RandomNumbers dice(2);
    for (int trial = 0; trial < 200; ++trial) {
        const Triangle t = some(dice);
        const ConvexView view = view_of(t);
        const Vec3 d = dice.direction();
        Real largest = -kInf;
        for (const Vec3 v : t.v) largest = std::fmax(largest, dot(d, v));
        EXPECT_NEAR(dot(d, view.support(d)), largest, kTight);
        Polygon face;
        view.feature(d, face);
        ASSERT_EQ(face.count, 3);
        const Vec3 n = cross(face.points[1] - face.points[0], face.points[2] - face.points[0]);
        EXPECT_GE(dot(n, d), 0);
        for (const Vec3 v : t.v) EXPECT_LE(length(v), view.size * (1 + kTight));
    }
}

// Inside the prism about d means: some move along d ends on the triangle.
bool in_prism(const Triangle& t, Vec3 d, Vec3 p)
{
    const Vec3 q = p - (t.height(p) / dot(t.n, d)) * d;
    for (int k = 0; k < 3; ++k)
        if (dot(cross(t.edge(k), q - t.v[k]), t.n) < 0) return false;
    return true;
}

TEST(Triangle, prisms_keep_of_a_segment_what_lies_over_the_triangle)
{
    RandomNumbers dice(3);
    int kept = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const Triangle t = some(dice);
        Vec3 d = t.n;
        if (trial % 2) d = normalized_or(t.n + Real(0.5) * dice.vec(), t.n);
        const Vec3 a = 2 * dice.vec(), b = 2 * dice.vec();
        const Stretch s = within_prism(t, d, a, b, 0);
        kept += s.empty() ? 0 : 1;
        for (int k = 0; k <= 50; ++k) {
            const Real x = Real(k) / 50;
            if (std::fabs(x - s.from) < 1e-4 || std::fabs(x - s.to) < 1e-4) continue;
            EXPECT_EQ(in_prism(t, d, a + x * (b - a)), x > s.from && x < s.to) << trial << ' ' << x;
        }
    }
    EXPECT_GT(kept, 50);
}

TEST(Triangle, prisms_cut_polygons_to_the_triangle)
{
    RandomNumbers dice(4);
    for (int trial = 0; trial < 200; ++trial) {
        const Triangle t = some(dice);
        Polygon big;  // a large square in the plane, whose part over the triangle is the triangle
        Vec3 p, q;
        plane_space(t.n, p, q);
        for (int k = 0; k < 4; ++k) big.add(t.v[0] + (k == 0 || k == 3 ? 9 : -9) * p + (k < 2 ? 9 : -9) * q);
        clip_to_prism(big, t, t.n, 0);
        ASSERT_GE(big.count, 3);
        for (const Vec3 v : t.v) {
            Real least = kInf;
            for (int k = 0; k < big.count; ++k) least = std::fmin(least, length(big.points[k] - v));
            EXPECT_LT(least, 100 * kTight);
        }
    }
}

}  // namespace
}  // namespace epode
