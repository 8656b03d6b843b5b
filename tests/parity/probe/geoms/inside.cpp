// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See inside.h. Depth of a point in a shape, in the shape's frame (positive inside): sphere r - |p|; box the
// least of s/2 - |p_i|; capsule r - distance to the segment; cylinder min(r - rho, l/2 - |z|); convex the
// least of d - n . p over its planes.
#include "inside.h"

#include <algorithm>
#include <cmath>

namespace parity {
namespace {

Vec3 to_frame(const dReal* position, const dReal* rotation, const Vec3& p)
{
    const double d[3] = {p.x - position[0], p.y - position[1], p.z - position[2]};
    double local[3];
    for (int i = 0; i < 3; ++i) {
        local[i] = rotation[i] * d[0] + rotation[4 + i] * d[1] + rotation[8 + i] * d[2];
    }
    return {local[0], local[1], local[2]};
}

double box_depth(dGeomID geom, const Vec3& p)
{
    dVector3 side;
    dGeomBoxGetLengths(geom, side);
    return std::min(
        {0.5 * side[0] - std::fabs(p.x), 0.5 * side[1] - std::fabs(p.y), 0.5 * side[2] - std::fabs(p.z)});
}

double capsule_depth(dGeomID geom, const Vec3& p)
{
    dReal r = 0, l = 0;
    dGeomCapsuleGetParams(geom, &r, &l);
    const double z = p.z - std::clamp<double>(p.z, -0.5 * l, 0.5 * l);
    return r - std::sqrt(p.x * p.x + p.y * p.y + z * z);
}

double cylinder_depth(dGeomID geom, const Vec3& p)
{
    dReal r = 0, l = 0;
    dGeomCylinderGetParams(geom, &r, &l);
    return std::min<double>(r - std::sqrt(p.x * p.x + p.y * p.y), 0.5 * l - std::fabs(p.z));
}

double plane_depth(dGeomID geom, const Vec3& p)
{
    dVector4 n;
    dGeomPlaneGetParams(geom, n);
    return n[3] - (n[0] * p.x + n[1] * p.y + n[2] * p.z);
}

double convex_depth(dGeomID geom, const Vec3& p)
{
    double least = 1e9;
    const auto& n = convex_arrays(geom).planes;
    for (std::size_t i = 0; i < n.size(); i += 4) {
        least = std::min<double>(least, n[i + 3] - (n[i] * p.x + n[i + 1] * p.y + n[i + 2] * p.z));
    }
    return least;
}

double depth_in(dGeomID geom, const Vec3& point)
{
    const int shape = dGeomGetClass(geom);
    if (shape == dPlaneClass) { return plane_depth(geom, point); }
    const Vec3 p = to_frame(dGeomGetPosition(geom), dGeomGetRotation(geom), point);
    switch (shape) {
        case dSphereClass:
            return dGeomSphereGetRadius(geom) - std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
        case dBoxClass:
            return box_depth(geom, p);
        case dCapsuleClass:
            return capsule_depth(geom, p);
        case dCylinderClass:
            return cylinder_depth(geom, p);
        case dConvexClass:
            return convex_depth(geom, p);
        case dGeomTransformClass:
            return depth_in(dGeomTransformGetGeom(geom), p);
        default:
            return -1;
    }
}

}  // namespace

bool share_a_point(const Placed& a, const Placed& b, double margin, Random& random)
{
    const Placed& centre = dGeomGetClass(a.geom) == dPlaneClass ? b : a;
    if (dGeomGetClass(centre.geom) == dPlaneClass) { return false; }
    const dReal* c = dGeomGetPosition(centre.geom);
    for (int i = 0; i < 500; ++i) {
        const Vec3 d = random.in_cube(centre.radius);
        const Vec3 p{c[0] + d.x, c[1] + d.y, c[2] + d.z};
        if (depth_in(a.geom, p) > margin && depth_in(b.geom, p) > margin) { return true; }
    }
    return false;
}

}  // namespace parity
