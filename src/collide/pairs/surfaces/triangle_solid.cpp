// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A box, cylinder or polyhedron against a triangle of a mesh: of all directions that can part the two the one
// of least overlap (Gottschalk, Lin, Manocha 1996), among those that the mesh allows (mesh_facet.h), then the
// manifold along it. Along the triangle's own normal: the faces of the solid that look at it, cut by its
// prism, each point with its own depth. Along another, a crest: the manifold of two convex solids. The
// own normal points to the side on which the solid's middle is. A box or polyhedron in the back of a triangle
// is pushed out backwards, a cylinder is not pushed, as in ODE.
#include "collide/pairs/polyhedra/box_axes.h"
#include "collide/pairs/polyhedra/hull_axes.h"
#include "collide/pairs/polyhedra/least_axes.h"
#include "collide/pairs/surfaces/facet_contacts.h"
#include "geometry/hulls/polyhedron.h"
#include "geometry/overlap/epa.h"
#include "geometry/overlap/gjk.h"
#include "geometry/triangle_rim.h"

namespace epode {

namespace {

constexpr Real kOwnShare =
    Real(0.5);  // less of the own depth against a neighbour that rises: it is that which is touched
constexpr Real kShallow = Real(5e-4);  // of the size: no less than the depth of whatever a search would find
constexpr Real kAlongCrest = Real(0.2);  // a normal that leans along a crest by less is made upright to it

// The least overlap among the directions that have been tried.
struct Way {
    Vec3 normal;
    Real depth = 0;
    bool on_crest = false;  // the normal is not the triangle's own
    bool at_border = false;
    // Least overlap in directions that are no contact's. When it is less than a crest's, the solid is not on
    // that crest: it has barely come over this triangle, and what it really touches is another.
    Real blocked = kInf;
    Real hollow = kInf;  // of these, against a neighbour that rises
};

// The search for the direction of least overlap that is allowed.
class LeastWay : public Way {
  public:
    LeastWay(const MeshFacet& facet, const MeshPair& pair) : f_(facet), m_(pair), reach_(pair.solid) {}

    // False: the two do not touch.
    bool search()
    {
        const bool by_corner = m_.solid.kind == SolidKind::kPolyhedron;
        if (by_corner) lowest_ = reach_.lowest_along(f_.n);
        normal = f_.n;
        depth = f_.c - (by_corner ? dot(f_.n, lowest_) : reach_.low_along(f_.n));
        own_ = depth;
        if (depth < -m_.slack) return false;
        if (!by_corner) lowest_ = reach_.lowest_along(f_.n);
        if (reach_.own_is_least(f_, own_, lowest_)) return true;
        if (!(axes() && exact())) return false;
        if (quick_ && on_crest) return search_all();
        return decide();
    }

    // Whether what touches may still be found apart: the rest of the directions has not been tried.
    bool quick() const { return quick_; }
    // Tries the concave edges among these, which show whether the solid is on a neighbour.
    bool try_hollows()
    {
        for (int k = 0; k < 3; ++k)
            if (f_.rim[k] == Rim::kHollow &&
                !rim_on(k, RimArc(*reach_.cylinder(), m_.solid.pose, f_, k), kOwnShare * own_))
                return false;
        return decide();
    }
    // From where the first was left out.
    bool search_all()
    {
        quick_ = false;
        static_cast<Way&>(*this) = before_;
        return rims(skipped_, true) && decide();
    }

  private:
    bool decide()
    {
        if (on_crest && kFaceFirst * depth > blocked) on_crest = false, normal = f_.n, depth = own_;
        const bool touches_neighbour = !on_crest && hollow < kOwnShare * own_;
        return !touches_neighbour;
    }

    Real overlap_along(Vec3 n) const
    {
        Real top = -kInf;
        for (const Vec3 v : f_.v) top = dot(n, v) > top ? dot(n, v) : top;
        return top - reach_.low_along(n);
    }

    // A direction and what moving the solid along it would take.
    void consider(Vec3 n, Real d)
    {
        if (!(d < kFaceFirst * depth)) return;
        if (tie_ < 0) tie_ = kLevel * longest_edge(f_);
        const Shows shows = shown_within(f_, n, tie_);
        if (shows.corners == 3) return;
        if (shows.corners == 2) return judge(n, d, crest_at_edge(f_, shows.at, n), shows.at);
        const Crest crest = crest_at_corner(m_.mesh, f_, shows.at, n, m_.refused);
        if (crest.stands) return judge(n, d, crest, -1);
        // The corner is not the top of its edges: upright to one of them it may be.
        for (const int edge : {shows.at, (shows.at + 2) % 3}) {
            const Vec3 side = f_.edge(edge);
            if (runs_along(n, side)) continue;
            Vec3 e = side;
            if (!normalize(e) || std::fabs(dot(n, e)) > kAlongCrest) continue;
            Vec3 upright = n - dot(n, e) * e;
            if (!normalize(upright)) continue;
            const Crest upright_crest = crest_at_edge(f_, edge, upright);
            const Real across = overlap_along(upright);
            if (!upright_crest.stands || !(across < kFaceFirst * depth)) continue;
            blocked = d < blocked ? d : blocked;
            return judge(upright, across, upright_crest, edge);
        }
        judge(n, d, crest, shows.at);
    }

    // The same of one that edge k shows.
    void consider_edge(Vec3 n, Real d, int k)
    {
        if (d < kFaceFirst * depth) judge(n, d, crest_at_edge(f_, k, n), k);
    }

    // Whether n leans along a side by clearly more than kAlongCrest; computed without a square root.
    static bool runs_along(Vec3 n, Vec3 side)
    {
        const Real along = dot(n, side);
        return along * along > Real(1.01) * kAlongCrest * kAlongCrest * length2(side);
    }

    void judge(Vec3 n, Real d, Crest crest, int edge)
    {
        if (crest.stands) {
            if (!crest.border || own_ > kLip * m_.solid.size)
                normal = n, depth = d > 0 ? d : 0, on_crest = true, at_border = crest.border;
            return;
        }
        blocked = d < blocked ? d : blocked;
        if (edge >= 0 && f_.rim[edge] == Rim::kHollow && d < hollow) hollow = d;
    }

    bool closed_axes()
    {
        const auto offer = [this](Real up, Real down, Real size2, auto&& axis) {
            const Real d = up <= down ? up : down, worth = kFaceFirst * depth;
            if (d < 0 && d * d > m_.slack * m_.slack * size2) return false;
            if (d > 0 && d * d >= worth * worth * size2) return true;
            const Real size = std::sqrt(size2), per = (up <= down ? 1 : -1) / size;
            consider(per * axis(), d / size);
            return true;
        };
        if (!reach_.box()) return each_cylinder_axis(*reach_.cylinder(), m_.solid.pose, f_, offer);
        const auto look = [this](const AxisOverlaps& o) {
            const Quad d = smaller(o.up, o.down), d2 = d * magnitude(d);
            const Real worth = kFaceFirst * depth;
            return AxisVerdict{bits(d2 < quad(-m_.slack * m_.slack) * o.size2),
                               bits(d2 < quad(worth * worth) * o.size2)};
        };
        return BoxAxes(*reach_.box(), m_.solid.pose, f_).each(look, offer);
    }

    bool axes()
    {
        if (reach_.box() || reach_.cylinder()) return closed_axes();
        return !m_.hull || hull_axes(HullAxes(*m_.hull, f_, false));
    }

    bool hull_axes(HullAxes axes)
    {
        const Real worth = kFaceFirst * depth;
        return axes.faces(worth, m_.slack, [this](Vec3 n, Real d) { consider(n, d); }) &&
               axes.edges(reach_.edges_to_try(f_, own_, lowest_), worth, m_.slack,
                          [this](Vec3 n, Real d, int k) { consider_edge(n, d, k); });
    }

    // The round of a cylinder against corners.
    bool rounds()
    {
        return each_round_axis(*reach_.cylinder(), m_.solid.pose, f_, [this](Real d, Vec3 n) {
            if (d < -m_.slack) return false;
            consider(n, d);
            return true;
        });
    }

    // Its rims against edges, from one on: every one, or what may be a crest. Without crests, an edge says
    // only how far the solid is over the triangle.
    bool rims(int first, bool every)
    {
        for (int k = first; k < 3; ++k) {
            const Rim rim = f_.rim[k];
            const bool level = !every && (rim == Rim::kSeam || rim == Rim::kFlat || rim == Rim::kHollow);
            if (!level) {
                const RimArc arc(*reach_.cylinder(), m_.solid.pose, f_, k);
                if (every || rim != Rim::kConvex || rim_turns_before(arc, f_.beyond[k])) {
                    if (!rim_on(k, arc, kFaceFirst * depth)) return false;
                    continue;
                }
            }
            if (!quick_) quick_ = true, skipped_ = k, before_ = *this;
        }
        return true;
    }
    bool rim_on(int k, const RimArc& arc, Real worth)
    {
        if (reach_.own_is_less(f_, k, own_, lowest_)) return true;
        RimMinimum found[kMostRimMinima];
        const int count = rim_minima(arc, worth, found);
        for (int i = 0; i < count; ++i) {
            if (found[i].overlap < -m_.slack) return false;
            consider(found[i].normal, found[i].overlap);
        }
        return true;
    }

    // What has no short list of directions: rims, and what is curved.
    bool exact()
    {
        const ConvexView& s = m_.solid;
        if (reach_.cylinder()) return rounds() && rims(0, false);
        if (reach_.box() || m_.hull) return true;
        const ConvexView flat = view_of(f_);
        if (!f_.has_crest() || own_ < kShallow * s.size) return !(gjk_distance(s, flat).distance > m_.slack);
        const Overlap o = least_overlap(s, flat);
        if (o.depth < -m_.slack) return false;
        consider(o.normal, o.depth);
        return true;
    }

    const MeshFacet& f_;
    const MeshPair& m_;
    const SolidReach reach_;
    Real tie_ = -1;  // of heights of corners; negative: not known yet
    Vec3 lowest_;    // the lowest point of the solid, along the triangle's normal
    Real own_ = 0;
    bool quick_ = false;
    int skipped_ = 0;  // the first edge that was left out
    Way before_;       // what was known then
};

// A crest of the surface penetrates the solid.
void add_crest_contacts(const MeshFacet& f, const Way& way, MeshPair& m)
{
    dContactGeom found[4];
    ContactSink sink(found, sizeof(dContactGeom), 4, false);
    convex_manifold(m.solid, view_of(f), way.normal, way.depth, sink);
    for (int k = 0; k < sink.count(); ++k) {
        const Vec3 at = load(found[k].pos), normal = load(found[k].normal);
        way.at_border ? m.out.add_at_border(at, normal, found[k].depth, f.index)
                      : m.out.add(at, normal, found[k].depth, f.index);
    }
}

// The rest of the search is only for what has contacts, and most of it for what is not seen to touch.
void add_contacts_if_met(const MeshFacet& f, LeastWay& least, MeshPair& m)
{
    FacetContacts contacts(f, m);
    contacts.hold();
    collect_facet_contacts(m.solid, m.hull, f, contacts);
    if (contacts.held() == 0 || !least.try_hollows()) return;
    if (!least.on_crest && contacts.met(m.solid.pose.p)) return contacts.deliver();
    if (!least.search_all()) return;
    if (least.on_crest)
        add_crest_contacts(f, least, m);
    else
        contacts.deliver();
}

void meet_side(const MeshFacet& f, MeshPair& m)
{
    LeastWay least(f, m);
    if (!least.search()) return;
    if (least.on_crest) return add_crest_contacts(f, least, m);
    if (least.quick()) return add_contacts_if_met(f, least, m);
    FacetContacts contacts(f, m);
    collect_facet_contacts(m.solid, m.hull, f, contacts);
}

}  // namespace

void solid_on(const MeshFacet& f, MeshPair& m)
{
    if (f.height(m.solid.pose.p) >= -m.slack)
        meet_side(f, m);
    else if (m.two_sided)
        meet_side(turned(f), m);
}

bool add_crest_if_least(const MeshFacet& f, MeshPair& m)
{
    LeastWay least(f, m);
    if (!least.search() || !least.on_crest) return false;
    add_crest_contacts(f, least, m);
    return true;
}

}  // namespace epode
