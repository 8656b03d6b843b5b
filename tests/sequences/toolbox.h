/* SPDX-License-Identifier: BSD-3-Clause */
/* Copyright (c) 2026 The Epode authors
 *
 * What a random sequence does in more than one call. Plain C: the text of this file stands at the head of
 * every program that a failed sequence is written down as, so that the program needs nothing else. */
#include <ode/ext.h>
#include <ode/ode.h>
#include <string.h>

#ifdef __cplusplus
#define TOOL inline
#else
#define TOOL static
#endif

enum { kMadeRoom = 16, kFeedbackRoom = 64 };
TOOL dJointID made[kMadeRoom]; /* by the last call of meet() */
TOOL int made_count;
TOOL dJointFeedback feedback[kFeedbackRoom];
TOOL const double kHeights[16] = {0, 0.3, 0.1, 0, 0.2, 0.5, 0.4, 0.1, 0, 0.6, 0.2, 0.3, 0.1, 0, 0.2, 0};

/* Contacts of two geoms become joints between their bodies, where these belong to `w`. */
TOOL void meet(dWorldID w, dJointGroupID group, dGeomID a, dGeomID b, int most, int mode)
{
    dContact contact[kMadeRoom];
    dBodyID b1 = dGeomGetBody(a), b2 = dGeomGetBody(b);
    int i, n = dCollide(a, b, most < kMadeRoom ? most : (int)kMadeRoom, &contact[0].geom, sizeof contact[0]);
    made_count = 0;
    if ((b1 && dBodyGetWorld(b1) != w) || (b2 && dBodyGetWorld(b2) != w) || b1 == b2) return;
    for (i = 0; i < n; ++i) {
        memset(&contact[i].surface, 0, sizeof contact[i].surface);
        contact[i].surface.mode = mode;
        contact[i].surface.mu = (dReal)0.5;
        contact[i].surface.bounce = (dReal)0.3;
        contact[i].surface.soft_erp = (dReal)0.5;
        contact[i].surface.soft_cfm = (dReal)1e-4;
        made[made_count] = dJointCreateContact(w, group, &contact[i]);
        if (!made[made_count]) return;
        dJointAttach(made[made_count], b1, b2);
        ++made_count;
    }
}

TOOL void set_mass(dBodyID body, dReal density, dReal x, dReal y, dReal z)
{
    dMass m;
    dMassSetBox(&m, density, x, y, z);
    dBodySetMass(body, &m);
}

TOOL void build_heights(dHeightfieldDataID data, int copy, dReal width, int wrap)
{
    dGeomHeightfieldDataBuildDouble(data, kHeights, copy, width, width, 4, 4, 1, 0, 1, wrap);
}

TOOL void watch(dJointID joint, int index) { dJointSetFeedback(joint, index < 0 ? 0 : &feedback[index]); }
