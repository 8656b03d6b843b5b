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
    for (const JointNode* n = find_connection(a.joints, b); n; n = find_connection(n->next, b))
        if (n->joint->type->number != dJointTypeContact) return true;
    return false;
}

bool awake(const Body* body) { return body && !body->disabled; }

// What the narrow phase reads first.
void fetch_pair(const ContactPair& pair)
{
    for (const Geom* geom : {pair.g1, pair.g2}) fetch<6>(geom), fetch<3>(geom->position);
}

// What is open and has not been pushed was only near.
bool touches(const ContactPair& part, const PatchPoint& point)
{
    return point.push > 0 || point.gap <= part.layer;
}

bool touches(std::span<const ContactPair> parts)
{
    bool any = false;
    for (const ContactPair& part : parts)
        for (int i = 0; i < part.patch.count; ++i) any = any || touches(part, part.patch.points[i]);
    return any;
}

}  // namespace

bool ContactWorld::update(const World& world, Space& in, Real h, const Tasks& tasks)
{
    clean(in);  // which a locked space is not
    const DeepLock lock(in);
    fresh_.clear();
    heads_.clear();
    if (!find_geom_pairs(in, h, found_) || !list_pairs(world) || !ended_.reserve(pairs_.size())) return false;
    collide_pairs(world, h, tasks);
    return true;
}

bool ContactWorld::list_pairs(const World& world)
{
    RecordFinder finder(pairs_, table_);
    constexpr int kAhead = 4;
    for (int i = 0; i < found_.size(); ++i) {
        if (i + kAhead < found_.size()) fetch<2>(found_[i + kAhead].a), fetch<2>(found_[i + kAhead].b);
        const GeomPair& pair = found_.data()[i];
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
    Body *body1 = body_of(g1), *body2 = body_of(g2);
    const std::span<const ContactPair> was = record(old);
    const bool asleep = !awake(body1) && !awake(body2);
    if (asleep && was.empty()) return true;  // it will be looked at when one of them wakes up
    const int parts = is_surface(g1) || is_surface(g2) ? kSurfaceParts : 1, first = fresh_.size();
    if (!fresh_.extend(parts)) return false;
    for (int part = 0; part < parts; ++part) {
        ContactPair& pair = fresh_.data()[first + part];
        if (asleep) pair = was[std::size_t(part)];  // it is as it was
        pair.g1 = &g1, pair.g2 = &g2;
        pair.id1 = to_handle(&g1), pair.id2 = to_handle(&g2);
        pair.serial1 = g1.serial, pair.serial2 = g2.serial;
        pair.body1 = body1, pair.body2 = body2;
        pair.part = part, pair.parts = parts;
        pair.old = old;
        if (!asleep) pair.patch.count = 0;
    }
    ContactPair& head = fresh_.data()[first];
    head.wanted = was.empty() ? ask_filter(head) : was[0].wanted;
    head.touched = touches(was);
    return asleep || heads_.push(first);
}

bool ContactWorld::ask_filter(const ContactPair& pair) const
{
    return !filter || filter(filter_data, pair.id1, pair.id2) != 0;
}

std::span<const ContactPair> ContactWorld::record(int old) const
{
    if (old < 0) return {};
    return pairs_.span().subspan(std::size_t(old), std::size_t(pairs_[old].parts));
}

void ContactWorld::collide_pairs(const World& world, Real h, const Tasks& tasks)
{
    const NarrowSettings settings{world.contact_layer > 0 ? world.contact_layer : kDefaultLayer, h,
                                  world.gravity};
    const auto update_one = [&](int head) {
        const ContactPair& first = fresh_.data()[head];
        const auto parts = fresh_.span().subspan(std::size_t(head), std::size_t(first.parts));
        if (!first.wanted || tied(*first.body1, first.body2)) return;
        update_pair(parts, record(first.old), settings);
    };
    // Functions of the program are called by the caller's thread, and first.
    int ours = 0;
    for (const int head : heads_) {
        if (asks_program(*fresh_[head].g1, *fresh_[head].g2))
            update_one(head);
        else
            heads_[ours++] = head;
    }
    tasks.for_each((ours + kPiece - 1) / kPiece, [&](int piece, int) {
        for (int i = piece * kPiece; i < std::min(ours, (piece + 1) * kPiece); ++i) {
            if (i + 2 < ours) fetch_pair(fresh_.data()[heads_.data()[i + 2]]);
            update_one(heads_.data()[i]);
        }
    });
}

bool ContactWorld::touching(Arena& arena, std::span<PatchEdge>& out)
{
    int count = 0;
    for (const ContactPair& pair : fresh_) count += pair.patch.count > 0;
    out = arena.take<PatchEdge>(count);
    if (arena.failed()) return false;
    std::size_t at = 0;
    for (ContactPair& pair : fresh_)
        if (pair.patch.count > 0)
            out[at++] = {{pair.body1, pair.body2}, {nullptr, nullptr}, &pair.patch, false};
    return true;
}

void ContactWorld::accept(Real h)
{
    // A pair of the last step that this one has taken over is marked; what is left and touched has ended.
    for (const ContactPair& pair : fresh_)
        if (pair.old >= 0) pairs_[pair.old].old = -2;
    ended_.clear();
    for (int i = 0; i < pairs_.size(); i += pairs_[i].parts) {
        if (pairs_[i].old != -2 && touches(record(i)))
            (void)ended_.push({dContactEnds, pairs_[i].id1, pairs_[i].id2});
    }
    pairs_.swap(fresh_);
    h_ = h;
}

void ContactWorld::forget()
{
    pairs_.clear();
    fresh_.clear();
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
    for (int i = 0; i < pairs_.size(); i += pairs_[i].parts) {
        const bool now = touches(record(i));
        if (now || pairs_[i].touched)
            add(!now                ? dContactEnds
                : pairs_[i].touched ? dContactStays
                                    : dContactBegins,
                pairs_[i].id1, pairs_[i].id2);
    }
    for (const dContactEvent& event : ended_) add(event.kind, event.g1, event.g2);
    return count;
}

int ContactWorld::contacts(dWorldContact* out, int room) const
{
    int count = 0;
    const Real per_h = h_ > 0 ? 1 / h_ : 0;
    for (const ContactPair& pair : pairs_)
        for (int i = 0; i < pair.patch.count; ++i) {
            const PatchPoint& point = pair.patch.points[i];
            if (!touches(pair, point) || count++ >= room) continue;
            dWorldContact& to = out[count - 1];
            to = {};
            to.g1 = from_handle<Geom>(pair.id1) ? pair.id1 : nullptr;
            to.g2 = from_handle<Geom>(pair.id2) ? pair.id2 : nullptr;
            store(to.pos, pair.origin + widen(point.r1));
            store(to.normal, widen(pair.patch.normal));
            to.depth = Real(pair.layer - point.gap);
            to.push = per_h * Real(point.push);
            store(to.friction, per_h * widen(point.friction));
        }
    return count;
}

}  // namespace epode
