// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Convex polyhedron: the hull of the client's points (geometry/hulls/polyhedron.h), copied. ODE keeps pointers;
// here a program may free the points early. ODE, too, collides all points whatever the polygons contain:
// polygons and planes must be valid by themselves and are then ignored.
#include "base/float_environment.h"
#include "collide/describe.h"
#include "collide/solid_type.h"
#include "collide/types/registry.h"
#include "geometry/inertia.h"
#include "ode/ext.h"
#include "ode/mass.h"

namespace epode {
namespace {

Aabb aabb(Geom& geom)
{
    const ConvexGeom& g = static_cast<const ConvexGeom&>(geom);
    const Mat3 r = load_mat(geom.rotation);
    const Polyhedron& solid = *g.shape.solid;
    const Vec3 middle = load(geom.position) + r * solid.centre();
    Aabb box;
    for (int i = 0; i < 3; ++i) {
        Real low, high;
        solid.extent(r.row(i), low, high);
        box.lo.set(i, middle[i] + low), box.hi.set(i, middle[i] + high);
    }
    return box;
}

constexpr unsigned kMostFaces = 1u << 24;
constexpr int kNoLimit = 1 << 24;  // of points

// The reason to refuse the client's faces, or null.
const char* fault_of(const dReal* planes, unsigned plane_count, unsigned point_count,
                     const unsigned* polygons)
{
    if (plane_count < 1 || plane_count > kMostFaces) return "too few or too many planes";
    if (point_count > unsigned(kNoLimit)) return "too many points";  // nor as many corners are then read
    if (!usable(planes, int(4 * plane_count))) return "plane is not a usable number";
    for (unsigned i = 0; i < plane_count; ++i) {
        const unsigned corners = *polygons++;
        if (corners < 3 || corners > point_count) return "polygon with a wrong number of corners";
        for (unsigned k = 0; k < corners; ++k)
            if (*polygons++ >= point_count) return "polygon with a corner that is no point";
    }
    return nullptr;
}

// These answer the reason of a refusal, or null.
const char* build(SharedSolid& solid, const dReal* points, unsigned point_count, int max_faces, bool plates)
{
    Polyhedron made;
    const char* const refusal = made.build(points, point_count, max_faces, plates);
    return refusal || solid.take(made) ? refusal : "out of memory";
}

const char* build(SharedSolid& solid, const dReal* planes, unsigned plane_count, const dReal* points,
                  unsigned point_count, const unsigned* polygons)
{
    if (!planes || !points || !polygons) return "Bad argument(s)";
    const char* const fault = fault_of(planes, plane_count, point_count, polygons);
    return fault ? fault : build(solid, points, point_count, kNoLimit, true);
}

const char* build_hull(SharedSolid& solid, const dReal* points, unsigned point_count, unsigned max_faces)
{
    if (!points || (max_faces > 0 && max_faces < 4)) return "Bad argument(s)";
    return build(solid, points, point_count,
                 max_faces > 0 && max_faces < unsigned(kNoLimit) ? int(max_faces) : kNoLimit, false);
}

const Polyhedron& solid_of(const Geom& geom) { return *static_cast<const ConvexGeom&>(geom).shape.solid; }

CoreSize core_size(const Geom& geom)
{
    const Polyhedron& solid = solid_of(geom);
    return {length(solid.centre()) + solid.size(), 0};
}
Real core_reach(const Geom& geom, Vec3 d)
{
    const Polyhedron& solid = solid_of(geom);
    return dot(d, solid.centre()) + solid.reach(d);
}
Real half_thickness(const Geom& geom)
{
    return thickness_at_least(solid_of(geom).inner_radius(), solid_of(geom).size());
}

// As the original, without its points.
void describe_convex(const Geom&, DifWriter& out) { out.text("type", "convex"); }

void fingerprint(const Geom& geom, ContentHash& hash)
{
    const Polyhedron& solid = *static_cast<const ConvexGeom&>(geom).shape.solid;
    const Vec3 c = solid.centre();
    hash.add({c.x, c.y, c.z});
    for (const Vec3 v : solid.vertices()) hash.add({v.x, v.y, v.z});
}

const Polyhedron* visit_solid(ConvexGeom& geom, StructureStream& stream)
{
    if (stream.saves()) {
        Polyhedron& solid = const_cast<Polyhedron&>(*geom.shape.solid);
        solid.structure(stream);  // writes nothing to it
        return &solid;
    }
    Polyhedron loaded;
    SharedSolid solid;
    loaded.structure(stream);
    if (stream.failed() || !stream.demand(solid.take(loaded), kOutOfMemory)) return nullptr;
    geom.take(solid);
    return geom.shape.solid;
}

void structure(Geom& geom, ShapeStream& stream)
{
    ConvexGeom& convex = static_cast<ConvexGeom&>(geom);
    const Polyhedron* const solid = stream.shared<const Polyhedron>(
        convex.shape.solid, nullptr,
        [&](const Polyhedron*, StructureStream& s) { return visit_solid(convex, s); });
    if (stream.saves() || !stream.demand(solid, "a convex geom in it has no points")) return;
    if (convex.shape.solid == solid) return;
    SharedSolid same = SharedSolid::of(*solid);
    convex.take(same);
}

constexpr SolidType kSolid = {
    .view = view_of_shape<Convex>, .core_reach = core_reach, .core_size = core_size, .round = false};

}  // namespace

const GeomType kConvexType = {.number = dConvexClass,
                              .aabb = aabb,
                              .destroy = destroy_pooled<ConvexGeom>,
                              .describe = describe_convex,
                              .fingerprint = fingerprint,
                              .solid = &kSolid,
                              .half_thickness = half_thickness,
                              .create = create_pooled<ConvexGeom>,
                              .structure = structure};

}  // namespace epode

using namespace epode;

extern "C" dGeomID dCreateConvex(dSpaceID space, const dReal* planes, unsigned int planecount,
                                 const dReal* points, unsigned int pointcount, const unsigned int* polygons)
{
    const FloatEnvironment floats;
    EPODE_PARENT_SPACE(space, nullptr);
    SharedSolid solid;
    const char* const refusal = build(solid, planes, planecount, points, pointcount, polygons);
    EPODE_USER_SAY(!refusal, refusal, nullptr);
    ConvexGeom* geom = create_geom<Convex>(space);
    if (geom) geom->take(solid);
    return to_handle<Geom>(geom);
}

extern "C" void dGeomSetConvex(dGeomID g, const dReal* planes, unsigned int count, const dReal* points,
                               unsigned int pointcount, const unsigned int* polygons)
{
    const FloatEnvironment floats;
    EPODE_GEOM_AS(Convex, geom, g);
    EPODE_UNLOCKED(geom);
    SharedSolid solid;
    const char* const refusal = build(solid, planes, count, points, pointcount, polygons);
    EPODE_USER_SAY(!refusal, refusal);
    geom->take(solid);
    mark_changed(*geom);
}

extern "C" dGeomID dCreateConvexHull(dSpaceID space, const dReal* points, unsigned int pointcount,
                                     unsigned int maxvertices)
{
    const FloatEnvironment floats;
    EPODE_PARENT_SPACE(space, nullptr);
    SharedSolid solid;
    const char* const refusal = build_hull(solid, points, pointcount, maxvertices);
    EPODE_USER_SAY(!refusal, refusal, nullptr);
    ConvexGeom* geom = create_geom<Convex>(space);
    if (geom) geom->take(solid);
    return to_handle<Geom>(geom);
}

extern "C" void dGeomSetConvexHull(dGeomID convex, const dReal* points, unsigned int pointcount,
                                   unsigned int maxvertices)
{
    const FloatEnvironment floats;
    EPODE_GEOM_AS(Convex, geom, convex);
    EPODE_UNLOCKED(geom);
    SharedSolid solid;
    const char* const refusal = build_hull(solid, points, pointcount, maxvertices);
    EPODE_USER_SAY(!refusal, refusal);
    geom->take(solid);
    mark_changed(*geom);
}

extern "C" int dGeomConvexGetPoints(dGeomID convex, dReal* points, int capacity)
{
    const FloatEnvironment floats;
    EPODE_GEOM_AS(Convex, geom, convex, 0);
    EPODE_USER(capacity >= 0 && (points || capacity == 0), 0);
    const std::span<const Vec3> all = geom->shape.solid->vertices();
    for (int i = 0; i < capacity && i < int(all.size()); ++i) {
        const Vec3 p = all[std::size_t(i)] + geom->shape.solid->centre();
        for (int k = 0; k < 3; ++k) points[3 * i + k] = p[k];
    }
    return int(all.size());
}

extern "C" int dGeomConvexGetPlanes(dGeomID convex, dReal* planes, int capacity)
{
    const FloatEnvironment floats;
    EPODE_GEOM_AS(Convex, geom, convex, 0);
    EPODE_USER(capacity >= 0 && (planes || capacity == 0), 0);
    const std::span<const PolyhedronFace> all = geom->shape.solid->faces();
    for (int i = 0; i < capacity && i < int(all.size()); ++i) {
        const PolyhedronFace& f = all[std::size_t(i)];
        for (int k = 0; k < 3; ++k) planes[4 * i + k] = f.normal[k];
        planes[4 * i + 3] = f.offset + dot(f.normal, geom->shape.solid->centre());
    }
    return int(all.size());
}

extern "C" int dGeomConvexGetPolygons(dGeomID convex, unsigned int* polygons, int capacity)
{
    EPODE_GEOM_AS(Convex, geom, convex, 0);
    EPODE_USER(capacity >= 0 && (polygons || capacity == 0), 0);
    int count = 0;
    const auto put = [&](int number) {
        if (count < capacity) polygons[count] = unsigned(number);
        ++count;
    };
    for (const PolyhedronFace& f : geom->shape.solid->faces()) {
        put(f.count);
        for (int k = 0; k < f.count; ++k) put(geom->shape.solid->corners()[std::size_t(f.first + k)]);
    }
    return count;
}

extern "C" void dMassSetConvex(dMass* m, dReal density, dGeomID convex)
{
    const FloatEnvironment floats;
    EPODE_GEOM_AS(Convex, geom, convex);
    EPODE_USER(m && usable(density));
    const MassProperties unit = geom->shape.solid->mass();
    EPODE_USER_SAY(unit.mass > 0, "convex has no volume");
    const MassProperties p = with_mass(unit, density * unit.mass);
    EPODE_USER(usable(p));
    put_mass(m, p);
}

extern "C" void dMassSetConvexTotal(dMass* m, dReal total_mass, dGeomID convex)
{
    const FloatEnvironment floats;
    EPODE_GEOM_AS(Convex, geom, convex);
    EPODE_USER(m && usable(total_mass));
    const MassProperties unit = geom->shape.solid->mass();
    EPODE_USER_SAY(unit.mass > 0, "convex has no volume");
    const MassProperties p = with_mass(unit, total_mass);
    EPODE_USER(usable(p));
    put_mass(m, p);
}
