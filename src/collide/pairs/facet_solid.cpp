// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A box, cylinder or polyhedron against a facet: of all directions that can part the solid and the facet's
// column, and that are upward, the one of least overlap; then the manifold along it. Along the facet's
// normal: the lower faces of the solid cut by the column, each point with its own depth below the facet.
// Along another, the facet's edge or corner is what pushes: the manifold of two convex solids. Rejected: each
// column as a solid of its own with GJK/EPA; it meets the walls between columns, which do not exist.
#include "collide/pairs/facet.h"
#include "collide/pairs/press.h"
#include "geometry/epa.h"

namespace epode {

namespace {

constexpr Real kFaceFirst = Real(0.95);  // another direction must beat the face's by this factor

// The search for the direction of least overlap between the solid and the column under a facet.
class LeastRise {
  public:
    LeastRise(const Facet& facet, const Meeting& meeting) : facet_(facet), m_(meeting) {}

    // False: the solid does not touch the column.
    bool search()
    {
        depth = overlap_along(facet_.n);
        normal = facet_.n;
        if (depth < 0) return false;
        if (!(walls() && (listed() ? solid_faces() && edges() && rim() : any_direction()))) return false;
        if (kFaceFirst * depth > elsewhere_) on_crest = false;
        return true;
    }

    Vec3 normal;
    Real depth = 0;
    bool on_crest = false;  // the normal is not the facet's own

    // After search(): the way out through the wall under edge k; infinite when the solid is not in the hole.
    Real way_aside(int k) const
    {
        const Vec3 out = facet_.out(k);
        const Real c = facet_.out_limit(k);
        if (!(dot(out, m_.solid.support(out)) - c > m_.slack)) return kInf;
        return c - dot(out, m_.solid.support(-out));
    }
    bool worth(Real way) const { return way < kFaceFirst * depth; }

  private:
    void choose(Vec3 n, Real d) { normal = n, depth = d, on_crest = true; }

    Real overlap_along(Vec3 n) const
    {
        const Real low = dot(n, m_.solid.support(-n));
        Real top = -kInf;
        for (const Vec3 v : facet_.v) top = dot(n, v) > top ? dot(n, v) : top;
        return top - low;
    }

    // False when the direction (either sense that is not downward) parts the two.
    bool offer(Vec3 n)
    {
        if (n.y < 0) n = -n;
        const Real d = overlap_along(n);
        if (d < -m_.slack) return false;
        if (n.y < kSteepest) return n.y > 0 || overlap_along(-n) >= -m_.slack;
        if (!(d < kFaceFirst * depth)) return true;
        if (m_.terrain.crests(facet_, n))
            choose(n, d);
        else
            elsewhere_ = d < elsewhere_ ? d : elsewhere_;
        return true;
    }

    bool offer_cross(Vec3 a, Vec3 b)
    {
        Vec3 n = cross(a, b);
        return length2(n) <= Real(1e-6) * length2(a) * length2(b) || !normalize(n) || offer(n);
    }

    bool walls()
    {
        for (int k = 0; k < 3; ++k) {
            Vec3 n = cross(facet_.edge(k), kUp);
            if (!normalize(n)) continue;
            const Real d = overlap_along(n);
            if (d < -m_.slack) return false;
            elsewhere_ = d < elsewhere_ ? d : elsewhere_;
        }
        return true;
    }

    // A large polyhedron lists no edges.
    bool listed() const { return m_.solid.faces.empty() || !m_.solid.edges.empty(); }

    bool solid_faces()
    {
        for (int i = 0; i < 3; ++i)
            if ((m_.solid.face_axes >> i & 1) && !offer(m_.solid.pose.R.column(i))) return false;
        for (const PolyhedronFace& f : m_.solid.faces)
            if (!offer(m_.solid.pose.R * f.normal)) return false;
        return true;
    }

    bool edges()
    {
        for (int i = 0; i < 3; ++i) {
            if ((m_.solid.edge_axes >> i & 1) && !edge(m_.solid.pose.R.column(i))) return false;
        }
        for (const Vec3 direction : m_.solid.edges)
            if (!edge(m_.solid.pose.R * direction)) return false;
        return true;
    }

    bool edge(Vec3 axis)
    {
        if (!offer_cross(axis, kUp)) return false;
        for (int k = 0; k < 3; ++k)
            if (!offer_cross(axis, facet_.edge(k))) return false;
        return true;
    }

    // A round rim on a ridge has no finite list of directions.
    bool rim() { return !(m_.solid.rim_radius > 0) || !m_.terrain.has_ridge(facet_) || any_direction(); }

    bool any_direction()
    {
        const Overlap o = least_overlap(m_.solid, view_of(facet_));
        if (o.normal.y < 0) return true;
        if (o.depth < -m_.slack) return false;
        const bool better = o.normal.y >= kSteepest && o.depth < kFaceFirst * depth;
        if (better && m_.terrain.crests(facet_, o.normal)) choose(o.normal, o.depth > 0 ? o.depth : 0);
        return true;
    }

    const Facet& facet_;
    const Meeting& m_;
    // Least overlap in directions that are no contact's: aside, through the walls between columns, or against
    // a surface that goes on rising. When it is less than a crest's, the solid is not on that crest: it has
    // barely come under this facet, and what it really touches stands in another column.
    Real elsewhere_ = kInf;
};

struct Ground {
    const Facet& f;
    Meeting& m;

    void press(Polygon& low)
    {
        clip_to_prism(low, f, kUp, m.slack);
        for (int k = 0; k < low.count; ++k) {
            const Real depth = -f.height(low.points[k]);
            if (depth >= -m.slack) m.out.add(low.points[k], f.n, depth > 0 ? depth : 0);
        }
    }
    void press(Vec3 p)
    {
        Polygon one;
        one.add(p);
        press(one);
    }
    bool ends_at(int) const { return true; }
    Vec3 upright() const { return kUp; }
};

// The part of the solid that is behind a wall of a hole, by one of its two triangles.
struct Wall {
    const Triangle& t;
    Meeting& m;

    void press(Polygon& low)
    {
        clip_to_prism(low, t, t.n, m.slack);
        for (int k = 0; k < low.count; ++k) {
            const Real depth = -t.height(low.points[k]);
            if (depth >= -m.slack) m.out.add(low.points[k], t.n, depth > 0 ? depth : 0);
        }
    }
    void press(Vec3 p)
    {
        Polygon one;
        one.add(p);
        press(one);
    }
    bool ends_at(int edge) const { return edge != 1; }  // the two triangles share edge 1
    Vec3 upright() const { return t.n; }
};

void press_walls(const Facet& f, Meeting& m)
{
    for (const int k : {0, 2}) {
        Triangle wall[2];
        if (!m.terrain.hole_beyond(f, k) || !m.walls->pushes(f, k) || !m.terrain.wall_below(f, k, wall))
            continue;
        for (const Triangle& t : wall) press_solid(m.solid, t, Wall{t, m});
    }
}

// A crest of the surface pushes into the solid.
void press_crest(const Facet& f, Vec3 normal, Real depth, Meeting& m)
{
    dContactGeom found[4];
    ContactSink sink(found, sizeof(dContactGeom), 4, false);
    convex_manifold(m.solid, view_of(f), normal, depth, sink);
    const Vec3 margin{m.slack, m.slack, m.slack};
    for (int k = 0; k < sink.count(); ++k) {
        const Vec3 p = load(found[k].pos);
        if (overlap({p - margin, p + margin}, m.box)) m.out.add(p, load(found[k].normal), found[k].depth);
    }
}

}  // namespace

void weigh_solid(const Facet& f, Meeting& m)
{
    LeastRise least(f, m);
    if (!least.search()) return;
    for (const int k : {0, 2})
        if (m.terrain.hole_beyond(f, k)) {
            const Real way = least.way_aside(k);
            if (least.worth(way) || (way < kInf && m.walls->sunk(f))) m.walls->push(f, k);
        }
}

void solid_on(const Facet& f, Meeting& m)
{
    if (m.walls) {
        press_walls(f, m);
        if (m.walls->sunk(f) || m.walls->behind(f)) return;
    }
    LeastRise least(f, m);
    if (!least.search()) return;
    if (least.on_crest)
        press_crest(f, least.normal, least.depth, m);
    else
        press_solid(m.solid, f, Ground{f, m});
}

}  // namespace epode
