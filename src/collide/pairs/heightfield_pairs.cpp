// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sphere, capsule, box and cylinder against a height field, in the field's frame (y up). The ground is solid down
// to any depth: under each facet stands an endless column. Facets whose cells lie under the solid's box are taken
// one after the other.
//   all samples under the solid in one plane   the plane's pair function: a flat field is a plane, exactly
//   round cores (point or segment s, radius r)
//     over the facet        ends of the part of s whose foot lies in the facet, depth r - height
//     beside an edge        nearest points p, q of s and the edge, along p - q
//     core under the facet  ends of the part of s in the column, depth r + distance
//   box, cylinder           of all directions that can part solid and column and are upward, the one of least
//                           overlap; then the manifold along it: the lower faces of the solid cut by the column,
//                           or the facet's edge cut by the solid
// A direction that is not the facet's own normal must crest there (Terrain::crests): the surface lies below it on all
// sides. At flat and hollow edges none does, so a solid that slides over them meets no bumps.
// Rejected: each facet as a solid of its own with GJK/EPA; it meets the walls between columns, which do not exist.
#include "collide/heightfield.h"
#include "collide/pairs/harvest.h"
#include "collide/pairs/pairs.h"
#include "geometry/closest.h"
#include "geometry/epa.h"

namespace epode {

namespace {

constexpr Vec3 kUp{0, 1, 0};
constexpr Real kSteepest = Real(1e-3);      // least upward part of a contact normal
constexpr Real kFaceFirst = Real(0.95);     // another direction must beat the face's by this factor
constexpr Real kFaceLean = Real(0.17);      // faces that look down by more than 10 degrees carry contacts

Aabb box_around(const ConvexView& v)
{
    const Vec3 r{v.radius, v.radius, v.radius};
    const Vec3 hi = {v.support({1, 0, 0}).x, v.support({0, 1, 0}).y, v.support({0, 0, 1}).z};
    const Vec3 lo = {v.support({-1, 0, 0}).x, v.support({0, -1, 0}).y, v.support({0, 0, -1}).z};
    return {lo - r, hi + r};
}

struct Cells {
    int i0, i1, j0, j1;  // inclusive
};

// The cells under the box; false when there are none or the place is out of all measure.
bool cells_under(const Terrain& t, const Aabb& box, Cells& out)
{
    const Vec3 o = t.low_corner(), cell = t.cell();
    const Real from[2] = {(box.lo.x - o.x) / cell.x, (box.lo.z - o.z) / cell.z};
    const Real to[2] = {(box.hi.x - o.x) / cell.x, (box.hi.z - o.z) / cell.z};
    const int count[2] = {t.cells_x(), t.cells_z()};
    int lo[2], hi[2];
    constexpr Real kFar = 1e9;
    for (int a = 0; a < 2; ++a) {
        if (!(from[a] > -kFar && to[a] < kFar)) return false;
        if (!t.endless() && (to[a] < 0 || from[a] > Real(count[a]))) return false;
        lo[a] = int(std::floor(from[a])), hi[a] = int(std::floor(to[a]));
        if (t.endless()) continue;
        lo[a] = lo[a] < 0 ? 0 : lo[a] < count[a] ? lo[a] : count[a] - 1;
        hi[a] = hi[a] < 0 ? 0 : hi[a] < count[a] ? hi[a] : count[a] - 1;
    }
    out = {lo[0], hi[0], lo[1], hi[1]};
    return true;
}

// What the samples under the solid look like together.
struct Ground {
    Real lowest = kInf, highest = -kInf;
    bool level = true;  // all in the plane of the first facet
};

Ground survey(const Terrain& t, const Cells& c, const Facet& first, Real slack)
{
    Ground g;
    for (int j = c.j0; j <= c.j1 + 1; ++j)
        for (int i = c.i0; i <= c.i1 + 1; ++i) {
            const Vec3 v = t.vertex(i, j);
            g.lowest = v.y < g.lowest ? v.y : g.lowest;
            g.highest = v.y > g.highest ? v.y : g.highest;
            g.level = g.level && std::fabs(first.height(v)) <= slack;
        }
    return g;
}

bool inside(const Terrain& t, const Aabb& box)
{
    const Vec3 o = t.low_corner();
    return t.endless() || (box.lo.x >= o.x && box.lo.z >= o.z && box.hi.x <= -o.x && box.hi.z <= -o.z);
}

// Everything that the routines for one facet need.
struct Meeting {
    const Terrain& terrain;
    const ConvexView& solid;
    Aabb box;
    Real slack;  // rounding of coordinates
    Harvest& out;
};

// ---- round cores ----

struct Core {
    Vec3 a, b;
    Real r;
};

void over_and_under(const Core& s, const Facet& f, Meeting& m)
{
    const Real at_a = f.height(s.a), at_b = f.height(s.b);
    for (const bool over : {true, false}) {
        Stretch part = within_prism(f, over ? f.n : kUp, s.a, s.b, m.slack);
        // Only the ends on the right side of the plane.
        const auto keep = over ? at_a >= 0 : at_a <= 0, keep_b = over ? at_b >= 0 : at_b <= 0;
        if (!keep && !keep_b) continue;
        if (keep != keep_b) {
            const Real t = at_a / (at_a - at_b);
            if (!keep && t > part.from) part.from = t;
            if (!keep_b && t < part.to) part.to = t;
        }
        if (part.empty()) continue;
        for (const Real t : {part.from, part.to}) {
            const Vec3 p = s.a + t * (s.b - s.a);
            const Real depth = s.r - f.height(p);
            if (depth >= 0) m.out.add(p - s.r * f.n, f.n, depth);
        }
    }
}

void beside_edge(const Core& s, const Facet& f, Vec3 p, Vec3 q, Meeting& m)
{
    Vec3 n = p - q;
    const Real distance = length(n);
    if (distance > s.r || !(distance > m.slack) || !normalize(n)) return;
    if (n.y < kSteepest || dot(n, f.n) < 0 || !m.terrain.crests(f, n)) return;
    m.out.add(p - s.r * n, n, s.r - distance);
}

void round_facet(const Core& s, const Facet& f, Meeting& m)
{
    const Real at_a = f.height(s.a), at_b = f.height(s.b);
    if (at_a > s.r && at_b > s.r) return;
    over_and_under(s, f, m);
    if (at_a < 0 && at_b < 0) return;
    const Vec3 axis = s.b - s.a;
    for (int k = 0; k < 3; ++k) {
        const Vec3 v = f.v[k], e = f.edge(k);
        Vec3 p, q;
        closest_segment_points(s.a, s.b, v, v + e, p, q);
        beside_edge(s, f, p, q, m);
        if (!(length2(axis) > 0) || length2(cross(axis, e)) > Real(1e-2) * length2(axis) * length2(e)) continue;
        // Side by side: both ends of the common stretch.
        for (const Vec3 end : {s.a, s.b}) beside_edge(s, f, end, v + closest_on_segment(v, v + e, end) * e, m);
        for (const Vec3 end : {v, v + e})
            beside_edge(s, f, s.a + closest_on_segment(s.a, s.b, end) * axis, end, m);
    }
}

// ---- box and cylinder ----

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
        return walls() && solid_faces() && edges() && rim();
    }

    Vec3 normal;
    Real depth = 0;

  private:
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
        if (d < kFaceFirst * depth && m_.terrain.crests(facet_, n)) depth = d, normal = n;
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
            if (normalize(n) && overlap_along(n) < -m_.slack) return false;
        }
        return true;
    }

    bool solid_faces()
    {
        for (int i = 0; i < 3; ++i)
            if ((m_.solid.face_axes >> i & 1) && !offer(m_.solid.pose.R.column(i))) return false;
        return true;
    }

    bool edges()
    {
        for (int i = 0; i < 3; ++i) {
            if (!(m_.solid.edge_axes >> i & 1)) continue;
            const Vec3 axis = m_.solid.pose.R.column(i);
            if (!offer_cross(axis, kUp)) return false;
            for (int k = 0; k < 3; ++k)
                if (!offer_cross(axis, facet_.edge(k))) return false;
        }
        return true;
    }

    // A round rim on a ridge has no finite list of directions.
    bool rim()
    {
        if (!(m_.solid.rim_radius > 0) || !m_.terrain.has_ridge(facet_)) return true;
        const Overlap o = least_overlap(m_.solid, view_of(facet_));
        if (o.normal.y < 0) return true;
        if (o.depth < -m_.slack) return false;
        const bool better = o.normal.y >= kSteepest && o.depth < kFaceFirst * depth;
        if (better && m_.terrain.crests(facet_, o.normal)) depth = o.depth > 0 ? o.depth : 0, normal = o.normal;
        return true;
    }

    const Facet& facet_;
    const Meeting& m_;
};

void press(Polygon& low, const Facet& f, Meeting& m)
{
    clip_to_prism(low, f, kUp, m.slack);
    for (int k = 0; k < low.count; ++k) {
        const Real depth = -f.height(low.points[k]);
        if (depth >= -m.slack) m.out.add(low.points[k], f.n, depth > 0 ? depth : 0);
    }
}

void press_point(Vec3 p, const Facet& f, Meeting& m)
{
    Polygon one;
    one.add(p);
    press(one, f, m);
}

// Where the true rims pass over the facet's edges: on a ridge, these are the deepest points.
void press_rims(const Facet& f, Meeting& m)
{
    const Vec3 axis = m.solid.pose.R.column(2);
    const Real r = m.solid.rim_radius;
    for (const Vec3 end : {axis, -axis}) {
        const Vec3 centre = m.solid.support(end);
        for (int k = 0; k < 3; ++k) {
            Vec3 wall = cross(f.edge(k), kUp);
            const Real offset = dot(wall, f.v[k] - centre);
            wall -= dot(wall, axis) * axis;  // within the plane of the end
            const Real steep = length(wall), s = offset / steep;
            if (!(std::fabs(s) < r)) continue;
            const Vec3 out = wall / steep, along = std::sqrt(r * r - s * s) * cross(axis, out);
            press_point(centre + s * out + along, f, m);
            press_point(centre + s * out - along, f, m);
        }
    }
}

// The lower faces of the solid that lie over the facet.
void press_faces(const Facet& f, Meeting& m)
{
    const ConvexView& s = m.solid;
    for (int i = 0; i < 3; ++i) {
        if (!(s.face_axes >> i & 1)) continue;
        const Vec3 axis = s.pose.R.column(i), down = dot(axis, f.n) > 0 ? -axis : axis;
        if (-dot(down, f.n) < kFaceLean) continue;
        Polygon face;
        s.feature(down, face);
        press(face, f, m);
    }
    if (!(s.rim_radius > 0)) return;
    const Vec3 axis = s.pose.R.column(2);
    const Vec3 aside = dot(axis, f.n) * axis - f.n;
    if (length2(aside) > kFaceLean * kFaceLean) {
        Polygon line;
        s.feature(aside, line);
        press(line, f, m);
    }
    press_point(s.support(-f.n), f, m);  // the lowest of the true rim, not of its polygon
    press_rims(f, m);
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

void solid_facet(const Facet& f, Meeting& m)
{
    LeastRise least(f, m);
    if (!least.search()) return;
    if (dot(least.normal, f.n) > Real(1) - Real(1e-9))
        press_faces(f, m);
    else
        press_crest(f, least.normal, least.depth, m);
}

void meet(const Sphere& a, const Pose& A, const Facet& f, Meeting& m) { round_facet({A.p, A.p, a.radius}, f, m); }
void meet(const Capsule& a, const Pose& A, const Facet& f, Meeting& m)
{
    const Vec3 half = a.half_length * A.R.column(2);
    round_facet({A.p - half, A.p + half, a.radius}, f, m);
}
void meet(const Box&, const Pose&, const Facet& f, Meeting& m) { solid_facet(f, m); }
void meet(const Cylinder&, const Pose&, const Facet& f, Meeting& m) { solid_facet(f, m); }

void on_plane(const Sphere& a, const Pose& A, const Plane& p, ContactSink& s) { sphere_plane(a, A, p, {}, s); }
void on_plane(const Capsule& a, const Pose& A, const Plane& p, ContactSink& s) { capsule_plane(a, A, p, {}, s); }
void on_plane(const Box& a, const Pose& A, const Plane& p, ContactSink& s) { box_plane(a, A, p, {}, s); }
void on_plane(const Cylinder& a, const Pose& A, const Plane& p, ContactSink& s) { cylinder_plane(a, A, p, {}, s); }

// Contacts in the field's frame.
template <typename Shape>
void collide_local(const Shape& a, const Pose& A, const HeightfieldData& data, ContactSink& sink)
{
    const Terrain terrain(data);
    const ConvexView solid = view_of(a, A);
    const Aabb box = box_around(solid);
    Cells cells;
    if (!cells_under(terrain, box, cells)) return;
    const Facet first = terrain.facet(cells.i0, cells.j0, false);
    const Real reach = max_component(max(abs(box.lo), abs(box.hi)));
    const Real slack = 64 * kEpsilon * (reach + solid.size);
    const Ground ground = survey(terrain, cells, first, slack);
    if (box.lo.y > ground.highest) return;
    if (box.hi.y < ground.lowest) {  // buried: straight up
        sink.add({{A.p.x, ground.lowest, A.p.z}, kUp, ground.lowest - box.hi.y});
        return;
    }
    if (ground.level && inside(terrain, box)) return on_plane(a, A, {first.n, first.c}, sink);
    Harvest harvest(Real(1e-6) * (solid.size + solid.radius));
    Meeting meeting{terrain, solid, box, slack, harvest};
    for (int j = cells.j0; j <= cells.j1; ++j)
        for (int i = cells.i0; i <= cells.i1; ++i)
            for (const bool upper : {false, true}) {
                const Facet f = terrain.facet(i, j, upper);
                const bool above = f.v[0].y < box.lo.y && f.v[1].y < box.lo.y && f.v[2].y < box.lo.y;
                if (!above) meet(a, A, f, meeting);
            }
    harvest.deliver(sink);
}

template <typename Shape>
void collide_field(const Shape& a, const Pose& A, const Heightfield& b, const Pose& B, ContactSink& sink)
{
    const HeightfieldData* data = b.field();
    if (!data) return;
    const int before = sink.count();
    collide_local(a, inverse_times(B, A), *data, sink);
    for (int k = before; k < sink.count(); ++k) {
        dContactGeom& c = *sink.at(k);
        store(c.pos, B.to_world(load(c.pos)));
        store(c.normal, B.R * load(c.normal));
    }
}

}  // namespace

void sphere_heightfield(const Sphere& a, const Pose& A, const Heightfield& b, const Pose& B, ContactSink& sink)
{
    collide_field(a, A, b, B, sink);
}
void capsule_heightfield(const Capsule& a, const Pose& A, const Heightfield& b, const Pose& B, ContactSink& sink)
{
    collide_field(a, A, b, B, sink);
}
void box_heightfield(const Box& a, const Pose& A, const Heightfield& b, const Pose& B, ContactSink& sink)
{
    collide_field(a, A, b, B, sink);
}
void cylinder_heightfield(const Cylinder& a, const Pose& A, const Heightfield& b, const Pose& B, ContactSink& sink)
{
    collide_field(a, A, b, B, sink);
}

}  // namespace epode
