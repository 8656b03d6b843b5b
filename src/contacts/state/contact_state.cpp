// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// World-managed contacts in states of the world. Kept are pairs that touch, with the anchors and
// impulses of their manifolds, in the order of the space; of all others their separating axis
// (where it is known, what is hardly apart is never collided), what a filter has said and what the program
// may still ask about the last step. Left out is what the next step finds again:
//   where points are     and the normal: anchors and poses tell (place_again() in contacts/narrow_phase.h)
//   leaves of meshes     a list of what the tree would answer
// What rests lies apart afterwards as before, and what has been disturbed since the last step is so again.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/streams/little_endian.h"
#include "collide/collide.h"
#include "contacts/material.h"
#include "contacts/pair_rules.h"
#include "contacts/state/contact_format.h"
#include "contacts/state/contact_state.h"
#include "contacts/support.h"

namespace epode {
namespace {

// -1: it is gone, or in none of these spaces.
int number_of(dGeomID id, const SpaceGeoms& geoms)
{
    const Geom* geom = from_handle<Geom>(id);
    return geom ? geoms.find(*geom) : -1;
}

// `changes`: of both geoms, now.
void load_manifold(std::uint32_t bits, std::uint32_t changes, float layer, StateStream& stream,
                   CachedManifold& kept)
{
    const int count = int(bits & kPoints);
    if (!stream.demand(count >= 1 && count <= kManifoldPoints, "a contact with too many points")) return;
    const bool old = stream.format() < 4;
    const std::byte* const numbers = stream.block(old ? size_of_manifold_3(bits) : size_of_manifold(bits));
    if (!numbers) return;
    old ? read_manifold_3(numbers, bits, layer, kept) : read_manifold(numbers, bits, layer, kept);
    const Vec3 n = widen(kept.found.normal);
    constexpr Real kTolerance = Real(1e-4);  // as of bodies (dynamics/body_state.cpp)
    if (!stream.demand(std::fabs(dot(n, n) - 1) < kTolerance, "a normal of the state is not of unit length"))
        return;
    kept.found.changes = changes - (bits & kChanged ? 1 : 0);
}

// Of a pair's manifold i, from the bits of the pair.
std::uint32_t bits_of_manifold(std::uint32_t pair_bits, int i, int format)
{
    if (format >= 4) return unpacked(pair_bits >> (kFirstManifold + i * kManifoldBits) & 0xff);
    return pair_bits >> (kFirstManifold + i * kManifoldBits3) & ((1u << kManifoldBits3) - 1);
}

}  // namespace

// What the pairs of a geom want to know of it, found once for all of them.
bool ContactWorld::describe_geoms(const World& world, const SpaceGeoms& geoms)
{
    constexpr int kAhead = 8;
    const int count = geoms.count();
    if (!described_.resize(count)) return false;
    for (int i = 0; i < count; ++i) {
        if (i + kAhead < count) prefetch<2>(&geoms[i + kAhead]);
        const Geom& geom = geoms[i];
        const Body* const body = body_of(geom);
        const bool meets = can_push(geom) && !is_space(geom) && (!body || body->world == &world);
        described_.data()[i] = {body,
                                to_handle(&geom),
                                geom.serial,
                                changes_of(geom),
                                meets,
                                is_surface(geom),
                                geom.type->number == dTriMeshClass,
                                is_solid(geom)};
    }
    return true;
}

// All pairs in the order of the space.
bool ContactWorld::list_with_resting()
{
    listed_.clear();
    bool complete = true;
    const auto list = [&](const ContactPair& pair, std::span<const CachedManifold> manifolds, bool rests) {
        complete = complete && listed_.push({&pair, manifolds.data(), rests});
    };
    for (const ContactPair& pair : last_.pairs) list(pair, last_.of(pair), false);
    resting_.for_each([&](const ContactPair& pair, std::span<const CachedManifold> manifolds) {
        list(pair, manifolds, true);
    });
    if (!complete) return false;
    // What a geom that is gone has left is not in the state.
    const auto gone = std::remove_if(listed_.begin(), listed_.end(), [](const Listed& l) {
        return !from_handle<Geom>(l.pair->id1) || !from_handle<Geom>(l.pair->id2);
    });
    listed_.truncate(int(gone - listed_.begin()));
    std::sort(listed_.begin(), listed_.end(), [](const Listed& a, const Listed& b) {
        return in_order(slots_of(*a.pair), slots_of(*b.pair));
    });
    return true;
}

bool ContactWorld::save(const World& world, const SpaceGeoms& geoms, StateStream& stream)
{
    if (!describe_geoms(world, geoms) || (!resting_.empty() && !list_with_resting())) return false;
    const Space* in = live_space();
    const bool lost = in && !in->disturbances.knows_since(seen_disturbances_);
    const bool settled = in && is_settled(*in);
    (void)stream.word((few_active_ ? kFewActive : 0u) | (unfinished_ || lost ? kUnfinished : 0u) |
                      (settled ? kSettled : 0u));
    stream.reals(&h_, 1);
    const std::size_t place = stream.failed() ? 0 : stream.written();
    StateCounts counts;
    (void)stream.block(sizeof counts);
    save_pairs(float(contact_layer(world)), geoms, stream, counts);
    for (const dContactEvent& event : ended_) counts.ended += save_ended(event, geoms, stream);
    if (!stream.failed())
        copy_little<sizeof counts.pairs>(stream.written_at(place), &counts,
                                         sizeof counts / sizeof counts.pairs);
    return !stream.failed();
}

void ContactWorld::save_pairs(float layer, const SpaceGeoms& geoms, StateStream& stream, StateCounts& counts)
{
    if (resting_.empty())
        for (const ContactPair& pair : last_.pairs)
            save_pair({&pair, last_.of(pair).data(), false}, layer, geoms, stream, counts);
    else
        for (const Listed& listed : listed_) save_pair(listed, layer, geoms, stream, counts);
}

void ContactWorld::save_pair(const Listed& listed, float layer, const SpaceGeoms& geoms, StateStream& stream,
                             StateCounts& counts) const
{
    const ContactPair& pair = *listed.pair;
    const bool separated = !pair.on_mesh && pair.separating_axis;
    if (pair.count == 0 && !separated && !pair.touched && pair.wanted && !filter) return;
    const int n1 = geoms.find(pair.serial1), n2 = geoms.find(pair.serial2);
    if (n1 < 0 || n2 < 0 || !Described::are_pair(described_.data()[n1], described_.data()[n2])) return;
    std::byte* const begin = stream.block(kMaxPairBytes);
    if (!begin) return;
    std::byte* to = begin;
    const auto word = [&](std::uint32_t value) {
        copy_little<sizeof value>(to, &value, 1);
        to += sizeof value;
    };
    if (geoms.count() <= kNarrowGeoms)
        word(std::uint32_t(n1) | std::uint32_t(n2) << 16);
    else
        word(std::uint32_t(n1)), word(std::uint32_t(n2));
    std::byte* const bits_at = to;
    word(0);
    if (separated) word(pair.separating_axis);
    std::uint32_t struck = 0;
    for (int i = 0; i < pair.count; ++i) {
        const ContactManifold& manifold = listed.manifolds[i].manifold;
        struck |= std::uint32_t(manifold.struck) << i;
        struck |= std::uint32_t(manifold.at_border) << (kSurfaceManifolds + i);
    }
    if (struck) word(struck);
    const float step = listed.rests ? resting_.step_of(pair) : 0;
    const bool other_step = listed.rests && step != float(h_);
    if (other_step) word(std::bit_cast<std::uint32_t>(step));
    const std::uint32_t changes = described_.data()[n1].changes + described_.data()[n2].changes;
    std::uint32_t bits = pair.count | (pair.wanted ? kWanted : 0u) | (pair.touched ? kTouched : 0u) |
                         (listed.rests ? kRests : 0u) | (separated ? kSeparatingAxis : 0u) |
                         (struck ? kStruck : 0u) | (other_step ? kOtherStep : 0u);
    for (int i = 0; i < pair.count; ++i) {
        const CachedManifold& kept = listed.manifolds[i];
        std::uint32_t own = write_manifold(kept, layer, to);
        if (kept.found.changes != changes) own |= kChanged;
        bits |= packed(own) << (kFirstManifold + i * kManifoldBits);
    }
    copy_little<sizeof bits>(bits_at, &bits, 1);
    stream.end_block(to);
    ++counts.pairs, counts.manifolds += pair.count;
}

// What has ended because a geom was destroyed cannot be named in another world: it is left out.
// False: it is not in the state.
bool ContactWorld::save_ended(const dContactEvent& event, const SpaceGeoms& geoms, StateStream& stream)
{
    const int n1 = number_of(event.g1, geoms), n2 = number_of(event.g2, geoms);
    if (n1 < 0 || n2 < 0) return false;
    (void)stream.word(std::uint32_t(event.kind));
    (void)stream.word(std::uint32_t(n1)), (void)stream.word(std::uint32_t(n2));
    return true;
}

bool ContactWorld::load(const World& world, const SpaceGeoms& geoms, StateStream& stream, Loaded& out)
{
    out.clear();
    const std::uint32_t bits = stream.word(0);
    out.few_active = bits & kFewActive, out.unfinished = bits & kUnfinished, out.settled = bits & kSettled;
    stream.reals(&out.h, 1);
    const std::uint32_t pairs = stream.word(0), manifolds = stream.word(0), ended = stream.word(0);
    const std::size_t left = stream.left();
    if (!stream.demand(
            pairs <= left / kPairBytes && manifolds <= left / kManifoldBytes && ended <= left / kEventBytes,
            "the state ends too early"))
        return true;
    if (!describe_geoms(world, geoms)) return false;
    PairList& list = fresh_;
    list.clear();
    list.connections = world.connections_version;
    if (!list.pairs.reserve(int(pairs)) || !list.manifolds.extend(int(manifolds)) ||
        !out.rests.reserve(int(pairs)) || !out.ended.reserve(int(ended)))
        return false;
    std::uint32_t used = 0;
    for (std::uint32_t i = 0; i < pairs && !stream.failed(); ++i)
        if (!load_pair(world, stream, used, out)) return false;
    const auto geom = [&] {
        const std::uint32_t number = stream.index(0, std::uint32_t(geoms.count()), "an event of no geom");
        return stream.failed() ? nullptr : to_handle(&geoms[int(number)]);
    };
    for (std::uint32_t i = 0; i < ended && !stream.failed(); ++i) {
        const std::uint32_t kind = stream.index(0, dContactEnd + 1, "an event of no kind");
        const dGeomID g1 = geom(), g2 = geom();
        (void)out.ended.push({dContactEventKind(kind), g1, g2});
    }
    return true;
}

// `used`: manifolds so far. False: out of memory.
bool ContactWorld::load_pair(const World& world, StateStream& stream, std::uint32_t& used, Loaded& out)
{
    const auto count = std::uint32_t(described_.size());
    std::uint32_t n1 = stream.word(0), n2 = n1 >> 16;
    if (described_.size() <= kNarrowGeoms)
        n1 &= 0xffff;
    else
        n2 = stream.word(0);
    const std::uint32_t bits = stream.word(0);
    if (stream.failed() || !stream.demand(n1 < count && n2 < count, "a contact of no geom")) return true;
    const Described &a = described_.data()[n1], &b = described_.data()[n2];
    if (!stream.demand(n1 != n2 && Described::are_pair(a, b), "a contact of geoms that do not meet"))
        return true;
    ContactPair pair{a.id, b.id, a.serial, b.serial, nullptr, nullptr, -1, int(used), {}};
    pair.max_manifolds = std::uint8_t(a.is_surface || b.is_surface ? kSurfaceManifolds : 1);
    pair.count = std::uint8_t(bits & kManifolds);
    pair.wanted = bits & kWanted, pair.touched = bits & kTouched;
    PairList& list = fresh_;
    if (!stream.demand(
            pair.count <= pair.max_manifolds && used + pair.count <= std::uint32_t(list.manifolds.size()),
            "a contact with too many manifolds"))
        return true;
    if (bits & kSeparatingAxis) pair.separating_axis = stream.word(0);
    const std::uint32_t struck = bits & kStruck ? stream.word(0) : 0;
    auto step = float(out.h);
    if (stream.format() >= 6 && bits & kOtherStep) stream.floats(&step, 1);
    if (!stream.demand(step >= 0 && step < float(kInf),
                       "a contact at rest since a step of an impossible size"))
        return true;
    if ((pair.on_mesh = (a.is_mesh && b.is_solid) || (b.is_mesh && a.is_solid))) {
        pair.leaves = list.leaves.size();
        if (!list.leaves.push(NearLeaves{})) return false;
    }
    const auto layer = float(contact_layer(world));
    for (int i = 0; i < pair.count && !stream.failed(); ++i) {
        CachedManifold& kept = list.manifolds.data()[int(used++)];
        load_manifold(bits_of_manifold(bits, i, stream.format()), a.changes + b.changes, layer, stream, kept);
        kept.manifold.struck = struck >> i & 1;
        kept.manifold.at_border = struck >> (kSurfaceManifolds + i) & 1;
    }
    out.any_rests = out.any_rests || bits & kRests;
    (void)list.pairs.push(pair), (void)out.rests.push(bits & kRests ? step : 0);
    return true;
}

void ContactWorld::accept(World& world, Loaded& loaded, const SpaceGeoms& geoms,
                          std::span<const std::uint8_t> rest)
{
    last_.swap(fresh_);
    resting_.clear();
    ended_.swap(loaded.ended);
    h_ = loaded.h;
    few_active_ = loaded.few_active, unfinished_ = loaded.unfinished, settled_ = loaded.settled;
    Space* const in = live_space();
    if (!in) return;
    // A geom may be at rest although none of its pairs is listed.
    if (!in->keeper || in->keeper == this)
        for (int i = 0; i < geoms.count(); ++i) {
            if (geoms[i].space != in) continue;
            const bool rests = rest[std::size_t(i)] & kGeomAtRest;
            geoms[i].watched &= std::uint8_t(~kRestingPairs);  // for what touches another world may watch it
            if (rests) geoms[i].watched |= kRestingPairs;
            if (rests) in->keeper = this;
        }
    if (loaded.any_rests) put_to_rest(loaded, *in);
    if (settled_) clean(*in);  // as the step that found it settled has left the space
    edition_ = in->edition;
    seen_disturbances_ = in->disturbances.count();
    seen_disturbance_ = next_disturbance();
    any_unsupported_ = false;
    for (int i = 0; i < geoms.count(); ++i) {
        const std::uint8_t bits = rest[std::size_t(i)];
        if (bits & kGeomDisturbed && geoms[i].space == in) in->disturbances.note(geoms[i]);
        Body* const body = own_body(world, geoms[i]);
        if (!body) continue;
        geoms[i].watched &= std::uint8_t(~kUnsupported);
        if (bits & kGeomUnsupported) geoms[i].watched |= kUnsupported, any_unsupported_ = true;
        if (bits & kGeomPutDown) body->put_down = world.last_put_down = next_disturbance();
    }
    for_each_pair([](const ContactPair& pair, std::span<const CachedManifold> manifolds) {
        if (!manifolds.empty()) watch(pair, kTouch);
    });
}

// Where another world keeps pairs of the space at rest, or memory is exhausted, the next step looks
// everywhere.
void ContactWorld::put_to_rest(const Loaded& loaded, Space& in)
{
    if (in.keeper && in.keeper != this) {
        unfinished_ = true;
        return;
    }
    in.keeper = this;
    int next = 0;
    const bool complete = resting_.put(last_, [&](const ContactPair& pair) {
        const float step = loaded.rests[next++];
        if (step > 0) watch(pair, kRestingPairs);
        return step;
    });
    if (!complete) unfinished_ = true;
}

void ContactWorld::mark_rest(const World& world, const SpaceGeoms& geoms,
                             std::span<std::uint8_t> by_number) const
{
    const Space* in = live_space();
    if (!in) return;
    if (!in->keeper || in->keeper == this)
        for (int i = 0; i < geoms.count(); ++i)
            if (geoms[i].watched & kRestingPairs && geoms[i].space == in)
                by_number[std::size_t(i)] |= kGeomAtRest;
    const auto mark_unsupported = [&](const Geom& geom) {
        if (const int number = own_body(world, geom) ? geoms.find(geom) : -1; number >= 0)
            by_number[std::size_t(number)] |= kGeomUnsupported;
    };
    for (int i = 0; any_unsupported_ && i < geoms.count(); ++i)
        if (geoms[i].watched & kUnsupported) mark_unsupported(geoms[i]);
    if (in->last_disturbed > seen_disturbance_)
        for_each_pair([&](const ContactPair& pair, std::span<const CachedManifold> manifolds) {
            visit_unsupported(pair, manifolds, *in, seen_disturbance_, mark_unsupported);
        });
    if (world.last_put_down > seen_disturbance_)
        for (int i = 0; i < geoms.count(); ++i)
            if (const Body* body = own_body(world, geoms[i]); body && body->put_down > seen_disturbance_)
                by_number[std::size_t(i)] |= kGeomPutDown;
    if (!in->disturbances.knows_since(seen_disturbances_)) return;
    for (std::uint64_t i = seen_disturbances_; i < in->disturbances.count(); ++i) {
        const auto& [id, serial] = in->disturbances[i];
        const Geom* geom = from_handle<Geom>(id);
        if (!geom || geom->serial != serial || geom->space != in) continue;
        if (const int number = geoms.find(*geom); number >= 0)
            by_number[std::size_t(number)] |= kGeomDisturbed;
    }
}

}  // namespace epode
