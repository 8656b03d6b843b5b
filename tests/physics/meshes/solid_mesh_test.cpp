// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Closed meshes as solids: what is inside is pushed out by the nearest way, distances are signed, surfaces
// that are not closed are refused. The references are closed forms of the cube and, for a body with hollow
// and saddle corners, the winding number. Also the program's numbers for contacts that have become one.
#include <array>

#include "rig.h"

namespace epode::physics {
namespace {

struct MeshOf {
    std::vector<dReal> vertices;
    std::vector<dTriIndex> indices;
    dTriMeshDataID data = dGeomTriMeshDataCreate();
    ~MeshOf() { dGeomTriMeshDataDestroy(data); }

    void vertex(V3 v)
    {
        for (const double x : {v.x, v.y, v.z, 0.0}) vertices.push_back(real(x));
    }
    void quad(int a, int b, int c, int d)
    {
        for (const int i : {a, b, c, a, c, d}) indices.push_back(dTriIndex(i));
    }
    void build()
    {
        dGeomTriMeshDataBuildSimple(data, vertices.data(), int(vertices.size() / 4), indices.data(),
                                    int(indices.size()));
    }
    V3 corner(std::size_t i) const { return vec(&vertices[4 * std::size_t(indices[i])]); }
};

// The cube of half edge 1.
void make_cube(MeshOf& m)
{
    for (int i = 0; i < 8; ++i) m.vertex({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
    m.quad(0, 2, 3, 1), m.quad(4, 5, 7, 6), m.quad(0, 1, 5, 4);
    m.quad(2, 6, 7, 3), m.quad(0, 4, 6, 2), m.quad(1, 3, 7, 5);
}

// A ring of square section, its height waving round: hollow edges inside, saddle corners.
void make_ring(MeshOf& m)
{
    constexpr int n = 12;
    for (int i = 0; i < n; ++i) {
        const double a = 2 * kPi * i / n, wave = 0.3 * (i % 3);
        for (const V3 v : {V3{2, 0, wave}, V3{2, 0, 1 + wave}, V3{1, 0, 1 - wave}, V3{1, 0, -wave}})
            m.vertex({v.x * std::cos(a), v.x * std::sin(a), v.z});
    }
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < 4; ++k) {
            const int j = (i + 1) % n, l = (k + 1) % 4;
            m.quad(4 * i + k, 4 * j + k, 4 * j + l, 4 * i + l);
        }
}

// How often the surface winds round a point: the sum of its solid angles (van Oosterom and Strackee 1983).
double winding(const MeshOf& m, V3 p)
{
    double sum = 0;
    for (std::size_t i = 0; i < m.indices.size(); i += 3) {
        const V3 a = m.corner(i) - p, b = m.corner(i + 1) - p, c = m.corner(i + 2) - p;
        const double x = length(a), y = length(b), z = length(c);
        sum += 2 * std::atan2(dot(a, cross(b, c)), x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y);
    }
    return sum / (4 * kPi);
}

TEST(SolidMesh, pushes_a_ball_out_by_the_nearest_face)
{
    Sim sim;
    MeshOf m;
    make_cube(m);
    m.build();
    const dGeomID cube = dCreateTriMesh(sim.space, m.data, nullptr, nullptr, nullptr);
    const dGeomID ball = dCreateSphere(sim.space, real(0.1));
    dGeomSetPosition(ball, real(0.2), real(-0.7), real(0.1));
    dContactGeom c[8];
    EXPECT_EQ(dCollide(ball, cube, 8, c, sizeof c[0]), 0);  // a surface
    dGeomTriMeshSetSolid(cube, 1);
    ASSERT_EQ(dCollide(ball, cube, 8, c, sizeof c[0]), 1);
    EXPECT_NEAR(c[0].depth, 0.4, tol(1e-12, 1e-6));
    EXPECT_NEAR(c[0].normal[1], -1, tol(1e-12, 1e-6));
    EXPECT_GE(c[0].side2, 0);
    ASSERT_EQ(dCollide(cube, ball, 8, c, sizeof c[0]), 1);
    EXPECT_NEAR(c[0].normal[1], 1, tol(1e-12, 1e-6));
    dQueryDistance d{};
    ASSERT_EQ(dGeomGetDistance(ball, cube, dInfinity, &d), 1);
    EXPECT_NEAR(d.distance, -0.4, tol(1e-12, 1e-6));
    dGeomID met[2];
    EXPECT_EQ(dSpaceOverlap(sim.space, ball, nullptr, met, 2), 1);
    dGeomTriMeshSetSolid(cube, 0);
    EXPECT_EQ(dSpaceOverlap(sim.space, ball, nullptr, met, 2), 0);
}

// Moving a solid by normal * depth must part it from the mesh.
TEST(SolidMesh, the_way_out_leads_out)
{
    Sim sim;
    MeshOf m;
    make_cube(m);
    m.build();
    const dGeomID cube = dCreateTriMesh(sim.space, m.data, nullptr, nullptr, nullptr);
    dGeomTriMeshSetSolid(cube, 1);
    const dReal t = real(0.2);
    const dReal points[] = {t, t, t, -t, -t, t, -t, t, -t, t, -t, -t};
    const dGeomID shapes[] = {dCreateSphere(nullptr, t), dCreateBox(nullptr, t, t, t),
                              dCreateCapsule(nullptr, real(0.1), t), dCreateCylinder(nullptr, t, t),
                              dCreateConvexHull(nullptr, points, 4, 0)};
    Random dice(3);
    for (const dGeomID shape : shapes) {
        for (int i = 0; i < 200; ++i) {
            const V3 at = dice.point(0.95);
            dQuaternion q;
            dice.quaternion(q);
            dGeomSetPosition(shape, real(at.x), real(at.y), real(at.z));
            dGeomSetQuaternion(shape, q);
            dContactGeom c[4];
            const int count = dCollide(shape, cube, 4, c, sizeof c[0]);
            ASSERT_GT(count, 0);
            double depth = 0;
            for (int k = 0; k < count; ++k) depth = std::max(depth, double(c[k].depth));
            const V3 to = at + (depth + 1e-4) * vec(c[0].normal);
            dGeomSetPosition(shape, real(to.x), real(to.y), real(to.z));
            EXPECT_EQ(dCollide(shape, cube, 4, c, sizeof c[0]), 0) << at.x << ' ' << at.y << ' ' << at.z;
        }
        dGeomDestroy(shape);
    }
}

TEST(SolidMesh, is_inside_where_the_winding_number_is_one)
{
    Sim sim;
    MeshOf m;
    make_ring(m);
    m.build();
    const dGeomID ring = dCreateTriMesh(sim.space, m.data, nullptr, nullptr, nullptr);
    const Messages messages;
    dGeomTriMeshSetSolid(ring, 1);
    ASSERT_EQ(messages.count(), 0) << messages.last();
    const dGeomID dot_ = dCreateSphere(sim.space, real(1e-6));
    Random dice(9);
    int inside = 0;
    for (int i = 0; i < 4000; ++i) {
        const V3 p = {dice.uniform(-2.2, 2.2), dice.uniform(-2.2, 2.2), dice.uniform(-0.8, 1.8)};
        const double turns = winding(m, p);
        dGeomSetPosition(dot_, real(p.x), real(p.y), real(p.z));
        dQueryDistance d{};
        ASSERT_EQ(dGeomGetDistance(dot_, ring, dInfinity, &d), 1);
        if (std::fabs(double(d.distance)) < 1e-4) continue;
        EXPECT_EQ(d.distance<0, turns> 0.5) << p.x << ' ' << p.y << ' ' << p.z << ' ' << turns;
        inside += turns > 0.5;
    }
    EXPECT_GT(inside, 400);
}

TEST(SolidMesh, a_ball_that_was_put_inside_comes_out)
{
    Sim sim;
    MeshOf m;
    make_cube(m);
    m.build();
    const dGeomID cube = dCreateTriMesh(sim.space, m.data, nullptr, nullptr, nullptr);
    dGeomTriMeshSetSolid(cube, 1);
    const dBodyID ball = sim.sphere({0.1, 0.2, 0.5}, 0.2, 1);
    sim.gravity(0, 0, -9.81);
    sim.steps(400, 0.01);
    EXPECT_NEAR(position(ball).z, 1.2, 1e-2);
}

TEST(SolidMesh, what_is_not_closed_is_refused)
{
    Sim sim;
    MeshOf open, inward, closed;
    make_cube(open);
    open.indices.resize(33);
    open.build();
    make_cube(inward);
    for (std::size_t i = 0; i < inward.indices.size(); i += 3)
        std::swap(inward.indices[i], inward.indices[i + 1]);
    inward.build();
    MeshOf one_turned;
    make_cube(one_turned);
    std::swap(one_turned.indices[0], one_turned.indices[1]);
    one_turned.build();
    make_cube(closed);
    closed.build();
    const Messages messages;
    int refusals = 0;
    for (MeshOf* m : {&open, &inward, &one_turned}) {
        const dGeomID g = dCreateTriMesh(sim.space, m->data, nullptr, nullptr, nullptr);
        dGeomTriMeshSetSolid(g, 1);
        EXPECT_EQ(messages.count(), ++refusals);
        EXPECT_NE(messages.last().find("not closed"), std::string::npos);
        EXPECT_EQ(dGeomTriMeshGetSolid(g), 0);
    }
    const dGeomID g = dCreateTriMesh(sim.space, closed.data, nullptr, nullptr, nullptr);
    dGeomTriMeshSetSolid(g, 2);
    dGeomTriMeshSetSolid(dCreateSphere(sim.space, 1), 1);
    dGeomTriMeshSetSolid(dCreateTriMesh(sim.space, nullptr, nullptr, nullptr, nullptr), 1);
    EXPECT_EQ(messages.count(), refusals + 3);
    dGeomTriMeshSetSolid(g, 1);
    EXPECT_EQ(dGeomTriMeshGetSolid(g), 1);
    // Other data, that are open, and the first again.
    dGeomTriMeshSetData(g, open.data);
    EXPECT_EQ(dGeomTriMeshGetSolid(g), 0);
    dGeomTriMeshSetData(g, closed.data);
    EXPECT_EQ(dGeomTriMeshGetSolid(g), 1);
    EXPECT_EQ(messages.count(), refusals + 3);
}

// ---- contacts that become one ----

std::vector<std::array<int, 2>> merged_pairs;
int number_merged(dGeomID, int one, int other)
{
    merged_pairs.push_back({one, other});
    return 1000 + one + other;
}

TEST(MergedContacts, are_numbered_by_the_program)
{
    // A ball over the edge between two triangles of a floor that is bent there: the crest is either's.
    Sim sim;
    MeshOf m;
    for (const V3 v : {V3{-1, -1, -1}, V3{-1, 1, -1}, V3{0, -1, 0}, V3{0, 1, 0}, V3{1, -1, -1}, V3{1, 1, -1}})
        m.vertex(v);
    for (const int i : {0, 2, 3, 0, 3, 1, 2, 4, 5, 2, 5, 3}) m.indices.push_back(dTriIndex(i));
    m.build();
    const dGeomID roof = dCreateTriMesh(sim.space, m.data, nullptr, nullptr, nullptr);
    const dGeomID ball = dCreateSphere(sim.space, real(0.25));
    dGeomSetPosition(ball, 0, 0, real(0.2));
    dContactGeom c[8];
    ASSERT_EQ(dCollide(ball, roof, 8, c, sizeof c[0]), 1);
    EXPECT_GE(c[0].side2, 0);
    EXPECT_LT(c[0].side2, 4);
    merged_pairs.clear();
    dGeomTriMeshSetTriMergeCallback(roof, number_merged);
    ASSERT_EQ(dCollide(ball, roof, 8, c, sizeof c[0]), 1);
    ASSERT_FALSE(merged_pairs.empty());
    EXPECT_GE(c[0].side2, 1000);
    for (const auto& pair : merged_pairs) EXPECT_NE(pair[0], pair[1]);
    // From the other side the number is on the other side.
    ASSERT_EQ(dCollide(roof, ball, 8, c, sizeof c[0]), 1);
    EXPECT_GE(c[0].side1, 1000);
}

}  // namespace
}  // namespace epode::physics
