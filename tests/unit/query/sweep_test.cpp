// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Shape casts: closed forms; for every pair of classes the time of impact by the signed distance, which must
// be positive before and next to nothing there; nothing thin is passed; spaces by brute force; refusals.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "../api/message_recorder.h"
#include "query_scene.h"

using namespace epode;
using namespace epode::test;

namespace {

constexpr Real kTight = kSingle ? Real(1e-3) : Real(1e-6);

class SweptGeoms : public testing::Test {
  protected:
    SweptGeoms() { dInitODE(); }
    ~SweptGeoms() override { dCloseODE(); }
    static dQueryHit cast(dGeomID o, Vec3 motion, dGeomID other, int met = 1)
    {
        const dVector3 m = {motion.x, motion.y, motion.z, 0};
        dQueryHit hit{};
        EXPECT_EQ(dGeomCast(o, m, other, &hit), met);
        EXPECT_EQ(hit.geom, met ? other : nullptr);
        return hit;
    }
};

Real distance_of(dGeomID a, dGeomID b)
{
    dQueryDistance d{};
    EXPECT_EQ(dGeomGetDistance(a, b, dInfinity, &d), 1);
    return d.distance;
}

// Does the box of the moving geom meet that of the other one?
bool boxes_meet(dGeomID moving, Vec3 motion, dGeomID other)
{
    dReal a[6], b[6];
    dGeomGetAABB(moving, a);
    dGeomGetAABB(other, b);
    for (int i = 0; i < 3; ++i) {
        const Real low = std::min(a[2 * i], a[2 * i] + motion[i]);
        const Real high = std::max(a[2 * i + 1], a[2 * i + 1] + motion[i]);
        if (low > b[2 * i + 1] || high < b[2 * i]) return false;
    }
    return true;
}

}  // namespace

TEST_F(SweptGeoms, meet_where_closed_forms_say)
{
    const dGeomID ball = dCreateSphere(nullptr, 1), box = dCreateBox(nullptr, 2, 2, 2),
                  plane = dCreatePlane(nullptr, 0, 0, 1, 0), can = dCreateCylinder(nullptr, 1, 2);
    dGeomSetPosition(ball, -10, 0, 0);
    dQueryHit hit = cast(ball, {20, 0, 0}, box);
    EXPECT_NEAR(hit.distance, 8, kTight);
    EXPECT_LT(length(load(hit.pos) - Vec3{-1, 0, 0}), kTight);
    EXPECT_LT(length(load(hit.normal) - Vec3{-1, 0, 0}), kTight);
    cast(ball, {Real(7.9), 0, 0}, box, 0);
    cast(ball, {-20, 0, 0}, box, 0);
    dGeomSetPosition(ball, -10, 0, Real(1.6));  // over the edge: 0.6 above it, so 0.8 before it
    EXPECT_NEAR(cast(ball, {20, 0, 0}, box).distance, 10 - 1 - 0.8, kTight);
    dGeomSetPosition(ball, -10, 0, Real(2.01));
    cast(ball, {20, 0, 0}, box, 0);

    dGeomSetPosition(ball, 0, 0, 5);
    hit = cast(ball, {3, 0, -4}, plane);
    EXPECT_NEAR(hit.distance, 5, kTight);
    EXPECT_NEAR(hit.pos[0], 3, kTight);
    dGeomSetPosition(can, 0, 0, 5);
    EXPECT_NEAR(cast(can, {0, 0, -100}, plane).distance, 4, kTight);
    EXPECT_NEAR(cast(can, {0, 0, -100}, box).distance, 3, kTight);
    for (const dGeomID g : {ball, box, plane, can}) dGeomDestroy(g);
}

TEST_F(SweptGeoms, slide_along_what_they_touch_and_are_stopped_by_what_they_overlap)
{
    const dGeomID box = dCreateBox(nullptr, 1, 1, 1), floor = dCreateBox(nullptr, 50, 50, 1),
                  plane = dCreatePlane(nullptr, 0, 0, 1, Real(0.5));
    dGeomSetPosition(box, 0, 0, 1);
    for (const dGeomID ground : {floor, plane}) {
        cast(box, {10, 0, 0}, ground, 0);
        cast(box, {0, 0, 10}, ground, 0);
        EXPECT_EQ(cast(box, {0, 0, -10}, ground).distance, 0);
    }
    dGeomSetPosition(box, 0, 0, Real(0.9));
    for (const dGeomID ground : {floor, plane}) {
        const dQueryHit hit = cast(box, {10, 0, 0}, ground);
        EXPECT_EQ(hit.distance, 0);
        EXPECT_NEAR(hit.normal[2], 1, kTight);
    }
    for (const dGeomID g : {box, floor, plane}) dGeomDestroy(g);
}

TEST_F(SweptGeoms, are_stopped_at_once_inside_a_solid_mesh)
{
    constexpr double kCube[] = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 0, 0, 2, 2, 0, 2, 2, 2, 2, 0, 2, 2};
    constexpr dTriIndex kFaces[] = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                    1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data, kCube, 24, 8, kFaces, 36, 12);
    const dGeomID cube = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
    const Real r = Real(0.1);
    const dGeomID solids[] = {dCreateSphere(nullptr, r),
                              dCreateBox(nullptr, r, r, r),
                              dCreateCapsule(nullptr, r, r),
                              dCreateCylinder(nullptr, r, r),
                              dCreateCone(nullptr, r, r),
                              dCreateEllipsoid(nullptr, r, 2 * r, r),
                              dCreateTaperedCapsule(nullptr, r, r / 2, r)};
    for (const dGeomID solid : solids) {
        dGeomSetPosition(solid, 1, 1, Real(1.7));
        dGeomTriMeshSetSolid(cube, 0);
        EXPECT_GT(cast(solid, {0, 0, -5}, cube).distance, 1) << "a surface is met from behind";
        dGeomTriMeshSetSolid(cube, 1);
        for (const Vec3 motion : {Vec3{0, 0, -5}, Vec3{Real(0.01), 0, 0}}) {
            const dQueryHit hit = cast(solid, motion, cube);
            EXPECT_EQ(hit.distance, 0);
            EXPECT_LT(length(load(hit.normal) - Vec3{0, 0, 1}), kTight);
            EXPECT_NEAR(hit.pos[2], 2, kTight);
            EXPECT_TRUE(hit.side == 2 || hit.side == 3) << hit.side;
        }
        dGeomDestroy(solid);
    }
    dGeomDestroy(cube);
    dGeomTriMeshDataDestroy(data);
}

TEST(SpaceCast, every_class_is_met_where_the_distance_vanishes)
{
    QueryScene scene(31, 0);
    RandomNumbers& dice = scene.dice();
    int met = 0, missed = 0;
    for (int i = 0; i < QueryScene::kKinds + 1; ++i)
        for (int j = 0; j < QueryScene::kKinds + 1; ++j) {
            if (i == 5 || i == 6 || i == 8) continue;  // no solids
            for (int k = 0; k < 16; ++k) {
                const auto made = [&](int kind) {
                    return kind < QueryScene::kKinds ? scene.make(kind, nullptr) : dCreateRay(nullptr, 2);
                };
                const dGeomID a = made(i), b = made(j);
                scene.place(a, 8), scene.place(b, 1);
                // A field is met at its surface, from above: around it there is no wall to its ground.
                const bool field = dGeomGetClass(b) == dHeightfieldClass;
                if (field) {
                    const dQuaternion upright = {1, 0, 0, 0};
                    dGeomSetQuaternion(b, upright);
                    dGeomSetPosition(b, 0, 0, 0);
                    dGeomSetPosition(a, dice.in(-1, 1), 5, dice.in(-1, 1));
                }
                const Vec3 p = load(dGeomGetPosition(a));
                const Vec3 aim = Real(1.2) * dice.vec();
                const Vec3 m = Real(field ? 1.2 : 2) * (aim - p);
                const dVector3 motion = {m.x, m.y, m.z, 0};
                SCOPED_TRACE(testing::Message() << "classes " << dGeomGetClass(a) << " and "
                                                << dGeomGetClass(b) << ", pose " << k);
                dQueryHit hit{};
                const int hits = dGeomCast(a, motion, b, &hit);
                const Real way = hits ? hit.distance : length(m);
                const auto at = [&](Real t) {
                    const Vec3 q = p + (t / length(m)) * m;
                    dGeomSetPosition(a, q.x, q.y, q.z);
                    return distance_of(a, b);
                };
                if (hits && way > 0) { EXPECT_NEAR(at(way), 0, kTight); }
                for (int step = 0; step < 40 && !(hits && way == 0); ++step)
                    EXPECT_GT(at(way * Real(step) / 40), -kTight);
                if (hits && way == 0) { EXPECT_LT(at(0), kTight); }
                (hits ? met : missed) += 1;
                dGeomDestroy(a), dGeomDestroy(b);
            }
        }
    EXPECT_GT(met, 300);
    EXPECT_GT(missed, 30);
}

TEST_F(SweptGeoms, pass_nothing_however_thin)
{
    const dGeomID bullet = dCreateSphere(nullptr, Real(0.001)),
                  wall = dCreateBox(nullptr, Real(1e-4), 10, 10);
    const dReal corners[] = {0, -5, -5, 0, 0, 5, -5, 0, 0, 0, 5, 0};
    const dTriIndex one[] = {0, 1, 2};
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSimple(data, corners, 3, one, 3);
    const dGeomID sheet = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
    dGeomSetPosition(bullet, -500, 0, 0);
    EXPECT_NEAR(cast(bullet, {1000, 0, 0}, wall).distance, 500 - 0.001 - 5e-5, kTight);
    dQueryHit hit = cast(bullet, {1000, 0, 0}, sheet);
    EXPECT_NEAR(hit.distance, 500 - 0.001, kTight);
    EXPECT_EQ(hit.side, 0);
    EXPECT_NEAR(std::fabs(hit.normal[0]), 1, kTight);
    for (const dGeomID g : {bullet, wall, sheet}) dGeomDestroy(g);
    dGeomTriMeshDataDestroy(data);
}

TEST(SpaceCast, finds_what_casts_at_every_member_find)
{
    int hits = 0;
    for (std::uint64_t key = 1; key <= 5; ++key) {
        QueryScene scene(key, 120, 5);
        for (int k = 0; k < 30; ++k) {
            const int kinds[] = {0, 1, 2, 3, 4, 7};
            const dGeomID probe = scene.make(kinds[k % 6], nullptr);
            scene.place(probe, 12);
            if (k % 3 == 0) dGeomSetCategoryBits(probe, 4), dGeomSetCollideBits(probe, 1);
            const Vec3 m = Real(2) * (Real(3) * scene.dice().vec() - load(dGeomGetPosition(probe)));
            const dVector3 motion = {m.x, m.y, m.z, 0};
            dQueryHit best{}, got{};
            best.distance = dInfinity;
            for (const dGeomID g : scene.leaves()) {
                dQueryHit hit;
                if (!QueryScene::seen(g, dGeomGetCategoryBits(probe), dGeomGetCollideBits(probe))) continue;
                // What lies below the box of a height field is not in it for a space.
                if (!boxes_meet(probe, m, g)) continue;
                if (dGeomCast(probe, motion, g, &hit) && hit.distance < best.distance) best = hit;
            }
            EXPECT_EQ(dSpaceCast(scene.space, probe, motion, nullptr, &got), int(best.geom != nullptr));
            EXPECT_EQ(got.geom, best.geom);
            if (best.geom) { EXPECT_EQ(got.distance, best.distance); }
            hits += best.geom != nullptr;
            dGeomDestroy(probe);
        }
    }
    EXPECT_GT(hits, 80);
}

TEST(SpaceCast, refuses_what_makes_no_sense)
{
    QueryScene scene(1, 10);
    const dGeomID ball = dCreateSphere(nullptr, 1), other = dCreateSphere(nullptr, 1),
                  plane = dCreatePlane(nullptr, 0, 0, 1, 0);
    MessageRecorder recorder;
    const dVector3 way = {1, 0, 0}, zero = {0, 0, 0}, nan = {0, dReal(NAN), 0};
    dQueryHit hit, untouched;
    std::memset(&hit, 0x5a, sizeof hit);
    untouched = hit;
    EXPECT_EQ(dGeomCast(nullptr, way, other, &hit), 0);
    EXPECT_EQ(dGeomCast(ball, nullptr, other, &hit), 0);
    EXPECT_EQ(dGeomCast(ball, zero, other, &hit), 0);
    EXPECT_EQ(dGeomCast(ball, nan, other, &hit), 0);
    EXPECT_EQ(dGeomCast(ball, way, nullptr, &hit), 0);
    EXPECT_EQ(dGeomCast(ball, way, ball, &hit), 0);
    EXPECT_EQ(dGeomCast(plane, way, ball, &hit), 0);
    EXPECT_EQ(dGeomCast(ball, way, geom_of(scene.space), &hit), 0);
    EXPECT_EQ(dGeomCast(ball, way, other, nullptr), 0);
    EXPECT_EQ(dSpaceCast(nullptr, ball, way, nullptr, &hit), 0);
    EXPECT_EQ(dSpaceCast(scene.space, geom_of(scene.space), way, nullptr, &hit), 0);
    EXPECT_EQ(dSpaceCast(scene.space, ball, zero, nullptr, &hit), 0);
    const std::string said = recorder.take();
    EXPECT_EQ(std::count(said.begin(), said.end(), '|'), 11) << said;
    EXPECT_EQ(std::memcmp(&hit, &untouched, sizeof hit), 0);
    for (const dGeomID g : {ball, other, plane}) dGeomDestroy(g);
}
