// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See distance.h. A surface is queried in its own frame, two surfaces in the frame of the second.
#include "query/distance.h"

#include "collide/collide.h"
#include "collide/types/registry.h"
#include "collide/user_class.h"
#include "query/query_shape.h"

namespace epode {
namespace {

// Sets `best` to the triangle of `b` nearest to `a`, if that is nearer. All in the surface's frame.
void nearest_triangle(const ConvexView& a, int side_a, const TriangleSet& b, Real limit, Separation& best,
                      Effort& effort)
{
    const Aabb around = box_around(a);
    const Real farthest = best.distance < limit ? best.distance : limit;
    const Real gap = gap_between(around, b.box());
    if (b.count() == 0 || gap > (farthest > 0 ? farthest : Real(0))) return;
    const Vec3 own = around.hi - around.lo, all = b.box().hi - b.box().lo;
    Real step = std::max(max_component(own), std::min(all.x, all.z) < kInf ? max_component(all) / 64 : 0);
    step = std::max(step, (kSingle ? Real(1e-6) : Real(1e-12)) *
                              (gap + max_component(max(abs(around.lo), abs(around.hi)))));
    for (Real reach = gap + step / 8;; step *= 4, reach += step) {
        const Aabb asked = grown(around, reach < limit ? reach : std::max(limit, Real(0)));
        b.query(asked, effort, [&](const Triangle& t, int side) {
            if (!effort.spend(Effort::kDistance)) return;
            Separation s = separation(a, view_of(t), best.distance < limit ? best.distance : limit);
            s.side_a = side_a, s.side_b = side;
            if (s.distance <= limit && s.before(best)) best = s;
        });
        if (best.distance <= reach || reach >= limit || contains(asked, b.box())) return;
        if (!(reach < kMaxMagnitude) || effort.is_cut_short()) return;
    }
}

Separation solid_solid(const QueryShape& a, const QueryShape& b, Real limit)
{
    Capsule memory_a, memory_b;
    const Real apart = kEndless * length(a.pose.p - b.pose.p);
    const BoundingBall ball_a = ball_about(a, apart), ball_b = ball_about(b, apart);
    return separation(solid_view(a, ball_b.centre, ball_b.reach, memory_a),
                      solid_view(b, ball_a.centre, ball_a.reach, memory_b), limit, LastDigits::kByNewton);
}

Separation solid_plane(const QueryShape& a, const QueryShape& b)
{
    const Plane& plane = b.as<Plane>();
    Capsule memory;
    if (a.number() != dRayClass) return separation(solid_view(a, {}, 0, memory), plane);
    // One of its ends is the lowest point of a ray, however long it is.
    const Vec3 along = a.pose.R.column(2);
    const Real reach = a.as<Ray>().length;
    Separation s;
    s.on_a = dot(plane.normal, along) < 0 && reach > 0 ? a.pose.p + reach * along : a.pose.p;
    s.distance = dot(plane.normal, s.on_a) - plane.d;
    s.normal = plane.normal;
    s.on_b = s.on_a - s.distance * plane.normal;
    return s;
}

Separation solid_surface(const QueryShape& a, const QueryShape& b, Real limit, Effort& effort)
{
    Separation best;
    if (kind_of(b) == QueryKind::kMesh && in_mesh(a, b, best)) return best;
    if (kind_of(b) == QueryKind::kField && in_terrain(a, b, best)) return best;
    const TriangleSet surface = triangles_of(b);
    const BoundingBall ball = ball_about(surface, b.pose);
    Capsule memory;
    nearest_triangle(in_frame(b.pose, solid_view(a, ball.centre, ball.reach, memory)), -1, surface, limit,
                     best, effort);
    to_world(b.pose, best);
    return best;
}

// Of an endless field one period counts if its height axis is the plane's normal; otherwise the distance is
// unbounded below.
Separation surface_plane(const QueryShape& a, const QueryShape& b, Effort& effort)
{
    const TriangleSet surface = triangles_of(a);
    const Plane& plane = b.as<Plane>();
    const Vec3 n = transposed_times(a.pose.R, plane.normal);
    const Real d = plane.d - dot(plane.normal, a.pose.p);
    Separation best;
    if (surface.endless() && std::fabs(n.y) < 1) {
        best.distance = -kInf;
        best.normal = n;
    }
    for (int t = 0; t < surface.count() && best.distance > -kInf && effort.spend(1); ++t) {
        Triangle triangle;
        if (!surface.triangle(t, triangle)) continue;
        for (const Vec3 v : triangle.v) {
            const Real above = dot(n, v) - d;
            if (above >= best.distance) continue;
            best = {above, v, v - above * n, n, t, -1};
        }
    }
    to_world(a.pose, best);
    return best;
}

Separation plane_plane(const Plane& a, const Plane& b)
{
    Separation s;
    s.normal = b.normal;
    const bool facing = length2(a.normal + b.normal) < 64 * kEpsilon * kEpsilon;
    s.distance = facing ? -(a.d + b.d) : -kInf;
    s.on_a = a.d * a.normal;
    s.on_b = b.d * b.normal;
    return s;
}

// The triangles of `a` one by one, beginning with the one whose box is nearest.
Separation surface_surface(const QueryShape& a, const QueryShape& b, Real limit, Effort& effort)
{
    const TriangleSet sa = triangles_of(a), sb = triangles_of(b);
    if (sa.endless() && sb.endless()) return {};
    if (sa.endless() || (!sb.endless() && sb.count() < sa.count()))
        return surface_surface(b, a, limit, effort).turned();
    const Pose pose = inverse_times(b.pose, a.pose);
    const auto placed = [&](int t, Triangle& out) {
        if (!sa.triangle(t, out)) return false;
        for (Vec3& v : out.v) v = pose.to_world(v);
        out.n = pose.R * out.n;
        out.c = dot(out.n, out.v[0]);
        return true;
    };
    int nearest = -1, count = 0;
    Real least = kInf;
    Triangle triangle;
    for (; count < sa.count() && effort.spend(1); ++count) {
        if (!placed(count, triangle)) continue;
        const Real gap = gap_between(box_around(triangle), sb.box());
        if (nearest < 0 || gap < least) nearest = count, least = gap;
    }
    Separation best;
    look_at_each(count, effort, [&](int i, Effort& share) {
        const int t = i == 0 && nearest >= 0 ? nearest : i <= nearest ? i - 1 : i;  // the nearest one first
        if (placed(t, triangle)) nearest_triangle(view_of(triangle), t, sb, limit, best, share);
    });
    to_world(b.pose, best);
    return best;
}

// The kind of `a` must not come after that of `b`.
Separation in_order(const QueryShape& a, const QueryShape& b, Real limit, Effort& effort)
{
    const QueryKind x = kind_of(a), y = kind_of(b);
    if (x == QueryKind::kNone || y == QueryKind::kNone) return {};
    if (x == QueryKind::kSolid) {
        if (y == QueryKind::kSolid) return solid_solid(a, b, limit);
        return y == QueryKind::kPlane ? solid_plane(a, b) : solid_surface(a, b, limit, effort);
    }
    if (x == QueryKind::kPlane)
        return y == QueryKind::kPlane ? plane_plane(a.as<Plane>(), b.as<Plane>())
                                      : surface_plane(b, a, effort).turned();
    Separation terrain;
    if (x == QueryKind::kMesh && y == QueryKind::kField && in_terrain(a, b, terrain)) return terrain;
    return surface_surface(a, b, limit, effort);
}

}  // namespace

GeomSeparation separation(Geom& a, Geom& b, Real limit)
{
    const QueryShape ta = query_shape_of(a), tb = query_shape_of(b);
    const QueryKind x = kind_of(ta), y = kind_of(tb);
    // One canonical order, so that swapping the two changes no bit.
    const bool turn = x != y ? x > y : ta.geom && tb.geom && ta.geom->serial > tb.geom->serial;
    Effort effort(mesh_triangles(ta) + mesh_triangles(tb));
    const Separation s = turn ? in_order(tb, ta, limit, effort).turned() : in_order(ta, tb, limit, effort);
    GeomSeparation out;
    out.cut_short = effort.is_cut_short();
    static_cast<Separation&>(out) = s;
    if (s.distance <= limit && s.distance < kInf) out.a = ta.named, out.b = tb.named;
    if (x == QueryKind::kField) out.side_a = -1;
    if (y == QueryKind::kField) out.side_b = -1;
    return out;
}

bool overlapping(Geom& a, Geom& b, bool& cut_short)
{
    const bool built_in = !is_user_class(a.type->number) && !is_user_class(b.type->number);
    if (built_in && !overridden(a, b)) {
        const GeomSeparation s = separation(a, b, 0);
        cut_short = cut_short || s.cut_short;
        return s.a != nullptr;
    }
    dContactGeom contact;
    ContactArray one{&contact, int(sizeof contact), 1, true};
    collide(a, b, one);
    return one.count > 0;
}

}  // namespace epode
