// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See shape_geoms.h.
#include "batch/shape_geoms.h"

#include <ode/ext.h>

namespace epode::batch {

using namespace robots;

namespace {

dGeomID hull_geom(const Hull& hull)
{
    return dCreateConvex(nullptr, hull.planes.data(), unsigned(hull.planes.size() / 4), hull.points.data(),
                         unsigned(hull.points.size() / 3), hull.polygons.data());
}

}  // namespace

dGeomID make_geom(const Prepared& prepared, const AskedShape& its)
{
    const Shape& shape = *its.shape;
    const dReal x = dReal(shape.size.x), y = dReal(shape.size.y), z = dReal(shape.size.z);
    switch (shape.kind) {
        case ShapeKind::kSphere:
            return dCreateSphere(nullptr, x);
        case ShapeKind::kBox:
            return dCreateBox(nullptr, 2 * x, 2 * y, 2 * z);
        case ShapeKind::kCapsule:
            return dCreateCapsule(nullptr, x, 2 * y);
        case ShapeKind::kCylinder:
            return dCreateCylinder(nullptr, x, 2 * y);
        case ShapeKind::kEllipsoid:
            return dCreateEllipsoid(nullptr, x, y, z);
        case ShapeKind::kPlane:
            return dCreatePlane(nullptr, 0, 0, 1, 0);
        case ShapeKind::kHull:
            return hull_geom(prepared.hulls(shape.mesh)[size_t(its.part)]);
        case ShapeKind::kHeights:
            return dCreateHeightfield(nullptr, prepared.heights(shape.field), 1);
        case ShapeKind::kTriangles:
            return dCreateTriMesh(nullptr, prepared.triangles(shape.mesh), nullptr, nullptr, nullptr);
    }
    return nullptr;
}

// ODE's height fields have y up, and z towards the shape's -y.
void put_geom(dGeomID geom, ShapeKind kind, const AskedPose& pose)
{
    const auto column = [&](int k) -> Vec { return {pose.turn[k], pose.turn[3 + k], pose.turn[6 + k]}; };
    const Vec x = column(0), y = column(1), z = column(2), at{pose.at[0], pose.at[1], pose.at[2]};
    if (kind == ShapeKind::kPlane)
        return dGeomPlaneSetParams(geom, dReal(z.x), dReal(z.y), dReal(z.z), dReal(dot(z, at)));
    const bool lies = kind == ShapeKind::kHeights;
    const Vec second = lies ? z : y, third = lies ? -y : z;
    const dMatrix3 turn = {dReal(x.x), dReal(second.x), dReal(third.x), 0,
                           dReal(x.y), dReal(second.y), dReal(third.y), 0,
                           dReal(x.z), dReal(second.z), dReal(third.z), 0};
    dGeomSetPosition(geom, dReal(at.x), dReal(at.y), dReal(at.z));
    dGeomSetRotation(geom, turn);
}

}  // namespace epode::batch
