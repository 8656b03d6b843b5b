// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/resting_pairs.h"

#include <bit>

#include "base/hash.h"

namespace epode {
namespace {

constexpr int kFewHeads = 64;

// The last of them, or -1.
int take_last(Array<int>& places)
{
    if (places.empty()) return -1;
    const int place = places.back();
    places.pop();
    return place;
}

// A free place, or a new one at the end of `all`; -1: out of memory.
template <typename T>
int place_in(Array<T>& all, int count, Array<int>& free)
{
    if (const int place = take_last(free); place >= 0) return place;
    const int end = all.size();
    return all.extend(count) ? end : -1;
}

}  // namespace

bool RestingPairs::put_one(const PairList& from, const ContactPair& pair, float step)
{
    const std::span<const CachedManifold> kept = from.of(pair);
    Array<int>& free_blocks = free_manifolds_[kept.size()];
    const int at = place_in(list_.pairs, 1, free_pairs_);
    if (at < 0) return false;
    ContactPair& own = list_.pairs.data()[at];
    own = pair;
    own.id1 = nullptr;  // until all has been found
    own.first = kept.empty() ? 0 : place_in(list_.manifolds, int(kept.size()), free_blocks);
    if (pair.on_mesh) own.leaves = place_in(list_.leaves, 1, free_leaves_);
    const bool linked = own.first >= 0 && !(pair.on_mesh && own.leaves < 0) &&
                        (links_.size() > at || links_.resize(at + 1)) && link(at);
    if (!linked) return false;  // its places are lost, as where lists of free ones are full
    own.id1 = pair.id1;
    links_[at].step = step;
    std::copy(kept.begin(), kept.end(), list_.manifolds.data() + own.first);
    if (pair.on_mesh) list_.leaves.data()[own.leaves] = from.leaves.data()[pair.leaves];
    ++count_;
    return true;
}

// For the heads of one pair's two lists: the table is at most half full. Those of empty lists go.
bool RestingPairs::reserve_heads()
{
    if (2 * (head_count_ + 2) <= heads_.size()) return true;
    int used = 0;
    for (const Head& head : heads_) used += head.serial && head.first != kEnd;
    Array<Head> larger;
    if (!larger.resize(int(std::bit_ceil(unsigned(4 * used + kFewHeads))))) return false;
    heads_.swap(larger);
    head_count_ = used;
    for (const Head& head : larger)
        if (head.serial && head.first != kEnd) place_of(head.serial) = head;
    return true;
}

RestingPairs::Head& RestingPairs::place_of(std::uint64_t serial)
{
    const auto mask = std::size_t(heads_.size() - 1);
    std::size_t at = hash_of(serial, 0) & mask;
    while (heads_.data()[at].serial && heads_.data()[at].serial != serial) at = (at + 1) & mask;
    return heads_.data()[at];
}

bool RestingPairs::link(int pair)
{
    if (!reserve_heads()) return false;
    ContactPair& p = list_.pairs.data()[pair];
    p.body1 = p.body2 = nullptr;
    p.old = -1;
    Link& own = links_.data()[pair];
    for (int side = 0; side < 2; ++side) {
        const std::uint64_t serial = serial_of(pair, side);
        Head& head = place_of(serial);
        if (!head.serial) head = {serial, kEnd}, ++head_count_;
        own.next[side] = head.first;
        own.previous[side] = kEnd;
        if (head.first != kEnd) links_.data()[head.first].previous[side_of(head.first, serial)] = pair;
        head.first = pair;
    }
    return true;
}

void RestingPairs::unlink(int pair)
{
    const Link& own = links_.data()[pair];
    for (int side = 0; side < 2; ++side) {
        const std::uint64_t serial = serial_of(pair, side);
        const int next = own.next[side], previous = own.previous[side];
        if (next != kEnd) links_.data()[next].previous[side_of(next, serial)] = previous;
        if (previous != kEnd)
            links_.data()[previous].next[side_of(previous, serial)] = next;
        else
            place_of(serial).first = next;
    }
}

bool RestingPairs::move(int pair, float h, PairList& to)
{
    ContactPair& p = list_.pairs.data()[pair];
    if (!append(pair, h, to)) return false;
    unlink(pair);
    p.id1 = nullptr;
    --count_;
    (void)free_pairs_.push(pair);
    if (p.count > 0) (void)free_manifolds_[p.count].push(p.first);
    if (p.on_mesh) (void)free_leaves_.push(p.leaves);
    return true;
}

bool RestingPairs::append(int pair, float h, PairList& to) const
{
    if (!to.append(list_, list_.pairs.data()[pair])) return false;
    const float step = links_[pair].step;
    if (h > 0 && step > 0) to.scale_impulses(to.pairs.back(), h / step);
    return true;
}

bool RestingPairs::take(std::uint64_t serial, float h, PairList& to)
{
    if (empty()) return true;
    while (true) {
        const Head& head = place_of(serial);
        if (!head.serial || head.first == kEnd) return true;
        if (!move(head.first, h, to)) return false;
    }
}

// They need not be linked.
bool RestingPairs::take_all(float h, PairList& to)
{
    for (int i = 0; i < list_.pairs.size(); ++i) {
        ContactPair& pair = list_.pairs.data()[i];
        if (!is_there(pair)) continue;
        if (!append(i, h, to)) return false;
        pair.id1 = nullptr;
        --count_;
    }
    clear();
    return true;
}

void RestingPairs::clear()
{
    list_.clear();
    links_.clear();
    for (Head& head : heads_) head = {};
    for (Array<int>* places : {&free_pairs_, &free_leaves_}) places->clear();
    for (Array<int>& places : free_manifolds_) places.clear();
    head_count_ = count_ = 0;
}

const char* RestingPairs::fault() const
{
    int count = 0;
    for (int i = 0; i < list_.pairs.size(); ++i) {
        const ContactPair& pair = list_.pairs.data()[i];
        if (!is_there(pair)) continue;
        ++count;
        if (const char* found = list_.fault(pair)) return found;
        for (int side = 0; side < 2; ++side) {
            const std::uint64_t serial = serial_of(i, side);
            const int next = links_.data()[i].next[side];
            if (next == kEnd) continue;
            const int its = side_of(next, serial);
            if (serial_of(next, its) != serial || links_.data()[next].previous[its] != i)
                return "resting pairs: a list of a geom's pairs is broken";
        }
    }
    return count != count_ ? "resting pairs: the count is wrong" : nullptr;
}

}  // namespace epode
