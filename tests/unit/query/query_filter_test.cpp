// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Filters of queries: what a callback or a body leaves out is as if it were not there, in scenes with every
// class of geom; callbacks are called in order of joining on the caller's thread and cannot change the space;
// filters of older programs work, and those that make no sense are refused.
#include <algorithm>
#include <cstring>
#include <thread>

#include "../api/message_recorder.h"
#include "query_scene.h"

using namespace epode;
using namespace epode::test;

namespace {

dQueryFilter everything()
{
    dQueryFilter filter;
    EXPECT_EQ(dQueryFilterInit(&filter, sizeof filter), 1);
    return filter;
}

// Rejects spheres, cylinders, convex geoms and height fields, and remembers what it was asked.
struct Picky {
    std::vector<dGeomID> asked;
    std::thread::id thread = std::this_thread::get_id();

    static bool likes(dGeomID geom) { return dGeomGetClass(geom) % 3 != 0; }
    static int keep(void* data, dGeomID geom)
    {
        Picky& self = *static_cast<Picky*>(data);
        EXPECT_EQ(self.thread, std::this_thread::get_id());
        self.asked.push_back(geom);
        return likes(geom) ? 2 : 0;
    }
    dQueryFilter filter()
    {
        dQueryFilter f = everything();
        f.callback = keep;
        f.data = this;
        return f;
    }
};

struct Line {
    dVector3 from, along;
};
Line random_line(RandomNumbers& dice)
{
    Line line{};
    const Vec3 o = Real(9) * dice.vec(), d = Real(3) * dice.vec() - o;
    store(line.from, o);
    store(line.along, length(d) > 0 ? d : Vec3{1, 0, 0});
    return line;
}

// A body of three geoms about the origin, one of them in a transform, in a space with a wall at x = 5.
class Robot {
  public:
    Robot()
    {
        dInitODE();
        space = dHashSpaceCreate(nullptr);
        world = dWorldCreate();
        body = dBodyCreate(world);
        wall = dCreateBox(space, Real(0.2), 10, 10);
        dGeomSetPosition(wall, 5, 0, 0);
        const dGeomID head = dCreateSphere(space, 1), trunk = dCreateBox(space, 2, 2, 2),
                      arm = dCreateGeomTransform(space), inner = dCreateCapsule(nullptr, Real(0.5), 2);
        dGeomTransformSetGeom(arm, inner);
        dGeomTransformSetCleanup(arm, 1);
        dGeomTransformSetInfo(arm, 1);
        for (const dGeomID g : {head, trunk, arm}) dGeomSetBody(g, body);
    }
    ~Robot()
    {
        dSpaceDestroy(space);
        dWorldDestroy(world);
        dCloseODE();
    }
    Robot(const Robot&) = delete;
    Robot& operator=(const Robot&) = delete;

    dWorldID world;
    dSpaceID space;
    dBodyID body;
    dGeomID wall;
};

}  // namespace

TEST(QueryFilter, a_robot_does_not_see_itself_from_inside)
{
    Robot robot;
    dQueryFilter others = everything();
    const dVector3 eye = {0, 0, 0}, forward = {1, 0, 0}, up = {0, 0, 1};
    dQueryHit hit, hits[8];
    ASSERT_EQ(dSpaceRayClosest(robot.space, eye, forward, 20, &others, &hit), 1);
    EXPECT_EQ(dGeomGetBody(hit.geom), robot.body);
    others.skip_body = robot.body;
    ASSERT_EQ(dSpaceRayClosest(robot.space, eye, forward, 20, &others, &hit), 1);
    EXPECT_EQ(hit.geom, robot.wall);
    EXPECT_NEAR(hit.distance, 4.9, 1e-5);
    EXPECT_EQ(dSpaceRayAll(robot.space, eye, forward, 20, &others, hits, 8), 1);
    EXPECT_EQ(dSpaceRayAll(robot.space, eye, forward, 20, nullptr, hits, 8), 4);
    EXPECT_EQ(dSpaceRayClosest(robot.space, eye, up, 20, &others, &hit), 0);
    const dReal origins[6] = {}, directions[6] = {1, 0, 0, 0, 0, 1}, lengths[2] = {20, 20};
    EXPECT_EQ(dSpaceRayBatch(robot.space, 2, origins, directions, lengths, &others, hits, 2), 1);
    EXPECT_EQ(hits[0].geom, robot.wall);
    EXPECT_EQ(hits[1].geom, nullptr);
    // A tool that is no part of the robot.
    const dGeomID tool = dCreateSphere(nullptr, Real(0.1));
    dGeomID met[8];
    EXPECT_EQ(dSpaceOverlap(robot.space, tool, nullptr, met, 8), 3);
    EXPECT_EQ(dSpaceOverlap(robot.space, tool, &others, met, 8), 0);
    const dVector3 way = {10, 0, 0};
    ASSERT_EQ(dSpaceCast(robot.space, tool, way, &others, &hit), 1);
    EXPECT_EQ(hit.geom, robot.wall);
    dGeomDestroy(tool);
}

TEST(QueryFilter, bits_of_a_filter_stand_for_those_of_the_geom)
{
    Robot robot;
    dGeomSetCategoryBits(robot.wall, 2), dGeomSetCollideBits(robot.wall, 0);
    const dGeomID ball = dCreateSphere(nullptr, 1);
    dGeomSetPosition(ball, 5, 0, 0);
    dGeomSetCategoryBits(ball, 1), dGeomSetCollideBits(ball, 4);
    dGeomID met[4];
    const dVector3 way = {1, 0, 0};
    dQueryHit hit;
    EXPECT_EQ(dSpaceOverlap(robot.space, ball, nullptr, met, 4), 0);
    EXPECT_EQ(dSpaceCast(robot.space, ball, way, nullptr, &hit), 0);
    dQueryFilter walls = everything();
    walls.category_bits = 0, walls.collide_bits = 2;
    ASSERT_EQ(dSpaceOverlap(robot.space, ball, &walls, met, 4), 1);
    EXPECT_EQ(met[0], robot.wall);
    EXPECT_EQ(dSpaceCast(robot.space, ball, way, &walls, &hit), 1);
    dGeomDestroy(ball);
}

TEST(QueryFilter, what_a_callback_rejects_is_as_if_it_were_not_there)
{
    int rejected = 0, first_rejected = 0;
    for (std::uint64_t key = 1; key <= 8; ++key) {
        QueryScene scene(key, key % 2 ? 200 : 30);
        for (int i = 0; i < 60; ++i) {
            const Line line = random_line(scene.dice());
            dQueryHit all[200], kept[200], first;
            const int count = dSpaceRayAll(scene.space, line.from, line.along, 25, nullptr, all, 200);
            Picky picky;
            const dQueryFilter filter = picky.filter();
            const int left = dSpaceRayAll(scene.space, line.from, line.along, 25, &filter, kept, 200);
            EXPECT_EQ(int(picky.asked.size()), count);
            const auto end =
                std::remove_if(all, all + count, [](const dQueryHit& h) { return !Picky::likes(h.geom); });
            ASSERT_EQ(left, int(end - all));
            for (int k = 0; k < left; ++k) EXPECT_EQ(std::memcmp(&kept[k], &all[k], sizeof first), 0);
            rejected += count - left;
            picky.asked.clear();
            EXPECT_EQ(dSpaceRayClosest(scene.space, line.from, line.along, 25, &filter, &first),
                      int(left > 0));
            EXPECT_LE(int(picky.asked.size()), count);
            if (left > 0) {
                EXPECT_EQ(first.geom, all[0].geom);
                EXPECT_NEAR(first.distance, all[0].distance, 1000 * kEpsilon);  // height fields round
            } else {
                EXPECT_EQ(first.geom, nullptr);
            }
            dQueryHit whoever;
            first_rejected += dSpaceRayClosest(scene.space, line.from, line.along, 25, nullptr, &whoever) &&
                              whoever.geom != first.geom;
        }
    }
    EXPECT_GT(rejected, 100);
    EXPECT_GT(first_rejected, 50);
}

TEST(QueryFilter, a_batch_with_a_callback_stays_on_the_callers_thread)
{
    QueryScene scene(9, 300);
    constexpr int kCount = 300;
    std::vector<dReal> origins, directions;
    const std::vector<dReal> lengths(kCount, 25);
    for (int i = 0; i < kCount; ++i) {
        const Line line = random_line(scene.dice());
        for (int k = 0; k < 3; ++k) origins.push_back(line.from[k]), directions.push_back(line.along[k]);
    }
    Picky one, many;
    const dQueryFilter filter = one.filter(), batch_filter = many.filter();
    std::vector<dQueryHit> single(kCount), batch(kCount);
    int met = 0;
    for (std::size_t i = 0; i < kCount; ++i)
        met += dSpaceRayClosest(scene.space, &origins[3 * i], &directions[3 * i], 25, &filter, &single[i]);
    EXPECT_EQ(dSpaceRayBatch(scene.space, kCount, origins.data(), directions.data(), lengths.data(),
                             &batch_filter, batch.data(), 4),
              met);
    EXPECT_GT(met, kCount / 3);
    EXPECT_EQ(std::memcmp(single.data(), batch.data(), kCount * sizeof(dQueryHit)), 0);
    EXPECT_EQ(one.asked, many.asked);
}

TEST(QueryFilter, of_casts_and_overlaps_rejects_what_its_callback_rejects)
{
    int hits = 0, overlaps = 0;
    for (std::uint64_t key = 1; key <= 4; ++key) {
        QueryScene scene(key, 120, 5);
        for (int k = 0; k < 30; ++k) {
            const int kinds[] = {0, 1, 2, 3, 4, 7};
            const dGeomID probe = scene.make(kinds[k % 6], nullptr);
            scene.place(probe, 6);
            const Vec3 m = Real(2) * (Real(3) * scene.dice().vec() - load(dGeomGetPosition(probe)));
            const dVector3 motion = {m.x, m.y, m.z, 0};
            Picky picky;
            const dQueryFilter filter = picky.filter();
            dGeomID all[200], kept[200];
            dQueryHit with_filter, without;
            const int count = dSpaceOverlap(scene.space, probe, nullptr, all, 200);
            const int left = dSpaceOverlap(scene.space, probe, &filter, kept, 200);
            EXPECT_EQ(picky.asked, std::vector<dGeomID>(all, all + count));  // newest first
            const auto end = std::remove_if(all, all + count, [](dGeomID g) { return !Picky::likes(g); });
            ASSERT_EQ(left, int(end - all));
            EXPECT_TRUE(std::equal(all, end, kept));
            overlaps += left;
            const int met = dSpaceCast(scene.space, probe, motion, &filter, &with_filter);
            // The same with the rejected ones disabled.
            std::vector<dGeomID> gone;
            for (const dGeomID g : scene.leaves())
                if (dGeomIsEnabled(g) && !Picky::likes(g)) dGeomDisable(g), gone.push_back(g);
            EXPECT_EQ(dSpaceCast(scene.space, probe, motion, nullptr, &without), met);
            for (const dGeomID g : gone) dGeomEnable(g);
            EXPECT_EQ(with_filter.geom, without.geom);
            EXPECT_EQ(with_filter.distance, without.distance);
            hits += met;
            dGeomDestroy(probe);
        }
    }
    EXPECT_GT(hits, 50);
    EXPECT_GT(overlaps, 20);
}

TEST(QueryFilter, callbacks_are_called_newest_first_however_the_tree_has_grown)
{
    dInitODE();
    std::vector<int> asked[6];
    for (int shuffle = 0; shuffle < 6; ++shuffle) {
        const dSpaceID space = dHashSpaceCreate(nullptr);
        RandomNumbers dice{std::uint64_t(shuffle)};
        std::vector<dGeomID> spheres;
        for (int i = 0; i < 60; ++i) {
            spheres.push_back(dCreateSphere(space, 1));
            dGeomSetData(spheres.back(), &asked[shuffle]);
        }
        for (int move = 0; move < 20 * shuffle; ++move) {
            dGeomSetPosition(spheres[std::size_t(dice.below(60))], dice.in(-9, 9), dice.in(-9, 9),
                             dice.in(-9, 9));
            dSpaceCollide(space, nullptr, [](void*, dGeomID, dGeomID) {});
        }
        for (std::size_t i = 0; i < 60; ++i) dGeomSetPosition(spheres[i], 0, 0, dReal(i * 7 % 60));
        dQueryFilter filter = everything();
        filter.data = &spheres;
        filter.callback = [](void* data, dGeomID geom) {
            const auto& list = *static_cast<std::vector<dGeomID>*>(data);
            const int number = int(std::find(list.begin(), list.end(), geom) - list.begin());
            static_cast<std::vector<int>*>(dGeomGetData(geom))->push_back(number);
            return int(number % 4 == 1);
        };
        const dVector3 from = {0, 0, 100}, down = {0, 0, -1};
        dQueryHit hit;
        EXPECT_EQ(dSpaceRayClosest(space, from, down, 200, &filter, &hit), 1);
        EXPECT_EQ(hit.geom, spheres[17]);  // highest at 17 * 7 % 60 = 59, which is also 1 mod 4
        EXPECT_TRUE(std::is_sorted(asked[shuffle].rbegin(), asked[shuffle].rend()));
        EXPECT_EQ(asked[shuffle], asked[0]);
        dSpaceDestroy(space);
    }
    EXPECT_GT(asked[0].size(), 3u);
    EXPECT_LT(asked[0].size(), 60u);  // those that are farther than one that was kept are not asked about
    dCloseODE();
}

TEST(QueryFilter, a_callback_cannot_change_the_space)
{
    Robot robot;
    MessageRecorder recorder;
    struct Vandal {
        dSpaceID space;
        int called = 0;
    } vandal{robot.space};
    dQueryFilter filter = everything();
    filter.data = &vandal;
    filter.callback = [](void* data, dGeomID geom) {
        Vandal& self = *static_cast<Vandal*>(data);
        ++self.called;
        dGeomDestroy(geom);
        dSpaceRemove(self.space, geom);
        dSpaceDestroy(self.space);
        dQueryHit other;
        const dVector3 back = {-1, 0, 0}, far = {20, 0, 0};
        EXPECT_EQ(dSpaceRayClosest(self.space, far, back, 30, nullptr, &other), 1);  // asking is allowed
        return 1;
    };
    const dVector3 eye = {0, 0, 0}, forward = {1, 0, 0};
    dQueryHit hits[8];
    const int members = dSpaceGetNumGeoms(robot.space);
    EXPECT_EQ(dSpaceRayAll(robot.space, eye, forward, 20, &filter, hits, 8), 4);
    const dGeomID tool = dCreateSphere(nullptr, Real(0.1));
    dGeomID met[8];
    EXPECT_EQ(dSpaceOverlap(robot.space, tool, &filter, met, 8), 3);
    EXPECT_EQ(dSpaceCast(robot.space, tool, forward, &filter, hits), 1);
    const dReal length = 20;
    EXPECT_EQ(dSpaceRayBatch(robot.space, 1, eye, forward, &length, &filter, hits, 1), 1);
    EXPECT_GE(vandal.called, 9);
    const std::string said = recorder.take();
    EXPECT_EQ(std::count(said.begin(), said.end(), '|'), 3 * vandal.called - 1) << said;
    EXPECT_EQ(dSpaceGetNumGeoms(robot.space), members);
    dGeomDestroy(tool);
    EXPECT_EQ(recorder.take(), "");
}

TEST(QueryFilter, of_an_older_program_has_no_body_and_no_callback)
{
    Robot robot;
    dQueryFilter old = everything();
    old.struct_size = offsetof(dQueryFilter, skip_body);
    std::memset(&old.skip_body, 0x5a, sizeof old - old.struct_size);
    const dVector3 eye = {0, 0, 0}, forward = {1, 0, 0};
    dQueryHit hit;
    EXPECT_EQ(dSpaceRayClosest(robot.space, eye, forward, 20, &old, &hit), 1);
    EXPECT_EQ(dGeomGetBody(hit.geom), robot.body);
    old.category_bits = old.collide_bits = 0;
    EXPECT_EQ(dSpaceRayClosest(robot.space, eye, forward, 20, &old, &hit), 0);
}

TEST(QueryFilter, that_makes_no_sense_is_refused)
{
    Robot robot;
    MessageRecorder recorder;
    const dVector3 eye = {0, 0, 0}, forward = {1, 0, 0};
    const dReal length = 20;
    dQueryHit hit, untouched;
    std::memset(&hit, 0x5a, sizeof hit);
    untouched = hit;
    dGeomID met[4] = {};
    const dGeomID tool = dCreateSphere(nullptr, 1);
    const auto refused = [&](const dQueryFilter& bad, const char* why) {
        EXPECT_EQ(dSpaceRayClosest(robot.space, eye, forward, length, &bad, &hit), 0);
        EXPECT_EQ(dSpaceRayAll(robot.space, eye, forward, length, &bad, &hit, 1), 0);
        EXPECT_EQ(dSpaceRayBatch(robot.space, 1, eye, forward, &length, &bad, &hit, 1), 0);
        EXPECT_EQ(dSpaceCast(robot.space, tool, forward, &bad, &hit), 0);
        EXPECT_EQ(dSpaceOverlap(robot.space, tool, &bad, met, 4), 0);
        const std::string said = recorder.take();
        EXPECT_EQ(std::count(said.begin(), said.end(), '|'), 4) << said;
        for (const char* name : {why, "dSpaceRayClosest()", "dSpaceRayAll()", "dSpaceRayBatch()",
                                 "dSpaceCast()", "dSpaceOverlap()"})
            EXPECT_NE(said.find(name), std::string::npos) << name << " in " << said;
    };
    const std::string range = "from " + std::to_string(offsetof(dQueryFilter, skip_body)) + " to " +
                              std::to_string(sizeof(dQueryFilter));
    for (const unsigned size : {0u, 4u, 25u, unsigned(sizeof(dQueryFilter)) + 8, ~0u}) {
        dQueryFilter filter = everything();
        filter.struct_size = size;
        refused(filter, range.c_str());
        EXPECT_EQ(dQueryFilterInit(&filter, size), 0);
        EXPECT_NE(recorder.take().find(range), std::string::npos);
    }
    dQueryFilter filter = everything();
    filter.skip_body = dBodyCreate(robot.world);
    dBodyDestroy(filter.skip_body);
    refused(filter, "skip_body");
    filter.skip_body = dBodyID(tool);
    refused(filter, "skip_body");
    EXPECT_EQ(dQueryFilterInit(nullptr, sizeof filter), 0);
    EXPECT_EQ(std::memcmp(&hit, &untouched, sizeof hit), 0);
    EXPECT_EQ(met[0], nullptr);
    dGeomDestroy(tool);
}
