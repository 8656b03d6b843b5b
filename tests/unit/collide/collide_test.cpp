// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The dispatcher: who is g1, what is refused, overrides, user classes, transforms.
#include <gtest/gtest.h>

#include <cstring>

#include "../api/message_recorder.h"
#include "space_scene.h"

namespace {

constexpr int kStride = sizeof(dContactGeom);

int collide(dGeomID a, dGeomID b, dContactGeom* c, int capacity = 4)
{
    return dCollide(a, b, capacity, c, kStride);
}

TEST(Collide, names_the_geoms_in_the_callers_order_and_turns_the_normal)
{
    dGeomID sphere = dCreateSphere(nullptr, 1), plane = dCreatePlane(nullptr, 0, 0, 1, 0);
    dGeomSetPosition(sphere, 0, 0, dReal(0.5));
    dContactGeom c[4];
    ASSERT_EQ(collide(sphere, plane, c), 1);
    EXPECT_EQ(c[0].g1, sphere);
    EXPECT_EQ(c[0].g2, plane);
    EXPECT_EQ(c[0].normal[2], 1);
    EXPECT_EQ(c[0].depth, dReal(0.5));
    ASSERT_EQ(collide(plane, sphere, c), 1);
    EXPECT_EQ(c[0].g1, plane);
    EXPECT_EQ(c[0].g2, sphere);
    EXPECT_EQ(c[0].normal[2], -1);
    EXPECT_EQ(c[0].side1, -1);
    EXPECT_EQ(c[0].side2, -1);
    dGeomDisable(sphere);
    EXPECT_EQ(collide(sphere, plane, c), 1) << "only spaces look at enabling";
    EXPECT_EQ(collide(sphere, sphere, c), 0);
    dGeomDestroy(sphere);
    dGeomDestroy(plane);
}

TEST(Collide, refuses_bad_arguments_and_writes_nothing)
{
    MessageRecorder messages;
    dGeomID a = dCreateSphere(nullptr, 1), b = dCreateSphere(nullptr, 1);
    dContactGeom c[2];
    std::memset(c, 0x55, sizeof c);
    const dContactGeom untouched = c[0];
    EXPECT_EQ(dCollide(a, b, 0, c, kStride), 0);
    EXPECT_EQ(messages.take(), "2: no contacts requested in dCollide()");
    EXPECT_EQ(dCollide(a, b, 1, c, kStride - 1), 0);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in dCollide()");
    EXPECT_EQ(dCollide(nullptr, b, 1, c, kStride), 0);
    EXPECT_EQ(dCollide(a, nullptr, 1, c, kStride), 0);
    EXPECT_EQ(dCollide(a, b, 1, nullptr, kStride), 0);
    dGeomDestroy(b);
    EXPECT_EQ(dCollide(a, b, 1, c, kStride), 0) << "a destroyed geom";
    messages.take();
    EXPECT_EQ(std::memcmp(&c[0], &untouched, sizeof untouched), 0);
    dGeomDestroy(a);
}

TEST(Collide, honours_the_stride_and_the_capacity)
{
    dGeomID box = dCreateBox(nullptr, 1, 1, 1), plane = dCreatePlane(nullptr, 0, 0, 1, 0);
    dGeomSetPosition(box, 0, 0, dReal(0.4));
    dContact c[5];
    std::memset(c, 0x55, sizeof c);
    const dContact untouched = c[4];
    ASSERT_EQ(dCollide(box, plane, 4, &c[0].geom, sizeof(dContact)), 4);
    for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(c[i].geom.depth, 0.1, 1e-6);
        EXPECT_EQ(c[i].geom.g1, box);
        EXPECT_EQ(std::memcmp(&c[i].surface, &untouched.surface, sizeof untouched.surface), 0);
    }
    EXPECT_EQ(std::memcmp(&c[4], &untouched, sizeof untouched), 0);
    EXPECT_EQ(dCollide(box, plane, 2, &c[0].geom, sizeof(dContact)), 2);
    dGeomDestroy(box);
    dGeomDestroy(plane);
}

TEST(Collide, gives_nothing_for_geoms_of_one_body)
{
    dWorldID world = dWorldCreate();
    dBodyID body = dBodyCreate(world);
    dGeomID a = dCreateSphere(nullptr, 1), b = dCreateSphere(nullptr, 1);
    dContactGeom c[1];
    dGeomSetBody(a, body);
    EXPECT_EQ(collide(a, b, c, 1), 1);
    dGeomSetBody(b, body);
    EXPECT_EQ(collide(a, b, c, 1), 0);
    dGeomDestroy(a);
    dGeomDestroy(b);
    dWorldDestroy(world);
}

int two_contacts(dGeomID o1, dGeomID o2, int flags, dContactGeom* contact, int skip)
{
    const int n = (flags & 0xffff) < 2 ? flags & 0xffff : 2;
    for (int i = 0; i < n; ++i) {
        auto* c = reinterpret_cast<dContactGeom*>(reinterpret_cast<char*>(contact) + i * skip);
        *c = {};
        c->normal[0] = 1;
        c->depth = dReal(i + 1);
        c->g1 = o1, c->g2 = o2;
        c->side1 = 10 + i, c->side2 = 20 + i;
        const dReal* p = dGeomGetPosition(o1);
        for (int k = 0; k < 3; ++k) c->pos[k] = p[k];
    }
    return n;
}

class Initialized : public testing::Test {
  protected:
    Initialized() { dInitODE2(0); }
    ~Initialized() override { dCloseODE(); }
};

using Override = Initialized;

TEST_F(Override, serves_both_orders_until_the_last_close)
{
    dGeomID a = dCreateSphere(nullptr, 1), b = dCreateBox(nullptr, 1, 1, 1);
    dContactGeom c[4];
    ASSERT_EQ(collide(a, b, c), 1);
    dSetColliderOverride(dSphereClass, dBoxClass, two_contacts);
    ASSERT_EQ(collide(a, b, c), 2);
    EXPECT_EQ(c[1].g1, a);
    EXPECT_EQ(c[1].side1, 11);
    EXPECT_EQ(c[1].normal[0], 1);
    ASSERT_EQ(collide(b, a, c), 2);
    EXPECT_EQ(c[0].g1, b);
    EXPECT_EQ(c[0].side1, 20);
    EXPECT_EQ(c[0].normal[0], -1);
    EXPECT_EQ(collide(a, b, c, 1), 1);
    dSetColliderOverride(dSphereClass, dBoxClass, nullptr);
    EXPECT_EQ(collide(a, b, c), 0);
    dCloseODE();
    dInitODE2(0);
    EXPECT_EQ(collide(a, b, c), 1);
    dGeomDestroy(a);
    dGeomDestroy(b);
}

TEST_F(Override, of_a_class_with_itself_gets_its_arguments_in_order)
{
    dGeomID a = dCreateSphere(nullptr, 1), b = dCreateSphere(nullptr, 1);
    dSetColliderOverride(dSphereClass, dSphereClass, two_contacts);
    dContactGeom c[4];
    ASSERT_EQ(collide(a, b, c), 2);
    EXPECT_EQ(c[0].g1, a);
    EXPECT_EQ(c[0].normal[0], 1);
    dGeomDestroy(a);
    dGeomDestroy(b);
}

// ---- user classes ----

struct Calls {
    int colliders = 0, vetoes = 0, destroyed = 0;
    bool veto = false;
} g_calls;

dColliderFn* answer(int number)
{
    ++g_calls.colliders;
    return number == dSphereClass ? two_contacts : nullptr;
}
void unit_box(dGeomID g, dReal aabb[6])
{
    const dReal* p = dGeomGetPosition(g);
    for (int i = 0; i < 3; ++i) aabb[2 * i] = p[i] - 1, aabb[2 * i + 1] = p[i] + 1;
}
int veto(dGeomID, dGeomID, dReal[6])
{
    ++g_calls.vetoes;
    return !g_calls.veto;
}
void count_end(dGeomID g)
{
    EXPECT_EQ(*static_cast<int*>(dGeomGetClassData(g)), 42);
    ++g_calls.destroyed;
}

class UserClass : public Initialized {
  protected:
    UserClass() { g_calls = {}; }
    dGeomClass description{sizeof(int), answer, unit_box, veto, count_end};
};

TEST_F(UserClass, collides_and_lives_through_the_programs_functions)
{
    const int number = dCreateGeomClass(&description);
    EXPECT_EQ(number, dFirstUserClass);
    dGeomID user = dCreateGeom(number), sphere = dCreateSphere(nullptr, 1),
            box = dCreateBox(nullptr, 1, 1, 1);
    int* memory = static_cast<int*>(dGeomGetClassData(user));
    EXPECT_EQ(*memory, 0);
    *memory = 42;
    dContactGeom c[4];
    ASSERT_EQ(collide(user, sphere, c), 2);
    EXPECT_EQ(c[0].g1, user);
    EXPECT_EQ(c[0].normal[0], 1);
    ASSERT_EQ(collide(sphere, user, c), 2);
    EXPECT_EQ(c[0].g1, sphere);
    EXPECT_EQ(c[0].normal[0], -1);
    EXPECT_EQ(g_calls.colliders, 1) << "the answer is remembered for both orders";
    EXPECT_EQ(collide(user, box, c), 0);
    EXPECT_EQ(collide(box, user, c), 0);
    EXPECT_EQ(g_calls.colliders, 2);

    dSpaceID space = dHashSpaceCreate(nullptr);
    dSpaceAdd(space, user);
    dSpaceAdd(space, sphere);
    EXPECT_EQ(pairs_in(space).size(), 1u);
    EXPECT_EQ(g_calls.vetoes, 1);
    g_calls.veto = true;
    EXPECT_EQ(pairs_in(space).size(), 0u);
    g_calls.veto = false;
    dGeomSetPosition(user, 5, 0, 0);
    EXPECT_EQ(pairs_in(space).size(), 0u);
    dSpaceDestroy(space);
    EXPECT_EQ(g_calls.destroyed, 1);
    dGeomDestroy(box);
}

TEST_F(UserClass, registration_is_checked_and_ends_with_the_last_close)
{
    MessageRecorder messages;
    dGeomClass bad = description;
    bad.collider = nullptr;
    EXPECT_EQ(dCreateGeomClass(&bad), -1);
    EXPECT_EQ(messages.take(), "2: bad geom class in dCreateGeomClass()");
    for (int i = 0; i < dMaxUserClasses; ++i) EXPECT_EQ(dCreateGeomClass(&description), dFirstUserClass + i);
    EXPECT_EQ(dCreateGeomClass(&description), -1);
    EXPECT_NE(messages.take(), "");
    EXPECT_EQ(dCreateGeom(dSphereClass), nullptr);
    EXPECT_EQ(messages.take(), "2: not a custom class in dCreateGeom()");
    dGeomID sphere = dCreateSphere(nullptr, 1), user = dCreateGeom(dFirstUserClass);
    *static_cast<int*>(dGeomGetClassData(user)) = 42;
    EXPECT_EQ(dGeomGetClassData(sphere), nullptr);
    EXPECT_EQ(messages.take(), "2: not a custom class in dGeomGetClassData()");
    dCloseODE();
    dInitODE2(0);
    EXPECT_EQ(dCreateGeom(dFirstUserClass), nullptr);
    messages.take();
    // The number is taken by another class; the geom of the forgotten one must not reach its collider.
    EXPECT_EQ(dCreateGeomClass(&description), dFirstUserClass);
    dContactGeom c[4];
    EXPECT_EQ(collide(user, sphere, c), 0);
    dGeomDestroy(user);
    EXPECT_EQ(g_calls.destroyed, 1);
    EXPECT_EQ(messages.take(), "");
    dGeomDestroy(sphere);
}

// ---- transforms ----

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

TEST_F(UserClass, inside_a_transform_sees_itself_placed)
{
    const int number = dCreateGeomClass(&description);
    dGeomID user = dCreateGeom(number), sphere = dCreateSphere(nullptr, 1), t = dCreateGeomTransform(nullptr);
    *static_cast<int*>(dGeomGetClassData(user)) = 42;
    dGeomSetPosition(user, 1, 0, 0);
    dGeomSetPosition(t, 0, 2, 0);
    dGeomTransformSetGeom(t, user);
    dGeomTransformSetCleanup(t, 1);
    dContactGeom c[4];
    ASSERT_EQ(collide(t, sphere, c), 2);
    EXPECT_EQ(c[0].pos[0], 1);
    EXPECT_EQ(c[0].pos[1], 2);
    EXPECT_EQ(c[0].g1, user);
    dGeomTransformSetInfo(t, 1);
    ASSERT_EQ(collide(sphere, t, c), 2);
    EXPECT_EQ(c[0].g2, t);
    EXPECT_EQ(dGeomGetPosition(user)[1], 0);
    dReal box[6];
    dGeomGetAABB(t, box);
    EXPECT_EQ(box[2], 1);
    EXPECT_EQ(box[3], 3);
    dGeomDestroy(t);
    EXPECT_EQ(g_calls.destroyed, 1);
    dGeomDestroy(sphere);
}

TEST(GeomTransform, collides_as_what_it_holds_where_it_holds_it)
{
    dGeomID t = dCreateGeomTransform(nullptr), sphere = dCreateSphere(nullptr, dReal(0.5));
    dGeomID plane = dCreatePlane(nullptr, 0, 0, 1, 0);
    dContactGeom c[4];
    EXPECT_EQ(collide(t, plane, c), 0) << "empty";
    dGeomSetPosition(sphere, 1, 0, 0);
    dGeomTransformSetGeom(t, sphere);
    dGeomSetPosition(t, 0, 0, dReal(0.4));
    ASSERT_EQ(collide(t, plane, c), 1);
    EXPECT_EQ(c[0].g1, sphere);
    EXPECT_EQ(c[0].pos[0], 1);
    EXPECT_NEAR(c[0].pos[2], -0.1, 1e-6);
    EXPECT_NEAR(c[0].depth, 0.1, 1e-6);
    dGeomTransformSetInfo(t, 1);
    ASSERT_EQ(collide(plane, t, c), 1);
    EXPECT_EQ(c[0].g2, t);
    EXPECT_EQ(c[0].normal[2], -1);
    dGeomDestroy(sphere);
    EXPECT_EQ(dGeomTransformGetGeom(t), nullptr) << "nothing dangles";
    EXPECT_EQ(collide(t, plane, c), 0);
    dGeomDestroy(t);
    dGeomDestroy(plane);
}

TEST(GeomTransform, box_follows_what_it_holds)
{
    dSpaceID space = dHashSpaceCreate(nullptr);
    dGeomID t = dCreateGeomTransform(space), sphere = dCreateSphere(nullptr, 1),
            target = dCreateSphere(space, 1);
    dGeomSetPosition(target, 10, 0, 0);
    dGeomTransformSetGeom(t, sphere);
    EXPECT_TRUE(pairs_in(space).empty());
    dGeomSetPosition(sphere, 9, 0, 0);
    EXPECT_EQ(pairs_in(space).size(), 1u);
    dGeomSphereSetRadius(sphere, 0);
    EXPECT_TRUE(pairs_in(space).empty()) << "of zero size now";
    dGeomDestroy(sphere);
    dSpaceDestroy(space);
}

TEST(GeomTransform, refuses_what_it_cannot_hold)
{
    MessageRecorder messages;
    dSpaceID space = dHashSpaceCreate(nullptr);
    dGeomID t = dCreateGeomTransform(nullptr), u = dCreateGeomTransform(nullptr),
            inside = dCreateSphere(space, 1);
    dGeomTransformSetGeom(t, inside);
    EXPECT_EQ(messages.take(),
              "2: GeomTransform encapsulated object must not be in a space in dGeomTransformSetGeom()");
    dGeomTransformSetGeom(t, t);
    EXPECT_NE(messages.take(), "");
    dGeomTransformSetGeom(t, u);
    EXPECT_EQ(messages.take(), "");
    dGeomTransformSetGeom(u, t);
    EXPECT_NE(messages.take(), "") << "a circle";
    dSpaceAdd(space, u);
    EXPECT_NE(messages.take(), "") << "held by a transform";
    dGeomDestroy(t);
    EXPECT_EQ(dGeomTransformGetGeom(u), nullptr);
    dGeomDestroy(u);
    dSpaceDestroy(space);
}

TEST(GeomTransform, nested_composes_poses_and_cleanup)
{
    MessageRecorder messages;
    dGeomID outer = dCreateGeomTransform(nullptr), inner = dCreateGeomTransform(nullptr);
    dGeomID sphere = dCreateSphere(nullptr, 1), probe = dCreateSphere(nullptr, 1);
    dGeomSetPosition(outer, 1, 0, 0), dGeomSetPosition(inner, 0, 1, 0), dGeomSetPosition(sphere, 0, 0, 1);
    dGeomTransformSetGeom(outer, inner), dGeomTransformSetGeom(inner, sphere);
    dGeomTransformSetCleanup(outer, 1), dGeomTransformSetCleanup(inner, 1);
    dGeomSetPosition(probe, 1, 1, 2);
    dContactGeom c[1];
    ASSERT_EQ(collide(outer, probe, c, 1), 1);
    EXPECT_NEAR(c[0].depth, 1, 1e-6);
    EXPECT_EQ(c[0].g1, sphere);
    dGeomTransformSetInfo(outer, 1);
    ASSERT_EQ(collide(outer, probe, c, 1), 1);
    EXPECT_EQ(c[0].g1, outer);
    dGeomDestroy(outer);
    EXPECT_EQ(messages.take(), "");
    (void)dGeomSphereGetRadius(sphere);
    EXPECT_NE(messages.take(), "") << "cleaned up two levels down";
    dGeomDestroy(probe);
}

// ---- helpers on plain numbers ----

TEST(CollisionHelpers, boxes_that_overlap_touch_and_have_contacts)
{
    const dVector3 p1 = {0, 0, 0}, p2 = {dReal(0.1), dReal(0.2), dReal(0.9)}, side = {1, 1, 1},
                   far = {0, 0, 2};
    const dMatrix3 R = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    EXPECT_EQ(dBoxTouchesBox(p1, R, side, p2, R, side), 1);
    EXPECT_EQ(dBoxTouchesBox(p1, R, side, far, R, side), 0);
    dVector3 normal;
    dReal depth = 0;
    int code = 0;
    dContactGeom c[8];
    ASSERT_EQ(dBoxBox(p1, R, side, p2, R, side, normal, &depth, &code, 8, c, kStride), 4);
    EXPECT_NEAR(normal[2], 1, 1e-6) << "from box 1 to box 2";
    EXPECT_NEAR(depth, 0.1, 1e-6);
    EXPECT_TRUE(code == 3 || code == 6) << code;
    EXPECT_EQ(dBoxBox(p1, R, side, p2, R, side, normal, &depth, &code, 2, c, kStride), 2);
    EXPECT_EQ(dBoxBox(p1, R, side, far, R, side, normal, &depth, &code, 8, c, kStride), 0);
}

TEST(CollisionHelpers, closest_points_of_crossing_segments_lie_over_each_other)
{
    const dVector3 a1 = {-1, 0, 0}, a2 = {1, 0, 0}, b1 = {dReal(0.5), -1, 2}, b2 = {dReal(0.5), 3, 2};
    dVector3 p, q;
    dClosestLineSegmentPoints(a1, a2, b1, b2, p, q);
    EXPECT_NEAR(p[0], 0.5, 1e-6);
    EXPECT_NEAR(q[0], 0.5, 1e-6);
    EXPECT_NEAR(p[2], 0, 1e-6);
    EXPECT_NEAR(q[1], 0, 1e-6);
    EXPECT_NEAR(q[2], 2, 1e-6);
}

TEST(CollisionHelpers, low_level_control_of_a_class_without_controls_does_nothing)
{
    dGeomID g = dCreateSphere(nullptr, 1);
    int value = 7, size = sizeof value;
    EXPECT_EQ(dGeomLowLevelControl(g, dGeomColliderControlClass, 1, &value, &size), 0);
    EXPECT_EQ(size, 0);
    EXPECT_EQ(value, 7);
    dGeomDestroy(g);
}

}  // namespace
