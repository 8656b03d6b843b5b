// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/contact_world.h"

#include <algorithm>
#include <utility>

#include "base/ahead.h"
#include "collide/collide.h"
#include "contacts/narrow_phase.h"

namespace epode {
namespace {

constexpr Real kDefaultLayer = Real(2e-4);
constexpr int kPiece = 32;  // pairs

Body* body_of(const Geom& geom) { return from_handle<Body>(geom.body.id); }

bool is_surface(const Geom& geom)
{
    return geom.type->number == dTriMeshClass || geom.type->number == dHeightfieldClass;
}

// Rays measure, they do not push.
bool can_push(const Geom& geom) { return geom.type->number != dRayClass; }

// By a joint that is no contact.
bool tied(const Body& a, const Body* b)
{
    if (!b) return false;
    for (const JointNode* n = find_connection(a.lasting, b); n; n = find_connection(n->next, b))
        if (!is_contact(*n->joint)) return true;
    return false;
}

bool awake(const Body* body) { return body && !body->disabled; }

// What is open and has not been pushed was only near.
bool touches(const KeptPatch& kept, const PatchPoint& point)
{
    return point.push > 0 || point.gap <= kept.layer;
}

bool touches(std::span<const KeptPatch> patches)
{
    for (const KeptPatch& kept : patches)
        for (int i = 0; i < kept.patch.count; ++i)
            if (touches(kept, kept.patch.points[i])) return true;
    return false;
}

// What the narrow phase reads of a pair, told twice: first the geoms, then what they lead to.
void fetch_geoms(const ContactPair& pair) { fetch<6>(pair.id1), fetch<6>(pair.id2); }
void fetch_poses(const ContactPair& pair)
{
    for (const dGeomID id : {pair.id1, pair.id2}) fetch<5>(from_handle<Geom>(id)->position);
}

}  // namespace

bool ContactWorld::update(const World& world, Space& in, Real h, const Tasks& tasks)
{
    clean(in);  // which a locked space is not
    const DeepLock lock(in);
    fresh_.pairs.clear();
    fresh_.patches.clear();
    if (!find_geom_pairs(in, {h, world.gravity}, found_) || !list_pairs(world) || !make_room()) return false;
    collide_pairs(world, h, tasks);
    return true;
}

bool ContactWorld::list_pairs(const World& world)
{
    RecordFinder finder(last_.pairs, table_);
    constexpr int kAhead = 4;
    const int count = found_.size();
    const GeomPair* pairs = found_.data();
    for (int i = 0; i < count; ++i) {
        if (i + 2 * kAhead < count) fetch<2>(pairs[i + 2 * kAhead].a), fetch<2>(pairs[i + 2 * kAhead].b);
        if (i + kAhead < count)
            fetch<1>(pairs[i + kAhead].a->body.id), fetch<1>(pairs[i + kAhead].b->body.id);
        const GeomPair& pair = pairs[i];
        if (!can_push(*pair.a) || !can_push(*pair.b)) continue;
        const Body *a = body_of(*pair.a), *b = body_of(*pair.b);
        const bool moves = (a && !a->kinematic()) || (b && !b->kinematic());
        const bool ours = (!a || a->world == &world) && (!b || b->world == &world);
        if (moves && ours && !list_pair(*pair.a, *pair.b, finder)) return false;
    }
    return true;
}

bool ContactWorld::list_pair(Geom& a, Geom& b, RecordFinder& finder)
{
    Geom &g1 = a.body.id ? a : b, &g2 = a.body.id ? b : a;
    const int old = finder.find(g1.serial, g2.serial);
    if (old == -2) return false;
    ContactPair pair{to_handle(&g1), to_handle(&g2), g1.serial, g2.serial, body_of(g1), body_of(g2), old};
    // What sleeps will be looked at when one of them wakes up.
    if (old < 0 && !awake(pair.body1) && !awake(pair.body2)) return true;
    pair.most = is_surface(g1) || is_surface(g2) ? kSurfacePatches : 1;
    pair.wanted = old < 0 ? ask_filter(pair) : last_.pairs.data()[old].wanted;
    pair.parting = old < 0 ? 0 : last_.pairs.data()[old].parting;
    pair.asked = asks_program(g1, g2);
    return fresh_.pairs.push(pair);
}

bool ContactWorld::ask_filter(const ContactPair& pair) const
{
    return !filter || filter(filter_data, pair.id1, pair.id2) != 0;
}

// For all patches that there may be, and for what accept() will keep.
bool ContactWorld::make_room()
{
    int room = 0;
    for (ContactPair& pair : fresh_.pairs) {
        pair.first = room;
        room += pair.most;
    }
    return fresh_.patches.extend(room) && ended_.reserve(last_.pairs.size());
}

void ContactWorld::update_one(ContactPair& pair, int place, const NarrowSettings& settings)
{
    const std::span<const KeptPatch> old = last_.of(pair.old);
    KeptPatch* into = fresh_.patches.data() + place;
    pair.first = place;
    pair.touched = touches(old);
    if (!awake(pair.body1) && !awake(pair.body2)) {
        pair.count = std::uint8_t(old.size());
        std::copy(old.begin(), old.end(), into);
    } else if (pair.wanted && !tied(*pair.body1, pair.body2)) {
        update_pair(pair, old, settings, into);
    }
}

// Patches of a piece lie close together, at the beginning of its room: gaps cost no memory of the cache.
void ContactWorld::collide_pairs(const World& world, Real h, const Tasks& tasks)
{
    // Functions of the program are called by the caller's thread, and first; they are asked about the present
    // only.
    NarrowSettings settings{
        world.contact_layer > 0 ? world.contact_layer : kDefaultLayer, {h, world.gravity}, false};
    ContactPair* pairs = fresh_.pairs.data();
    const int count = fresh_.pairs.size();
    for (ContactPair& pair : fresh_.pairs)
        if (pair.asked) update_one(pair, pair.first, settings);
    settings.foresees = true;
    tasks.for_each((count + kPiece - 1) / kPiece, [&](int piece, int) {
        const int begin = piece * kPiece, end = std::min(count, begin + kPiece);
        int place = pairs[begin].first;
        for (int i = begin; i < end; ++i) {
            if (i + 4 < end) fetch_geoms(pairs[i + 4]);
            if (i + 2 < end) fetch_poses(pairs[i + 2]), fetch<6>(last_.of(pairs[i + 2].old).data());
            if (!pairs[i].asked) update_one(pairs[i], place, settings);
            place = pairs[i].asked ? pairs[i].first + pairs[i].most : place + pairs[i].count;
        }
    });
}

bool ContactWorld::touching(Arena& arena, std::span<PatchEdge>& out)
{
    int count = 0;
    for (const ContactPair& pair : fresh_.pairs) count += pair.count;
    out = arena.take<PatchEdge>(count);
    if (arena.failed()) return false;
    std::size_t at = 0;
    for (const ContactPair& pair : fresh_.pairs)
        for (int i = 0; i < pair.count; ++i) {
            Patch& patch = fresh_.patches.data()[pair.first + i].patch;
            out[at++] = {{pair.body1, pair.body2}, {nullptr, nullptr}, &patch, false};
        }
    return true;
}

void ContactWorld::accept(Real h)
{
    // A pair of the last step that this one has taken over is marked; what is left and touched has ended.
    for (const ContactPair& pair : fresh_.pairs)
        if (pair.old >= 0) last_.pairs[pair.old].old = -2;
    ended_.clear();
    for (const ContactPair& pair : last_.pairs)
        if (pair.old != -2 && touches(last_.of(pair))) (void)ended_.push({dContactEnds, pair.id1, pair.id2});
    std::swap(last_, fresh_);
    h_ = h;
}

void ContactWorld::forget()
{
    last_.pairs.clear();
    last_.patches.clear();
    ended_.clear();
}

int ContactWorld::events(dContactEvent* out, int room) const
{
    int count = 0;
    const auto add = [&](dContactEventKind kind, dGeomID g1, dGeomID g2) {
        const bool alive = from_handle<Geom>(g1) && from_handle<Geom>(g2);
        if (count < room) out[count] = {kind, alive ? g1 : nullptr, alive ? g2 : nullptr};
        ++count;
    };
    for (const ContactPair& pair : last_.pairs) {
        const bool now = touches(last_.of(pair));
        if (!now && !pair.touched) continue;
        add(!now ? dContactEnds : pair.touched ? dContactStays : dContactBegins, pair.id1, pair.id2);
    }
    for (const dContactEvent& event : ended_) add(event.kind, event.g1, event.g2);
    return count;
}

int ContactWorld::contacts(dWorldContact* out, int room) const
{
    int count = 0;
    const Real per_h = h_ > 0 ? 1 / h_ : 0;
    const auto add = [&](const ContactPair& pair, const KeptPatch& kept, const PatchPoint& point) {
        if (count++ >= room) return;
        dWorldContact& to = out[count - 1];
        to = {};
        to.g1 = from_handle<Geom>(pair.id1) ? pair.id1 : nullptr;
        to.g2 = from_handle<Geom>(pair.id2) ? pair.id2 : nullptr;
        store(to.pos, kept.origin + widen(point.r1));
        store(to.normal, widen(kept.patch.normal));
        to.depth = Real(kept.layer - point.gap);
        to.push = per_h * Real(point.push);
        store(to.friction, per_h * widen(point.friction));
    };
    for (const ContactPair& pair : last_.pairs)
        for (const KeptPatch& kept : last_.of(pair))
            for (int i = 0; i < kept.patch.count; ++i)
                if (touches(kept, kept.patch.points[i])) add(pair, kept, kept.patch.points[i]);
    return count;
}

}  // namespace epode
