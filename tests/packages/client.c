/* SPDX-License-Identifier: BSD-3-Clause
   Copyright (c) 2026 The Epode authors

   What a package's user writes first: a ball falls on a plane and lies there. */
#include <math.h>
#include <ode/ode.h>
#ifndef NO_ROBOTS
#include <epode/robots.h>
#endif
#include <stdio.h>

static dWorldID world;
static dJointGroupID contacts;

static void near_callback(void *data, dGeomID a, dGeomID b) {
    dContact contact = {0};
    (void)data;
    contact.surface.mu = 1;
    if (dCollide(a, b, 1, &contact.geom, sizeof(dContact)))
        dJointAttach(dJointCreateContact(world, contacts, &contact), dGeomGetBody(a), dGeomGetBody(b));
}

int main(void) {
    int i;
    double height;
    dSpaceID space;
    dBodyID ball;
    dInitODE2(0);
    world = dWorldCreate();
    space = dHashSpaceCreate(0);
    contacts = dJointGroupCreate(0);
    dWorldSetGravity(world, 0, 0, -9.81);
    dCreatePlane(space, 0, 0, 1, 0);
    ball = dBodyCreate(world);
    dGeomSetBody(dCreateSphere(space, 0.5), ball);
    dBodySetPosition(ball, 0, 0, 2);
    for (i = 0; i < 200; ++i) {
        dSpaceCollide(space, 0, near_callback);
        dWorldStep(world, 0.01);
        dJointGroupEmpty(contacts);
    }
    height = dBodyGetPosition(ball)[2];
    printf("%s, ball at %.4f m\n", dGetConfiguration(), height);
    dWorldDestroy(world);
    dCloseODE();
    return fabs(height - 0.5) < 0.01 ? 0 : 1;
}
