// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Holes in height fields: what is set is read back, nothing touches inside, rims and walls push as the
// nearest of all triangles of the slab says, what has fallen in is not lifted, what does not reach a hole
// does not know of it.
#include <cstring>

#include "../api/message_recorder.h"
#include "base/check.h"
#include "ode/ext.h"
#include "terrain.h"

namespace epode::test {
namespace {

constexpr Real kTight = kSingle ? Real(1e-4) : Real(1e-9);

// 12 x 12 cells of one metre, one metre thick; those for which missing(i, j) holds are holes.
template <typename Missing>
void dig(const Ground& ground, const Missing& missing)
{
    std::vector<unsigned char> holes;
    for (int j = 0; j + 1 < ground.nz; ++j)
        for (int i = 0; i + 1 < ground.nx; ++i) holes.push_back(missing(i, j) ? 200 : 0);
    dGeomHeightfieldDataSetHoles(ground.data, holes.data(), ground.nx - 1, ground.nz - 1);
    holes.assign(holes.size(), 77);  // it has been copied
}

Real flat(int, int) { return 0; }
bool middle(int i, int j) { return i >= 4 && i < 8 && j >= 4 && j < 8; }  // -2..2 both ways
bool slot(int i, int) { return i == 6; }                                  // 0..1 along x

struct Shapes {
    std::vector<dGeomID> all;
    dTriMeshDataID block = dGeomTriMeshDataCreate();
    explicit Shapes(Real s) : all(solids(s))
    {
        static const dTriIndex kSides[] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                           2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
        dReal corners[24];
        for (int k = 0; k < 8; ++k) {
            corners[3 * k] = k & 1 ? s : -s;
            corners[3 * k + 1] = k & 2 ? s : -s;
            corners[3 * k + 2] = k & 4 ? s : -s;
        }
        all.push_back(dCreateConvexHull(nullptr, corners, 8, 0));
        std::vector<double> points(corners, corners + 24);
        dGeomTriMeshDataBuildDouble(block, points.data(), 3 * sizeof(double), 8, kSides, 36,
                                    3 * sizeof(dTriIndex));
        all.push_back(dCreateTriMesh(nullptr, block, nullptr, nullptr, nullptr));
    }
    ~Shapes()
    {
        for (dGeomID g : all) dGeomDestroy(g);
        dGeomTriMeshDataDestroy(block);
    }
};

TEST(HeightfieldHoles, are_read_back_and_removed_when_the_field_is_built_again)
{
    const Ground ground(5, 4, 4, 3, flat);
    EXPECT_EQ(dGeomHeightfieldDataGetHole(ground.data, 1, 2), 0);
    dig(ground, [](int i, int j) { return i == 3 && j == 1; });
    dGeomHeightfieldDataSetHole(ground.data, 1, 2, 1);
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 4; ++i)
            EXPECT_EQ(dGeomHeightfieldDataGetHole(ground.data, i, j),
                      (i == 3 && j == 1) || (i == 1 && j == 2));
    dGeomHeightfieldDataSetHole(ground.data, 3, 1, 0);
    EXPECT_EQ(dGeomHeightfieldDataGetHole(ground.data, 3, 1), 0);
    dGeomHeightfieldDataBuildDouble(ground.data, ground.heights.data(), 0, 4, 3, 5, 4, 1, 0, 1, 0);
    EXPECT_EQ(dGeomHeightfieldDataGetHole(ground.data, 1, 2), 0);
    dGeomHeightfieldDataSetHole(ground.data, 0, 0, 1);
    dGeomHeightfieldDataSetHoles(ground.data, nullptr, 4, 3);
    EXPECT_EQ(dGeomHeightfieldDataGetHole(ground.data, 0, 0), 0);
}

TEST(HeightfieldHoles, refuses_cells_that_are_none)
{
    const Ground ground(5, 4, 4, 3, flat);
    dGeomHeightfieldDataSetHole(ground.data, 2, 2, 1);
    const unsigned char holes[12] = {};
    const dHeightfieldDataID empty = dGeomHeightfieldDataCreate();
    MessageRecorder messages;
    const auto refused = [&](const char* name) {
        EXPECT_EQ(messages.take(), std::string("2: Bad argument(s) in ") + name + "()");
        EXPECT_EQ(dGeomHeightfieldDataGetHole(ground.data, 2, 2), 1);
    };
    for (const auto& [columns, rows] :
         {std::pair(5, 3), std::pair(4, 4), std::pair(-4, -3), std::pair(3, 4)}) {
        dGeomHeightfieldDataSetHoles(ground.data, holes, columns, rows);
        refused("dGeomHeightfieldDataSetHoles");
    }
    for (const dHeightfieldDataID d : {empty, dHeightfieldDataID(nullptr)}) {
        dGeomHeightfieldDataSetHoles(d, holes, 4, 3);
        refused("dGeomHeightfieldDataSetHoles");
        dGeomHeightfieldDataSetHole(d, 0, 0, 1);
        refused("dGeomHeightfieldDataSetHole");
        EXPECT_EQ(dGeomHeightfieldDataGetHole(d, 0, 0), 0);
        refused("dGeomHeightfieldDataGetHole");
    }
    for (const auto& [i, j] : {std::pair(-1, 0), std::pair(0, -1), std::pair(4, 0), std::pair(0, 3)}) {
        dGeomHeightfieldDataSetHole(ground.data, i, j, 0);
        refused("dGeomHeightfieldDataSetHole");
        EXPECT_EQ(dGeomHeightfieldDataGetHole(ground.data, i, j), 0);
        refused("dGeomHeightfieldDataGetHole");
    }
    dGeomHeightfieldDataSetHole(ground.data, 2, 2, 2);
    refused("dGeomHeightfieldDataSetHole");
    dGeomHeightfieldDataDestroy(empty);
}

TEST(HeightfieldHoles, nothing_touches_inside)
{
    for (const bool wrap : {false, true}) {
        RandomNumbers dice(4);
        const Ground ground(
            13, 13, 12, 12, [&](int, int) { return dice.in(0, Real(0.4)); }, wrap);
        dig(ground, middle);
        Shapes shapes(Real(0.5));
        for (int trial = 0; trial < 300; ++trial)
            for (const dGeomID g : shapes.all) {
                const Real period = wrap && trial % 2 ? 12 : 0;
                place(g, {dice.in(-1, 1) + period, dice.in(-4, 1), dice.in(-1, 1) - period},
                      to_matrix(dice.rotation()));
                EXPECT_TRUE(contacts(g, ground.geom).empty()) << dGeomGetClass(g) << " trial " << trial;
                dQueryDistance apart;
                ASSERT_EQ(dGeomGetDistance(g, ground.geom, dInfinity, &apart), 1);
                EXPECT_GT(apart.distance, 0) << dGeomGetClass(g);
            }
    }
}

TEST(HeightfieldHoles, what_does_not_reach_a_hole_does_not_know_of_it)
{
    RandomNumbers dice(7);
    const Ground whole(13, 13, 12, 12, [&](int, int) { return dice.in(0, Real(0.4)); });
    const Ground holed(13, 13, 12, 12, [&](int i, int j) { return whole.at(i, j).y; });
    dig(holed, [](int i, int j) { return i >= 8 && j >= 3; });  // from x = 2 and z = -3 on
    Shapes shapes(Real(0.5));
    int touching = 0;
    for (int trial = 0; trial < 500; ++trial)
        for (const dGeomID g : shapes.all) {
            const Real x = dice.in(-4, Real(1.05)), z = dice.in(-4, 4);
            place(g, {x, whole.surface(x, z) + dice.in(Real(0.05), 1), z}, to_matrix(dice.rotation()));
            dReal box[6];
            dGeomGetAABB(g, box);
            if (box[1] >= 2) continue;
            const std::vector<Found> a = contacts(g, whole.geom), b = contacts(g, holed.geom);
            ASSERT_EQ(a.size(), b.size());
            touching += !a.empty();
            for (std::size_t k = 0; k < a.size(); ++k) {
                EXPECT_EQ(a[k].pos, b[k].pos);
                EXPECT_EQ(a[k].normal, b[k].normal);
                EXPECT_EQ(a[k].depth, b[k].depth);
            }
        }
    EXPECT_GT(touching, 500);
}

// The ground's triangles with the walls, and the nearest point of them.
struct Nearest {
    Real distance = kInf;
    Vec3 normal;
};
Vec3 nearest_on(const Tri& t, Vec3 p)
{
    const Vec3 v[3] = {t.a, t.b, t.c};
    const Vec3 n = normalized_or(cross(t.b - t.a, t.c - t.a), {0, 1, 0});
    Vec3 best;
    Real least = kInf;
    int sides = 0;
    for (int k = 0; k < 3; ++k) {
        const Vec3 e = v[(k + 1) % 3] - v[k];
        sides += dot(cross(e, p - v[k]), n) >= 0 ? 1 : -1;
        const Real s = std::fmin(1, std::fmax(0, dot(p - v[k], e) / length2(e)));
        if (length(p - v[k] - s * e) < least) least = length(p - v[k] - s * e), best = v[k] + s * e;
    }
    return sides == 3 || sides == -3 ? p - dot(n, p - t.a) * n : best;
}

// Of the ground with the middle missing: walls look inward.
std::vector<Tri> slab(const Ground& ground)
{
    std::vector<Tri> all;
    const std::vector<Tri> facets = ground.triangles();
    for (int j = 0; j < 12; ++j)
        for (int i = 0; i < 12; ++i)
            if (!middle(i, j))
                for (int k : {0, 1}) all.push_back(facets[std::size_t(2 * (i + 12 * j) + k)]);
    const auto wall = [&](Vec3 p, Vec3 q) {
        const Vec3 down{0, -1, 0};
        all.push_back({p, q, p + down}), all.push_back({q + down, q, p + down});
    };
    for (int k = 4; k < 8; ++k)
        for (int end : {4, 8}) {
            wall(ground.at(end, k), ground.at(end, k + 1));
            wall(ground.at(k, end), ground.at(k + 1, end));
        }
    return all;
}

TEST(HeightfieldHoles, spheres_over_and_in_a_hole_agree_with_all_triangles)
{
    RandomNumbers dice(11);
    const Ground ground(13, 13, 12, 12, [&](int, int) { return dice.in(0, Real(0.6)); });
    dig(ground, middle);
    const std::vector<Tri> all = slab(ground);
    const dGeomID ball = dCreateSphere(nullptr, 1);
    int touching = 0, level = 0;
    for (int trial = 0; trial < 6000; ++trial) {
        const Real r = dice.in(Real(0.1), Real(1.2));
        const Vec3 c{dice.in(-2, 2), dice.in(Real(-0.3), Real(1.5)), dice.in(-2, 2)};
        dGeomSphereSetRadius(ball, r);
        place(ball, c);
        Real least = kInf;
        Vec3 near;
        for (const Tri& t : all)
            if (const Vec3 p = nearest_on(t, c); length(p - c) < least) least = length(p - c), near = p;
        const std::vector<Found> f = contacts(ball, ground.geom);
        if (std::fabs(least - r) < 1e-6 || c.y < near.y - Real(0.999)) continue;
        ASSERT_EQ(!f.empty(), least < r) << trial << " r " << r << " at " << c.x << ' ' << c.y << ' ' << c.z;
        if (f.empty()) continue;
        ++touching;
        EXPECT_NEAR(deepest(f), r - least, 1e-6) << trial;
        for (const Found& k : f) {
            EXPECT_GE(k.normal.y, 0);
            level += k.normal.y < Real(1e-9);
        }
    }
    EXPECT_GT(touching, 2000);
    EXPECT_GT(level, 200);
    dGeomDestroy(ball);
}

TEST(HeightfieldHoles, rims_carry_what_lies_across)
{
    const Ground ground(13, 13, 12, 12, flat);
    dig(ground, slot);
    const Real size = Real(1.25);
    Shapes shapes(size);
    for (const dGeomID g : shapes.all) {
        const int kind = dGeomGetClass(g);
        const bool round = kind == dSphereClass;
        const Mat3 R = kind == dCapsuleClass || kind == dCylinderClass
                           ? from_columns({0, 1, 0}, {0, 0, 1}, {1, 0, 0})
                           : Mat3::identity();
        const Real height = round                                        ? std::sqrt(size * size - Real(0.25))
                            : kind == dCapsuleClass || kind == dBoxClass ? size / 2
                            : kind == dCylinderClass                     ? Real(0.7) * size
                                                                         : size;
        place(g, {Real(0.5), height - Real(0.01), Real(0.3)}, R);
        const std::vector<Found> f = contacts(g, ground.geom);
        ASSERT_GE(f.size(), 2u) << dGeomGetClass(g);
        Vec3 sum;
        for (const Found& c : f) {
            sum += c.normal;
            EXPECT_TRUE(c.pos.x < Real(0.02) || c.pos.x > Real(0.98)) << dGeomGetClass(g);
            if (round) {
                EXPECT_NEAR(c.normal.y, height / size, 0.01);
            } else {
                EXPECT_LT(length(c.normal - Vec3{0, 1, 0}), 1e-6) << dGeomGetClass(g);
            }
        }
        EXPECT_NEAR(sum.x, 0, 1e-6);
        EXPECT_NEAR(deepest(f), round ? 0.01 * height / size : 0.01, 1e-4) << dGeomGetClass(g);
    }
}

TEST(HeightfieldHoles, walls_push_level_and_nothing_lifts)
{
    const Ground ground(13, 13, 12, 12, flat);
    dig(ground, middle);
    Shapes shapes(Real(0.25));
    RandomNumbers dice(3);
    for (int trial = 0; trial < 200; ++trial)
        for (const dGeomID g : shapes.all) {
            // Against the wall at x = 2, a centimetre deep, wholly in the shaft.
            const Mat3 R = to_matrix(dice.rotation());
            place(g, {}, R);
            dReal box[6];
            dGeomGetAABB(g, box);
            place(g, {2 + Real(0.01) - box[1], Real(-0.5), dice.in(-1, 1)}, R);
            const std::vector<Found> f = contacts(g, ground.geom);
            ASSERT_FALSE(f.empty()) << dGeomGetClass(g);
            EXPECT_NEAR(deepest(f), 0.01, 1e-5) << dGeomGetClass(g);
            // A corner of a mesh goes out by its own faces now and then, when it sits on the edge between two
            // triangles of the wall.
            const Real aside = dGeomGetClass(g) == dTriMeshClass ? Real(0.7) : Real(1e-5);
            for (const Found& c : f)
                EXPECT_LT(length(c.normal - Vec3{-1, 0, 0}), aside) << dGeomGetClass(g) << " trial " << trial;
            // Under the ground around it, below the walls: nothing.
            place(g, {dice.in(2, 4), dice.in(-6, Real(-1.5)), dice.in(-1, 1)}, R);
            EXPECT_TRUE(contacts(g, ground.geom).empty()) << dGeomGetClass(g);
        }
}

TEST(HeightfieldHoles, rays_go_through_holes_and_meet_walls)
{
    RandomNumbers dice(21);
    const Ground ground(13, 13, 12, 12, [&](int, int) { return dice.in(0, Real(0.6)); });
    dig(ground, middle);
    const std::vector<Tri> all = slab(ground);
    const dGeomID ray = dCreateRay(nullptr, 30);
    int hits = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const Vec3 o{dice.in(-5, 5), dice.in(-3, 3), dice.in(-5, 5)}, d = dice.direction();
        dGeomRaySet(ray, o.x, o.y, o.z, d.x, d.y, d.z);
        std::vector<Real> expected;
        bool grazes = false;
        for (const Tri& t : all) {
            const Vec3 n = cross(t.b - t.a, t.c - t.a);
            if (dot(n, d) == 0) continue;
            const Real at = dot(n, t.a - o) / dot(n, d);
            if (at < 0) continue;
            const Vec3 p = o + at * d;
            const Vec3 v[3] = {t.a, t.b, t.c};
            Real least = kInf;
            for (int k = 0; k < 3; ++k)
                least = std::fmin(least, dot(cross(v[(k + 1) % 3] - v[k], p - v[k]), n) / length2(n));
            grazes = grazes || std::fabs(least) < 1e-6;
            if (least > 0) expected.push_back(at);
        }
        if (grazes) continue;
        std::sort(expected.begin(), expected.end());
        const std::vector<Found> f = contacts(ray, ground.geom);
        ASSERT_EQ(f.size(), expected.size()) << trial;
        for (std::size_t k = 0; k < f.size(); ++k) {
            EXPECT_NEAR(f[k].depth, expected[k], 1e-5) << trial;
            ++hits;
        }
    }
    EXPECT_GT(hits, 1500);
    dGeomDestroy(ray);
}

TEST(HeightfieldHoles, casts_and_distances_see_the_hole)
{
    const Ground ground(13, 13, 12, 12, flat);
    dig(ground, middle);
    const dGeomID ball = dCreateSphere(nullptr, Real(0.5));
    place(ball, {1, 3, 0});
    const dVector3 down{0, -10, 0, 0}, aside{10, 0, 0, 0};
    dQueryHit hit;
    EXPECT_EQ(dGeomCast(ball, down, ground.geom, &hit), 0);
    dQueryDistance apart;
    place(ball, {1, Real(-0.5), 0});
    ASSERT_EQ(dGeomGetDistance(ball, ground.geom, dInfinity, &apart), 1);
    EXPECT_NEAR(apart.distance, 0.5, kTight);
    EXPECT_NEAR(apart.normal[0], -1, kTight);
    ASSERT_EQ(dGeomCast(ball, aside, ground.geom, &hit), 1);
    EXPECT_NEAR(hit.distance, 0.5, 1e-3);
    EXPECT_NEAR(hit.normal[0], -1, 1e-3);
    place(ball, {1, -2, 0});  // below the walls: on, under the ground
    EXPECT_EQ(dGeomCast(ball, aside, ground.geom, &hit), 0);
    dGeomDestroy(ball);
}

}  // namespace
}  // namespace epode::test
