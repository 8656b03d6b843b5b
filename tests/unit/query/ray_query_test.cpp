// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rays against spaces: the same bits as dCollide with a ray geom against every leaf, in scenes with every
// class of geom; the order depends on joining alone; functions of the program are called on the caller's
// thread, and what they do to the ray is undone; bad arguments are refused.
#include <algorithm>
#include <cstring>

#include "../api/message_recorder.h"
#include "query_scene.h"

using namespace epode;
using namespace epode::test;

namespace {

struct RandomRay {
    dVector3 origin, direction;
    dReal length;
    unsigned long category = ~0ul, collide = ~0ul;
};

RandomRay random_ray(RandomNumbers& dice)
{
    RandomRay q{};
    const Vec3 o = Real(9) * dice.vec();
    Vec3 d = dice.below(3) == 0 ? Vec3{0, 0, -1} : Real(4) * dice.vec() - o;
    if (!(length(d) > 0)) d = {1, 0, 0};
    store(q.origin, o);
    store(q.direction, dice.in(Real(0.1), 5) * d);
    q.length = dice.below(4) == 0 ? dInfinity : dice.in(0, 20);
    if (dice.below(3) == 0) q.category = 4, q.collide = 1;
    return q;
}

// All hits by a ray geom against each leaf, sorted by distance, the newer first.
std::vector<dQueryHit> by_collide(const QueryScene& scene, const RandomRay& q)
{
    std::vector<dQueryHit> out;
    const dGeomID ray = dCreateRay(nullptr, q.length);
    dGeomRaySet(ray, q.origin[0], q.origin[1], q.origin[2], q.direction[0], q.direction[1], q.direction[2]);
    dGeomRaySetClosestHit(ray, 1);
    for (const dGeomID g : scene.leaves()) {
        dContactGeom c;
        if (!QueryScene::seen(g, q.category, q.collide) || dCollide(ray, g, 1, &c, sizeof c) == 0) continue;
        dQueryHit hit{};
        hit.geom = c.g2;
        store(hit.pos, load(c.pos));
        store(hit.normal, load(c.normal));
        hit.distance = c.depth;
        hit.side = c.side2;
        out.push_back(hit);
    }
    dGeomDestroy(ray);
    std::stable_sort(out.begin(), out.end(),
                     [](const dQueryHit& a, const dQueryHit& b) { return a.distance < b.distance; });
    return out;
}

// But for a height field's, whose walk rounds with the end of the ray: of the closest hit that is another
// one.
void expect_same(const dQueryHit& got, const dQueryHit& wanted, Real slack)
{
    EXPECT_EQ(got.geom, wanted.geom);
    EXPECT_EQ(got.side, wanted.side);
    EXPECT_NEAR(got.distance, wanted.distance, slack);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(got.pos[i], wanted.pos[i], slack);
        EXPECT_NEAR(got.normal[i], wanted.normal[i], slack);
    }
}

Real slack_of(dGeomID geom) { return dGeomGetClass(geom) == dHeightfieldClass ? 1000 * kEpsilon : Real(0); }

int count_threads_calls = 0;
void no_box(dGeomID, dReal box[6])
{
    for (int i = 0; i < 6; ++i) box[i] = i % 2 ? 1 : -1;
}
int hit_in_front(dGeomID geom, dGeomID ray, int, dContactGeom* contact, int)
{
    ++count_threads_calls;
    dVector3 start, direction;
    dGeomRayGet(ray, start, direction);
    *contact = dContactGeom{};
    contact->depth = Real(0.5);
    for (int i = 0; i < 3; ++i) contact->pos[i] = start[i] + Real(0.5) * direction[i];
    contact->normal[2] = 1;
    contact->g1 = geom;
    contact->g2 = ray;
    contact->side1 = contact->side2 = -1;
    // None of this may matter to the query.
    dGeomRaySet(ray, 100, 100, 100, 1, 0, 0);
    dGeomDestroy(ray);
    return 1;
}
dColliderFn* collider_of_rays(int other) { return other == dRayClass ? hit_in_front : nullptr; }

}  // namespace

TEST(RandomRay, finds_what_d_collide_finds_in_scenes_of_all_classes)
{
    int hits = 0;
    for (std::uint64_t key = 1; key <= 12; ++key) {
        QueryScene scene(key, key % 3 == 0 ? 300 : 25);
        for (int i = 0; i < 100; ++i) {
            const RandomRay q = random_ray(scene.dice());
            const dQueryFilter filter = bits(q.category, q.collide);
            const std::vector<dQueryHit> wanted = by_collide(scene, q);
            std::vector<dQueryHit> got(wanted.size() + 5);
            ASSERT_EQ(dSpaceRayAll(scene.space, q.origin, q.direction, q.length, &filter, got.data(),
                                   int(got.size())),
                      int(wanted.size()));
            for (std::size_t k = 0; k < wanted.size(); ++k) expect_same(got[k], wanted[k], 0);
            dQueryHit first;
            EXPECT_EQ(dSpaceRayClosest(scene.space, q.origin, q.direction, q.length, &filter, &first),
                      int(!wanted.empty()));
            if (!wanted.empty())
                expect_same(first, wanted[0], slack_of(wanted[0].geom));
            else
                EXPECT_EQ(first.geom, nullptr);
            hits += int(wanted.size());
        }
    }
    EXPECT_GT(hits, 1500);
}

TEST(RandomRay, room_takes_the_nearest_and_the_number_is_that_of_all)
{
    QueryScene scene(5, 200, 3);
    const dVector3 from = {-20, 0, 0}, along = {1, 0, 0};
    dQueryHit all[64], few[3];
    const int count = dSpaceRayAll(scene.space, from, along, 40, nullptr, all, 64);
    ASSERT_GT(count, 5);
    few[2].side = 77;
    EXPECT_EQ(dSpaceRayAll(scene.space, from, along, 40, nullptr, few, 2), count);
    EXPECT_EQ(few[0].geom, all[0].geom);
    EXPECT_EQ(few[1].geom, all[1].geom);
    EXPECT_EQ(few[2].side, 77);
    EXPECT_EQ(dSpaceRayAll(scene.space, from, along, 40, nullptr, nullptr, 0), count);
}

TEST(RandomRay, the_newer_of_equals_comes_first_however_the_tree_has_grown)
{
    dInitODE();
    for (int shuffle = 0; shuffle < 6; ++shuffle) {
        const dSpaceID space = dHashSpaceCreate(nullptr);
        RandomNumbers dice{std::uint64_t(shuffle)};
        std::vector<dGeomID> spheres;
        for (int i = 0; i < 40; ++i) spheres.push_back(dCreateSphere(space, 1));
        for (int i = 0; i < 40; ++i) dCreateBox(space, 1, 1, 1);
        for (int move = 0; move < 20 * shuffle; ++move) {
            const dGeomID g = spheres[std::size_t(dice.below(40))];
            dGeomSetPosition(g, dice.in(-9, 9), dice.in(-9, 9), dice.in(-9, 9));
            dSpaceCollide(space, nullptr, [](void*, dGeomID, dGeomID) {});
        }
        for (const dGeomID g : spheres) dGeomSetPosition(g, 0, 0, 5);
        const dVector3 from = {0, 0, 10}, down = {0, 0, -1};
        dQueryHit hits[80];
        ASSERT_EQ(dSpaceRayAll(space, from, down, 20, nullptr, hits, 80), 80);
        for (int i = 0; i < 40; ++i) EXPECT_EQ(hits[i].geom, spheres[std::size_t(39 - i)]);
        dQueryHit first;
        EXPECT_EQ(dSpaceRayClosest(space, from, down, 20, nullptr, &first), 1);
        EXPECT_EQ(first.geom, spheres[39]);
        dSpaceDestroy(space);
    }
    dCloseODE();
}

TEST(RandomRay, a_batch_has_the_bits_of_single_rays_on_any_number_of_threads)
{
    QueryScene scene(9, 400);
    constexpr int kCount = 1000;
    std::vector<dReal> origins, directions, lengths;
    for (int i = 0; i < kCount; ++i) {
        const RandomRay q = random_ray(scene.dice());
        for (int k = 0; k < 3; ++k) origins.push_back(q.origin[k]), directions.push_back(q.direction[k]);
        lengths.push_back(q.length);
    }
    const dQueryFilter filter = bits(1, ~0ul);
    std::vector<dQueryHit> single(kCount);
    int met = 0;
    for (std::size_t i = 0; i < kCount; ++i)
        met += dSpaceRayClosest(scene.space, &origins[3 * i], &directions[3 * i], lengths[i], &filter,
                                &single[i]);
    EXPECT_GT(met, kCount / 4);
    for (const int threads : {1, 2, 3, 0}) {
        std::vector<dQueryHit> batch(kCount);
        EXPECT_EQ(dSpaceRayBatch(scene.space, kCount, origins.data(), directions.data(), lengths.data(),
                                 &filter, batch.data(), threads),
                  met);
        for (std::size_t i = 0; i < kCount; ++i) expect_same(batch[i], single[i], 0);
    }
}

TEST(RandomRay, functions_of_the_program_are_asked_once_and_cannot_spoil_the_ray)
{
    QueryScene scene(3, 30);
    dGeomClass description{};
    description.collider = collider_of_rays;
    description.aabb = no_box;
    const dGeomID user = dCreateGeom(dCreateGeomClass(&description));
    dSpaceAdd(scene.space, user);
    const MessageRecorder recorder;
    const dVector3 from = {0, 0, 1}, down = {0, 0, -1};
    count_threads_calls = 0;
    dQueryHit hits[40];
    const int all = dSpaceRayAll(scene.space, from, down, 20, nullptr, hits, 40);
    EXPECT_GE(all, 1);
    EXPECT_EQ(count_threads_calls, 1);
    std::vector<dReal> origins(3 * 200, 0), directions(3 * 200, 0), lengths(200, 20);
    for (std::size_t i = 2; i < 600; i += 3) origins[i] = 1, directions[i] = -1;
    std::vector<dQueryHit> batch(200);
    EXPECT_EQ(dSpaceRayBatch(scene.space, 200, origins.data(), directions.data(), lengths.data(), nullptr,
                             batch.data(), 4),
              200);
    for (const dQueryHit& hit : batch) {
        EXPECT_EQ(hit.geom, hits[0].geom);
        EXPECT_EQ(hit.distance, hits[0].distance);
    }
    EXPECT_LE(count_threads_calls, 201);
}

TEST(RandomRay, may_be_asked_from_inside_a_collision)
{
    QueryScene scene(4, 60, 2);
    dQueryHit before;
    const dVector3 from = {-20, 0, 0}, along = {1, 0, 0};
    ASSERT_EQ(dSpaceRayClosest(scene.space, from, along, 40, nullptr, &before), 1);
    struct Inside {
        dSpaceID space;
        dGeomID wanted;
        int asked = 0;
    } inside{scene.space, before.geom};
    dSpaceCollide(scene.space, &inside, [](void* data, dGeomID, dGeomID) {
        Inside& in = *static_cast<Inside*>(data);
        const dVector3 start = {-20, 0, 0}, forward = {1, 0, 0};
        dQueryHit hit;
        if (in.asked++ >= 20) return;
        EXPECT_EQ(dSpaceRayClosest(in.space, start, forward, 40, nullptr, &hit), 1);
        EXPECT_EQ(hit.geom, in.wanted);
    });
    EXPECT_GT(inside.asked, 0);
}

TEST(RandomRay, refuses_what_makes_no_sense_and_writes_nothing)
{
    QueryScene scene(1, 20);
    MessageRecorder recorder;
    const dVector3 o = {0, 0, 0}, d = {0, 0, 1}, zero = {0, 0, 0}, nan = {0, dReal(NAN), 0};
    dQueryHit hit, untouched;
    std::memset(&hit, 0x5a, sizeof hit);
    untouched = hit;
    const dSpaceID none = nullptr, wrong = dSpaceID(dSpaceGetGeom(scene.space, 0));
    const dReal one[3] = {0, 0, 1}, length[1] = {-1};
    EXPECT_EQ(dSpaceRayClosest(none, o, d, 1, nullptr, &hit), 0);
    EXPECT_EQ(dSpaceRayClosest(dGeomIsSpace(dGeomID(wrong)) ? none : wrong, o, d, 1, nullptr, &hit), 0);
    EXPECT_EQ(dSpaceRayClosest(scene.space, nullptr, d, 1, nullptr, &hit), 0);
    EXPECT_EQ(dSpaceRayClosest(scene.space, o, zero, 1, nullptr, &hit), 0);
    EXPECT_EQ(dSpaceRayClosest(scene.space, nan, d, 1, nullptr, &hit), 0);
    EXPECT_EQ(dSpaceRayClosest(scene.space, o, d, -1, nullptr, &hit), 0);
    EXPECT_EQ(dSpaceRayClosest(scene.space, o, d, dReal(NAN), nullptr, &hit), 0);
    EXPECT_EQ(dSpaceRayClosest(scene.space, o, d, 1, nullptr, nullptr), 0);
    EXPECT_EQ(dSpaceRayAll(scene.space, o, d, 1, nullptr, &hit, -1), 0);
    EXPECT_EQ(dSpaceRayAll(scene.space, o, d, 1, nullptr, nullptr, 1), 0);
    EXPECT_EQ(dSpaceRayBatch(scene.space, 1, one, one, length, nullptr, &hit, 1), 0);
    EXPECT_EQ(dSpaceRayBatch(scene.space, -1, one, one, one, nullptr, &hit, 1), 0);
    EXPECT_EQ(dSpaceRayBatch(scene.space, 1, one, one, one + 2, nullptr, &hit, -1), 0);
    const std::string said = recorder.take();
    EXPECT_EQ(std::count(said.begin(), said.end(), '|'), 12) << said;
    EXPECT_EQ(std::memcmp(&hit, &untouched, sizeof hit), 0);
    EXPECT_EQ(dSpaceRayBatch(scene.space, 0, nullptr, nullptr, nullptr, nullptr, nullptr, 1), 0);
    EXPECT_EQ(recorder.take(), "");
}
