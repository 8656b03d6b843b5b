// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A box, cylinder or polyhedron against a triangle of a mesh: of all directions that can part the two the one
// of least overlap (Gottschalk, Lin, Manocha 1996), among those that the mesh allows (mesh_facet.h), then the
// manifold along it. Along the triangle's own normal: the faces of the solid that look at it, cut by its
// prism, each point with its own depth. Along another, a crest pushes: the manifold of two convex solids. The
// own normal points to the side on which the solid's middle is. A box or polyhedron in the back of a triangle
// is pushed out backwards, a cylinder is not pushed, as in ODE.
#include "collide/pairs/mesh_ground.h"
#include "collide/pairs/press.h"
#include "geometry/epa.h"
#include "geometry/gjk.h"
#include "geometry/triangle_rim.h"

#include <algorithm>

namespace epode {

namespace {

constexpr Real kFaceFirst = Real(0.95);  // another direction must beat the own normal by this factor
constexpr Real kThere =
    Real(0.5);  // less of the own depth against a neighbour that rises: it is that which is touched
constexpr Real kShallow = Real(5e-4);   // of the size: no less than the depth of whatever a search would find
constexpr std::size_t kManyEdges = 16;  // of a polyhedron: more are searched by expansion
constexpr Real kAlongCrest = Real(0.2);  // a normal that leans along a crest by less is made upright to it

// The search for the direction of least overlap that is allowed.
class LeastWay {
  public:
    LeastWay(const MeshFacet& facet, const MeshMeeting& meeting) : f_(facet), m_(meeting)
    {
        if (m_.solid.face_axes == 7) box_ = static_cast<const Box*>(m_.solid.shape);
        if (m_.solid.rim_radius > 0) cylinder_ = static_cast<const Cylinder*>(m_.solid.shape);
    }

    // False: the two do not touch.
    bool search()
    {
        normal = f_.n;
        depth = f_.c - low_along(f_.n);
        own_ = depth;
        if (depth < -m_.slack) return false;
        if (own_is_least()) return true;
        if (!(axes() && exact(false))) return false;
        if (quick_ && on_crest) return search_all();
        return decide();
    }

    // Whether what touches may still be found apart: the rest of the directions has not been tried.
    bool quick() const { return quick_; }
    bool search_all()
    {
        quick_ = on_crest = false;
        normal = f_.n, depth = own_;
        blocked_ = hollow_ = kInf;
        return axes() && exact(true) && decide();
    }

    Vec3 normal;
    Real depth = 0;
    bool on_crest = false;  // the normal is not the triangle's own

  private:
    bool decide()
    {
        if (on_crest && kFaceFirst * depth > blocked_) on_crest = false, normal = f_.n, depth = own_;
        if (!on_crest && hollow_ < kThere * own_) return false;  // it touches the neighbour, not this one
        return true;
    }

    // That no other direction can be less by kFaceFirst, when the solid's lowest point p is deep in the
    // triangle. With s the distance of its foot from the edges, in the triangle, c the solid's middle, H its
    // height and L how far it is from over p, the overlap along a direction at the angle a from n is at least
    //   own cos a + s sin a          a <= 90 degrees: what p needs
    //   max(own cos a + s sin a, -H cos a - L sin a)    beyond: the same, and what c needs
    // that is min(own, s) and (s H - L own) / sqrt((H + own)^2 + (s + L)^2).
    bool own_is_least() const
    {
        if (!symmetric() || !(own_ > 0)) return false;
        const Vec3 c = m_.solid.pose.p, p = m_.solid.support(-f_.n);
        const Real worth = kFaceFirst * own_;
        Real s = kInf;
        for (int k = 0; k < 3; ++k) {
            const Vec3 e = f_.edge(k);
            const Real in = dot(cross(f_.n, e), p - f_.v[k]);
            if (!(in > 0) || in * in < worth * worth * length2(e)) return false;
            s = std::fmin(s, in / length(e));
        }
        const Real H = f_.height(c), fall = H + own_, L2 = length2(c - p) - fall * fall;
        const Real L = L2 > 0 ? std::sqrt(L2) : Real(0), clear = s * H - L * own_;
        return clear > 0 && clear * clear > worth * worth * (fall * fall + (s + L) * (s + L));
    }

    // How far the solid goes down along n; of boxes and cylinders without calls.
    Real low_along(Vec3 n) const
    {
        const ConvexView& s = m_.solid;
        if (cylinder_) return dot(n, s.pose.p) - reach(n);
        if (!box_) return dot(n, s.support(-n));
        return dot(n, s.pose.p) - dot(abs(transposed_times(s.pose.R, n)), box_->half);
    }
    // reach_along() for directions of any length.
    Real reach(Vec3 n) const
    {
        const Real c = dot(m_.solid.pose.R.column(2), n), s2 = length2(n) - c * c;
        return cylinder_->half_length * std::fabs(c) + cylinder_->radius * (s2 > 0 ? std::sqrt(s2) : Real(0));
    }
    bool symmetric() const { return m_.solid.face_axes != 0 || m_.solid.edge_axes != 0; }

    Real overlap_along(Vec3 n) const
    {
        Real top = -kInf;
        for (const Vec3 v : f_.v) top = dot(n, v) > top ? dot(n, v) : top;
        return top - low_along(n);
    }

    // A direction and what moving the solid along it would take.
    void consider(Vec3 n, Real d)
    {
        if (!(d < kFaceFirst * depth)) return;
        const Shows shows = shown_along(f_, n);
        if (shows.corners == 3) return;
        if (shows.corners == 2) return judge(n, d, crest_at_edge(f_, shows.at, n), shows.at);
        const Crest crest = crest_at_corner(m_.mesh, f_, shows.at, n);
        if (crest.stands) return judge(n, d, crest, -1);
        // The corner is not the top of its edges: upright to one of them it may be.
        for (const int edge : {shows.at, (shows.at + 2) % 3}) {
            Vec3 e = f_.edge(edge);
            if (!normalize(e) || std::fabs(dot(n, e)) > kAlongCrest) continue;
            Vec3 upright = n - dot(n, e) * e;
            if (!normalize(upright)) continue;
            const Crest beside = crest_at_edge(f_, edge, upright);
            const Real across = overlap_along(upright);
            if (beside.stands && across < kFaceFirst * depth) return judge(upright, across, beside, edge);
        }
        judge(n, d, crest, shows.at);
    }

    void judge(Vec3 n, Real d, Crest crest, int edge)
    {
        if (crest.stands) {
            if (!crest.border || own_ > kLip * m_.solid.size)
                normal = n, depth = d > 0 ? d : 0, on_crest = true;
            return;
        }
        blocked_ = d < blocked_ ? d : blocked_;
        if (edge >= 0 && f_.rim[edge] == Rim::kHollow && d < hollow_) hollow_ = d;
    }

    // Both senses of an axis of the length sqrt(size2); false when it parts the two. Most axes are done with
    // before their length is needed.
    bool offer(Vec3 a, Real size2 = 1)
    {
        const Real low = low_along(a);
        const Real high = symmetric() ? 2 * dot(a, m_.solid.pose.p) - low : -low_along(-a);
        Real least = kInf, most = -kInf;
        for (const Vec3 v : f_.v) {
            const Real at = dot(a, v);
            least = at < least ? at : least, most = at > most ? at : most;
        }
        const Real up = most - low, down = high - least, d = up <= down ? up : down;
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

    // The axes of a box in its own frame: across its faces, and across one of its edges and one of the
    // triangle's, along which two of the triangle's corners are one.
    bool box_axes()
    {
        const Pose& pose = m_.solid.pose;
        const Real half[3] = {box_->half.x, box_->half.y, box_->half.z};
        const Vec3 column[3] = {pose.R.column(0), pose.R.column(1), pose.R.column(2)};
        Real v[3][3];
        for (int k = 0; k < 3; ++k) {
            const Vec3 from_middle = f_.v[k] - pose.p;
            for (int i = 0; i < 3; ++i) v[k][i] = dot(column[i], from_middle);
        }
        for (int i = 0; i < 3; ++i) {
            const Real least = std::min(std::min(v[0][i], v[1][i]), v[2][i]);
            const Real most = std::max(std::max(v[0][i], v[1][i]), v[2][i]);
            const Real up = most + half[i], down = half[i] - least, d = up <= down ? up : down;
            if (d < -m_.slack) return false;
            if (d < kFaceFirst * depth) consider(up <= down ? column[i] : -column[i], d);
        }
        constexpr int kNext[3] = {1, 2, 0};
        for (int i = 0; i < 3; ++i) {
            const int j = kNext[i], l = kNext[j];
            for (int k = 0; k < 3; ++k) {
                const Real *p = v[k], *next = v[kNext[k]], *other = v[kNext[kNext[k]]];
                const Real aj = p[l] - next[l], al = next[j] - p[j], ei = next[i] - p[i];
                const Real size2 = aj * aj + al * al;
                if (size2 <= Real(1e-6) * (size2 + ei * ei)) continue;
                const Real on = aj * p[j] + al * p[l], off = aj * other[j] + al * other[l];
                const Real reach = half[j] * std::fabs(aj) + half[l] * std::fabs(al);
                const Real up = std::max(on, off) + reach, down = reach - std::min(on, off);
                const Real d = up <= down ? up : down, worth = kFaceFirst * depth;
                if (d < 0 && d * d > m_.slack * m_.slack * size2) return false;
                if (d > 0 && d * d >= worth * worth * size2) continue;
                const Real size = std::sqrt(size2), per = (up <= down ? 1 : -1) / size;
                consider(per * (aj * column[j] + al * column[l]), d / size);
            }
        }
        return true;
    }

    bool axes()
    {
        if (box_) return box_axes();
        const ConvexView& s = m_.solid;
        for (int i = 0; i < 3; ++i)
            if ((s.face_axes >> i & 1) && !offer(s.pose.R.column(i))) return false;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k)
                if ((s.edge_axes >> i & 1) && !offer_cross(s.pose.R.column(i), f_.edge(k))) return false;
        for (const PolyhedronFace& face : s.faces)
            if (!offer(s.pose.R * face.normal)) return false;
        if (many_edges()) return true;
        for (const Vec3 edge : s.edges)
            for (int k = 0; k < 3; ++k)
                if (!offer_cross(s.pose.R * edge, f_.edge(k))) return false;
        return true;
    }
    bool many_edges() const { return m_.solid.edges.size() > kManyEdges; }

    // Without crests, an edge says only how far the solid is over the triangle.
    bool settled(int edge) const
    {
        const Rim rim = f_.rim[edge];
        if (rim == Rim::kConvex)
            return !rim_turns_before(*cylinder_, m_.solid.pose, f_, edge, f_.beyond[edge]);
        return rim == Rim::kSeam || rim == Rim::kFlat;
    }

    // The round of a cylinder against corners, and its rims against edges: every one, or what may be a crest
    // or tell that the solid is on a neighbour.
    bool rims(bool every)
    {
        const Pose& pose = m_.solid.pose;
        const Vec3 axis = pose.R.column(2);
        for (const Vec3 v : f_.v) {
            Vec3 n = pose.p - v;
            n -= dot(n, axis) * axis;
            if (!normalize(n)) continue;
            const Real d = overlap_along(n);
            if (d < -m_.slack) return false;
            consider(n, d);
        }
        for (int k = 0; k < 3; ++k) {
            RimMinimum found[kMostRimMinima];
            if (!every && settled(k)) {
                quick_ = true;
                continue;
            }
            const bool hollow = !every && f_.rim[k] == Rim::kHollow;
            quick_ = quick_ || hollow;
            const int count =
                rim_minima(*cylinder_, pose, f_, k, hollow ? kThere * own_ : kFaceFirst * depth, found);
            for (int i = 0; i < count; ++i) {
                if (found[i].overlap < -m_.slack) return false;
                consider(found[i].normal, found[i].overlap);
            }
        }
        return true;
    }

    // What has no short list of directions: rims, and polyhedra with many edges.
    bool exact(bool every)
    {
        const ConvexView& s = m_.solid;
        if (cylinder_) return rims(every);
        if (s.face_axes == 7 || (!s.edges.empty() && !many_edges())) return true;
        const ConvexView flat = view_of(f_);
        if (!f_.has_crest() || own_ < kShallow * s.size) return !(gjk_distance(s, flat).distance > m_.slack);
        const Overlap o = least_overlap(s, flat);
        if (o.depth < -m_.slack) return false;
        consider(o.normal, o.depth);
        return true;
    }

    const MeshFacet& f_;
    const MeshMeeting& m_;
    const Box* box_ = nullptr;
    const Cylinder* cylinder_ = nullptr;
    Real own_ = 0;
    bool quick_ = false;
    // Least overlap in directions that are no contact's. When it is less than a crest's, the solid is not on
    // that crest: it has barely come over this triangle, and what it really touches is another.
    Real blocked_ = kInf;
    Real hollow_ = kInf;  // of these, against a neighbour that rises
};

// A crest of the surface pushes into the solid.
void press_crest(const MeshFacet& f, Vec3 normal, Real depth, MeshMeeting& m)
{
    dContactGeom found[4];
    ContactSink sink(found, sizeof(dContactGeom), 4, false);
    convex_manifold(m.solid, view_of(f), normal, depth, sink);
    for (int k = 0; k < sink.count(); ++k)
        m.out.add(load(found[k].pos), load(found[k].normal), found[k].depth, f.index);
}

// The rest of the search is only for what is not seen to touch.
void press_if_met(const MeshFacet& f, LeastWay& least, MeshMeeting& m)
{
    MeshGround ground(f, m);
    ground.hold();
    press_solid<MeshGround&>(m.solid, f, ground);
    if (ground.held() == 0) return;
    if (ground.met() || (least.search_all() && !least.on_crest)) return ground.deliver();
    if (least.on_crest) press_crest(f, least.normal, least.depth, m);
}

void meet_side(const MeshFacet& f, MeshMeeting& m)
{
    LeastWay least(f, m);
    if (!least.search()) return;
    if (least.on_crest)
        press_crest(f, least.normal, least.depth, m);
    else if (m.solid.kind == SolidKind::kBox)
        press_box(*static_cast<const Box*>(m.solid.shape), f, m);
    else if (!least.quick())
        press_solid(m.solid, f, MeshGround(f, m));
    else
        press_if_met(f, least, m);
}

}  // namespace

void solid_on(const MeshFacet& f, MeshMeeting& m)
{
    if (f.height(m.solid.pose.p) >= -m.slack)
        meet_side(f, m);
    else if (m.two_sided)
        meet_side(turned(f), m);
}

bool crest_pushes(const MeshFacet& f, MeshMeeting& m)
{
    LeastWay least(f, m);
    if (!least.search() || !least.on_crest) return false;
    press_crest(f, least.normal, least.depth, m);
    return true;
}

}  // namespace epode
