// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What every class of convex solids (a line of geom_types.inc with a SolidType) has from its view alone, by
// the public functions: contacts with every class, distances, overlaps, rays, casts, continuous collision,
// world-managed contacts, triangles to draw. The reference is a sweep over directions with the
// support function; how good it is compared with other means is the business of tests/reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "../effort.h"
#include "../unit/api/message_recorder.h"
#include "../unit/math/random_numbers.h"
#include "collide/solid_type.h"
#include "ode/ode.h"
#include "solids.h"

namespace epode {
namespace {

constexpr Real kTight = kSingle ? Real(2e-3) : Real(2e-5);
constexpr int kPoses = tests::effort(40);

struct Class {
    std::string name;
    int number;
};
std::vector<Class> solid_classes()
{
    std::vector<Class> all;
#define GEOM_TYPE(Name, Number, Object, Refusal) \
    if (geom_type(Number)->solid) all.push_back({#Name, Number});
#include "collide/types/geom_types.inc"
#undef GEOM_TYPE
    return all;
}
void PrintTo(const Class& c, std::ostream* out) { *out << c.name; }

Vec3 support(dGeomID g, Vec3 n)
{
    const ConvexView v =
        solid_view(*from_handle<Geom>(g), load_pose(dGeomGetPosition(g), dGeomGetRotation(g)));
    return v.support(n) + v.radius * n;
}
// Moving a by this along n parts the two.
Real overlap_along(dGeomID a, dGeomID b, Vec3 n) { return dot(n, support(b, n) - support(a, -n)); }

Real least_overlap(dGeomID a, dGeomID b)
{
    static const std::vector<Vec3> directions = [] {
        RandomNumbers random{5};
        std::vector<Vec3> out;
        for (int i = 0; i < 600; ++i) out.push_back(random.direction());
        return out;
    }();
    Vec3 n;
    Real best = kInf;
    for (const Vec3 d : directions)
        if (const Real h = overlap_along(a, b, d); h < best) best = h, n = d;
    for (Real step = Real(0.1); step > Real(1e-7);) {
        Vec3 u, v;
        plane_space(n, u, v);
        bool better = false;
        for (int i = 0; i < 8; ++i) {
            const Real x = i % 4 == 0   ? 1
                           : i % 4 == 2 ? 0
                                        : Real(0.7),
                       y = i % 4 == 3 ? Real(-0.7)
                           : i % 4    ? 1
                                      : 0;
            Vec3 m = n + (i < 4 ? step : -step) * (x * u + y * v);
            normalize(m);
            if (const Real h = overlap_along(a, b, m); h < best) best = h, n = m, better = true;
        }
        if (!better) step /= 2;
    }
    return best;
}

// There is a direction along which they have a gap.
bool proven_apart(dGeomID a, dGeomID b)
{
    dQueryDistance d;
    dGeomGetDistance(a, b, dInfinity, &d);
    return d.distance > 0 && overlap_along(a, b, load(d.normal)) < 0;
}

class EverySolid : public testing::TestWithParam<Class> {
  protected:
    EverySolid() { geom = tests::make_solid(GetParam().number); }
    ~EverySolid() override
    {
        for (dGeomID g : made) dGeomDestroy(g);
        dGeomDestroy(geom);
    }
    void SetUp() override { ASSERT_NE(geom, nullptr) << "this class is new: solids.inc must make one"; }
    dGeomID keep(dGeomID g)
    {
        made.push_back(g);
        return g;
    }
    void turn(dGeomID g)
    {
        const Quat q = random.rotation();
        const Real numbers[4] = {q.w, q.x, q.y, q.z};
        dGeomSetQuaternion(g, numbers);
    }
    static void move(dGeomID g, Vec3 by)
    {
        const Vec3 p = load(dGeomGetPosition(g)) + by;
        dGeomSetPosition(g, p.x, p.y, p.z);
    }
    // A point inside: the mean of some of the surface.
    Vec3 middle()
    {
        Vec3 sum;
        for (int i = 0; i < 16; ++i) sum += support(geom, random.direction());
        return sum / Real(16);
    }
    // Its lowest point comes so far above z = 0.
    void hover(Real height) { move(geom, {0, 0, height - support(geom, {0, 0, -1}).z}); }
    int collide(dGeomID a, dGeomID b) { return count = dCollide(a, b, 8, contacts, sizeof(dContactGeom)); }
    Real deepest() const
    {
        Real depth = -1;
        for (int i = 0; i < count; ++i) depth = std::max(depth, contacts[i].depth);
        return depth;
    }

    dGeomID geom = nullptr;
    std::vector<dGeomID> made;
    RandomNumbers random{3};
    dContactGeom contacts[8];
    int count = 0;
};

INSTANTIATE_TEST_SUITE_P(all, EverySolid, testing::ValuesIn(solid_classes()),
                         [](const auto& instance) { return instance.param.name; });

TEST_P(EverySolid, meets_every_solid_as_deep_as_a_sweep_finds)
{
    for (const Class& other : solid_classes()) {
        SCOPED_TRACE(other.name);
        dGeomID b = keep(tests::make_solid(other.number));
        for (int i = 0; i < kPoses; ++i) {
            dGeomSetPosition(geom, 0, 0, 0), dGeomSetPosition(b, 0, 0, 0);
            turn(geom), turn(b);
            const Vec3 n = random.direction();
            const Real deep = i % 4 == 0 ? Real(-0.05) : Real(0.02) * Real(i % 4);
            move(geom, (overlap_along(geom, b, n) - deep) * n);
            const Real least = least_overlap(geom, b);
            collide(geom, b);
            if (least < -kTight) { ASSERT_EQ(count, 0) << "they are apart"; }
            if (least < kTight || (count == 0 && proven_apart(geom, b)))
                continue;  // the sweep may stop too early
            ASSERT_GE(count, 1) << "missed a depth of " << least;
            // Boxes prefer faces by a few per cent.
            ASSERT_LE(deepest(), Real(1.06) * least + kTight);
            ASSERT_LE(count, 8);
            for (int k = 0; k < count; ++k) ASSERT_NEAR(length(load(contacts[k].normal)), 1, kTight);
            ASSERT_NEAR(deepest(), overlap_along(geom, b, load(contacts[0].normal)),
                        Real(0.07) * least + kTight);
            const Real reversed = deepest();
            ASSERT_GE(collide(b, geom), 1);
            ASSERT_NEAR(deepest(), reversed, Real(0.07) * least + kTight);
        }
    }
}

TEST_P(EverySolid, rests_on_planes_meshes_and_height_fields_alike)
{
    static const dReal corners[] = {-9, -9, 0, 0, 9, -9, 0, 0, 9, 9, 0, 0, -9, 9, 0, 0};
    static const dTriIndex triangles[] = {0, 1, 2, 0, 2, 3};
    static const double heights[] = {0, 0, 0, 0, 0, 0, 0, 0, 0};
    dTriMeshDataID mesh = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSimple(mesh, corners, 4, triangles, 6);
    dHeightfieldDataID field = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildDouble(field, heights, 0, 18, 18, 3, 3, 1, 0, 1, 0);
    dGeomID grounds[] = {keep(dCreatePlane(nullptr, 0, 0, 1, 0)),
                         keep(dCreateTriMesh(nullptr, mesh, nullptr, nullptr, nullptr)),
                         keep(dCreateHeightfield(nullptr, field, 1)), keep(dCreateBox(nullptr, 18, 18, 2))};
    const Real upright[4] = {Real(M_SQRT1_2), Real(M_SQRT1_2), 0, 0};
    dGeomSetQuaternion(grounds[2], upright);  // y becomes z
    dGeomSetPosition(grounds[3], 0, 0, -1);
    for (int i = 0; i < kPoses; ++i) {
        turn(geom);
        dGeomSetPosition(geom, Real(0.3), Real(0.1), 0);
        for (dGeomID ground : grounds) {
            SCOPED_TRACE(dGeomGetClass(ground));
            hover(Real(0.01));
            ASSERT_EQ(collide(geom, ground), 0);
            hover(Real(-0.03));
            ASSERT_GE(collide(geom, ground), 1);
            ASSERT_NEAR(deepest(), Real(0.03), 10 * kTight);
            for (int k = 0; k < count; ++k) ASSERT_NEAR(contacts[k].normal[2], 1, kTight);
        }
    }
    for (dGeomID g : made) dGeomDestroy(g);
    made.clear();
    dGeomTriMeshDataDestroy(mesh), dGeomHeightfieldDataDestroy(field);
}

TEST_P(EverySolid, stops_rays_at_its_surface)
{
    dGeomID ray = keep(dCreateRay(nullptr, 20)), point = keep(dCreateSphere(nullptr, 0));
    for (int i = 0; i < 4 * kPoses; ++i) {
        turn(geom);
        const Vec3 d = random.direction(), inside = middle();
        const Vec3 from = inside - 10 * d;
        dGeomRaySet(ray, from.x, from.y, from.z, d.x, d.y, d.z);
        ASSERT_EQ(collide(ray, geom), 1);
        const Vec3 hit = load(contacts[0].pos), n = load(contacts[0].normal);
        ASSERT_LE(dot(n, d), kTight);
        ASSERT_NEAR(contacts[0].depth, length(hit - from), kTight);
        ASSERT_NEAR(dot(n, support(geom, n) - hit), 0, 10 * kTight)
            << "the normal is not that of the surface";
        dGeomSetPosition(point, hit.x, hit.y, hit.z);
        dQueryDistance to;
        dGeomGetDistance(point, geom, 1, &to);
        ASSERT_NEAR(to.distance, 0, kTight);
        // From inside to the far wall; one that passes above misses.
        const Vec3 start = hit + Real(1e-2) * d;
        dGeomRaySet(ray, start.x, start.y, start.z, d.x, d.y, d.z);
        if (collide(ray, geom) == 1 && contacts[0].depth > kTight) {
            ASSERT_LE(dot(load(contacts[0].normal), d), kTight);
        }
        Vec3 aside, other;
        plane_space(d, aside, other);
        const Vec3 top = support(geom, aside) + Real(0.01) * aside - 10 * d;
        dGeomRaySet(ray, top.x, top.y, top.z, d.x, d.y, d.z);
        ASSERT_EQ(collide(ray, geom), 0);
    }
}

TEST_P(EverySolid, knows_distances_overlaps_and_casts)
{
    dSpaceID space = dHashSpaceCreate(nullptr);
    dGeomID box = dCreateBox(space, 1, 1, 1);
    for (int i = 0; i < kPoses; ++i) {
        dGeomSetPosition(geom, 0, 0, 0);
        turn(geom);
        const Vec3 n = random.direction();
        const Real gap = Real(0.5);
        move(geom, (overlap_along(geom, box, n) + gap) * n);
        dQueryDistance d;
        dGeomGetDistance(geom, box, 10, &d);
        // No less by the gap along the normal, no more by the two points.
        ASSERT_GE(d.distance, gap - kTight);
        ASSERT_NEAR(d.distance, -overlap_along(geom, box, load(d.normal)), kTight);
        ASSERT_NEAR(d.distance, length(load(d.pos1) - load(d.pos2)), kTight);
        ASSERT_LE(dot(load(d.normal), load(d.pos2)),
                  dot(load(d.normal), support(box, load(d.normal))) + kTight);
        ASSERT_EQ(dSpaceOverlap(space, geom, nullptr, nullptr, 0), 0);
        const Vec3 way = -middle();  // to the middle of the box
        const dVector3 motion = {way.x, way.y, way.z};
        dQueryHit hit;
        ASSERT_EQ(dSpaceCast(space, geom, motion, nullptr, &hit), 1);
        ASSERT_GE(hit.distance, d.distance - kTight);
        move(geom, ((hit.distance + Real(1e-2)) / length(way)) * way);
        ASSERT_EQ(dSpaceOverlap(space, geom, nullptr, nullptr, 0), 1);
    }
    dSpaceDestroy(space);
}

class MovingSolid : public EverySolid {
  protected:
    MovingSolid()
    {
        body = dBodyCreate(world);
        dGeomSetBody(geom, body);
        dWorldSetGravity(world, 0, 0, Real(-9.81));
    }
    ~MovingSolid() override { dWorldDestroy(world), dSpaceDestroy(space); }
    dWorldID world = dWorldCreate();
    dSpaceID space = dHashSpaceCreate(nullptr);
    dBodyID body;
};

INSTANTIATE_TEST_SUITE_P(all, MovingSolid, testing::ValuesIn(solid_classes()),
                         [](const auto& instance) { return instance.param.name; });

TEST_P(MovingSolid, does_not_fly_through_a_sheet_when_continuous)
{
    dCreateBox(space, 40, 40, Real(0.01));
    dSpaceAdd(space, geom);
    dWorldSetGravity(world, 0, 0, 0);
    dGeomSetContinuous(geom, dContinuousOn);
    dBodySetPosition(body, 0, 0, 6);
    dBodySetLinearVel(body, 0, 0, -1000);
    dWorldStep(world, Real(0.02));
    EXPECT_GT(dBodyGetPosition(body)[2], Real(-3)) << "it has passed";
    EXPECT_NEAR(support(geom, {0, 0, -1}).z, Real(0.005), Real(0.3));
}

TEST_P(MovingSolid, comes_to_rest_in_contacts_that_the_world_manages)
{
    MessageRecorder messages;
    dCreatePlane(space, 0, 0, 1, 0);
    dSpaceAdd(space, geom);
    dWorldSetContactSpace(world, space);
    dWorldSetAngularDamping(world, Real(0.05));
    dWorldSetLinearDamping(world, Real(0.01));
    dBodySetPosition(body, 0, 0, 2);
    for (int i = 0; i < 600; ++i) dWorldStepFast1(world, Real(0.01), 4);
    EXPECT_NEAR(support(geom, {0, 0, -1}).z, 0, Real(0.02));
    EXPECT_LT(length(load(dBodyGetLinearVel(body))), Real(0.1));
    EXPECT_EQ(messages.take(), "");
}

TEST_P(EverySolid, has_a_closed_surface_of_triangles)
{
    const int all = dGeomGetTriangles(geom, 32, nullptr, 0);
    ASSERT_GT(all, 3);
    std::vector<dReal> t(9 * std::size_t(all) + 1, Real(-7));
    ASSERT_EQ(dGeomGetTriangles(geom, 32, t.data(), all), all);
    EXPECT_EQ(t.back(), -7);
    Real six_volumes = 0;
    Vec3 sum;  // of the areas' normals: nothing, of a closed surface
    for (std::size_t k = 0; k + 9 < t.size(); k += 9) {
        const Vec3 a{t[k], t[k + 1], t[k + 2]}, b{t[k + 3], t[k + 4], t[k + 5]},
            c{t[k + 6], t[k + 7], t[k + 8]};
        six_volumes += dot(a, cross(b, c));
        sum += cross(b - a, c - a);
    }
    EXPECT_GT(six_volumes, 0);
    EXPECT_LE(length(sum), 100 * kTight);
    MessageRecorder messages;
    EXPECT_EQ(dGeomGetTriangles(geom, 3, nullptr, 0), 0);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in dGeomGetTriangles()");
}

}  // namespace
}  // namespace epode
