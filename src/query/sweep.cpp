// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See sweep.h.
#include "query/sweep.h"

#include <algorithm>

#include "query/query_shape.h"

namespace epode {
namespace {

constexpr int kSweepAdvances = 200;
constexpr Real kLevel = kSingle ? Real(1e-5) : Real(1e-10);  // slope below which a path does not approach

// Solids within this distance touch.
Real touch_of(const ConvexView& a) { return (kSingle ? Real(1e-4) : Real(1e-8)) * (a.size + a.radius); }

SweepHit met(Real distance, const Separation& s)
{
    SweepHit hit;
    hit.distance = distance;
    hit.pos = s.on_b;
    hit.normal = s.normal;
    hit.side = s.side_b;
    hit.depth = std::max(-s.distance, Real(0));
    return hit;
}

SweepHit touched(Real distance, const Separation& s)
{
    SweepHit hit = met(distance, s);
    hit.depth = 0;
    return hit;
}

// separation_at(t, limit): separation of the solid, moved by t, from a convex shape.
template <typename SeparationAt>
SweepHit advance(const Way& way, Real limit, Real touch, const SeparationAt& separation_at)
{
    Real t = 0;
    Separation s;
    for (int i = 0; i < kSweepAdvances; ++i) {
        s = separation_at(t, limit - t + touch);
        if (!(s.distance < kInf)) return {};
        const Real closing = -dot(way.along, s.normal);
        if (s.distance < -touch && i == 0) return way.skips_overlaps ? SweepHit{} : met(t, s);
        if (closing <= kLevel) return {};
        if (s.distance <= touch) return touched(t, s);
        t += (s.distance - Real(0.5) * touch) / closing;
        if (t > limit) return {};
    }
    return touched(t, s);  // grazing: stopped a little early
}

ConvexView moved(const ConvexView& v, Vec3 by)
{
    ConvexView out = v;
    out.pose.p += by;
    return out;
}

SweepHit sweep_solid(const ConvexView& a, const Way& way, const ConvexView& b, Real limit)
{
    return advance(way, limit, touch_of(a), [&](Real t, Real max_distance) {
        return separation(moved(a, t * way.along), b, max_distance);
    });
}

SweepHit sweep_plane(const ConvexView& a, const Way& way, const Plane& b, Real limit)
{
    return advance(way, limit, touch_of(a),
                   [&](Real t, Real) { return separation(moved(a, t * way.along), b); });
}

// All in the frame of the triangles.
SweepHit sweep_triangles(const ConvexView& a, const Way& way, const TriangleSet& b, Real limit,
                         Effort& effort)
{
    SweepHit best;
    const Aabb around = grown(box_around(a), touch_of(a));
    if (b.count() == 0) return best;
    const Real own = max_component(around.hi - around.lo);
    const Real piece = std::max(2 * own, limit / 256);
    for (Real from = 0; from <= limit; from += piece) {
        const Real to = std::min(from + piece, limit);
        const Vec3 first = from * way.along, last = to * way.along;
        const Aabb swept = {around.lo + min(first, last), around.hi + max(first, last)};
        if (!effort.spend(1)) break;
        b.query(swept, effort, [&](const Triangle& t, int side) {
            const ConvexView view = view_of(t);
            const Real max_distance = best.distance < limit ? best.distance : limit;
            SweepHit hit = advance(way, max_distance, touch_of(a), [&](Real at, Real reach) {
                if (!effort.spend(Effort::kDistance)) return Separation{};
                return separation(moved(a, at * way.along), view, reach);
            });
            hit.side = side;
            if (hit.before(best)) best = hit;
        });
        if (best.distance <= to || to >= limit) break;
    }
    return best;
}

SweepHit sweep_surface(const ConvexView& a, const Way& way, const QueryShape& surface, Real limit)
{
    Effort effort(mesh_triangles(surface));
    const Way local = {transposed_times(surface.pose.R, way.along), way.length, way.skips_overlaps};
    SweepHit hit = sweep_triangles(in_frame(surface.pose, a), local, triangles_of(surface), limit, effort);
    hit.cut_short = effort.is_cut_short();
    hit.pos = surface.pose.to_world(hit.pos);
    hit.normal = surface.pose.R * hit.normal;
    return hit;
}

SweepHit sweep_mesh(const ConvexView& a, const QueryShape& solid, const Way& way, const QueryShape& mesh,
                    Real limit)
{
    Separation inside;
    if (in_mesh(solid, mesh, inside) && inside.distance < -touch_of(a))
        return way.skips_overlaps ? SweepHit{} : met(0, inside);
    return sweep_surface(a, way, mesh, limit);
}

SweepHit sweep_field(const ConvexView& a, const QueryShape& solid, const Way& way, const QueryShape& field,
                     Real limit)
{
    Separation terrain;
    if (!way.skips_overlaps && in_terrain(solid, field, terrain) && terrain.distance < -touch_of(a))
        return met(0, terrain);
    SweepHit hit = sweep_surface(a, way, field, limit);
    hit.side = -1;
    return hit;
}

}  // namespace

bool is_solid(Geom& geom) { return kind_of(query_shape_of(geom)) == QueryKind::kSolid; }

SweepHit sweep(Geom& solid, const Way& way, Geom& other, Real limit)
{
    const QueryShape a = query_shape_of(solid), b = query_shape_of(other);
    const QueryKind kind = kind_of(b);
    if (kind == QueryKind::kNone) return {};
    // A ray geom is cut to the length that reaches the other geom along the path.
    Capsule memory_a, memory_b;
    const Real far = kEndless * (length(a.pose.p - b.pose.p) + way.length);
    const BoundingBall ball_a = ball_about(a, far);
    BoundingBall ball_b = {a.pose.p, far};
    if (kind == QueryKind::kSolid) ball_b = ball_about(b, far);
    if (kind == QueryKind::kMesh || kind == QueryKind::kField) ball_b = ball_about(triangles_of(b), b.pose);
    const ConvexView view = solid_view(a, ball_b.centre, ball_b.reach + way.length, memory_a);
    SweepHit hit;
    if (kind == QueryKind::kSolid)
        hit =
            sweep_solid(view, way, solid_view(b, ball_a.centre, ball_a.reach + way.length, memory_b), limit);
    else if (kind == QueryKind::kPlane)
        hit = sweep_plane(view, way, b.as<Plane>(), limit);
    else if (kind == QueryKind::kField)
        hit = sweep_field(view, a, way, b, limit);
    else
        hit = sweep_mesh(view, a, way, b, limit);
    hit.named = b.named;
    return hit;
}

}  // namespace epode
