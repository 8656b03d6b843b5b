// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/contact_world.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "base/float_environment.h"
#include "base/prefetch.h"
#include "collide/collide.h"
#include "contacts/manifold_points.h"
#include "contacts/narrow_phase.h"
#include "contacts/pair_rules.h"
#include "dynamics/active.h"

namespace epode {
namespace {

constexpr int kPiece = 32;  // pairs
// Few are active if they are this part of all, to begin with and as long as it lasts.
constexpr int kFew = 16, kStillFew = 8;

// By a joint that is no contact.
bool tied(const Body& a, const Body* b)
{
    if (!b) return false;
    for (const JointNode* n = find_connection(a.lasting, b); n; n = find_connection(n->next, b))
        if (!is_contact(*n->joint)) return true;
    return false;
}

bool may_push(const World& world, const GeomPair& pair)
{
    if (!can_push(*pair.a) || !can_push(*pair.b)) return false;
    const Body *a = body_of(*pair.a), *b = body_of(*pair.b);
    const bool moves = (a && !a->kinematic()) || (b && !b->kinematic());
    return moves && !pair.a->sensor && !pair.b->sensor && !pair.a->character && !pair.b->character &&
           (!a || a->world == &world) && (!b || b->world == &world);
}

// False: out of memory.
bool reach(dGeomID id, Array<Body*>& reached)
{
    Body* body = body_of(*from_handle<Geom>(id));
    return !body || is_active(*body) || reached.push(body);
}

// What the narrow phase reads of a pair, told twice: first the geoms, then what they lead to.
void prefetch_geoms(const ContactPair& pair) { prefetch<6>(pair.id1), prefetch<6>(pair.id2); }
void prefetch_poses(const ContactPair& pair)
{
    for (const dGeomID id : {pair.id1, pair.id2}) {
        const Geom& geom = *from_handle<Geom>(id);
        prefetch<1>(geom.position), prefetch<2>(geom.rotation);
    }
    for (const Body* body : {pair.body1, pair.body2})
        if (body) prefetch<2>(body->lvel);
}

}  // namespace

bool ContactWorld::is_settled(const Space& in) const
{
    return settled_ && !unfinished_ && !any_unsupported_ && edition_ == in.edition && is_clean(in) &&
           in.helped == 0;
}

void ContactWorld::accept_settled(Real h)
{
    ended_.clear();
    h_ = h;
}

bool ContactWorld::leaves_at_rest(const Space& in, ActiveBodies active) const
{
    return !unfinished_ && in.helped == 0 && !is_locked(in) && (!in.keeper || in.keeper == this) &&
           in.disturbances.knows_since(seen_disturbances_) &&
           (few_active_ ? kStillFew : kFew) * active.count <= active.all;
}

bool ContactWorld::update(const World& world, Space& in, Real h, const Tasks& tasks)
{
    settled_ = false;
    all_asleep_ = true;
    take_step_size(h);
    edition_ = in.edition;
    disturbances_ = in.disturbances.count();
    disturbance_ = next_disturbance();
    few_active_ = leaves_at_rest(in, {world.bodies.active_count(), world.bodies.count()});
    unfinished_ = true;
    const SpeculativeMotion soon{h, world.gravity};
    if (few_active_ ? !expect_few(world, in, soon) : !expect_all(in, soon, tasks)) return false;
    const DeepLock lock(in);
    fresh_.clear();
    const bool found =
        few_active_ ? find_geom_pairs(in, active_, near_, found_) : find_geom_pairs(in, soon, tasks, found_);
    if (!found || !choose_pairs(world, tasks) || !list_pairs(world, tasks)) return false;
    if (filter) ask_filter();
    floor_ = 0, has_seams_ = false;
    collide_pairs(world, h, tasks);
    if (has_seams_ && !drop_hidden_contacts()) return false;
    show_manifolds(tasks);
    brought_ = last_.pairs.size();
    return true;
}

// What the last step has left are impulses of its own size.
void ContactWorld::take_step_size(Real h)
{
    if (h_ > 0 && h != h_)
        for (const ContactPair& pair : last_.pairs) last_.scale_impulses(pair, float(h) / float(h_));
    h_ = h;
}

bool ContactWorld::expect_all(Space& in, const SpeculativeMotion& soon, const Tasks& tasks)
{
    expect_motion(in, soon, tasks);
    return resting_.empty() || resting_.take_all(float(h_), last_);
}

// What is active brings its pairs back from rest.
bool ContactWorld::expect_few(const World& world, Space& in, const SpeculativeMotion& soon)
{
    in.keeper = this;
    if (!active_.gather(world, in, seen_disturbances_)) return false;
    expect_motion(in, soon, active_);
    if (!take_disturbed(in)) return false;
    for (const int slot : active_.slots())
        if (!bring(*in.geoms[slot])) return false;
    return true;
}

bool ContactWorld::bring(Geom& geom)
{
    if (!(geom.watched & kRestingPairs)) return true;
    geom.watched &= std::uint8_t(~kRestingPairs);
    return resting_.take(geom.serial, float(h_), last_);
}

bool ContactWorld::bring_pairs(const Body& body, Array<Body*>& reached)
{
    bool complete = true;
    for_each_geom_from(body.first_geom, [&](Geom& geom) {
        const int first = last_.pairs.size();
        if (!complete || geom.space != live_space()) return;
        complete = bring(geom);
        for (int i = first; i < last_.pairs.size(); ++i) {
            const ContactPair& pair = last_.pairs[i];
            if (pair.count > 0) complete = reach(pair.id1, reached) && reach(pair.id2, reached) && complete;
        }
    });
    return complete;
}

// In the space's order among the others: all is as if they had been looked at, too.
bool ContactWorld::list_brought(const World& world)
{
    if (brought_ == last_.pairs.size()) return true;
    for (; brought_ < last_.pairs.size(); ++brought_) {
        const ContactPair& old = last_.pairs[brought_];
        const int manifold = fresh_.manifolds.size(), leaf = fresh_.leaves.size();
        if (!fresh_.manifolds.extend(old.max_manifolds) || !fresh_.leaves.extend(old.on_mesh)) return false;
        const GeomPair geoms{from_handle<Geom>(old.id1), from_handle<Geom>(old.id2), brought_};
        ContactPair pair = pair_of(world, geoms, manifold, leaf);
        (void)leaves_of(pair);
        keep_manifolds(pair, manifold);
        if (!fresh_.pairs.push(pair)) return false;
    }
    std::sort(fresh_.pairs.begin(), fresh_.pairs.end(),
              [](const ContactPair& a, const ContactPair& b) { return in_order(slots_of(a), slots_of(b)); });
    return true;
}

// Which of the pairs that were found are this world's, and what each was in the last step; those that are
// chosen move to the beginning of their range.
bool ContactWorld::choose_pairs(const World& world, const Tasks& tasks)
{
    const int count = (found_.size() + kPairRange - 1) / kPairRange;
    ranges_.clear();
    RecordFinder shared(last_.pairs, table_);
    if (!ranges_.resize(count + 1) || (tasks.workers() > 1 && !shared.make_table())) return false;
    std::atomic<bool> complete{true};
    tasks.for_each(count, [&](int range, int) {
        RecordFinder own = shared;
        if (!choose_range(world, range, tasks.workers() > 1 ? own : shared)) complete = false;
    });
    return complete;
}

bool ContactWorld::choose_range(const World& world, int range, RecordFinder& finder)
{
    const int first = range * kPairRange, last = std::min(found_.size(), first + kPairRange);
    GeomPair *to = found_.data() + first, *pairs = to;
    int known = 0;
    while (first + known < last && pairs[known].a) ++known;
    PairRange& sum = ranges_[range];
    for (int i = 0; i < known; ++i) {
        constexpr int kAhead = 4;
        if (i + 2 * kAhead < known)
            prefetch<2>(pairs[i + 2 * kAhead].a), prefetch<2>(pairs[i + 2 * kAhead].b);
        if (i + kAhead < known)
            prefetch<1>(pairs[i + kAhead].a->body.id), prefetch<1>(pairs[i + kAhead].b->body.id);
        GeomPair pair = pairs[i];
        if (!may_push(world, pair)) continue;
        if (!pair.a->body.id) std::swap(pair.a, pair.b);
        pair.old = finder.find(pair.a->serial, pair.b->serial);
        if (pair.old == -2) return false;
        // What sleeps will be looked at when one of them wakes up.
        if (pair.old < 0 && !awake(body_of(*pair.a)) && !awake(body_of(*pair.b))) continue;
        *to++ = pair;
        ++sum.pairs, sum.manifolds += max_manifolds(pair), sum.leaves += on_mesh(pair);
    }
    return true;
}

// Room for all manifolds that there may be, and for what accept() will keep.
bool ContactWorld::list_pairs(const World& world, const Tasks& tasks)
{
    fresh_.connections = world.connections_version;
    PairRange total;
    for (PairRange& range : ranges_) {
        const PairRange own = range;
        range = total;
        total.pairs += own.pairs, total.manifolds += own.manifolds, total.leaves += own.leaves;
    }
    if (!fresh_.pairs.extend(total.pairs) || !fresh_.manifolds.extend(total.manifolds) ||
        !fresh_.leaves.extend(total.leaves) || !ended_.reserve(last_.pairs.size()))
        return false;
    tasks.for_each(ranges_.size() - 1, [&](int range, int) {
        PairRange at = ranges_[range];
        const GeomPair* from = found_.data() + range * kPairRange;
        for (; at.pairs < ranges_[range + 1].pairs; ++from) {
            ContactPair& pair = fresh_.pairs.data()[at.pairs++];
            pair = pair_of(world, *from, at.manifolds, at.leaves);
            at.leaves += pair.on_mesh;
            at.manifolds += pair.max_manifolds;
        }
    });
    return true;
}

// `manifold`, `leaf`: where its own begin.
ContactPair ContactWorld::pair_of(const World& world, const GeomPair& from, int manifold, int leaf) const
{
    Geom &a = *from.a, &b = *from.b;
    ContactPair pair{to_handle(&a), to_handle(&b), a.serial, b.serial, body_of(a),
                     body_of(b),    from.old,      manifold, {}};
    pair.max_manifolds = std::uint8_t(max_manifolds(from));
    const ContactPair* old = from.old < 0 ? nullptr : last_.pairs.data() + from.old;
    pair.wanted = !old || old->wanted;
    const bool as_before = old && last_.connections == world.connections_version &&
                           old->body1 == pair.body1 && old->body2 == pair.body2;
    pair.tied = as_before ? old->tied : tied(*pair.body1, pair.body2);
    if ((pair.on_mesh = on_mesh(from)))
        pair.leaves = leaf;
    else
        pair.separating_axis = old ? old->separating_axis : 0;
    pair.asked = may_call_program(a, b);
    return pair;
}

// About those that are new.
void ContactWorld::ask_filter()
{
    const CallerFloatEnvironment program;
    for (ContactPair& pair : fresh_.pairs)
        if (pair.old < 0) pair.wanted = filter(filter_data, pair.id1, pair.id2) != 0;
}

void ContactWorld::update_one(ContactPair& pair, int place, const NarrowSettings& settings)
{
    const std::span<const CachedManifold> old = last_.of(pair.old);
    NearLeaves* const leaves = leaves_of(pair);
    if (!awake(pair.body1) && !awake(pair.body2)) return keep_manifolds(pair, place);
    pair.first = place;
    pair.touched = touches(old);
    if (all_asleep_.load(std::memory_order_relaxed)) all_asleep_.store(false, std::memory_order_relaxed);
    if (pair.wanted && !pair.tied) update_pair(pair, old, settings, fresh_.manifolds.data() + place, leaves);
    if (pair.count == 0) return;
    watch(pair, kTouch);
    note_floor(pair);
}

// Those of the step before.
void ContactWorld::keep_manifolds(ContactPair& pair, int place)
{
    const std::span<const CachedManifold> old = last_.of(pair.old);
    pair.first = place;
    pair.touched = touches(old);
    pair.count = std::uint8_t(old.size());
    CachedManifold* const to = fresh_.manifolds.data() + place;
    std::copy(old.begin(), old.end(), to);
    for (std::size_t i = 0; i < old.size(); ++i) place_again(pair, to[i]);
    if (pair.count > 0) watch(pair, kTouch);
}

// What the pair kept in the step before, or nothing yet.
NearLeaves* ContactWorld::leaves_of(const ContactPair& pair)
{
    if (!pair.on_mesh) return nullptr;
    NearLeaves* leaves = fresh_.leaves.data() + pair.leaves;
    if (pair.old < 0)
        leaves->edition = 0;
    else
        *leaves = last_.leaves.data()[last_.pairs.data()[pair.old].leaves];
    return leaves;
}

// Manifolds of a piece lie close together, at the beginning of its room: gaps cost no memory of the cache.
void ContactWorld::collide_pairs(const World& world, Real h, const Tasks& tasks)
{
    // Functions of the program are called by the caller's thread, and first; those that collide geoms about the
    // present only.
    NarrowSettings settings{.layer = contact_layer(world),
                            .is_set = world.contact_layer > 0,
                            .soon = {h, world.gravity},
                            .foresees = false};
    ContactPair* pairs = fresh_.pairs.data();
    const int count = fresh_.pairs.size();
    for (ContactPair& pair : fresh_.pairs) {
        if (!pair.asked) continue;
        settings.foresees = !program_collides(*from_handle<Geom>(pair.id1), *from_handle<Geom>(pair.id2));
        update_one(pair, pair.first, settings);
    }
    settings.foresees = true;
    tasks.for_each((count + kPiece - 1) / kPiece, [&](int piece, int) {
        constexpr int kAhead = 4;
        const int begin = piece * kPiece, end = std::min(count, begin + kPiece);
        int place = pairs[begin].first;
        for (int i = begin; i < end; ++i) {
            if (i + 2 * kAhead < end) prefetch_geoms(pairs[i + 2 * kAhead]);
            if (i + kAhead < end)
                prefetch_poses(pairs[i + kAhead]), prefetch<6>(last_.of(pairs[i + kAhead].old).data());
            if (!pairs[i].asked) update_one(pairs[i], place, settings);
            place = pairs[i].asked ? pairs[i].first + pairs[i].max_manifolds : place + pairs[i].count;
        }
    });
}

bool ContactWorld::touching(const Tasks& tasks, Arena& arena, std::span<ManifoldEdge>& out)
{
    const int ranges = (fresh_.pairs.size() + kPairRange - 1) / kPairRange;
    const auto range = [&](int i) {
        const int first = i * kPairRange, last = std::min(fresh_.pairs.size(), first + kPairRange);
        return std::span(fresh_.pairs.data() + first, std::size_t(last - first));
    };
    const auto begin = arena.take_zeroed<int>(ranges + 1);
    if (arena.failed()) return false;
    tasks.for_each(ranges, [&](int i, int) {
        for (const ContactPair& pair : range(i)) begin[std::size_t(i) + 1] += pair.count;
    });
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    out = arena.take<ManifoldEdge>(begin.back());
    if (arena.failed()) return false;
    tasks.for_each(ranges, [&](int i, int) {
        ManifoldEdge* to = out.data() + begin[std::size_t(i)];
        for (const ContactPair& pair : range(i))
            for (int k = 0; k < pair.count; ++k) {
                ContactManifold& manifold = fresh_.manifolds.data()[pair.first + k].manifold;
                *to++ = {{pair.body1, pair.body2}, {nullptr, nullptr}, &manifold, {-1, -1}};
            }
    });
    return true;
}

void ContactWorld::accept(Real h, const Tasks& tasks)
{
    // A pair of the last step that this one has taken over is marked; what is left and touched has ended.
    tasks.each_of(fresh_.pairs.size(), kPairRange, [&](std::size_t i) {
        if (const int old = fresh_.pairs.data()[i].old; old >= 0) last_.pairs.data()[old].old = kTakenOver;
    });
    ended_.clear();
    for (const ContactPair& pair : last_.pairs)
        if (pair.old != kTakenOver && touches(last_.of(pair)))
            (void)ended_.push({dContactEnd, pair.id1, pair.id2});
    last_.swap(fresh_);
    h_ = h;
    settled_ = all_asleep_;
    seen_disturbances_ = disturbances_;
    seen_disturbance_ = disturbance_;
    any_unsupported_ = false;
    unfinished_ = false;
}

void ContactWorld::lay_to_rest()
{
    const auto is_idle = [](const Body* body) { return !body || !is_active(*body); };
    const bool complete = resting_.put(last_, [&](const ContactPair& pair) {
        if (!is_idle(pair.body1) || !is_idle(pair.body2)) return 0.0f;
        watch(pair, kRestingPairs);
        return float(h_);
    });
    if (!complete) unfinished_ = true;  // so that the next update looks everywhere
}

void ContactWorld::forget()
{
    if (Space* in = live_space(); in && in->keeper == this) in->keeper = nullptr;
    last_.clear();
    resting_.clear();
    ended_.clear();
    settled_ = unfinished_ = any_unsupported_ = few_active_ = false;
}

void ContactWorld::shift(Vec3 by)
{
    // What stands on a plane has its anchors in the world: with another lattice point they are found again.
    constexpr std::uint32_t kOutdated = 1u << 31;
    const auto shift_pair = [&](const ContactPair& pair, std::span<CachedManifold> manifolds) {
        const Geom* const g2 = from_handle<Geom>(pair.id2);
        const bool on_plane = g2 && g2->type->number == dPlaneClass;
        for (CachedManifold& kept : manifolds) {
            const Vec3 before = frame_of_anchors({}, kept.origin, true).p;
            kept.origin += by;
            const Vec3 after = frame_of_anchors({}, kept.origin, true).p;
            if (on_plane && after != before + by) kept.found.changes ^= kOutdated;
        }
    };
    for (const ContactPair& pair : last_.pairs) shift_pair(pair, last_.own(pair));
    resting_.for_each_own(shift_pair);
}

const char* ContactWorld::fault() const
{
    for (const ContactPair& pair : last_.pairs) {
        if (pair.serial1 == pair.serial2) return "contacts: a pair of one geom with itself";
        if (const char* found = last_.fault(pair)) return found;
    }
    return resting_.fault();
}

int ContactWorld::events(dContactEvent* out, int capacity) const
{
    int count = 0;
    const auto add = [&](dContactEventKind kind, dGeomID g1, dGeomID g2) {
        const bool alive = from_handle<Geom>(g1) && from_handle<Geom>(g2);
        if (count < capacity) out[count] = {kind, alive ? g1 : nullptr, alive ? g2 : nullptr};
        ++count;
    };
    for_each_pair([&](const ContactPair& pair, std::span<const CachedManifold> manifolds) {
        const bool now = touches(manifolds);
        if (!now && !pair.touched) return;
        add(!now ? dContactEnd : pair.touched ? dContactPersist : dContactBegin, pair.id1, pair.id2);
    });
    for (const dContactEvent& event : ended_) add(event.kind, event.g1, event.g2);
    return count;
}

int ContactWorld::contacts(dWorldContact* out, int capacity) const
{
    int count = 0;
    const Real per_h = h_ > 0 ? 1 / h_ : 0;
    const auto add = [&](const ContactPair& pair, const CachedManifold& kept, const ManifoldPoint& point) {
        if (count++ >= capacity) return;
        dWorldContact& to = out[count - 1];
        to = {};
        to.g1 = from_handle<Geom>(pair.id1) ? pair.id1 : nullptr;
        to.g2 = from_handle<Geom>(pair.id2) ? pair.id2 : nullptr;
        store(to.pos, kept.origin + widen(point.r1));
        store(to.normal, widen(kept.manifold.normal));
        to.depth = Real(kept.layer - point.separation);
        to.normal_force = per_h * Real(point.normal_impulse);
        store(to.friction_force, per_h * widen(point.friction_impulse));
    };
    for_each_pair([&](const ContactPair& pair, std::span<const CachedManifold> manifolds) {
        for (const CachedManifold& kept : manifolds) {
            CachedManifold placed;
            const bool unplaced = is_unplaced(kept);
            if (unplaced) placed = kept, place_again(pair, placed);
            const CachedManifold& now = unplaced ? placed : kept;
            for (int i = 0; i < now.manifold.count; ++i)
                if (touches(now, now.manifold.points[i])) add(pair, now, now.manifold.points[i]);
        }
    });
    return count;
}

}  // namespace epode
