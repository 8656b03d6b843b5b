// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is left of a parallelogram over a rectangle, against cutting it side by side, and the choice of four
// points against trying all.
#include "geometry/rectangle_cut.h"

#include <gtest/gtest.h>

#include <random>

#include "geometry/best_four.h"
#include "geometry/clip.h"

namespace epode {

namespace {

struct Dice {
    std::mt19937_64 engine;
    Real between(Real lo, Real hi) { return lo + (hi - lo) * Real(double(engine() >> 11) * 0x1p-53); }
};

constexpr Real kSlack = kSingle ? Real(1e-5) : Real(1e-13);

Polygon cut_side_by_side(const Parallelogram& f, Real half_x, Real half_y)
{
    Polygon polygon;
    polygon.add(f.centre + f.u + f.v), polygon.add(f.centre - f.u + f.v);
    polygon.add(f.centre - f.u - f.v), polygon.add(f.centre + f.u - f.v);
    for (const Real sign : {Real(1), Real(-1)})
        clip(polygon, 0, sign, half_x, 0), clip(polygon, 1, sign, half_y, 0);
    return polygon;
}

Vec3 point(const CutPoints& cut, int i) { return {cut.at[0][i], cut.at[1][i], cut.at[2][i]}; }

// How far the points reach along a direction.
Real reach(const Polygon& p, Vec3 d)
{
    Real largest = -kInf;
    for (int i = 0; i < p.count; ++i) largest = std::max(largest, dot(d, p.points[i]));
    return largest;
}

Real reach(const CutPoints& cut, Vec3 d)
{
    Real largest = -kInf;
    for (int i = 0; i < CutPoints::kMax; ++i)
        if (cut.there >> i & 1) largest = std::max(largest, dot(d, point(cut, i)));
    return largest;
}

void expect_same_part(const Parallelogram& f, Real half_x, Real half_y, Real tolerance)
{
    const Polygon polygon = cut_side_by_side(f, half_x, half_y);
    CutPoints cut;
    cut_by_rectangle(f, half_x + kSlack, half_y + kSlack, 4 * kSlack, cut);
    EXPECT_LE(__builtin_popcount(cut.there), 12);
    if (polygon.count == 0) {
        EXPECT_EQ(cut.there, 0u);
        return;
    }
    for (int k = 0; k < 16; ++k) {
        const Real angle = Real(k) * Real(0.39269908169872414);
        const Vec3 d = {std::cos(angle), std::sin(angle), Real(0.3) * Real(k % 3 - 1)};
        EXPECT_NEAR(reach(cut, d), reach(polygon, d), tolerance);
    }
}

}  // namespace

TEST(RectangleCut, is_what_cutting_side_by_side_leaves)
{
    Dice dice{std::mt19937_64(31)};
    int cut_away = 0;
    for (int i = 0; i < 20000; ++i) {
        const Real angle = dice.between(0, 7), lean = dice.between(-1, 1);
        const Real u = dice.between(Real(0.05), 2), v = dice.between(Real(0.05), 2);
        const Parallelogram f = {{dice.between(-2, 2), dice.between(-2, 2), dice.between(-1, 1)},
                                 {u * std::cos(angle), u * std::sin(angle), dice.between(-1, 1)},
                                 {v * (lean * std::cos(angle) - std::sin(angle)),
                                  v * (lean * std::sin(angle) + std::cos(angle)), 0}};
        const Real half_x = dice.between(Real(0.05), 2), half_y = dice.between(Real(0.05), 2);
        cut_away += cut_side_by_side(f, half_x, half_y).count == 0;
        expect_same_part(f, half_x, half_y, kSingle ? Real(2e-3) : Real(1e-10));
    }
    EXPECT_GT(cut_away, 1000);
    EXPECT_LT(cut_away, 19000);
}

// Sides on sides and corners on corners, whole and shifted by parts of their length.
TEST(RectangleCut, is_right_where_sides_lie_on_sides)
{
    for (int shift_x = -5; shift_x <= 5; ++shift_x)
        for (int shift_y = -5; shift_y <= 5; ++shift_y)
            for (int size = 1; size <= 4; ++size) {
                const Real x = Real(0.25) * Real(shift_x), y = Real(0.25) * Real(shift_y);
                const Parallelogram f = {{x, y, 0}, {Real(0.25) * Real(size), 0, 1}, {0, Real(0.5), 0}};
                CutPoints cut;
                cut_by_rectangle(f, Real(0.5) + kSlack, Real(0.5) + kSlack, 4 * kSlack, cut);
                if (size == 2 && std::abs(shift_x) <= 4 && std::abs(shift_y) <= 4)
                    expect_same_part(f, Real(0.5), Real(0.5), 20 * kSlack);
                if (size == 2 && shift_x == 0 && shift_y == 0) { EXPECT_EQ(cut.there, 15u); }
                for (int i = 0; i < CutPoints::kMax; ++i)
                    if (cut.there >> i & 1) {
                        EXPECT_LE(std::fabs(cut.at[0][i]), Real(0.5) + 2 * kSlack);
                        EXPECT_LE(std::fabs(cut.at[1][i]), Real(0.5) + 2 * kSlack);
                        EXPECT_LE(std::fabs(cut.at[1][i] - y), Real(0.5) + 2 * kSlack);
                    }
            }
}

// The deepest is kept, and the four span most of what any four could.
TEST(BestFour, keeps_the_deepest_and_spans_the_area)
{
    Dice dice{std::mt19937_64(32)};
    for (int i = 0; i < 2000; ++i) {
        ManifoldPoints points;
        const int count = 5 + i % 28;
        for (int k = 0; k < count; ++k)
            points.add({dice.between(-1, 1), dice.between(-1, 1), 0}, dice.between(0, Real(0.1)));
        Real deepest = 0, farthest = 0;
        for (int k = 0; k < count; ++k) deepest = std::max(deepest, points.depth[k]);
        int chosen[kBestFour];
        const int kept = best_four(points, {0, 0, 1}, 4, chosen);
        ASSERT_GE(kept, 2);
        for (int k = 0; k < kept; ++k) {
            ASSERT_LT(chosen[k], count);
            for (int m = 0; m < k; ++m) EXPECT_NE(chosen[m], chosen[k]);
        }
        EXPECT_GE(points.depth[chosen[0]], deepest - Real(1e-4));
        const auto offset = [&](int k) {
            return Vec3{points.x[k] - points.x[chosen[0]], points.y[k] - points.y[chosen[0]], 0};
        };
        for (int k = 0; k < count; ++k) farthest = std::max(farthest, length(offset(k)));
        EXPECT_GE(length(offset(chosen[1])), Real(0.999) * farthest);
        const auto aside = [&](int k) { return cross(offset(chosen[1]), offset(k)).z; };
        Real left = 0, right = 0, kept_left = 0, kept_right = 0;
        for (int k = 0; k < count; ++k) left = std::max(left, aside(k)), right = std::min(right, aside(k));
        for (int k = 2; k < kept; ++k)
            kept_left = std::max(kept_left, aside(chosen[k])),
            kept_right = std::min(kept_right, aside(chosen[k]));
        EXPECT_GE(kept_left, Real(0.998) * left - Real(1e-5));
        EXPECT_LE(kept_right, Real(0.998) * right + Real(1e-5));
        int fewer[kBestFour];
        EXPECT_EQ(best_four(points, {0, 0, 1}, 1, fewer), 1);
        EXPECT_EQ(fewer[0], chosen[0]);
    }
}

}  // namespace epode
