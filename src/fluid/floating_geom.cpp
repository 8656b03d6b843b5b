// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "fluid/floating_geom.h"

#include "collide/solid_type.h"
#include "collide/surfaces/trimesh.h"
#include "geometry/immersion/polygons.h"
#include "ode/shapes.h"

namespace epode {
namespace {

const Polyhedron* polyhedron_of(const Geom& geom)
{
    if (geom.type->number != dConvexClass) return nullptr;
    return static_cast<const ShapeGeom<Convex>&>(geom).shape.solid;
}

const Box& box_of_geom(const Geom& geom) { return static_cast<const ShapeGeom<Box>&>(geom).shape; }

// Far below the surface of the half space.
WaterPlane above(Vec3 half_extent, Vec3 middle) { return {{0, 0, 1}, middle.z + 2 * half_extent.z}; }

}  // namespace

bool FloatingGeom::take(Geom& geom)
{
    if (!geom.enabled || geom.sensor || geom.dying) return false;
    pose_ = pose_of(geom);
    middle_ = {};
    if (geom.type->number == dBoxClass) {
        kind_ = Kind::kBox, half_ = box_of_geom(geom).half;
        return true;
    }
    if (const Polyhedron* solid = polyhedron_of(geom)) return take_polyhedron(*solid, pose_), true;
    if (geom.type->solid && geom.type->solid->round_solid) {
        kind_ = Kind::kRound, round_ = geom.type->solid->round_solid(geom);
        half_ = round_.half_extent(), middle_ = round_.middle();
        return true;
    }
    if (geom.type->number != dTriMeshClass) return false;
    const TrimeshData* const data = static_cast<const TrimeshGeom&>(geom).shape.mesh();
    if (!data || !data->closed) return false;
    kind_ = Kind::kMesh, mesh_ = &data->mesh;
    const Aabb& box = data->tree.box();
    half_ = Real(0.5) * (box.hi - box.lo), middle_ = box.lo + half_;
    return true;
}

void FloatingGeom::take_polyhedron(const Polyhedron& solid, const Pose& pose)
{
    kind_ = Kind::kPolyhedron, solid_ = &solid;
    pose_ = {pose.to_world(solid.centre()), pose.R};
    Vec3 low, high;
    for (int i = 0; i < 3; ++i) {
        Vec3 axis;
        Real from = 0, to = 0;
        axis.set(i, 1);
        solid.extent(axis, from, to);
        low.set(i, from), high.set(i, to);
    }
    half_ = Real(0.5) * (high - low), middle_ = low + half_;
}

template <typename Visit>
void FloatingGeom::for_each_face(Visit&& visit) const
{
    if (kind_ == Kind::kPolyhedron) {
        const auto corners = solid_->corners();
        const auto vertices = solid_->vertices();
        for (const PolyhedronFace& face : solid_->faces())
            visit(face.count,
                  [&](int i) { return vertices[std::size_t(corners[std::size_t(face.first + i)])]; });
        return;
    }
    for (int t = 0; t < mesh_->triangle_count(); ++t) visit(3, [&](int i) { return mesh_->corner(t, i); });
}

Immersed FloatingGeom::whole() const
{
    if (kind_ == Kind::kBox) return {8 * half_.x * half_.y * half_.z, {}};
    if (kind_ == Kind::kRound) return round_.whole();
    PolygonCut cut(above(half_, middle_));
    for_each_face([&](int count, const auto& corner) { cut.add_face(count, corner); });
    return cut.result();
}

Immersed FloatingGeom::under(const WaterPlane& half) const
{
    const Real height = half.height(middle_), reach = dot(abs(half.normal), half_);
    if (!(height < reach)) return {};
    if (height <= -reach) return whole();
    if (kind_ == Kind::kBox) return immersed_box(half_, half);
    if (kind_ == Kind::kRound) return round_.under(half);
    PolygonCut cut(half);
    for_each_face([&](int count, const auto& corner) { cut.add_face(count, corner); });
    return cut.result();
}

Real FloatingGeom::shadow(Vec3 u) const
{
    if (kind_ == Kind::kRound) return round_.shadow(u);
    if (kind_ == Kind::kBox)
        return 4 * dot(abs(u), {half_.y * half_.z, half_.z * half_.x, half_.x * half_.y});
    Real sum = 0;  // both sides of four times as much
    for_each_face([&](int count, const auto& corner) {
        const Vec3 first = corner(0);
        Vec3 area;
        for (int i = 2; i < count; ++i) area += cross(corner(i - 1) - first, corner(i) - first);
        sum += std::fabs(dot(area, u));
    });
    return sum / 4;
}

bool bounds_fluids(const Geom& geom)
{
    switch (geom.type->number) {
        case dBoxClass:
        case dSphereClass:
        case dCapsuleClass:
        case dCylinderClass:
        case dEllipsoidClass:
            return true;
        default:
            return polyhedron_of(geom) != nullptr;
    }
}

bool contains(Geom& geom, Vec3 place)
{
    const Vec3 x = pose_of(geom).to_local(place);
    switch (geom.type->number) {
        case dBoxClass: {
            const Vec3 out = abs(x) - box_of_geom(geom).half;
            return out.x <= 0 && out.y <= 0 && out.z <= 0;
        }
        case dCapsuleClass: {
            const Capsule& c = static_cast<const ShapeGeom<Capsule>&>(geom).shape;
            const Real up = std::fabs(x.z) > c.half_length ? std::fabs(x.z) - c.half_length : Real(0);
            return x.x * x.x + x.y * x.y + up * up <= c.radius * c.radius;
        }
        case dCylinderClass: {
            const Cylinder& c = static_cast<const ShapeGeom<Cylinder>&>(geom).shape;
            return x.x * x.x + x.y * x.y <= c.radius * c.radius && std::fabs(x.z) <= c.half_length;
        }
        case dSphereClass:
        case dEllipsoidClass: {
            const Vec3 r = geom.type->solid->round_solid(geom).half_extent();
            return length2({x.x / r.x, x.y / r.y, x.z / r.z}) <= 1;
        }
        default:
            break;
    }
    const Polyhedron* const solid = polyhedron_of(geom);
    if (!solid) return false;
    for (const PolyhedronFace& face : solid->faces())
        if (dot(face.normal, x - solid->centre()) > face.offset) return false;
    return true;
}

}  // namespace epode
