// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies, joints, groups, geoms, spaces and worlds are destroyed in each of the 720 orders of the six kinds,
// once without and once with spaces and transforms that take their contents along. After each kind every
// handle that is left names objects that are alive, those that are gone are refused, and at the end no block
// is held.
#include <algorithm>

#include "heap.h"

namespace epode::memory {
namespace {

enum Kind { kBodies, kJoints, kGroups, kGeoms, kSpaces, kWorlds, kKinds };

struct Objects {
    std::vector<dWorldID> worlds;
    std::vector<dBodyID> bodies;
    std::vector<dJointID> joints;
    std::vector<dJointGroupID> groups;
    std::vector<dGeomID> geoms;
    std::vector<dSpaceID> spaces;
};

template <typename Call>
bool refused(Call&& call)
{
    const int before = messages();
    call();
    return messages() != before;
}

void touch(void* data, dGeomID a, dGeomID b)
{
    auto& objects = *static_cast<Objects*>(data);
    dContact contact[4];
    const int n = dCollide(a, b, 4, &contact[0].geom, sizeof contact[0]);
    for (int i = 0; i < n; ++i) {
        contact[i].surface = {};
        dBodyID one = dGeomGetBody(a), two = dGeomGetBody(b);
        if ((!one && !two) || (one && two && dBodyGetWorld(one) != dBodyGetWorld(two))) continue;
        dWorldID world = dBodyGetWorld(one ? one : two);
        objects.joints.push_back(dJointCreateContact(world, objects.groups[0], &contact[i]));
        dJointAttach(objects.joints.back(), one, two);
    }
}

Objects build(bool take_along)
{
    Objects t;
    for (int w = 0; w < 2; ++w) t.worlds.push_back(dWorldCreate());
    for (int g = 0; g < 2; ++g) t.groups.push_back(dJointGroupCreate(0));
    t.spaces = {dHashSpaceCreate(nullptr)};
    t.spaces.push_back(dSimpleSpaceCreate(t.spaces[0]));
    t.spaces.push_back(dSimpleSpaceCreate(t.spaces[1]));
    for (dSpaceID s : t.spaces) dSpaceSetCleanup(s, take_along);
    for (int i = 0; i < 6; ++i) {
        t.bodies.push_back(dBodyCreate(t.worlds[std::size_t(i % 2)]));
        dBodySetPosition(t.bodies.back(), dReal(0.4 * i), 0, dReal(0.3));
        t.geoms.push_back(i % 2 ? dCreateSphere(t.spaces[std::size_t(i % 3)], dReal(0.5))
                                : dCreateBox(t.spaces[std::size_t(i % 3)], 1, 1, 1));
        dGeomSetBody(t.geoms.back(), t.bodies.back());
        if (i % 3 == 1) dGeomSetOffsetPosition(t.geoms.back(), dReal(0.1), 0, 0);
        const dJointGroupID group = i % 3 ? t.groups[std::size_t(i % 2)] : nullptr;
        t.joints.push_back(dJointCreateHinge(t.worlds[std::size_t(i % 2)], group));
        dJointAttach(t.joints.back(), t.bodies.back(), i < 2 ? nullptr : t.bodies[std::size_t(i - 2)]);
    }
    t.geoms.push_back(dCreatePlane(t.spaces[0], 0, 0, 1, 0));
    dGeomID inner = dCreateCapsule(nullptr, dReal(0.2), 1), transform = dCreateGeomTransform(t.spaces[1]);
    dGeomTransformSetGeom(transform, inner);
    dGeomTransformSetCleanup(transform, take_along);
    dGeomSetBody(transform, t.bodies[0]);
    t.geoms.push_back(transform), t.geoms.push_back(inner);
    dSpaceCollide(t.spaces[0], &t, &touch);
    for (dWorldID w : t.worlds) {
        dWorldStep(w, dReal(0.01));
        dWorldQuickStep(w, dReal(0.01));
    }
    return t;
}

template <typename Id, typename Destroy>
void destroy_all(const std::vector<Id>& all, bool backwards, Destroy&& destroy)
{
    for (std::size_t i = 0; i < all.size(); ++i) destroy(all[backwards ? all.size() - 1 - i : i]);
}

void destroy(const Objects& t, Kind kind, bool backwards)
{
    switch (kind) {
        case kBodies:
            return destroy_all(t.bodies, backwards, dBodyDestroy);
        case kJoints:
            return destroy_all(t.joints, backwards, dJointDestroy);
        case kGroups:
            return destroy_all(t.groups, backwards, dJointGroupDestroy);
        case kGeoms:
            return destroy_all(t.geoms, backwards, dGeomDestroy);
        case kSpaces:
            return destroy_all(t.spaces, backwards, dSpaceDestroy);
        default:
            return destroy_all(t.worlds, backwards, dWorldDestroy);
    }
}

template <typename Id>
bool among(const std::vector<Id>& all, Id one)
{
    return std::find(all.begin(), all.end(), one) != all.end();
}

// Whatever still answers names only objects that answer.
void expect_no_dangling(const Objects& t)
{
    const auto lives = [&](dBodyID b) { return !refused([&] { dBodyIsEnabled(b); }); };
    for (dBodyID b : t.bodies) {
        if (!lives(b)) continue;
        EXPECT_TRUE(among(t.worlds, dBodyGetWorld(b)));
        for (int i = dBodyGetNumJoints(b); i-- > 0;) {
            const dJointID joint = dBodyGetJoint(b, i);
            EXPECT_TRUE(dJointGetBody(joint, 0) == b || dJointGetBody(joint, 1) == b);
        }
        for (dGeomID g = dBodyGetFirstGeom(b); g; g = dBodyGetNextGeom(g)) EXPECT_EQ(dGeomGetBody(g), b);
    }
    for (dJointID j : t.joints) {
        if (refused([&] { dJointGetType(j); })) continue;
        for (int i = 0; i < 2; ++i)
            if (dBodyID b = dJointGetBody(j, i)) { EXPECT_TRUE(lives(b)); }
    }
    for (dGeomID g : t.geoms) {
        if (refused([&] { dGeomGetClass(g); })) continue;
        if (dBodyID b = dGeomGetBody(g)) { EXPECT_TRUE(lives(b)); }
        if (dSpaceID s = dGeomGetSpace(g)) { EXPECT_TRUE(dSpaceQuery(s, g)); }
    }
    for (dSpaceID s : t.spaces) {
        if (refused([&] { dSpaceGetNumGeoms(s); })) continue;
        for (int i = dSpaceGetNumGeoms(s); i-- > 0;) EXPECT_EQ(dGeomGetSpace(dSpaceGetGeom(s, i)), s);
    }
    for (dWorldID w : t.worlds) dWorldStepFast1(w, dReal(0.01), 2);
}

void expect_all_gone(const Objects& t)
{
    for (dBodyID b : t.bodies) EXPECT_TRUE(refused([&] { dBodyDestroy(b); }));
    for (dJointID j : t.joints) EXPECT_TRUE(refused([&] { dJointDestroy(j); }));
    for (dGeomID g : t.geoms) EXPECT_TRUE(refused([&] { dGeomDestroy(g); }));
    for (dSpaceID s : t.spaces) EXPECT_TRUE(refused([&] { dSpaceDestroy(s); }));
    for (dWorldID w : t.worlds) EXPECT_TRUE(refused([&] { dWorldDestroy(w); }));
}

TEST(Teardown, every_order_of_kinds_gives_everything_back)
{
    int order[kKinds];
    for (int i = 0; i < kKinds; ++i) order[i] = i;
    int orders = 0;
    do {
        for (bool take_along : {false, true}) {
            const Library library;
            const Objects t = build(take_along);
            for (int kind : order) {
                destroy(t, Kind(kind), orders % 2 != 0);
                expect_no_dangling(t);
            }
            expect_all_gone(t);
        }
        ++orders;
    } while (std::next_permutation(order, order + kKinds) && !HasFailure());
    EXPECT_EQ(orders, 720);
}

// Many times over: what is held between two rounds does not grow, also where nobody closes the library.
TEST(Teardown, rounds_without_a_close_hold_no_more_from_round_to_round)
{
    const Library library;
    long after_two = 0;
    for (int round = 0; round < 50; ++round) {
        const Objects t = build(round % 2 != 0);
        for (Kind kind : {kGeoms, kSpaces, kGroups, kJoints, kBodies, kWorlds}) destroy(t, kind, false);
        if (round == 1) after_two = Heap::held();
    }
    EXPECT_EQ(Heap::held(), after_two);
}

}  // namespace
}  // namespace epode::memory
