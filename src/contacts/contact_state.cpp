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
#include "contacts/contact_state.h"
#include "contacts/manifold_points.h"
#include "contacts/material.h"
#include "contacts/pair_rules.h"

namespace epode {
namespace {

enum PairBit : std::uint32_t { kManifolds = 3, kWanted = 4, kTouched = 8, kRests = 16, kSeparatingAxis = 32 };
enum ManifoldBit : std::uint32_t { kPoints = 7, kChanged = 8, kRoll = 16, kLayer = 32 };
enum ListBit : std::uint32_t { kFewActive = 1, kUnfinished = 2, kSettled = 4 };
constexpr std::size_t kPairBytes = 12, kManifoldBytes = 64, kEventBytes = 12;  // at least

std::uint32_t changes_of(const Geom& a, const Geom& b) { return epode::changes_of(a) + epode::changes_of(b); }

// -1: it is gone, or in none of these spaces.
int number_of(dGeomID id, const SpaceGeoms& geoms)
{
    const Geom* geom = from_handle<Geom>(id);
    return geom ? geoms.find(*geom) : -1;
}

bool is_zero(Float3 v) { return v.x == 0 && v.y == 0 && v.z == 0; }

// Where numbers go to, or come from, one after the other.
struct Writing {
    std::byte* at;
    template <int n>
    void operator()(const float* numbers)
    {
        std::memcpy(at, numbers, n * sizeof(float));
        at += n * sizeof(float);
    }
};
struct Reading {
    const std::byte* at;
    template <int n>
    void operator()(float* numbers)
    {
        std::memcpy(numbers, at, n * sizeof(float));
        at += n * sizeof(float);
    }
};

// All numbers of a manifold of so many points; of a constant number, since most of them are copied a few at
// once.
template <int count, typename Kept, typename Move>
void move_points(Kept& kept, std::uint32_t bits, Move& move)
{
    static_assert(offsetof(ManifoldFinding, anchors) - offsetof(ManifoldFinding, offset) ==
                  15 * sizeof(float));
    static_assert(offsetof(ManifoldPoint, friction_impulse) - offsetof(ManifoldPoint, normal_impulse) ==
                  sizeof(float));
    auto& found = kept.found;
    auto& points = kept.manifold.points;
    move.template operator()<15>(&found.offset.x);
    for (int k = 0; k < 3; ++k)
        move.template operator()<count>(found.anchors.a1[k]),
            move.template operator()<count>(found.anchors.a2[k]);
    move.template operator()<count>(found.anchors.separation);
    if (bits & kRoll) move.template operator()<3>(&kept.manifold.rolling_impulse.x);
    if (bits & kLayer) move.template operator()<1>(&kept.layer);
    for (int i = 0; i < count; ++i)
        move.template operator()<1>(&points[i].separation),
            move.template operator()<4>(&points[i].normal_impulse);
}

template <typename Kept, typename Move>
void move_numbers(Kept& kept, std::uint32_t bits, Move&& move)
{
    switch (bits & kPoints) {
        case 1:
            return move_points<1>(kept, bits, move);
        case 2:
            return move_points<2>(kept, bits, move);
        case 3:
            return move_points<3>(kept, bits, move);
        default:
            return move_points<4>(kept, bits, move);
    }
}

// Bytes of these.
std::size_t size_of(std::uint32_t bits)
{
    std::size_t numbers = 15 + 12 * std::size_t(bits & kPoints);
    if (bits & kRoll) numbers += 3;
    if (bits & kLayer) numbers += 1;
    return numbers * sizeof(float);
}

std::uint32_t bits_of(std::uint32_t changes, Real layer, const CachedManifold& kept)
{
    std::uint32_t bits = std::uint32_t(kept.manifold.count);
    if (kept.found.changes != changes) bits |= kChanged;
    if (!is_zero(kept.manifold.rolling_impulse)) bits |= kRoll;
    if (kept.layer != float(layer)) bits |= kLayer;
    return bits;
}

// Will be looked at soon.
void fetch_pair(const ContactPair& pair) { prefetch<3>(pair.id1), prefetch<3>(pair.id2); }

// Columns behind the last point repeat it.
void fill_anchors(ContactAnchors& anchors, int count)
{
    for (int i = count; i < kManifoldPoints; ++i) {
        for (int k = 0; k < 3; ++k)
            anchors.a1[k][i] = anchors.a1[k][count - 1], anchors.a2[k][i] = anchors.a2[k][count - 1];
        anchors.separation[i] = anchors.separation[count - 1];
    }
}

void load_manifold(const ContactPair& pair, Real layer, StateStream& stream, CachedManifold& kept)
{
    const std::uint32_t bits = stream.word(0);
    const int count = int(bits & kPoints);
    if (!stream.demand(count >= 1 && count <= kManifoldPoints, "a contact with too many points")) return;
    kept.layer = float(layer);
    ContactManifold& manifold = kept.manifold;
    manifold.count = count, manifold.normal = manifold.surface_velocity = manifold.rolling_impulse = {};
    const std::byte* const numbers = stream.block(size_of(bits));
    if (!numbers) return;
    move_numbers(kept, bits, Reading{numbers});
    const Vec3 n = widen(kept.found.normal);
    if (!stream.demand(std::fabs(dot(n, n) - 1) < Real(1e-3), "a normal of the state is not of unit length"))
        return;
    fill_anchors(kept.found.anchors, count);
    const Geom &g1 = *from_handle<Geom>(pair.id1), &g2 = *from_handle<Geom>(pair.id2);
    kept.found.changes = changes_of(g1, g2) - (bits & kChanged ? 1 : 0);
}

}  // namespace

// With the bits of their manifolds.
bool ContactWorld::list_for_state(const World& world, const SpaceGeoms& geoms)
{
    listed_.clear(), manifold_bits_.clear();
    const Real layer = contact_layer(world);
    bool complete = true;
    const auto list = [&](const ContactPair& pair, std::span<const CachedManifold> manifolds, bool rests) {
        const Geom *g1 = from_handle<Geom>(pair.id1), *g2 = from_handle<Geom>(pair.id2);
        if (!g1 || !g2 || !body_of(*g1)) return;
        const bool separated = !pair.on_mesh && pair.separating_axis;
        if (manifolds.empty() && !separated && !pair.touched && pair.wanted && !filter) return;
        const int n1 = geoms.find(*g1), n2 = geoms.find(*g2);
        if (n1 < 0 || n2 < 0) return;
        complete = complete && listed_.push({&pair, manifolds.data(), n1, n2, manifold_bits_.size(), rests});
        const std::uint32_t changes = manifolds.empty() ? 0 : changes_of(*g1, *g2);
        for (const CachedManifold& kept : manifolds)
            complete = complete && manifold_bits_.push(std::uint8_t(bits_of(changes, layer, kept)));
    };
    for (int i = 0; i < last_.pairs.size(); ++i) {
        constexpr int kAhead = 8;
        const ContactPair& pair = last_.pairs[i];
        if (i + kAhead < last_.pairs.size()) fetch_pair(last_.pairs[i + kAhead]);
        list(pair, last_.of(pair), false);
    }
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
    for (const int count : {listed_.size(), manifold_bits_.size(), ended})
        (void)stream.word(std::uint32_t(count));
    for (const Listed& l : listed_) save_pair(l, stream);
    for (const dContactEvent& event : ended_) save_ended(event, geoms, stream);
    return true;
}

void ContactWorld::save_pair(const Listed& l, StateStream& stream) const
{
    const ContactPair& pair = *l.pair;
    (void)stream.word(std::uint32_t(l.number1)), (void)stream.word(std::uint32_t(l.number2));
    std::uint32_t own = pair.count;
    if (pair.wanted) own |= kWanted;
    if (pair.touched) own |= kTouched;
    if (l.rests) own |= kRests;
    if (!pair.on_mesh && pair.separating_axis) own |= kSeparatingAxis;
    (void)stream.word(own);
    if (own & kSeparatingAxis) (void)stream.word(pair.separating_axis);
    for (int i = 0; i < pair.count; ++i) {
        const std::uint32_t bits = stream.word(manifold_bits_.data()[l.first_bits + i]);
        if (std::byte* to = stream.block(size_of(bits))) move_numbers(l.manifolds[i], bits, Writing{to});
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
    const std::uint32_t n1 = stream.index(0, count, "a contact of no geom"),
                        n2 = stream.index(0, count, "a contact of no geom"), bits = stream.word(0);
    if (stream.failed()) return true;
    Geom &g1 = geoms[int(n1)], &g2 = geoms[int(n2)];
    const Body *body1 = body_of(g1), *body2 = body_of(g2);
    const bool meet = n1 != n2 && can_push(g1) && can_push(g2) && !is_space(g1) && !is_space(g2) && body1 &&
                      body1->world == &world && (!body2 || body2->world == &world) && body1 != body2;
    if (!stream.demand(meet, "a contact of geoms that do not meet")) return true;
    ContactPair pair{
        to_handle(&g1), to_handle(&g2), g1.serial, g2.serial, nullptr, nullptr, -1, int(used), {}};
    pair.max_manifolds = std::uint8_t(max_manifolds({&g1, &g2}));
    pair.count = std::uint8_t(bits & kManifolds);
    pair.wanted = bits & kWanted, pair.touched = bits & kTouched;
    PairList& list = fresh_;
    if (!stream.demand(
            pair.count <= pair.max_manifolds && used + pair.count <= std::uint32_t(list.manifolds.size()),
            "a contact with too many manifolds"))
        return true;
    if (bits & kSeparatingAxis) pair.separating_axis = stream.word(0);
    if ((pair.on_mesh = on_mesh({&g1, &g2}))) {
        pair.leaves = list.leaves.size();
        if (!list.leaves.push(NearLeaves{})) return false;
    }
    for (int i = 0; i < pair.count && !stream.failed(); ++i)
        load_manifold(pair, contact_layer(world), stream, list.manifolds[int(used++)]);
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
