// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// GJK and the polytope on a polyhedron that knows nothing of boxes: eight points. Both must agree with the
// box functions, which share no code with them; and the convex pair must make manifolds of such a polyhedron.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "collide/pairs/pairs.h"
#include "geometry/closest.h"
#include "geometry/overlap/box_box.h"
#include "geometry/overlap/epa.h"
#include "geometry/overlap/gjk.h"

using namespace epode;

namespace {

constexpr Real kTight = kSingle ? Real(1e-4) : Real(1e-9);

struct Hull {
    Vec3 points[8];
};

Vec3 hull_support(const void* shape, Vec3 d)
{
    const Hull& hull = *static_cast<const Hull*>(shape);
    return *std::max_element(hull.points, hull.points + 8,
                             [d](Vec3 a, Vec3 b) { return dot(a, d) < dot(b, d); });
}

void hull_feature(const void* shape, Vec3 d, Polygon& out)
{
    const Vec3 corner = static_cast<const Hull*>(shape)->points[0];
    const Box box = {abs(corner)};
    const ConvexView view = view_of(box, Pose{});
    view.local_feature(&box, d, out);
}

Hull hull_of(const Box& b)
{
    Hull h;
    for (int i = 0; i < 8; ++i)
        h.points[i] = {i & 1 ? b.half.x : -b.half.x, i & 2 ? b.half.y : -b.half.y,
                       i & 4 ? b.half.z : -b.half.z};
    return h;
}

ConvexView view_of_hull(const Hull& hull, const Pose& pose)
{
    ConvexView v;
    v.shape = &hull, v.local_support = hull_support, v.local_feature = hull_feature, v.pose = pose;
    v.size = length(hull.points[0]);
    return v;
}

struct Dice {
    std::mt19937_64 engine;
    Real between(Real lo, Real hi) { return lo + (hi - lo) * Real(double(engine() >> 11) * 0x1p-53); }
    Vec3 point(Real lo, Real hi)
    {
        const Real x = between(lo, hi), y = between(lo, hi);
        return {x, y, between(lo, hi)};
    }
    Pose pose(Real far)
    {
        const Vec3 p = point(-far, far), v = point(-1, 1);
        Quat q = {between(Real(0.1), 1), v.x, v.y, v.z};
        normalize(q);
        return {p, to_matrix(q)};
    }
};

TEST(Convex, polytope_finds_the_depth_of_boxes)
{
    Dice dice{std::mt19937_64(4)};
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
        const Box a = {dice.point(Real(0.2), 1)}, b = {dice.point(Real(0.2), 1)};
        const Pose A = dice.pose(Real(0.8)), B = dice.pose(Real(0.8));
        const Hull ha = hull_of(a), hb = hull_of(b);
        const Overlap o = least_overlap(view_of_hull(ha, A), view_of_hull(hb, B));
        BoxBox m;
        const bool hit = box_box_manifold(a, A, b, B, m);
        EXPECT_EQ(hit, boxes_touch(a, A, b, B));
        if (!hit) {
            EXPECT_LT(o.depth, kTight);
            continue;
        }
        ++hits;
        EXPECT_LE(o.depth, m.overlap + kTight);
        EXPECT_GE(o.depth * kEdgeHandicap, m.overlap - kTight - Real(4e-5)) << "code " << m.code;
    }
    EXPECT_GT(hits, 300);
}

TEST(Convex, gjk_distance_is_below_every_pair_of_points)
{
    Dice dice{std::mt19937_64(5)};
    for (int i = 0; i < 1000; ++i) {
        const Box a = {dice.point(Real(0.2), 1)};
        const Capsule b = {0, dice.between(Real(0.2), 2)};
        const Pose A = dice.pose(1), B = dice.pose(4);
        const Distance d = gjk_distance(view_of(a, A), view_of(b, B));
        const Vec3 reach = b.half_length * B.R.column(2);
        const Vec3 from = A.to_local(B.p - reach), to = A.to_local(B.p + reach);
        const Vec3 p = from + closest_to_box(from, to, a.half) * (to - from);
        EXPECT_NEAR(d.distance, length(p - clamp_to_box(p, a.half)), kSingle ? Real(1e-3) : Real(1e-7));
        if (d.distance > kTight) {
            EXPECT_NEAR(length(d.on_a - d.on_b), d.distance, kTight);
            EXPECT_LE(length(A.to_local(d.on_a) - clamp_to_box(A.to_local(d.on_a), a.half)), kTight);
        }
    }
}

// A box that stands 1 cm before a wall of 1 km, anywhere: corners of the wall are known to the rounding of half of it, the normal of its
// face and the gap no worse. In floats a character passed such a wall.
TEST(Convex, gjk_finds_the_gap_before_a_long_wall)
{
    Dice dice{std::mt19937_64(8)};
    const Box wall = {{Real(0.5), 7, 500}}, standing = {{Real(0.3), Real(0.3), Real(0.9)}};
    const Real gap = Real(0.01), rounding = 4 * kEpsilon * 500;
    for (int i = 0; i < 1000; ++i) {
        const Real angle = dice.between(0, 6), c = std::cos(angle), s = std::sin(angle);
        const Real reach = Real(0.3) * (std::fabs(c) + std::fabs(s));
        const Pose at = {{Real(-6) + reach + gap, dice.between(-6, 6), dice.between(-3, 3)},
                         {{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
        const Distance d =
            gjk_distance(view_of(standing, at), view_of(wall, Pose{{Real(-6.5), 0, 0}, Mat3::identity()}));
        EXPECT_NEAR(d.distance, gap, rounding) << i;
        EXPECT_NEAR(d.normal.x, 1, 1e-5) << i;
    }
}

TEST(Convex, gjk_stops_at_the_limit)
{
    const Box box;
    const Distance d =
        gjk_distance(view_of(box, Pose{}), view_of(box, Pose{{50, 3, 2}, Mat3::identity()}), 1);
    EXPECT_GT(d.distance, 1);
    EXPECT_LE(d.distance, 50);
}

TEST(Convex, hull_on_hull_has_the_boxes_manifold)
{
    const Box box;
    const Hull hull = hull_of(box);
    const Pose top = {{Real(0.1), Real(0.2), Real(0.9)}, Mat3::identity()};
    dContactGeom contacts[8];
    ContactSink sink(contacts, int(sizeof(dContactGeom)), 8, false);
    convex_convex(view_of_hull(hull, Pose{}), view_of_hull(hull, top), sink);
    ASSERT_EQ(sink.count(), 4);
    Real low_x = 1, high_y = -1;
    for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(contacts[i].depth, Real(0.1), kTight);
        EXPECT_NEAR(contacts[i].normal[2], -1, kTight);
        low_x = std::min(low_x, contacts[i].pos[0]), high_y = std::max(high_y, contacts[i].pos[1]);
    }
    EXPECT_NEAR(low_x, Real(-0.4), kTight);
    EXPECT_NEAR(high_y, Real(0.5), kTight);
}

TEST(Convex, inflated_cores_use_their_distance)
{
    const Sphere ball = {Real(0.5)};
    const Box box;
    const Hull hull = hull_of(box);
    for (const Real z : {Real(0.9), Real(0.45), Real(0.2)}) {
        const Pose at = {{Real(0.1), 0, z}, Mat3::identity()};
        dContactGeom contacts[4];
        ContactSink sink(contacts, int(sizeof(dContactGeom)), 4, false);
        convex_convex(view_of(ball, at), view_of_hull(hull, Pose{}), sink);
        ASSERT_EQ(sink.count(), 1) << z;
        EXPECT_NEAR(contacts[0].depth, 1 - z, kTight);
        EXPECT_NEAR(contacts[0].normal[2], 1, kTight);
    }
}

TEST(Convex, cylinder_on_hull_is_as_exact_as_cylinder_on_box)
{
    Dice dice{std::mt19937_64(7)};
    int hits = 0;
    for (int i = 0; i < 500; ++i) {
        const Box box = {dice.point(Real(0.2), 1)};
        const Hull hull = hull_of(box);
        const Cylinder c = {dice.between(Real(0.2), 1), dice.between(Real(0.2), 1)};
        const Pose A = dice.pose(1), B = dice.pose(Real(0.5));
        const Overlap on_box = least_overlap(view_of(c, A), view_of(box, B));
        const Overlap on_hull = least_overlap(view_of(c, A), view_of_hull(hull, B));
        EXPECT_EQ(on_box.depth < -kTight, on_hull.depth < -kTight);
        if (on_box.depth < 0) continue;
        ++hits;
        EXPECT_NEAR(on_box.depth, on_hull.depth, kSingle ? Real(1e-3) : Real(1e-5));
    }
    EXPECT_GT(hits, 100);
}

TEST(Convex, cylinder_normals_are_exact)
{
    Dice dice{std::mt19937_64(6)};
    int tried = 0;
    for (int i = 0; i < 300; ++i) {
        const Cylinder a = {dice.between(Real(0.2), 1), dice.between(Real(0.2), 1)};
        const Cylinder b = {dice.between(Real(0.2), 1), dice.between(Real(0.2), 1)};
        const Pose A = dice.pose(Real(0.7)), B = dice.pose(Real(0.7));
        const ConvexView va = view_of(a, A), vb = view_of(b, B);
        const Overlap o = least_overlap(va, vb);
        if (o.apart()) continue;
        ++tried;
        for (int k = 0; k < 200; ++k) {  // no direction near by is better
            Vec3 n = o.normal + Real(std::pow(10, dice.between(-6, -1))) * dice.point(-1, 1);
            normalize(n);
            EXPECT_GE(extent(va, vb, n).h, o.depth - kTight);
        }
    }
    EXPECT_GT(tried, 100);
}

}  // namespace
