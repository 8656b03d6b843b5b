// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The least of h(n) over unit n, to rounding: see epa.h. A face of C belongs to one of these kinds, by what
// touches:
//   face and point        n = a face normal                     tried exactly
//   edge and edge         n = product of two edge directions    tried exactly
//   round and edge/point  n perpendicular to an edge direction  one unknown: root of the slope
//   rim and rim           n free                                two unknowns: Newton
// The slope of h at n is its support point, since h is homogeneous of degree one; for a rim of radius r about
// u, with m the unit part of n across u and w = u x m, the second derivative is  r / |n - (n.u)u|  w w^T.
#include "geometry/overlap/curved_overlap.h"
#include "geometry/overlap/epa.h"
#include "geometry/overlap/flat_overlap.h"
#include "geometry/root.h"

namespace epode {

namespace {

// Polished directions must beat exact ones by this part of the size: resting contacts keep their face
// normals.
constexpr Real kFacePreference = kSingle ? Real(1e-5) : Real(1e-9);
constexpr Real kCoarse = Real(2e-6);  // of the size: how near the polytope must come before polishing

bool symmetric(const ConvexView& v) { return v.face_axes != 0 || v.edge_axes != 0; }

// The better sign of a direction; false when it proves the shapes apart. Shapes that name their axes are
// symmetric about their centres, so the sign against the line of centres is the better one.
bool offer(const ConvexView& a, const ConvexView& b, Vec3 n, Real handicap, Real enough, Overlap& best)
{
    const Vec3 m = dot(n, b.pose.p - a.pose.p) > 0 ? -n : n;
    const Real h = extent(a, b, m).h;
    if (h + handicap < best.depth) best.depth = h, best.normal = m;
    return best.depth >= enough;
}

bool offer_exact(const ConvexView& a, const ConvexView& b, Real handicap, Real enough, Overlap& best)
{
    if (!symmetric(a) || !symmetric(b)) return true;
    for (const ConvexView* v : {&a, &b})
        for (int i = 0; i < 3; ++i)
            if ((v->face_axes >> i & 1) &&
                !offer(a, b, v->pose.R.column(i), v == &a ? 0 : handicap, enough, best))
                return false;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            if (!(a.edge_axes >> i & 1) || !(b.edge_axes >> j & 1)) continue;
            Vec3 n = cross(a.pose.R.column(i), b.pose.R.column(j));
            if (length2(n) < Real(1e-6) || !normalize(n)) continue;
            if (!offer(a, b, n, 2 * handicap, enough, best)) return false;
        }
    return true;
}

// h along n(t) = normalised p + t q; its slope in t has the sign of (q - t p) . c, c the support point.
struct Arc {
    const ConvexView& a;
    const ConvexView& b;
    Vec3 p, q;
    Vec3 direction(Real t) const { return normalized_or(p + t * q, p); }
    Real slope(Real t) const { return dot(q - t * p, extent(a, b, direction(t)).point); }
};

// Least h near n among the directions perpendicular to `edge`.
void polish_about(const ConvexView& a, const ConvexView& b, Vec3 edge, Vec3 n, Real handicap, Overlap& best)
{
    Vec3 p = n - dot(n, edge) * edge;
    if (!normalize(p)) return;
    const Arc arc = {a, b, p, cross(edge, p)};
    const Real at_zero = arc.slope(0);
    const Real way = at_zero > 0 ? -1 : 1;
    Real t = 0, inner = 0, at_inner = at_zero;
    for (Real step = Real(1e-4); at_zero != 0 && step < 1; step *= 8) {
        const Real at_step = arc.slope(way * step);
        if (way * at_step >= 0) {
            const auto slope = [&arc](Real x) { return arc.slope(x); };
            t = way > 0 ? rising_root(slope, inner, at_inner, step, at_step)
                        : rising_root(slope, -step, at_step, inner, at_inner);
            break;
        }
        inner = way * step, at_inner = at_step;
    }
    const Vec3 m = arc.direction(t);
    const Real h = extent(a, b, m).h;
    if (h + handicap < best.depth) best.depth = h, best.normal = m;
}

// Adds the second derivative of the cylinder's support function in the tangent basis (u, v).
bool add_rim(const ConvexView& shape, Vec3 n, Vec3 u, Vec3 v, Real& uu, Real& uv, Real& vv)
{
    const Vec3 axis = shape.pose.R.column(2);
    Vec3 w = cross(axis, n);
    const Real across = length(w);
    if (!(across > Real(1e-6))) return false;
    w = w / across;
    const Real k = shape.rim_radius / across, wu = dot(w, u), wv = dot(w, v);
    uu += k * wu * wu, uv += k * wu * wv, vv += k * wv * wv;
    return true;
}

void polish_rims(const ConvexView& a, const ConvexView& b, Vec3 n, Real handicap, Overlap& best)
{
    Extent e = extent(a, b, n);
    for (int i = 0; i < 12; ++i) {
        Vec3 u, v;
        plane_space(n, u, v);
        const Real gu = dot(u, e.point), gv = dot(v, e.point);
        Real uu = -e.h, uv = 0, vv = -e.h;
        if (!add_rim(a, n, u, v, uu, uv, vv) || !add_rim(b, n, u, v, uu, uv, vv)) return;
        const Real det = uu * vv - uv * uv;
        if (!(det > 0) || !(uu > 0)) break;  // not a valley
        const Real su = (uv * gv - vv * gu) / det, sv = (uv * gu - uu * gv) / det;
        Vec3 m = n + su * u + sv * v;
        if (!normalize(m)) break;
        const Extent next = extent(a, b, m);
        if (!(next.h <= e.h + 8 * kEpsilon * (a.size + b.size))) break;
        n = m, e = next;
        if (std::fabs(su) + std::fabs(sv) < 16 * kEpsilon) break;
    }
    if (e.h + handicap < best.depth) best.depth = e.h, best.normal = n;
}

}  // namespace

namespace {

// Edges that lie nearly across the guess: those the view names, else those of the feature it shows.
void polish_edges(const ConvexView& v, Vec3 outward, const ConvexView& a, const ConvexView& b, Vec3 guess,
                  Overlap& best)
{
    constexpr Real kAcross = Real(0.1);
    if (symmetric(v)) {
        for (int i = 0; i < 3; ++i)
            if ((v.edge_axes >> i & 1) && std::fabs(dot(v.pose.R.column(i), guess)) < kAcross)
                polish_about(a, b, v.pose.R.column(i), guess, 0, best);
        return;
    }
    Polygon f;
    v.feature(outward, f);
    for (int i = 0; i < f.count && f.count > 1; ++i) {
        Vec3 edge = f.points[i + 1 < f.count ? i + 1 : 0] - f.points[i];
        if (normalize(edge) && std::fabs(dot(edge, guess)) < kAcross)
            polish_about(a, b, edge, guess, 0, best);
    }
}

}  // namespace

void offer_face(const ConvexView& v, Real sense, Vec3 guess, const ConvexView& a, const ConvexView& b,
                Overlap& best)
{
    const Vec3 outward = sense * transposed_times(v.pose.R, guess);
    const PolyhedronFace* nearest = nullptr;
    for (const PolyhedronFace& f : v.faces)
        if (!nearest || dot(f.normal, outward) > dot(nearest->normal, outward)) nearest = &f;
    if (!nearest) return;
    const Vec3 n = sense * (v.pose.R * nearest->normal);
    const Real h = extent(a, b, n).h;
    if (h < best.depth) best.depth = h, best.normal = n;
}

namespace {

Overlap search(const ConvexView& a, const ConvexView& b, Real enough)
{
    const Real size = a.size + b.size;
    const Real handicap = kFacePreference * size;
    Overlap best;
    if (!offer_exact(a, b, handicap, enough, best)) return best;
    const bool polishable = a.rim_radius > 0 || b.rim_radius > 0;
    Overlap coarse = best;
    expand(a, b, (polishable ? kCoarse : 16 * kEpsilon) * size, enough, coarse);
    if (coarse.depth + handicap >= best.depth) return best;
    if (coarse.depth < enough) return coarse;
    const Vec3 guess = coarse.normal;
    Overlap flush;
    offer_face(a, -1, guess, a, b, flush);
    offer_face(b, 1, guess, a, b, flush);
    if (!polishable) return flush.depth <= coarse.depth + handicap ? flush : coarse;
    best = coarse.depth + handicap < best.depth ? coarse : best;
    polish_edges(a, -guess, a, b, guess, best);
    polish_edges(b, guess, a, b, guess, best);
    if (a.rim_radius > 0 && b.rim_radius > 0) polish_rims(a, b, best.normal, 0, best);
    return flush.depth <= best.depth + handicap ? flush : best;
}

}  // namespace

Overlap least_overlap(const ConvexView& a, const ConvexView& b)
{
    const Real enough =
        -(a.radius + b.radius) - 64 * kEpsilon * (a.size + b.size + length(b.pose.p - a.pose.p));
    if (a.kind == SolidKind::kCurved || b.kind == SolidKind::kCurved) return curved_overlap(a, b, enough);
    Overlap least;
    const bool known = with_pair(a, b, [&](auto&& pair) {
        pair.try_faces(enough);
        if (pair.best.depth >= enough && !pair.proven()) pair.try_rest(enough);
        least = pair.best;
    });
    return known ? least : search(a, b, enough);
}

}  // namespace epode
