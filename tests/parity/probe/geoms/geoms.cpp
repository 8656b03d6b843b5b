// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See geoms.h. The transform holds a box at a random offset; dGeomTransform owns it through cleanup mode. The
// plane of a face has its normal along (b - a) x (c - a) of its first corners.
#include "geoms.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

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

// Corner i has the sign of bit k of i along axis k; each face counter-clockwise from outside.
const unsigned kPolygons[] = {4, 1, 3, 7, 5, 4, 0, 4, 6, 2, 4, 2, 6, 7, 3,
                              4, 0, 1, 5, 4, 4, 4, 5, 7, 6, 4, 0, 2, 3, 1};

std::map<dGeomID, const ConvexArrays*>& convex_list()
{
    static std::map<dGeomID, const ConvexArrays*> list;
    return list;
}

void put_plane(const std::array<dReal, 24>& points, int face, std::array<dReal, 24>& planes)
{
    const auto corner = [&](int k) {
        const dReal* p = &points[3 * kPolygons[5 * face + 1 + k]];
        return Vec3{p[0], p[1], p[2]};
    };
    const Vec3 a = corner(0), b = corner(1), c = corner(2);
    const Vec3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
    const double x = u.y * v.z - u.z * v.y, y = u.z * v.x - u.x * v.z, z = u.x * v.y - u.y * v.x;
    const double size = std::sqrt(x * x + y * y + z * z);
    dReal* n = &planes[4 * static_cast<std::size_t>(face)];
    n[0] = x / size, n[1] = y / size, n[2] = z / size;
    n[3] = n[0] * a.x + n[1] * a.y + n[2] * a.z;
}

Placed make_convex(dSpaceID space, Random& random)
{
    static std::deque<ConvexArrays> kept;
    ConvexArrays& arrays = kept.emplace_back();
    const double half[3] = {random.range(0.15, 1), random.range(0.15, 1), random.range(0.15, 1)};
    const double top = std::min(1.0, random.range(0.3, 1.7));
    for (unsigned i = 0; i < 8; ++i) {
        for (unsigned k = 0; k < 3; ++k) {
            const double size = (i & 4) != 0 && k < 2 ? top * half[k] : half[k];
            arrays.points[3 * i + k] = (i >> k & 1) != 0 ? size : -size;
        }
    }
    for (int face = 0; face < 6; ++face) { put_plane(arrays.points, face, arrays.planes); }
    const dGeomID geom = dCreateConvex(space, arrays.planes.data(), 6, arrays.points.data(), 8, kPolygons);
    convex_list()[geom] = &arrays;
    return {geom, std::sqrt(half[0] * half[0] + half[1] * half[1] + half[2] * half[2])};
}

}  // namespace

const ConvexArrays& convex_arrays(dGeomID geom) { return *convex_list().at(geom); }
const unsigned* convex_polygons() { return kPolygons; }

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
        case Kind::kConvex:
            return "convex";
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
        case Kind::kConvex:
            return make_convex(space, random);
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

namespace {

bool passes_by(dGeomID ray, dGeomID other)
{
    if (dGeomGetClass(ray) != dRayClass) { return false; }
    dVector3 start, direction;
    dGeomRayGet(ray, start, direction);
    dReal box[6];
    dGeomGetAABB(other, box);
    double near = 0, far = dGeomRayGetLength(ray);
    for (int i = 0; i < 3; ++i) {
        const double a = (box[2 * i] - start[i]) / direction[i],
                     b = (box[2 * i + 1] - start[i]) / direction[i];
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    return near > far;
}

}  // namespace

bool a_ray_passes_by(dGeomID a, dGeomID b) { return passes_by(a, b) || passes_by(b, a); }

}  // namespace parity
