// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Neighbours, crests and what counts as flat, on meshes whose answers are known: a cube, grids, fans of
// sheets on one edge, and meshes with triangles that are none.
#include "geometry/triangle_mesh.h"

#include <gtest/gtest.h>

#include "mesh_shapes.h"

namespace epode {
namespace {

int count_crests(const TriangleMesh& mesh, int bits)
{
    int count = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int b = 0; b < 6; ++b) count += (mesh.crests(t) >> b & 1) && (bits >> b & 1);
    return count;
}

TEST(TriangleMesh, a_cube_has_twelve_crests_and_flat_diagonals)
{
    for (const bool soup : {false, true}) {
        const TriangleMesh mesh = make_mesh(soup ? separate(cube()) : cube());
        EXPECT_EQ(count_crests(mesh, 7), 24);
        EXPECT_EQ(count_crests(mesh, 56), 36);
        for (int t = 0; t < 12; ++t)
            for (int k = 0; k < 3; ++k) {
                const int over = mesh.neighbour(t, k);
                ASSERT_GE(over, 0);
                const bool flat = mesh.normal(over) == mesh.normal(t);
                EXPECT_EQ(mesh.crests(t) >> k & 1, flat ? 0 : 1);
                EXPECT_EQ(mesh.triangle(t).beyond[k], mesh.normal(over));
                EXPECT_TRUE(flat || dot(mesh.normal(t), mesh.normal(over)) == 0);
            }
    }
}

TEST(TriangleMesh, a_cube_turned_inside_out_has_no_crests)
{
    const TriangleMesh mesh = make_mesh(reversed(cube()));
    EXPECT_EQ(count_crests(mesh, 63), 0);
}

TEST(TriangleMesh, only_the_border_of_a_flat_grid_crests)
{
    for (const Real tilt : {Real(0), Real(0.37)})
        for (const bool soup : {false, true}) {
            const Figure grid = flat_grid(8, 6, tilt);
            const TriangleMesh mesh = make_mesh(soup ? separate(grid) : grid);
            EXPECT_EQ(count_crests(mesh, 7), 2 * (8 + 6));
            for (int t = 0; t < mesh.triangle_count(); ++t) {
                const MeshTriangle triangle = mesh.triangle(t);
                for (int k = 0; k < 3; ++k) {
                    const bool border = mesh.neighbour(t, k) < 0;
                    EXPECT_EQ(triangle.crests >> k & 1, border);
                    EXPECT_LT(length(triangle.beyond[k] - (border ? -triangle.n : triangle.n)), Real(1e-5));
                    EXPECT_EQ(triangle.crests >> (3 + k) & 1, on_border(grid, triangle.v[k]));
                }
            }
        }
}

TEST(TriangleMesh, crests_where_the_angle_exceeds_what_counts_as_flat)
{
    for (const Real height : {Real(0.02), Real(0.0005), Real(-0.0005), Real(-0.02)}) {
        // Two triangles on the edge from (0,0,0) to (0,1,0); the far corner of the second is lowered.
        const TriangleMesh mesh =
            make_mesh({{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, -height}}, {{0, 1, 2}, {0, 3, 1}}});
        EXPECT_EQ(mesh.crests(0) & 1, height == Real(0.02)) << height;
        EXPECT_EQ(mesh.crests(1) >> 2 & 1, height == Real(0.02)) << height;
        EXPECT_EQ(mesh.neighbour(0, 0), 1);
        EXPECT_EQ(mesh.neighbour(1, 2), 0);
    }
}

// A floor with the data of a float: coordinates far from the origin are rounded, which bends it.
TEST(TriangleMesh, rounding_of_float_data_makes_no_crests)
{
    Figure grid = flat_grid(20, 20, Real(0.37));
    for (Vec3& v : grid.vertices) {
        v = Real(0.01) * v + Vec3{100, 50, 30};
        v = {Real(float(v.x)), Real(float(v.y)), Real(float(v.z))};
    }
    const TriangleMesh mesh = make_mesh(grid, std::numeric_limits<float>::epsilon());
    EXPECT_EQ(count_crests(mesh, 7), 4 * 20);
}

TEST(TriangleMesh, winding_that_differs_is_borne)
{
    Figure grid = flat_grid(2, 1, 0);
    std::swap(grid.triangles[1].at[0], grid.triangles[1].at[1]);
    const TriangleMesh mesh = make_mesh(grid);
    EXPECT_EQ(mesh.normal(0), -mesh.normal(1));
    EXPECT_EQ(count_crests(mesh, 7), 6);
    for (int k = 0; k < 3; ++k)
        if (mesh.neighbour(1, k) >= 0) { EXPECT_EQ(mesh.triangle(1).beyond[k], mesh.normal(1)); }
}

TEST(TriangleMesh, a_wall_on_a_floor_parts_its_sides)
{
    // Floor left and right of the y axis, a wall up from it, facing right.
    const TriangleMesh mesh = make_mesh(
        {{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 3, 1}, {0, 1, 4}}});
    ASSERT_EQ(mesh.normal(2), (Vec3{1, 0, 0}));
    EXPECT_EQ(mesh.neighbour(0, 0), 2);
    EXPECT_EQ(mesh.neighbour(1, 2), 2);
    EXPECT_EQ(mesh.neighbour(2, 0), 1);
    EXPECT_EQ(mesh.crests(0) & 1, 0);
    EXPECT_EQ(mesh.crests(1) & 4, 0);
    EXPECT_EQ(mesh.crests(2) & 1, 0);
    EXPECT_EQ(mesh.triangle(0).beyond[0], (Vec3{-1, 0, 0}));  // the back of the wall
    EXPECT_EQ(mesh.triangle(1).beyond[2], (Vec3{1, 0, 0}));
}

TEST(TriangleMesh, a_doubled_sheet_is_two_sheets_and_copies_do_no_harm)
{
    const Figure grid = flat_grid(3, 3, 0);
    Figure doubled = grid;
    for (const MeshCorners& c : grid.triangles) doubled.triangles.push_back({{c.at[0], c.at[2], c.at[1]}});
    for (const MeshCorners& c : grid.triangles) doubled.triangles.push_back(c);
    const TriangleMesh mesh = make_mesh(doubled);
    EXPECT_EQ(count_crests(mesh, 7), 3 * 12);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            const bool crest = mesh.crests(t) >> k & 1;
            EXPECT_EQ(mesh.triangle(t).beyond[k], crest ? -mesh.normal(t) : mesh.normal(t));
        }
}

TEST(TriangleMesh, degenerate_triangles_keep_numbers_and_are_looked_through)
{
    // A square whose left half is one triangle and whose right half is two, with a sliver on the seam.
    const TriangleMesh mesh = make_mesh({{{0, 0, 0}, {0, 2, 0}, {-1, 1, 0}, {1, 1, 0}, {0, 1, 0}},
                                         {{0, 1, 2}, {0, 4, 1}, {0, 3, 4}, {4, 3, 1}, {3, 3, 1}}});
    EXPECT_FALSE(mesh.degenerate(0));
    EXPECT_TRUE(mesh.degenerate(1));
    EXPECT_TRUE(mesh.degenerate(4));
    EXPECT_EQ(mesh.neighbour(0, 0), 2);
    EXPECT_EQ(mesh.neighbour(2, 2), 0);
    EXPECT_EQ(mesh.neighbour(3, 2), 0);
    EXPECT_EQ(mesh.crests(0) & 1, 0);
    EXPECT_EQ(mesh.crests(2) & 4, 0);
    EXPECT_EQ(mesh.crests(3) & 4, 0);
    EXPECT_EQ(count_crests(mesh, 7), 4);
}

TEST(TriangleMesh, tiny_and_huge_triangles_have_normals)
{
    for (const Real size : {kSingle ? Real(1e-30) : Real(1e-250), Real(1), kMaxMagnitude}) {
        const TriangleMesh mesh = make_mesh({{{0, 0, 0}, {size, 0, 0}, {0, size, 0}}, {{0, 1, 2}}});
        EXPECT_EQ(mesh.normal(0), (Vec3{0, 0, 1}));
    }
    EXPECT_TRUE(make_mesh({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}}).degenerate(0));
    EXPECT_TRUE(make_mesh({{{3, 3, 3}}, {{0, 0, 0}}}).degenerate(0));
}

TEST(TriangleMesh, refresh_follows_the_vertices)
{
    TriangleMesh mesh = make_mesh(flat_grid(2, 2, 0));
    ASSERT_EQ(count_crests(mesh, 7), 8);
    for (int i = 0; i < mesh.vertex_count(); ++i)
        if (mesh.vertex(i).x == 1 && mesh.vertex(i).y == 1) mesh.vertices()[i].z = 1;  // a hill
    mesh.refresh();
    EXPECT_GT(count_crests(mesh, 7), 8);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        EXPECT_NEAR(length(mesh.normal(t)), 1, 4 * double(kEpsilon));
}

TEST(TriangleMesh, an_empty_mesh_is_a_mesh)
{
    const TriangleMesh mesh = make_mesh({});
    EXPECT_EQ(mesh.triangle_count(), 0);
    EXPECT_EQ(mesh.box().lo, (Vec3{}));
}

}  // namespace
}  // namespace epode
