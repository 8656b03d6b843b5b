// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Pairs and points lie in the order in which islands noted them, which is nearly the same in every step: the
// search for one leaves the next in the caches.
#include "step/common/contact_cache.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "base/hash.h"
#include "simd/quad.h"

namespace epode {
namespace {

constexpr Real kReach = Real(0.05);      // of the lever arm
constexpr Real kSameNormal = Real(0.9);  // cosine

}  // namespace

void ContactCache::Store::swap(Store& other)
{
    pairs.swap(other.pairs);
    points.swap(other.points);
    runs.swap(other.runs);
    std::swap(step, other.step), std::swap(h, other.h);
}

bool ContactCache::fits(const Pair& pair, const Wanted& wanted) const
{
    return pair.serial1 == wanted.serial1 && pair.serial2 == wanted.serial2 &&
           !(dot(widen(pair.normal), wanted.normal) < kSameNormal);
}

bool ContactCache::is_guess(int guess, const Wanted& wanted) const
{
    if (guess < 0 || guess >= old_.pairs.size()) return false;
    const Pair& pair = old_.pairs[guess];
    return pair.step == old_.step && !pair.twin && fits(pair, wanted);
}

void ContactCache::look_into(int index, const Wanted& wanted, std::uint8_t attempt, Found& best)
{
    const Pair& pair = old_.pairs[index];
    for (int k = pair.first; k < pair.first + pair.count; ++k) {
        Point& point = old_.points[k];
        const Real distance2 = length2(widen(point.place) - wanted.place);
        if (point.used < attempt && distance2 <= best.distance2) best = {&point, index, distance2};
    }
}

// The points of an old pair, a lane each; those that are used, and those that are none, are not free. They
// stay in registers: vectors read from what has just been written number by number would have to wait for it.
struct ContactCache::Places {
    Quad x, y, z;
    unsigned free;

    // Mostly there is one within reach, and no more to compare.
    int nearest(const ManifoldArms& arms, int i) const  // -1: none
    {
        const Quad dx = x - quad(arms.x[i]), dy = y - quad(arms.y[i]), dz = z - quad(arms.z[i]);
        const Quad distance2 = dx * dx + dy * dy + dz * dz;
        const unsigned near = bits(distance2 <= quad(arms.within2[i])) & free;
        if ((near & (near - 1)) == 0) return near ? std::countr_zero(near) : -1;
        int best = -1;
        for (unsigned left = near; left != 0; left &= left - 1) {
            const int k = std::countr_zero(left);
            if (best < 0 || lane(distance2, k) <= lane(distance2, best)) best = k;
        }
        return best;
    }
};

ContactCache::Places ContactCache::places_of(const Pair& pair, std::uint8_t attempt) const
{
    static_assert(kManifoldPoints == 4);
    const Point* at = old_.points.data() + pair.first;
    unsigned free = 0;
    for (int k = 0; k < pair.count; ++k) free |= unsigned(at[k].used < attempt) << k;
    return {quad_of(pair.count, [&](int k) { return Real(at[k].place.x); }),
            quad_of(pair.count, [&](int k) { return Real(at[k].place.y); }),
            quad_of(pair.count, [&](int k) { return Real(at[k].place.z); }), free};
}

ContactCache::ManifoldArms ContactCache::arms_of(const Body& body1,
                                                 std::span<const JointManifoldPoint> points)
{
    const int count = int(points.size());
    const Quad x = quad_of(count, [&](int i) { return points[std::size_t(i)].r1.x; }),
               y = quad_of(count, [&](int i) { return points[std::size_t(i)].r1.y; }),
               z = quad_of(count, [&](int i) { return points[std::size_t(i)].r1.z; });
    const Mat3 R = body1.rotation();
    const auto along = [&](Vec3 axis) { return quad(axis.x) * x + quad(axis.y) * y + quad(axis.z) * z; };
    const Quad u = along(R.column(0)), v = along(R.column(1)), w = along(R.column(2));
    const Quad within2 = quad(kReach * kReach) * (u * u + v * v + w * w + quad(kReach * kReach));
    ManifoldArms arms;
    store_quad(arms.x, u), store_quad(arms.y, v), store_quad(arms.z, w);
    store_quad(arms.within2, within2);
    return arms;
}

ContactCache::Found ContactCache::find(const Wanted& wanted, Real within2, std::uint8_t attempt)
{
    Found best{nullptr, -1, within2};
    const std::size_t hash = hash_of(wanted.serial1, wanted.serial2);
    for (int i = buckets_[int(hash & std::size_t(buckets_.size() - 1))]; i >= 0; i = old_.pairs[i].next)
        if (fits(old_.pairs[i], wanted)) look_into(i, wanted, attempt, best);
    return best;
}

void ContactCache::note(Run& run, const Wanted& wanted, int ticket, int points)
{
    Pair& fresh = fresh_.pairs[run.first + run.count];
    fresh.serial1 = wanted.serial1, fresh.serial2 = wanted.serial2;
    fresh.normal = narrow(wanted.normal);
    fresh.first = ticket, fresh.count = points;
    fresh.next = -1, fresh.step = fresh_.step, fresh.twin = false;
    if (run.count > 0) {
        Pair& before = fresh_.pairs[run.first + run.count - 1];
        if (before.serial1 == fresh.serial1 && before.serial2 == fresh.serial2)
            before.twin = fresh.twin = true;
    }
    ++run.count;
}

void ContactCache::note_points(int ticket, int count, const ManifoldArms& arms)
{
    for (int i = 0; i < count; ++i) {
        Point& fresh = fresh_.points.data()[ticket + i];
        fresh.place = narrow(arms.place(i)), fresh.friction = {0, 0, 0};
        fresh.normal_impulse = 0, fresh.used = 0;
    }
}

void ContactCache::load(int writer, int ticket, const Body& body1, const Body* body2,
                        const JointManifold& manifold, std::span<JointManifoldPoint> points, Real share,
                        Real h)
{
    Run& run = fresh_.runs[writer];
    if (run.count == 0) run.first = ticket, run.guess = -1;
    const std::uint64_t serial1 = body1.serial, serial2 = body2 ? body2->serial : 0;
    Wanted wanted{serial1, serial2, {}, manifold.n};
    note(run, wanted, ticket, int(points.size()));
    const ManifoldArms arms = arms_of(body1, points);
    note_points(ticket, int(points.size()), arms);
    if (!(share > 0) || buckets_.empty()) return;
    if (old_.h > 0) share *= h / old_.h;  // forces persist, not impulses
    const int guess = is_guess(run.guess, wanted) ? run.guess : -1;
    Places places{};
    if (guess >= 0) places = places_of(old_.pairs[guess], run.attempt);
    for (int i = 0; i < int(points.size()); ++i) {
        const int nearest = places.nearest(arms, i);
        Found old{nullptr, guess, arms.within2[i]};
        if (nearest >= 0) {
            old.point = &old_.points[old_.pairs[guess].first + nearest];
            places.free &= ~(1u << nearest);
        } else {
            wanted.place = arms.place(i);
            old = find(wanted, arms.within2[i], run.attempt);
        }
        if (!old.point) continue;
        old.point->used = run.attempt;
        run.guess = old.pair + 1;
        JointManifoldPoint& point = points[std::size_t(i)];
        point.p[0] = share * Real(old.point->normal_impulse);
        point.p[1] = share * dot(widen(old.point->friction), manifold.t1);
        point.p[2] = share * dot(widen(old.point->friction), manifold.t2);
    }
}

void ContactCache::begin_again(int writer)
{
    Run& run = fresh_.runs[writer];
    run.count = 0, ++run.attempt;
}

void ContactCache::remember(int ticket, const JointManifold& manifold,
                            std::span<const JointManifoldPoint> points, Real times)
{
    for (const JointManifoldPoint& point : points) {
        Point& fresh = fresh_.points[ticket++];
        fresh.normal_impulse = float(times * point.p[0]);
        fresh.friction = narrow(times * (point.p[1] * manifold.t1 + point.p[2] * manifold.t2));
    }
}

int ContactCache::buckets_for(int pairs)
{
    int wanted = 16;
    while (wanted < 2 * pairs) wanted *= 2;
    return wanted;
}

bool ContactCache::begin_runs(int writers)
{
    if (!fresh_.runs.resize(writers)) return false;
    for (Run& run : fresh_.runs) run = {0, 0, -1, 1};
    return true;
}

bool ContactCache::begin(int tickets, int writers)
{
    // A quarter is spare, since the number of contacts of a settled pile still varies; and each store has at
    // least the capacity of the other, because the two swap after every step.
    const auto capacity_for = [](int wanted, int mine, int partner) {
        return std::max(partner, wanted > mine ? wanted + wanted / 4 : mine);
    };
    const int points = capacity_for(tickets, fresh_.points.capacity(), old_.points.capacity());
    const int runs = capacity_for(writers, fresh_.runs.capacity(), old_.runs.capacity());
    fresh_.runs.clear();
    fresh_.step = ++steps_;
    // Sizes only grow: the runs say which pairs and points are valid.
    return fresh_.pairs.reserve(points) && fresh_.points.reserve(points) && fresh_.runs.reserve(runs) &&
           buckets_.reserve(buckets_for(points)) &&
           fresh_.pairs.resize(std::max(tickets, fresh_.pairs.size())) &&
           fresh_.points.resize(std::max(tickets, fresh_.points.size())) && begin_runs(writers);
}

void ContactCache::end(Real h)
{
    old_.swap(fresh_);
    old_.h = h;
    int pairs = 0;
    for (const Run& run : old_.runs) pairs += run.count;
    if (const int wanted = buckets_for(pairs); buckets_.size() < wanted)
        (void)buckets_.resize(wanted);  // begin() has reserved them
    fill_buckets();
}

void ContactCache::fill_buckets()
{
    std::fill(buckets_.begin(), buckets_.end(), -1);
    const auto mask = std::size_t(buckets_.size() - 1);
    // From the last to the first, so that each chain runs in order of creation.
    for (int r = old_.runs.size(); r-- > 0;)
        for (int i = old_.runs[r].first + old_.runs[r].count; i-- > old_.runs[r].first;) {
            Pair& pair = old_.pairs[i];
            int& bucket = buckets_[int(hash_of(pair.serial1, pair.serial2) & mask)];
            pair.next = bucket;
            bucket = i;
        }
}

void ContactCache::take_back()
{
    for (const Run& run : old_.runs)
        for (int i = run.first; i < run.first + run.count; ++i)
            for (int k = old_.pairs[i].first; k < old_.pairs[i].first + old_.pairs[i].count; ++k)
                old_.points[k].used = 0;
}

const char* ContactCache::fault() const
{
    const Pair* pairs = old_.pairs.data();
    for (const Run& run : old_.runs)
        for (int i = run.first; i < run.first + run.count; ++i) {
            if (i < 0 || i >= old_.pairs.size()) return "contact cache: a run leaves the list of pairs";
            if (pairs[i].first < 0 || pairs[i].first + pairs[i].count > old_.points.size())
                return "contact cache: a pair's points are not in the list";
            if (pairs[i].next >= 0 && pairs[i].next <= i) return "contact cache: a chain runs backwards";
            for (int k = pairs[i].first; k < pairs[i].first + pairs[i].count; ++k)
                if (old_.points.data()[k].used) return "contact cache: a point is used between steps";
        }
    return nullptr;
}

}  // namespace epode
