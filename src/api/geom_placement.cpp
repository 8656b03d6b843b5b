// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where a geom is: its own pose, or its body's. Setting the pose of a geom on a body moves the body.
#include "base/float_environment.h"
#include "collide/types/registry.h"
#include "math/rotation.h"
#include "step/common/link.h"

using namespace epode;

namespace {

// Moving a body moves all its geoms: none of them may lie in a locked space.
bool may_move(const Geom& geom)
{
    const Body* body = body_of(geom);
    return body ? !in_locked_space(*body) : !in_locked_space(geom);
}

void copy_rotation(dReal* to, const dReal* from)
{
    for (int row = 0; row < 3; ++row) store(to + 4 * row, load(from + 4 * row));
}

}  // namespace

#define MAY_MOVE(geom) EPODE_USER_SAY(may_move(*geom), EPODE_LOCKED_TEXT)

extern "C" {

void dGeomSetPosition(dGeomID id, dReal x, dReal y, dReal z)
{
    EPODE_GEOM(geom, id);
    EPODE_PLACEABLE(geom);
    EPODE_USER(usable(x) && usable(y) && usable(z));
    MAY_MOVE(geom);
    set_geom_position(*geom, {x, y, z});
}

void dGeomSetRotation(dGeomID id, const dMatrix3 R)
{
    EPODE_GEOM(geom, id);
    EPODE_PLACEABLE(geom);
    EPODE_USER(usable_matrix(R));
    MAY_MOVE(geom);
    EPODE_USER(set_geom_rotation(*geom, load_mat(R)));
}

// The geom turns to q also when it has an offset. (The original then also turns the body to q.)
void dGeomSetQuaternion(dGeomID id, const dQuaternion q)
{
    EPODE_GEOM(geom, id);
    EPODE_PLACEABLE(geom);
    EPODE_USER(q && usable(q, 4));
    MAY_MOVE(geom);
    Quat given = load_quat(q);
    EPODE_USER(normalize(given));
    EPODE_USER(set_geom_orientation(*geom, given));
}

const dReal* dGeomGetPosition(dGeomID id)
{
    const FloatEnvironment floats;
    EPODE_GEOM(geom, id, nullptr);
    EPODE_PLACEABLE(geom, nullptr);
    refresh_pose(*geom);
    return geom->position;
}

const dReal* dGeomGetRotation(dGeomID id)
{
    const FloatEnvironment floats;
    EPODE_GEOM(geom, id, nullptr);
    EPODE_PLACEABLE(geom, nullptr);
    refresh_pose(*geom);
    return geom->rotation;
}

void dGeomCopyPosition(dGeomID id, dVector3 pos)
{
    const FloatEnvironment floats;
    EPODE_GEOM(geom, id);
    EPODE_PLACEABLE(geom);
    EPODE_USER(pos);
    store(pos, pose_of(*geom).p);
}

void dGeomCopyRotation(dGeomID id, dMatrix3 R)
{
    const FloatEnvironment floats;
    EPODE_GEOM(geom, id);
    EPODE_PLACEABLE(geom);
    EPODE_USER(R);
    refresh_pose(*geom);
    copy_rotation(R, geom->rotation);
}

void dGeomGetQuaternion(dGeomID id, dQuaternion result)
{
    const FloatEnvironment floats;
    EPODE_GEOM(geom, id);
    EPODE_PLACEABLE(geom);
    EPODE_USER(result);
    const Body* body = geom->offset ? nullptr : body_of(*geom);
    store_quat(result, body ? body->orientation() : to_quat(pose_of(*geom).R));
}

void dGeomRaySet(dGeomID ray, dReal px, dReal py, dReal pz, dReal dx, dReal dy, dReal dz)
{
    const FloatEnvironment floats;
    EPODE_GEOM_AS(Ray, geom, ray);
    EPODE_USER(usable(px) && usable(py) && usable(pz) && usable(dx) && usable(dy) && usable(dz));
    Mat3 R;
    EPODE_USER(rotation_from_z_axis({dx, dy, dz}, R));
    MAY_MOVE(geom);
    EPODE_USER(set_geom_pose(*geom, {{px, py, pz}, R}));
}

// ---- points and vectors; a geom without a pose gives them back ----

#define MAP_FUNCTION(name, expression)                                     \
    void name(dGeomID id, dReal px, dReal py, dReal pz, dVector3 result)   \
    {                                                                      \
        EPODE_GEOM(geom, id);                                              \
        const FloatEnvironment floats;                                     \
        EPODE_USER(result&& usable(px) && usable(py) && usable(pz));       \
        const Vec3 in{px, py, pz};                                         \
        const Pose pose = geom->type->placeable ? pose_of(*geom) : Pose{}; \
        store(result, expression);                                         \
    }
MAP_FUNCTION(dGeomGetRelPointPos, pose.to_world(in))
MAP_FUNCTION(dGeomGetPosRelPoint, pose.to_local(in))
MAP_FUNCTION(dGeomVectorToWorld, pose.R* in)
MAP_FUNCTION(dGeomVectorFromWorld, transposed_times(pose.R, in))
#undef MAP_FUNCTION

// ---- bodies ----

void dGeomSetBody(dGeomID id, dBodyID body)
{
    EPODE_GEOM(geom, id);
    Body* target = from_handle<Body>(body);
    EPODE_USER(!body || target);
    EPODE_USER_SAY(geom->type->placeable || !target, "geom must be placeable");
    EPODE_UNLOCKED(geom);
    EPODE_USER_SAY(!target || !geom->holders,
                   "GeomTransform encapsulated object must not be attached to a body");
    if (geom->type->placeable) attach_geom(*geom, target);
}

dBodyID dGeomGetBody(dGeomID id)
{
    EPODE_GEOM(geom, id, nullptr);
    return geom->body.id;
}

dGeomID dBodyGetFirstGeom(dBodyID id)
{
    const Body* body = from_handle<Body>(id);
    EPODE_USER(body, nullptr);
    return body->first_geom;
}

dGeomID dBodyGetNextGeom(dGeomID id)
{
    EPODE_GEOM(geom, id, nullptr);
    return to_handle<Geom>(geom->body_next);
}

dGeomID dGeomGetBodyNext(dGeomID id)
{
    EPODE_GEOM(geom, id, nullptr);
    return to_handle<Geom>(geom->body_next);
}

}  // extern "C"
