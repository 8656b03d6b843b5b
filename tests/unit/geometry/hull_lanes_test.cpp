// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A polyhedron's farthest vertices, few of them in lanes and many by climbing, against all of them one by one:
// the same vertex, the first of equals, and the same bits.
#include <gtest/gtest.h>

#include <vector>

#include "../math/random_numbers.h"
#include "geometry/hulls/flat_solid.h"
#include "geometry/hulls/polyhedron.h"

namespace epode {
namespace {

Polyhedron ball_of(int points, RandomNumbers& random)
{
    std::vector<Real> all;
    for (int i = 0; i < points; ++i) {
        const Vec3 p = random.direction();
        all.insert(all.end(), {p.x, p.y, p.z});
    }
    Polyhedron made;
    EXPECT_EQ(made.build(all.data(), unsigned(points), 1000, false), nullptr);
    return made;
}

void compare_with_all(const Polyhedron& solid, Vec3 d)
{
    Real least = kInf, largest = -kInf;
    Vec3 first;
    for (const Vec3 v : solid.vertices()) {
        const Real along = dot(d, v);
        if (along > largest) largest = along, first = v;
        if (along < least) least = along;
    }
    EXPECT_TRUE(solid.support(d) == first);
    EXPECT_EQ(solid.reach(d), largest);
    Real low, high;
    solid.extent(d, low, high);
    EXPECT_EQ(low, least);
    EXPECT_EQ(high, largest);
}

TEST(HullLanes, find_what_a_loop_over_all_vertices_finds)
{
    RandomNumbers random(11);
    for (const int points : {4, 5, 19, 20, 32, 33, 100}) {
        const Polyhedron solid = ball_of(points, random);
        for (int i = 0; i < 500; ++i) compare_with_all(solid, random.direction());
    }
}

TEST(HullLanes, of_equals_it_is_the_first_vertex)
{
    std::vector<Real> corners;
    for (int i = 0; i < 8; ++i)
        corners.insert(corners.end(),
                       {i & 1 ? Real(1) : Real(-1), i & 2 ? Real(1) : Real(-1), i & 4 ? Real(1) : Real(-1)});
    Polyhedron cube;
    ASSERT_EQ(cube.build(corners.data(), 8, 100, false), nullptr);
    for (int i = 0; i < 3; ++i)
        for (const Real sign : {Real(1), Real(-1)}) {
            Vec3 d;
            d.set(i, sign);
            compare_with_all(cube, d);
        }
}

TEST(HullLanes, gaps_of_faces_are_those_of_a_loop)
{
    RandomNumbers random(12);
    const Polyhedron solid = ball_of(20, random);
    const FlatSolid flat(view_of(Convex{&solid}, Pose{}));
    for (int i = 0; i < 500; ++i) {
        const Vec3 p = Real(2) * random.vec();
        const FaceGaps gaps(flat, p);
        std::size_t widest = 0;
        for (std::size_t f = 0; f < solid.faces().size(); ++f) {
            EXPECT_EQ(gaps[f], dot(solid.faces()[f].normal, p) - solid.faces()[f].offset);
            if (gaps[f] > gaps[widest]) widest = f;
        }
        EXPECT_EQ(gaps.widest, widest);
    }
}

}  // namespace
}  // namespace epode
