// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Ray: the segment from the geom's position along its z axis. An infinite length is taken as the longest that
// numbers bear. Setting start and direction is in api/geom_placement.cpp, since it may move a body.
#include "bvh/dynamic_tree.h"
#include "collide/collide.h"
#include "collide/describe.h"
#include "collide/types/registry.h"

#include <algorithm>

namespace epode {
namespace {

Aabb aabb(Geom& geom)
{
    const Real length = static_cast<const ShapeGeom<Ray>&>(geom).shape.length;
    const Vec3 a = load(geom.position), b = a + length * load_mat(geom.rotation).column(2);
    return {min(a, b), max(a, b)};
}

// A box that the segment does not cross contains nothing that it hits, so spaces need not report the geom.
// The slack is half of the slack of tree queries, so trees never reject what this accepts.
bool may_touch(Geom& geom, Geom& other)
{
    if (rays_overridden()) return true;
    const Aabb& box = box_of(other);
    const Pose pose = pose_of(geom);
    TreeRay ray(pose.p, static_cast<const ShapeGeom<Ray>&>(geom).shape.length * pose.R.column(2), box);
    ray.slack /= 2;
    return ray.enters(box, 1) < kInf;
}

Real bearable(Real length) { return std::clamp(length, -kMaxMagnitude, kMaxMagnitude); }

void structure(Geom& geom, ShapeStream& stream)
{
    Ray& ray = static_cast<ShapeGeom<Ray>&>(geom).shape;
    stream.real(ray.length);
    stream.flag(ray.first_contact), stream.flag(ray.backface_cull), stream.flag(ray.closest_hit);
    if (stream.loads()) ray.length = bearable(ray.length);
}

void describe_ray(const Geom& geom, DifWriter& out)
{
    out.text("type", "ray");
    out.real("length", static_cast<const ShapeGeom<Ray>&>(geom).shape.length);
}

}  // namespace

const GeomType kRayType = {.number = dRayClass,
                           .aabb = aabb,
                           .destroy = destroy_pooled<ShapeGeom<Ray>>,
                           .may_touch = may_touch,
                           .describe = describe_ray,
                           .create = create_pooled<ShapeGeom<Ray>>,
                           .structure = structure};

}  // namespace epode

using namespace epode;

extern "C" dGeomID dCreateRay(dSpaceID space, dReal length)
{
    EPODE_USER(usable_or_infinite(length), nullptr);
    EPODE_PARENT_SPACE(space, nullptr);
    return create_shape(space, Ray{bearable(length)});
}

extern "C" void dGeomRaySetLength(dGeomID ray, dReal length)
{
    EPODE_GEOM_AS(Ray, geom, ray);
    EPODE_USER(usable_or_infinite(length));
    EPODE_UNLOCKED(geom);
    geom->shape.length = bearable(length);
    mark_moved(*geom);
}

extern "C" dReal dGeomRayGetLength(dGeomID ray)
{
    EPODE_GEOM_AS(Ray, geom, ray, 0);
    return geom->shape.length;
}

extern "C" void dGeomRayGet(dGeomID ray, dVector3 start, dVector3 dir)
{
    EPODE_GEOM_AS(Ray, geom, ray);
    EPODE_USER(start && dir);
    const Pose pose = pose_of(*geom);
    store(start, pose.p);
    store(dir, pose.R.column(2));
}

extern "C" void dGeomRaySetFirstContact(dGeomID ray, int on)
{
    EPODE_GEOM_AS(Ray, geom, ray);
    geom->shape.first_contact = on != 0;
}

extern "C" int dGeomRayGetFirstContact(dGeomID ray)
{
    EPODE_GEOM_AS(Ray, geom, ray, 0);
    return geom->shape.first_contact;
}

extern "C" void dGeomRaySetBackfaceCull(dGeomID ray, int on)
{
    EPODE_GEOM_AS(Ray, geom, ray);
    geom->shape.backface_cull = on != 0;
}

extern "C" int dGeomRayGetBackfaceCull(dGeomID ray)
{
    EPODE_GEOM_AS(Ray, geom, ray, 0);
    return geom->shape.backface_cull;
}

extern "C" void dGeomRaySetClosestHit(dGeomID ray, int on)
{
    EPODE_GEOM_AS(Ray, geom, ray);
    geom->shape.closest_hit = on != 0;
}

extern "C" int dGeomRayGetClosestHit(dGeomID ray)
{
    EPODE_GEOM_AS(Ray, geom, ray, 0);
    return geom->shape.closest_hit;
}

extern "C" void dGeomRaySetParams(dGeomID ray, int first_contact, int backface_cull)
{
    EPODE_GEOM_AS(Ray, geom, ray);
    geom->shape.first_contact = first_contact != 0;
    geom->shape.backface_cull = backface_cull != 0;
}

extern "C" void dGeomRayGetParams(dGeomID ray, int* first_contact, int* backface_cull)
{
    EPODE_GEOM_AS(Ray, geom, ray);
    EPODE_USER(first_contact && backface_cull);
    *first_contact = geom->shape.first_contact;
    *backface_cull = geom->shape.backface_cull;
}
