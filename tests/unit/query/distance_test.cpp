// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Signed distances: closed forms; for every pair of classes in random poses the promises that hold whatever
// the shapes are: the same bits in both orders, points that lie where they belong, a motion along the normal
// that parts or joins the two, a limit that only leaves out; least values over triangles and members;
// refusals.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "../api/message_recorder.h"
#include "../collide/space_scene.h"
#include "query_scene.h"

using namespace epode;
using namespace epode::test;

namespace {

constexpr Real kTight = kSingle ? Real(2e-4) : Real(1e-8);
// Where GJK walks round a rim.
constexpr Real kRound = kSingle ? Real(3e-3) : Real(2e-6);

class Library {
  public:
    Library() { dInitODE(); }
    ~Library() { dCloseODE(); }
};

dQueryDistance between(dGeomID a, dGeomID b)
{
    dQueryDistance d{};
    EXPECT_EQ(dGeomGetDistance(a, b, dInfinity, &d), 1);
    return d;
}

void at(dGeomID g, Real x, Real y, Real z) { dGeomSetPosition(g, x, y, z); }

// pos1 - pos2 = distance n, n of length one.
void expect_consistent(const dQueryDistance& d, Real slack)
{
    const Vec3 n = load(d.normal), gap = load(d.pos1) - load(d.pos2);
    EXPECT_NEAR(length(n), 1, slack);
    EXPECT_LT(length(gap - d.distance * n), slack * (1 + std::fabs(d.distance)));
}

}  // namespace

TEST(GeomDistance, has_the_values_of_closed_forms)
{
    const Library library;
    const dGeomID s1 = dCreateSphere(nullptr, 1), s2 = dCreateSphere(nullptr, Real(0.5));
    at(s2, 3, 4, 0);
    EXPECT_NEAR(between(s1, s2).distance, 3.5, kTight);
    at(s2, Real(0.3), 0, 0);
    EXPECT_NEAR(between(s1, s2).distance, -1.2, kTight);

    const dGeomID box = dCreateBox(nullptr, 2, 4, 6);
    at(s1, 3, 0, 0);
    EXPECT_NEAR(between(s1, box).distance, 1, kTight);
    at(s1, 4, 6, 3);  // an edge: 3, 4 from it
    dQueryDistance d = between(s1, box);
    EXPECT_NEAR(d.distance, 4, kTight);
    EXPECT_LT(length(load(d.pos2) - Vec3{1, 2, 3}), kTight);
    EXPECT_LT(length(load(d.normal) - Vec3{Real(0.6), Real(0.8), 0}), kTight);
    at(s1, Real(0.7), 0, 0);
    d = between(s1, box);
    EXPECT_NEAR(d.distance, -1.3, kTight);
    EXPECT_LT(length(load(d.pos1) - Vec3{Real(-0.3), 0, 0}), kTight);
    EXPECT_LT(length(load(d.pos2) - Vec3{1, 0, 0}), kTight);

    const dGeomID other = dCreateBox(nullptr, 1, 1, 1);
    at(other, Real(1.4), Real(0.2), 0);  // faces flush: the points must lie in both
    d = between(other, box);
    EXPECT_NEAR(d.distance, -0.1, kTight);
    EXPECT_NEAR(d.pos1[0], 0.9, kTight);
    EXPECT_NEAR(d.pos2[0], 1, kTight);
    EXPECT_LT(std::fabs(d.pos1[1] - Real(0.2)), Real(0.5) + kTight);
    EXPECT_LT(std::fabs(d.pos1[2]), Real(0.5) + kTight);

    const dGeomID can = dCreateCylinder(nullptr, 1, 2), capsule = dCreateCapsule(nullptr, Real(0.5), 2);
    at(can, 10, 0, 0), at(capsule, 13, 0, 0);
    EXPECT_NEAR(between(can, capsule).distance, 1.5, kTight);
    at(s1, 13, 4, 5);  // from the rim: 5 - 1 = 4 across, 4 up
    EXPECT_NEAR(between(s1, can).distance, std::sqrt(32.0) - 1, kRound);

    const dGeomID plane = dCreatePlane(nullptr, 0, 0, 1, -2);
    at(can, 0, 0, 0);
    EXPECT_NEAR(between(can, plane).distance, 1, kTight);
    EXPECT_NEAR(between(plane, can).normal[2], -1, kTight);
    const dGeomID ceiling = dCreatePlane(nullptr, 0, 0, -1, -1), wall = dCreatePlane(nullptr, 1, 0, 0, 0);
    EXPECT_NEAR(between(plane, ceiling).distance, 3, kTight);
    EXPECT_EQ(between(plane, wall).distance, -dInfinity);

    const dGeomID ray = dCreateRay(nullptr, dInfinity), short_ray = dCreateRay(nullptr, 2);
    dGeomRaySet(ray, -5, 3, 0, 1, 0, 0);
    at(s1, 50, 0, 0);
    EXPECT_NEAR(between(ray, s1).distance, 2, kRound);
    dGeomRaySet(short_ray, -5, 3, 0, 1, 0, 0);
    EXPECT_NEAR(between(short_ray, plane).distance, 2, kTight);
    EXPECT_NEAR(between(short_ray, s1).distance, std::hypot(53.0, 3.0) - 1, kTight * 100);
    dGeomRaySet(short_ray, 0, 0, 5, 0, 1, 0);
    EXPECT_NEAR(between(ray, short_ray).distance, std::hypot(5.0, 1.0), kTight);
    for (const dGeomID g : {s1, s2, box, other, can, capsule, plane, ceiling, wall, ray, short_ray})
        dGeomDestroy(g);
}

TEST(GeomDistance, of_every_pair_of_classes_keeps_its_promises)
{
    QueryScene scene(77, 0);
    RandomNumbers& dice = scene.dice();
    constexpr int kPoses = 24;
    for (int i = 0; i < QueryScene::kKinds + 1; ++i)
        for (int j = i; j < QueryScene::kKinds + 1; ++j)
            for (int k = 0; k < kPoses; ++k) {
                const auto made = [&](int kind) {
                    if (kind < QueryScene::kKinds) return scene.make(kind, nullptr);
                    return dCreateRay(nullptr, dice.in(0, 3));
                };
                const dGeomID a = made(i), b = made(j);
                const Real extent = k % 3 == 0 ? Real(0.5) : k % 3 == 1 ? 2 : 6;
                scene.place(a, extent), scene.place(b, extent);
                SCOPED_TRACE(testing::Message() << "classes " << dGeomGetClass(a) << " and "
                                                << dGeomGetClass(b) << ", pose " << k);
                dQueryDistance d{}, turned{};
                ASSERT_EQ(dGeomGetDistance(a, b, dInfinity, &d), 1);
                ASSERT_EQ(dGeomGetDistance(b, a, dInfinity, &turned), 1);
                EXPECT_EQ(d.distance, turned.distance);
                EXPECT_EQ(0, std::memcmp(d.pos1, turned.pos2, 3 * sizeof(dReal)));
                EXPECT_EQ(0, std::memcmp(d.pos2, turned.pos1, 3 * sizeof(dReal)));
                EXPECT_EQ(d.normal[0], -turned.normal[0]);
                EXPECT_EQ(d.side1, turned.side2);
                if (std::isfinite(d.distance)) {
                    expect_consistent(d, kSingle ? Real(1e-3) : Real(1e-6));
                    // A limit leaves the answer as it is or out.
                    dQueryDistance limited{};
                    EXPECT_EQ(dGeomGetDistance(a, b, d.distance + Real(1e-3), &limited), 1);
                    EXPECT_EQ(limited.distance, d.distance);
                    EXPECT_EQ(dGeomGetDistance(a, b, d.distance - Real(1e-3), &limited), 0);
                    // Moved along the normal by it, and a little less or more, they hardly touch or do not.
                    const bool moves = dGeomGetClass(a) != dPlaneClass;
                    const dGeomID mover = moves ? a : b;
                    const Vec3 p = load(dGeomGetPosition(mover));
                    const Vec3 way = moves ? load(d.normal) : -load(d.normal);
                    if (d.distance > 0) {
                        // Half the way nearer is half the distance, or less where other parts come nearer.
                        const Vec3 q = p - Real(0.5) * d.distance * way;
                        at(mover, q.x, q.y, q.z);
                        const Real half = between(a, b).distance;
                        EXPECT_LE(half, Real(0.5) * d.distance + kRound);
                        // No surface comes nearer than it has been moved.
                        const bool ground =
                            dGeomGetClass(a) == dHeightfieldClass || dGeomGetClass(b) == dHeightfieldClass;
                        EXPECT_TRUE(ground || half >= Real(0.5) * d.distance - kRound);
                    } else if (i < 5 && (j < 5 || j == 7)) {
                        const Vec3 q = p - (d.distance - Real(0.01)) * way;
                        at(mover, q.x, q.y, q.z);
                        EXPECT_NEAR(between(a, b).distance, 0.01, kRound);
                    }
                }
                dGeomDestroy(a), dGeomDestroy(b);
            }
}

TEST(GeomDistance, agrees_with_d_collide_where_solids_overlap)
{
    QueryScene scene(78, 0);
    int overlaps = 0, apart = 0;
    for (int i = 0; i < 5; ++i)
        for (int j = i; j < 5; ++j)
            for (int k = 0; k < 60; ++k) {
                const dGeomID a = scene.make(i, nullptr), b = scene.make(j, nullptr);
                scene.place(a, Real(0.5)), scene.place(b, Real(0.5));
                dContactGeom contacts[16];
                const int n = dCollide(a, b, 16, contacts, sizeof(dContactGeom));
                Real depth = -1;
                for (int c = 0; c < n; ++c) depth = std::max(depth, contacts[c].depth);
                const Real distance = between(a, b).distance;
                if (distance < -kRound) {
                    ++overlaps;
                    // Pair functions prefer faces to a somewhat shorter way over edges.
                    EXPECT_GE(depth, -distance - (kSingle ? Real(5e-3) : Real(1e-5)))
                        << dGeomGetClass(a) << " " << dGeomGetClass(b);
                    EXPECT_LE(depth, -distance * Real(1.06) + (kSingle ? Real(5e-3) : Real(1e-5)));
                } else if (distance > kRound) {
                    ++apart;
                    EXPECT_EQ(n, 0);
                }
                dGeomDestroy(a), dGeomDestroy(b);
            }
    EXPECT_GT(overlaps, 200);
    EXPECT_GT(apart, 50);
}

TEST(GeomDistance, of_a_mesh_is_the_least_over_its_triangles)
{
    const Library library;
    // Hills as a mesh, and each of their triangles as a mesh of its own.
    constexpr int kCells = 12;
    RandomNumbers dice(5);
    std::vector<dReal> vertices;
    for (int j = 0; j <= kCells; ++j)
        for (int i = 0; i <= kCells; ++i)
            vertices.insert(vertices.end(), {Real(i) / 2, Real(j) / 2, dice.in(0, Real(0.5)), 0});
    std::vector<dTriIndex> all;
    for (int j = 0; j < kCells; ++j)
        for (int i = 0; i < kCells; ++i) {
            const dTriIndex v = dTriIndex(i + j * (kCells + 1)), up = v + kCells + 1;
            all.insert(all.end(), {v, v + 1, up + 1, v, up + 1, up});
        }
    const auto mesh_of = [&](const dTriIndex* indices, int count, dTriMeshDataID data) {
        dGeomTriMeshDataBuildSimple(data, vertices.data(), int(vertices.size() / 4), indices, count);
        return dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
    };
    std::vector<dTriMeshDataID> data(all.size() / 3 + 1);
    for (dTriMeshDataID& d : data) d = dGeomTriMeshDataCreate();
    const dGeomID mesh = mesh_of(all.data(), int(all.size()), data.back());
    std::vector<dGeomID> pieces;
    for (std::size_t t = 0; t < all.size() / 3; ++t) pieces.push_back(mesh_of(&all[3 * t], 3, data[t]));
    const dGeomID solids[] = {dCreateSphere(nullptr, Real(0.3)), dCreateBox(nullptr, 1, Real(0.4), Real(0.2)),
                              dCreateCapsule(nullptr, Real(0.2), 1), dCreateCylinder(nullptr, Real(0.3), 1),
                              dCreateRay(nullptr, 2)};
    for (const dGeomID solid : solids)
        for (int k = 0; k < 25; ++k) {
            const Quat q = dice.rotation();
            const dQuaternion turned = {q.w, q.x, q.y, q.z};
            dGeomSetQuaternion(solid, turned);
            at(solid, dice.in(-2, 8), dice.in(-2, 8), dice.in(-1, k % 2 ? 6 : 1));
            Real least = dInfinity;
            int triangle = -1;
            for (std::size_t t = 0; t < pieces.size(); ++t) {
                const Real d = between(solid, pieces[t]).distance;
                if (d < least) least = d, triangle = int(t);
            }
            const dQueryDistance d = between(solid, mesh);
            // Of a ray so much is taken as reaches the mesh, or the triangle.
            EXPECT_NEAR(d.distance, least, solid == solids[4] ? kTight : 0);
            EXPECT_NEAR(between(solid, pieces[std::size_t(d.side2)]).distance, least, kTight);
            EXPECT_TRUE(d.side2 == triangle || solid == solids[4]);
            EXPECT_EQ(d.g2, mesh);
        }
    for (const dGeomID g : pieces) dGeomDestroy(g);
    for (const dGeomID g : solids) dGeomDestroy(g);
    dGeomDestroy(mesh);
    for (const dTriMeshDataID d : data) dGeomTriMeshDataDestroy(d);
}

TEST(GeomDistance, of_a_space_is_the_least_over_what_is_seen_in_it)
{
    QueryScene scene(21, 120);
    const dGeomID probe = dCreateBox(nullptr, Real(0.4), Real(0.6), Real(0.8));
    dGeomSetCategoryBits(probe, 4), dGeomSetCollideBits(probe, 1);
    for (int k = 0; k < 40; ++k) {
        scene.place(probe, 8);
        Real least = dInfinity;
        dGeomID nearest = nullptr;
        for (const dGeomID g : scene.leaves()) {
            dQueryDistance d;
            if (!QueryScene::seen(g, 4, 1) || !dGeomGetDistance(probe, g, dInfinity, &d)) continue;
            if (d.distance < least) least = d.distance, nearest = d.g2;
        }
        const dQueryDistance d = between(probe, geom_of(scene.space));
        EXPECT_EQ(d.distance, least);
        EXPECT_EQ(d.g2, nearest);
        EXPECT_EQ(between(geom_of(scene.space), probe).g1, nearest);
    }
    dGeomDestroy(probe);
}

TEST(SpaceOverlap, is_what_has_no_distance_newest_first)
{
    int found = 0;
    for (std::uint64_t key = 1; key <= 6; ++key) {
        QueryScene scene(key, 150, 4);
        for (int kind = 0; kind < QueryScene::kKinds; ++kind) {
            const dGeomID probe = scene.make(kind, nullptr);
            scene.place(probe, 3);
            std::vector<dGeomID> wanted;
            for (const dGeomID g : scene.leaves()) {
                dQueryDistance d;
                if (QueryScene::seen(g, ~0ul, ~0ul) && boxes_overlap(probe, g) &&
                    dGeomGetDistance(probe, g, 0, &d))
                    wanted.push_back(g);
            }
            dGeomID got[200];
            ASSERT_EQ(dSpaceOverlap(scene.space, probe, nullptr, got, 200), int(wanted.size())) << kind;
            for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_EQ(got[i], wanted[i]);
            EXPECT_EQ(dSpaceOverlap(scene.space, probe, nullptr, nullptr, 0), int(wanted.size()));
            found += int(wanted.size());
            dGeomDestroy(probe);
        }
        // A member does not overlap itself.
        for (const dGeomID g : scene.leaves()) {
            dGeomID got[200];
            const int n = dSpaceOverlap(scene.space, g, nullptr, got, 200);
            EXPECT_EQ(std::find(got, got + n, g), got + n);
        }
    }
    EXPECT_GT(found, 200);
}

TEST(GeomDistance, refuses_what_makes_no_sense)
{
    QueryScene scene(1, 10);
    const dGeomID g = dCreateSphere(nullptr, 1), h = dCreateSphere(nullptr, 1);
    MessageRecorder recorder;
    dQueryDistance d, untouched;
    std::memset(&d, 0x5a, sizeof d);
    untouched = d;
    dGeomID list[4];
    EXPECT_EQ(dGeomGetDistance(nullptr, g, 1, &d), 0);
    EXPECT_EQ(dGeomGetDistance(g, nullptr, 1, &d), 0);
    EXPECT_EQ(dGeomGetDistance(g, g, 1, &d), 0);
    EXPECT_EQ(dGeomGetDistance(g, h, dReal(NAN), &d), 0);
    EXPECT_EQ(dGeomGetDistance(g, h, 1, nullptr), 0);
    EXPECT_EQ(dSpaceOverlap(nullptr, g, nullptr, list, 4), 0);
    EXPECT_EQ(dSpaceOverlap(scene.space, nullptr, nullptr, list, 4), 0);
    EXPECT_EQ(dSpaceOverlap(scene.space, g, nullptr, list, -1), 0);
    EXPECT_EQ(dSpaceOverlap(scene.space, g, nullptr, nullptr, 4), 0);
    EXPECT_EQ(dSpaceOverlap(scene.space, geom_of(scene.space), nullptr, list, 4), 0);
    const std::string said = recorder.take();
    EXPECT_EQ(std::count(said.begin(), said.end(), '|'), 9) << said;
    EXPECT_EQ(std::memcmp(&d, &untouched, sizeof d), 0);
    EXPECT_EQ(dGeomGetDistance(g, h, -3, &d), 0);  // not that deep
    EXPECT_EQ(recorder.take(), "");
    EXPECT_EQ(std::memcmp(&d, &untouched, sizeof d), 0);
    dGeomDestroy(g), dGeomDestroy(h);
}
