// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What solids keep of the mesh that they met last cannot be told from their contacts: these are those of a
// geom that has just been made, bit by bit, wherever the solid goes and whatever becomes of the mesh.
#include "collide/geom_leaves.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "../geometry/mesh_shapes.h"
#include "ode/ode.h"

namespace epode {
namespace {

constexpr int kCapacity = 12;
constexpr int kKinds = 4;

dGeomID make_solid(int kind)
{
    if (kind == 0) return dCreateSphere(nullptr, Real(0.4));
    if (kind == 1) return dCreateBox(nullptr, Real(0.6), Real(0.9), Real(0.5));
    if (kind == 2) return dCreateCapsule(nullptr, Real(0.3), Real(0.8));
    return dCreateCylinder(nullptr, Real(0.35), Real(0.7));
}

struct Contacts {
    dContactGeom at[kCapacity];
    int count = 0;
};

Contacts collide(dGeomID solid, dGeomID mesh, bool mesh_first = false)
{
    Contacts c;
    c.count =
        dCollide(mesh_first ? mesh : solid, mesh_first ? solid : mesh, kCapacity, c.at, sizeof(dContactGeom));
    return c;
}

// But for the names of the geoms.
bool same(const Contacts& a, const Contacts& b)
{
    bool all = a.count == b.count;
    for (int i = 0; all && i < a.count; ++i) {
        const dContactGeom &p = a.at[i], &q = b.at[i];
        for (int k = 0; k < 3; ++k) all = all && p.pos[k] == q.pos[k] && p.normal[k] == q.normal[k];
        all = all && p.depth == q.depth && p.side1 == q.side1 && p.side2 == q.side2;
    }
    return all;
}

bool knows_leaves(dGeomID solid)
{
    const GeomLeaves* kept = from_handle<Geom>(solid)->leaves.load();
    return kept && kept->leaves.edition != 0 && kept->leaves.count <= NearLeaves::kCapacity;
}

// A mesh of the program's, and its arrays.
struct Ground {
    explicit Ground(const Figure& figure)
    {
        for (const Vec3 v : figure.vertices)
            for (const Real x : {v.x, v.y, v.z, Real(0)}) vertices.push_back(x);
        for (const MeshCorners& c : figure.triangles)
            for (const int i : c.at) indices.push_back(dTriIndex(i));
        data = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildSimple(data, vertices.data(), int(figure.vertices.size()), indices.data(),
                                    int(indices.size()));
        geom = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
    }
    Ground(const Ground&) = delete;
    Ground& operator=(const Ground&) = delete;
    ~Ground()
    {
        dGeomDestroy(geom);
        dGeomTriMeshDataDestroy(data);
    }
    std::vector<Real> vertices;
    std::vector<dTriIndex> indices;
    dTriMeshDataID data;
    dGeomID geom;
};

Figure hills(int cells, Real height, std::uint64_t key)
{
    RandomNumbers dice(key);
    Figure f = flat_grid(cells, cells, 0);
    for (Vec3& v : f.vertices) v.z = dice.in(0, height);
    return f;
}

struct GeomLeavesTest : testing::Test {
    GeomLeavesTest() { dInitODE(); }
    ~GeomLeavesTest() override { dCloseODE(); }

    void expect_as_fresh(dGeomID solid, int kind, dGeomID mesh, bool mesh_first = false)
    {
        const dGeomID fresh = make_solid(kind);
        dGeomSetPosition(fresh, dGeomGetPosition(solid)[0], dGeomGetPosition(solid)[1],
                         dGeomGetPosition(solid)[2]);
        dGeomSetRotation(fresh, dGeomGetRotation(solid));
        const Contacts expected = collide(fresh, mesh, mesh_first);
        EXPECT_TRUE(same(collide(solid, mesh, mesh_first), expected));
        contacts += expected.count;
        gathered += knows_leaves(solid);
        dGeomDestroy(fresh);
    }

    // A way over the mesh: steps of `step`, turning, and now and then a jump.
    template <typename Each>
    void travel(int kind, Real step, int steps, const Each& each)
    {
        RandomNumbers dice(std::uint64_t(31 + kind));
        const dGeomID solid = make_solid(kind);
        Vec3 at{8, 8, Real(0.5)}, way;
        for (int i = 0; i < steps; ++i) {
            if (i % 40 == 0) at = {dice.in(2, 14), dice.in(2, 14), Real(0.5)}, way = step * dice.direction();
            at += Vec3{way.x, way.y, step * dice.in(-1, 1)};
            const Quat q = dice.rotation();
            dGeomSetPosition(solid, at.x, at.y, at.z);
            const dReal turned[4] = {q.w, q.x, q.y, q.z};
            if (i % 7 == 0) dGeomSetQuaternion(solid, turned);
            each(solid, i);
        }
        dGeomDestroy(solid);
    }

    int contacts = 0, gathered = 0;
};

TEST_F(GeomLeavesTest, contacts_do_not_depend_on_the_way_there)
{
    const Ground ground(hills(16, Real(0.5), 5));
    for (int kind = 0; kind < kKinds; ++kind)
        for (const Real step : {Real(0.004), Real(0.05), Real(2)}) {
            SCOPED_TRACE(kind);
            contacts = gathered = 0;
            travel(kind, step, 400,
                   [&](dGeomID solid, int i) { expect_as_fresh(solid, kind, ground.geom, i % 3 == 0); });
            // It is of use to what moves by little, and to nothing that leaps.
            const bool leaps = step > 1;
            EXPECT_GT(contacts, leaps ? 0 : 100);
            if (!leaps) { EXPECT_GT(gathered, 200); }
        }
}

TEST_F(GeomLeavesTest, the_mesh_may_move)
{
    const Ground ground(hills(16, Real(0.5), 6));
    RandomNumbers dice(3);
    for (int kind = 0; kind < kKinds; ++kind)
        travel(kind, Real(0.01), 200, [&](dGeomID solid, int i) {
            dGeomSetPosition(ground.geom, dice.in(0, Real(0.1)), i % 50 == 0 ? 3 : 0, 0);
            expect_as_fresh(solid, kind, ground.geom);
        });
    EXPECT_GT(contacts, 400);
    EXPECT_GT(gathered, 400);
}

TEST_F(GeomLeavesTest, the_mesh_may_change)
{
    Ground ground(hills(16, Real(0.5), 7));
    RandomNumbers dice(4);
    for (int kind = 0; kind < kKinds; ++kind)
        travel(kind, Real(0.005), 120, [&](dGeomID solid, int i) {
            if (i % 20 == 10) {
                // Its extent stays, so that the tree's frame does.
                for (std::size_t v = 4 * 20; v < ground.vertices.size() - 4 * 20; v += 4)
                    ground.vertices[v + 2] = dice.in(0, Real(0.5));
                dGeomTriMeshDataUpdate(ground.data);
            }
            expect_as_fresh(solid, kind, ground.geom);
        });
    EXPECT_GT(contacts, 200);
    EXPECT_GT(gathered, 200);
}

TEST_F(GeomLeavesTest, another_mesh_may_take_the_place_of_one)
{
    const dGeomID solid = make_solid(1);
    for (std::uint64_t key = 0; key < 20; ++key) {
        const Ground ground(hills(12, Real(0.6), key)), other(hills(12, Real(0.6), key + 50));
        for (int i = 0; i < 8; ++i) {
            dGeomSetPosition(solid, 6 + Real(0.01) * Real(i), 6, Real(0.6));
            expect_as_fresh(solid, 1, ground.geom);
            if (key % 2 == 0) expect_as_fresh(solid, 1, other.geom);  // in turn
        }
        dGeomTriMeshSetData(ground.geom, other.data);
        for (int i = 0; i < 3; ++i) expect_as_fresh(solid, 1, ground.geom);
    }
    EXPECT_GT(contacts, 200);
    EXPECT_GT(gathered, 50);
    dGeomDestroy(solid);
}

TEST_F(GeomLeavesTest, the_solid_may_change)
{
    const Ground ground(hills(16, Real(0.5), 8));
    const dGeomID ball = dCreateSphere(nullptr, Real(0.2));
    for (const Real radius : {Real(0.2), Real(0.21), Real(1.5), Real(6), Real(0.3)}) {
        dGeomSphereSetRadius(ball, radius);
        const dGeomID fresh = dCreateSphere(nullptr, radius);
        for (const dGeomID g : {ball, fresh}) dGeomSetPosition(g, 8, 8, Real(0.2) + Real(0.8) * radius);
        for (int i = 0; i < 3; ++i) {
            const Contacts expected = collide(fresh, ground.geom);
            EXPECT_GT(expected.count, 0);
            EXPECT_TRUE(same(collide(ball, ground.geom), expected)) << radius;
        }
        dGeomDestroy(fresh);
    }
    dGeomDestroy(ball);
}

TEST_F(GeomLeavesTest, two_threads_may_collide_one_solid)
{
    const Ground low(hills(16, Real(0.5), 9)), high(hills(16, Real(0.5), 10));
    const dGeomID solid = make_solid(3), fresh = make_solid(3);
    for (const dGeomID g : {solid, fresh}) dGeomSetPosition(g, 8, 8, Real(0.5));
    const Contacts expected[2] = {collide(fresh, low.geom), collide(fresh, high.geom)};
    ASSERT_GT(expected[0].count * expected[1].count, 0);
    int wrong[2] = {};
    const auto ask = [&](int who) {
        for (int i = 0; i < 3000; ++i) {
            const int which = (i / 5 + who) % 2;
            wrong[who] += !same(collide(solid, which ? high.geom : low.geom), expected[which]);
        }
    };
    std::thread other(ask, 1);
    ask(0);
    other.join();
    EXPECT_EQ(wrong[0] + wrong[1], 0);
    dGeomDestroy(solid);
    dGeomDestroy(fresh);
}

}  // namespace
}  // namespace epode
