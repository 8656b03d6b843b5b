// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Convex polyhedron. The client's arrays are read once, checked and copied (geometry/polyhedron.h); ODE keeps
// pointers to them, and so a program that frees them early is safe here. The planes that come along must be
// numbers and are then passed over, since the points give them again, and to more digits.
#include "collide/registry.h"

namespace epode {
namespace {

Aabb aabb(Geom& geom)
{
    const ConvexGeom& g = static_cast<const ConvexGeom&>(geom);
    const Mat3 r = load_mat(geom.rotation);
    const Vec3 middle = load(geom.position) + r * g.own.centre();
    Aabb box;
    for (int i = 0; i < 3; ++i) {
        box.lo.set(i, middle[i] + dot(r.row(i), g.own.support(-r.row(i))));
        box.hi.set(i, middle[i] + dot(r.row(i), g.own.support(r.row(i))));
    }
    return box;
}

constexpr unsigned kMostFaces = 1u << 24;

// The reason of a refusal, or null.
const char* build(Polyhedron& solid, const dReal* planes, unsigned plane_count, const dReal* points,
                  unsigned point_count, const unsigned* polygons)
{
    if (!planes || !points || !polygons || plane_count > kMostFaces) return "Bad argument(s)";
    if (!usable(planes, int(4 * plane_count))) return "plane is not a usable number";
    return solid.build(points, point_count, polygons, plane_count);
}

}  // namespace

const GeomType kConvexType = {.number = dConvexClass, .aabb = aabb, .destroy = destroy_pooled<ConvexGeom>};

}  // namespace epode

using namespace epode;

extern "C" dGeomID dCreateConvex(dSpaceID space, const dReal* planes, unsigned int planecount,
                                 const dReal* points, unsigned int pointcount, const unsigned int* polygons)
{
    EPODE_PARENT_SPACE(space, nullptr);
    Polyhedron solid;
    const char* const refusal = build(solid, planes, planecount, points, pointcount, polygons);
    EPODE_USER_SAY(!refusal, refusal, nullptr);
    ConvexGeom* geom = create_geom<Convex>(space);
    if (geom) geom->own.swap(solid);
    return to_handle<Geom>(geom);
}

extern "C" void dGeomSetConvex(dGeomID g, const dReal* planes, unsigned int count, const dReal* points,
                               unsigned int pointcount, const unsigned int* polygons)
{
    EPODE_GEOM_AS(Convex, geom, g);
    EPODE_UNLOCKED(geom);
    Polyhedron solid;
    const char* const refusal = build(solid, planes, count, points, pointcount, polygons);
    EPODE_USER_SAY(!refusal, refusal);
    geom->own.swap(solid);
    mark_moved(*geom);
}
