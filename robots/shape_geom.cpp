// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See shape_geom.h.
#include "robots/shape_geom.h"

#include <ode/ext.h>

namespace epode::robots {

namespace {

dGeomID make_hull(dSpaceID space, const Hull& hull)
{
    return dCreateConvex(space, hull.planes.data(), unsigned(hull.planes.size() / 4), hull.points.data(),
                         unsigned(hull.points.size() / 3), hull.polygons.data());
}

}  // namespace

int parts_of(const Prepared& prepared, const Shape& shape)
{
    if (shape.kind == ShapeKind::kHull) return int(prepared.hulls(shape.mesh).size());
    const bool is_unread = shape.kind == ShapeKind::kTriangles && !prepared.triangles(shape.mesh);
    return is_unread ? 0 : 1;
}

dGeomID make_geom(dSpaceID space, const Prepared& prepared, const Shape& shape, int part)
{
    const dReal x = dReal(shape.size.x), y = dReal(shape.size.y), z = dReal(shape.size.z);
    switch (shape.kind) {
        case ShapeKind::kSphere:
            return dCreateSphere(space, x);
        case ShapeKind::kBox:
            return dCreateBox(space, 2 * x, 2 * y, 2 * z);
        case ShapeKind::kCapsule:
            return dCreateCapsule(space, x, 2 * y);
        case ShapeKind::kCylinder:
            return dCreateCylinder(space, x, 2 * y);
        case ShapeKind::kEllipsoid:
            return dCreateEllipsoid(space, x, y, z);
        case ShapeKind::kPlane:
            return dCreatePlane(space, 0, 0, 1, 0);
        case ShapeKind::kHull:
            return make_hull(space, prepared.hulls(shape.mesh)[size_t(part)]);
        case ShapeKind::kHeights:
            return dCreateHeightfield(space, prepared.heights(shape.field), 1);
        case ShapeKind::kTriangles:
            return dCreateTriMesh(space, prepared.triangles(shape.mesh), nullptr, nullptr, nullptr);
    }
    return nullptr;
}

Pose geom_pose(const Shape& shape)
{
    constexpr double kHalf = 0.70710678118654752440;
    return shape.kind == ShapeKind::kHeights ? shape.pose * Pose{{}, {kHalf, kHalf, 0, 0}} : shape.pose;
}

void put_plane(dGeomID plane, const Pose& at)
{
    const Vec n = rotate(at.q, {0, 0, 1});
    dGeomPlaneSetParams(plane, dReal(n.x), dReal(n.y), dReal(n.z), dReal(dot(n, at.p)));
}

}  // namespace epode::robots
