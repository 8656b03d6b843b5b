// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See triangle_triangle.h. Whether two triangles cross: each has corners on both sides of the other's plane,
// and their stretches of the line that the planes share overlap (Moller 1997).
#include "collide/pairs/surfaces/triangle_triangle.h"

#include "collide/pairs/surfaces/triangle_part.h"
#include "geometry/closest.h"

namespace epode {

namespace {

constexpr Real kFaceFirst = Real(0.95);                     // edges must beat faces by this factor
constexpr Real kFalls = kSingle ? Real(1e-4) : Real(1e-6);  // sine of an angle that counts as flat

// The stretch of the common line within a triangle; `at`: heights of its corners over the other's plane.
struct Span {
    Real from = kInf, to = -kInf;
    void take(Real x)
    {
        from = x < from ? x : from;
        to = x > to ? x : to;
    }
};

Span span_of(const Triangle& t, const Real (&at)[3], Vec3 line)
{
    Span s;
    for (int k = 0; k < 3; ++k) {
        const int j = (k + 1) % 3;
        const Real x = dot(line, t.v[k]), y = dot(line, t.v[j]);
        if (at[k] == 0) s.take(x);
        if ((at[k] < 0) != (at[j] < 0) && at[k] != at[j]) s.take(x + at[k] / (at[k] - at[j]) * (y - x));
    }
    return s;
}

// Heights of the corners of t over the plane of `over`, raised by `touch`, or lowered where t lies behind the plane and touches it from
// there: the foot of a box that stands on another, with its sides flush. False when all lie to one side.
bool heights(const Triangle& t, const Triangle& over, Real touch, Real (&at)[3])
{
    bool above = true, below = true, behind = true;
    for (int k = 0; k < 3; ++k) {
        at[k] = over.height(t.v[k]) - touch;
        above = above && at[k] > 0;
        below = below && at[k] < 0;
        behind = behind && at[k] < -2 * touch;
    }
    if (below && !behind)
        for (Real& height : at) height += 2 * touch;
    return !above && !behind;
}

class Crossing {
  public:
    Crossing(const PlacedFacet& a, const PlacedFacet& b, Tolerance tolerance)
        : a_(a), b_(b), slack_(tolerance.slack), touch_(tolerance.touch)
    {}

    bool crosses()
    {
        if (!heights(a_.f, b_.f, touch_, a_over_b_) || !heights(b_.f, a_.f, touch_, b_over_a_)) return false;
        Vec3 line = cross(a_.f.n, b_.f.n);
        if (!(length2(line) > kFalls * kFalls) || !normalize(line)) return false;  // flush: others cross
        const Span a = span_of(a_.f, a_over_b_, line), b = span_of(b_.f, b_over_a_, line);
        const Real from = a.from > b.from ? a.from : b.from, to = a.to < b.to ? a.to : b.to;
        if (!(from <= to)) return false;
        // A point of the line: in both planes, the nearest to the first corner of a.
        const Vec3 across = cross(b_.f.n, line), corner = a_.f.v[0];
        const Vec3 on_b = corner - b_.f.height(corner) * b_.f.n;
        const Vec3 on_both = on_b - a_.f.height(on_b) / dot(a_.f.n, across) * across;
        middle_ = on_both + (Real(0.5) * (from + to) - dot(line, on_both)) * line;
        return true;
    }

    void meet(TriangleContact& out)
    {
        for (int k = 0; k < 3; ++k)
            a_over_b_part_.add(a_.f.v[k], false), b_over_a_part_.add(b_.f.v[k], false);
        cut_to_prism(a_over_b_part_, b_.prism, true, slack_);
        cut_to_prism(b_over_a_part_, a_.prism, true, slack_);
        offer_face(a_, b_, a_over_b_part_, 1, 1), offer_face(b_, a_, b_over_a_part_, -1, 1);
        if (!b_.one_sided()) offer_face(a_, b_, a_over_b_part_, 1, -1);
        if (!a_.one_sided()) offer_face(b_, a_, b_over_a_part_, -1, -1);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                if (may_crest(a_.f, i) && may_crest(b_.f, j)) offer_edges(i, j);
        out.allowed = weighed_ < kInf && fringe_ >= Real(0.5) * depth_;
        out.normal = out.allowed ? normal_ : blocked_normal_;
        out.depth = out.allowed ? depth_ : blocked_;
        if (out.allowed && face_)
            collect(out);
        else if (out.depth < kInf)
            out.add(middle_, out.depth);
    }

  private:
    // How deep the part of a triangle over `face` is on the side that is wrong when `side` is right.
    struct Sunk {
        Real depth = 0;
        int at = 0;  // the deepest corner
        Sunk(const TrianglePart& part, const MeshFacet& face, Real side)
        {
            Real deepest = -kInf;
            for (int i = 0; i < part.count; ++i) {
                const Real d = -side * face.height(part.points[i]);
                if (d > deepest) deepest = d, at = i;
            }
            depth = deepest > 0 ? deepest : 0;
        }
    };

    // What crest_at_edge() needs of an edge, whatever the direction.
    static bool may_crest(const MeshFacet& f, int edge)
    {
        return f.rim[edge] == Rim::kBorder || f.rim[edge] == Rim::kConvex;
    }

    // Does the mesh of `p` end along n at the point of its facet? On an edge it must fall behind the edge, at
    // a corner all around; within the facet, the point is where the other mesh ends.
    bool ends(const PlacedFacet& p, Vec3 point, Vec3 n) const
    {
        const MeshFacet& f = p.f;
        int on[3], count = 0;
        for (int k = 0; k < 3; ++k) {
            const Vec3 e = f.edge(k);
            if (length2(cross(e, point - f.v[k])) <= slack_ * slack_ * length2(e)) on[count++] = k;
        }
        if (count == 0) return true;
        if (count == 1) return f.rim[on[0]] == Rim::kBorder || falls(f, on[0], n);
        const int corner = on[1] == on[0] + 1 ? on[1] : 0;
        const int other = corner == on[0] ? on[1] : on[0];
        for (const int edge : {corner, other})
            if (shows_edge(f, edge, n)) return f.rim[edge] == Rim::kBorder || falls(f, edge, n);
        if (p.terrain) return terrain_crests_at_corner(*p.terrain, p.place, corner, n);
        return crest_at_corner(*p.mesh, facet_of(*p.mesh, f.index), corner, transposed_times(p.pose->R, n))
            .stands;
    }
    static bool falls(const MeshFacet& f, int edge, Vec3 n)
    {
        const Vec3 into = f.into(edge);
        return dot(n, into) <= kFalls * length(into);
    }
    static bool shows_edge(const MeshFacet& f, int edge, Vec3 n)
    {
        const Shows shows = shown_along(f, n);
        return shows.corners == 2 && shows.at == edge;
    }

    // `t` moved to the front (side 1) or back of `face`, over which it has `part`; `sense`: 1 if t is a's, the normal
    // points into a.
    void offer_face(const PlacedFacet& t, const PlacedFacet& face, const TrianglePart& part, Real sense,
                    Real side)
    {
        if (part.count == 0) return;
        const Sunk sunk(part, face.f, side);
        const Vec3 outward = side * face.f.n;
        if (side > 0 && sunk.depth < weighed_ && ends(t, part.points[sunk.at], -outward)) {
            weighed_ = sunk.depth, normal_ = sense * outward, depth_ = sunk.depth;
            sunken_ = &part, face_ = &face;
            return;
        }
        if (sunk.depth < blocked_) blocked_ = sunk.depth, blocked_normal_ = sense * outward;
        if (side > 0 && sunk.depth < fringe_ && !flat_at(t.f, part.points[sunk.at])) fringe_ = sunk.depth;
    }

    // Is the point on an edge or at a corner where the surface is flat?
    bool flat_at(const MeshFacet& f, Vec3 point) const
    {
        for (int k = 0; k < 3; ++k) {
            const Vec3 e = f.edge(k);
            const bool on = length2(cross(e, point - f.v[k])) <= slack_ * slack_ * length2(e);
            if (on && f.rim[k] != Rim::kSeam && f.rim[k] != Rim::kFlat) return false;
        }
        return true;
    }

    void offer_edges(int i, int j)
    {
        const Vec3 e = a_.f.edge(i), g = b_.f.edge(j);
        Vec3 n = cross(e, g);
        if (length2(n) <= Real(1e-4) * length2(e) * length2(g) || !normalize(n)) return;
        for (const Vec3 m : {n, -n}) {
            const Real depth = dot(m, b_.f.v[j] - a_.f.v[i]);
            if (!(depth >= 0) || depth / kFaceFirst >= weighed_) continue;
            if (!crest_at_edge(a_.f, i, -m).stands || !crest_at_edge(b_.f, j, m).stands) continue;
            Vec3 p, q;
            closest_segment_points(a_.f.v[i], a_.f.v[i] + e, b_.f.v[j], b_.f.v[j] + g, p, q);
            if (length(q - p) > depth * Real(1.0001) + slack_) continue;  // they do not cross
            weighed_ = depth / kFaceFirst, normal_ = m, depth_ = depth;
            face_ = nullptr, middle_ = Real(0.5) * (p + q);
        }
    }

    void collect(TriangleContact& out) const
    {
        for (int i = 0; i < sunken_->count; ++i) {
            const Vec3 p = sunken_->points[i];
            const Real depth = -face_->f.height(p);
            if (!sunken_->seam[i] && depth >= -touch_) out.add(p, depth > 0 ? depth : 0);
        }
    }

    const PlacedFacet& a_;
    const PlacedFacet& b_;
    const Real slack_, touch_;
    Real a_over_b_[3] = {}, b_over_a_[3] = {};
    Vec3 middle_;  // of the stretch that the two share
    Real weighed_ = kInf, depth_ = 0, blocked_ = kInf, fringe_ = kInf;
    Vec3 normal_, blocked_normal_;
    TrianglePart a_over_b_part_, b_over_a_part_;  // what each has over the other
    const TrianglePart* sunken_ = nullptr;
    const PlacedFacet* face_ = nullptr;  // null: an edge against an edge
};

}  // namespace

PlacedCorners placed_corners(const TriangleMesh& mesh, int triangle, const Pose& pose)
{
    return {{pose.to_world(mesh.corner(triangle, 0)), pose.to_world(mesh.corner(triangle, 1)),
             pose.to_world(mesh.corner(triangle, 2))}};
}

PlacedFacet placed(const TriangleMesh& mesh, int triangle, const Pose& pose, const PlacedCorners& corners)
{
    PlacedFacet p{{}, &mesh, &pose};
    for (int k = 0; k < 3; ++k) p.f.v[k] = corners.v[k];
    p.f.n = pose.R * mesh.normal(triangle);
    p.f.c = dot(p.f.n, p.f.v[0]);
    p.f.index = triangle;
    return p;
}

void finish(PlacedFacet& p)
{
    if (!p.has_rims && p.terrain) find_terrain_rims(*p.terrain, p.place, p.f);
    if (!p.has_rims && p.mesh) {
        static_cast<MeshRims&>(p.f) = rims_of(*p.mesh, p.f.index, nullptr);
        for (int k = 0; k < 3; ++k) p.f.beyond[k] = p.pose->R * p.mesh->beyond(p.f.index, k);
    }
    if (!p.has_prism) p.prism = Prism(p.f);
    p.has_rims = p.has_prism = true;
}

Real TriangleContact::overlap_along(Vec3 n) const
{
    Real top = -kInf, low = kInf;
    for (const Vec3 v : corners_b) top = dot(n, v) > top ? dot(n, v) : top;
    for (const Vec3 v : corners_a) low = dot(n, v) < low ? dot(n, v) : low;
    return top - low;
}

bool triangle_triangle(PlacedFacet& a, PlacedFacet& b, Tolerance tolerance, TriangleContact& out)
{
    Crossing crossing(a, b, tolerance);
    if (!crossing.crosses()) return false;
    finish(a), finish(b);
    out.a = a.f.index, out.b = b.f.index;
    for (int k = 0; k < 3; ++k) out.corners_a[k] = a.f.v[k], out.corners_b[k] = b.f.v[k];
    crossing.meet(out);
    return out.count > 0;
}

}  // namespace epode
