// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a solid keeps of a mesh's tree from query to query: the answers are those of the tree, leaf by
// leaf and in its order, wherever the solid goes and whatever becomes of the mesh.
#include "bvh/near_leaves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "../geometry/mesh_shapes.h"
#include "bvh/mesh_tree.h"

namespace epode {
namespace {

struct Found {
    std::vector<std::pair<int, unsigned>> seen;  // leaves, and which of their triangles
    std::vector<int> close;
    bool operator==(const Found&) const = default;
};

SolidProbe ball(Vec3 at, Real radius) { return {ProbeKind::kBall, at, {}, {}, radius, 0}; }

Found ask(const MeshTree& tree, Vec3 at, Real radius, NearLeaves* kept)
{
    const Vec3 half{radius, radius, radius};
    Found found;
    tree.query(
        {at - half, at + half}, ball(at, radius), kept,
        [&](int leaf, unsigned met) {
            found.seen.push_back({leaf, met});
        },
        [&](const MeshPacket& packet, int lane) { found.close.push_back(packet.lanes[lane]); });
    return found;
}

void expect_the_same(const MeshTree& tree, Vec3 at, Real radius, NearLeaves& kept)
{
    EXPECT_EQ(ask(tree, at, radius, &kept), ask(tree, at, radius, nullptr));
}

Figure hills(int cells)
{
    Figure f = flat_grid(cells, cells, 0);
    for (Vec3& v : f.vertices) v.z = Real(0.3) * (v.x * Real(0.37) - Real(int(v.x * Real(0.37))));
    return f;
}

TEST(NearLeaves, answer_as_the_tree_does_along_a_way)
{
    const TriangleMesh mesh = make_mesh(hills(60));
    MeshTree tree;
    ASSERT_TRUE(tree.build(mesh));
    RandomNumbers random(17);
    for (const Real radius : {Real(0.2), Real(0.7), Real(5)}) {
        NearLeaves kept;
        Vec3 at, way;
        int close = 0, stays = 0;
        for (int i = 0; i < 600; ++i) {
            // Ways in all directions, and now and then a jump, off the mesh too.
            if (i % 30 == 0) at = {30, 30, Real(0.2)}, way = radius * Real(0.05) * random.vec();
            at += i % 30 == 29 ? 80 * radius * random.vec() : way;
            const FloatBox before = kept.box;
            expect_the_same(tree, at, radius, kept);
            close += int(ask(tree, at, radius, &kept).close.size());
            stays += i > 0 && before.lo[0] == kept.box.lo[0] && before.hi[1] == kept.box.hi[1];
        }
        EXPECT_GT(close, 100) << radius;
        EXPECT_GT(stays, 200) << radius;  // it was of use
    }
}

TEST(NearLeaves, are_forgotten_when_vertices_have_moved)
{
    const Figure figure = hills(20);
    TriangleMesh mesh = make_mesh(figure);
    MeshTree tree;
    ASSERT_TRUE(tree.build(mesh));
    NearLeaves kept;
    const Vec3 at{5, 5, Real(0.2)};
    expect_the_same(tree, at, Real(0.3), kept);
    ASSERT_FALSE(ask(tree, at, Real(0.3), &kept).close.empty());
    // The far side of the mesh comes here; its extent stays.
    for (std::size_t i = 0; i < figure.vertices.size(); ++i) mesh.vertices()[i].x = 20 - figure.vertices[i].x;
    mesh.refresh();
    tree.refit(mesh);
    expect_the_same(tree, at, Real(0.3), kept);
    EXPECT_FALSE(ask(tree, at, Real(0.3), &kept).close.empty());
}

TEST(NearLeaves, are_not_those_of_another_tree)
{
    Figure other = hills(20);  // of the same size, its triangles in another order
    for (Vec3& v : other.vertices) std::swap(v.x, v.y);
    std::reverse(other.triangles.begin(), other.triangles.end());
    const TriangleMesh first = make_mesh(hills(20)), second = make_mesh(reversed(other));
    MeshTree trees[2];
    ASSERT_TRUE(trees[0].build(first) && trees[1].build(second));
    NearLeaves kept;
    for (int i = 0; i < 6; ++i) expect_the_same(trees[i % 2], {5, 6, Real(0.2)}, Real(0.3), kept);
    // One that takes the place of another.
    ASSERT_TRUE(trees[0].build(second));
    expect_the_same(trees[0], {5, 6, Real(0.2)}, Real(0.3), kept);
    MeshTree empty;
    ASSERT_TRUE(empty.build(TriangleMesh{}));
    expect_the_same(empty, {}, Real(0.3), kept);
}

TEST(NearLeaves, bear_more_leaves_than_there_is_room_for)
{
    const TriangleMesh mesh = make_mesh(hills(40));
    MeshTree tree;
    ASSERT_TRUE(tree.build(mesh));
    NearLeaves kept;
    for (const Real radius : {Real(12), Real(0.2), Real(12), Real(12)})
        expect_the_same(tree, {20, 20, Real(0.2)}, radius, kept);
    EXPECT_GT(kept.count, NearLeaves::kCapacity);
}

}  // namespace
}  // namespace epode
