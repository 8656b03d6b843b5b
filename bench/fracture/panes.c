/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * panes BODIES PARTS STEPS BREAKS: so many panes of PARTS tiles lie on a floor for a second; then STEPS steps, each after a
 * dFractureUpdate of all, and in the last one BREAKS of them have no strength. Prints how many broke. bench/fracture/cost counts
 * the instructions. */
#include <ode/ext.h>
#include <ode/ode.h>
#include <stdio.h>
#include <stdlib.h>

enum { kSettle = 60 };

static const dReal kTile = 0.2, kThick = 0.05;

static dFracture add_pane(dWorldID world, dSpaceID space, int parts, dReal x, dReal y)
{
    dFracturePart* list = malloc((size_t)parts * sizeof *list);
    for (int i = 0; i < parts; ++i) {
        list[i].geom = dCreateBox(space, kTile, kTile, kThick);
        list[i].density = 2500;
        dGeomSetPosition(list[i].geom, x + kTile * (i % 5), y + kTile * (i / 5), kThick / 2);
    }
    dFractureCreate(world, list, parts);
    const dFracture pane = {list, parts, dInfinity, dInfinity};
    return pane;
}

int main(int argc, char** argv)
{
    if (argc != 5) return 1;
    const int bodies = atoi(argv[1]), parts = atoi(argv[2]), steps = atoi(argv[3]), breaks = atoi(argv[4]);
    dInitODE2(0);
    dWorldID world = dWorldCreate();
    dSpaceID space = dHashSpaceCreate(0);
    dWorldUseDefaults(world, dDefaultsGame);
    dWorldSetAutoDisableFlag(world, 0);
    dWorldSetGravity(world, 0, 0, -9.81);
    dWorldSetContactSpace(world, space);
    dCreatePlane(space, 0, 0, 1, 0);
    dFracture* panes = malloc((size_t)bodies * sizeof *panes);
    for (int i = 0; i < bodies; ++i)
        panes[i] = add_pane(world, space, parts, 1.5 * (i % 10), (0.3 + kTile * (parts / 5)) * (i / 10));
    for (int i = 0; i < kSettle; ++i) dWorldStepHybrid(world, 1.0 / 60);
    int broken = 0;
    for (int i = 0; i < steps; ++i) {
        for (int k = 0; k < breaks && i == steps - 1; ++k) panes[k].strength = 0;
        broken += dFractureUpdate(world, panes, bodies);
        dWorldStepHybrid(world, 1.0 / 60);
    }
    printf("%d\n", broken);
    for (int i = 0; i < bodies; ++i) free((void*)panes[i].parts);
    free(panes);
    dWorldDestroy(world);
    dSpaceDestroy(space);
    dCloseODE();
    return 0;
}
