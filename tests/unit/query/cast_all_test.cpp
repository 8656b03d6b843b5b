// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every hit of a swept shape, overlaps at the beginning, normals of faces; rays that leave what they start on.
#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <cmath>
#include <cstdarg>
#include <vector>

namespace epode::test {
namespace {

struct CastSpace {
    CastSpace() { dInitODE(), space = dHashSpaceCreate(nullptr), ball = dCreateSphere(nullptr, dReal(0.5)); }
    ~CastSpace() { dGeomDestroy(ball), dSpaceDestroy(space), dCloseODE(); }
    CastSpace(const CastSpace&) = delete;
    CastSpace& operator=(const CastSpace&) = delete;
    dGeomID box(double x, double y = 0, double z = 0, double size = 1) const
    {
        const dGeomID geom = dCreateBox(space, dReal(size), dReal(size), dReal(size));
        dGeomSetPosition(geom, dReal(x), dReal(y), dReal(z));
        return geom;
    }
    std::vector<dCastHit> all(dGeomID o, double x, double y, double z,
                              const dQueryFilter* filter = nullptr) const
    {
        const dVector3 motion = {dReal(x), dReal(y), dReal(z)};
        std::vector<dCastHit> hits(std::size_t(dSpaceCastAll(space, o, motion, filter, nullptr, 0)));
        EXPECT_EQ(dSpaceCastAll(space, o, motion, filter, hits.data(), int(hits.size())), int(hits.size()));
        return hits;
    }
    dSpaceID space;
    dGeomID ball;
};

constexpr double kNear = sizeof(dReal) == 8 ? 1e-6 : 1e-3;

TEST(CastAll, lists_every_hit_the_nearest_first_and_agrees_with_the_closest)
{
    const CastSpace scene;
    const dGeomID far = scene.box(9), near = scene.box(3), middle = scene.box(6);
    scene.box(3, 5);
    scene.box(-3);
    const auto hits = scene.all(scene.ball, 20, 0, 0);
    ASSERT_EQ(hits.size(), 3u);
    EXPECT_EQ(hits[0].geom, near);
    EXPECT_EQ(hits[1].geom, middle);
    EXPECT_EQ(hits[2].geom, far);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(hits[std::size_t(i)].distance, 2 + 3 * i, kNear);
    dQueryHit closest;
    const dVector3 motion = {20, 0, 0};
    ASSERT_EQ(dSpaceCast(scene.space, scene.ball, motion, nullptr, &closest), 1);
    EXPECT_EQ(closest.geom, near);
    EXPECT_EQ(closest.distance, hits[0].distance);
    EXPECT_NEAR(hits[0].normal[0], -1, kNear);
    EXPECT_NEAR(hits[0].face_normal[0], -1, kNear);
    EXPECT_EQ(hits[0].depth, 0);
}

TEST(CastAll, reports_overlaps_with_their_depth_or_leaves_them_out)
{
    const CastSpace scene;
    const dGeomID in = scene.box(0.75), ahead = scene.box(4);
    auto hits = scene.all(scene.ball, 10, 0, 0);
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_EQ(hits[0].geom, in);
    EXPECT_EQ(hits[0].distance, 0);
    EXPECT_NEAR(hits[0].depth, 0.25, kNear);
    dQueryFilter filter;
    dQueryFilterInit(&filter, sizeof filter);
    filter.skip_overlaps = 1;
    hits = scene.all(scene.ball, 10, 0, 0, &filter);
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_EQ(hits[0].geom, ahead);
    dQueryHit closest;
    const dVector3 motion = {10, 0, 0};
    ASSERT_EQ(dSpaceCast(scene.space, scene.ball, motion, &filter, &closest), 1);
    EXPECT_EQ(closest.geom, ahead);
}

// A ball that comes down at a box's top edge touches it aslant; the face against the motion is the top.
TEST(CastAll, says_the_face_of_an_edge_that_was_hit)
{
    const CastSpace scene;
    scene.box(0);
    dGeomSetPosition(scene.ball, dReal(0.8), 0, 3);
    const auto hits = scene.all(scene.ball, 0, 0, -5);
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_NEAR(hits[0].normal[0], 0.6, 1e-3);
    EXPECT_NEAR(hits[0].normal[2], 0.8, 1e-3);
    EXPECT_NEAR(hits[0].face_normal[2], 1, kNear);
}

// A floor and a wall of one mesh: the triangles that overlap are left out, the wall is not.
TEST(CastAll, leaves_out_the_triangles_of_a_mesh_that_overlap_alone)
{
    const CastSpace scene;
    const double at[8][3] = {{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0},
                             {5, -5, 0},  {5, 5, 0},  {5, 5, 4}, {5, -5, 4}};
    const dTriIndex triangles[12] = {0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6};
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data, at, 3 * sizeof(double), 8, triangles, 12, 3 * sizeof(dTriIndex));
    const dGeomID mesh = dCreateTriMesh(scene.space, data, nullptr, nullptr, nullptr);
    dGeomSetPosition(scene.ball, 0, 0, dReal(0.4));
    dQueryFilter filter;
    dQueryFilterInit(&filter, sizeof filter);
    filter.skip_overlaps = 1;
    const auto hits = scene.all(scene.ball, 10, 0, 0, &filter);
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_EQ(hits[0].geom, mesh);
    EXPECT_NEAR(hits[0].distance, 4.5, kNear);
    EXPECT_NEAR(std::fabs(hits[0].face_normal[0]), 1, kNear);
    dGeomDestroy(mesh), dGeomTriMeshDataDestroy(data);
}

TEST(CastAll, refuses_what_the_closest_refuses)
{
    const CastSpace scene;
    scene.box(3);
    const dVector3 motion = {5, 0, 0}, none = {0, 0, 0};
    dCastHit hit;
    dSetMessageHandler([](int, const char*, va_list) {});
    EXPECT_EQ(dSpaceCastAll(nullptr, scene.ball, motion, nullptr, &hit, 1), 0);
    EXPECT_EQ(dSpaceCastAll(scene.space, scene.ball, none, nullptr, &hit, 1), 0);
    EXPECT_EQ(dSpaceCastAll(scene.space, scene.ball, motion, nullptr, nullptr, 1), 0);
    EXPECT_EQ(dSpaceCastAll(scene.space, scene.ball, motion, nullptr, &hit, -1), 0);
    EXPECT_EQ(dSpaceCastAll(scene.space, nullptr, motion, nullptr, &hit, 1), 0);
    dSetMessageHandler(nullptr);
}

// Outward from a face, and inward: the far wall is then met from inside only where the near one is not at the start.
TEST(RayStarts, a_ray_that_leaves_a_surface_outward_does_not_hit_it)
{
    const CastSpace scene;
    const dGeomID ground = dCreatePlane(scene.space, 0, 0, 1, 0);
    const dGeomID ball = dCreateSphere(scene.space, 1);
    dGeomSetPosition(ball, 0, 0, 5);
    const dGeomID box = scene.box(10, 0, 5, 2);
    const dGeomID cylinder = dCreateCylinder(scene.space, 1, 2);
    dGeomSetPosition(cylinder, 20, 0, 5);
    const double tops[4][3] = {{0, 0, 6}, {10, 0, 6}, {20, 0, 6}, {30, 0, 0}};
    for (const auto& top : tops) {
        const dVector3 from = {dReal(top[0]), dReal(top[1]), dReal(top[2])}, up = {0, 0, 1},
                       down = {0, 0, -1};
        dQueryHit hit;
        EXPECT_EQ(dSpaceRayClosest(scene.space, from, up, 3, nullptr, &hit), 0) << top[0];
        ASSERT_EQ(dSpaceRayClosest(scene.space, from, down, 3, nullptr, &hit), 1) << top[0];
        EXPECT_EQ(hit.distance, 0);
        EXPECT_LT(hit.normal[2] * -1, 0) << "against the ray";
    }
    (void)ground, (void)box;
}

TEST(RayStarts, a_ray_that_leaves_a_mesh_meets_what_the_mesh_has_beyond)
{
    const CastSpace scene;
    const double at[6][3] = {{-5, -5, 0}, {5, -5, 0}, {0, 5, 0}, {-5, -5, 2}, {5, -5, 2}, {0, 5, 2}};
    const dTriIndex triangles[6] = {0, 1, 2, 3, 4, 5};
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data, at, 3 * sizeof(double), 6, triangles, 6, 3 * sizeof(dTriIndex));
    const dGeomID mesh = dCreateTriMesh(scene.space, data, nullptr, nullptr, nullptr);
    const dVector3 from = {0, 0, 0}, up = {0, 0, 1};
    dQueryHit hit;
    ASSERT_EQ(dSpaceRayClosest(scene.space, from, up, 3, nullptr, &hit), 1);
    EXPECT_NEAR(hit.distance, 2, kNear);
    EXPECT_EQ(hit.side, 1);
    dGeomDestroy(mesh), dGeomTriMeshDataDestroy(data);
}

}  // namespace
}  // namespace epode::test
