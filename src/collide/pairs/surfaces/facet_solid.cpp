// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A box, cylinder or polyhedron against a facet: of all directions that can part the solid and the facet's
// column, and that are upward, the one of least overlap; then the manifold along it. Along the facet's
// normal: the lower faces of the solid cut by the column, each point with its own depth below the facet.
// Along another, the facet's edge or corner makes contact: the manifold of two convex solids. Rejected: each
// column as a solid of its own with GJK/EPA; it meets the walls between columns, which do not exist.
#include "collide/pairs/polyhedra/box_axes.h"
#include "collide/pairs/polyhedra/hull_axes.h"
#include "collide/pairs/polyhedra/least_axes.h"
#include "collide/pairs/surfaces/facet.h"
#include "collide/pairs/surfaces/facet_contacts.h"
#include "collide/pairs/surfaces/facet_manifold_builder.h"
#include "geometry/hulls/polyhedron.h"
#include "geometry/overlap/epa.h"
#include "geometry/triangle_rim.h"

namespace epode {

namespace {

// The search for the direction of least overlap between the solid and the column under a facet.
class LeastRise {
  public:
    LeastRise(const Facet& facet, const TerrainPair& pair) : facet_(facet), m_(pair), reach_(pair.solid) {}

    // False: the solid does not touch the column.
    bool search()
    {
        const bool by_corner = m_.solid.kind == SolidKind::kPolyhedron;
        if (by_corner) lowest_ = reach_.lowest_along(facet_.n);
        depth = own_ = by_corner ? -facet_.height(lowest_) : overlap_along(facet_.n);
        normal = facet_.n;
        if (depth < 0) return false;
        if (!by_corner) lowest_ = reach_.lowest_along(facet_.n);
        if (reach_.own_is_least(facet_, depth, lowest_)) return true;
        if (!others()) return false;
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
        Real top = -kInf;
        for (const Vec3 v : facet_.v) top = dot(n, v) > top ? dot(n, v) : top;
        return top - reach_.low_along(n);
    }

    void consider(Vec3 n, Real d)
    {
        if (!(d < kFaceFirst * depth)) return;
        if (m_.terrain.crests(facet_, n))
            choose(n, d);
        else
            elsewhere_ = d < elsewhere_ ? d : elsewhere_;
    }

    // False when an upward direction parts the two.
    bool offer(Vec3 n)
    {
        const Real d = overlap_along(n);
        if (d < -m_.slack) return false;
        consider(n, d);
        return true;
    }

    // Those under the sides of the cell are upright to the axes of the solid's box.
    bool walls()
    {
        const bool upper = facet_.upper;
        const Real aside[3] = {
            facet_.out_limit(0) + (upper ? -m_.box.lo.x : m_.box.hi.x),
            overlap_along(normalized_or(cross(facet_.edge(1), kUp), {})),
            facet_.out_limit(2) + (upper ? -m_.box.lo.z : m_.box.hi.z),
        };
        for (const Real d : aside) {
            if (d < -m_.slack) return false;
            elsewhere_ = d < elsewhere_ ? d : elsewhere_;
        }
        return true;
    }

    bool others()
    {
        if (!reach_.box()) ridges_ = m_.terrain.ridges(facet_);
        if (m_.hull) return hull_axes(axes_of_hull()) && (!on_crest || walls());
        if (!walls()) return false;
        if (reach_.box()) return closed_axes();
        return reach_.cylinder() ? closed_axes() && rim() : any_direction();
    }

    // Upward ones may be the way out, level ones may part the two.
    bool closed_axes()
    {
        const Pose& pose = m_.solid.pose;
        const auto offer = [this](Real along, Real against, Real size2, auto&& axis_of) {
            const Vec3 axis = axis_of();
            const Real d = axis.y < 0 ? against : along, slack2 = m_.slack * m_.slack * size2;
            if (d < 0 && d * d > slack2) return false;
            if (axis.y * axis.y < kSteepest * kSteepest * size2)
                return axis.y != 0 || against >= 0 || against * against <= slack2;
            const Real worth = kFaceFirst * depth;
            if (d > 0 && d * d >= worth * worth * size2) return true;
            const Real size = std::sqrt(size2), per = (axis.y < 0 ? -1 : 1) / size;
            consider(per * axis, d / size);
            return true;
        };
        if (!reach_.box()) return each_cylinder_axis(*reach_.cylinder(), pose, facet_, offer);
        const auto look = [this](const AxisOverlaps& o) { return look_at(o); };
        return BoxAxes(*reach_.box(), pose, facet_).each(look, offer);
    }
    // The same of four axes, the depth being what it is now.
    AxisVerdict look_at(const AxisOverlaps& o) const
    {
        const Real worth = kFaceFirst * depth;
        const Quad d = if_less(o.rise, quad(0), o.down, o.up), d2 = d * magnitude(d), rise2 = o.rise * o.rise;
        const unsigned steep = ~bits(rise2 < quad(kSteepest * kSteepest) * o.size2);
        return {bits(d2 < quad(-m_.slack * m_.slack) * o.size2),
                (steep & bits(d2 < quad(worth * worth) * o.size2)) | bits(rise2 <= quad(0))};
    }

    HullAxes axes_of_hull() const
    {
        if (!m_.corners) return HullAxes(*m_.hull, facet_, true);
        const auto of = [this](int k) { return m_.corners->distances(facet_, k); };
        return HullAxes(*m_.hull, facet_, true, of(0), of(1), of(2));
    }

    // A crest at a corner is opposite a face, one at an edge is a ridge's; the other edges matter where there is
    // a crest, for they may show that the solid is not on it.
    bool hull_axes(HullAxes axes)
    {
        const Real worth = kFaceFirst * depth;
        const auto offer = [this](Vec3 n, Real d, int = 0) {
            if (n.y >= kSteepest) consider(n, d);
        };
        const unsigned some = reach_.edges_to_try(facet_, own_, lowest_);
        const auto edges = [&](unsigned which) { return axes.edges(some & which, worth, m_.slack, offer); };
        return axes.faces(worth, m_.slack, offer) && edges(ridges_) && (!on_crest || edges(~ridges_));
    }

    // On a ridge, the round of a cylinder against corners, and its rims against edges.
    bool rim()
    {
        if (ridges_ == 0) return true;
        const Pose& pose = m_.solid.pose;
        const auto offer_round = [this](Real d, Vec3 n) {
            if (n.y < 0) return true;
            if (d < -m_.slack) return false;
            if (n.y >= kSteepest) consider(n, d);
            return true;
        };
        if (!each_round_axis(*reach_.cylinder(), pose, facet_, offer_round)) return false;
        return rim_on(ridges_) && (!on_crest || rim_on(7 & ~ridges_));
    }
    // As of a polyhedron, the edges behind which nothing falls away matter where there is a crest.
    bool rim_on(unsigned edges)
    {
        const Pose& pose = m_.solid.pose;
        for (int k = 0; k < 3; ++k) {
            if (!(edges >> k & 1) || reach_.own_is_less(facet_, k, own_, lowest_)) continue;
            RimMinimum found[kMostRimMinima];
            const int count =
                rim_minima(RimArc(*reach_.cylinder(), pose, facet_, k), kFaceFirst * depth, found);
            for (int i = 0; i < count; ++i)
                if (found[i].normal.y >= kSteepest && !offer(found[i].normal)) return false;
        }
        return true;
    }

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
    const TerrainPair& m_;
    const SolidReach reach_;
    Vec3 lowest_;   // along the facet's normal
    Real own_ = 0;  // the overlap along the facet's normal
    unsigned ridges_ = 0;
    // Least overlap in directions that are no contact's: aside, through the walls between columns, or against
    // a surface that goes on rising. When it is less than a crest's, the solid is not on that crest: it has
    // barely come under this facet, and what it really touches stands in another column.
    Real elsewhere_ = kInf;
};

constexpr int kNoEdge = -1, kWallEdge = 1;

// The part of the solid that is behind a face of the terrain, in the column that stands on it along `up`: a
// facet, or one of the two triangles of a hole's wall, which go on beyond the edge that they share.
void add_wall_face_contacts(const Triangle& face, TerrainPair& m)
{
    FacetContacts contacts(face, face.n, kWallEdge, m.slack, m.out);
    collect_facet_contacts(m.solid, m.hull, face, contacts);
}
void add_face_contacts(const Facet& facet, TerrainPair& m)
{
    FacetContacts contacts(facet, kUp, kNoEdge, m.slack, m.out);
    if (m.corners)
        collect_field_contacts(*m.hull, *m.corners, facet, contacts);
    else if (m.ends)
        build_facet_manifold(m.solid, facet, CylinderFacetContacts(*m.ends, facet, contacts));
    else
        collect_facet_contacts(m.solid, m.hull, facet, contacts);
}

void add_wall_contacts(const Facet& f, TerrainPair& m)
{
    for (const int k : {0, 2}) {
        Triangle wall[2];
        if (!m.terrain.hole_beyond(f, k) || !m.walls->gives_contacts(f, k) ||
            !m.terrain.wall_below(f, k, wall))
            continue;
        for (const Triangle& t : wall) add_wall_face_contacts(t, m);
    }
}

// A crest of the surface penetrates the solid.
void add_crest_contacts(const Facet& f, Vec3 normal, Real depth, TerrainPair& m)
{
    dContactGeom found[4];
    ContactSink sink(found, sizeof(dContactGeom), 4, false);
    convex_manifold(m.solid, view_of(f), normal, depth, sink);
    const Vec3 margin{m.slack, m.slack, m.slack};
    for (int k = 0; k < sink.count(); ++k) {
        const Vec3 p = load(found[k].pos);
        if (overlap({p - margin, p + margin}, m.box))
            m.add_crest(f, p, load(found[k].normal), found[k].depth);
    }
}

}  // namespace

Sides::Sides(const Terrain& terrain, const ConvexView& solid, Real slack)
{
    const SolidReach reach(solid);
    const Vec3 cell = terrain.cell();
    const Real per = 1 / (cell.x + cell.z);
    add({per * cell.z, 0, per * cell.x}, reach, slack);
    for (int i = 0; i < 3; ++i)
        if (solid.edge_axes >> i & 1) add(cross(solid.pose.R.column(i), kUp), reach, slack);
}

void Sides::add(Vec3 level, const SolidReach& reach, Real slack)
{
    if (length2(level) <= Real(1e-6) && count_ > 0) return;
    const Real more = slack * (std::fabs(level.x) + std::fabs(level.z));
    sides_[count_++] = {level.x, level.z, reach.low_along(level) - more, more - reach.low_along(-level)};
}

void weigh_solid(const Facet& f, TerrainPair& m)
{
    LeastRise least(f, m);
    if (!least.search()) return;
    for (const int k : {0, 2})
        if (m.terrain.hole_beyond(f, k)) {
            const Real way = least.way_aside(k);
            if (least.worth(way) || (way < kInf && m.walls->sunk(f))) m.walls->push(f, k);
        }
}

void solid_on(const Facet& f, TerrainPair& m)
{
    if (m.walls) {
        add_wall_contacts(f, m);
        if (m.walls->sunk(f) || m.walls->behind(f)) return;
    }
    LeastRise least(f, m);
    if (!least.search()) return;
    if (least.on_crest)
        add_crest_contacts(f, least.normal, least.depth, m);
    else
        add_face_contacts(f, m);
}

}  // namespace epode
