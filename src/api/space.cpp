// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What all spaces have in common.
#include "base/float_environment.h"
#include "collide/surfaces/height_function.h"
#include "collide/types/registry.h"

using namespace epode;

extern "C" {

void dSpaceDestroy(dSpaceID id)
{
    EPODE_SPACE(space, id);
    EPODE_OUTSIDE_HEIGHT_FUNCTION();
    EPODE_USER_SAY(may_destroy(*space), EPODE_LOCKED_TEXT);
    destroy_geom(*space);
}

void dSpaceSetCleanup(dSpaceID id, int mode)
{
    EPODE_SPACE(space, id);
    space->cleanup = mode != 0;
}

int dSpaceGetCleanup(dSpaceID id)
{
    EPODE_SPACE(space, id, 0);
    return space->cleanup;
}

void dSpaceSetSublevel(dSpaceID id, int sublevel)
{
    EPODE_SPACE(space, id);
    space->sublevel = sublevel;
}

int dSpaceGetSublevel(dSpaceID id)
{
    EPODE_SPACE(space, id, 0);
    return space->sublevel;
}

// There are no caches of threads to look after: as in Debian's build of ODE, the answer is 1 for ever.
void dSpaceSetManualCleanup(dSpaceID id, int)
{
    EPODE_SPACE(space, id);
    static_cast<void>(space);
}

int dSpaceGetManualCleanup(dSpaceID id)
{
    EPODE_SPACE(space, id, 0);
    static_cast<void>(space);
    return 1;
}

void dSpaceAdd(dSpaceID id, dGeomID geom_id)
{
    EPODE_SPACE(space, id);
    EPODE_GEOM(geom, geom_id);
    EPODE_USER_SAY(accepts_geoms(*space), EPODE_LOCKED_TEXT);
    EPODE_USER_SAY(!geom->space, "geom is already in a space");
    EPODE_USER_SAY(!geom->holders, "GeomTransform encapsulated object must not be in a space");
    EPODE_USER_SAY(!is_space(*geom) || !is_inside(*space, static_cast<Space&>(*geom)),
                   "a space cannot be put inside itself");
    EPODE_USER_SAY(!is_space(*geom) || nesting_fits(*space, static_cast<Space&>(*geom)),
                   "spaces are nested too deeply");
    EPODE_USER_SAY(add_geom(*space, *geom), kOutOfMemory);
}

void dSpaceRemove(dSpaceID id, dGeomID geom_id)
{
    EPODE_SPACE(space, id);
    EPODE_GEOM(geom, geom_id);
    EPODE_USER_SAY(!is_locked(*space), EPODE_LOCKED_TEXT);
    EPODE_USER_SAY(geom->space == space, "object is not in this space");
    remove_geom(*space, *geom);
}

int dSpaceQuery(dSpaceID id, dGeomID geom_id)
{
    EPODE_SPACE(space, id, 0);
    EPODE_GEOM(geom, geom_id, 0);
    return geom->space == space;
}

void dSpaceClean(dSpaceID id)
{
    const FloatEnvironment floats;
    EPODE_SPACE(space, id);
    clean(*space);
}

int dSpaceGetNumGeoms(dSpaceID id)
{
    EPODE_SPACE(space, id, 0);
    return space->count;
}

dGeomID dSpaceGetGeom(dSpaceID id, int i)
{
    EPODE_SPACE(space, id, nullptr);
    EPODE_USER_SAY(i >= 0 && i < space->count, "index out of range", nullptr);
    return to_handle(geom_at(*space, i));
}

int dSpaceGetClass(dSpaceID id)
{
    EPODE_SPACE(space, id, -1);
    return space->type->number;
}

void dSpaceCollide(dSpaceID id, void* data, dNearCallback* callback)
{
    const FloatEnvironment floats;
    EPODE_SPACE(space, id);
    EPODE_USER(callback);
    collide_space(*space, data, callback);
}

void dSpaceCollide2(dGeomID o1, dGeomID o2, void* data, dNearCallback* callback)
{
    const FloatEnvironment floats;
    EPODE_GEOM(first, o1);
    EPODE_GEOM(second, o2);
    EPODE_USER(callback);
    collide_across(*first, *second, data, callback);
}

}  // extern "C"
