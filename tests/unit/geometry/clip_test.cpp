// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Cutting polygons: areas, order, slack, segments and points; and the thinning of manifolds to four points.
#include "geometry/clip.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "collide/contact_sink.h"

using namespace epode;

namespace {

constexpr Real kTight = kSingle ? Real(1e-4) : Real(1e-10);

Real area(const Polygon& p)
{
    Vec3 sum;
    for (int i = 1; i + 1 < p.count; ++i)
        sum += cross(p.points[i] - p.points[0], p.points[i + 1] - p.points[0]);
    return Real(0.5) * sum.z;
}

Polygon square(Real half)
{
    Polygon p;
    p.add({half, half, 0}), p.add({-half, half, 0}), p.add({-half, -half, 0}), p.add({half, -half, 0});
    return p;
}

TEST(Clip, two_parts_make_the_whole)
{
    std::mt19937_64 engine(3);
    for (int i = 0; i < 500; ++i) {
        const Real angle = Real(double(engine() >> 11) * 0x1p-53) * 2 * kPi;
        const Real limit = Real(double(engine() >> 11) * 0x1p-52 - 1);
        const Vec3 n = {std::cos(angle), std::sin(angle), 0};
        Polygon one = square(1), other = square(1);
        clip(one, n, limit, 0);
        clip(other, -n, -limit, 0);
        EXPECT_NEAR(area(one) + area(other), 4, kTight);
        EXPECT_GE(area(one), -kTight) << "still counter-clockwise";
    }
}

TEST(Clip, flush_edges_stay_whole)
{
    Polygon p = square(1);
    clip(p, {1, 0, 0}, 1 - kEpsilon, 8 * kEpsilon);
    EXPECT_EQ(p.count, 4);
    EXPECT_EQ(p.points[0].x, 1);
}

TEST(Clip, segment_and_point)
{
    Polygon segment;
    segment.add({-1, 0, 0}), segment.add({3, 0, 0});
    clip(segment, {1, 0, 0}, 1, 0);
    ASSERT_EQ(segment.count, 2);
    EXPECT_NEAR(segment.points[1].x, 1, kTight);
    clip(segment, {-1, 0, 0}, -2, 0);
    EXPECT_EQ(segment.count, 0);
    Polygon point;
    point.add({0, 0, 0});
    clip(point, {1, 0, 0}, 0, 0);
    EXPECT_EQ(point.count, 1);
    clip(point, {1, 0, 0}, -1, 0);
    EXPECT_EQ(point.count, 0);
}

TEST(Clip, prism_keeps_the_intersection)
{
    Polygon big = square(2);
    clip_to_prism(big, square(1), {0, 0, 1}, 0);
    EXPECT_NEAR(area(big), 4, kTight);
    Polygon small = square(Real(0.5));
    for (int i = 0; i < 4; ++i) small.points[i].z = 7;  // height does not matter
    clip_to_prism(small, square(1), {0, 0, 1}, 0);
    EXPECT_EQ(small.count, 4);
}

std::vector<ContactPoint> ring(int count)
{
    std::vector<ContactPoint> out;
    for (int i = 0; i < count; ++i) {
        const Real a = 2 * kPi * Real(i) / Real(count);
        out.push_back({{std::cos(a), std::sin(a), 0}, {0, 0, 1}, Real(0.1)});
    }
    return out;
}

TEST(ContactSink, keeps_four_well_spread_points)
{
    dContactGeom contacts[8];
    ContactSink sink(contacts, int(sizeof(dContactGeom)), 8, false);
    sink.add_manifold(ring(8));
    ASSERT_EQ(sink.count(), 4);
    Polygon p;  // deepest, opposite, left, right
    for (const int i : {0, 3, 1, 2}) p.add(load(contacts[i].pos));
    EXPECT_GT(std::fabs(area(p)), Real(1.9)) << "an inscribed square has area 2";
}

TEST(ContactSink, the_deepest_survives_any_capacity)
{
    for (int capacity = 1; capacity <= 6; ++capacity)
        for (int deepest = 0; deepest < 6; ++deepest) {
            std::vector<ContactPoint> points = ring(6);
            points[std::size_t(deepest)].depth = Real(0.2);
            dContactGeom contacts[7] = {};
            contacts[capacity].depth = -5;
            ContactSink sink(contacts, int(sizeof(dContactGeom)), capacity, false);
            sink.add_manifold(points);
            EXPECT_LE(sink.count(), capacity);
            EXPECT_EQ(contacts[0].depth, Real(0.2));
            EXPECT_EQ(contacts[capacity].depth, Real(-5));
        }
}

TEST(ContactSink, stride_and_room_are_the_callers)
{
    struct Wide {
        dContactGeom geom;
        char rest[40];
    } wide[3];
    ContactSink sink(&wide[0].geom, int(sizeof(Wide)), 2, false);
    EXPECT_TRUE(sink.add({{1, 2, 3}, {0, 0, 1}, Real(0.5)}));
    EXPECT_TRUE(sink.add({{4, 5, 6}, {0, 0, 1}, Real(-0.5)}));
    EXPECT_FALSE(sink.add({{7, 8, 9}, {0, 0, 1}, Real(0.5)}));
    EXPECT_EQ(wide[1].geom.pos[1], 5);
    EXPECT_EQ(wide[1].geom.depth, 0) << "never negative";
    EXPECT_EQ(wide[1].geom.side1, -1);
}

}  // namespace
