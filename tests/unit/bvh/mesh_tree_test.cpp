// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The tree over a mesh against a list of its triangles: what a box meets, what a ray meets, before and after
// vertices have moved.
#include "bvh/mesh_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "../geometry/mesh_shapes.h"

namespace epode {
namespace {

std::vector<int> ask(const MeshTree& tree, const TriangleMesh& mesh, const Aabb& box)
{
    std::vector<int> found;
    tree.query(mesh, box, [&](int t) {
        found.push_back(t);
        return true;
    });
    return found;
}

std::vector<int> sorted(std::vector<int> v)
{
    std::sort(v.begin(), v.end());
    return v;
}

std::vector<int> ask(const TriangleMesh& mesh, const Aabb& box)
{
    std::vector<int> found;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (!mesh.degenerate(t) && overlap(mesh.box(t), box)) found.push_back(t);
    return found;
}

// Does the ray hit the triangle, not just its rim (Moeller and Trumbore, 1997)? What it does must be visited.
bool hits(const TriangleMesh& mesh, int t, Vec3 o, Vec3 d, Real to)
{
    const Vec3 a = mesh.corner(t, 0), e = mesh.corner(t, 1) - a, f = mesh.corner(t, 2) - a;
    const Vec3 p = cross(d, f), s = o - a, q = cross(s, e);
    const Real det = dot(e, p), u = dot(s, p) / det, v = dot(d, q) / det, at = dot(f, q) / det;
    const Real rim = 100 * kEpsilon;
    return det != 0 && u > rim && v > rim && 1 - u - v > rim && at > 0 && at < to;
}

Vec3 middle_of(const TriangleMesh& mesh, int t)
{
    return (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
}

// How many triangles of the list the ray hits.
int compare(const MeshTree& tree, const TriangleMesh& mesh, Vec3 o, Vec3 d, Real length, Real spread)
{
    std::vector<char> visited(std::size_t(mesh.triangle_count()));
    const auto visit = [&](const MeshRay& ray, const MeshPacket& packet, int lane) {
        const int t = packet.lanes[lane];
        EXPECT_FALSE(visited[std::size_t(t)]);
        visited[std::size_t(t)] = 1;
        for (int k = 0; k < 3; ++k) EXPECT_EQ(packet.corners[lane].at[k], mesh.corners(t).at[k]);
        EXPECT_LE(epode::length(ray.origin - (o + ray.start * d)), 8 * kEpsilon * spread);
        return length;
    };
    tree.shoot(
        o, d, 0, length, [](const MeshPacket&) {}, visit);
    int count = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        if (!hits(mesh, t, o, d, length)) continue;
        EXPECT_TRUE(visited[std::size_t(t)]) << t;
        ++count;
    }
    return count;
}

// The same of all rays, of which every other one is aimed at a triangle.
int compare(const MeshTree& tree, const TriangleMesh& mesh, RandomNumbers& random, Real spread, int queries)
{
    int hit_count = 0;
    const int rays = std::clamp(60000 / mesh.triangle_count(), 1, 20);
    for (int i = 0; i < queries; ++i) {
        const Vec3 c = spread * random.vec(), e = abs(random.vec()) * (spread * random.in(0, Real(0.3)));
        const Aabb box{c - e, c + e};
        EXPECT_EQ(sorted(ask(tree, mesh, box)), ask(mesh, box));
        for (int k = 0; k < rays; ++k) {
            Vec3 d = random.vec();
            if ((i + k) % 5 == 0) d = {0, 0, d.z};
            if ((i + k) % 7 == 0) d = {d.x, 0, d.z};
            const Vec3 o = Real(i % 2 ? 1 : 3) * spread * random.vec();
            if (k % 2 == 1)
                d = middle_of(mesh, int(random.in(0, Real(mesh.triangle_count()))) % mesh.triangle_count()) -
                    o;
            EXPECT_TRUE(normalize(d));
            hit_count += compare(tree, mesh, o, d, spread * random.in(0, 4), spread);
        }
    }
    return hit_count;
}

TEST(MeshTree, finds_what_a_list_finds)
{
    RandomNumbers random(5);
    for (const int count : {1, 2, 3, 4, 5, 7, 16, 17, 100, 3000}) {
        const TriangleMesh mesh = make_mesh(random_soup(random, count, 10, Real(0.5)));
        MeshTree tree;
        ASSERT_TRUE(tree.build(mesh));
        EXPECT_GT(compare(tree, mesh, random, 10, count > 1000 ? 100 : 200), 500);
    }
}

TEST(MeshTree, finds_what_a_list_finds_in_a_large_mesh)
{
    RandomNumbers random(6);
    const TriangleMesh mesh = make_mesh(random_soup(random, 100000, 10, Real(0.05)));
    MeshTree tree;
    ASSERT_TRUE(tree.build(mesh));
    compare(tree, mesh, random, 10, 20);
    EXPECT_LT(tree.node_count(), 4000);
}

TEST(MeshTree, follows_moved_vertices)
{
    RandomNumbers random(7);
    TriangleMesh mesh = make_mesh(random_soup(random, 500, 10, Real(0.5)));
    MeshTree tree;
    ASSERT_TRUE(tree.build(mesh));
    for (int round = 0; round < 5; ++round) {
        for (int i = 0; i < mesh.vertex_count(); ++i) mesh.vertices()[i] += 3 * random.vec();
        mesh.vertices()[round] = {1000, -2000, 0};
        mesh.refresh();
        tree.refit(mesh);
        compare(tree, mesh, random, 12, 50);
    }
}

TEST(MeshTree, bears_any_size_place_and_number_of_equal_triangles)
{
    RandomNumbers random(8);
    const Real largest = kSingle ? Real(1e17) : Real(1e99);
    for (const Real size : {1 / largest, Real(1e-6), Real(1e6), largest}) {
        const TriangleMesh mesh = make_mesh(random_soup(random, 200, size, size / 10));
        MeshTree tree;
        ASSERT_TRUE(tree.build(mesh));
        compare(tree, mesh, random, size, 40);
    }
    Figure same;
    same.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    same.triangles.assign(5000, {{0, 1, 2}});
    const TriangleMesh mesh = make_mesh(same);
    MeshTree tree;
    ASSERT_TRUE(tree.build(mesh));
    EXPECT_EQ(ask(tree, mesh, {{0, 0, 0}, {0, 0, 0}}).size(), 5000u);
    EXPECT_TRUE(ask(tree, mesh, {{0, 0, Real(0.1)}, {1, 1, 1}}).empty());
}

// Sizes that grow by a factor each: greedy cuts would take one triangle off at a time.
TEST(MeshTree, stays_low_where_sizes_run_away)
{
    Figure figure;
    Real size = 1;
    for (int t = 0; t < 400; ++t) {
        for (const Vec3 v : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
            figure.vertices.push_back(size * v);
        figure.triangles.push_back({{3 * t, 3 * t + 1, 3 * t + 2}});
        size *= kSingle ? Real(1.1) : Real(1.7);
    }
    RandomNumbers random(9);
    const TriangleMesh mesh = make_mesh(figure);
    MeshTree tree;
    ASSERT_TRUE(tree.build(mesh));
    for (Real spread = 1; spread < size; spread *= 100) compare(tree, mesh, random, spread, 20);
}

TEST(MeshTree, reports_in_the_order_of_its_making)
{
    RandomNumbers random(10), again(10);
    const TriangleMesh mesh = make_mesh(random_soup(random, 300, 5, 1)),
                       twin = make_mesh(random_soup(again, 300, 5, 1));
    MeshTree tree, other;
    ASSERT_TRUE(tree.build(mesh) && other.build(twin));
    const Aabb box{{-3, -3, -3}, {3, 3, 3}}, all{{-99, -99, -99}, {99, 99, 99}};
    EXPECT_EQ(ask(tree, mesh, box), ask(other, twin, box));
    // What a smaller box meets comes in the order in which a larger one meets it.
    const std::vector<int> order = ask(tree, mesh, all);
    EXPECT_EQ(order.size(), 300u);
    std::size_t at = 0;
    for (const int t : ask(tree, mesh, box)) {
        while (at < order.size() && order[at] != t) ++at;
        EXPECT_LT(at, order.size());
    }
    int seen = 0;
    tree.query(mesh, all, [&](int) { return ++seen < 7; });
    EXPECT_EQ(seen, 7);
}

TEST(MeshTree, degenerate_triangles_are_never_reported)
{
    Figure figure = flat_grid(4, 4, 0);
    figure.triangles[5].at[1] = figure.triangles[5].at[0];
    figure.triangles[9] = {{0, 1, 2}};  // three in a row
    const TriangleMesh mesh = make_mesh(figure);
    MeshTree tree;
    ASSERT_TRUE(tree.build(mesh));
    const std::vector<int> all = ask(tree, mesh, {{-9, -9, -9}, {9, 9, 9}});
    EXPECT_EQ(all.size(), 30u);
    EXPECT_EQ(std::count(all.begin(), all.end(), 5) + std::count(all.begin(), all.end(), 9), 0);
}

TEST(MeshTree, an_empty_mesh_is_met_by_nothing)
{
    const TriangleMesh mesh = make_mesh({});
    MeshTree tree;
    ASSERT_TRUE(tree.build(mesh));
    EXPECT_TRUE(ask(tree, mesh, {{-9, -9, -9}, {9, 9, 9}}).empty());
    const auto seen = [](const MeshPacket&) { ADD_FAILURE(); };
    tree.shoot({0, 0, 0}, {0, 0, 1}, 0, 1, seen,
               [](const MeshRay&, const MeshPacket&, int) { return Real(0); });
}

}  // namespace
}  // namespace epode
