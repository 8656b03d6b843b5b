// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Directions that part two geoms: what is found parts them, what is said to last holds where the bodies will
// be, and what is worth finding is found.
#include "contacts/ahead/pair_separation.h"

#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <vector>

#include "../math/random_numbers.h"
#include "collide/collide.h"
#include "math/rotation.h"

namespace epode::test {
namespace {

constexpr Real kH = Real(1) / 60;

TEST(PackedDirection, comes_back_almost_as_it_was)
{
    RandomNumbers random(3);
    EXPECT_EQ(pack_direction({}), 0u);
    std::vector<Vec3> all = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int i = 0; i < 5000; ++i) all.push_back(random.direction());
    for (const Vec3 n : all) {
        const std::uint32_t code = pack_direction(n);
        EXPECT_NE(code, 0u);
        const Vec3 back = unpack_direction(code);
        EXPECT_LT(length(back - n), Real(1e-4));
        EXPECT_NEAR(double(length(back)), 1.0, 1e-6);
    }
}

// One of each kind that is known, on bodies of their own, the hull on an offset.
class PairSeparationOf : public testing::Test {
  protected:
    PairSeparationOf()
    {
        dInitODE();
        world = dWorldCreate();
        RandomNumbers random(5);
        std::vector<dReal> points;
        for (int i = 0; i < 20; ++i) {
            const Vec3 p = Real(0.4) * random.direction();
            points.insert(points.end(), {p.x, p.y, p.z});
        }
        for (int twice = 0; twice < 2; ++twice)
            for (const dGeomID geom :
                 {dCreateSphere(nullptr, Real(0.3)), dCreateBox(nullptr, Real(0.3), Real(0.5), Real(0.8)),
                  dCreateCapsule(nullptr, Real(0.2), Real(0.6)),
                  dCreateCylinder(nullptr, Real(0.3), Real(0.5)),
                  dCreateConvexHull(nullptr, points.data(), 20, 0)})
                if (geom) add(geom);
    }
    ~PairSeparationOf() override
    {
        for (const dGeomID geom : geoms) dGeomDestroy(geom);
        dWorldDestroy(world);
        dCloseODE();
    }
    void add(dGeomID geom)
    {
        dGeomSetBody(geom, dBodyCreate(world));
        geoms.push_back(geom);
    }
    void throw_about(dGeomID geom, RandomNumbers& random, Vec3 x)
    {
        const dBodyID body = dGeomGetBody(geom);
        const Quat q = random.rotation();
        const dQuaternion turned = {q.w, q.x, q.y, q.z};
        const Vec3 v = Real(4) * random.vec(), w = Real(10) * random.vec();
        dBodySetPosition(body, x.x, x.y, x.z);
        dBodySetQuaternion(body, turned);
        dBodySetLinearVel(body, v.x, v.y, v.z);
        dBodySetAngularVel(body, w.x, w.y, w.z);
    }
    static Geom& live(dGeomID id) { return *from_handle<Geom>(id); }
    static const Body* body_of(dGeomID id) { return from_handle<Body>(dGeomGetBody(id)); }
    static bool touch(Geom& a, const Pose& A, Geom& b, const Pose& B)
    {
        dContactGeom found[4];
        ContactArray out{found, int(sizeof(dContactGeom)), 4, false};
        collide_at(a, A, b, B, out);
        return out.count > 0;
    }

    dWorldID world;
    std::vector<dGeomID> geoms;
    const SpeculativeMotion soon{kH, {0, 0, Real(-9.81)}};
};

TEST_F(PairSeparationOf, parts_what_is_apart_and_lasts_as_long_as_it_says)
{
    RandomNumbers random(9);
    int apart = 0, found = 0, missed = 0, lasted = 0, met = 0;
    for (int round = 0; round < 40; ++round)
        for (std::size_t i = 0; i < geoms.size(); ++i)
            for (std::size_t j = i + 1; j < geoms.size(); ++j) {
                throw_about(geoms[i], random, {});
                throw_about(geoms[j], random, Real(0.9) * random.vec());
                Geom &a = live(geoms[i]), &b = live(geoms[j]);
                const Pose A = pose_of(a), B = pose_of(b);
                const PairSeparation separation(a, b);
                const Vec3 n = separation.find(A, B, A.p - B.p);
                const bool touches = touch(a, A, b, B);
                dQueryDistance answer = {};
                ASSERT_EQ(dGeomGetDistance(geoms[i], geoms[j], dInfinity, &answer), 1);
                const double distance = double(answer.distance);
                apart += !touches;
                if (n == Vec3{}) {
                    missed += distance > 0.02;
                    continue;
                }
                ++found;
                EXPECT_FALSE(touches) << i << " " << j;
                const Real gap = separation.gap(A, B, n);
                EXPECT_GT(gap, separation.hair());
                EXPECT_LE(double(gap), distance + 1e-5);
                const bool lasts = separation.lasts(A, B, n, gap, soon, body_of(geoms[i]), body_of(geoms[j]));
                const bool will =
                    touch(a, soon.pose(body_of(geoms[i]), A), b, soon.pose(body_of(geoms[j]), B));
                EXPECT_FALSE(lasts && will) << i << " " << j;
                lasted += lasts, met += will;
            }
    EXPECT_GT(found, apart * 9 / 10);
    EXPECT_EQ(missed, 0);
    EXPECT_GT(lasted, found / 2);
    EXPECT_GT(met, 10);  // or nothing would have been tried
}

}  // namespace
}  // namespace epode::test
