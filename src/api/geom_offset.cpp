// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The pose of a geom in its body's frame, (p_o, R_o): the geom is at p_b + R_b p_o, turned by R_b R_o.
#include "base/objects/structure_edition.h"
#include "collide/types/registry.h"
#include "math/rotation.h"
#include "step/common/link.h"

using namespace epode;

namespace {

constexpr GeomOffset kNoOffset;

const GeomOffset& offset_of(const Geom& geom) { return geom.offset ? *geom.offset : kNoOffset; }

Pose body_pose(const Geom& geom) { return load_pose(geom.body.position, geom.body.rotation); }

void set_offset_position(Geom& geom, Vec3 p)
{
    store(geom.offset->position, p);
    note_structure_changed();
    mark_moved(geom);
}

void set_offset_rotation(Geom& geom, const Mat3& R)
{
    store_mat(geom.offset->rotation, R);
    note_structure_changed();
    mark_moved(geom);
}

// Turned to R in the world, its place in the world unchanged.
void set_world_rotation(Geom& geom, const Mat3& R)
{
    set_offset_rotation(geom, transpose(body_pose(geom).R) * R);
}

}  // namespace

// A placeable geom on a body in no locked space, with an offset to write to.
#define OFFSET_GEOM(geom, id)                                \
    EPODE_GEOM(geom, id);                                    \
    EPODE_PLACEABLE(geom);                                   \
    EPODE_USER_SAY(geom->body.id, "geom must be on a body"); \
    EPODE_UNLOCKED(geom)
#define OFFSET_READY(geom) EPODE_USER_SAY(ensure_offset(*geom), kOutOfMemory)

extern "C" {

void dGeomSetOffsetPosition(dGeomID id, dReal x, dReal y, dReal z)
{
    OFFSET_GEOM(geom, id);
    EPODE_USER(usable(x) && usable(y) && usable(z));
    OFFSET_READY(geom);
    set_offset_position(*geom, {x, y, z});
}

void dGeomSetOffsetRotation(dGeomID id, const dMatrix3 R)
{
    OFFSET_GEOM(geom, id);
    EPODE_USER(usable_matrix(R));
    Mat3 clean = load_mat(R);
    EPODE_USER(make_rotation(clean));
    OFFSET_READY(geom);
    set_offset_rotation(*geom, clean);
}

void dGeomSetOffsetQuaternion(dGeomID id, const dQuaternion q)
{
    OFFSET_GEOM(geom, id);
    EPODE_USER(q && usable(q, 4));
    Quat given = load_quat(q);
    EPODE_USER(normalize(given));
    OFFSET_READY(geom);
    set_offset_rotation(*geom, to_matrix(given));
}

void dGeomSetOffsetWorldPosition(dGeomID id, dReal x, dReal y, dReal z)
{
    OFFSET_GEOM(geom, id);
    EPODE_USER(usable(x) && usable(y) && usable(z));
    OFFSET_READY(geom);
    set_offset_position(*geom, body_pose(*geom).to_local({x, y, z}));
}

void dGeomSetOffsetWorldRotation(dGeomID id, const dMatrix3 R)
{
    OFFSET_GEOM(geom, id);
    EPODE_USER(usable_matrix(R));
    Mat3 clean = load_mat(R);
    EPODE_USER(make_rotation(clean));
    OFFSET_READY(geom);
    set_world_rotation(*geom, clean);
}

void dGeomSetOffsetWorldQuaternion(dGeomID id, const dQuaternion q)
{
    OFFSET_GEOM(geom, id);
    EPODE_USER(q && usable(q, 4));
    Quat given = load_quat(q);
    EPODE_USER(normalize(given));
    OFFSET_READY(geom);
    set_world_rotation(*geom, to_matrix(given));
}

void dGeomClearOffset(dGeomID id)
{
    EPODE_GEOM(geom, id);
    EPODE_PLACEABLE(geom);
    EPODE_UNLOCKED(geom);
    if (!geom->offset) return;
    drop_offset(*geom);
    mark_moved(*geom);
}

int dGeomIsOffset(dGeomID id)
{
    EPODE_GEOM(geom, id, 0);
    return geom->offset != nullptr;
}

const dReal* dGeomGetOffsetPosition(dGeomID id)
{
    EPODE_GEOM(geom, id, nullptr);
    return offset_of(*geom).position;
}

const dReal* dGeomGetOffsetRotation(dGeomID id)
{
    EPODE_GEOM(geom, id, nullptr);
    return offset_of(*geom).rotation;
}

void dGeomCopyOffsetPosition(dGeomID id, dVector3 pos)
{
    EPODE_GEOM(geom, id);
    EPODE_USER(pos);
    store(pos, load(offset_of(*geom).position));
}

void dGeomCopyOffsetRotation(dGeomID id, dMatrix3 R)
{
    EPODE_GEOM(geom, id);
    EPODE_USER(R);
    for (int row = 0; row < 3; ++row) store(R + 4 * row, load(offset_of(*geom).rotation + 4 * row));
}

void dGeomGetOffsetQuaternion(dGeomID id, dQuaternion result)
{
    EPODE_GEOM(geom, id);
    EPODE_USER(result);
    store_quat(result, to_quat(load_mat(offset_of(*geom).rotation)));
}

}  // extern "C"
