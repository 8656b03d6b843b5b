// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Meshes of all formats: the solid that they enclose, where nodes put them, mirrors.
#include <gtest/gtest.h>

#include "glb_files.h"
#include "robots/load.h"
#include "robots/meshes/meshes.h"
#include "robots/meshes/solid.h"

namespace {

using namespace epode::robots;

Mesh mesh_of(const std::string& path, const std::string& bytes)
{
    Mesh mesh;
    std::string problem;
    EXPECT_TRUE(read_mesh(path, bytes, mesh, problem)) << problem;
    return mesh;
}

std::string problem_of(const std::string& path, const std::string& bytes)
{
    Mesh mesh;
    std::string problem;
    EXPECT_FALSE(read_mesh(path, bytes, mesh, problem));
    return problem;
}

// Volume 1/6 s^3, centre at a quarter of each edge.
void expect_tetrahedron(const Mesh& mesh, double volume, Vec centre)
{
    Solid solid;
    ASSERT_TRUE(solid_of(mesh, solid));
    EXPECT_NEAR(solid.volume, volume, 1e-12);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(solid.centre[i], centre[i], 1e-7) << i;
}

// Volume with its sign: negative if the triangles look inwards.
double signed_volume(const Mesh& mesh)
{
    double sum = 0;
    for (const auto& t : mesh.triangles)
        sum += dot(mesh.vertices[t[0]], cross(mesh.vertices[t[1]], mesh.vertices[t[2]])) / 6;
    return sum;
}

TEST(Glb, is_read_with_its_own_axes)
{
    expect_tetrahedron(mesh_of("a.glb", tetrahedron_glb()), 1.0 / 6, {0.25, 0.25, 0.25});
}

TEST(Glb, nodes_turn_scale_and_move)
{
    const double h = std::sqrt(0.5);
    const std::string turned =
        R"({"children":[1],"translation":[1,2,3]},{"mesh":0,"scale":[2,2,2],"rotation":[0,)" +
        std::to_string(h) + ",0," + std::to_string(h) + "]}";
    // Scaled: centre (1/2, 1/2, 1/2). A quarter turn about y: (z, y, -x). Moved.
    expect_tetrahedron(mesh_of("a.glb", tetrahedron_glb(turned)), 8.0 / 6, {1.5, 2.5, 2.5});
    const std::string matrix = R"({"mesh":0,"matrix":[0,1,0,0, -1,0,0,0, 0,0,1,0, 5,0,0,1]})";
    expect_tetrahedron(mesh_of("a.glb", tetrahedron_glb(matrix)), 1.0 / 6, {4.75, 0.25, 0.25});
}

TEST(Glb, mirrors_turn_triangles_round)
{
    EXPECT_GT(signed_volume(mesh_of("a.glb", tetrahedron_glb())), 0);
    EXPECT_GT(signed_volume(mesh_of("a.glb", tetrahedron_glb(R"({"mesh":0,"scale":[-1,1,1]})"))), 0);
}

TEST(Glb, says_what_it_does_not_read)
{
    const std::string packed =
        tetrahedron_glb(R"({"mesh":0})", R"(,"extensionsRequired":["KHR_draco_mesh_compression"])");
    EXPECT_NE(problem_of("a.glb", packed).find("KHR_draco_mesh_compression"), std::string::npos);
    EXPECT_NE(problem_of("a.glb", tetrahedron_glb().substr(0, 100)).find("is broken"), std::string::npos);
    EXPECT_NE(problem_of("a.glb", tetrahedron_glb(R"({"mesh":0,"children":[0]})")).find("is broken"),
              std::string::npos);
    EXPECT_NE(problem_of("a.ply", "ply").find("meshes are read from .stl, .obj, .dae, .glb and .msh"),
              std::string::npos);
}

TEST(Meshes, mu_jo_cos_old_format_is_read)
{
    const std::uint32_t counts[4] = {4, 1, 1, 4}, triangles[12] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
    const float floats[17] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    std::string bytes(reinterpret_cast<const char*>(counts), sizeof counts);
    bytes.append(reinterpret_cast<const char*>(floats), sizeof floats);
    bytes.append(reinterpret_cast<const char*>(triangles), sizeof triangles);
    expect_tetrahedron(mesh_of("a.msh", bytes), 1.0 / 6, {0.25, 0.25, 0.25});
    bytes[bytes.size() - 1] = 1;
    EXPECT_NE(problem_of("a.msh", bytes).find("is broken"), std::string::npos);
}

TEST(Meshes, negative_scale_mirrors_and_keeps_the_outside_outside)
{
    Mesh mesh = mesh_of("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    EXPECT_NEAR(signed_volume(mesh), 1.0 / 6, 1e-12);
    scale_mesh(mesh, {1, -2, 1});
    EXPECT_NEAR(signed_volume(mesh), 2.0 / 6, 1e-12);
    expect_tetrahedron(mesh, 2.0 / 6, {0.25, -0.5, 0.25});
}

TEST(Meshes, collada_instances_a_geometry_twice)
{
    const std::string text =
        R"(<COLLADA><library_geometries><geometry id="g"><mesh><source id="s"><float_array>0 0 0 1 0 0 0 1 0 0 0 1</float_array>
</source><vertices id="v"><input semantic="POSITION" source="#s"/></vertices><triangles><input semantic="NORMAL" offset="1"/>
<input semantic="VERTEX" offset="0"/><p>0 9 2 9 1 9 0 9 1 9 3 9 1 9 2 9 3 9 0 9 3 9 2 9</p></triangles></mesh></geometry>
</library_geometries><library_visual_scenes><visual_scene><node><instance_geometry url="#g"/></node><node>
<translate>3 0 0</translate><scale>1 1 -1</scale><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes></COLLADA>)";
    const Mesh mesh = mesh_of("a.dae", text);
    EXPECT_EQ(mesh.vertices.size(), 8u);
    EXPECT_NEAR(signed_volume(mesh), 2.0 / 6, 1e-12);
    expect_tetrahedron(mesh, 2.0 / 6, {1.75, 0.25, 0});
}

}  // namespace
