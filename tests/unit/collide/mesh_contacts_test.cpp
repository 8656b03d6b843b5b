// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Solids on meshes of many triangles: a flat mesh is a plane, inner edges are not felt, crests push head-on,
// the surface is found wherever brute force over all triangles finds it, and what has sunk in is pushed out.
#include "mesh_scene.h"

namespace epode::test {
namespace {

constexpr Real kTight = kSingle ? Real(1e-4) : Real(2e-6);

template <typename Shape>
struct MeshContacts : testing::Test {};
using Shapes = testing::Types<Sphere, Box, Capsule, Cylinder>;
TYPED_TEST_SUITE(MeshContacts, Shapes);

template <typename Shape>
Real lowest(const Shape& s, const Mat3& R)
{
    return (R * farthest(s, transposed_times(R, {0, 0, -1}))).z;
}

// A pit far off but within the solid's box keeps the mesh from being taken for one plane.
TYPED_TEST(MeshContacts, inner_edges_of_a_floor_are_not_felt)
{
    using Shape = TypeParam;
    RandomNumbers dice(3);
    const Mesh mesh(grid(12, 12, [](int i, int j) { return i == 12 && j == 12 ? -1 : 0; }));
    for (int trial = 0; trial < 300; ++trial) {
        SCOPED_TRACE(trial);
        Shape s;
        roll(dice, s);
        const Mat3 R = trial % 3 ? to_matrix(dice.rotation()) : Mat3::identity();
        const Real deep = trial % 2 ? Real(1e-4) : Real(0.05);
        const Pose pose{{dice.in(3, 9), dice.in(3, 9), -lowest(s, R) - deep}, R};
        const std::vector<Hit> found = hits(s, pose, mesh);
        ASSERT_FALSE(found.empty());
        EXPECT_NEAR(deepest(found)->depth, deep, kTight);
        for (const Hit& h : found) {
            EXPECT_LT(length(h.normal - Vec3{0, 0, 1}), 1e-6);
            EXPECT_LT(gap(s, pose, mesh.all[std::size_t(h.triangle)]), kTight);
        }
    }
}

TYPED_TEST(MeshContacts, agree_with_brute_force_on_rough_ground)
{
    using Shape = TypeParam;
    RandomNumbers dice(5);
    const Mesh mesh(grid(10, 10, [&](int, int) { return dice.in(0, Real(0.8)); }));
    int met = 0;
    for (int trial = 0; trial < 500; ++trial) {
        SCOPED_TRACE(trial);
        Shape s;
        roll(dice, s);
        const Mat3 R = to_matrix(dice.rotation());
        const Pose pose{{dice.in(2, 8), dice.in(2, 8), dice.in(Real(0.8), Real(2.2))}, R};
        Real least = kInf;
        for (const Corners& t : mesh.all) least = std::fmin(least, near_gap(s, pose, t));
        if (std::fabs(least) < kTight) continue;
        const std::vector<Hit> found = hits(s, pose, mesh);
        ASSERT_EQ(!found.empty(), least < 0) << least;
        if (found.empty()) continue;
        ++met;
        if constexpr (std::is_same_v<Shape, Sphere>) { EXPECT_NEAR(deepest(found)->depth, -least, kTight); }
        for (const Hit& h : found)
            EXPECT_TRUE(h.normal.z > 0 || least < Real(-0.1)) << h.normal.z << ' ' << least;
    }
    EXPECT_GT(met, 90);
}

TYPED_TEST(MeshContacts, push_out_what_has_sunk_in)
{
    using Shape = TypeParam;
    RandomNumbers dice(7);
    const Mesh mesh(grid(10, 10, [&](int, int) { return dice.in(0, Real(0.6)); }));
    for (int trial = 0; trial < 150; ++trial) {
        SCOPED_TRACE(trial);
        Shape s;
        roll(dice, s);
        const Mat3 R = to_matrix(dice.rotation());
        Pose pose{{dice.in(2, 8), dice.in(2, 8), 0}, R};
        pose.p.z = Real(0.6) - lowest(s, R) * dice.in(Real(0.5), 1);
        int corrections = 0;
        Real left = kInf;
        for (; corrections < 60; ++corrections) {
            const std::vector<Hit> found = hits(s, pose, mesh);
            left = found.empty() ? 0 : deepest(found)->depth;
            if (left < Real(1e-4)) break;
            pose.p += (left + Real(1e-5)) * deepest(found)->normal;
        }
        EXPECT_LT(left, Real(1e-4));
        Real least = kInf;
        for (const Corners& t : mesh.all) least = std::fmin(least, near_gap(s, pose, t));
        EXPECT_GT(least, -Real(2e-3));
    }
}

}  // namespace
}  // namespace epode::test
