/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * The pieces of the 0.039 guide in one program, by its names: a world with gravity, ERP and CFM; masses; a space
 * with a plane; near callback, contact joints in a group, bounce and friction; a hinge with motor, stop and
 * feedback; a chain link on a ball joint; dWorldStep first, dWorldStepFast1 after it.
 */
#include <math.h>
#include <stdio.h>

#include <ode/ode.h>

#define STEP REAL(0.01)
#define MAX_CONTACTS 4

static dWorldID world;
static dSpaceID space;
static dJointGroupID contacts;
static int wrong;

static void expect(const char* what, double value, double wanted, double tolerance)
{
    const int good = fabs(value - wanted) <= tolerance;
    printf("guide: %s is %.6g, wanted %.6g +- %g%s\n", what, value, wanted, tolerance, good ? "" : "  WRONG");
    if (!good) wrong = 1;
}

static void nearCallback(void* data, dGeomID o1, dGeomID o2)
{
    dContact contact[MAX_CONTACTS];
    int i, n = dCollide(o1, o2, MAX_CONTACTS, &contact[0].geom, sizeof(dContact));
    (void)data;
    for (i = 0; i < n; i++) {
        contact[i].surface.mode = dContactBounce | dContactApprox1;
        contact[i].surface.mu = 1;
        contact[i].surface.bounce = REAL(0.2);
        contact[i].surface.bounce_vel = REAL(0.5);
        dJointAttach(dJointCreateContact(world, contacts, &contact[i]), dGeomGetBody(o1), dGeomGetBody(o2));
    }
}

static dBodyID createBox(dReal mass, dReal lx, dReal ly, dReal lz, dReal x, dReal y, dReal z)
{
    dMass m;
    dBodyID body = dBodyCreate(world);
    dMassSetBox(&m, mass / (lx * ly * lz), lx, ly, lz);
    dBodySetMass(body, &m);
    dBodySetPosition(body, x, y, z);
    return body;
}

static void simulate(int steps, int fast)
{
    int i;
    for (i = 0; i < steps; i++) {
        dSpaceCollide(space, 0, &nearCallback);
        if (fast)
            dWorldStepFast1(world, STEP, 10);
        else
            dWorldStep(world, STEP);
        dJointGroupEmpty(contacts);
    }
}

int main(void)
{
    dBodyID box, door, link;
    dJointID hinge, ball;
    dJointFeedback feedback;
    dVector3 anchor, anchor2;
    int fast;

    world = dWorldCreate();
    space = dSimpleSpaceCreate(0);
    contacts = dJointGroupCreate(0);
    dWorldSetGravity(world, 0, 0, REAL(-9.81));
    dWorldSetERP(world, REAL(0.2));
    dWorldSetCFM(world, REAL(1e-6));
    dCreatePlane(space, 0, 0, 1, 0);

    box = createBox(1, 1, 1, REAL(0.5), 0, 0, 2);
    dGeomSetBody(dCreateBox(space, 1, 1, REAL(0.5)), box);
    dBodySetLinearVel(box, 1, 0, 0);

    door = createBox(3, 1, REAL(0.1), 2, 5, 0, 4);
    hinge = dJointCreateHinge(world, 0);
    dJointAttach(hinge, door, 0);
    dJointSetHingeAnchor(hinge, REAL(4.5), 0, 4);
    dJointSetHingeAxis(hinge, 0, 0, 1);
    dJointSetHingeParam(hinge, dParamHiStop, REAL(0.75));
    dJointSetHingeParam(hinge, dParamVel, 1);
    dJointSetHingeParam(hinge, dParamFMax, 20);
    dJointSetFeedback(hinge, &feedback);

    link = createBox(1, REAL(0.1), REAL(0.1), 1, 10, 0, 4);
    ball = dJointCreateBall(world, 0);
    dJointAttach(ball, link, 0);
    dJointSetBallAnchor(ball, 10, 0, REAL(4.5));
    dBodySetAngularVel(link, 1, 2, REAL(0.5));

    for (fast = 0; fast < 2; fast++) {
        simulate(300, fast);
        expect("height of the box", dBodyGetPosition(box)[2], 0.25, 2e-3);
        expect("speed of the box", dBodyGetLinearVel(box)[0], 0, 1e-3);
        expect("upright", dBodyGetRotation(box)[10], 1, 1e-4);
        expect("angle of the door", fabs(dJointGetHingeAngle(hinge)), 0.75, 5e-3);
        expect("weight on the hinge", feedback.f1[2], 3 * 9.81, 0.05);
        dJointGetBallAnchor(ball, anchor);
        dJointGetBallAnchor2(ball, anchor2);
        expect("gap of the ball joint", anchor[0] - anchor2[0] + anchor[1] - anchor2[1] + anchor[2] - anchor2[2], 0, 5e-3);
    }

    dJointGroupDestroy(contacts);
    dSpaceDestroy(space);
    dWorldDestroy(world);
    dCloseODE();
    return wrong;
}
