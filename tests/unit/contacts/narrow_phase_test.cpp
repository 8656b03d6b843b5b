// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which pairs keep the points they had.
#include "contacts/narrow_phase.h"

#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

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
        dBodySetPosition(body, x + along, 0, Real(0.5) - kLayer);
        const dQuaternion q = {1, turned / 2, 0, 0};
        dBodySetQuaternion(body, q);
    }
    // Points of a collision at the present place, after one at the first.
    bool keeps_points(Real along, Real turned)
    {
        ContactPair pair;
        pair.id1 = cube, pair.id2 = ground;
        pair.body1 = from_handle<Body>(dGeomGetBody(cube)), pair.body2 = nullptr;
        pair.most = data ? kSurfacePatches : 1;
        const NarrowSettings settings = {kLayer, {Real(1) / 60, {}}, false};
        KeptPatch before[kSurfacePatches], after[kSurfacePatches];
        place_cube(0, 0);
        update_pair(pair, {}, settings, before, nullptr);
        EXPECT_GT(pair.count, 0);
        const int count = pair.count;
        place_cube(along, turned);
        update_pair(pair, std::span(before).first(std::size_t(count)), settings, after, nullptr);
        EXPECT_GT(pair.count, 0);
        const Float3 was = before[0].offset, is = after[0].offset;
        return was.x == is.x && was.y == is.y && was.z == is.z;
    }

    dWorldID world;
    Real x = 0;
    dGeomID cube, ground = nullptr;
    dTriMeshDataID data = nullptr;
    float vertices[12];
    const dTriIndex indices[6] = {0, 1, 2, 0, 2, 3};
};

// Full patches allow 2 % of half the cube, as it was found; others a quarter of the layer.
TEST_F(NarrowPhase, a_full_patch_stays_while_the_cube_moves_by_less_than_a_hundredth)
{
    lay_plane();
    EXPECT_TRUE(keeps_points(0, 0));
    EXPECT_TRUE(keeps_points(Real(0.009), 0));
    EXPECT_FALSE(keeps_points(Real(0.011), 0));
    EXPECT_TRUE(keeps_points(0, Real(0.005)));
    EXPECT_FALSE(keeps_points(0, Real(0.03)));
}

TEST_F(NarrowPhase, patches_on_a_mesh_stay_while_the_cube_moves_by_less_than_a_quarter_of_the_layer)
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
