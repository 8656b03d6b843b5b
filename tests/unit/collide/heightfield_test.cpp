// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Solids on height fields: a flat field is a plane, a slope is a tilted plane, seams are not felt, crests are
// met head-on, valleys from both sides, spheres agree with brute force over all triangles, and whatever has
// sunk in is pushed out again.
#include "base/check.h"
#include "base/memory.h"
#include "terrain.h"

namespace epode::test {
namespace {

constexpr Real kTight = kSingle ? Real(1e-4) : Real(1e-9);

Real flat(int, int) { return 0; }

struct Solids {
    std::vector<dGeomID> all;
    explicit Solids(Real size) : all(solids(size)) {}
    ~Solids()
    {
        for (dGeomID g : all) dGeomDestroy(g);
    }
};

// The same contacts in any order.
void expect_same(std::vector<Found> a, std::vector<Found> b)
{
    ASSERT_EQ(a.size(), b.size());
    for (const Found& x : a) {
        Real least = kInf;
        for (const Found& y : b) {
            const Real off =
                length(x.pos - y.pos) + length(x.normal - y.normal) + std::fabs(x.depth - y.depth);
            least = off < least ? off : least;
        }
        EXPECT_LT(least, 10 * kTight);
    }
}

TEST(Heightfield, flat_and_sloping_fields_are_planes_in_any_pose)
{
    const Real sx = Real(0.3), sz = Real(-0.2);
    RandomNumbers dice(1);
    for (const bool tilted : {false, true}) {
        const Ground ground(21, 17, 20, 16,
                            [&](int i, int j) { return tilted ? sx * Real(i) + sz * Real(j) : 0; });
        const Vec3 up = normalized_or(tilted ? Vec3{-sx, 1, -sz} : Vec3{0, 1, 0}, {});
        const Vec3 on = ground.at(0, 0);
        Solids solids(Real(0.8));
        const dGeomID plane = dCreatePlane(nullptr, 0, 1, 0, 0);
        for (int trial = 0; trial < 200; ++trial) {
            const Pose field{trial % 2 ? 5 * dice.vec() : Vec3{},
                             trial % 2 ? to_matrix(dice.rotation()) : Mat3::identity()};
            place(ground.geom, field.p, field.R);
            const Vec3 n = field.R * up;
            dGeomPlaneSetParams(plane, n.x, n.y, n.z, dot(n, field.to_world(on)));
            const Vec3 xz{dice.in(-5, 5), 0, dice.in(-5, 5)};
            const Vec3 above = xz + Vec3{0, ground.surface(xz.x, xz.z), 0} + dice.in(Real(-0.3), 1) * up;
            const dGeomID g = solids.all[std::size_t(trial / 2 % 4)];
            place(g, field.to_world(above), to_matrix(dice.rotation()));
            expect_same(contacts(g, ground.geom), contacts(g, plane));
        }
        dGeomDestroy(plane);
    }
}

// A far pit within the solid's box keeps the field from being taken for a plane.
TEST(Heightfield, seams_of_a_flat_field_are_not_felt)
{
    const Ground ground(13, 13, 12, 12, [](int i, int j) { return i == 12 && j == 12 ? -1 : 0; });
    const dGeomID ball = dCreateSphere(nullptr, 3);
    for (int k = 0; k <= 40; ++k) {
        const Vec3 c{3 + Real(k) / 40, Real(2.9), Real(3.5) - Real(k) / 80};
        place(ball, c);
        const std::vector<Found> f = contacts(ball, ground.geom);
        ASSERT_EQ(f.size(), 1u) << k;
        EXPECT_LT(length(f[0].normal - Vec3{0, 1, 0}), 1e-6);
        EXPECT_NEAR(f[0].depth, 0.1, kTight);
    }
    dGeomDestroy(ball);
    RandomNumbers dice(2);
    Solids solids(3);
    for (int trial = 0; trial < 100; ++trial)
        for (const dGeomID g : solids.all) {
            place(g, {dice.in(2, 3), 0, dice.in(2, 3)}, to_matrix(dice.rotation()));
            const Real low = farthest(g, {0, -1, 0}).y;
            const Vec3 p = load(dGeomGetPosition(g));
            place(g, p - Vec3{0, low + Real(0.05), 0}, load_mat(dGeomGetRotation(g)));
            const std::vector<Found> f = contacts(g, ground.geom);
            ASSERT_FALSE(f.empty());
            EXPECT_NEAR(deepest(f), 0.05, 1e-5) << dGeomGetClass(g);
            for (const Found& c : f)
                if (length(c.pos - ground.at(12, 12)) > Real(1.5)) {
                    EXPECT_LT(length(c.normal - Vec3{0, 1, 0}), 1e-5) << dGeomGetClass(g);
                }
        }
}

TEST(Heightfield, a_ridge_carries_what_lies_across_it)
{
    const Ground ground(5, 5, 8, 8, [](int i, int) { return i == 2 ? 1 : 0; });
    Solids solids(Real(0.5));
    const Vec3 up{0, 1, 0};
    for (const Real x : {Real(-0.1), Real(0), Real(0.15)})
        for (const dGeomID g : solids.all) {
            if (dGeomGetClass(g) == dSphereClass && x != 0) continue;
            const bool round = dGeomGetClass(g) == dCapsuleClass;
            // Box flat, cylinder upright, capsule along x.
            const Mat3 R = round ? from_columns({0, 1, 0}, {0, 0, 1}, {1, 0, 0})
                           : dGeomGetClass(g) == dCylinderClass
                               ? from_columns({0, 0, 1}, {1, 0, 0}, {0, 1, 0})
                               : Mat3::identity();
            place(g, {x, 0, Real(0.3)}, R);
            const Real low = farthest(g, -up).y;
            place(g, {x, 1 - low - Real(0.01), Real(0.3)}, R);
            const std::vector<Found> f = contacts(g, ground.geom);
            ASSERT_FALSE(f.empty()) << dGeomGetClass(g);
            EXPECT_NEAR(deepest(f), 0.01, 1e-6) << dGeomGetClass(g);
            for (const Found& c : f) {
                EXPECT_LT(length(c.normal - up), 1e-5) << dGeomGetClass(g) << " x " << x;
                EXPECT_NEAR(c.pos.x, 0, 1e-5);
            }
        }
}

TEST(Heightfield, a_peak_carries_a_box_and_a_ball)
{
    const Ground ground(5, 5, 8, 8, [](int i, int j) { return i == 2 && j == 2 ? 1 : 0; });
    Solids solids(1);
    for (const dGeomID g : {solids.all[0], solids.all[1]}) {
        place(g, {0, 0, 0});
        place(g, {0, 1 - farthest(g, {0, -1, 0}).y - Real(0.02), 0});
        const std::vector<Found> f = contacts(g, ground.geom);
        ASSERT_FALSE(f.empty());
        EXPECT_NEAR(deepest(f), 0.02, kTight);
        EXPECT_LT(length(f[0].normal - Vec3{0, 1, 0}), 1e-6);
    }
}

TEST(Heightfield, a_valley_holds_a_ball_from_both_sides)
{
    const Ground ground(5, 5, 8, 8, [](int i, int) { return std::fabs(Real(i) - 2) * 2; });
    const dGeomID ball = dCreateSphere(nullptr, 1);
    place(ball, {0, std::sqrt(Real(2)) - Real(0.01), Real(0.3)});
    for (const int capacity : {2, 4, 64}) {
        const std::vector<Found> f = contacts(ball, ground.geom, capacity);
        ASSERT_EQ(f.size(), 2u);
        EXPECT_NEAR(f[0].normal.x + f[1].normal.x, 0, kTight);
        for (const Found& c : f) {
            EXPECT_NEAR(std::fabs(c.normal.x), std::sqrt(0.5), kTight);
            EXPECT_NEAR(c.depth, 0.01 * std::sqrt(0.5), kTight);
        }
    }
    dGeomDestroy(ball);
}

Real distance_to(const Tri& t, Vec3 p)
{
    // Over the inside: the plane; else the nearest of three edges.
    const Vec3 n = t.normal();
    const Vec3 v[3] = {t.a, t.b, t.c};
    Real signs[3], least = kInf;
    for (int k = 0; k < 3; ++k) {
        const Vec3 a = v[k], e = v[(k + 1) % 3] - a;
        signs[k] = dot(cross(e, p - a), n);
        Real s = dot(p - a, e) / length2(e);
        s = s < 0 ? 0 : s > 1 ? 1 : s;
        const Real d = length(p - a - s * e);
        least = d < least ? d : least;
    }
    const bool over = (signs[0] >= 0 && signs[1] >= 0 && signs[2] >= 0) ||
                      (signs[0] <= 0 && signs[1] <= 0 && signs[2] <= 0);
    return over ? std::fabs(dot(n, p - t.a)) : least;
}

TEST(Heightfield, spheres_agree_with_all_triangles)
{
    RandomNumbers dice(5);
    const Ground ground(12, 9, 11, 8, [&](int, int) { return dice.in(0, Real(1.5)); });
    const std::vector<Tri> all = ground.triangles();
    const dGeomID ball = dCreateSphere(nullptr, 1);
    int touching = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const Real r = dice.in(Real(0.1), Real(1.2));
        const Real x = dice.in(-4, 4), z = dice.in(Real(-2.5), Real(2.5));
        const Vec3 c{x, ground.surface(x, z) + dice.in(0, 2), z};
        dGeomSphereSetRadius(ball, r);
        place(ball, c);
        Real least = kInf;
        for (const Tri& t : all) least = std::fmin(least, distance_to(t, c));
        const std::vector<Found> f = contacts(ball, ground.geom);
        if (std::fabs(least - r) < 1e-6) continue;
        ASSERT_EQ(!f.empty(), least < r) << trial;
        if (f.empty()) continue;
        ++touching;
        EXPECT_NEAR(deepest(f), r - least, 1e-6) << trial;
        for (const Found& k : f) EXPECT_GT(k.normal.y, 0);
    }
    EXPECT_GT(touching, 1000);
}

TEST(Heightfield, what_has_sunk_in_is_found_and_pushed_out)
{
    RandomNumbers dice(7);
    const Ground ground(16, 16, 15, 15, [&](int, int) { return dice.in(0, Real(0.8)); });
    Solids solids(Real(0.6));
    for (int trial = 0; trial < 400; ++trial)
        for (const dGeomID g : solids.all) {
            const Real x = dice.in(-4, 4), z = dice.in(-4, 4);
            place(g, {x, ground.surface(x, z) + dice.in(Real(-0.4), 1), z}, to_matrix(dice.rotation()));
            if (sunk(ground, g) > Real(1e-3)) {
                ASSERT_FALSE(contacts(g, ground.geom).empty()) << dGeomGetClass(g);
            }
            Real left = 0;
            for (int k = 0; k < 200; ++k) {
                const std::vector<Found> f = contacts(g, ground.geom);
                left = deepest(f);
                if (left < Real(1e-4)) break;
                const Found* deepest_one = &f[0];
                for (const Found& c : f) deepest_one = c.depth > deepest_one->depth ? &c : deepest_one;
                const Vec3 p =
                    load(dGeomGetPosition(g)) + (deepest_one->depth + Real(1e-5)) * deepest_one->normal;
                place(g, p, load_mat(dGeomGetRotation(g)));
            }
            EXPECT_LT(left, Real(1e-4)) << dGeomGetClass(g) << ' ' << trial;
            EXPECT_LT(sunk(ground, g), Real(2e-3)) << dGeomGetClass(g) << ' ' << trial;
        }
}

TEST(Heightfield, buried_solids_get_one_contact_straight_up)
{
    const Ground ground(5, 5, 4, 4, [](int i, int j) { return i == 2 && j == 2 ? 1 : 0; });
    const dGeomID ball = dCreateSphere(nullptr, Real(0.3));
    place(ball, {0, -5, 0});
    const std::vector<Found> f = contacts(ball, ground.geom);
    ASSERT_EQ(f.size(), 1u);
    EXPECT_NEAR(f[0].depth, 4.7, kTight);
    EXPECT_LT(length(f[0].normal - Vec3{0, 1, 0}), kTight);
    EXPECT_LT(length(f[0].pos), kTight);
    dGeomDestroy(ball);
}

TEST(Heightfield, agrees_with_measured_numbers_of_the_original)
{
    const Ground ground(3, 3, 4, 4, [](int i, int j) { return i == 1 && j == 1 ? 1 : 0; });
    const dGeomID ball = dCreateSphere(nullptr, Real(0.3));
    place(ball, {Real(-0.8), Real(0.75), Real(-0.3)});
    const std::vector<Found> f = contacts(ball, ground.geom);
    ASSERT_EQ(f.size(), 1u);
    EXPECT_LT(length(f[0].pos - Vec3{Real(-0.677526), Real(0.505051), Real(-0.177526)}), 2e-6);
    EXPECT_LT(length(f[0].normal - Vec3{Real(-0.408248), Real(0.816497), Real(-0.408248)}), 2e-6);
    EXPECT_NEAR(f[0].depth, 0.055051, 1e-6);
    dGeomDestroy(ball);
}

TEST(Heightfield, serves_both_orders_and_small_rooms_without_allocating)
{
    RandomNumbers dice(8);
    const Ground ground(30, 30, 10, 10, [&](int, int) { return dice.in(0, Real(0.2)); });
    Solids solids(2);
    for (const dGeomID g : solids.all) {
        place(g, {0, Real(0.7), 0}, to_matrix(dice.rotation()));
        const std::vector<Found> ahead = contacts(g, ground.geom), back = contacts(ground.geom, g);
        ASSERT_EQ(ahead.size(), back.size());
        ASSERT_FALSE(ahead.empty());
        for (std::size_t k = 0; k < ahead.size(); ++k) {
            EXPECT_TRUE(ahead[k].pos == back[k].pos && ahead[k].depth == back[k].depth);
            EXPECT_EQ(ahead[k].normal, -back[k].normal);
        }
        for (int capacity = 1; capacity < 6; ++capacity)
            EXPECT_NEAR(deepest(contacts(g, ground.geom, capacity)), deepest(ahead), 1e-12);
        dContactGeom few[8];
        const std::size_t before = allocation_count();
        dCollide(g, ground.geom, 8, few, sizeof(dContactGeom));
        EXPECT_EQ(allocation_count(), before);
    }
}

TEST(Heightfield, odd_sizes_and_places_do_no_harm)
{
    RandomNumbers dice(10);
    for (const bool wrap : {false, true}) {
        const Ground ground(
            11, 11, 10, 10, [&](int, int) { return dice.in(0, Real(0.4)); }, wrap);
        for (const double size : {0.0, 1e-30, 1e-9, 1.0, 1e4, 1e12}) {
            Solids odd{Real(size)};
            for (const double x : {0.0, 1e-12, 5.0, 1e3, 1e9, 1e15})
                for (const dGeomID g : odd.all) {
                    const bool slow = wrap && size > 10 && (x > 0 || dGeomGetClass(g) == dCylinderClass);
                    if (slow) continue;  // tens of thousands of cells each
                    place(g, {Real(x), Real(0.2), Real(-x / 2)}, to_matrix(dice.rotation()));
                    for (const Found& f : contacts(g, ground.geom)) {
                        EXPECT_TRUE(usable(f.depth) && usable(f.pos.x) && usable(f.pos.y) && usable(f.pos.z));
                        EXPECT_GT(f.normal.y, 0);
                    }
                }
        }
    }
}

void contact_joints(void* data, dGeomID a, dGeomID b)
{
    const auto* where = static_cast<std::pair<dWorldID, dJointGroupID>*>(data);
    dContact c[8] = {};
    const int n = dCollide(a, b, 8, &c[0].geom, sizeof(dContact));
    for (int k = 0; k < n; ++k) {
        c[k].surface.mode = dContactApprox1;
        c[k].surface.mu = 1;
        dJointAttach(dJointCreateContact(where->first, where->second, &c[k]), dGeomGetBody(a),
                     dGeomGetBody(b));
    }
}

void drop_boxes(unsigned seed)
{
    RandomNumbers dice(seed);
    const Ground ground(41, 41, 40, 40, [&](int, int) { return dice.in(0, Real(0.4)); });
    std::pair<dWorldID, dJointGroupID> where(dWorldCreate(), dJointGroupCreate(0));
    dWorldSetGravity(where.first, 0, Real(-9.81), 0);
    dWorldSetContactSurfaceLayer(where.first, Real(1e-3));
    const dSpaceID space = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XZY);
    std::vector<dGeomID> boxes;
    for (int k = 0; k < 9; ++k) {
        const dGeomID box = dCreateBox(space, Real(0.8), Real(0.4), Real(0.6));
        const dBodyID body = dBodyCreate(where.first);
        dMass mass;
        dMassSetBoxTotal(&mass, 1, Real(0.8), Real(0.4), Real(0.6));
        dBodySetMass(body, &mass);
        dGeomSetBody(box, body);
        place(box, {Real(k % 3) * 4 - 4, 2, Real(k / 3) * 4 - 4}, to_matrix(dice.rotation()));
        boxes.push_back(box);
    }
    Real sunk_largest = -kInf;
    dSpaceAdd(space, ground.geom);
    for (int step = 0; step < 800; ++step) {
        dSpaceCollide(space, &where, contact_joints);
        dWorldStep(where.first, Real(0.01));
        dJointGroupEmpty(where.second);
        if (step % 50 == 0)
            for (const dGeomID box : boxes) sunk_largest = std::fmax(sunk_largest, sunk(ground, box));
    }
    EXPECT_LT(sunk_largest, Real(0.1)) << "the impact, 2 m down at 0.01 s, and no deeper";
    for (const dGeomID box : boxes) {
        EXPECT_LT(length(load(dBodyGetLinearVel(dGeomGetBody(box)))), 1e-3) << "seed " << seed;
        EXPECT_LT(sunk(ground, box), Real(0.01));
    }
    dSpaceRemove(space, ground.geom);
    dSpaceDestroy(space);
    dJointGroupDestroy(where.second);
    dWorldDestroy(where.first);
}

TEST(Heightfield, dropped_boxes_come_to_rest_on_rough_ground)
{
    for (unsigned seed = 1; seed <= 3; ++seed) drop_boxes(seed);
}

TEST(Heightfield, wrapped_fields_repeat_without_a_seam)
{
    RandomNumbers dice(9);
    double sample[6][6];
    for (auto& row : sample)
        for (double& s : row) s = dice.in(0, 1);
    for (int k = 0; k < 6; ++k) sample[5][k] = sample[0][k];
    for (int k = 0; k < 6; ++k) sample[k][5] = sample[k][0];
    const Ground ground(
        6, 6, 5, 5, [&](int i, int j) { return sample[j][i]; }, true);
    Solids solids(Real(0.5));
    int met = 0, differ = 0;
    for (int trial = 0; trial < 200; ++trial)
        for (const dGeomID g : solids.all) {
            const Vec3 p{dice.in(-3, 3), dice.in(Real(0.3), Real(1.3)), dice.in(-3, 3)};
            const Mat3 R = to_matrix(dice.rotation());
            place(g, p, R);
            const std::vector<Found> here = contacts(g, ground.geom);
            const Vec3 away{Real(-15), 0, Real(10)};
            place(g, p + away, R);
            const std::vector<Found> there = contacts(g, ground.geom);
            ASSERT_EQ(here.empty(), there.empty());
            differ += std::fabs(deepest(here) - deepest(there)) > kTight ? 1 : 0;
            met += here.empty() ? 0 : 1;
        }
    EXPECT_GT(met, 300);
    EXPECT_LE(differ, kSingle ? 8 : 2)
        << "deep on a peak, which of two directions is least may hang on rounding";
}

TEST(Heightfield, off_the_rectangle_there_is_nothing)
{
    const Ground ground(5, 5, 4, 4, flat);
    const dGeomID ball = dCreateSphere(nullptr, Real(0.3));
    place(ball, {Real(2.31), 0, 0});
    EXPECT_TRUE(contacts(ball, ground.geom).empty());
    place(ball, {Real(2.1), Real(0.25), 0});
    EXPECT_EQ(contacts(ball, ground.geom).size(), 1u) << "on the rim";
    place(ball, {0, Real(0.31), 0});
    EXPECT_TRUE(contacts(ball, ground.geom).empty());
    dGeomDestroy(ball);
}

}  // namespace
}  // namespace epode::test
