// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Geoms of the same points have one polyhedron, others their own, and nobody sees a difference.
#include "collide/shared_solid.h"

#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <cstdlib>
#include <thread>
#include <vector>

#include "../math/random_numbers.h"
#include "collide/types/registry.h"

namespace epode::test {
namespace {

using Points = std::vector<dReal>;

Points rock(std::uint64_t key, int corners = 12)
{
    RandomNumbers random(key);
    Points out;
    for (int i = 0; i < corners; ++i) {
        const Vec3 p = random.direction();
        out.insert(out.end(), {p.x, p.y, p.z});
    }
    return out;
}

dGeomID geom_of(const Points& points)
{
    return dCreateConvexHull(nullptr, points.data(), unsigned(points.size() / 3), 0);
}

const Polyhedron* solid_of(dGeomID id) { return geom_as<Convex>(id)->shape.solid; }

Points points_of(dGeomID id)
{
    Points out(std::size_t(3 * dGeomConvexGetPoints(id, nullptr, 0)));
    dGeomConvexGetPoints(id, out.data(), int(out.size() / 3));
    return out;
}

class SharedSolids : public testing::Test {
  protected:
    SharedSolids() { dInitODE(); }
    ~SharedSolids() override { dCloseODE(); }
};

TEST_F(SharedSolids, are_those_of_the_same_points)
{
    const Points points = rock(1);
    dGeomID a = geom_of(points), b = geom_of(points), other = geom_of(rock(2));
    EXPECT_EQ(solid_of(a), solid_of(b));
    EXPECT_NE(solid_of(a), solid_of(other));
    Points shifted = points;
    for (std::size_t i = 0; i < shifted.size(); i += 3) shifted[i] += 8;  // the same about another middle
    dGeomID apart = geom_of(shifted);
    EXPECT_NE(solid_of(a), solid_of(apart));
    for (dGeomID g : {a, b, other, apart}) dGeomDestroy(g);
}

TEST_F(SharedSolids, stay_with_the_others_when_one_is_given_other_points)
{
    const Points points = rock(3), others = rock(4, 20);
    dGeomID a = geom_of(points), b = geom_of(points);
    const Points before = points_of(b);
    dReal box[6], box_after[6];
    dGeomGetAABB(b, box);
    dGeomSetConvexHull(a, others.data(), unsigned(others.size() / 3), 0);
    EXPECT_NE(solid_of(a), solid_of(b));
    EXPECT_EQ(points_of(b), before);
    dGeomGetAABB(b, box_after);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(box[i], box_after[i]);
    dGeomSetConvexHull(a, points.data(), unsigned(points.size() / 3), 0);
    EXPECT_EQ(solid_of(a), solid_of(b));
    dGeomDestroy(b);
    EXPECT_EQ(points_of(a), before);
    dGeomDestroy(a);
}

// So many are compared, and no more; what is not found is made again, and is the same.
TEST_F(SharedSolids, are_looked_for_among_those_asked_for_last)
{
    std::vector<dGeomID> geoms = {geom_of(rock(100))};
    for (std::uint64_t key = 101; key < 160; ++key) geoms.push_back(geom_of(rock(key)));
    geoms.push_back(geom_of(rock(100)));
    EXPECT_EQ(solid_of(geoms.front()), solid_of(geoms.back()));
    for (std::uint64_t key = 200; key < 300; ++key) geoms.push_back(geom_of(rock(key)));
    geoms.push_back(geom_of(rock(100)));
    EXPECT_NE(solid_of(geoms.front()), solid_of(geoms.back()));
    EXPECT_EQ(points_of(geoms.front()), points_of(geoms.back()));
    for (dGeomID g : geoms) dGeomDestroy(g);
}

long g_bytes = 0;
void* counted(dsizeint size)
{
    g_bytes += long(size);
    return std::malloc(size);
}
void uncounted(void* memory, dsizeint size)
{
    g_bytes -= long(size);
    std::free(memory);
}

bool take(SharedSolid& solid, const Points& points)
{
    Polyhedron made;
    return !made.build(points.data(), unsigned(points.size() / 3), 1000, false) && solid.take(made);
}

TEST_F(SharedSolids, are_given_back_by_their_last_user)
{
    const Points points = rock(5);
    dSetAllocHandler(counted);
    dSetFreeHandler(uncounted);
    const long before = g_bytes;
    {
        SharedSolid last;
        {
            SharedSolid one;
            ASSERT_TRUE(take(one, points));
            const long alone = g_bytes;
            EXPECT_GT(alone, before);
            ASSERT_TRUE(take(last, points));
            EXPECT_EQ(last.get(), one.get());
            EXPECT_EQ(g_bytes, alone);
        }
        EXPECT_GT(g_bytes, before);
        EXPECT_EQ(last.get()->vertices().size(), points.size() / 3);
    }
    EXPECT_EQ(g_bytes, before);
    dSetAllocHandler(nullptr);
    dSetFreeHandler(nullptr);
}

TEST_F(SharedSolids, may_be_made_by_several_threads)
{
    constexpr int kThreads = 4, kRounds = 100, kKinds = 5;
    std::vector<Points> kinds;
    std::vector<Points> hulls;
    for (int k = 0; k < kKinds; ++k) {
        kinds.push_back(rock(std::uint64_t(10 + k)));
        dGeomID geom = geom_of(kinds.back());
        hulls.push_back(points_of(geom));
        dGeomDestroy(geom);
    }
    int wrong[kThreads] = {};
    std::vector<std::thread> threads;
    for (int t = 0; t < kThreads; ++t)
        threads.emplace_back([&, t] {
            dAllocateODEDataForThread(dAllocateMaskAll);
            std::vector<dGeomID> mine;
            for (int round = 0; round < kRounds; ++round) {
                const std::size_t kind = std::size_t((round + t) % kKinds);
                mine.push_back(geom_of(kinds[kind]));
                wrong[t] += points_of(mine.back()) != hulls[kind];
                if (round % 3 == 2) {
                    dGeomDestroy(mine.front());
                    mine.erase(mine.begin());
                }
            }
            for (dGeomID g : mine) dGeomDestroy(g);
            dCleanupODEAllDataForThread();
        });
    for (std::thread& t : threads) t.join();
    for (const int w : wrong) EXPECT_EQ(w, 0);
}

}  // namespace
}  // namespace epode::test
