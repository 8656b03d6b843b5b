// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "characters/surroundings.h"

#include "base/float_environment.h"
#include "characters/segment_triangle.h"
#include "collide/collide.h"
#include "collide/solid_type.h"
#include "collide/transform.h"
#include "query/candidates.h"

namespace epode {
namespace {

constexpr int kAdvances = 50;
constexpr Real kLevel = kSingle ? Real(1e-5) : Real(1e-9);  // slope below which a path does not approach
constexpr Real kProbe = Real(0.5);  // of the skin: how far beyond an edge its faces are looked for

bool is_met(const Geom& self, const Geom& other)
{
    return &other != &self && !other.sensor && !is_space(other) && !is_ray(other);
}

Aabb in_frame_of(const Pose& pose, const Aabb& box)
{
    const Vec3 half = Real(0.5) * (box.hi - box.lo), centre = pose.to_local(box.lo + half);
    const Mat3 back = transpose(pose.R);
    const Vec3 reach = {dot(abs(back.row0), half), dot(abs(back.row1), half), dot(abs(back.row2), half)};
    return {centre - reach, centre + reach};
}

Triangle placed(const Triangle& t, const Pose& pose)
{
    Triangle out;
    for (int k = 0; k < 3; ++k) out.v[k] = pose.to_world(t.v[k]);
    out.n = pose.R * t.n;
    out.c = dot(out.n, out.v[0]);
    return out;
}

bool admitted(const dCharacterSettings& s, Geom& self, Geom& other, Vec3 velocity)
{
    if (!s.filter) return true;
    dVector3 v = {};
    store(v, velocity);
    const CallerFloatEnvironment program;
    return s.filter(s.data, to_handle(&self), to_handle(&other), v) != 0;
}

}  // namespace

bool Surroundings::collect(Space& space, const Aabb& region)
{
    const Aabb& box = box_of(self_);
    half_ = Real(0.5) * (box.hi - box.lo);
    view_ = solid_view(self_, pose_of(self_));
    reach_ = length(max(abs(region.lo), abs(region.hi)));
    const dCharacterSettings settings = self_.character->settings;
    const QueryFilter bits{self_.category, self_.collide};
    if (!collect_near(space, bits, region, near_)) return false;
    const GeomHold hold(self_, settings.filter != nullptr);
    const CandidateLock lock(settings.filter ? &space : nullptr, near_);
    for (Geom* geom : near_)
        if (is_met(self_, *geom) && admitted(settings, self_, *geom, velocity_) && !add(*geom, region))
            return false;
    return true;
}

bool Surroundings::add(Geom& geom, const Aabb& region)
{
    const QueryShape shape = query_shape_of(geom);
    switch (kind_of(shape)) {
        case QueryKind::kNone:
            return true;
        case QueryKind::kPlane:
            return obstacles_.push({&geom, -1, planes_.size(), Obstacle::kPlane, region}) &&
                   planes_.push(shape.as<Plane>());
        case QueryKind::kSolid:
            return add_solid(geom, solid_view(*shape.geom, shape.pose));
        default:
            return add_triangles(geom, shape, region);
    }
}

bool Surroundings::add_solid(Geom& geom, const ConvexView& view)
{
    reach_ = std::max(reach_, length(view.pose.p) + view.size + view.radius);
    return obstacles_.push({&geom, -1, solids_.size(), Obstacle::kSolid, box_of(geom)}) && solids_.push(view);
}

bool Surroundings::add_triangles(Geom& geom, const QueryShape& shape, const Aabb& region)
{
    const bool mesh = kind_of(shape) == QueryKind::kMesh;
    Effort effort(mesh_triangles(shape));
    bool complete = true;
    triangles_of(shape).query(in_frame_of(shape.pose, region), effort, [&](const Triangle& t, int side) {
        const Triangle world = placed(t, shape.pose);
        const Aabb box = box_around(world);
        if (!complete || !overlap(box, region)) return;
        complete = obstacles_.push({&geom, mesh ? side : -1, triangles_.size(), Obstacle::kTriangle, box}) &&
                   triangles_.push(world);
    });
    return complete;
}

ConvexView Surroundings::view_at(Vec3 centre) const
{
    ConvexView view = view_;
    view.pose.p = centre;
    return view;
}

Aabb Surroundings::box_at(Vec3 centre, Real grown_by) const
{
    const Vec3 reach = half_ + Vec3{grown_by, grown_by, grown_by};
    return {centre - reach, centre + reach};
}

// From the plane of a triangle, less the skin: no more than the distance from the triangle.
Real Surroundings::height_over(const Triangle& t, Vec3 centre) const
{
    const Real core = self_.type->solid->core_reach(self_, transposed_times(view_.pose.R, t.n));
    return std::fabs(t.height(centre)) - core - view_.radius - skin_;
}

// How far the shape moves at least until it may touch: by the boxes, and by the plane of a triangle.
Real Surroundings::least_way(int obstacle, Vec3 centre, Vec3 along, Real limit) const
{
    const Obstacle& o = obstacles_.data()[obstacle];
    const Aabb box = box_at(centre, skin_);
    Real least = 0;
    for (int i = 0; i < 3; ++i) {
        const Real before = std::max(o.box.lo[i] - box.hi[i], box.lo[i] - o.box.hi[i]);
        if (!(before > 0)) continue;
        const Real speed = o.box.lo[i] > box.hi[i] ? along[i] : -along[i];
        if (!(speed * limit >= before)) return kInf;
        least = std::max(least, before / speed);
    }
    if (o.kind != Obstacle::kTriangle) return least;
    const Triangle& t = triangles_.data()[o.index];
    const Real height = height_over(t, centre);
    if (!(height > 0)) return least;
    const Real speed = t.height(centre) > 0 ? -dot(along, t.n) : dot(along, t.n);
    if (!(speed * limit >= height)) return kInf;
    return std::max(least, height / speed);
}

// If the shape's farthest point towards the plane of a triangle is over the face, no other is nearer.
bool Surroundings::separation_over(const Triangle& t, Vec3 centre, Separation& out) const
{
    const Vec3 n = t.height(centre) < 0 ? -t.n : t.n;
    const Vec3 core = view_at(centre).support(-n);
    const Real height = dot(n, core - t.v[0]);
    if (!(height > view_.radius) || !is_over(t, core)) return false;
    out.normal = n;
    out.distance = height - view_.radius;
    out.on_a = core - view_.radius * n;
    out.on_b = core - height * n;
    return true;
}

// Of a capsule from a triangle. Nothing: the general search must do it.
bool Surroundings::separation_of_capsule(const Triangle& t, Vec3 centre, Separation& out) const
{
    if (view_.kind != SolidKind::kSegment) return false;
    const Vec3 arm = static_cast<const ShapeGeom<Capsule>&>(self_).shape.half_length * view_.pose.R.column(2);
    SegmentGap gap;
    if (!segment_gap(centre - arm, centre + arm, t, gap)) return false;
    const Real core = std::sqrt(gap.distance2);
    if (!(core > Real(0.01) * view_.radius)) return false;
    out.normal = (gap.on_segment - gap.on_triangle) / core;
    out.distance = core - view_.radius;
    out.on_a = gap.on_segment - view_.radius * out.normal;
    out.on_b = gap.on_triangle;
    return true;
}

Separation Surroundings::separation_of(int obstacle, const ConvexView& shape, Real limit) const
{
    const Obstacle& o = obstacles_.data()[obstacle];
    if (o.kind == Obstacle::kPlane) return separation(shape, planes_.data()[o.index]);
    if (o.kind == Obstacle::kSolid) return separation(shape, solids_.data()[o.index], limit);
    return separation(shape, view_of(triangles_.data()[o.index]), limit);
}

Touch Surroundings::touch(int obstacle, Vec3 centre, Real limit) const
{
    const Obstacle& o = obstacles_.data()[obstacle];
    const Real reach = limit + skin_;
    if (!overlap(box_at(centre, reach), o.box)) return {};
    Separation s;
    const bool flat = o.kind == Obstacle::kTriangle;
    const Triangle* const t = flat ? triangles_.data() + o.index : nullptr;
    const Real height = t ? height_over(*t, centre) : -kInf;
    if (height > limit) return {};
    if (!t || !(separation_of_capsule(*t, centre, s) || separation_over(*t, centre, s)))
        s = separation_of(obstacle, view_at(centre), reach);
    if (!(s.distance <= reach)) return {};
    // As near to the plane as to the triangle, to the tolerance, it touches the face and not an edge.
    if (kSingle && s.distance - skin_ - height <= tolerance())
        s.normal = t->height(centre) < 0 ? -t->n : t->n;
    return {obstacle, s.distance - skin_, s.normal, s.on_b};
}

Touch Surroundings::advance(int obstacle, Vec3 centre, Vec3 along, Real from, Real limit) const
{
    Real t = from;
    Touch now;
    for (int i = 0; i < kAdvances; ++i) {
        now = touch(obstacle, centre + t * along, limit - t + tolerance());
        if (now.obstacle < 0) return {};
        const Real closing = -dot(along, now.normal);
        if (closing <= kLevel) return {};
        if (now.distance <= tolerance()) break;
        t += (now.distance - Real(0.5) * tolerance()) / closing;
        if (t > limit) return {};
    }
    now.distance = t;
    return now;
}

Vec3 Surroundings::face_normal(const Touch& touch, Vec3 up) const
{
    const Obstacle& o = obstacles_.data()[touch.obstacle];
    if (o.kind == Obstacle::kTriangle) {
        const Vec3 n = triangles_.data()[o.index].n;
        return dot(n, touch.normal) < 0 ? -n : n;
    }
    Vec3 inward = touch.normal - dot(touch.normal, up) * up;
    if (o.kind == Obstacle::kPlane || !normalize(inward)) return touch.normal;
    const Sphere point{0};
    const ConvexView probe = view_of(point, {touch.pos + kProbe * skin_ * (up - inward), Mat3::identity()});
    return separation_of(touch.obstacle, probe, kInf).normal;
}

}  // namespace epode
