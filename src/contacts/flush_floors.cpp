// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Floors laid edge to edge: tiles of terrain, boxes side by side, a mesh next to a box. Each pair knows one
// of them only, and sees an edge or a side where the other one continues: what slides along is held back
// there, by as much as it has sunk in.
// A convex solid that touches a floor A in q, with the normal a of A, is above the plane P across a in q, but
// for what it has sunk in. So nothing below that plane is in its way. A contact with another floor B at p,
// normal b, is dropped where
//   b . t > kLean |t|,  t = (q - p) across a   it holds the solid back from p (ball, capsule: p is not q), and
//   B is below P + flush, p near A             of a convex B; flush = kFlush size of the solid
//   B ends at p, p in P up to flush            of a mesh or height field, which may rise elsewhere
// Of one mesh, too, whose parts are not connected. What moves holds nothing back that slides: only what
// stands counts.
// Rejected: to tell each field of its neighbours, which move, come and go.
#include <algorithm>

#include "contacts/contact_world.h"
#include "contacts/manifold_points.h"
#include "contacts/pair_rules.h"
#include "geometry/overlap/gjk.h"

namespace epode {
namespace {

constexpr Real kFlush = Real(0.01);
constexpr Real kLean = Real(0.01);

// A solid and a floor, and a manifold of theirs.
struct Touch {
    const ContactPair& pair;
    bool first;  // the solid is g1
    const CachedManifold& kept;

    Geom& solid() const { return *from_handle<Geom>(first ? pair.id1 : pair.id2); }
    Geom& floor() const { return *from_handle<Geom>(first ? pair.id2 : pair.id1); }
    int count() const { return kept.manifold.count; }
    Vec3 normal() const
    {
        const Vec3 n = widen(kept.manifold.normal);
        return first ? n : -n;
    }
    // On the floor's surface, if it is no solid: contacts lie on that of the solid then.
    Vec3 place(int i) const
    {
        const ContactAnchors& anchors = kept.found.anchors;
        const Pose frame = frame_of_anchors(pose_of(floor()), pair.body1->position(), first && !pair.body2);
        const Vec3 at = frame.to_world(widen(first ? anchors.second(i) : anchors.first(i)));
        return is_solid(floor()) ? at : at - Real(anchors.separation[i]) * normal();
    }
    Real depth(int i) const { return std::fabs(Real(kept.found.anchors.separation[i])); }
};

Real flush_of(const Touch& touch)
{
    const Aabb& box = box_of(touch.solid());
    return kFlush * max_component(box.hi - box.lo) / 2;
}

Real top_along(Geom& solid, Vec3 n)
{
    const ConvexView view = solid_view(solid, pose_of(solid));
    return dot(n, view.support(n)) + view.radius;
}

bool is_near(Geom& solid, Vec3 p, Real reach)
{
    const Sphere point{0};
    const ConvexView view = solid_view(solid, pose_of(solid));
    return gjk_distance(view, view_of(point, Pose{p, Mat3::identity()}), reach + view.radius).distance <=
           reach + view.radius;
}

// Whether the floor of `on` lets nothing be in the way where `at` has its contacts.
bool hides(const Touch& on, const Touch& at, Real flush)
{
    const Vec3 a = on.normal(), b = at.normal();
    if (is_solid(at.floor())) {
        const Real plane = is_solid(on.floor()) ? top_along(on.floor(), a) : dot(a, on.place(0));
        if (top_along(at.floor(), a) > plane + flush) return false;
        for (int i = 0; i < at.count(); ++i)
            if (is_solid(on.floor()) && !is_near(on.floor(), at.place(i), flush + at.depth(i))) return false;
    }
    const bool ends = !is_solid(at.floor());
    // A ball or capsule that touches the floor itself has no part in its edge, wherever that would send it.
    const bool by_face = ends && solid_view(at.solid(), pose_of(at.solid())).radius > 0;
    for (int j = 0; j < on.count(); ++j) {
        bool all = true;
        for (int i = 0; all && i < at.count(); ++i) {
            const Vec3 way = on.place(j) - at.place(i), t = way - dot(a, way) * a;
            const bool held = by_face ? length(t) > kLean * flush : dot(b, t) > kLean * length(t);
            all = held && (!ends || std::fabs(dot(a, way)) <= flush);
        }
        if (all) return true;
    }
    return false;
}

}  // namespace

bool ContactWorld::has_border(const ContactPair& pair) const
{
    const std::span<const CachedManifold> own = fresh_.of(pair);
    return std::any_of(own.begin(), own.end(), [](const CachedManifold& m) { return m.manifold.at_border; });
}

// By any worker: there may be something to drop if a surface ends, or if two floors are touched.
void ContactWorld::note_floor(const ContactPair& pair)
{
    if (pair.max_manifolds > 1 && has_border(pair)) has_seams_.store(true, std::memory_order_relaxed);
    if (moves(pair.body1) && moves(pair.body2)) return;
    const std::uint64_t floor = moves(pair.body1) ? pair.serial2 : pair.serial1;
    std::uint64_t known = floor_.load(std::memory_order_relaxed);
    if (known == 0) floor_.compare_exchange_strong(known, floor, std::memory_order_relaxed);
    if (known != 0 && known != floor) has_seams_.store(true, std::memory_order_relaxed);
}

// Awake solids on what stands, by solid.
bool ContactWorld::list_floors()
{
    floors_.clear();
    for (int i = 0; i < fresh_.pairs.size(); ++i) {
        const ContactPair& pair = fresh_.pairs[i];
        if (pair.count == 0 || (moves(pair.body1) && moves(pair.body2))) continue;
        const bool first = moves(pair.body1);
        if (!awake(first ? pair.body1 : pair.body2)) continue;
        if (!is_solid(*from_handle<Geom>(first ? pair.id1 : pair.id2))) continue;
        if (!floors_.push({first ? pair.serial1 : pair.serial2, i, first})) return false;
    }
    const auto before = [](const FloorPair& a, const FloorPair& b) {
        return a.solid < b.solid || (a.solid == b.solid && a.pair < b.pair);
    };
    if (!std::is_sorted(floors_.begin(), floors_.end(), before))
        std::sort(floors_.begin(), floors_.end(), before);
    return true;
}

// Manifolds of one floor that another one hides lose their points.
void ContactWorld::empty_hidden(const FloorPair& at, const FloorPair& on)
{
    const ContactPair &pair_at = fresh_.pairs[at.pair], &pair_on = fresh_.pairs[on.pair];
    for (int i = 0; i < pair_at.count; ++i) {
        CachedManifold& kept = fresh_.manifolds[pair_at.first + i];
        const Touch touch{pair_at, at.first, kept};
        if (!is_solid(touch.floor()) && !kept.manifold.at_border) continue;
        for (const CachedManifold& other : fresh_.of(pair_on)) {
            if (&other == &kept || other.manifold.at_border || other.manifold.count == 0) continue;
            if (!hides({pair_on, on.first, other}, touch, flush_of(touch))) continue;
            kept.manifold.count = 0;
            break;
        }
    }
}

bool ContactWorld::drop_hidden_contacts()
{
    if (!list_floors()) return false;
    for (int i = 0, end; i < floors_.size(); i = end) {
        for (end = i + 1; end < floors_.size() && floors_[end].solid == floors_[i].solid;) ++end;
        for (int at = i; at < end; ++at)
            for (int on = i; on < end; ++on) empty_hidden(floors_[at], floors_[on]);
        for (int at = i; at < end; ++at) {
            ContactPair& pair = fresh_.pairs[floors_[at].pair];
            CachedManifold* const own = fresh_.manifolds.data() + pair.first;
            const auto is_empty = [](const CachedManifold& m) { return m.manifold.count == 0; };
            pair.count = std::uint8_t(std::remove_if(own, own + pair.count, is_empty) - own);
        }
    }
    return true;
}

}  // namespace epode
