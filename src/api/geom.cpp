// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What all classes of geoms have in common: life, data, class, bits, box, enabling.
#include "base/float_environment.h"
#include "collide/surfaces/height_function.h"
#include "collide/types/registry.h"
#include "state/world_archive.h"

using namespace epode;

extern "C" {

void dGeomDestroy(dGeomID id)
{
    EPODE_GEOM(geom, id);
    EPODE_OUTSIDE_HEIGHT_FUNCTION();
    EPODE_USER_SAY(may_destroy(*geom), EPODE_LOCKED_TEXT);
    if (!keep_for_history(*geom)) destroy_geom(*geom);
}

void dGeomSetData(dGeomID id, void* data)
{
    EPODE_GEOM(geom, id);
    geom->data = data;
}

void* dGeomGetData(dGeomID id)
{
    EPODE_GEOM(geom, id, nullptr);
    return geom->data;
}

int dGeomGetClass(dGeomID id)
{
    EPODE_GEOM(geom, id, -1);
    return geom->type->number;
}

int dGeomIsSpace(dGeomID id)
{
    EPODE_GEOM(geom, id, 0);
    return is_space(*geom);
}

dSpaceID dGeomGetSpace(dGeomID id)
{
    EPODE_GEOM(geom, id, nullptr);
    return id_of(geom->space);
}

void dGeomSetCategoryBits(dGeomID id, unsigned long bits)
{
    EPODE_GEOM(geom, id);
    EPODE_UNLOCKED(geom);
    if (geom->category == bits) return;
    geom->category = bits;
    note_rules_changed(*geom);
}

void dGeomSetCollideBits(dGeomID id, unsigned long bits)
{
    EPODE_GEOM(geom, id);
    EPODE_UNLOCKED(geom);
    if (geom->collide == bits) return;
    geom->collide = bits;
    note_rules_changed(*geom);
}

unsigned long dGeomGetCategoryBits(dGeomID id)
{
    EPODE_GEOM(geom, id, 0);
    return geom->category;
}

unsigned long dGeomGetCollideBits(dGeomID id)
{
    EPODE_GEOM(geom, id, 0);
    return geom->collide;
}

void dGeomEnable(dGeomID id)
{
    EPODE_GEOM(geom, id);
    if (geom->enabled) return;
    geom->enabled = true;
    note_rules_changed(*geom);
}

void dGeomDisable(dGeomID id)
{
    EPODE_GEOM(geom, id);
    if (!geom->enabled) return;
    geom->enabled = false;
    note_rules_changed(*geom);
}

int dGeomIsEnabled(dGeomID id)
{
    EPODE_GEOM(geom, id, 0);
    return geom->enabled;
}

void dGeomGetAABB(dGeomID id, dReal aabb[6])
{
    const FloatEnvironment floats;
    EPODE_GEOM(geom, id);
    EPODE_USER(aabb);
    const Aabb& box = box_of(*geom);
    for (int i = 0; i < 3; ++i) aabb[2 * i] = box.lo[i], aabb[2 * i + 1] = box.hi[i];
}

void dInfiniteAABB(dGeomID, dReal aabb[6])
{
    EPODE_USER(aabb);
    for (int i = 0; i < 3; ++i) aabb[2 * i] = -kInf, aabb[2 * i + 1] = kInf;
}

void dGeomMoved(dGeomID id)
{
    EPODE_GEOM(geom, id);
    EPODE_UNLOCKED(geom);
    mark_moved(*geom);
}

}  // extern "C"
