// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A box, cylinder or polyhedron against a triangle of a mesh: of all directions that can part the two the one
// of least overlap (Gottschalk, Lin, Manocha 1996), among those that the mesh allows (mesh_facet.h), then the
// manifold along it. Along the triangle's own normal: the faces of the solid that look at it, cut by its
// prism, each point with its own depth. Along another, a crest: the manifold of two convex solids. The
// own normal points to the side on which the solid's middle is. A box or polyhedron in the back of a triangle
// is pushed out backwards, a cylinder is not pushed, as in ODE.
#include "collide/pairs/across_edges.h"
#include "collide/pairs/polyhedra/box_axes.h"
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
constexpr Real kShallow = Real(5e-4);   // of the size: no less than the depth of whatever a search would find
constexpr std::size_t kManyEdges = 16;  // of a polyhedron: more are searched by expansion
constexpr Real kSafeFraction = Real(0.999);  // less than this of a bound is no matter of rounding
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
    LeastWay(const MeshFacet& facet, const MeshPair& pair) : f_(facet), m_(pair), reach_(pair.solid)
    {
        if (pair.solid.kind != SolidKind::kPolyhedron) return;
        const Polyhedron& solid = *static_cast<const Polyhedron*>(pair.solid.shape);
        ball_centre_ = pair.solid.pose.to_world(solid.inner()), ball_radius_ = solid.inner_radius();
    }

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
            if (upright_crest.stands && across < kFaceFirst * depth)
                return judge(upright, across, upright_crest, edge);
        }
        judge(n, d, crest, shows.at);
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

    // Whether what is known to be in a polyhedron, a ball and its lowest point, shows already that neither
    // sense of an axis is worth anything.
    bool surely_more(Vec3 a, Real size2, Real least, Real largest) const
    {
        const Real worth = kFaceFirst * depth, spare = kSafeFraction * (ball_radius_ - worth);
        const Real middle = dot(a, ball_centre_), low = dot(a, lowest_);
        const auto more = [&](Real of_middle, Real of_low) {
            const bool by_ball =
                spare > 0 && (of_middle >= 0 || of_middle * of_middle <= spare * spare * size2);
            return by_ball ||
                   (of_low > 0 && kSafeFraction * kSafeFraction * of_low * of_low >= worth * worth * size2);
        };
        return more(largest - middle, largest - low) && more(middle - least, low - least);
    }

    // Whether the overlap of a polyhedron along the axis is by more than rounding, and more than it is worth,
    // or less than parts the two: 1, -1, else 0.
    int clearly(Vec3 a, Real size2, Real least, Real largest) const
    {
        if (!m_.hull) return 0;
        Real low, high;
        reach_.roughly_along(a, low, high);
        const Real hair = m_.slack * (std::fabs(a.x) + std::fabs(a.y) + std::fabs(a.z));
        const Real d = std::min(largest - low, high - least), worth = kFaceFirst * depth;
        const Real more = d + hair, less = d - hair;
        if (more < 0 && more * more > m_.slack * m_.slack * size2) return -1;
        return less > 0 && less * less >= worth * worth * size2 ? 1 : 0;
    }

    // Both senses of an axis of the length sqrt(size2); false when it parts the two. Most axes are done with
    // before their length is needed.
    bool offer(Vec3 a, Real size2 = 1)
    {
        Real least = kInf, largest = -kInf;
        for (const Vec3 v : f_.v) {
            const Real at = dot(a, v);
            least = at < least ? at : least, largest = at > largest ? at : largest;
        }
        if (ball_radius_ > 0 && surely_more(a, size2, least, largest)) return true;
        if (const int clear = clearly(a, size2, least, largest)) return clear > 0;
        const Real low = reach_.low_along(a);
        const Real high = reach_.symmetric() ? 2 * dot(a, m_.solid.pose.p) - low : -reach_.low_along(-a);
        const Real up = largest - low, down = high - least, d = up <= down ? up : down;
        if (d < 0 && d * d > m_.slack * m_.slack * size2) return false;
        const Real worth = kFaceFirst * depth;
        if (d > 0 && d * d >= worth * worth * size2) return true;
        const Real size = std::sqrt(size2);
        consider(up <= down ? a / size : -a / size, d / size);
        return true;
    }

    bool offer_cross(Vec3 a, Vec3 b)
    {
        const Vec3 n = cross(a, b);
        const Real size2 = length2(n);
        return size2 <= Real(1e-6) * length2(a) * length2(b) || offer(n, size2);
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
        const ConvexView& s = m_.solid;
        for (int i = 0; i < 3; ++i)
            if ((s.face_axes >> i & 1) && !offer(s.pose.R.column(i))) return false;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k)
                if ((s.edge_axes >> i & 1) && !offer_cross(s.pose.R.column(i), f_.edge(k))) return false;
        if (m_.hull && !hull_faces(*m_.hull)) return false;
        for (std::size_t i = m_.hull ? std::size_t(m_.hull->count()) : 0; i < s.faces.size(); ++i)
            if (!offer(s.pose.R * s.faces[i].normal)) return false;
        if (many_edges()) return true;
        for (const Vec3 edge : s.edges)
            if (!offer_edge(s.pose.R * edge)) return false;
        return true;
    }
    // The same as offer() of each, the separating axes first.
    bool hull_faces(PlacedHull& hull)
    {
        Real up[PlacedHull::kMostFaces], down[PlacedHull::kMostFaces];
        unsigned wanted[PlacedHull::kMostGroups];
        const Real worth = kFaceFirst * depth;
        for (int g = 0; g < hull.groups(); ++g) {
            const FaceOverlaps o(hull.faces(g), f_);
            const Quad d = smaller(o.up, o.down), d2 = d * magnitude(d);
            if (bits(d2 < quad(-m_.slack * m_.slack))) return false;
            wanted[g] = bits(d2 < quad(worth * worth));
            store_quad(up + 4 * g, o.up), store_quad(down + 4 * g, o.down);
        }
        for (int g = 0; g < hull.groups(); ++g)
            for (unsigned some = wanted[g]; some; some &= some - 1) {
                const int i = __builtin_ctz(some), k = 4 * g + i;
                const Vec3 a = hull.faces(g).axis(i);
                if (k < hull.count()) consider(up[k] <= down[k] ? a : -a, std::min(up[k], down[k]));
            }
        return true;
    }
    bool offer_edge(Vec3 edge)
    {
        for (unsigned some = ball_radius_ > 0 ? worth_a_look(edge) : 7u; some; some &= some - 1)
            if (!offer_cross(edge, f_.edge(__builtin_ctz(some)))) return false;
        return true;
    }
    // Of the directions across an edge of a polyhedron and those of the triangle those of which what
    // surely_more() tells is not known.
    unsigned worth_a_look(Vec3 edge) const
    {
        const AcrossEdges across(edge, f_);
        const auto [largest, least] = across.reach(f_, lowest_);
        const Quad middle = across.along(lowest_ - ball_centre_);
        const Real enough = depth > 0 ? kFaceFirst * depth / kSafeFraction : Real(0),
                   spare = enough - ball_radius_;
        const auto more = [&](const Quad& by_point, const Quad& by_ball) {
            return across.beyond(by_point, enough) | across.beyond(by_ball, spare);
        };
        return 7u & ~(more(largest, largest + middle) & more(quad(0) - least, quad(0) - least - middle));
    }
    bool many_edges() const { return m_.solid.edges.size() > kManyEdges; }

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

    // What has no short list of directions: rims, and polyhedra with many edges.
    bool exact()
    {
        const ConvexView& s = m_.solid;
        if (reach_.cylinder()) return rounds() && rims(0, false);
        if (s.face_axes == 7 || (!s.edges.empty() && !many_edges())) return true;
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
    Real tie_ = -1;              // of heights of corners; negative: not known yet
    Vec3 ball_centre_, lowest_;  // the lowest point of the solid, along the triangle's normal
    Real ball_radius_ = 0;
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
