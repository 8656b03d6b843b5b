// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Row layout that is relied on here: a contact block begins with its normal row, whose lin1 is the normal;
// the linear parts of the others are tangents.
#include "step/contact_cache.h"

#include <algorithm>

namespace epode {
namespace {

constexpr Real kReach = Real(0.05);      // of the lever arm
constexpr Real kSameNormal = Real(0.9);  // cosine

}  // namespace

std::size_t ContactCache::hash(std::uint64_t a, std::uint64_t b)
{
    std::uint64_t z = a * 0x9e3779b97f4a7c15u + b * 0xc2b2ae3d27d4eb4fu;
    z ^= z >> 29;
    z *= 0xbf58476d1ce4e5b9u;
    return std::size_t(z ^ (z >> 32));
}

ContactCache::Entry* ContactCache::find(const Entry& like)
{
    if (entries_.empty()) return nullptr;
    const Vec3 place = widen(like.place), normal = widen(like.normal);
    Entry* best = nullptr;
    Real best_distance2 = kReach * kReach * (length2(place) + kReach * kReach);
    const auto mask = std::size_t(buckets_.size() - 1);
    for (int i = buckets_[int(hash(like.serial1, like.serial2) & mask)]; i >= 0; i = entries_[i].next) {
        Entry& e = entries_[i];
        // The flag last: that of other bodies' entries may be changing on another thread.
        if (e.serial1 != like.serial1 || e.serial2 != like.serial2 || e.used) continue;
        if (dot(widen(e.normal), normal) < kSameNormal) continue;
        const Real distance2 = length2(widen(e.place) - place);
        if (distance2 <= best_distance2) best = &e, best_distance2 = distance2;
    }
    return best;
}

void ContactCache::load(int ticket, const Joint& joint, const RowBlock& block, RowSystem& system, Real share)
{
    const Body& body = *joint.body1();
    const Entry fresh{body.serial,
                      joint.body2() ? joint.body2()->serial : 0,
                      narrow(transposed_times(body.rotation(), block.arms.r1)),
                      narrow(system.rows[std::size_t(block.first)].lin1),
                      {},
                      0,
                      -1,
                      false};
    if (ticket >= fresh_.size()) return;
    fresh_[ticket] = fresh;
    if (Entry* old = share > 0 ? find(fresh) : nullptr) {
        old->used = true;
        system.numbers[std::size_t(block.first)].p = share * Real(old->push);
        for (int i = block.first + 1; i < block.first + block.count; ++i)
            system.numbers[std::size_t(i)].p =
                share * dot(widen(old->friction), system.rows[std::size_t(i)].lin1);
    }
}

int ContactCache::buckets_for(int entries)
{
    int wanted = 16;
    while (wanted < 2 * entries) wanted *= 2;
    return wanted;
}

bool ContactCache::begin(int tickets)
{
    fresh_.clear();
    // With room to spare, the contacts of a settled pile still come and go; and as much as its partner, with
    // which it changes places after every step.
    const int most = fresh_.capacity();
    const int room = std::max(entries_.capacity(), tickets > most ? tickets + tickets / 4 : most);
    return fresh_.reserve(room) && fresh_.resize(tickets) && buckets_.reserve(buckets_for(room));
}

void ContactCache::remember(int ticket, const RowBlock& block, const RowSystem& system)
{
    if (ticket >= fresh_.size()) return;
    Vec3 friction;
    for (int i = block.first + 1; i < block.first + block.count; ++i)
        friction += system.numbers[std::size_t(i)].p * system.rows[std::size_t(i)].lin1;
    fresh_[ticket].push = float(system.numbers[std::size_t(block.first)].p);
    fresh_[ticket].friction = narrow(friction);
}

void ContactCache::drop_unused()
{
    int used = 0;
    for (int i = 0; i < fresh_.size(); ++i)
        if (fresh_[i].serial1 != 0) fresh_[used++] = fresh_[i];
    fresh_.truncate(used);
}

void ContactCache::end()
{
    drop_unused();
    entries_.swap(fresh_);
    if (const int wanted = buckets_for(entries_.size()); buckets_.size() < wanted)
        (void)buckets_.resize(wanted);  // begin() has reserved them
    std::fill(buckets_.begin(), buckets_.end(), -1);
    const auto mask = std::size_t(buckets_.size() - 1);
    // From the last to the first, so that each chain runs in order of creation.
    for (int i = entries_.size(); i-- > 0;) {
        int& bucket = buckets_[int(hash(entries_[i].serial1, entries_[i].serial2) & mask)];
        entries_[i].next = bucket;
        bucket = i;
    }
}

void ContactCache::take_back()
{
    fresh_.clear();
    for (Entry& e : entries_) e.used = false;
}

}  // namespace epode
