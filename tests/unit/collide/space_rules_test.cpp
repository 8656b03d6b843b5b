// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Membership, locks, nesting, cleaning and the end of spaces.
#include <gtest/gtest.h>

#include "../api/message_recorder.h"
#include "space_scene.h"

namespace {

using Box6 = std::vector<dReal>;

Box6 box_of(dGeomID g)
{
    Box6 box(6);
    dGeomGetAABB(g, box.data());
    return box;
}

TEST(Space, refuses_wrong_membership_in_odes_words)
{
    MessageRecorder messages;
    dSpaceID a = dSimpleSpaceCreate(nullptr), b = dHashSpaceCreate(nullptr);
    dGeomID g = dCreateSphere(a, 1);
    dSpaceAdd(b, g);
    EXPECT_EQ(messages.take(), "2: geom is already in a space in dSpaceAdd()");
    EXPECT_EQ(dGeomGetSpace(g), a);
    dSpaceRemove(b, g);
    EXPECT_EQ(messages.take(), "2: object is not in this space in dSpaceRemove()");
    EXPECT_EQ(dSpaceGetGeom(a, 1), nullptr);
    EXPECT_EQ(messages.take(), "2: index out of range in dSpaceGetGeom()");
    EXPECT_EQ(dSpaceGetNumGeoms(reinterpret_cast<dSpaceID>(g)), 0);
    EXPECT_EQ(messages.take(), "2: argument not a space in dSpaceGetNumGeoms()");
    EXPECT_EQ(dSpaceQuery(a, g), 1);
    EXPECT_EQ(dSpaceQuery(b, g), 0);
    EXPECT_EQ(messages.take(), "");
    dSpaceDestroy(a);
    dSpaceDestroy(b);
}

TEST(Space, cannot_be_put_inside_itself_at_any_depth)
{
    MessageRecorder messages;
    dSpaceID outer = dSimpleSpaceCreate(nullptr), inner = dHashSpaceCreate(outer);
    dSpaceAdd(outer, as_geom(outer));
    EXPECT_NE(messages.take(), "");
    dSpaceAdd(inner, as_geom(outer));
    EXPECT_NE(messages.take(), "");
    EXPECT_EQ(dGeomGetSpace(as_geom(outer)), nullptr);
    dSpaceDestroy(outer);
}

TEST(Space, levels_are_kept_and_checked)
{
    MessageRecorder messages;
    dSpaceID hash = dHashSpaceCreate(nullptr), simple = dSimpleSpaceCreate(nullptr);
    int lo = 0, hi = 0;
    dHashSpaceGetLevels(hash, &lo, &hi);
    EXPECT_EQ(lo, -3);
    EXPECT_EQ(hi, 10);
    dHashSpaceSetLevels(hash, 2, 1);
    EXPECT_EQ(messages.take(), "2: must have minlevel <= maxlevel in dHashSpaceSetLevels()");
    dHashSpaceSetLevels(simple, 1, 2);
    EXPECT_EQ(messages.take(), "2: argument must be a hash space in dHashSpaceSetLevels()");
    dHashSpaceSetLevels(hash, -5, 5);
    dHashSpaceGetLevels(hash, &lo, nullptr);
    dHashSpaceGetLevels(hash, nullptr, &hi);
    EXPECT_EQ(lo, -5);
    EXPECT_EQ(hi, 5);
    dSpaceDestroy(hash);
    dSpaceDestroy(simple);
}

TEST(Space, cleanup_destroys_members_and_letting_go_keeps_them)
{
    MessageRecorder messages;
    dSpaceID space = dHashSpaceCreate(nullptr);
    EXPECT_EQ(dSpaceGetCleanup(space), 1);
    dGeomID g = dCreateSphere(space, 1);
    dSpaceSetCleanup(space, 0);
    dSpaceDestroy(space);
    EXPECT_EQ(dGeomGetSpace(g), nullptr);
    EXPECT_EQ(dGeomSphereGetRadius(g), 1);
    EXPECT_EQ(messages.take(), "");
    dSpaceID second = dHashSpaceCreate(nullptr);
    dSpaceAdd(second, g);
    dSpaceDestroy(second);
    (void)dGeomSphereGetRadius(g);
    EXPECT_NE(messages.take(), "") << "the geom should be gone";
}

struct LockProbe {
    MessageRecorder* messages;
    dSpaceID space;
    dGeomID member;
    dBodyID body;
    int calls = 0;
};

void try_everything(void* data, dGeomID, dGeomID)
{
    auto& p = *static_cast<LockProbe*>(data);
    if (p.calls++) return;
    const dMatrix3 R = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    const dQuaternion q = {1, 0, 0, 0};
    int refused = 0;
    const auto expect_refused = [&](const char* name) {
        ++refused;
        EXPECT_EQ(p.messages->take(), std::string("2: Invalid operation for locked space in ") + name + "()");
    };
    dGeomID loner = dCreateSphere(nullptr, 1);
    dSpaceAdd(p.space, loner), expect_refused("dSpaceAdd");
    dSpaceRemove(p.space, p.member), expect_refused("dSpaceRemove");
    dGeomDestroy(p.member), expect_refused("dGeomDestroy");
    dSpaceDestroy(p.space), expect_refused("dSpaceDestroy");
    dGeomSetPosition(p.member, 9, 9, 9), expect_refused("dGeomSetPosition");
    dGeomSetRotation(p.member, R), expect_refused("dGeomSetRotation");
    dGeomSetQuaternion(p.member, q), expect_refused("dGeomSetQuaternion");
    dGeomSetBody(p.member, nullptr), expect_refused("dGeomSetBody");
    dGeomSetOffsetPosition(p.member, 1, 0, 0), expect_refused("dGeomSetOffsetPosition");
    dGeomSetCategoryBits(p.member, 0), expect_refused("dGeomSetCategoryBits");
    dGeomSetCollideBits(p.member, 0), expect_refused("dGeomSetCollideBits");
    dGeomSphereSetRadius(p.member, 7), expect_refused("dGeomSphereSetRadius");
    dBodySetPosition(p.body, 9, 9, 9), expect_refused("dBodySetPosition");
    EXPECT_EQ(dCreateSphere(p.space, 1), nullptr);
    expect_refused("dCreateSphere");
    EXPECT_EQ(refused, 14);
    // Allowed: other geoms, reading, enabling, data, further collisions.
    dGeomSetPosition(loner, 1, 2, 3);
    dGeomDestroy(loner);
    dGeomSetData(p.member, &p);
    dGeomDisable(p.member);
    dGeomEnable(p.member);
    (void)box_of(p.member);
    dContactGeom contact;
    (void)dCollide(p.member, dSpaceGetGeom(p.space, 0), 1, &contact, sizeof contact);
    EXPECT_EQ(pairs_in(p.space), brute_force(p.space));
    EXPECT_EQ(p.messages->take(), "");
}

TEST(Space, refuses_changes_while_it_is_collided_and_takes_them_afterwards)
{
    MessageRecorder messages;
    dWorldID world = dWorldCreate();
    LockProbe probe{&messages, dHashSpaceCreate(nullptr), nullptr, dBodyCreate(world)};
    probe.member = dCreateSphere(probe.space, 1);
    dGeomSetBody(probe.member, probe.body);
    (void)dCreateSphere(probe.space, 1);
    (void)dCreateSphere(probe.space, 1);
    dSpaceCollide(probe.space, &probe, try_everything);
    EXPECT_EQ(probe.calls, 3);
    EXPECT_EQ(dGeomSphereGetRadius(probe.member), 1);
    EXPECT_EQ(dGeomGetPosition(probe.member)[0], 0);
    EXPECT_EQ(dGeomGetBody(probe.member), probe.body);
    probe.calls = 0;
    dGeomID outside = dCreateSphere(nullptr, 1);
    dSpaceCollide2(outside, as_geom(probe.space), &probe, try_everything);
    EXPECT_EQ(probe.calls, 3);
    dGeomSetPosition(probe.member, 9, 9, 9);
    dGeomSetCategoryBits(probe.member, 3);
    EXPECT_EQ(dBodyGetPosition(probe.body)[0], 9);
    EXPECT_EQ(messages.take(), "");
    dGeomDestroy(outside);
    dSpaceDestroy(probe.space);
    dWorldDestroy(world);
}

TEST(Space, destruction_is_refused_while_a_space_inside_is_locked)
{
    MessageRecorder messages;
    dSpaceID outer = dSimpleSpaceCreate(nullptr), inner = dHashSpaceCreate(outer);
    (void)dCreateSphere(inner, 1);
    (void)dCreateSphere(inner, 1);
    dSpaceCollide(inner, outer,
                  [](void* data, dGeomID, dGeomID) { dSpaceDestroy(static_cast<dSpaceID>(data)); });
    EXPECT_EQ(messages.take(), "2: Invalid operation for locked space in dSpaceDestroy()");
    EXPECT_EQ(dSpaceGetNumGeoms(inner), 2);
    dSpaceDestroy(outer);
}

TEST(Space, nested_in_another_is_reported_as_a_geom_with_the_box_of_its_members)
{
    dSpaceID outer = dHashSpaceCreate(nullptr), inner = dSimpleSpaceCreate(outer);
    EXPECT_EQ(box_of(as_geom(inner)), Box6(6, dReal(0)));
    dGeomID a = dCreateSphere(inner, 1), b = dCreateSphere(inner, 1), c = dCreateSphere(outer, 1);
    dGeomSetPosition(a, 5, 0, 0);
    dGeomSetPosition(b, 0, 5, 0);
    EXPECT_EQ(box_of(as_geom(inner)), (Box6{-1, 6, -1, 6, -1, 1}));
    const PairList with_space = {{c, as_geom(inner)}};
    EXPECT_EQ(pairs_in(outer), with_space);
    dGeomSetPosition(c, 20, 0, 0);
    EXPECT_TRUE(pairs_in(outer).empty());
    dGeomSetPosition(a, 20, 0, 0);  // two levels down
    EXPECT_EQ(pairs_in(outer), with_space);
    EXPECT_EQ(pairs_across(as_geom(inner), c), (PairList{{a, c}}));
    dGeomSetCollideBits(as_geom(inner), 0);
    dGeomSetCategoryBits(as_geom(inner), 0);
    EXPECT_TRUE(pairs_in(outer).empty()) << "the space's own bits decide";
    dSpaceDestroy(outer);
}

TEST(Space, box_follows_a_member_asked_in_between)
{
    dSpaceID outer = dHashSpaceCreate(nullptr), middle = dHashSpaceCreate(outer),
             inner = dHashSpaceCreate(middle);
    dGeomID g = dCreateSphere(inner, 1);
    for (int i = 1; i < 20; ++i) {
        dGeomSetPosition(g, dReal(i), 0, 0);
        if (i % 2) (void)box_of(as_geom(inner));
        if (i % 3) (void)box_of(g);
        if (i % 5) (void)box_of(as_geom(middle));
        dGeomSetPosition(g, dReal(i), dReal(i), 0);
        ASSERT_EQ(box_of(as_geom(outer))[3], dReal(i + 1));
    }
    dSpaceDestroy(outer);
}

TEST(Space, of_higher_sublevel_is_opened_and_the_other_passed_whole)
{
    dSpaceID high = dHashSpaceCreate(nullptr), low = dSimpleSpaceCreate(nullptr);
    dGeomID a = dCreateSphere(high, 1), b = dCreateSphere(low, 1);
    dSpaceSetSublevel(high, 2);
    dSpaceSetSublevel(low, 1);
    EXPECT_EQ(dSpaceGetSublevel(high), 2);
    EXPECT_EQ(pairs_across(as_geom(high), as_geom(low)), (PairList{{a, as_geom(low)}}));
    EXPECT_EQ(pairs_across(as_geom(low), as_geom(high)), (PairList{{as_geom(low), a}}));
    dSpaceSetSublevel(low, 2);
    EXPECT_EQ(pairs_across(as_geom(low), as_geom(high)), (PairList{{b, a}}));
    dSpaceDestroy(high);
    dSpaceDestroy(low);
}

TEST(Space, does_not_pair_a_member_with_itself)
{
    dSpaceID space = dHashSpaceCreate(nullptr);
    dGeomID a = dCreateSphere(space, 1), b = dCreateSphere(space, 1);
    EXPECT_EQ(pairs_across(a, as_geom(space)), (PairList{{a, b}}));
    dSpaceDestroy(space);
}

TEST(Space, contacts_of_a_whole_space_are_appended_until_the_room_is_full)
{
    dSpaceID space = dHashSpaceCreate(nullptr);
    dGeomID floor = dCreatePlane(nullptr, 0, 0, 1, 0);
    dGeomID first = dCreateSphere(space, dReal(0.5)), second = dCreateSphere(space, dReal(0.5));
    dGeomSetPosition(first, 0, 0, dReal(0.4));
    dGeomSetPosition(second, 3, 0, dReal(0.3));
    dContactGeom c[4];
    ASSERT_EQ(dCollide(as_geom(space), floor, 4, c, sizeof c[0]), 2);
    EXPECT_EQ(c[0].g1, second);
    EXPECT_EQ(c[0].g2, floor);
    EXPECT_EQ(c[1].g1, first);
    EXPECT_GT(c[0].normal[2], 0);
    ASSERT_EQ(dCollide(floor, as_geom(space), 4, c, sizeof c[0]), 2);
    EXPECT_EQ(c[0].g1, floor);
    EXPECT_LT(c[0].normal[2], 0);
    EXPECT_EQ(dCollide(as_geom(space), floor, 1, c, sizeof c[0]), 1);
    EXPECT_EQ(dCollide(as_geom(space), as_geom(space), 4, c, sizeof c[0]), 0);
    dGeomDestroy(floor);
    dSpaceDestroy(space);
}

}  // namespace
