// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where bodies will be: at the place that a step without contacts leads to, and inside the box that is kept
// free for it.
#include "contacts/ahead/speculative_motion.h"

#include <gtest/gtest.h>
#include <ode/ode.h>

#include <cmath>

#include "../math/random_numbers.h"
#include "collide/collide.h"

namespace epode::test {
namespace {

constexpr Real kH = Real(1) / 60;

class SpeculativeMotionOf : public testing::Test {
  protected:
    SpeculativeMotionOf()
    {
        dInitODE();
        world = dWorldCreate();
        dWorldSetGravity(world, 0, Real(0.5), Real(-9.81));
        id = dBodyCreate(world);
        geom = dCreateBox(nullptr, Real(0.3), Real(0.8), Real(1.7));
        dGeomSetBody(geom, id);
    }
    ~SpeculativeMotionOf() override
    {
        dGeomDestroy(geom);
        dWorldDestroy(world);
        dCloseODE();
    }
    const Body* body() const { return from_handle<Body>(id); }
    Geom& shape() const { return *from_handle<Geom>(geom); }

    dWorldID world;
    dBodyID id;
    dGeomID geom;
    const SpeculativeMotion soon{kH, {0, Real(0.5), Real(-9.81)}};
};

TEST_F(SpeculativeMotionOf, a_free_body_is_where_the_step_takes_it)
{
    dBodySetLinearVel(id, 3, -2, 1);
    dBodySetAngularVel(id, 0, 0, 4);  // about an axis of inertia
    dGeomSetOffsetPosition(geom, Real(0.4), 0, 0);
    const Pose now = pose_of(shape()), then = soon.pose(body(), now);
    ASSERT_EQ(dWorldStep(world, kH), 1);
    const Pose came = pose_of(shape());
    EXPECT_LT(length(then.p - came.p), Real(1e-5));
    EXPECT_LT(length(then.R.column(0) - came.R.column(0)), Real(1e-3));  // the step turns by the small angle
    EXPECT_LT(length(soon.velocity(nullptr)), Real(1e-9));
}

TEST_F(SpeculativeMotionOf, only_what_gravity_moves_falls)
{
    const Vec3 fallen = kH * soon.gravity;
    EXPECT_LT(length(soon.velocity(body()) - fallen), Real(1e-9));
    dBodySetGravityMode(id, 0);
    EXPECT_EQ(length(soon.velocity(body())), 0);
    dBodySetGravityMode(id, 1);
    dBodyDisable(id);
    EXPECT_EQ(length(soon.velocity(body())), 0);
    dBodyEnable(id);
    dBodySetKinematic(id);
    EXPECT_EQ(length(soon.velocity(body())), 0);
}

TEST_F(SpeculativeMotionOf, the_box_holds_the_geom_after_any_motion)
{
    RandomNumbers random(7);
    Real largest = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 v = Real(20) * random.vec(), w = Real(30) * random.vec(), offset = random.vec(),
                   x = Real(5) * random.vec();
        dBodySetPosition(id, x.x, x.y, x.z);
        dBodySetLinearVel(id, v.x, v.y, v.z);
        dBodySetAngularVel(id, w.x, w.y, w.z);
        dGeomSetOffsetPosition(geom, offset.x, offset.y, offset.z);
        const Aabb now = box_of(shape());
        const Pose then = soon.pose(body(), pose_of(shape()));
        const Aabb kept = soon.box(body(), now);
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 half{Real(0.15), Real(0.4), Real(0.85)};
            const Vec3 at = then.to_world({corner & 1 ? half.x : -half.x, corner & 2 ? half.y : -half.y,
                                           corner & 4 ? half.z : -half.z});
            EXPECT_TRUE(overlap(kept, Aabb{at, at})) << i;
        }
        const Aabb moved{now.lo + kH * soon.velocity(body()), now.hi + kH * soon.velocity(body())};
        largest = std::max(largest, moved.lo.x - kept.lo.x);
    }
    EXPECT_LT(largest, kH * 30 * std::sqrt(Real(3)) * Real(3.7));  // and not much more
}

}  // namespace
}  // namespace epode::test
