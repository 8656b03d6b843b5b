// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sizes by the getters of each class. Triangles of a mesh come in world coordinates and are brought back, x =
// R^T (p - c); equal corners become one vertex again.
#include "record/watch/shapes.h"

#include "record/watch/surfaces.h"

namespace epode::record {

namespace {

// Deprecated, and yet in programs that are recorded.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
dGeomID inner(dGeomID geom)
{
    if (dGeomGetClass(geom) != dGeomTransformClass) return geom;
    dGeomID held = dGeomTransformGetGeom(geom);
    return held ? held : geom;
}
#pragma GCC diagnostic pop

Pose pose_from(const dReal* pos, const dReal* turn)
{
    Pose pose;
    for (size_t i = 0; i < 3; ++i) pose.pos[i] = double(pos[i]);
    for (size_t i = 0; i < 4; ++i) pose.turn[i] = double(turn[i]);
    return pose;
}

Shape with_size(ShapeKind kind, double a, double b = 0, double c = 0, double d = 0)
{
    Shape shape;
    shape.kind = kind;
    shape.size = {a, b, c, d};
    return shape;
}

Shape box(dGeomID geom)
{
    dVector3 sides;
    dGeomBoxGetLengths(geom, sides);
    return with_size(ShapeKind::kBox, double(sides[0]), double(sides[1]), double(sides[2]));
}

Shape rod(dGeomID geom, ShapeKind kind, void (*get)(dGeomID, dReal*, dReal*))
{
    dReal radius = 0, length = 0;
    get(geom, &radius, &length);
    return with_size(kind, double(radius), double(length));
}

Shape plane(dGeomID geom)
{
    dVector4 p;
    dGeomPlaneGetParams(geom, p);
    return with_size(ShapeKind::kPlane, double(p[0]), double(p[1]), double(p[2]), double(p[3]));
}

}  // namespace

Shape shape_of(dGeomID given)
{
    dGeomID geom = inner(given);
    switch (dGeomGetClass(geom)) {
        case dSphereClass:
            return with_size(ShapeKind::kSphere, double(dGeomSphereGetRadius(geom)));
        case dBoxClass:
            return box(geom);
        case dCapsuleClass:
            return rod(geom, ShapeKind::kCapsule, dGeomCapsuleGetParams);
        case dCylinderClass:
            return rod(geom, ShapeKind::kCylinder, dGeomCylinderGetParams);
        case dPlaneClass:
            return plane(geom);
        case dRayClass:
            return with_size(ShapeKind::kRay, double(dGeomRayGetLength(geom)));
        case dConvexClass:
            return convex_surface(geom);
        case dTriMeshClass:
            return mesh_surface(geom);
        case dHeightfieldClass:
            return height_field_surface(geom);
        default:
            return solid_surface(geom);
    }
}

Pose pose_of(dGeomID geom)
{
    if (dGeomGetClass(geom) == dPlaneClass) return {};
    dQuaternion turn;
    if (dGeomID held = inner(geom); held != geom) {
        dGeomGetQuaternion(held, turn);
        return pose_from(dGeomGetPosition(held), turn);
    }
    if (!dGeomGetBody(geom)) {
        dGeomGetQuaternion(geom, turn);
        return pose_from(dGeomGetPosition(geom), turn);
    }
    if (!dGeomIsOffset(geom)) return {};
    dGeomGetOffsetQuaternion(geom, turn);
    return pose_from(dGeomGetOffsetPosition(geom), turn);
}

}  // namespace epode::record
