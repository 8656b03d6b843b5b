// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Meshes that are hard to bear, through the public functions: triangles without area, copies of vertices and
// triangles, solids without size and as large as the world, surfaces that coincide, one triangle and very
// many. Whatever is reported must be usable. EPODE_LARGE_MESHES: also a million triangles (the nightly run).
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "../math/random_numbers.h"

namespace epode::test {
namespace {

struct Soup {
    std::vector<dReal> vertices;
    std::vector<dTriIndex> corners;

    dTriIndex vertex(Real x, Real y, Real z)
    {
        for (const Real c : {x, y, z, Real(0)}) vertices.push_back(c);
        return dTriIndex(vertices.size() / 4 - 1);
    }
    void triangle(dTriIndex a, dTriIndex b, dTriIndex c)
    {
        for (const dTriIndex i : {a, b, c}) corners.push_back(i);
    }
    int triangles() const { return int(corners.size() / 3); }
};

// n x n cells of `cell` about the origin, z up to `rough`.
Soup floor(int n, Real cell, Real rough, RandomNumbers& dice)
{
    Soup s;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            s.vertex(cell * (Real(i) - Real(n) / 2), cell * (Real(j) - Real(n) / 2), rough * dice.in(0, 1));
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const dTriIndex a = dTriIndex(i + j * (n + 1)), b = a + 1, c = a + dTriIndex(n) + 1, d = c + 1;
            s.triangle(a, b, d), s.triangle(a, d, c);
        }
    return s;
}

// Points, needles, corners named twice, copies of triangles in both windings and of vertices.
void spoil(Soup& s, Real cell, RandomNumbers& dice)
{
    const int count = s.triangles();
    for (int t = 0; t < count; t += 3) {
        const dTriIndex* at = s.corners.data() + 3 * t;
        const dTriIndex a = at[0], b = at[1], c = at[2];
        s.triangle(a, a, a), s.triangle(a, a, b), s.triangle(a, b, c), s.triangle(c, b, a);
        const auto x = [&](dTriIndex i, int k) { return s.vertices[4 * i + dTriIndex(k)]; };
        const dTriIndex copy = s.vertex(x(b, 0), x(b, 1), x(b, 2));
        const Real half[3] = {(x(a, 0) + x(b, 0)) / 2, (x(a, 1) + x(b, 1)) / 2, (x(a, 2) + x(b, 2)) / 2};
        const dTriIndex middle = s.vertex(half[0], half[1], half[2]);
        s.triangle(a, copy, c), s.triangle(a, middle, b);
        const dTriIndex near_it = s.vertex(half[0], half[1], half[2] + cell * 8 * kEpsilon * dice.in(0, 1));
        s.triangle(a, near_it, copy);
    }
}

class MeshOf {
  public:
    explicit MeshOf(const Soup& s) : data_(dGeomTriMeshDataCreate()), count(s.triangles())
    {
        dGeomTriMeshDataBuildSimple(data_, s.vertices.data(), int(s.vertices.size() / 4), s.corners.data(),
                                    int(s.corners.size()));
        geom = dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
    }
    MeshOf(const MeshOf&) = delete;
    MeshOf& operator=(const MeshOf&) = delete;
    ~MeshOf()
    {
        dGeomDestroy(geom);
        dGeomTriMeshDataDestroy(data_);
    }

  private:
    dTriMeshDataID data_;

  public:
    dGeomID geom;
    int count;
};

constexpr int kKinds = 5;
dGeomID make(int kind, Real size)
{
    switch (kind) {
        case 0:
            return dCreateSphere(nullptr, size);
        case 1:
            return dCreateBox(nullptr, size, 2 * size, size / 2);
        case 2:
            return dCreateCapsule(nullptr, size, size);
        case 3:
            return dCreateCylinder(nullptr, size, size);
        default:
            return dCreateRay(nullptr, size);
    }
}

// How many contacts there are; all of them must be usable.
int check(dGeomID solid, const MeshOf& mesh)
{
    constexpr int kCapacity = 16;
    dContactGeom found[kCapacity + 1];
    found[kCapacity].depth = -77;
    const int n = dCollide(solid, mesh.geom, kCapacity, found, sizeof(dContactGeom));
    EXPECT_LE(n, kCapacity);
    EXPECT_EQ(found[kCapacity].depth, -77);
    for (int i = 0; i < n; ++i) {
        const dContactGeom& c = found[i];
        for (int k = 0; k < 3; ++k) EXPECT_TRUE(std::isfinite(c.pos[k]) && std::isfinite(c.normal[k]));
        EXPECT_TRUE(std::isfinite(c.depth) && c.depth >= 0);
        EXPECT_NEAR(length(load(c.normal)), 1, kSingle ? 1e-4 : 1e-9);
        EXPECT_TRUE(c.side2 >= 0 && c.side2 < mesh.count) << c.side2;
    }
    return n;
}

struct HardMeshes : testing::Test {
    HardMeshes() { dInitODE(); }
    ~HardMeshes() override { dCloseODE(); }
};

TEST_F(HardMeshes, give_usable_contacts_whatever_their_triangles_and_sizes)
{
    RandomNumbers dice(21);
    int met = 0;
    for (const Real cell : {Real(1e-6), Real(1), Real(1e6)})
        for (const Real rough : {Real(0), Real(0.7)}) {
            Soup s = floor(6, cell, cell * rough, dice);
            spoil(s, cell, dice);
            const MeshOf mesh(s);
            for (const Real part : {Real(0), Real(1e-6), Real(1e-2), Real(1), Real(1e6)})
                for (int kind = 0; kind < kKinds; ++kind) {
                    SCOPED_TRACE(testing::Message() << cell << ' ' << rough << ' ' << part << ' ' << kind);
                    const dGeomID solid = make(kind, part * cell);
                    for (int trial = 0; trial < 12; ++trial) {
                        // On a vertex, on an edge, within a triangle; some upright, so that faces coincide.
                        const Real step = trial % 3 == 0 ? 1 : trial % 3 == 1 ? Real(0.5) : Real(0.3);
                        dQuaternion q = {1, 0, 0, 0};
                        const Quat any = dice.rotation();
                        if (trial % 4) q[0] = any.w, q[1] = any.x, q[2] = any.y, q[3] = any.z;
                        dGeomSetQuaternion(solid, q);
                        dGeomSetPosition(solid, step * cell, step * cell, trial < 6 ? 0 : part * cell / 2);
                        met += check(solid, mesh) > 0 ? 1 : 0;
                    }
                    dGeomDestroy(solid);
                }
        }
    EXPECT_GT(met, 300);
}

TEST_F(HardMeshes, meet_their_own_copies_in_the_same_place)
{
    RandomNumbers dice(22);
    for (const Real cell : {Real(1e-3), Real(1), Real(1e4)}) {
        Soup s = floor(4, cell, cell / 2, dice);
        spoil(s, cell, dice);
        const MeshOf a(s), b(s);
        (void)check(a.geom, b);
        dGeomSetPosition(a.geom, 0, 0, -cell / 100);
        (void)check(a.geom, b);
    }
}

TEST_F(HardMeshes, of_one_triangle_and_of_many)
{
    RandomNumbers dice(23);
    std::vector<int> sides = {1, 2, 7, 100};
    if (std::getenv("EPODE_LARGE_MESHES")) sides.push_back(708);  // 1,002,528 triangles
    for (const int n : sides) {
        const MeshOf mesh(floor(n, 1, Real(0.1), dice));
        for (int kind = 0; kind < kKinds; ++kind) {
            const dGeomID solid = make(kind, Real(0.5));
            const bool ray =
                kind == kKinds - 1;  // upwards, from under the ground; others have their middle over it
            for (int trial = 0; trial < 20; ++trial) {
                const Real half = Real(0.45) * Real(n);
                dGeomSetPosition(solid, dice.in(-half, half), dice.in(-half, half),
                                 ray ? Real(-0.05) : Real(0.11));
                EXPECT_GT(check(solid, mesh), 0) << n << ' ' << kind;
            }
            dGeomDestroy(solid);
        }
    }
}

}  // namespace
}  // namespace epode::test
