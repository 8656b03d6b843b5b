// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Plane: the half-space normal . x <= d, in the world; it has no pose. Its bounding box is endless, except
// that a plane across a world axis bounds one side.
#include "collide/types/registry.h"

#include "base/float_environment.h"

namespace epode {
namespace {

Aabb aabb(Geom& geom)
{
    const Plane& s = static_cast<const ShapeGeom<Plane>&>(geom).shape;
    Aabb box{{-kInf, -kInf, -kInf}, {kInf, kInf, kInf}};
    for (int i = 0; i < 3; ++i) {
        if (s.normal[(i + 1) % 3] != 0 || s.normal[(i + 2) % 3] != 0) continue;
        if (s.normal[i] > 0) box.hi.set(i, s.d);
        if (s.normal[i] < 0) box.lo.set(i, -s.d);
    }
    return box;
}

// All four numbers over the normal's length; a zero normal becomes (1, 0, 0, 0).
Plane normalized(Real a, Real b, Real c, Real d)
{
    const Vec3 given{a, b, c};
    Vec3 n = given;
    if (!normalize(n)) return {{1, 0, 0}, 0};
    return {n, d / dot(given, n)};
}

// The distance may be no number any more where the normal is next to nothing.
bool legal(Real a, Real b, Real c, Real d)
{
    return usable(a) && usable(b) && usable(c) && usable(d) && usable(normalized(a, b, c, d).d);
}

void structure(Geom& geom, ShapeStream& stream)
{
    Plane& plane = static_cast<ShapeGeom<Plane>&>(geom).shape;
    stream.vector(plane.normal), stream.real(plane.d);
    stream.demand(stream.saves() || (usable(plane.d) && std::fabs(length2(plane.normal) - 1) < Real(1e-3)),
                  "a plane in it has no unit normal");
}

}  // namespace

const GeomType kPlaneType = {.number = dPlaneClass,
                             .placeable = false,
                             .aabb = aabb,
                             .destroy = destroy_pooled<ShapeGeom<Plane>>,
                             .create = create_pooled<ShapeGeom<Plane>>,
                             .structure = structure};

}  // namespace epode

using namespace epode;

extern "C" dGeomID dCreatePlane(dSpaceID space, dReal a, dReal b, dReal c, dReal d)
{
    EPODE_USER(legal(a, b, c, d), nullptr);
    EPODE_PARENT_SPACE(space, nullptr);
    return create_shape(space, normalized(a, b, c, d));
}

extern "C" void dGeomPlaneSetParams(dGeomID plane, dReal a, dReal b, dReal c, dReal d)
{
    EPODE_GEOM_AS(Plane, geom, plane);
    EPODE_USER(legal(a, b, c, d));
    EPODE_UNLOCKED(geom);
    geom->shape = normalized(a, b, c, d);
    mark_changed(*geom);
}

extern "C" void dGeomPlaneGetParams(dGeomID plane, dVector4 result)
{
    EPODE_GEOM_AS(Plane, geom, plane);
    EPODE_USER(result);
    store(result, geom->shape.normal);
    result[3] = geom->shape.d;
}

extern "C" dReal dGeomPlanePointDepth(dGeomID plane, dReal x, dReal y, dReal z)
{
    const FloatEnvironment floats;
    EPODE_GEOM_AS(Plane, geom, plane, 0);
    EPODE_USER(usable(x) && usable(y) && usable(z), 0);
    return geom->shape.d - dot(geom->shape.normal, {x, y, z});
}
