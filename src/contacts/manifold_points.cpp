// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/manifold_points.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "collide/contact_sink.h"
#include "geometry/best_four.h"
#include "simd/pack_algebra.h"
#include "simd/quad.h"

namespace epode {
namespace {

constexpr Real kReach = Real(0.1);  // of the size

Real distance2(Float3 a, Float3 b) { return length2(widen(a) - widen(b)); }

// Index of the largest of score(0) ... score(count - 1), the first of equals.
template <typename Score>
int best_of(int count, Score&& score)
{
    int best = 0;
    Real largest = score(0);
    for (int i = 1; i < count; ++i)
        if (const Real s = score(i); s > largest) largest = s, best = i;
    return best;
}

// A point for each lane.
using Places = Vec3Of<Quad>;

Places places_of(const Pose& pose, const float (&in)[3][kManifoldPoints])
{
    const Quad x = widen(load_floats(in[0])), y = widen(load_floats(in[1])), z = widen(load_floats(in[2]));
    const auto along = [&](Real p, Vec3 row) {
        return quad(p) + (quad(row.x) * x + quad(row.y) * y + quad(row.z) * z);
    };
    return {along(pose.p.x, pose.R.row0), along(pose.p.y, pose.R.row1), along(pose.p.z, pose.R.row2)};
}

void fix(const Places& at, const Pose& pose, float (&in)[3][kManifoldPoints])
{
    const Quad x = at.x - quad(pose.p.x), y = at.y - quad(pose.p.y), z = at.z - quad(pose.p.z);
    for (int k = 0; k < 3; ++k) {
        const Vec3 axis = pose.R.column(k);
        store_floats(in[k], narrow(quad(axis.x) * x + quad(axis.y) * y + quad(axis.z) * z));
    }
}

// By point: where it is from a body, and a number.
struct Rows {
    FloatQuad of[kManifoldPoints];
    Rows(const Places& at, Vec3 from, FloatQuad number)
        : of{narrow(at.x - quad(from.x)), narrow(at.y - quad(from.y)), narrow(at.z - quad(from.z)), number}
    {
        transpose(of);
    }
};

// As it lies now: what stands keeps its side, and what lies on it would push itself along if the normal turned with it.
Vec3 normal_of(const ManifoldFinding& found, const Pose& pose1, const Pose& pose2, bool second_stands)
{
    const Vec3 n = widen(found.normal);
    if (!second_stands) return pose1.R * n;
    const Mat3 turn = {widen(found.turn[0]), widen(found.turn[1]), widen(found.turn[2])};
    return pose2.R * transposed_times(turn, n);
}

}  // namespace

Pose frame_of_anchors(const Pose& own, Vec3 x1, bool stands)
{
    constexpr Real kCell = kAnchorCell;
    if (!stands) return own;
    const Vec3 at = transposed_times(own.R, x1 - own.p);
    const Vec3 size = abs(at);
    if (std::max({size.x, size.y, size.z}) < kCell / 2) [[likely]]
        return own;
    const auto nearest = [](Real x) { return std::floor(x / kCell + Real(0.5)) * kCell; };
    const Vec3 cell{nearest(at.x), nearest(at.y), nearest(at.z)};
    return {own.p + own.R * cell, own.R};
}

void fix_points(const ManifoldMaker& maker, int part, const Pose& A, const Pose& B, Anchors how,
                ContactAnchors& anchors)
{
    const auto all = [&](auto&& number) {
        return quad_of(maker.count(part), [&](int i) { return number(maker.source(part, i)); });
    };
    const auto coordinate = [&](int k) { return all([k](const dContactGeom& c) { return c.pos[k]; }); };
    const Places at = {coordinate(0), coordinate(1), coordinate(2)};
    fix(at, A, anchors.a1);
    if (how == Anchors::kTogether) {
        fix(at, B, anchors.a2);
        store_floats(anchors.separation, narrow(all([](const dContactGeom& c) { return -c.depth; })));
        return;
    }
    const auto across = [&](int k) {
        return all([k](const dContactGeom& c) { return c.depth * c.normal[k]; });
    };
    fix({at.x + across(0), at.y + across(1), at.z + across(2)}, B, anchors.a2);
    store_floats(anchors.separation, FloatQuad{});
}

bool ManifoldMaker::at_border(int part) const
{
    for (int i = 0; i < counts_[part]; ++i) {
        const dContactGeom& c = source(part, i);
        if (c.side1 != kAtBorder && c.side2 != kAtBorder) return false;
    }
    return true;
}

Real largest_reach2(const float (&at)[3][kManifoldPoints])
{
    const FloatQuad x = load_floats(at[0]), y = load_floats(at[1]), z = load_floats(at[2]);
    const FloatQuad r2 = x * x + y * y + z * z;
    return std::max(std::max(r2[0], r2[1]), std::max(r2[2], r2[3]));
}

bool place_points(const Pose& pose1, const Pose& pose2, Vec3 x1, const Vec3* x2, Real layer,
                  const CachedManifold& was, ContactManifold& manifold)
{
    static_assert(kManifoldPoints == 4);
    const int count = was.manifold.count;
    const ContactAnchors& anchors = was.found.anchors;
    const Vec3 n = normal_of(was.found, pose1, pose2, !x2);
    manifold.normal = narrow(n);
    const Places at1 = places_of(pose1, anchors.a1), at2 = places_of(pose2, anchors.a2);
    const Quad half = quad(Real(0.5));
    const Places at = {half * (at1.x + at2.x), half * (at1.y + at2.y), half * (at1.z + at2.z)};
    const Quad apart =
        quad(n.x) * (at1.x - at2.x) + quad(n.y) * (at1.y - at2.y) + quad(n.z) * (at1.z - at2.z);
    const Quad separation = widen(load_floats(anchors.separation)) + apart;
    const Rows first(at, x1, narrow(separation + quad(layer))), second(at, x2 ? *x2 : Vec3{}, FloatQuad{});
    for (int i = 0; i < count; ++i) {
        ManifoldPoint& point = manifold.points[i];
        const float normal_impulse = was.manifold.points[i].normal_impulse;
        store_floats(&point.r1.x, first.of[i]);
        if (x2)
            store_floats(&point.r2.x, second.of[i]);
        else
            point.r2 = {};
        point.normal_impulse = normal_impulse;
    }
    return (bits(separation <= quad(0)) & ((1u << count) - 1)) != 0;
}

void place_found(const ManifoldMaker& maker, int part, Vec3 x1, const Vec3* x2, ContactManifold& manifold)
{
    for (int i = 0; i < manifold.count; ++i) {
        const Vec3 at = load(maker.source(part, i).pos);
        manifold.points[i].r1 = narrow(at - x1);
        if (x2) manifold.points[i].r2 = narrow(at - *x2);
    }
}

ManifoldMaker::ManifoldMaker(std::span<CachedManifold> parts) : parts_(parts)
{
    for (CachedManifold& part : parts_) part.manifold.count = 0;
}

// The manifold of that normal, a new one, or when there is no more the one that is nearest.
int ManifoldMaker::part_for(Vec3 normal, int kind)
{
    constexpr Real kOtherKind = 2;  // no agreement of normals outweighs it
    const auto agreement = [&](int i) {
        return dot(widen(parts_[std::size_t(i)].manifold.normal), normal) -
               (kinds_[i] == kind ? 0 : kOtherKind);
    };
    const int nearest = used_ ? best_of(used_, agreement) : -1;
    if (nearest >= 0 && (agreement(nearest) > kManifoldCosine || used_ == int(parts_.size()))) return nearest;
    parts_[std::size_t(used_)].manifold.normal = narrow(normal);
    kinds_[used_] = kind;
    return used_++;
}

void ManifoldMaker::add(const dContactGeom& contact, int kind)
{
    const int part = part_for(load(contact.normal), kind);
    if (counts_[part] < kMaxPoints) chosen_[part][counts_[part]++] = &contact;
}

void ManifoldMaker::finish()
{
    for (int part = 0; part < used_; ++part) {
        if (counts_[part] > kManifoldPoints) keep_four(part);
        parts_[std::size_t(part)].manifold.count = counts_[part];
    }
}

void ManifoldMaker::keep_four(int part)
{
    const dContactGeom** points = chosen_[part];
    ManifoldPoints lanes;
    for (int i = 0; i < counts_[part]; ++i) lanes.add(load(points[i]->pos), points[i]->depth);
    int best[kBestFour];
    const int count =
        best_four(lanes, widen(parts_[std::size_t(part)].manifold.normal), kManifoldPoints, best);
    std::uint64_t kept = 0;
    for (int i = 0; i < count; ++i) kept |= std::uint64_t(1) << best[i];
    counts_[part] = 0;
    for (; kept; kept &= kept - 1) points[counts_[part]++] = points[std::countr_zero(kept)];
}

void inherit_impulses(const CachedManifold& was, Real size, CachedManifold& part)
{
    const Real reach2 = kReach * kReach * size * size;
    bool taken[kManifoldPoints] = {};
    const ContactAnchors &here = part.found.anchors, &there = was.found.anchors;
    for (int i = 0; i < part.manifold.count; ++i) {
        if (was.manifold.count == 0) return;
        const Float3 first = here.first(i), second = here.second(i);
        const auto nearness = [&](int j) {
            return taken[j] ? -kInf
                            : -std::min(distance2(first, there.first(j)), distance2(second, there.second(j)));
        };
        const int j = best_of(was.manifold.count, nearness);
        if (-nearness(j) > reach2) continue;
        taken[j] = true;
        part.manifold.points[i].normal_impulse = was.manifold.points[j].normal_impulse;
        part.manifold.points[i].friction_impulse = was.manifold.points[j].friction_impulse;
        part.manifold.rolling_impulse = was.manifold.rolling_impulse;
        part.manifold.struck |= was.manifold.struck;
    }
}

}  // namespace epode
