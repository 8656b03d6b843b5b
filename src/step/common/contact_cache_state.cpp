// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The impulses of contact joints in states of a world: for every manifold of the last step its bodies, its
// normal and what is remembered of its points. Pairs come in the order in which they are looked up, with
// marks where another writer's run begins: the first guess after a search never leads from one into the next,
// so neither may it afterwards. What belonged to bodies that are gone is left out.
#include <algorithm>

#include "step/common/contact_cache.h"

namespace epode {
namespace {

constexpr std::uint32_t kCount = 7, kTwin = 8, kBeginsRun = 16;
constexpr std::uint32_t kNobody = ~0u;
constexpr int kWithSteps = 6;  // the format from which on the size of the step is known

}  // namespace

void ContactCache::save(const BodyTable& bodies, StateStream& stream) const
{
    const auto is_there = [&](const Pair& pair) {
        return bodies.find(pair.serial1) >= 0 && (pair.serial2 == 0 || bodies.find(pair.serial2) >= 0);
    };
    const auto for_each = [&](auto&& f) {
        for (const Run& run : old_.runs) {
            bool begins = true;
            for (int i = run.first; i < run.first + run.count; ++i)
                if (const Pair& pair = old_.pairs[i]; is_there(pair)) f(pair, begins), begins = false;
        }
    };
    std::uint32_t pairs = 0, points = 0;
    for_each([&](const Pair& pair, bool) { ++pairs, points += std::uint32_t(pair.count); });
    (void)stream.word(pairs), (void)stream.word(points);
    Real h = old_.h;
    stream.reals(&h, 1);
    for_each([&](Pair pair, bool begins) {
        (void)stream.word(std::uint32_t(bodies.find(pair.serial1)));
        (void)stream.word(pair.serial2 ? std::uint32_t(bodies.find(pair.serial2)) : kNobody);
        (void)stream.word(std::uint32_t(pair.count) | (pair.twin ? kTwin : 0) | (begins ? kBeginsRun : 0));
        stream.floats(&pair.normal.x, 3);
        for (int k = pair.first; k < pair.first + pair.count; ++k) {
            Point point = old_.points[k];
            stream.floats(&point.place.x, 3), stream.floats(&point.friction.x, 3);
            stream.floats(&point.normal_impulse, 1);
        }
    });
}

namespace {

struct PairRecord {
    std::uint32_t body1, body2, bits, points;
};

// Damage fails the stream. `left`: points that no pair has yet.
PairRecord read_pair(StateStream& stream, std::uint32_t bodies, std::uint32_t left, bool first)
{
    PairRecord r;
    r.body1 = stream.index(0, bodies, "a contact of no body"), r.body2 = stream.word(0);
    r.bits = stream.word(0), r.points = r.bits & kCount;
    if (stream.failed()) return r;
    const bool has_bodies = (r.body2 < bodies && r.body2 != r.body1) || r.body2 == kNobody;
    if (!stream.demand(has_bodies, "a contact of no body")) return r;
    const bool has_points =
        r.points <= std::uint32_t(kManifoldPoints) && r.points <= left && (!first || r.bits & kBeginsRun);
    (void)stream.demand(has_points, "a contact with too many points");
    return r;
}

}  // namespace

// A pair without a step stands before each run: no guess reaches over it.
bool ContactCache::load(const BodyTable& bodies, StateStream& stream, Loaded& out)
{
    constexpr std::size_t kLeast = 24;  // bytes of a pair
    const std::uint32_t pairs = stream.word(0), points = stream.word(0);
    if (!stream.demand(pairs <= stream.left() / kLeast && points <= stream.left() / sizeof(float),
                       "the state ends too early"))
        return true;
    Store& store = out.store;
    store.pairs.clear(), store.points.clear(), store.runs.clear();
    store.step = 1;
    store.h = 0;
    if (stream.format() >= kWithSteps) stream.reals(&store.h, 1);
    if (!store.pairs.reserve(2 * int(pairs)) || !store.points.resize(int(points)) ||
        !store.runs.reserve(int(pairs)) || !out.buckets.resize(buckets_for(int(pairs))))
        return false;
    const auto count = std::uint32_t(bodies.count());
    std::uint32_t used = 0;
    for (std::uint32_t i = 0; i < pairs && !stream.failed(); ++i) {
        const auto [body1, body2, bits, own] = read_pair(stream, count, points - used, i == 0);
        if (stream.failed()) break;
        if (bits & kBeginsRun) {
            (void)store.pairs.push(Pair{});
            (void)store.runs.push({store.pairs.size(), 0, -1, 1});
        }
        ++store.runs.back().count;
        Pair pair{bodies[int(body1)].serial,
                  body2 == kNobody ? 0 : bodies[int(body2)].serial,
                  {},
                  int(used),
                  int(own),
                  -1,
                  store.step,
                  (bits & kTwin) != 0};
        stream.floats(&pair.normal.x, 3);
        for (std::uint32_t k = 0; k < own; ++k) {
            Point& point = store.points[int(used++)];
            stream.floats(&point.place.x, 3), stream.floats(&point.friction.x, 3);
            stream.floats(&point.normal_impulse, 1);
        }
        (void)store.pairs.push(pair);
    }
    return true;
}

void ContactCache::accept(Loaded& loaded)
{
    ++steps_;
    for (const Run& run : loaded.store.runs)
        for (int i = run.first; i < run.first + run.count; ++i) loaded.store.pairs[i].step = steps_;
    loaded.store.step = steps_;
    old_.swap(loaded.store);
    buckets_.swap(loaded.buckets);
    fill_buckets();
}

}  // namespace epode
