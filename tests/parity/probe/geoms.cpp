// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See geoms.h. The transform holds a box at a random offset; dGeomTransform owns it through cleanup mode.
#include "geoms.h"

#include <algorithm>
#include <cmath>

namespace parity {
namespace {

void set_pose(dGeomID geom, const Vec3& p, Random& random)
{
    const Quat r = random.rotation(3.14);
    const dQuaternion q = {r.w, r.x, r.y, r.z};
    dMatrix3 R = {0};
    dRfromQ(R, q);
    dGeomSetPosition(geom, p.x, p.y, p.z);
    dGeomSetRotation(geom, R);
}

Placed make_box(dSpaceID space, Random& random)
{
    const double x = random.range(0.3, 2), y = random.range(0.3, 2), z = random.range(0.3, 2);
    return {dCreateBox(space, x, y, z), 0.5 * std::sqrt(x * x + y * y + z * z)};
}

Placed make_transform(dSpaceID space, Random& random)
{
    const Placed box = make_box(nullptr, random);
    const Vec3 offset = random.in_cube(0.4);
    set_pose(box.geom, offset, random);
    const dGeomID geom = dCreateGeomTransform(space);
    dGeomTransformSetCleanup(geom, 1);
    dGeomTransformSetGeom(geom, box.geom);
    return {geom, box.radius + 0.5};
}

}  // namespace

const char* kind_name(Kind kind)
{
    switch (kind) {
        case Kind::kSphere:
            return "sphere";
        case Kind::kBox:
            return "box";
        case Kind::kCapsule:
            return "capsule";
        case Kind::kCylinder:
            return "cylinder";
        case Kind::kPlane:
            return "plane";
        case Kind::kRay:
            return "ray";
        case Kind::kTransform:
            return "transform";
    }
    return "?";
}

Placed make_geom(Kind kind, dSpaceID space, Random& random)
{
    const double r = random.range(0.2, 1), l = random.range(0.2, 2);
    switch (kind) {
        case Kind::kSphere:
            return {dCreateSphere(space, r), r};
        case Kind::kBox:
            return make_box(space, random);
        case Kind::kCapsule:
            return {dCreateCapsule(space, r, l), r + 0.5 * l};
        case Kind::kCylinder:
            return {dCreateCylinder(space, r, l), std::sqrt(r * r + 0.25 * l * l)};
        case Kind::kPlane:
            return {dCreatePlane(space, 0, 0, 1, 0), 0.1};
        case Kind::kRay:
            return {dCreateRay(space, 1 + l), 0.6 * l};
        case Kind::kTransform:
            return make_transform(space, random);
    }
    return {nullptr, 0};
}

void place_geom(const Placed& placed, Kind kind, const Vec3& point, Random& random)
{
    if (kind == Kind::kPlane) {
        const Vec3 n = random.direction();
        dGeomPlaneSetParams(placed.geom, n.x, n.y, n.z, n.x * point.x + n.y * point.y + n.z * point.z);
        return;
    }
    if (kind == Kind::kRay) {
        const Vec3 d = random.direction();
        dGeomRaySet(placed.geom, point.x, point.y, point.z, d.x, d.y, d.z);
        return;
    }
    set_pose(placed.geom, point, random);
}

}  // namespace parity
