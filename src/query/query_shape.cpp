// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See query_shape.h.
#include "query/query_shape.h"

#include "collide/collide.h"
#include "collide/pairs/pairs.h"
#include "collide/solid_type.h"
#include "collide/surfaces/closed_mesh.h"

namespace epode {
namespace {

// The ray as a segment, cut to the length that reaches the ball around the other geom.
ConvexView segment_view(const Ray& ray, const Pose& pose, Vec3 centre, Real reach, Capsule& segment)
{
    Pose middle;
    Vec3 along = pose.R.column(2), p, q;
    const Real max_length = length(centre - pose.p) + reach;
    const Real long_enough = std::clamp(ray.length, Real(0), max_length > 0 ? max_length : Real(0));
    plane_space(along, p, q);
    middle.R = transpose(Mat3{p, q, along});
    middle.p = pose.p + Real(0.5) * long_enough * along;
    segment = {0, Real(0.5) * long_enough};
    return view_of(segment, middle);
}

}  // namespace

QueryShape query_shape_of(Geom& geom)
{
    QueryShape t = {&geom, pose_of(geom), &geom};
    while (t.geom) {
        const TransformGeom* transform = as_transform(*t.geom);
        if (!transform) break;
        const bool pinned = t.named != t.geom || transform->info != 0;
        t.geom = transform->inner;
        if (!t.geom) break;
        t.pose = t.pose * pose_of(*t.geom);
        if (!pinned) t.named = t.geom;
    }
    return t;
}

QueryKind kind_of(const QueryShape& t)
{
    if (!t.geom) return QueryKind::kNone;
    if (is_solid(*t.geom)) return QueryKind::kSolid;
    if (t.number() == dRayClass) return QueryKind::kSolid;
    if (t.number() == dPlaneClass) return QueryKind::kPlane;
    if (t.number() == dTriMeshClass && t.as<Trimesh>().mesh()) return QueryKind::kMesh;
    if (t.number() == dHeightfieldClass && t.as<Heightfield>().field()) return QueryKind::kField;
    return QueryKind::kNone;
}

ConvexView solid_view(const QueryShape& t, Vec3 centre, Real reach, Capsule& memory)
{
    return is_solid(*t.geom) ? solid_view(*t.geom, t.pose)
                             : segment_view(t.as<Ray>(), t.pose, centre, reach, memory);
}

BoundingBall ball_about(const QueryShape& t, Real max_length)
{
    if (t.number() == dRayClass) return {t.pose.p, std::clamp(t.as<Ray>().length, Real(0), max_length)};
    Capsule unused;
    const ConvexView v = solid_view(t, {}, 0, unused);
    return {v.pose.p, v.size + v.radius};
}

BoundingBall ball_about(const TriangleSet& s, const Pose& pose)
{
    const Vec3 half = Real(0.5) * (s.period().hi - s.period().lo);
    return {pose.to_world(s.period().lo + half), (s.endless() ? kEndless : Real(1)) * length(half)};
}

TriangleSet triangles_of(const QueryShape& t)
{
    return t.number() == dTriMeshClass ? TriangleSet(*t.as<Trimesh>().mesh())
                                       : TriangleSet(*t.as<Heightfield>().field());
}

int mesh_triangles(const QueryShape& t)
{
    return kind_of(t) == QueryKind::kMesh ? t.as<Trimesh>().mesh()->mesh.triangle_count() : 0;
}

ConvexView in_frame(const Pose& frame, const ConvexView& v)
{
    ConvexView out = v;
    out.pose = inverse_times(frame, v.pose);
    return out;
}

void to_world(const Pose& frame, Separation& s)
{
    s.on_a = frame.to_world(s.on_a);
    s.on_b = frame.to_world(s.on_b);
    s.normal = frame.R * s.normal;
}

bool in_mesh(const QueryShape& a, const QueryShape& b, Separation& out)
{
    const Trimesh& mesh = b.as<Trimesh>();
    if (a.number() == dRayClass || !mesh.is_solid()) return false;
    Capsule unused;
    const ConvexView view = in_frame(b.pose, solid_view(a, {}, 0, unused));
    WayOut way;
    if (!way_out_of(mesh.mesh()->mesh, mesh.mesh()->tree, view.pose.p, way)) return false;
    out = separation(view, Plane{way.normal, dot(way.normal, way.nearest)});
    out.side_b = way.triangle;
    to_world(b.pose, out);
    return true;
}

bool in_terrain(const QueryShape& a, const QueryShape& field, Separation& out)
{
    constexpr int kCapacity = 32;
    dContactGeom contacts[kCapacity];
    ContactSink sink(contacts, sizeof(dContactGeom), kCapacity, false);
    sink.name(to_handle(a.geom), to_handle(field.geom));
    const PairFunction pair = built_in_pair(a.number(), dHeightfieldClass);
    if (pair && a.number() != dRayClass) pair(*a.geom, a.pose, *field.geom, field.pose, sink);
    if (sink.count() == 0) return false;
    int deepest = 0;
    for (int k = 1; k < sink.count(); ++k)
        if (contacts[k].depth > contacts[deepest].depth) deepest = k;
    const dContactGeom& c = contacts[deepest];
    out.distance = -c.depth;
    out.normal = load(c.normal);
    out.on_a = load(c.pos);
    out.on_b = out.on_a + c.depth * out.normal;
    out.side_a = c.side1, out.side_b = c.side2;
    return true;
}

}  // namespace epode
