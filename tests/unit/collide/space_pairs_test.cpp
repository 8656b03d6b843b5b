// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which pairs spaces report, and in which order, against brute force through random histories.
#include <gtest/gtest.h>

#include <algorithm>

#include "../math/random_numbers.h"
#include "space_scene.h"

namespace epode {
namespace {

enum class Kind { kSimple, kHash, kSweep, kQuadTree };

dSpaceID make_space(Kind kind, dSpaceID parent = nullptr)
{
    const dVector3 centre = {0, 0, 0}, extents = {10, 10, 10};
    switch (kind) {
        case Kind::kSimple:
            return dSimpleSpaceCreate(parent);
        case Kind::kHash:
            return dHashSpaceCreate(parent);
        case Kind::kSweep:
            return dSweepAndPruneSpaceCreate(parent, dSAP_AXES_XZY);
        default:
            return dQuadTreeSpaceCreate(parent, centre, extents, 4);
    }
}

class SpacePairs : public testing::TestWithParam<Kind> {
  protected:
    ~SpacePairs() override { dSpaceDestroy(space); }
    dSpaceID space = make_space(GetParam());
};

INSTANTIATE_TEST_SUITE_P(all, SpacePairs,
                         testing::Values(Kind::kSimple, Kind::kHash, Kind::kSweep, Kind::kQuadTree));

dGeomID random_geom(RandomNumbers& random)
{
    switch (random.below(12)) {
        case 0:
            return dCreatePlane(nullptr, 0, random.in(-1, 1), 1, random.in(-3, 3));
        case 1:
            return dCreateBox(nullptr, 30, 30, 1);
        case 2:
            return dCreateBox(nullptr, Real(1e17), 1, 1);  // beyond the tree
        case 3:
            return dCreateRay(nullptr, random.in(-5, 20));
        case 4:
        case 5:
            return dCreateCapsule(nullptr, random.in(0, 1), random.in(0, 2));
        case 6:
        case 7:
            return dCreateBox(nullptr, random.in(0, 2), random.in(0, 2), random.in(0, 2));
        default:
            return dCreateSphere(nullptr, random.in(0, 1));
    }
}

bool placeable(dGeomID g) { return dGeomGetClass(g) != dPlaneClass && !dGeomIsSpace(g); }

void jog(dGeomID g, RandomNumbers& random, Real distance)
{
    if (!placeable(g)) return;
    const dReal* p = dGeomGetPosition(g);
    const Vec3 to = Vec3{p[0], p[1], p[2]} + distance * random.vec();
    dGeomSetPosition(g, to.x, to.y, to.z);
}

// One random change to one geom or to the membership.
void disturb(dSpaceID space, std::vector<dGeomID>& pool, RandomNumbers& random)
{
    const int i = random.below(int(pool.size()));
    dGeomID& g = pool[std::size_t(i)];
    switch (random.below(12)) {
        case 0:
            if (dGeomGetSpace(g)) dSpaceRemove(space, g);
            break;
        case 1:
            dGeomDestroy(g);
            g = random_geom(random);
            dSpaceAdd(space, g);
            break;
        case 2:
            if (dGeomIsEnabled(g))
                dGeomDisable(g);
            else
                dGeomEnable(g);
            break;
        case 3:
            dGeomSetCategoryBits(g, 1ul << random.below(3));
            dGeomSetCollideBits(g, 1ul << random.below(3));
            break;
        case 4:
            if (dGeomGetClass(g) == dSphereClass)
                dGeomSphereSetRadius(g, random.below(3) ? random.in(0, 2) : 0);
            break;
        case 5:
            jog(g, random, 8);
            break;
        default:
            jog(g, random, Real(0.1));
    }
    if (!dGeomGetSpace(g) && random.below(2)) dSpaceAdd(space, g);
}

TEST_P(SpacePairs, are_those_of_brute_force_whatever_has_happened_before)
{
    RandomNumbers random(77);
    std::vector<dGeomID> pool;
    for (int i = 0; i < 60; ++i) {
        pool.push_back(random_geom(random));
        jog(pool.back(), random, 6);
        dSpaceAdd(space, pool.back());
    }
    std::size_t seen = 0;
    for (int round = 0; round < 500; ++round) {
        const int changes = round % 7 == 0 ? 60 : random.below(6);
        for (int k = 0; k < changes; ++k) disturb(space, pool, random);
        const PairList expected = brute_force(space);
        ASSERT_EQ(pairs_in(space), expected) << "round " << round;
        ASSERT_EQ(pairs_in(space), expected) << "asked twice, round " << round;
        seen += expected.size();
    }
    EXPECT_GT(seen, 10000u);
    for (dGeomID g : pool)
        if (!dGeomGetSpace(g)) dGeomDestroy(g);
}

TEST_P(SpacePairs, of_a_geom_and_a_space_are_those_of_brute_force)
{
    RandomNumbers random(78);
    std::vector<dGeomID> pool;
    for (int i = 0; i < 50; ++i) {
        pool.push_back(random_geom(random));
        jog(pool.back(), random, 6);
        dSpaceAdd(space, pool.back());
    }
    dGeomID probe = dCreateBox(nullptr, 3, 3, 3);
    for (int round = 0; round < 200; ++round) {
        for (int k = 0; k < 3; ++k) disturb(space, pool, random);
        dGeomSetPosition(probe, random.in(-6, 6), random.in(-6, 6), random.in(-6, 6));
        PairList expected;
        for (dGeomID g : members_of(space))
            if (dGeomIsEnabled(g) && should_meet(probe, g)) expected.push_back({probe, g});
        ASSERT_EQ(pairs_across(probe, as_geom(space)), expected);
        for (auto& pair : expected) std::swap(pair.first, pair.second);
        ASSERT_EQ(pairs_across(as_geom(space), probe), expected);
    }
    dGeomDestroy(probe);
    for (dGeomID g : pool)
        if (!dGeomGetSpace(g)) dGeomDestroy(g);
}

TEST_P(SpacePairs, of_two_spaces_are_all_cross_pairs_with_sides_kept)
{
    RandomNumbers random(79);
    dSpaceID other = make_space(GetParam());
    for (int i = 0; i < 40; ++i) {
        dGeomID g = dCreateSphere(i % 3 ? space : other, 1);
        jog(g, random, 4);
        if (i % 5 == 0) dGeomDisable(g);
    }
    PairList expected;
    for (dGeomID a : members_of(space))
        for (dGeomID b : members_of(other))
            if (dGeomIsEnabled(a) && dGeomIsEnabled(b) && should_meet(a, b)) expected.push_back({a, b});
    PairList found = pairs_across(as_geom(space), as_geom(other));
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(found, expected);
    PairList turned = pairs_across(as_geom(other), as_geom(space));
    for (auto& pair : turned) std::swap(pair.first, pair.second);
    std::sort(turned.begin(), turned.end());
    EXPECT_EQ(turned, expected);
    EXPECT_EQ(pairs_across(as_geom(space), as_geom(space)), pairs_in(space));
    dSpaceDestroy(other);
}

TEST_P(SpacePairs, come_newest_first_and_motion_does_not_change_that)
{
    dGeomID a = dCreateSphere(space, 1), b = dCreateSphere(space, 1), c = dCreateSphere(space, 1);
    const PairList expected = {{c, b}, {c, a}, {b, a}};
    EXPECT_EQ(pairs_in(space), expected);
    EXPECT_EQ(members_of(space), (std::vector<dGeomID>{c, b, a}));
    dGeomSetPosition(a, Real(0.1), 0, 0);
    EXPECT_EQ(pairs_in(space), expected);
    EXPECT_EQ(members_of(space), (std::vector<dGeomID>{c, b, a}));
}

TEST_P(SpacePairs, are_found_one_way_by_bits)
{
    dGeomID a = dCreateSphere(space, 1), b = dCreateSphere(space, 1);
    dGeomSetCategoryBits(a, 1), dGeomSetCollideBits(a, 0);
    dGeomSetCategoryBits(b, 2), dGeomSetCollideBits(b, 1);
    EXPECT_EQ(pairs_in(space).size(), 1u);
    dGeomSetCollideBits(b, 4);
    EXPECT_TRUE(pairs_in(space).empty());
}

TEST_P(SpacePairs, touching_boxes_count)
{
    dGeomID a = dCreateBox(space, 1, 1, 1);
    (void)dCreateBox(space, 1, 1, 1);
    dGeomSetPosition(a, 1, 1, 1);
    EXPECT_EQ(pairs_in(space).size(), 1u);
    dGeomSetPosition(a, 1, 1, Real(1.001));
    EXPECT_TRUE(pairs_in(space).empty());
}

TEST_P(SpacePairs, of_many_joined_and_removed_in_any_order_stay_right)
{
    RandomNumbers random(80);
    for (int round = 0; round < 10; ++round) {
        for (int i = 0; i < 100; ++i) jog(dCreateBox(space, 1, 1, 1), random, 4);
        ASSERT_EQ(pairs_in(space), brute_force(space));
        for (int i = 0; i < 95; ++i)
            dGeomDestroy(dSpaceGetGeom(space, random.below(dSpaceGetNumGeoms(space))));
        ASSERT_EQ(pairs_in(space), brute_force(space));
    }
    while (dSpaceGetNumGeoms(space) > 0) dGeomDestroy(dSpaceGetGeom(space, 0));
    EXPECT_TRUE(pairs_in(space).empty());
    (void)dCreateBox(space, 1, 1, 1);
    (void)dCreateBox(space, 1, 1, 1);
    EXPECT_EQ(pairs_in(space).size(), 1u);
}

// Allocation that can be made to fail.
bool g_no_memory = false;
void* failing_alloc(dsizeint size) { return g_no_memory ? nullptr : std::malloc(size); }
void plain_free(void* p, dsizeint) { std::free(p); }

TEST_P(SpacePairs, are_found_without_memory_for_the_search)
{
    dSetAllocHandler(failing_alloc);
    dSetFreeHandler(plain_free);
    RandomNumbers random(81);
    for (int i = 0; i < 100; ++i) jog(dCreateBox(space, 1, 1, 1), random, 3);
    const PairList expected = brute_force(space);
    PairList found;
    found.reserve(5000);
    g_no_memory = true;
    dSpaceCollide(space, &found, record_pair);
    g_no_memory = false;
    EXPECT_EQ(found, expected);
    EXPECT_EQ(pairs_in(space), expected);
    while (dSpaceGetNumGeoms(space) > 0) dGeomDestroy(dSpaceGetGeom(space, 0));
    dSetAllocHandler(nullptr);
    dSetFreeHandler(nullptr);
}

}  // namespace
}  // namespace epode
