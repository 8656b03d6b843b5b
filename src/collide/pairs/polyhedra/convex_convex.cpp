// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Any two convex solids. First the normal and the depth (least_overlap, or GJK when only the radii touch),
// then the manifold by what the solids show each other along the normal:
//   face against anything   the other's feature, cut by the sides of the face (the true circle of a
//                           cylinder's end): the points below the face, each with its own depth
//   two discs               the lens that two circles share: their crossings, the innermost point of each rim
//   two lines side by side  both ends of the common stretch
//   else                    one point between the two nearest features
// Points of a face contact lie on the incident solid, as for boxes. The true deepest point is always among
// them.
#include "collide/pairs/pairs.h"
#include "geometry/best_four.h"
#include "geometry/closest.h"
#include "geometry/overlap/epa.h"
#include "geometry/overlap/flat_overlap.h"
#include "geometry/overlap/gjk.h"

namespace epode {

namespace {

constexpr Real kFaceSine2 = Real(1e-6);  // normal against face normal, beyond the jitter of resting solids
constexpr Real kLineSine2 = Real(1e-4);  // "nearly parallel" lines

struct Manifold {
    static constexpr int kMax = Polygon::kMax;
    union {
        ContactPoint points[kMax];  // in a union: left unwritten until added
    };
    int count = 0, touching = 0;  // of which
    Real largest = 0;
    const Real margin;  // see ContactSink
    explicit Manifold(Real margin_of_it) : margin(margin_of_it) {}
    void add(Vec3 position, Vec3 normal, Real depth)
    {
        if (depth < -margin || count == kMax) return;
        if (depth > largest) largest = depth;
        if (depth >= 0) ++touching;
        points[count++] = {position, normal, depth};
    }
    void clear() { count = 0, touching = 0, largest = 0; }
};

// The face's own, else Newell's; zero for fewer than three points.
Vec3 face_normal(const Polygon& f)
{
    if (!(f.normal == Vec3{})) return f.normal;
    Vec3 n;
    for (int i = 1; i + 1 < f.count; ++i)
        n += cross(f.points[i] - f.points[0], f.points[i + 1] - f.points[0]);
    return normalize(n) ? n : Vec3{};
}

bool faces(const Polygon& f, Vec3 direction)
{
    if (f.count < 3) return false;
    const Vec3 n = face_normal(f);
    return dot(n, direction) > 0 && length2(cross(n, direction)) < kFaceSine2;
}

bool is_end(const ConvexView& v, const Polygon& f) { return v.rim_radius > 0 && f.count == kRimPoints; }

Vec3 centre_of(const Polygon& f)
{
    Vec3 c;
    for (int i = 0; i < f.count; ++i) c += f.points[i];
    return c / Real(f.count);
}

// Whether a point is on the inner side of all edges.
bool over(const Polygon& f, Vec3 normal, Vec3 p)
{
    for (int i = 0; i < f.count; ++i) {
        const Vec3 from = f.points[i], to = f.points[i + 1 < f.count ? i + 1 : 0];
        if (dot(cross(to - from, normal), p - from) > 0) return false;
    }
    return true;
}

// The part of the incident polygon over the disc, edges cut by the true circle, and the rim points under it.
void clip_to_disc(const Polygon& rim, Vec3 centre, Real radius, Vec3 axis, Polygon& incident)
{
    Polygon cut;
    const auto flat = [&](Vec3 x) { return x - dot(axis, x) * axis; };
    const Real r2 = radius * radius * (1 + 64 * kEpsilon);
    const int edges = incident.count > 2 ? incident.count : incident.count - 1;
    for (int i = 0; i < edges; ++i) {
        const Vec3 p = incident.points[i], q = incident.points[i + 1 < incident.count ? i + 1 : 0];
        const Vec3 o = flat(p - centre), d = flat(q - p);
        const Real dd = length2(d), od = dot(o, d), oo = length2(o);
        if (oo <= r2) cut.add(p);
        const Real disc = od * od - dd * (oo - radius * radius);
        if (!(dd > 0) || !(disc > 0)) continue;
        const Real root = std::sqrt(disc), t1 = (-od - root) / dd, t2 = (-od + root) / dd;
        if (oo > r2 && t1 > 0 && t1 < 1) cut.add(p + t1 * (q - p));
        const bool q_inside = length2(o + d) <= r2;
        if (!q_inside && t2 > 0 && t2 < 1) cut.add(p + t2 * (q - p));
        if (q_inside && i + 1 == edges && incident.count == 2) cut.add(q);
    }
    if (incident.count > 2) {
        const Vec3 n = face_normal(incident);
        const Real lean = dot(n, axis);
        for (int i = 0; i < rim.count && lean != 0;
             ++i) {  // the rim point moved along the axis into the face
            const Vec3 p = rim.points[i] + (dot(n, incident.points[0] - rim.points[i]) / lean) * axis;
            if (over(incident, n, p)) cut.add(p);
        }
    }
    incident = cut;
}

// What two nearly parallel discs share, seen along the axis; points in the plane of the second.
void lens(const Polygon& rim1, Vec3 c1, Real r1, const Polygon& rim2, Vec3 c2, Real r2, Vec3 axis,
          Polygon& out)
{
    Vec3 across = c2 - c1;
    across = across - dot(axis, across) * axis;
    const Real distance = length(across);
    const Vec3 rise = c2 - c1 - across;
    if (distance <= std::fabs(r1 - r2)) {  // one within the other: the smaller rim at its fixed directions
        for (int i = 0; i < kRimPoints; i += 2) out.add(r1 < r2 ? rim1.points[i] + rise : rim2.points[i]);
        return;
    }
    if (distance > r1 + r2 || !(distance > 0)) return;
    const Vec3 u = across / distance, v = cross(axis, u);
    const Real x = (distance * distance + r1 * r1 - r2 * r2) / (2 * distance);
    const Real y2 = r1 * r1 - x * x, y = y2 > 0 ? std::sqrt(y2) : Real(0);
    const Vec3 base = c1 + rise;
    out.add(base + r1 * u), out.add(base + x * u + y * v), out.add(c2 - r2 * u),
        out.add(base + x * u - y * v);
}

// One side of a manifold.
struct Side {
    const ConvexView& view;
    const Polygon& feature;
};

// `inward`: from the incident solid into the reference one, along which depth grows.
void face_contacts(const Side& reference, const Side& incident, Vec3 inward, bool reference_is_a, Real depth,
                   Manifold& out)
{
    const Vec3 normal = reference_is_a ? inward : -inward;
    const Real radii = reference.view.radius + incident.view.radius;
    const Real size = reference.view.size + incident.view.size;
    Polygon cut;
    Vec3 axis = face_normal(reference.feature);
    const Real lean = -dot(axis, inward);  // almost one: the normal may lean a little from the face normal
    const bool round = is_end(reference.view, reference.feature);
    const Vec3 centre = centre_of(reference.feature);
    if (round && is_end(incident.view, incident.feature) &&
        length2(cross(incident.view.pose.R.column(2), axis)) < Real(1e-3)) {
        lens(reference.feature, centre, reference.view.rim_radius, incident.feature,
             centre_of(incident.feature), incident.view.rim_radius, axis, cut);
    } else {
        for (int i = 0; i < incident.feature.count; ++i) cut.add(incident.feature.points[i]);
        cut.normal = incident.feature.normal;
        if (round)
            clip_to_disc(reference.feature, centre, reference.view.rim_radius, axis, cut);
        else
            clip_to_prism(cut, reference.feature, axis, 32 * kEpsilon * size);
    }
    const Vec3 own = incident.view.radius * inward;
    const Vec3 plane = incident.view.pose.R.column(2);
    const Vec3 c2 = centre_of(incident.feature);
    const bool level = is_end(incident.view, incident.feature) && std::fabs(dot(plane, axis)) > Real(0.5);
    const Real hair = 32 * kEpsilon * size, touch = Real(1e-5) * size;
    Vec3 nearest;
    Real least_gap = touch;
    for (int i = 0; i < cut.count; ++i) {
        Vec3 x = cut.points[i];
        if (level) x += (dot(plane, c2 - x) / dot(plane, axis)) * axis;  // into the plane of the incident end
        const Real below = -dot(axis, x - centre) / lean;
        Real d = (below < depth ? below : depth) + radii;
        if (d < 0 && d >= -hair) d = 0;
        if (-d < least_gap) nearest = x + own, least_gap = -d;
        out.add(x + own, normal, d);
    }
    // What is over the face hardly touches: it does, and not what is deeper aside of the face.
    if (out.touching == 0 && least_gap < touch && depth + radii < touch) return out.add(nearest, normal, 0);
    if (out.touching == 0 || out.largest < depth + radii - touch)
        out.add(incident.view.support(inward) + own, normal, depth + radii > 0 ? depth + radii : Real(0));
}

// The straight line that a solid shows along `direction`, an edge or side line nearly across it.
struct Shown {
    Vec3 from, to;
    bool line = false;
    Real fall = 0, length = 0;  // against the direction from one end to the other

    bool leans_less(Real lean) const { return line && fall < lean * length; }
};

Shown shown(const ConvexView& v, const Polygon& f, Vec3 direction, Real lean)
{
    Shown s;
    if (is_end(v, f) || f.count < 2) return s;
    int best = 0;
    for (int i = 1; i < f.count; ++i)
        if (dot(direction, f.points[i]) > dot(direction, f.points[best])) best = i;
    const int around[2] = {best + 1 < f.count ? best + 1 : 0, best > 0 ? best - 1 : f.count - 1};
    Real least = lean;
    for (const int i : around) {
        const Vec3 d = f.points[i] - f.points[best];
        const Real fall = -dot(direction, d), long_ = length(d);
        if (long_ > 0 && fall < least * long_)
            least = fall / long_, s = {f.points[best], f.points[i], true, fall, long_};
    }
    return s;
}

// It, or if it leans more the farthest point.
void line_or_point(const ConvexView& v, const Shown& line, Vec3 direction, Real lean, Vec3& from, Vec3& to)
{
    if (line.leans_less(lean))
        from = line.from, to = line.to;
    else
        from = to = v.support(direction);
}

// Both ends of the common stretch of two nearly parallel lines; false when they are not, or have none.
bool side_by_side(const Shown& a, const Shown& b, Vec3 normal, Real radii, Real depth, Real own,
                  Manifold& out)
{
    if (!a.line || !b.line) return false;
    Vec3 u = a.to - a.from, v = b.to - b.from;
    const Real length_a = length(u);
    if (!normalize(u) || !normalize(v) || length2(cross(u, v)) > kLineSine2) return false;
    const Real s1 = dot(u, b.from - a.from), s2 = dot(u, b.to - a.from);
    const Real lo = std::fmax(Real(0), std::fmin(s1, s2)), hi = std::fmin(length_a, std::fmax(s1, s2));
    if (!(hi - lo > Real(1e-6) * length_a)) return false;
    const Real slope = 1 / dot(u, v);
    Manifold ends(out.margin);
    for (const Real s : {lo, hi}) {
        const Vec3 x = a.from + s * u, y = b.from + (s - s1) * slope * v;
        Real d = dot(normal, y - x);
        if (d > depth) d = depth;
        ends.add(x + (Real(0.5) * (d + radii) - own) * normal, normal, d + radii);
    }
    if (ends.touching == 0 || ends.largest < depth + radii - Real(1e-5) * length_a) return false;
    for (int i = 0; i < ends.count; ++i) out.add(ends.points[i].position, normal, ends.points[i].depth);
    return true;
}

void single(const Side& a, const Side& b, Vec3 normal, Real depth, Manifold& out)
{
    const Real radii = a.view.radius + b.view.radius;
    const Real total = depth + radii > 0 ? depth + radii : Real(0);
    const Real lean = Real(0.02), exact = kSingle ? Real(1e-3) : Real(1e-6);
    const Shown of_a = shown(a.view, a.feature, -normal, lean), of_b = shown(b.view, b.feature, normal, lean);
    if (side_by_side(of_a, of_b, normal, radii, depth, a.view.radius, out)) return;
    Vec3 p, p_end, q, q_end, x, y;
    line_or_point(a.view, of_a, -normal, exact, p, p_end);
    line_or_point(b.view, of_b, normal, exact, q, q_end);
    closest_segment_points(p + depth * normal, p_end + depth * normal, q, q_end, x, y);
    x = x - depth * normal;
    const Vec3 low_a = x - a.view.radius * normal, high_b = y + b.view.radius * normal;
    out.add(Real(0.5) * (low_a + high_b), normal, total);
}

void make_manifold(const ConvexView& a, const ConvexView& b, Vec3 normal, Real depth, Manifold& out)
{
    Polygon fa, fb;
    a.feature(-normal, fa);
    b.feature(normal, fb);
    const Side sa = {a, fa}, sb = {b, fb};
    if (faces(fa, -normal))
        face_contacts(sa, sb, normal, true, depth, out);
    else if (faces(fb, normal))
        face_contacts(sb, sa, -normal, false, depth, out);
    else
        single(sa, sb, normal, depth, out);
}

// Corners and rims: of what is round all over no point can be told before it touches.
bool has_faces(const ConvexView& v) { return FlatSolid::is_flat(v) || v.kind == SolidKind::kCylinder; }

Real margin_of(const ConvexView& a, const ConvexView& b, const ContactSink& sink)
{
    return has_faces(a) && has_faces(b) ? sink.margin() : Real(0);
}

}  // namespace

void convex_manifold(const ConvexView& a, const ConvexView& b, Vec3 normal, Real depth, ContactSink& sink)
{
    Manifold out(margin_of(a, b, sink));
    make_manifold(a, b, normal, depth, out);
    sink.add_manifold({out.points, std::size_t(out.count)});
}

namespace {

// Whether the middle of the contacts, or the deepest one, shows that no other normal can be better.
template <class Pair>
bool proven(const Pair& pair, const Manifold& m)
{
    if (m.touching == 0) return false;
    Vec3 middle;
    int deepest = 0;
    for (int i = 0; i < m.count; ++i) {
        if (m.points[i].depth < 0) continue;
        middle += m.points[i].position;
        if (m.points[i].depth > m.points[deepest].depth) deepest = i;
    }
    return pair.proven_at(middle / Real(m.touching)) || pair.proven_at(m.points[deepest].position);
}

// Whether the overlap along a face is the less one when the two are deeper by the margin, and it is nearly
// the same direction: a face shows more corners.
bool will_be_less(const Overlap& face, const Overlap& least, Real margin)
{
    const Real cosine = dot(face.normal, least.normal);
    return margin > 0 && cosine > kManifoldCosine && face.depth < least.depth + margin * (1 - cosine);
}

// Contacts along a face's normal are the rule, and often prove by themselves that they are right: they are
// made before any other normal is tried, unless the two are so deep in each other that this would be rare.
template <class Pair>
void meet(const ConvexView& a, const ConvexView& b, Pair& pair, Real enough, ContactSink& sink)
{
    constexpr Real kShallow = Real(0.05);
    const auto depth = [&] { return pair.best.depth > 0 ? pair.best.depth : Real(0); };
    pair.try_faces(enough);
    if (!(pair.best.depth >= enough)) return;
    bool sure = pair.proven();
    Manifold out(margin_of(a, b, sink));
    if (!sure && a.radius + b.radius == 0 && pair.best.depth < kShallow * (a.size + b.size)) {
        make_manifold(a, b, pair.best.normal, depth(), out);
        sure = proven(pair, out);
    }
    if (!sure) {
        const Overlap face = pair.best;
        pair.try_rest(enough);
        if (!(pair.best.depth >= enough)) return;
        if (will_be_less(face, pair.best, out.margin)) pair.best = face;
        if (!(pair.best.normal == face.normal)) out.clear();
    }
    if (out.count == 0) make_manifold(a, b, pair.best.normal, depth(), out);
    sink.add_manifold({out.points, std::size_t(out.count)});
}

// A distance to rounding leaves its direction open by the root of that. Where a face of a polyhedron parts
// the two as far, its normal is the steadier answer.
Vec3 settled(const ConvexView& a, const ConvexView& b, Vec3 normal, Real distance)
{
    Overlap flush;
    offer_face(a, -1, normal, a, b, flush);
    offer_face(b, 1, normal, a, b, flush);
    const Real hair = 16 * kEpsilon * (a.size + b.size + length(b.pose.p - a.pose.p));
    return flush.depth <= hair - distance ? flush.normal : normal;
}

}  // namespace

void convex_convex(const ConvexView& a, const ConvexView& b, ContactSink& sink)
{
    const Real radii = a.radius + b.radius, reach = a.size + b.size + radii;
    const Real apart = length(b.pose.p - a.pose.p);
    const Real touch = 64 * kEpsilon * (reach + apart);
    if (apart > reach + touch) return;
    if (radii > 0) {  // the cores may be apart
        const Distance d = gjk_distance(a, b, radii);
        if (d.distance > radii) return;
        Vec3 normal = kSingle ? d.normal : d.on_a - d.on_b;
        if (d.distance > touch && normalize(normal))
            return convex_manifold(a, b, settled(a, b, normal, d.distance), -d.distance, sink);
    }
    if (with_pair(a, b, [&](auto&& pair) { meet(a, b, pair, -touch - radii, sink); })) return;
    const Overlap o = least_overlap(a, b);
    if (o.depth >= -touch - radii) convex_manifold(a, b, o.normal, o.depth > 0 ? o.depth : Real(0), sink);
}

}  // namespace epode
