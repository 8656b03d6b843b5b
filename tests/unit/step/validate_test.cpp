// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every invariant can fail: each test breaks one of a world that is in order, and finds it reported.
#include "step/validate.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "contacts/resting_pairs.h"
#include "dynamics/active.h"
#include "dynamics/island.h"
#include "ode/contacts.h"
#include "ode/ext.h"
#include "ode/ode.h"
#include "solve/common/colours.h"
#include "step/step.h"

namespace epode {
namespace {

std::string said(const char* fault) { return fault ? fault : "nothing"; }

// For the time of a scope something has another value.
template <typename T>
class Broken {
  public:
    Broken(T& value, T other) : value_(value), before_(std::exchange(value, other)) {}
    Broken(const Broken&) = delete;
    Broken& operator=(const Broken&) = delete;
    ~Broken() { value_ = before_; }

  private:
    T& value_;
    T before_;
};
template <typename T>
Broken(T&, auto) -> Broken<T>;

// Five boxes in a space that the world keeps apart, on a plane, two of them hinged; a sixth far away asleep.
class Validate : public testing::Test {
  protected:
    void SetUp() override
    {
        dWorldSetGravity(id, 0, 0, dReal(-9.81));
        dWorldSetContactSpace(id, space_id);
        dCreatePlane(space_id, 0, 0, 1, 0);
        for (int i = 0; i < 6; ++i) {
            bodies[i] = dBodyCreate(id);
            dBodySetPosition(bodies[i], dReal(i == 5 ? 100 : dReal(1.01) * i), 0, dReal(0.5));
            geoms[i] = dCreateBox(space_id, 1, 1, 1);
            dGeomSetBody(geoms[i], bodies[i]);
        }
        for (int i = 0; i < 2; ++i) {
            joints[i] = dJointCreateHinge(id, nullptr);
            dJointAttach(joints[i], bodies[0], bodies[i + 1]);
        }
        for (int i = 0; i < 20; ++i) dWorldStep(id, dReal(0.01));
        ASSERT_EQ(said(fault_of(world())), "nothing");
        ASSERT_EQ(said(fault_of(space())), "nothing");
    }
    void TearDown() override
    {
        EXPECT_EQ(said(fault_of(world())), "nothing") << "what was broken has been mended";
        dWorldDestroy(id);
        dSpaceDestroy(space_id);
    }

    World& world() const { return *from_handle<World>(id); }
    Space& space() const { return *space_from(space_id); }
    Body& body(int i) const { return *from_handle<Body>(bodies[i]); }
    Geom& geom(int i) const { return *from_handle<Geom>(geoms[i]); }
    Joint& joint(int i) const { return *from_handle<Joint>(joints[i]); }
    std::string fault() const { return said(fault_of(world())); }

    dWorldID id = dWorldCreate();
    dSpaceID space_id = dHashSpaceCreate(nullptr);
    dBodyID bodies[6];
    dGeomID geoms[6];
    dJointID joints[2];
};

TEST_F(Validate, finds_numbers_that_are_not_finite)
{
    {
        const Broken broken(body(1).pos[2], kInf);
        EXPECT_EQ(fault(), "body: its pose is not finite");
    }
    {
        const Broken broken(body(1).avel[0], std::numeric_limits<Real>::quiet_NaN());
        EXPECT_EQ(fault(), "body: its velocity is not finite");
    }
    {
        const Broken broken(body(2).q[0], Real(2));
        EXPECT_EQ(fault(), "body: its quaternion is not of unit length");
    }
    const Broken broken(body(2).inv_mass, Real(0));
    EXPECT_EQ(fault(), "body: its inverse mass is wrong");
}

TEST_F(Validate, finds_rosters_that_disagree_with_their_members)
{
    const Broken broken(body(3).place, 0);
    EXPECT_EQ(fault(), "roster: a member stands in another place than it knows");
}

TEST_F(Validate, finds_broken_lists_of_joints)
{
    JointNode& node = joint(0).node[0];
    {
        const Broken broken(node.body, &body(4));
        EXPECT_EQ(fault(), "body: a joint in its list is attached elsewhere");
    }
    {
        const Broken broken(node.prev, &joint(1).node[1]);
        EXPECT_EQ(fault(), "body: its list of joints does not lead back");
    }
    {
        const Broken broken(body(0).lasting, static_cast<JointNode*>(nullptr));
        EXPECT_EQ(fault(), "body: the first joint that is no contact is another");
    }
    {
        const Broken broken(body(1).joints, static_cast<JointNode*>(nullptr));
        const Broken also(body(1).lasting, static_cast<JointNode*>(nullptr));
        EXPECT_EQ(fault(), "joint: its body does not know it");
    }
    const Broken broken(joint(1).world, static_cast<World*>(nullptr));
    EXPECT_EQ(fault(), "nothing") << "a joint may outlive its world in a group";
}

TEST_F(Validate, finds_what_is_awake_and_not_active)
{
    world().bodies.deactivate(body(5));
    EXPECT_EQ(fault(), "body: it is awake and not active");
    world().bodies.activate(body(5));
    world().joints.deactivate(joint(0));
    EXPECT_EQ(fault(), "body: it is active and its joint is not");
    world().joints.activate(joint(0));
}

TEST_F(Validate, finds_geoms_that_disagree_with_bodies_and_spaces)
{
    {
        const Broken broken(geom(2).body.id, bodies[3]);
        EXPECT_EQ(fault(), "body: a geom in its list is on another");
    }
    {
        const Broken broken(geom(2).position, static_cast<const Real*>(body(3).pos));
        EXPECT_EQ(fault(), "geom: it does not share its body's pose");
    }
    {
        const Broken broken(geom(2).slot, 0);
        EXPECT_EQ(fault(), "space: a member stands in another slot than it knows");
    }
    {
        const Broken broken(geom(2).space, static_cast<Space*>(nullptr));
        EXPECT_EQ(fault(), "space: a member is in another one");
    }
    const Broken broken(space().count, 9);
    EXPECT_EQ(fault(), "space: the count of members is wrong");
}

TEST_F(Validate, finds_boxes_that_are_not_true)
{
    clean(space());
    ASSERT_EQ(fault(), "nothing");
    {
        const Broken broken(geom(1).box.hi.z, Real(70));
        EXPECT_EQ(fault(), "space: a member that has not moved has another box than the broadphase");
    }
    const Broken broken(const_cast<Aabb&>(space().broadphase.way(geom(1).slot)).lo.x, Real(70));
    EXPECT_EQ(fault(), "broadphase: a box lies outside of what is expected of it");
}

TEST_F(Validate, finds_pairs_out_of_order)
{
    ASSERT_TRUE(space().broadphase.find_pairs());  // steps of so few geoms try all pairs
    const std::span<const SlotPair> pairs = space().broadphase.pairs();
    ASSERT_GT(pairs.size(), 1u);
    SlotPair& first = const_cast<SlotPair&>(pairs[0]);
    {
        const Broken broken(first, pairs[1]);
        EXPECT_EQ(fault(), "broadphase: pairs are not in order");
    }
    const Broken broken(first, SlotPair{1, 1});
    EXPECT_EQ(fault(), "broadphase: a pair of slots that are none");
}

// Pairs of geoms 1-2, 2-3 ..., each with a manifold of one point.
PairList chain_of_pairs(int count)
{
    PairList list;
    for (int i = 0; i < count; ++i) {
        CachedManifold kept{};
        kept.manifold.count = 1, kept.manifold.normal = {0, 0, 1};
        ContactPair pair{};
        pair.id1 = pair.id2 = dGeomID(&list);
        pair.serial1 = std::uint64_t(i) + 1, pair.serial2 = std::uint64_t(i) + 2;
        pair.first = i, pair.count = 1;
        EXPECT_TRUE(list.manifolds.push(kept) && list.pairs.push(pair));
    }
    return list;
}

TEST(Invariants, of_contact_pairs)
{
    PairList list = chain_of_pairs(2);
    ContactPair& pair = list.pairs[1];
    ContactManifold& manifold = list.manifolds[1].manifold;
    ASSERT_EQ(list.fault(pair), nullptr);
    {
        const Broken broken(pair.first, 2);
        EXPECT_EQ(said(list.fault(pair)), "contacts: a pair's manifolds are not in its list");
    }
    {
        const Broken broken(pair.count, std::uint8_t(kSurfaceManifolds + 1));
        EXPECT_EQ(said(list.fault(pair)), "contacts: a pair has more manifolds than it may");
    }
    {
        const Broken broken(manifold.count, kManifoldPoints + 1);
        EXPECT_EQ(said(list.fault(pair)), "contacts: a manifold's count is wrong");
    }
    {
        const Broken broken(manifold.points[0].normal_impulse, -1.0f);
        EXPECT_EQ(said(list.fault(pair)), "contacts: a normal impulse pulls");
    }
    const Broken broken(manifold.normal.z, 0.5f);
    EXPECT_EQ(said(list.fault(pair)), "contacts: a normal is not of unit length");
}

TEST(Invariants, of_resting_pairs)
{
    PairList list = chain_of_pairs(4);
    RestingPairs resting;
    ASSERT_TRUE(resting.put(list, [](const ContactPair&) { return true; }));
    ASSERT_EQ(resting.fault(), nullptr);
    ContactPair* inside[4] = {};
    int count = 0;
    resting.for_each(
        [&](const ContactPair& pair, auto) { inside[count++] = const_cast<ContactPair*>(&pair); });
    {
        const Broken broken(inside[1]->serial1, std::uint64_t(77));
        EXPECT_EQ(said(resting.fault()), "resting pairs: a list of a geom's pairs is broken");
    }
    const Broken broken(inside[1]->id1, static_cast<dGeomID>(nullptr));
    EXPECT_EQ(said(resting.fault()), "resting pairs: the count is wrong");
}

TEST_F(Validate, finds_points_of_the_contact_cache_that_are_used_between_steps)
{
    ContactCache cache;
    JointManifold manifold{};
    manifold.n = {0, 0, 1}, manifold.t1 = {1, 0, 0}, manifold.t2 = {0, 1, 0};
    const auto step = [&](bool ends) {
        JointManifoldPoint point{};
        point.r1 = {0, 0, Real(-0.5)};
        ASSERT_TRUE(cache.begin(1, 1));
        cache.load(0, 0, body(0), nullptr, manifold, {&point, 1}, 1, 1);
        if (ends) cache.end(1);
    };
    step(true);
    ASSERT_EQ(cache.fault(), nullptr);
    step(false);
    EXPECT_EQ(said(cache.fault()), "contact cache: a point is used between steps");
    cache.take_back();
    EXPECT_EQ(cache.fault(), nullptr);
}

TEST_F(Validate, finds_islands_that_are_no_partition)
{
    Arena arena;
    Islands found;
    ASSERT_TRUE(find_islands(world(), dReal(0.01), {}, arena, found));
    const auto fault_of_islands = [&] { return said(fault_of(world(), found, arena)); };
    ASSERT_EQ(fault_of_islands(), "nothing");
    ASSERT_GT(found.all.size(), 2u);
    {
        const Broken broken(found.all, found.all.subspan(1));
        EXPECT_EQ(fault_of_islands(), "islands: a body that is awake is in none of them");
    }
    {
        Body* held[] = {found.all[0].bodies[0]};
        const Broken broken(found.asleep, std::span<Body*>(held));
        EXPECT_EQ(fault_of_islands(), "islands: a body falls asleep and is in an island");
    }
    for (Island& island : found.all)
        if (island.bodies.size() > 1) {
            const Broken broken(island.bodies[0], island.bodies[1]);
            EXPECT_EQ(fault_of_islands(), "islands: a body is in two of them, or not active");
        }
    for (Island& island : found.all)
        if (!island.joints.empty()) {
            const Broken broken(joint(0).node[1].body, &body(5));
            const Broken other(joint(1).node[1].body, &body(5));
            EXPECT_EQ(fault_of_islands(), "islands: a joint leads out of its island");
        }
}

TEST(Invariants, of_colours_that_share_no_body)
{
    Arena arena;
    const int ends[3][2] = {{0, 1}, {1, 2}, {2, -1}};
    const auto body = [&](std::size_t i, int side) { return ends[i][side]; };
    int colours[3] = {0, 1, 0};
    EXPECT_TRUE(disjoint(colours, body, arena));
    colours[2] = 1;
    EXPECT_FALSE(disjoint(colours, body, arena));
}

}  // namespace
}  // namespace epode
