// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A box, cylinder or polyhedron against a facet: of all directions that can part the solid and the facet's
// column, and that are upward, the one of least overlap; then the manifold along it. Along the facet's
// normal: the lower faces of the solid cut by the column, each point with its own depth below the facet.
// Along another, the facet's edge or corner makes contact: the manifold of two convex solids. Rejected: each
// column as a solid of its own with GJK/EPA; it meets the walls between columns, which do not exist.
#include "collide/pairs/across_edges.h"
#include "collide/pairs/polyhedra/box_axes.h"
#include "collide/pairs/polyhedra/least_axes.h"
#include "collide/pairs/surfaces/facet.h"
#include "collide/pairs/surfaces/facet_contacts.h"
#include "geometry/hulls/polyhedron.h"
#include "geometry/overlap/epa.h"
#include "geometry/triangle_rim.h"

namespace epode {

namespace {

constexpr Real kFacetSafe = Real(0.999);  // less than this of a bound is no matter of rounding

// The search for the direction of least overlap between the solid and the column under a facet.
class LeastRise {
  public:
    LeastRise(const Facet& facet, const TerrainPair& pair) : facet_(facet), m_(pair), reach_(pair.solid)
    {
        if (pair.solid.kind != SolidKind::kPolyhedron) return;
        const Polyhedron& solid = *static_cast<const Polyhedron*>(pair.solid.shape);
        ball_centre_ = pair.solid.pose.to_world(solid.inner()), ball_radius_ = solid.inner_radius();
    }

    // False: the solid does not touch the column.
    bool search()
    {
        depth = own_ = overlap_along(facet_.n);
        normal = facet_.n;
        if (depth < 0) return false;
        lowest_ = reach_.lowest_along(facet_.n);
        if (reach_.own_is_least(facet_, depth, lowest_)) return true;
        if (!(walls() && others())) return false;
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

    // An overlap of more than this parts nothing and is worth nothing, whatever was rounded.
    Real enough() const
    {
        const Real worth = kFaceFirst * depth / kFacetSafe;
        return worth > 2 * m_.slack ? worth : 2 * m_.slack;
    }

    // Whether what is known to be in a polyhedron, a ball and its lowest point, shows already that an upward
    // direction is worth nothing.
    bool surely_more(Vec3 n) const
    {
        Real top = -kInf;
        for (const Vec3 v : facet_.v) top = dot(n, v) > top ? dot(n, v) : top;
        return top - dot(n, ball_centre_) + ball_radius_ > enough() || top - dot(n, lowest_) > enough();
    }

    // Whether the direction's overlap is by more than rounding, and more than it is worth, or less than
    // parts the two: 1, -1, else 0.
    int clearly(Vec3 n) const
    {
        if (!m_.hull || n.y < kSteepest) return 0;
        Real top = -kInf, low, high;
        for (const Vec3 v : facet_.v) top = dot(n, v) > top ? dot(n, v) : top;
        reach_.roughly_along(n, low, high);
        const Real d = top - low, hair = 2 * m_.slack;
        return d + hair < -m_.slack ? -1 : d - hair > kFaceFirst * depth ? 1 : 0;
    }

    // False when the direction (either sense that is not downward) parts the two.
    bool offer(Vec3 n)
    {
        if (n.y < 0) n = -n;
        if (n.y >= kSteepest && ball_radius_ > 0 && surely_more(n)) return true;
        if (const int clear = clearly(n)) return clear > 0;
        const Real d = overlap_along(n);
        if (d < -m_.slack) return false;
        if (n.y < kSteepest) return n.y > 0 || overlap_along(-n) >= -m_.slack;
        consider(n, d);
        return true;
    }

    bool offer_cross(Vec3 a, Vec3 b)
    {
        Vec3 n = cross(a, b);
        return length2(n) <= Real(1e-6) * length2(a) * length2(b) || !normalize(n) || offer(n);
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
        if (reach_.box()) return closed_axes();
        if (reach_.cylinder()) return closed_axes() && rim();
        return listed() ? solid_faces() && edges() : any_direction();
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

    // A large polyhedron lists no edges, and what is known by its support points alone lists nothing.
    bool listed() const
    {
        return m_.solid.kind != SolidKind::kCurved && (m_.solid.faces.empty() || !m_.solid.edges.empty());
    }

    bool solid_faces()
    {
        for (int i = 0; i < 3; ++i)
            if ((m_.solid.face_axes >> i & 1) && !offer(m_.solid.pose.R.column(i))) return false;
        if (m_.hull && !hull_faces(*m_.hull)) return false;
        for (std::size_t i = m_.hull ? std::size_t(m_.hull->count()) : 0; i < m_.solid.faces.size(); ++i)
            if (!offer(m_.solid.pose.R * m_.solid.faces[i].normal)) return false;
        return true;
    }

    // The same as offer() of each, the separating axes first.
    bool hull_faces(PlacedHull& hull)
    {
        Real upward[PlacedHull::kMostFaces];
        unsigned wanted[PlacedHull::kMostGroups];
        const Quad none = quad(0), parts = quad(-m_.slack), worth = quad(kFaceFirst * depth);
        for (int g = 0; g < hull.groups(); ++g) {
            const FourFaces& some = hull.faces(g);
            const FaceOverlaps o(some, facet_);
            const Quad rise = load_quad(some.y), d = if_less(rise, none, o.down, o.up);
            const unsigned level = bits(rise <= none) & bits(none <= rise);
            if (bits(d < parts) | (level & bits(o.down < parts))) return false;
            store_quad(upward + 4 * g, d);
            wanted[g] = bits(quad(kSteepest) <= magnitude(rise)) & bits(d < worth);
        }
        for (int g = 0; g < hull.groups(); ++g)
            for (unsigned some = wanted[g]; some; some &= some - 1) {
                const int i = __builtin_ctz(some);
                const Vec3 n = hull.faces(g).axis(i);
                if (4 * g + i < hull.count()) consider(n.y < 0 ? -n : n, upward[4 * g + i]);
            }
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
        for (unsigned some = ball_radius_ > 0 ? worth_a_look(axis) : 7u; some; some &= some - 1)
            if (!offer_cross(axis, facet_.edge(__builtin_ctz(some)))) return false;
        return true;
    }

    // Of the directions across the axis and the facet's edges those of which surely_more() is not known.
    unsigned worth_a_look(Vec3 axis) const
    {
        const AcrossEdges across(axis, facet_);
        const auto [largest, least] = across.reach(facet_, lowest_);
        const Quad middle = across.along(lowest_ - ball_centre_), rise = across.rise(), none = quad(0);
        const Quad by_point = if_less(rise, none, none - least, largest),
                   by_ball = by_point + if_less(rise, none, none - middle, middle);
        const Real worth = enough();
        return 7u & ~(across.at_least(rise, kSteepest) &
                      (across.beyond(by_point, worth) | across.beyond(by_ball, worth - ball_radius_)));
    }

    // On a ridge, the round of a cylinder against corners, and its rims against edges.
    bool rim()
    {
        if (!m_.terrain.has_ridge(facet_)) return true;
        const Pose& pose = m_.solid.pose;
        const auto offer_round = [this](Real d, Vec3 n) {
            if (n.y < 0) return true;
            if (d < -m_.slack) return false;
            if (n.y >= kSteepest) consider(n, d);
            return true;
        };
        if (!each_round_axis(*reach_.cylinder(), pose, facet_, offer_round)) return false;
        const Vec3 lowest = reach_.lowest_along(facet_.n);
        for (int k = 0; k < 3; ++k) {
            if (reach_.own_is_less(facet_, k, own_, lowest)) continue;
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
    Vec3 ball_centre_;
    Real ball_radius_ = 0;
    Vec3 lowest_;   // along the facet's normal
    Real own_ = 0;  // the overlap along the facet's normal
    // Least overlap in directions that are no contact's: aside, through the walls between columns, or against
    // a surface that goes on rising. When it is less than a crest's, the solid is not on that crest: it has
    // barely come under this facet, and what it really touches stands in another column.
    Real elsewhere_ = kInf;
};

// The part of the solid that is behind a face of the terrain, in the column that stands on it along `up`: a
// facet, or one of the two triangles of a hole's wall, which go on beyond the edge that they share.
void add_face_contacts(const Triangle& face, Vec3 up, int shared, TerrainPair& m)
{
    FacetContacts contacts(face, up, shared, m.slack, m.out);
    collect_facet_contacts(m.solid, m.hull, face, contacts);
}

constexpr int kNoEdge = -1, kWallEdge = 1;

void add_wall_contacts(const Facet& f, TerrainPair& m)
{
    for (const int k : {0, 2}) {
        Triangle wall[2];
        if (!m.terrain.hole_beyond(f, k) || !m.walls->gives_contacts(f, k) ||
            !m.terrain.wall_below(f, k, wall))
            continue;
        for (const Triangle& t : wall) add_face_contacts(t, t.n, kWallEdge, m);
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
        add_face_contacts(f, kUp, kNoEdge, m);
}

}  // namespace epode
