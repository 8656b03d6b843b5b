// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which geoms steps look at on their whole way (step/common/continuous.h).
#include "collide/types/registry.h"
#include "ode/ext.h"

using namespace epode;

extern "C" void dGeomSetContinuous(dGeomID id, int mode)
{
    EPODE_GEOM(geom, id);
    EPODE_USER_SAY(!is_space(*geom), "argument must not be a space");
    EPODE_USER(mode >= dContinuousOff && mode <= dContinuousIgnored);
    EPODE_USER_SAY(mode != dContinuousOn || geom->type->half_thickness || as_transform(*geom),
                   "this class of geom cannot be continuous");
    set_continuous(*geom, mode);
}

extern "C" int dGeomGetContinuous(dGeomID id)
{
    EPODE_GEOM(geom, id, 0);
    EPODE_USER_SAY(!is_space(*geom), "argument must not be a space", 0);
    return geom->continuous;
}
