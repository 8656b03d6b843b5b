/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * The scene of golden.rs by the C functions that the safe crate calls, in their order. Prints the hash of the state before the steps,
 * and after 60 steps of each stepper. */
#include <ode/ext.h>
#include <ode/ode.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static void print_hash(dWorldID world)
{
    size_t size = dWorldGetStateSize(world);
    unsigned char* state = malloc(size);
    if (!dWorldGetState(world, state, size)) exit(1);
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t i = 0; i < size; ++i) hash = (hash ^ state[i]) * 0x100000001b3u;
    printf("%016llx\n", (unsigned long long)hash);
    free(state);
}

static dBodyID add_body(dWorldID world, dSpaceID space, int i, dReal x, dReal y, dReal z)
{
    dBodyID body = dBodyCreate(world);
    dMass mass;
    dGeomID geom;
    if (i % 2 == 0) {
        geom = dCreateBox(space, REAL(0.5), REAL(0.6), REAL(0.7));
        dMassSetBox(&mass, 700, REAL(0.5), REAL(0.6), REAL(0.7));
    }
    else {
        geom = dCreateSphere(space, REAL(0.3));
        dMassSetSphere(&mass, 700, REAL(0.3));
    }
    dGeomSetBody(geom, body);
    dBodySetMass(body, &mass);
    dBodySetPosition(body, x, y, z);
    return body;
}

static void add_hinge(dWorldID world, dBodyID one, dBodyID other, dReal x, dReal y, dReal z)
{
    dJointID hinge = dJointCreateHinge(world, 0);
    dJointAttach(hinge, one, other);
    dJointSetHingeAxis(hinge, 0, 1, 0);
    dJointSetHingeAnchor(hinge, x, y, z);
    dJointSetHingeParam(hinge, dParamLoStop, REAL(-0.5));
    dJointSetHingeParam(hinge, dParamHiStop, REAL(0.5));
    dJointSetHingeParam(hinge, dParamVel, 2);
    dJointSetHingeParam(hinge, dParamFMax, 5);
}

static void add_ground(dSpaceID space)
{
    dMaterial rough;
    dMaterialInit(&rough, sizeof rough);
    rough.friction = REAL(0.9);
    rough.bounce = REAL(0.2);
    dGeomSetMaterial(dCreatePlane(space, 0, 0, 1, 0), &rough);
}

int main(void)
{
    dInitODE2(0);
    dWorldID world = dWorldCreate();
    dSpaceID space = dHashSpaceCreate(0);
    dWorldSetContactSpace(world, space);
    dWorldSetGravity(world, 0, 0, REAL(-9.81));
    dWorldSetERP(world, REAL(0.3));
    add_ground(space);
    dBodyID before = 0;
    for (int i = 0; i < 20; ++i) {
        dReal x = REAL(0.3) * (i % 3), y = REAL(0.2) * (i % 2), z = REAL(1.0) + REAL(0.8) * i;
        dBodyID body = add_body(world, space, i, x, y, z);
        if (i % 4 == 3) add_hinge(world, before, body, x, y, z);
        before = body;
    }
    print_hash(world);
    for (int i = 0; i < 240; ++i) {
        dReal h = REAL(0.01);
        int done = i < 60    ? dWorldStep(world, h)
                   : i < 120 ? dWorldQuickStep(world, h)
                   : i < 180 ? dWorldStepHybrid(world, h)
                             : dWorldStepFast1(world, h, 4);
        if (!done) return 1;
        if (i % 60 == 59) print_hash(world);
    }
    dWorldDestroy(world);
    dSpaceDestroy(space);
    dCloseODE();
    return 0;
}
