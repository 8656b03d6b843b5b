/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * The loop of the guide: a near callback makes contact joints in a group, the world steps, the group is
 * emptied. A sphere, a box, a capped cylinder and a box in a geometry transform fall on a plane; all come to
 * rest at the height their shape says, and auto-disabling puts them to sleep. Names are those of the 0.039
 * guide.
 */
#include <math.h>
#include <ode/ode.h>

#include "check.h"

#define MAX_CONTACTS 8
#define BODIES 4

static dWorldID world;
static dSpaceID space;
static dJointGroupID contactgroup;
static dBodyID body[BODIES];

static void nearCallback(void* data, dGeomID o1, dGeomID o2)
{
    dContact contact[MAX_CONTACTS];
    dBodyID b1 = dGeomGetBody(o1);
    dBodyID b2 = dGeomGetBody(o2);
    int i, n;
    if (b1 && b2 && dAreConnectedExcluding(b1, b2, dJointTypeContact)) return;
    n = dCollide(o1, o2, MAX_CONTACTS, &contact[0].geom, sizeof(dContact));
    for (i = 0; i < n; i++) {
        contact[i].surface.mode = dContactSoftCFM | dContactApprox1;
        contact[i].surface.mu = 0.5;
        contact[i].surface.soft_cfm = 1e-6;
        dJointAttach(dJointCreateContact(world, contactgroup, &contact[i]), b1, b2);
    }
}

static void makeBodies(void)
{
    dMass m;
    dMatrix3 R;
    dGeomID wrapper, inside;
    int i;
    for (i = 0; i < BODIES; i++) {
        body[i] = dBodyCreate(world);
        dBodySetPosition(body[i], 3 * i, 0, 1.5);
    }
    dMassSetSphere(&m, 1, 0.5);
    dBodySetMass(body[0], &m);
    dGeomSetBody(dCreateSphere(space, 0.5), body[0]);

    dMassSetBox(&m, 1, 1, 1, 0.6);
    dBodySetMass(body[1], &m);
    dGeomSetBody(dCreateBox(space, 1, 1, 0.6), body[1]);

    dMassSetCappedCylinder(&m, 1, 3, 0.3, 1.0);
    dBodySetMass(body[2], &m);
    dGeomSetBody(dCreateCCylinder(space, 0.3, 1.0), body[2]);
    dRFromAxisAndAngle(R, 0, 1, 0, M_PI / 2);
    dBodySetRotation(body[2], R);

    dMassSetBoxTotal(&m, 2, 0.8, 0.8, 0.8);
    dBodySetMass(body[3], &m);
    wrapper = dCreateGeomTransform(space);
    inside = dCreateBox(0, 0.8, 0.8, 0.8);
    dGeomTransformSetCleanup(wrapper, 1);
    dGeomTransformSetGeom(wrapper, inside);
    dGeomSetBody(wrapper, body[3]);
}

static void simulate(int steps)
{
    int i;
    for (i = 0; i < steps; i++) {
        dSpaceCollide(space, 0, &nearCallback);
        dWorldStep(world, 0.01);
        dJointGroupEmpty(contactgroup);
    }
}

int main(void)
{
    static const double height[BODIES] = {0.5, 0.3, 0.3, 0.4};
    int i;
    dInitODE();
    world = dWorldCreate();
    space = dHashSpaceCreate(0);
    contactgroup = dJointGroupCreate(1000000);
    dWorldSetGravity(world, 0, 0, -9.81);
    dWorldSetERP(world, 0.2);
    dWorldSetCFM(world, 1e-5);
    dWorldSetContactMaxCorrectingVel(world, 1);
    dWorldSetAutoDisableFlag(world, 1);
    dCreatePlane(space, 0, 0, 1, 0);
    makeBodies();

    simulate(20);
    CHECK(dBodyGetPosition(body[0])[2] < 1.4);
    CHECK(dBodyIsEnabled(body[0]));
    simulate(400);
    for (i = 0; i < BODIES; i++) {
        const dReal* p = dBodyGetPosition(body[i]);
        CHECK_CLOSE(p[2], height[i], 2e-3);
        CHECK_CLOSE(p[0], 3 * i, 2e-2);
        CHECK_CLOSE(p[1], 0, 2e-2);
        CHECK(!dBodyIsEnabled(body[i]));
        CHECK_CLOSE(dBodyGetLinearVel(body[i])[2], 0, 1e-12);
    }
    dBodyEnable(body[1]);
    dBodySetLinearVel(body[1], 2, 0, 0);
    simulate(200);
    /* braked by mu g: v^2 / (2 mu g) = 0.408 m */
    CHECK_CLOSE(dBodyGetPosition(body[1])[0], 3 + 2.0 * 2.0 / (2 * 0.5 * 9.81), 0.03);

    dJointGroupDestroy(contactgroup);
    dSpaceDestroy(space);
    dWorldDestroy(world);
    dCloseODE();
    printf("all at rest\n");
    return 0;
}
