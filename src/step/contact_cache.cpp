// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Row layout that is relied on here: a contact block begins with its normal row, whose lin1 is the normal and
// whose ang1 is r1 x n; rows of kind kFriction with a linear part are tangents.
#include "step/contact_cache.h"

#include <algorithm>

namespace epode {
namespace {

constexpr Real kReach = Real(0.05);        // of the lever arm
constexpr Real kSameNormal = Real(0.9);    // cosine

struct Place {
    std::uint64_t serial1, serial2;
    Vec3 local, normal;
};

// The foot of the contact's line on body 1: n x (r1 x n) is the lever arm without its part along n. That
// identifies a contact on a face as well as the point itself would, and needs nothing but the row.
Place place_of(const Joint& joint, const Row& normal)
{
    const Body& body = *joint.body1();
    const Vec3 arm = cross(normal.lin1, normal.ang1);
    return {body.serial, joint.body2() ? joint.body2()->serial : 0, transposed_times(body.rotation(), arm),
            normal.lin1};
}

}  // namespace

std::size_t ContactCache::hash(std::uint64_t a, std::uint64_t b)
{
    std::uint64_t z = a * 0x9e3779b97f4a7c15u + b * 0xc2b2ae3d27d4eb4fu;
    z ^= z >> 29;
    z *= 0xbf58476d1ce4e5b9u;
    return std::size_t(z ^ (z >> 32));
}

void ContactCache::load(const Joint& joint, const RowBlock& block, RowSystem& system, Real share)
{
    if (buckets_.empty() || share <= 0) return;
    const Place place = place_of(joint, system.rows[std::size_t(block.first)]);
    const Real reach = kReach * length(place.local) + kReach * kReach;
    Entry* best = nullptr;
    Real best_distance2 = reach * reach;
    const auto mask = std::size_t(buckets_.size() - 1);
    for (int i = buckets_[int(hash(place.serial1, place.serial2) & mask)]; i >= 0; i = entries_[i].next) {
        Entry& e = entries_[i];
        if (e.used || e.serial1 != place.serial1 || e.serial2 != place.serial2) continue;
        if (dot(e.normal, place.normal) < kSameNormal) continue;
        const Real distance2 = length2(e.place - place.local);
        if (distance2 <= best_distance2) best = &e, best_distance2 = distance2;
    }
    if (!best) return;
    best->used = true;
    system.numbers[std::size_t(block.first)].p = share * best->push;
    for (int i = block.first + 1; i < block.first + block.count; ++i) {
        const Row& row = system.rows[std::size_t(i)];
        system.numbers[std::size_t(i)].p = share * dot(best->friction, row.lin1);
    }
}

bool ContactCache::begin(int contacts)
{
    fresh_.clear();
    if (fresh_.reserve(contacts)) return true;
    clear();
    return false;
}

void ContactCache::remember(const Joint& joint, const RowBlock& block, const RowSystem& system)
{
    const Place place = place_of(joint, system.rows[std::size_t(block.first)]);
    Entry e{place.serial1, place.serial2, place.local, place.normal, {}, 0, -1, false};
    e.push = system.numbers[std::size_t(block.first)].p;
    for (int i = block.first + 1; i < block.first + block.count; ++i)
        e.friction += system.numbers[std::size_t(i)].p * system.rows[std::size_t(i)].lin1;
    if (fresh_.size() < fresh_.capacity()) (void)fresh_.push(e);
}

void ContactCache::end()
{
    entries_.swap(fresh_);
    int wanted = 16;
    while (wanted < 2 * entries_.size()) wanted *= 2;
    if (buckets_.size() < wanted && !buckets_.resize(wanted)) return clear();
    std::fill(buckets_.begin(), buckets_.end(), -1);
    const auto mask = std::size_t(buckets_.size() - 1);
    // From the last to the first, so that each chain runs in order of creation.
    for (int i = entries_.size(); i-- > 0;) {
        int& bucket = buckets_[int(hash(entries_[i].serial1, entries_[i].serial2) & mask)];
        entries_[i].next = bucket;
        bucket = i;
    }
}

void ContactCache::clear()
{
    entries_.clear();
    fresh_.clear();
    buckets_.clear();
}

}  // namespace epode
