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
#include <cmath>
#include <cstring>

#include "collide/collide.h"
#include "contacts/contact_format.h"
#include "contacts/contact_state.h"
#include "contacts/manifold_points.h"
#include "contacts/material.h"
#include "contacts/pair_rules.h"

namespace epode {
namespace {

// -1: it is gone, or in none of these spaces.
int number_of(dGeomID id, const SpaceGeoms& geoms)
{
    const Geom* geom = from_handle<Geom>(id);
    return geom ? geoms.find(*geom) : -1;
}

// Columns behind the last point repeat it.
void fill_anchors(ContactAnchors& anchors, int count)
{
    for (int i = count; i < kManifoldPoints; ++i) {
        for (int k = 0; k < 3; ++k)
            anchors.a1[k][i] = anchors.a1[k][count - 1], anchors.a2[k][i] = anchors.a2[k][count - 1];
        anchors.separation[i] = anchors.separation[count - 1];
    }
}

// `changes`: of both geoms, now.
void load_manifold(std::uint32_t bits, std::uint32_t changes, Real layer, StateStream& stream,
                   CachedManifold& kept)
{
    const int count = int(bits & kPoints);
    if (!stream.demand(count >= 1 && count <= kManifoldPoints, "a contact with too many points")) return;
    const std::byte* const numbers = stream.block(size_of_manifold(bits));
    if (!numbers) return;
    kept.layer = float(layer);
    ContactManifold& manifold = kept.manifold;
    manifold.count = count, manifold.normal = manifold.surface_velocity = manifold.rolling_impulse = {};
    for (int i = 0; (bits & kIdle) && i < count; ++i)
        manifold.points[i].normal_impulse = 0, manifold.points[i].friction_impulse = {};
    Reading reading{numbers};
    move_numbers(kept, bits, reading);
    const Vec3 n = widen(kept.found.normal);
    constexpr Real kTolerance = Real(1e-4);  // as of bodies (dynamics/body_state.cpp)
    if (!stream.demand(std::fabs(dot(n, n) - 1) < kTolerance, "a normal of the state is not of unit length"))
        return;
    fill_anchors(kept.found.anchors, count);
    kept.found.changes = changes - (bits & kChanged ? 1 : 0);
}

}  // namespace

// What the pairs of a geom want to know of it, found once for all of them.
bool ContactWorld::describe_geoms(const World& world, const SpaceGeoms& geoms)
{
    if (!described_.resize(geoms.count())) return false;
    for (int i = 0; i < geoms.count(); ++i) {
        const Geom& geom = geoms[i];
        const Body* const body = body_of(geom);
        const bool meets = can_push(geom) && !is_space(geom) && (!body || body->world == &world);
        described_.data()[i] = {
            body,          changes_of(geom), meets, is_surface(geom), geom.type->number == dTriMeshClass,
            is_solid(geom)};
    }
    return true;
}

// With the bits of their manifolds.
bool ContactWorld::list_for_state(const World& world, const SpaceGeoms& geoms)
{
    listed_.clear();
    listed_bytes_ = 0, listed_manifolds_ = 0;
    if (!describe_geoms(world, geoms)) return false;
    const auto layer = float(contact_layer(world));
    const bool narrow = geoms.count() <= kNarrowGeoms;
    bool complete = true;
    const auto list = [&](const ContactPair& pair, std::span<const CachedManifold> manifolds, bool rests) {
        const bool separated = !pair.on_mesh && pair.separating_axis;
        if (manifolds.empty() && !separated && !pair.touched && pair.wanted && !filter) return;
        const int n1 = geoms.find(pair.serial1), n2 = geoms.find(pair.serial2);
        if (n1 < 0 || n2 < 0 || !described_.data()[n1].body) return;
        std::uint32_t bits = pair.count | (pair.wanted ? kWanted : 0u) | (pair.touched ? kTouched : 0u) |
                             (rests ? kRests : 0u) | (separated ? kSeparatingAxis : 0u);
        const std::uint32_t changes = described_.data()[n1].changes + described_.data()[n2].changes;
        int shift = kFirstManifold;
        for (const CachedManifold& kept : manifolds)
            bits |= bits_of(changes, layer, kept) << shift, shift += kManifoldBits;
        listed_bytes_ += size_of_pair(bits, narrow), listed_manifolds_ += pair.count;
        complete = complete && listed_.push({&pair, manifolds.data(), n1, n2, bits});
    };
    for (const ContactPair& pair : last_.pairs) list(pair, last_.of(pair), false);
    if (resting_.empty()) return complete;
    resting_.for_each([&](const ContactPair& pair, std::span<const CachedManifold> manifolds) {
        list(pair, manifolds, true);
    });
    if (complete)
        std::sort(listed_.begin(), listed_.end(), [](const Listed& a, const Listed& b) {
            return in_order(slots_of(*a.pair), slots_of(*b.pair));
        });
    return complete;
}

bool ContactWorld::save(const World& world, const SpaceGeoms& geoms, StateStream& stream)
{
    const Space* in = live_space();
    if (stream.measures() && !list_for_state(world, geoms)) return false;
    const bool lost = in && !in->disturbances.knows_since(seen_disturbances_);
    const bool settled = in && is_settled(*in);
    (void)stream.word((few_active_ ? kFewActive : 0u) | (unfinished_ || lost ? kUnfinished : 0u) |
                      (settled ? kSettled : 0u));
    stream.reals(&h_, 1);
    const auto ended = int(std::count_if(ended_.begin(), ended_.end(), [&](const dContactEvent& event) {
        return number_of(event.g1, geoms) >= 0 && number_of(event.g2, geoms) >= 0;
    }));
    for (const int count : {listed_.size(), listed_manifolds_, ended})
        (void)stream.word(std::uint32_t(count));
    if (std::byte* const to = stream.block(listed_bytes_)) save_pairs(to, geoms.count() <= kNarrowGeoms);
    for (const dContactEvent& event : ended_) save_ended(event, geoms, stream);
    return true;
}

void ContactWorld::save_pairs(std::byte* to, bool narrow) const
{
    Writing writing{to};
    const auto word = [&](std::uint32_t value) {
        std::memcpy(writing.at, &value, sizeof value);
        writing.at += sizeof value;
    };
    for (const Listed& l : listed_) {
        const auto n1 = std::uint32_t(l.number1), n2 = std::uint32_t(l.number2);
        if (narrow)
            word(n1 | n2 << 16);
        else
            word(n1), word(n2);
        word(l.bits);
        if (l.bits & kSeparatingAxis) word(l.pair->separating_axis);
        for (int i = 0; i < int(l.bits & kManifolds); ++i)
            move_numbers(l.manifolds[i], bits_of_manifold(l.bits, i), writing);
    }
}

// What has ended because a geom was destroyed cannot be named in another world: it is left out.
void ContactWorld::save_ended(const dContactEvent& event, const SpaceGeoms& geoms, StateStream& stream)
{
    const int n1 = number_of(event.g1, geoms), n2 = number_of(event.g2, geoms);
    if (n1 < 0 || n2 < 0) return;
    (void)stream.word(std::uint32_t(event.kind));
    (void)stream.word(std::uint32_t(n1)), (void)stream.word(std::uint32_t(n2));
}

bool ContactWorld::load(const World& world, const SpaceGeoms& geoms, StateStream& stream, Loaded& out)
{
    const std::uint32_t bits = stream.word(0);
    out.few_active = bits & kFewActive, out.unfinished = bits & kUnfinished, out.settled = bits & kSettled;
    stream.reals(&out.h, 1);
    const std::uint32_t pairs = stream.word(0), manifolds = stream.word(0), ended = stream.word(0);
    const std::size_t left = stream.size();
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
        if (!load_pair(world, geoms, stream, used, out)) return false;
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
bool ContactWorld::load_pair(const World& world, const SpaceGeoms& geoms, StateStream& stream,
                             std::uint32_t& used, Loaded& out)
{
    const auto count = std::uint32_t(geoms.count());
    std::uint32_t n1 = stream.word(0), n2 = n1 >> 16;
    if (geoms.count() <= kNarrowGeoms)
        n1 &= 0xffff;
    else
        n2 = stream.word(0);
    const std::uint32_t bits = stream.word(0);
    if (stream.failed() || !stream.demand(n1 < count && n2 < count, "a contact of no geom")) return true;
    const Described &a = described_.data()[n1], &b = described_.data()[n2];
    if (!stream.demand(n1 != n2 && a.meets && b.meets && a.body && a.body != b.body,
                       "a contact of geoms that do not meet"))
        return true;
    const Geom &g1 = geoms[int(n1)], &g2 = geoms[int(n2)];
    ContactPair pair{
        to_handle(&g1), to_handle(&g2), g1.serial, g2.serial, nullptr, nullptr, -1, int(used), {}};
    pair.max_manifolds = std::uint8_t(a.is_surface || b.is_surface ? kSurfaceManifolds : 1);
    pair.count = std::uint8_t(bits & kManifolds);
    pair.wanted = bits & kWanted, pair.touched = bits & kTouched;
    PairList& list = fresh_;
    if (!stream.demand(
            pair.count <= pair.max_manifolds && used + pair.count <= std::uint32_t(list.manifolds.size()),
            "a contact with too many manifolds"))
        return true;
    if (bits & kSeparatingAxis) pair.separating_axis = stream.word(0);
    if ((pair.on_mesh = (a.is_mesh && b.is_solid) || (b.is_mesh && a.is_solid))) {
        pair.leaves = list.leaves.size();
        if (!list.leaves.push(NearLeaves{})) return false;
    }
    for (int i = 0; i < pair.count && !stream.failed(); ++i)
        load_manifold(bits_of_manifold(bits, i), a.changes + b.changes, contact_layer(world), stream,
                      list.manifolds.data()[int(used++)]);
    out.any_rests = out.any_rests || bits & kRests;
    (void)list.pairs.push(pair), (void)out.rests.push(bits & kRests ? 1 : 0);
    return true;
}

void ContactWorld::accept(Loaded& loaded, const SpaceGeoms& geoms, std::span<const std::uint8_t> rest)
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
            geoms[i].at_rest = rest[std::size_t(i)] & kGeomAtRest;
            if (geoms[i].at_rest) in->keeper = this;
        }
    if (loaded.any_rests) put_to_rest(loaded, *in);
    if (settled_) clean(*in);  // as the step that found it settled has left the space
    edition_ = in->edition;
    seen_disturbances_ = in->disturbances.count();
    for (int i = 0; i < geoms.count(); ++i)
        if (rest[std::size_t(i)] & kGeomDisturbed && geoms[i].space == in) in->disturbances.note(geoms[i]);
}

// Where another world keeps pairs of the space at rest, or memory is exhausted, the next step looks
// everywhere.
void ContactWorld::put_to_rest(const Loaded& loaded, Space& in)
{
    if (in.helped > 0 || (in.keeper && in.keeper != this)) {
        unfinished_ = true;
        return;
    }
    in.keeper = this;
    int next = 0;
    const bool complete = resting_.put(last_, [&](const ContactPair& pair) {
        if (!loaded.rests[next++]) return false;
        from_handle<Geom>(pair.id1)->at_rest = from_handle<Geom>(pair.id2)->at_rest = true;
        return true;
    });
    if (!complete) unfinished_ = true;
}

void ContactWorld::mark_rest(const SpaceGeoms& geoms, std::span<std::uint8_t> by_number) const
{
    const Space* in = live_space();
    if (!in) return;
    if (!in->keeper || in->keeper == this)
        for (int i = 0; i < geoms.count(); ++i)
            if (geoms[i].at_rest && geoms[i].space == in) by_number[std::size_t(i)] |= kGeomAtRest;
    if (!in->disturbances.knows_since(seen_disturbances_)) return;
    for (std::uint64_t i = seen_disturbances_; i < in->disturbances.count(); ++i) {
        const auto& [id, serial] = in->disturbances[i];
        const Geom* geom = from_handle<Geom>(id);
        if (!geom || geom->serial != serial) continue;
        if (const int number = geoms.find(*geom); number >= 0)
            by_number[std::size_t(number)] |= kGeomDisturbed;
    }
}

}  // namespace epode
