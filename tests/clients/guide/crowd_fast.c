/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * The fast stepper of the 0.039 guide and its helpers, which later releases dropped: a crowd of boxes and
 * spheres falls into a pit of planes under dWorldStepFast1 and settles; nothing passes the floor, nothing
 * gains energy, and the sleeping helpers give back what they were given. One body is taken over by dWorldStep
 * halfway: the guide promises that both steppers may be mixed on one world.
 */
#include <ode/ode.h>

#include "check.h"

#define COUNT 40

static dWorldID world;
static dSpaceID space;
static dJointGroupID contactgroup;
static dBodyID body[COUNT];

static void nearCallback(void* data, dGeomID o1, dGeomID o2)
{
    dContact contact[4];
    int i, n = dCollide(o1, o2, 4, &contact[0].geom, sizeof(dContact));
    for (i = 0; i < n; i++) {
        contact[i].surface.mode = dContactApprox1;
        contact[i].surface.mu = 0.7;
        dJointAttach(dJointCreateContact(world, contactgroup, &contact[i]), dGeomGetBody(o1),
                     dGeomGetBody(o2));
    }
}

static void makePit(void)
{
    dCreatePlane(space, 0, 0, 1, 0);
    dCreatePlane(space, 1, 0, 0, -2);
    dCreatePlane(space, -1, 0, 0, -2);
    dCreatePlane(space, 0, 1, 0, -2);
    dCreatePlane(space, 0, -1, 0, -2);
}

static void makeCrowd(void)
{
    dMass m;
    int i;
    for (i = 0; i < COUNT; i++) {
        dGeomID geom;
        body[i] = dBodyCreate(world);
        if (i % 2) {
            dMassSetSphereTotal(&m, 1, 0.3);
            geom = dCreateSphere(space, 0.3);
        } else {
            dMassSetBoxTotal(&m, 1, 0.5, 0.5, 0.5);
            geom = dCreateBox(space, 0.5, 0.5, 0.5);
        }
        dBodySetMass(body[i], &m);
        dGeomSetBody(geom, body[i]);
        dBodySetPosition(body[i], -1.4 + 0.7 * (i % 5), -1.4 + 0.7 * ((i / 5) % 4),
                         0.5 + 0.7 * (i / 20) + 0.05 * (i % 3));
    }
}

static double kineticEnergy(void)
{
    double sum = 0;
    int i;
    for (i = 0; i < COUNT; i++) {
        const dReal* v = dBodyGetLinearVel(body[i]);
        sum += 0.5 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    return sum;
}

static void simulate(int steps, int fast)
{
    int i;
    for (i = 0; i < steps; i++) {
        dSpaceCollide(space, 0, &nearCallback);
        if (fast) {
            dWorldStepFast1(world, 0.01, 10);
        } else {
            dWorldStep(world, 0.01);
        }
        dJointGroupEmpty(contactgroup);
    }
}

static void checkInside(double tolerance)
{
    int i;
    for (i = 0; i < COUNT; i++) {
        const dReal* p = dBodyGetPosition(body[i]);
        CHECK(p[2] > 0.25 - tolerance && p[2] < 4);
        CHECK(p[0] > -2 + 0.25 - tolerance && p[0] < 2 - 0.25 + tolerance);
        CHECK(p[1] > -2 + 0.25 - tolerance && p[1] < 2 - 0.25 + tolerance);
    }
}

static void checkHelpers(void)
{
    dWorldSetAutoEnableDepthSF1(world, 3);
    CHECK(dWorldGetAutoEnableDepthSF1(world) == 3);
    dBodySetAutoDisableThresholdSF1(body[0], 0.05);
    dBodySetAutoDisableStepsSF1(body[0], 15);
    dBodySetAutoDisableSF1(body[0], 1);
    CHECK_CLOSE(dBodyGetAutoDisableThresholdSF1(body[0]), 0.05, 1e-6);
    CHECK(dBodyGetAutoDisableStepsSF1(body[0]) == 15);
    CHECK(dBodyGetAutoDisableSF1(body[0]));
    CHECK(dBodyGetAutoDisableFlag(body[0]));
    dBodySetAutoDisableSF1(body[0], 0);
    CHECK(!dBodyGetAutoDisableSF1(body[0]));
}

int main(void)
{
    dInitODE();
    world = dWorldCreate();
    space = dHashSpaceCreate(0);
    contactgroup = dJointGroupCreate(0);
    dWorldSetGravity(world, 0, 0, -9.81);
    dWorldSetCFM(world, 1e-4);
    dWorldSetContactMaxCorrectingVel(world, 2);
    makePit();
    makeCrowd();
    checkHelpers();
    simulate(300, 1);
    checkInside(0.05);
    CHECK(kineticEnergy() < 0.05 * COUNT);
    simulate(20, 0);
    checkInside(0.05);
    simulate(100, 1);
    checkInside(0.05);
    CHECK(kineticEnergy() < 0.05 * COUNT);
    dJointGroupDestroy(contactgroup);
    dSpaceDestroy(space);
    dWorldDestroy(world);
    dCloseODE();
    printf("the crowd has settled\n");
    return 0;
}
