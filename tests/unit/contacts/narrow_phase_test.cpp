// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which pairs keep the points they had.
#include "contacts/narrow_phase.h"

#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "collide/collide.h"

namespace epode::test {
namespace {

constexpr Real kLayer = Real(1e-3);

// A cube of one metre that lies on something.
class NarrowPhase : public testing::Test {
  protected:
    NarrowPhase()
    {
        dInitODE();
        world = dWorldCreate();
        cube = dCreateBox(nullptr, 1, 1, 1);
        dGeomSetBody(cube, dBodyCreate(world));
    }
    ~NarrowPhase() override
    {
        dGeomDestroy(cube);
        take_ground();
        dWorldDestroy(world);
        dCloseODE();
    }
    void lay_plane() { ground = dCreatePlane(nullptr, 0, 0, 1, 0); }
    // Its own place is the origin, and the cube is far away.
    void lay_mesh(Real far)
    {
        take_ground();
        x = far;
        const float end = float(far) + 10;
        const float v[4][3] = {{-10, -10, 0}, {end, -10, 0}, {end, 10, 0}, {-10, 10, 0}};
        for (int i = 0; i < 4; ++i)
            for (int k = 0; k < 3; ++k) vertices[3 * i + k] = v[i][k];
        data = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildSingle(data, vertices, 3 * sizeof(float), 4, indices, 6, 3 * sizeof(dTriIndex));
        ground = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
    }
    void take_ground()
    {
        if (ground) dGeomDestroy(ground);
        if (data) dGeomTriMeshDataDestroy(data);
        ground = nullptr, data = nullptr;
    }
    void place_cube(Real along, Real turned)
    {
        const dBodyID body = dGeomGetBody(cube);
        const Real height = Real(0.5) * (std::cos(lean) + std::sin(lean));
        dBodySetPosition(body, x + along, 0, height - kLayer);
        const dQuaternion q = {std::cos(lean / 2), turned / 2, std::sin(lean / 2), 0};
        dBodySetQuaternion(body, q);
    }
    ContactPair cube_and_ground() const
    {
        ContactPair pair;
        pair.id1 = cube, pair.id2 = ground;
        pair.body1 = from_handle<Body>(dGeomGetBody(cube)), pair.body2 = nullptr;
        pair.max_manifolds = data ? kSurfaceManifolds : 1;
        return pair;
    }
    // Where they are, on a ground that is no mesh.
    ContactManifold update(std::span<const CachedManifold> old)
    {
        ContactPair pair = cube_and_ground();
        update_pair(pair, old, {kLayer, true, {Real(1) / 60, {}}, foresees}, &manifold, nullptr);
        EXPECT_EQ(pair.count, 1);
        return manifold.manifold;
    }
    static int deepest(const ContactManifold& p)
    {
        const auto less = [](const ManifoldPoint& a, const ManifoldPoint& b) {
            return a.separation < b.separation;
        };
        return int(std::min_element(p.points, p.points + p.count, less) - p.points);
    }
    // Points of a collision at the present place, after one at the first.
    bool keeps_points(Real along, Real turned)
    {
        ContactPair pair = cube_and_ground();
        const NarrowSettings settings = {kLayer, true, {Real(1) / 60, {}}, foresees};
        CachedManifold before[kSurfaceManifolds], after[kSurfaceManifolds];
        place_cube(0, 0);
        update_pair(pair, {}, settings, before, nullptr);
        EXPECT_GT(pair.count, 0);
        const int count = pair.count;
        place_cube(along, turned);
        update_pair(pair, std::span(before).first(std::size_t(count)), settings, after, nullptr);
        EXPECT_GT(pair.count, 0);
        const Float3 was = before[0].found.offset, is = after[0].found.offset;
        return was.x == is.x && was.y == is.y && was.z == is.z;
    }

    dWorldID world;
    Real x = 0, lean = 0;  // the latter on an edge
    bool foresees = false;
    dGeomID cube, ground = nullptr;
    dTriMeshDataID data = nullptr;
    CachedManifold manifold;
    float vertices[12];
    const dTriIndex indices[6] = {0, 1, 2, 0, 2, 3};
};

// Full manifolds allow 2 % of half the cube, as it was found; others a quarter of the layer.
TEST_F(NarrowPhase, a_full_manifold_stays_while_the_cube_moves_by_less_than_a_hundredth)
{
    lay_plane();
    EXPECT_TRUE(keeps_points(0, 0));
    EXPECT_TRUE(keeps_points(Real(0.009), 0));
    EXPECT_FALSE(keeps_points(Real(0.011), 0));
    EXPECT_TRUE(keeps_points(0, Real(0.005)));
    EXPECT_FALSE(keeps_points(0, Real(0.03)));
}

TEST_F(NarrowPhase, a_manifold_with_all_corners_nearby_stays_as_long_as_a_full_one)
{
    lay_plane();
    lean = Real(0.3);
    EXPECT_FALSE(keeps_points(Real(0.005), 0));
    foresees = true;
    EXPECT_TRUE(keeps_points(Real(0.005), 0));
    EXPECT_FALSE(keeps_points(Real(0.05), 0));
}

// Boxes that settle on one another: one corner touches, then others. While points are kept, they are as deep
// as those of a new collision.
TEST_F(NarrowPhase, kept_points_of_polyhedra_miss_no_corner_that_comes_down)
{
    ground = dCreateBox(nullptr, 3, 3, 1);
    dGeomSetPosition(ground, 0, 0, Real(-0.5));
    foresees = true;
    std::mt19937_64 engine{11};
    const auto between = [&](Real lo, Real hi) {
        return lo + (hi - lo) * Real(double(engine() >> 11) * 0x1p-53);
    };
    const auto place = [&](const Vec3& turn, Real deep) {
        const dQuaternion q = {1, turn.x / 2, turn.y / 2, turn.z / 2};
        dBodySetQuaternion(dGeomGetBody(cube), q);
        const dReal* R = dBodyGetRotation(dGeomGetBody(cube));
        const Real down = (std::fabs(R[8]) + std::fabs(R[9]) + std::fabs(R[10])) / 2;
        dBodySetPosition(dGeomGetBody(cube), 0, 0, down - deep);
    };
    int kept = 0, became_deepest = 0;
    for (int i = 0; i < 500; ++i) {
        const Vec3 turn = {between(Real(-0.02), Real(0.02)), between(Real(-0.02), Real(0.02)),
                           between(-1, 1)};
        const Vec3 more = {between(Real(-0.01), Real(0.01)), between(Real(-0.01), Real(0.01)), 0};
        place(turn, kLayer);
        const ContactManifold before = update({});
        const CachedManifold old = manifold;
        place(turn + more, kLayer);
        const ContactManifold after = update({&old, 1});
        if (manifold.found.offset.z != old.found.offset.z) continue;
        ++kept;
        became_deepest += deepest(before) != deepest(after);
        EXPECT_NEAR(after.points[deepest(after)].separation, 0, Real(0.1) * kLayer) << i;
    }
    EXPECT_GT(kept, 100);
    EXPECT_GT(became_deepest, 20);
}

TEST_F(NarrowPhase, manifolds_on_a_mesh_stay_while_the_cube_moves_by_less_than_a_quarter_of_the_layer)
{
    for (const Real far : {Real(0), Real(30), Real(200)}) {
        lay_mesh(far);
        EXPECT_TRUE(keeps_points(0, 0)) << far;
        EXPECT_TRUE(keeps_points(Real(0.2) * kLayer, 0)) << far;
        EXPECT_FALSE(keeps_points(Real(0.3) * kLayer, 0)) << far;
        EXPECT_TRUE(keeps_points(0, Real(0.2) * kLayer)) << far;
        EXPECT_FALSE(keeps_points(0, Real(1.2) * kLayer)) << far;
    }
}

}  // namespace
}  // namespace epode::test
