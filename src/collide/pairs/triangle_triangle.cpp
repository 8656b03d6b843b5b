// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See triangle_triangle.h. Whether two triangles cross: each has corners on both sides of the other's plane,
// and their stretches of the line that the planes share overlap (Moller 1997).
#include "collide/pairs/triangle_triangle.h"

#include "collide/pairs/mesh_patch.h"
#include "collide/pairs/pairs.h"

namespace epode {

namespace {

constexpr Real kFaceFirst = Real(0.95);  // edges must beat faces by this factor
constexpr Real kBackLast = Real(0.5);    // the back of a triangle must beat fronts by this one

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

// Heights of the corners of t over the plane of `over`; false when all lie to one side of it.
bool heights(const Triangle& t, const Triangle& over, Real slack, Real (&at)[3])
{
    bool above = true, below = true;
    for (int k = 0; k < 3; ++k) {
        at[k] = over.height(t.v[k]);
        above = above && at[k] > -slack;
        below = below && at[k] < slack;
    }
    return !above && !below;
}

class Crossing {
  public:
    Crossing(const PlacedFacet& a, const PlacedFacet& b, Real slack, Harvest& out)
        : a_(a), b_(b), slack_(slack), out_(out)
    {}

    bool crosses()
    {
        if (!heights(a_.f, b_.f, slack_, a_over_b_) || !heights(b_.f, a_.f, slack_, b_over_a_)) return false;
        Vec3 line = cross(a_.f.n, b_.f.n);
        if (!normalize(line)) return false;
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

    void meet(LastResort& last)
    {
        offer(b_.f.n, 1, Kind::kFaceOfB);
        offer(-a_.f.n, 1, Kind::kFaceOfA);
        offer(-b_.f.n, kBackLast, Kind::kFaceOfB);
        offer(a_.f.n, kBackLast, Kind::kFaceOfA);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const Vec3 e = a_.f.edge(i), g = b_.f.edge(j);
                Vec3 n = cross(e, g);
                if (length2(n) <= Real(1e-6) * length2(e) * length2(g) || !normalize(n)) continue;
                offer(n, kFaceFirst, Kind::kEdges), offer(-n, kFaceFirst, Kind::kEdges);
            }
        if (weighed_ < kInf) return press();
        if (blocked_ < last.depth) last = {blocked_, {middle_, blocked_normal_, blocked_, a_.f.index, b_.f.index}};
    }

  private:
    enum class Kind { kFaceOfA, kFaceOfB, kEdges };

    static Real highest(const Triangle& t, Vec3 n)
    {
        Real top = -kInf;
        for (const Vec3 v : t.v) top = dot(n, v) > top ? dot(n, v) : top;
        return top;
    }

    // May the mesh of `p` be pushed against along n, outwards?
    static bool allows(const PlacedFacet& p, Vec3 n)
    {
        const Shows shows = shown_along(p.f, n);
        if (shows.corners == 3) return true;
        if (shows.corners == 2) return crest_at_edge(p.f, shows.at, n).stands;
        MeshFacet own = facet_of(p.mesh, p.f.index);
        return crest_at_corner(p.mesh, own, shows.at, transposed_times(p.pose.R, n)).stands;
    }

    void offer(Vec3 n, Real favour, Kind kind)
    {
        const Real depth = highest(b_.f, n) + highest(a_.f, -n), weighed = depth / favour;
        if (weighed >= weighed_) return;
        if (allows(b_, n) && allows(a_, -n)) {
            weighed_ = weighed, depth_ = depth > 0 ? depth : 0, normal_ = n, kind_ = kind;
        } else if (kind != Kind::kEdges && depth < blocked_) {
            blocked_ = depth > 0 ? depth : 0, blocked_normal_ = n;
        }
    }

    void press()
    {
        if (kind_ == Kind::kFaceOfB) return press_into(a_.f, b_.f, dot(normal_, b_.f.n) > 0 ? 1 : -1);
        if (kind_ == Kind::kFaceOfA) return press_into(b_.f, a_.f, dot(normal_, a_.f.n) < 0 ? 1 : -1);
        dContactGeom found[4];
        ContactSink sink(found, sizeof(dContactGeom), 4, false);
        convex_manifold(view_of(a_.f), view_of(b_.f), normal_, depth_, sink);
        for (int k = 0; k < sink.count(); ++k) add(load(found[k].pos), found[k].depth);
    }

    // What of `t` lies on the wrong side of `face`.
    void press_into(const MeshFacet& t, const MeshFacet& face, Real side)
    {
        Patch patch;
        for (const Vec3 v : t.v) patch.add(v, false);
        cut_to_prism(patch, face, true, slack_);
        for (int i = 0; i < patch.count; ++i) {
            const Real depth = -side * face.height(patch.points[i]);
            if (!patch.seam[i] && depth >= 0) add(patch.points[i], depth);
        }
    }

    void add(Vec3 p, Real depth) { out_.add({p, normal_, depth, a_.f.index, b_.f.index}); }

    const PlacedFacet& a_;
    const PlacedFacet& b_;
    const Real slack_;
    Harvest& out_;
    Real a_over_b_[3] = {}, b_over_a_[3] = {};
    Vec3 middle_;  // of the stretch that the two share
    Real weighed_ = kInf, depth_ = 0, blocked_ = kInf;
    Vec3 normal_, blocked_normal_;
    Kind kind_ = Kind::kEdges;
};

}  // namespace

PlacedFacet placed(const TriangleMesh& mesh, int triangle, const Pose& pose)
{
    PlacedFacet p{facet_of(mesh, triangle), mesh, pose};
    for (int k = 0; k < 3; ++k) p.f.v[k] = pose.to_world(p.f.v[k]), p.f.into[k] = pose.R * p.f.into[k];
    p.f.n = pose.R * p.f.n;
    p.f.c = dot(p.f.n, p.f.v[0]);
    return p;
}

void triangle_triangle(const PlacedFacet& a, const PlacedFacet& b, Real slack, Harvest& out, LastResort& last)
{
    Crossing crossing(a, b, slack, out);
    if (crossing.crosses()) crossing.meet(last);
}

}  // namespace epode
