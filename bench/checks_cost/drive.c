/* SPDX-License-Identifier: BSD-3-Clause */
/* Copyright (c) 2026 The Epode authors
 *
 * drive SHAPE STEPPER STEPS: 1,000 bodies as a program drives them. Each step: collision by callback,
 * contacts as joints, a force on every body, pose and velocity of every body read as for drawing, the world's
 * step. SHAPE: boxes (in 250 towers of four) or spheres (next to each other). What is counted is one_step().
 */
#include <ode/ode.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { kBodies = 1000, kContacts = 4 };
static dWorldID world;
static dSpaceID space;
static dJointGroupID contacts;
static dBodyID bodies[kBodies];
static int met;
static double seen;

static void near(void* data, dGeomID a, dGeomID b)
{
    dContact contact[kContacts];
    dBodyID one = dGeomGetBody(a), two = dGeomGetBody(b);
    int i, n;
    (void)data;
    if (one && two && dAreConnectedExcluding(one, two, dJointTypeContact)) return;
    n = dCollide(a, b, kContacts, &contact[0].geom, sizeof contact[0]);
    for (i = 0; i < n; ++i) {
        contact[i].surface.mode = dContactApprox1 | dContactSoftCFM;
        contact[i].surface.mu = (dReal)0.5;
        contact[i].surface.soft_cfm = (dReal)1e-5;
        dJointAttach(dJointCreateContact(world, contacts, &contact[i]), one, two);
    }
    met += n;
}

__attribute__((noinline)) void one_step(int exact)
{
    int i;
    met = 0;
    dSpaceCollide(space, NULL, &near);
    for (i = 0; i < kBodies; ++i) dBodyAddForce(bodies[i], (dReal)0.01, 0, 0);
    exact ? dWorldStep(world, (dReal)0.01) : dWorldQuickStep(world, (dReal)0.01);
    dJointGroupEmpty(contacts);
    for (i = 0; i < kBodies; ++i) {
        const dReal *p = dBodyGetPosition(bodies[i]), *R = dBodyGetRotation(bodies[i]);
        seen += p[2] + R[0] + dBodyGetLinearVel(bodies[i])[2] + dBodyGetAngularVel(bodies[i])[2];
    }
}

int main(int count, char** words)
{
    const int boxes = count > 1 && strcmp(words[1], "boxes") == 0;
    const int exact = count > 2 && strcmp(words[2], "exact") == 0;
    const int steps = count > 3 ? atoi(words[3]) : 3;
    int i;
    dInitODE2(0);
    world = dWorldCreate();
    space = dHashSpaceCreate(NULL);
    contacts = dJointGroupCreate(0);
    dWorldSetGravity(world, 0, 0, (dReal)-9.81);
    dCreatePlane(space, 0, 0, 1, 0);
    for (i = 0; i < kBodies; ++i) {
        const int tower = boxes ? i / 4 : i, floor = boxes ? i % 4 : 0;
        dGeomID geom =
            boxes ? dCreateBox(space, (dReal)0.5, (dReal)0.5, (dReal)0.5) : dCreateSphere(space, (dReal)0.25);
        dMass mass;
        dMassSetBox(&mass, 1, (dReal)0.5, (dReal)0.5, (dReal)0.5);
        bodies[i] = dBodyCreate(world);
        dBodySetMass(bodies[i], &mass);
        dBodySetPosition(bodies[i], (dReal)(tower % 32), (dReal)(tower / 32), (dReal)(0.249 + 0.499 * floor));
        dGeomSetBody(geom, bodies[i]);
    }
    for (i = 0; i < steps; ++i) one_step(exact);
    printf("%d contacts %g\n", met, seen);
    dWorldDestroy(world);
    dSpaceDestroy(space);
    dJointGroupDestroy(contacts);
    dCloseODE();
    return met < kBodies;
}
