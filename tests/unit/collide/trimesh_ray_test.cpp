// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rays and planes against meshes: against all triangles one by one, through edges and corners, with the ray's
// flags, with the program's functions, and while these try to give up what the collision relies on.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "../api/message_recorder.h"
#include "../geometry/mesh_shapes.h"

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace epode {
namespace {

constexpr double kNear = kSingle ? 2e-4 : 1e-9;

dTriMeshDataID make_data(const Figure& figure)
{
    std::vector<Real> vertices;
    std::vector<dTriIndex> indices;
    for (const Vec3 v : figure.vertices)
        for (const Real x : {v.x, v.y, v.z, Real(0)}) vertices.push_back(x);
    for (const MeshCorners& c : figure.triangles)
        for (const int i : c.at) indices.push_back(dTriIndex(i));
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSimple(data, vertices.data(), int(figure.vertices.size()), indices.data(),
                                int(indices.size()));
    return data;
}

struct MeshScene : testing::Test {
    MeshScene() { dInitODE(); }
    ~MeshScene() override
    {
        dGeomDestroy(ray);
        dGeomDestroy(mesh);
        dCloseODE();
    }
    void take(const Figure& figure)
    {
        dGeomTriMeshDataDestroy(data);
        data = make_data(figure);
        dGeomTriMeshSetData(mesh, data);
    }
    std::vector<dContactGeom> hits(int capacity = 64, unsigned flags = 0)
    {
        std::vector<dContactGeom> all(static_cast<std::size_t>(capacity));
        const int count =
            dCollide(ray, mesh, int(unsigned(capacity) | flags), all.data(), sizeof(dContactGeom));
        all.resize(std::size_t(count));
        return all;
    }
    void aim(Vec3 from, Vec3 to, Real length)
    {
        const Vec3 d = to - from;
        dGeomRaySetLength(ray, length);
        dGeomRaySet(ray, from.x, from.y, from.z, d.x, d.y, d.z);
    }
    dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomID mesh = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
    dGeomID ray = dCreateRay(nullptr, 10);
};

struct Slow {
    Real t;
    int triangle;
};

// Moller and Trumbore's test, triangle by triangle; false where a hit is too near an edge or an end to be
// judged.
bool slow_hits(const Figure& f, Vec3 o, Vec3 d, Real length, std::vector<Slow>& out)
{
    out.clear();
    for (std::size_t t = 0; t < f.triangles.size(); ++t) {
        const Vec3 a = f.vertices[std::size_t(f.triangles[t].at[0])];
        const Vec3 e = f.vertices[std::size_t(f.triangles[t].at[1])] - a;
        const Vec3 g = f.vertices[std::size_t(f.triangles[t].at[2])] - a;
        const Vec3 p = cross(d, g);
        const Real det = dot(e, p);
        const Real u = dot(o - a, p) / det, v = dot(d, cross(o - a, e)) / det,
                   s = dot(g, cross(o - a, e)) / det;
        if (!std::isfinite(u) || !std::isfinite(v)) continue;
        const Real inside = std::min({u, v, 1 - u - v, s, length - s});
        if (std::fabs(inside) < Real(kSingle ? 1e-3 : 1e-9)) return false;
        if (inside > 0) out.push_back({s, int(t)});
    }
    std::sort(out.begin(), out.end(), [](const Slow& x, const Slow& y) { return x.t < y.t; });
    return true;
}

TEST_F(MeshScene, rays_hit_what_they_hit_one_by_one)
{
    RandomNumbers random(3);
    int judged = 0, with_hits = 0;
    for (const int count : {1, 5, 60, 2000}) {
        const Figure figure = random_soup(random, count, 5, count > 100 ? Real(0.6) : Real(3));
        take(figure);
        for (int i = 0; i < 200; ++i) {
            const Pose pose{5 * random.vec(), to_matrix(random.rotation())};
            dMatrix3 R;
            store_mat(R, pose.R);
            dGeomSetPosition(mesh, pose.p.x, pose.p.y, pose.p.z);
            dGeomSetRotation(mesh, R);
            const Vec3 from = pose.to_world(Real(i % 3 ? 6 : 60) * random.vec()),
                       to = pose.to_world(3 * random.vec());
            const Real length = random.in(0, 80);
            Vec3 d = to - from;
            std::vector<Slow> expected;
            if (!normalize(d) ||
                !slow_hits(figure, pose.to_local(from), transposed_times(pose.R, d), length, expected))
                continue;
            ++judged;
            with_hits += expected.empty() ? 0 : 1;
            aim(from, to, length);
            const auto found = hits(200);
            ASSERT_EQ(found.size(), expected.size());
            for (std::size_t k = 0; k < found.size(); ++k) {
                EXPECT_NEAR(found[k].depth, expected[k].t, 60 * kNear);
                EXPECT_LT(length2(load(found[k].pos) - (from + found[k].depth * d)), kNear * kNear * 3600);
                EXPECT_EQ(found[k].g1, ray);
                EXPECT_EQ(found[k].side1, -1);
            }
            if (expected.empty()) continue;
            // Fewer than there are: the nearest. One: the nearest or any.
            EXPECT_EQ(hits(1)[0].side2, found[0].side2);
            dGeomRaySetClosestHit(ray, 1);
            ASSERT_EQ(hits().size(), 1u);
            EXPECT_EQ(hits()[0].side2, found[0].side2);
            dGeomRaySetClosestHit(ray, 0);
            dGeomRaySetFirstContact(ray, 1);
            ASSERT_EQ(hits().size(), 1u);
            dGeomRaySetFirstContact(ray, 0);
            EXPECT_EQ(hits(2, CONTACTS_UNIMPORTANT).size(), std::min<std::size_t>(2, found.size()));
            dGeomRaySetBackfaceCull(ray, 1);
            std::size_t fronts = 0;
            for (const dContactGeom& c : found) fronts += dot(load(c.normal), d) < 0;
            EXPECT_EQ(hits().size(), std::min<std::size_t>(64, fronts));
            dGeomRaySetBackfaceCull(ray, 0);
        }
    }
    EXPECT_GT(judged, kSingle ? 300 : 700);
    EXPECT_GT(with_hits, 150);
}

// Whatever edge or corner of a flat grid or a closed solid a ray goes through: once in, once out.
TEST_F(MeshScene, no_ray_slips_through_a_seam_or_hits_it_twice)
{
    RandomNumbers random(4);
    for (const bool soup : {false, true}) {
        const Figure grid = flat_grid(6, 6, Real(0.37));
        take(soup ? separate(grid) : grid);
        for (int i = 1; i < 12; ++i)
            for (int j = 1; j < 12; ++j) {
                const Vec3 at{Real(0.5) * Real(i), Real(0.5) * Real(j), Real(0.37) * Real(0.5) * Real(i)};
                for (const Vec3 d : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{1, 0, 2}, Vec3{0, 1, -3}}) {
                    aim(at - d, at, 10);
                    EXPECT_EQ(hits().size(), 1u) << i << " " << j;
                }
            }
    }
    take(cube());
    for (int i = -4; i <= 4; ++i)
        for (int j = -4; j <= 4; ++j) {
            const Vec3 at{Real(0.125) * Real(i), Real(0.125) * Real(j), 0};
            if (std::abs(i) == 4 || std::abs(j) == 4) continue;  // along a side
            aim(at + Vec3{0, 0, 3}, at, 10);
            const auto found = hits();
            ASSERT_EQ(found.size(), 2u);
            EXPECT_EQ(found[0].depth, Real(2.5));
            EXPECT_EQ(found[0].normal[2], 1);
            EXPECT_EQ(found[1].normal[2], -1);
        }
}

TEST_F(MeshScene, rays_that_start_or_end_on_the_surface_hit_it)
{
    take(cube());
    aim({Real(0.1), Real(0.2), Real(0.5)}, {Real(0.1), Real(0.2), 0}, 5);
    EXPECT_EQ(hits().size(), 2u);
    EXPECT_EQ(hits()[0].depth, 0);
    aim({Real(0.1), Real(0.2), Real(0.5)}, {Real(0.1), Real(0.2), 9}, 5);
    EXPECT_EQ(hits().size(), 1u);
    aim({Real(0.1), Real(0.2), 0}, {Real(0.1), Real(0.2), 1}, Real(0.5));
    EXPECT_EQ(hits().size(), 1u);
    dGeomRaySetLength(ray, Real(0.499));
    EXPECT_EQ(hits().size(), 0u);
    dGeomRaySetLength(ray, -1);
    EXPECT_EQ(hits().size(), 0u);
    dGeomRaySetLength(ray, std::numeric_limits<dReal>::infinity());
    EXPECT_EQ(hits().size(), 1u);
}

struct Asked {
    std::vector<int> triangles;
    std::vector<Vec3> points;
    int refuse = 0;
    dGeomID mesh = nullptr, other = nullptr;
};
Asked g_asked;

int ask_ray(dGeomID mesh, dGeomID ray, int triangle, dReal u, dReal v)
{
    dVector3 p;
    dGeomTriMeshGetPoint(mesh, triangle, u, v, p);
    g_asked.triangles.push_back(triangle);
    g_asked.points.push_back(load(p));
    g_asked.mesh = mesh, g_asked.other = ray;
    return int(g_asked.triangles.size()) > g_asked.refuse;
}

TEST_F(MeshScene, hits_are_put_to_the_program_from_the_nearest_on)
{
    Figure layers;
    for (int i = 0; i < 6; ++i) {
        const int n = 3 * i;
        for (const Vec3 v : {Vec3{0, 0, Real(i)}, Vec3{1, 0, Real(i)}, Vec3{0, 1, Real(i)}})
            layers.vertices.push_back(v);
        layers.triangles.push_back({{n, n + 1, n + 2}});
    }
    take(layers);
    dGeomSetPosition(mesh, 10, 0, 0);
    dGeomTriMeshSetRayCallback(mesh, ask_ray);
    aim({Real(10.25), Real(0.5), 9}, {Real(10.25), Real(0.5), 0}, 100);
    for (int refuse = 0; refuse < 7; ++refuse)
        for (const bool one : {false, true}) {
            g_asked = {.triangles = {}, .points = {}, .refuse = refuse};
            dGeomRaySetClosestHit(ray, one);
            const auto found = hits();
            ASSERT_EQ(found.size(),
                      std::size_t(one ? std::min(1, 6 - std::min(6, refuse)) : 6 - std::min(6, refuse)));
            EXPECT_EQ(g_asked.triangles.size(), std::size_t(one ? std::min(6, refuse + 1) : 6));
            EXPECT_EQ(g_asked.mesh, mesh);
            EXPECT_EQ(g_asked.other, ray);
            for (std::size_t k = 0; k < g_asked.triangles.size(); ++k) {
                EXPECT_EQ(g_asked.triangles[k], 5 - int(k));
                EXPECT_LT(length(g_asked.points[k] - Vec3{Real(10.25), Real(0.5), Real(5 - int(k))}), kNear);
            }
            if (!found.empty()) { EXPECT_EQ(found[0].side2, 5 - refuse); }
        }
}

int give_up(dGeomID mesh, dGeomID other, int)
{
    const dTriMeshDataID data = dGeomTriMeshGetData(mesh);
    dGeomTriMeshDataUpdate(data);
    dGeomTriMeshDataDestroy(data);
    dGeomTriMeshSetData(mesh, nullptr);
    dGeomDestroy(mesh);
    dGeomDestroy(other);
    return 1;
}

TEST_F(MeshScene, functions_of_the_program_cannot_give_up_what_the_collision_needs)
{
    take(cube());
    dGeomTriMeshSetCallback(mesh, give_up);
    aim({Real(0.1), Real(0.2), 5}, {Real(0.1), Real(0.2), 0}, 10);
    MessageRecorder said;
    EXPECT_EQ(hits().size(), 2u);
    const std::string text = said.take();
    for (const char* name :
         {"dGeomTriMeshDataUpdate()", "dGeomTriMeshDataDestroy()", "dGeomTriMeshSetData()", "dGeomDestroy()"})
        EXPECT_NE(text.find(name), std::string::npos) << name;
    EXPECT_EQ(dGeomTriMeshGetTriangleCount(mesh), 12);
    EXPECT_EQ(hits().size(), 2u);
}

TEST_F(MeshScene, a_mesh_inside_a_transform_is_hit_and_reported_where_it_stands)
{
    take(cube());
    const dGeomID inner = dCreateTriMesh(nullptr, data, nullptr, nullptr, ask_ray),
                  outer = dCreateGeomTransform(nullptr);
    dGeomSetPosition(inner, 0, 0, 4);
    dGeomTransformSetGeom(outer, inner);
    dGeomTransformSetCleanup(outer, 1);
    dGeomSetPosition(outer, 20, 0, 0);
    aim({Real(20.1), Real(0.2), 9}, {Real(20.1), Real(0.2), 0}, 10);
    g_asked = {};
    dContactGeom c[4];
    ASSERT_EQ(dCollide(ray, outer, 4, c, sizeof(c[0])), 2);
    EXPECT_NEAR(c[0].pos[2], 4.5, kNear);
    EXPECT_EQ(g_asked.mesh, inner);
    EXPECT_LT(length(g_asked.points[0] - load(c[0].pos)), kNear);
    dGeomDestroy(outer);
}

TEST_F(MeshScene, planes_meet_every_vertex_below_once)
{
    for (const bool soup : {false, true}) {
        take(soup ? separate(cube()) : cube());
        const dGeomID plane = dCreatePlane(nullptr, 0, 0, 1, Real(0.1));
        dContactGeom c[16];
        ASSERT_EQ(dCollide(mesh, plane, 16, c, sizeof(c[0])), 4);
        for (int i = 0; i < 4; ++i) {
            EXPECT_NEAR(c[i].depth, 0.6, kNear);
            EXPECT_EQ(c[i].normal[2], 1);
            EXPECT_EQ(c[i].side2, -1);
            EXPECT_LE(i ? c[i - 1].side1 : 0, c[i].side1);
        }
        ASSERT_EQ(dCollide(plane, mesh, 16, c, sizeof(c[0])), 4);
        EXPECT_EQ(c[0].normal[2], -1);
        EXPECT_EQ(c[0].side1, -1);
        dGeomPlaneSetParams(plane, 0, 0, 1, 9);
        EXPECT_EQ(dCollide(mesh, plane, 16, c, sizeof(c[0])), 8);
        dGeomPlaneSetParams(plane, 0, 0, 1, -9);
        EXPECT_EQ(dCollide(mesh, plane, 16, c, sizeof(c[0])), 0);
        dGeomDestroy(plane);
    }
}

// A finely cut slab pressed into the ground: what is kept carries it.
TEST_F(MeshScene, of_many_vertices_below_a_plane_those_are_kept_that_carry)
{
    Figure slab = flat_grid(20, 20, 0);
    for (Vec3& v : slab.vertices) v = {v.x - 10, v.y - 10, Real(-0.25)};
    take(slab);
    const dGeomID plane = dCreatePlane(nullptr, 0, 0, 1, 0);
    dContactGeom c[400];
    const int four = dCollide(mesh, plane, 4, c, sizeof(c[0]));
    ASSERT_EQ(four, 4);
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(std::fabs(c[i].pos[0]) + std::fabs(c[i].pos[1]), 20) << i;  // its corners
    for (const int capacity : {1, 2, 3, 8, 64, 400}) {
        const int count = dCollide(mesh, plane, capacity, c, sizeof(c[0]));
        EXPECT_GE(count, std::min(capacity, 4));
        EXPECT_LE(count, capacity);
        for (int i = 0; i < count; ++i)
            for (int j = 0; j < i; ++j) EXPECT_NE(load(c[i].pos), load(c[j].pos));
    }
    EXPECT_EQ(dCollide(mesh, plane, int(100 | CONTACTS_UNIMPORTANT), c, sizeof(c[0])), 100);
    dGeomDestroy(plane);
}

TEST_F(MeshScene, planes_meet_what_they_meet_vertex_by_vertex)
{
    RandomNumbers random(12);
    const Figure figure = random_soup(random, 300, 5, 1);
    take(figure);
    const dGeomID plane = dCreatePlane(nullptr, 0, 0, 1, 0);
    std::vector<dContactGeom> c(1000);
    for (int i = 0; i < 60; ++i) {
        const Pose pose{3 * random.vec(), to_matrix(random.rotation())};
        dMatrix3 R;
        store_mat(R, pose.R);
        dGeomSetPosition(mesh, pose.p.x, pose.p.y, pose.p.z);
        dGeomSetRotation(mesh, R);
        const Vec3 n = random.direction();
        const Real d = 6 * random.in(-1, 1);
        dGeomPlaneSetParams(plane, n.x, n.y, n.z, d);
        int below = 0, doubtful = 0;
        for (const Vec3 v : figure.vertices) {
            const Real depth = d - dot(n, pose.to_world(v));
            below += depth > 0;
            doubtful += std::fabs(depth) < kNear;
        }
        const int found = dCollide(mesh, plane, 1000, c.data(), sizeof(c[0]));
        EXPECT_LE(std::abs(found - below), doubtful);
    }
    dGeomDestroy(plane);
}

}  // namespace
}  // namespace epode
