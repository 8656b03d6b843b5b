// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/ahead/pair_ahead.h"

#include <algorithm>

#include "bvh/dynamic_tree.h"
#include "collide/solid_type.h"
#include "contacts/pair_rules.h"
#include "geometry/best_four.h"

namespace epode {
namespace {

constexpr Real kShallow = Real(0.1), kDeep = Real(0.5);  // of the thickness
constexpr int kMostPoints = 16;

Vec3 velocity_of(const Body* body) { return body ? body->velocity() : Vec3{}; }
Vec3 spin_of(const Body* body) { return body ? body->angular_velocity() : Vec3{}; }
Vec3 turn_of(const Body* body, Vec3 at)
{
    return body ? cross(body->angular_velocity(), at - body->position()) : Vec3{};
}

bool faces_alike(const dContactGeom& c, const ContactArray& out, int count)
{
    for (int i = 0; i < count; ++i)
        if (dot(load(c.normal), load(out.at(i)->normal)) > kManifoldCosine) return true;
    return false;
}

}  // namespace

Real PairAhead::way_at(Vec3 velocity) const
{
    const Real turned = length(spin_of(body1_)) + length(spin_of(body2_));
    return soon_.h * (length(velocity) + size_ * turned);
}

Real PairAhead::present_way() const { return way_at(velocity_of(body1_) - velocity_of(body2_)); }
Real PairAhead::way() const { return way_at(soon_.velocity(body1_) - soon_.velocity(body2_)); }

bool PairAhead::may_meet(bool swift) const
{
    const Aabb &box1 = box_of(first_.geom), &box2 = box_of(second_.geom);
    const Aabb end1 = soon_.box(body1_, box1), end2 = soon_.box(body2_, box2);
    return swift ? overlap(merge(box1, end1), merge(box2, end2)) : overlap(end1, end2);
}

void PairAhead::collide_after(const SpeculativeMotion& time, ContactArray& out) const
{
    out.count = 0;
    collide_at(first_.geom, first_after(time), second_.geom, second_after(time), out);
}

SpeculativeMotion PairAhead::find(bool swift, ContactArray& out) const
{
    SpeculativeMotion met = soon_;
    const bool solids = is_solid(first_.geom) && is_solid(second_.geom);
    const Real part = swift ? first_share() : 1, further = solids ? part : 1;
    for (Real share = part;; share = std::min(share + further, Real(1))) {
        met.h = share * soon_.h;
        collide_after(met, out);
        if (out.count > 0 || !(share < 1)) break;
    }
    if (out.count > 0) go_back(met, out);
    return met;
}

// Of two solids a part of the way that is no longer than they are thick; else until the middle of a solid is at a mesh.
Real PairAhead::first_share() const
{
    if (is_solid(first_.geom) && is_solid(second_.geom))
        return 1 / Real(parts_of_way(first_.geom, second_.geom, way()));
    return share_before_crossing({first_, second_, first_after(soon_), second_after(soon_)});
}

// Four points of the end that has come first leave no room for the other end. By the speed of the deepest point.
void PairAhead::go_back(SpeculativeMotion& met, ContactArray& out) const
{
    const dContactGeom deepest = *std::max_element(
        out.first, out.first + out.count, [](const auto& a, const auto& b) { return a.depth < b.depth; });
    const Real thick = thickness(first_.geom, second_.geom),
               speed = -dot(load(deepest.normal), approach(load(deepest.pos), met));
    if (!(deepest.depth > kDeep * thick) || !(speed > deepest.depth)) return;
    SpeculativeMotion before = met;
    before.h *= 1 - (deepest.depth - kShallow * thick) / speed;
    collide_after(before, out);
    if (out.count > 0)
        met = before;
    else
        collide_after(met, out);
}

SpeculativeMotion PairAhead::find_earlier(SpeculativeMotion met, ContactArray& out) const
{
    constexpr int kHalvings = 6;
    Real apart = 0;
    for (int i = 0; i < kHalvings; ++i) {
        SpeculativeMotion middle = met;
        middle.h = Real(0.5) * (apart + met.h);
        collide_after(middle, out);
        (out.count > 0 ? met.h : apart) = middle.h;
    }
    collide_after(met, out);
    return met;
}

// Pair functions give the place of a contact on one of the two surfaces, or between them; what meets at the end
// of the way is deep by much of it, and still apart now. Planes, meshes
// and height fields give it on the solid's; two solids anywhere, and the part of the first that is d deep is by d
// below the top of the second along the normal.
void PairAhead::move_to_surface(dContactGeom& c, const SpeculativeMotion& met) const
{
    const Vec3 n = load(c.normal), at = load(c.pos);
    const Real depth = c.depth > 0 ? c.depth : 0;
    Real inside = depth / 2;
    if (is_solid(first_.geom) && is_solid(second_.geom)) {
        const ConvexView other = solid_view(second_.geom, second_after(met));
        const Real top = dot(n, other.support(n)) + other.radius;
        inside = std::clamp(dot(n, at) - top + depth, Real(0), depth);
    } else if (is_solid(first_.geom) || is_solid(second_.geom)) {
        inside = is_solid(first_.geom) ? 0 : depth;
    }
    store(c.pos, at - inside * n);
}

void PairAhead::add_far(const Pose& first, const Pose& second, ContactArray& out) const
{
    add_far_points({first_.geom, first}, {second_.geom, second}, 2 * way(), out);
}

void PairAhead::add_other_parts(ContactArray& out) const
{
    if (!(way() > kDeep * thickness(first_.geom, second_.geom))) return;
    SpeculativeMotion met = soon_;
    met.h *= first_share();
    dContactGeom found[kMostPoints];
    ContactArray there{found, int(sizeof(dContactGeom)), kMostPoints, false};
    collide_after(met, there);
    const int touching = out.count;
    for (int i = 0; i < there.count && !out.full(); ++i)
        if (!faces_alike(*there.at(i), out, touching)) add_expected(*there.at(i), met, out);
}

// Points of polyhedra are corners, which turn along.
void PairAhead::add_expected(dContactGeom c, const SpeculativeMotion& met, ContactArray& out) const
{
    const Pose met1 = first_after(met), met2 = second_after(met);
    move_to_surface(c, met);
    const Vec3 n = load(c.normal), at1 = load(c.pos), at2 = at1 + c.depth * n;
    if (is_round(first_.geom) || is_round(second_.geom)) {
        const Vec3 at = straight_back(at1, at2, met);
        store(c.pos, at), c.depth += dot(n, approach(at, met));
    } else {
        const Vec3 at = first_.pose.to_world(transposed_times(met1.R, at1 - met1.p));
        store(c.pos, at),
            c.depth = dot(n, second_.pose.to_world(transposed_times(met2.R, at2 - met2.p)) - at);
    }
    if (c.depth < 0) *out.at(out.count++) = c;
}

Vec3 PairAhead::straight_back(Vec3 at1, Vec3 at2, const SpeculativeMotion& met) const
{
    return moves(body1_) ? at1 - met.h * met.velocity(body1_) : at2 - met.h * met.velocity(body2_);
}

Vec3 PairAhead::approach(Vec3 at, const SpeculativeMotion& met) const
{
    const Vec3 way1 = met.h * met.velocity(body1_), way2 = met.h * met.velocity(body2_);
    return way1 + met.h * turn_of(body1_, at) - way2 - met.h * turn_of(body2_, at);
}

}  // namespace epode
