// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See impact.h.
#include "query/impact.h"

#include "collide/solid_type.h"

namespace epode {
namespace {

constexpr int kImpactAdvances = 500;
constexpr int kPieces = 256;

// A convex solid in motion. `arm`: how far its core reaches from the centre of rotation.
struct Traveller {
    ConvexView view;  // at the beginning
    Motion motion;
    Real arm;
    Vec3 middle;  // of a ball around it, in its frame
    Real reach;

    ConvexView at(Real t) const
    {
        ConvexView v = view;
        v.pose = motion.at(t, view.pose);
        return v;
    }
    Vec3 middle_at(Real t) const { return motion.at(t, view.pose).to_world(middle); }
};

Traveller traveller(const ConvexView& view, const Motion& motion)
{
    return {view, motion, length(view.pose.p - motion.centre) + view.size, {}, view.size + view.radius};
}

Traveller traveller(const Triangle& t, const Pose& pose, const Motion& motion)
{
    Traveller out = {view_of(t), motion, 0, (t.v[0] + t.v[1] + t.v[2]) / Real(3), 0};
    out.view.pose = pose;
    for (const Vec3 v : t.v) {
        out.arm = std::max(out.arm, length(pose.to_world(v) - motion.centre));
        out.reach = std::max(out.reach, length(v - out.middle));
    }
    return out;
}

// The largest speed of a point along a direction, from t on.
Real approach(const Motion& m, Real arm, Vec3 along, Real t)
{
    if (t >= m.until || !m.moves()) return 0;
    const Real spin = length(cross(along, m.turn));
    const Real rate = dot(along, m.shift) + (spin > 0 ? spin * arm : Real(0));
    return m.until < 1 ? std::max(rate, Real(0)) : rate;
}

Separation distance_of(const ConvexView& a, const ConvexView& b, Real limit)
{
    return separation(a, b, limit);
}
Separation distance_of(const ConvexView& a, const Plane& b, Real) { return separation(a, b); }

struct Impact {
    Real time = kInf;
    Vec3 normal;
};

// Two convex shapes; the second may be a half-space.
template <typename Other>
class Encounter {
  public:
    Encounter(const Traveller& a, const Motion& b, Real arm_b, const Other& other_at, Real max_time,
              Effort& effort)
        : a_(a), b_(b), arm_b_(arm_b), other_at_(other_at), max_time_(max_time), effort_(effort)
    {
        const bool together = a.motion.until == b.until;
        const Real straight =
            together ? length(a.motion.shift - b.shift) : length(a.motion.shift) + length(b.shift);
        way_ = straight + (a.motion.max_travel(a.arm) - length(a.motion.shift)) +
               (b.max_travel(arm_b) - length(b.shift));
    }

    Impact find(const ImpactRule& rule) const
    {
        if (!effort_.spend(Effort::kDistance)) return {};
        const Separation begin = distance_of(a_.at(0), other_at_(0), way_ + rule.hair);
        if (!(begin.distance < kInf)) return {};
        const bool touching = begin.distance <= Real(-0.25) * rule.hair;
        if (touching && !rule.held) return {};
        const Real deep = touching ? std::max(rule.allowed, rule.allowed / 4 - begin.distance) : rule.allowed;
        if (begin.distance - way_ > -deep) return {};
        if (!(reach(deep, rule.allowed / 16).time < kInf)) return {};
        return reach((touching ? -begin.distance : Real(0)) + rule.hair, rule.hair / 2);
    }

  private:
    // The first time at which they overlap by `depth`, within the tolerance.
    Impact reach(Real depth, Real tolerance) const
    {
        Real t = 0;
        Vec3 normal;
        for (int i = 0; i < kImpactAdvances; ++i) {
            if (!effort_.spend(Effort::kDistance)) return {};
            const Separation s = distance_of(a_.at(t), other_at_(t), way_ * (1 - t) + tolerance);
            if (!(s.distance < kInf)) return {};
            normal = s.normal;
            const Real clearance = s.distance + depth;
            if (clearance <= tolerance) return {t, normal};
            const Real closing =
                approach(a_.motion, a_.arm, -s.normal, t) + approach(b_, arm_b_, s.normal, t);
            if (!(closing > 0)) return {};
            t += (clearance - tolerance / 2) / closing;
            if (!(t <= max_time_)) return {};
        }
        return {t, normal};  // so slow that it can stop here
    }

    const Traveller& a_;
    const Motion& b_;
    Real arm_b_;
    const Other& other_at_;
    Real max_time_, way_;
    Effort& effort_;
};

Impact meet(const Traveller& a, const Traveller& b, const ImpactRule& rule, Real max_time, Effort& effort)
{
    const auto other_at = [&](Real t) { return b.at(t); };
    return Encounter(a, b.motion, b.arm, other_at, max_time, effort).find(rule);
}

Impact meet(const Traveller& a, const Plane& b, const ImpactRule& rule, Real max_time, Effort& effort)
{
    const Motion still;
    const auto other_at = [&](Real) -> const Plane& { return b; };
    return Encounter(a, still, 0, other_at, max_time, effort).find(rule);
}

// The path of a traveller in the surface's frame, as boxes around its pieces.
class SweptPath {
  public:
    SweptPath(const Traveller& a, const Mover& surface) : a_(a), surface_(surface)
    {
        const Motion &m = a.motion, &b = surface.motion;
        const Real spin_a = length(m.turn), spin_b = length(b.turn);
        const Real straight = length(m.shift) + length(b.shift);
        const Real far = length(m.centre - b.centre) + straight + a.arm + a.reach;
        length_ = straight + spin_a * (a.arm + a.reach) + spin_b * far;
        const Real wanted = length_ / (2 * a.reach);
        pieces_ = wanted < kPieces ? std::max(int(wanted) + 1, 1) : kPieces;
        const Real n = Real(pieces_);
        const Real bend = (spin_a + spin_b) * (spin_a + spin_b) * far + 2 * spin_b * straight;
        margin_ = a.reach + bend / (8 * n * n);
    }

    Real length_of_way() const { return length_; }
    int pieces() const { return pieces_; }
    Real begin(int piece) const { return Real(piece) / Real(pieces_); }

    Aabb box(int piece) const
    {
        const Real from = begin(piece), to = begin(piece + 1);
        const Vec3 first = place(from), last = place(to);
        Aabb box = {min(first, last), max(first, last)};
        for (const Real stop : {a_.motion.until, surface_.motion.until}) {
            if (!(stop > from && stop < to)) continue;
            box = {min(box.lo, place(stop)), max(box.hi, place(stop))};
        }
        return grown(box, margin_);
    }

  private:
    Vec3 place(Real t) const { return surface_.motion.at(t, surface_.shape.pose).to_local(a_.middle_at(t)); }

    const Traveller& a_;
    const Mover& surface_;
    Real length_, margin_;
    int pieces_;
};

// Depths of single triangles say nothing of the way out of a surface, and on any way there are others that have not been touched: what
// begins this deep and moves outwards where it is deepest is left to the contacts that push it. Of surfaces with a front, as a sheet has two.
bool is_leaving(const Traveller& a, const TriangleSet& set, const Mover& surface, Real allowed,
                Effort& effort)
{
    const Pose& pose = surface.shape.pose;
    const ConvexView view = a.at(0);
    const Vec3 middle = pose.to_local(a.middle_at(0));
    Separation deepest;
    set.query(grown(Aabb{middle, middle}, a.reach), effort, [&](const Triangle& t, int) {
        if (!effort.spend(Effort::kDistance)) return;
        const Separation s = distance_of(view, traveller(t, pose, {}).at(0), 0);
        if (s.distance < deepest.distance) deepest = s;
    });
    if (!(deepest.distance < -allowed)) return false;
    const Vec3 on_a = a.motion.at(1, view.pose).to_world(view.pose.to_local(deepest.on_a)),
               on_b = surface.motion.at(1, pose).to_world(pose.to_local(deepest.on_a));
    return dot(on_a - on_b, deepest.normal) >= 0;
}

// `one_sided`: a traveller that comes from behind a triangle passes.
Real meet_surface(const Traveller& a, const Mover& surface, bool one_sided, const ImpactRule& rule,
                  Real max_time, Effort& effort)
{
    const TriangleSet set = triangles_of(surface.shape);
    const SweptPath way(a, surface);
    Real best = kInf;
    if (!(a.reach > 0) || !(way.length_of_way() < kMaxMagnitude)) return best;
    // A traveller that crosses this much of an endless field is not stopped.
    if (set.endless() && way.length_of_way() > kEndless * a.reach) return best;
    const Pose& pose = surface.shape.pose;
    if (one_sided && rule.held && is_leaving(a, set, surface, rule.allowed, effort)) return best;
    for (int i = 0; i < way.pieces() && way.begin(i) < std::min(best, max_time); ++i) {
        if (!effort.spend(1)) break;
        set.query(way.box(i), effort, [&](const Triangle& t, int) {
            const Traveller other = traveller(t, pose, surface.motion);
            const Impact m = meet(a, other, rule, std::min(best, max_time), effort);
            if (!(m.time < best)) return;
            const Vec3 front = surface.motion.at(m.time, pose).R * t.n;
            if (!one_sided || dot(m.normal, front) > Real(-1e-3)) best = m.time;
        });
    }
    return best;
}

// True if contacts push the solid out of the surface to its front side only.
bool one_sided(const QueryShape& solid, const QueryShape& surface)
{
    if (kind_of(surface) == QueryKind::kField) return true;
    return is_solid(*solid.geom) && solid.geom->type->solid->round;
}

Real solid_meets(const Mover& a, const Mover& b, const ImpactRule& rule, Real max_time, Effort& effort)
{
    Capsule unused;
    const Traveller solid = traveller(solid_view(a.shape, {}, 0, unused), a.motion);
    switch (kind_of(b.shape)) {
        case QueryKind::kSolid:
            return meet(solid, traveller(solid_view(b.shape, {}, 0, unused), b.motion), rule, max_time,
                        effort)
                .time;
        case QueryKind::kPlane:
            return meet(solid, b.shape.as<Plane>(), rule, max_time, effort).time;
        case QueryKind::kMesh:
        case QueryKind::kField:
            return meet_surface(solid, b, one_sided(a.shape, b.shape), rule, max_time, effort);
        default:
            return kInf;
    }
}

// Against a plane, a mesh is the same as its vertices.
Vec3 cloud_support(const void* shape, Vec3 direction)
{
    const TriangleMesh& mesh = *static_cast<const TriangleMesh*>(shape);
    Vec3 best = mesh.vertex(0);
    for (int i = 1; i < mesh.vertex_count(); ++i)
        if (dot(direction, mesh.vertex(i)) > dot(direction, best)) best = mesh.vertex(i);
    return best;
}

Real mesh_meets_plane(const Mover& a, const Plane& plane, const ImpactRule& rule, Real max_time,
                      Effort& effort)
{
    const TrimeshData& data = *a.shape.as<Trimesh>().mesh();
    if (data.mesh.vertex_count() == 0) return kInf;
    ConvexView cloud;
    cloud.shape = &data.mesh;
    cloud.local_support = cloud_support;
    cloud.pose = a.shape.pose;
    const Aabb& box = data.tree.box();
    cloud.size = length(max(abs(box.lo), abs(box.hi)));
    return meet(traveller(cloud, a.motion), plane, rule, max_time, effort).time;
}

Real mesh_meets_surface(const Mover& a, const Mover& b, const ImpactRule& rule, Real max_time, Effort& effort)
{
    const TriangleSet set = triangles_of(a.shape);
    const bool field = kind_of(b.shape) == QueryKind::kField;
    Real best = kInf;
    look_at_each(set.count(), effort, [&](int t, Effort& share) {
        Triangle triangle;
        if (!set.triangle(t, triangle)) return;
        const Traveller flat = traveller(triangle, a.shape.pose, a.motion);
        best = std::min(best, meet_surface(flat, b, field, rule, std::min(best, max_time), share));
    });
    return best;
}

Real time_in_order(const Mover& a, const Mover& b, const ImpactRule& rule, Real max_time, Effort& effort)
{
    const QueryKind x = kind_of(a.shape), y = kind_of(b.shape);
    if (x == QueryKind::kSolid) return solid_meets(a, b, rule, max_time, effort);
    if (x != QueryKind::kMesh) return kInf;
    switch (y) {
        case QueryKind::kSolid:
            return solid_meets(b, a, rule, max_time, effort);
        case QueryKind::kPlane:
            return mesh_meets_plane(a, b.shape.as<Plane>(), rule, max_time, effort);
        case QueryKind::kMesh:
        case QueryKind::kField:
            return mesh_meets_surface(a, b, rule, max_time, effort);
        default:
            return kInf;
    }
}

}  // namespace

ImpactTime time_of_impact(const Mover& a, const Mover& b, const ImpactRule& rule, Real max_time)
{
    Effort effort(mesh_triangles(a.shape) + mesh_triangles(b.shape));
    const Real time = time_in_order(a, b, rule, max_time, effort);
    return {time, effort.is_cut_short()};
}

Real half_thickness(const QueryShape& shape)
{
    const auto half = shape.geom->type->half_thickness;
    return half ? half(*shape.geom) : kInf;
}

}  // namespace epode
