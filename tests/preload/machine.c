/* SPDX-License-Identifier: BSD-3-Clause
   Copyright (c) 2026 The Epode authors

   A program to be captured and run again: every joint type with parameters that change on the way, forces, bodies and
   joints that come and go, geoms that take their bodies along, contacts with every kind of surface, every stepper of the
   library. `machine space` lets the world find its contacts, which no recording can do again; so does `machine shove`,
   with a moved callback that adds forces in the middle of steps. `machine watch` has one that only reads. */
#include <ode/ext.h>
#include <ode/ode.h>
#include <stdio.h>
#include <string.h>

static dWorldID world;
static dSpaceID space;
static dJointGroupID contacts;
static int steps = 0;

static void near_callback(void* data, dGeomID a, dGeomID b)
{
    dContact contact[8];
    dBodyID first = dGeomGetBody(a), second = dGeomGetBody(b);
    int i, n;
    (void)data;
    if (first && second && dAreConnectedExcluding(first, second, dJointTypeContact)) return;
    memset(contact, 0, sizeof contact);
    n = dCollide(a, b, 8, &contact[0].geom, sizeof(dContact));
    for (i = 0; i < n; ++i) {
        dSurfaceParameters* surface = &contact[i].surface;
        surface->mu = i % 3 ? 0.5 : dInfinity;
        surface->mode = (steps / 5 + i) % 2
                            ? dContactApprox1 | dContactBounce | dContactSoftCFM | dContactRolling
                            : dContactApprox1_1 | dContactMu2 | dContactSoftERP | dContactSlip1;
        surface->mu2 = 0.3;
        surface->bounce = 0.1;
        surface->bounce_vel = 0.2;
        surface->soft_cfm = 1e-5;
        surface->soft_erp = 0.3;
        surface->rho = surface->rho2 = surface->rhoN = 0.01;
        surface->slip1 = 1e-4;
        dJointAttach(dJointCreateContact(world, contacts, &contact[i]), first, second);
    }
}

static dReal seen = 0;
static void watch(dBodyID body) { seen += dBodyGetPosition(body)[2] + dBodyGetLinearVel(body)[0]; }

static void shove(dBodyID body)
{
    dBodyAddForce(body, 0, 0, 0.1);
}

static dBodyID box_at(dReal x, dReal y, dReal z)
{
    dBodyID made = dBodyCreate(world);
    dMass mass;
    dMassSetBox(&mass, 2, 0.5, 0.4, 0.3);
    dBodySetMass(made, &mass);
    dBodySetPosition(made, x, y, z);
    dGeomSetBody(dCreateBox(space, 0.5, 0.4, 0.3), made);
    return made;
}

/* Two bodies and the joint between them, which is attached and not set up yet. */
static dJointID pair_with(dJointID joint, int place)
{
    dReal x = 2 * (place % 6), y = 3 * (place / 6);
    dJointAttach(joint, box_at(x, y, 2), box_at(x + 0.6, y, 2));
    return joint;
}

static void build(dJointGroupID kept)
{
    const dReal up[3] = {0, 0, 1}, across[3] = {0, 1, 0};
    int place = 0;
    dJointID joint = pair_with(dJointCreateBall(world, 0), place);
    dJointSetBallAnchor(joint, 0.3, 0, 2);
    joint = pair_with(dJointCreateHinge(world, kept), ++place);
    dJointSetHingeAnchor(joint, 2.3, 0, 2);
    dJointSetHingeAxis(joint, 0, 1, 0);
    dJointSetHingeParam(joint, dParamVel, 2);
    dJointSetHingeParam(joint, dParamFMax, 1);
    joint = pair_with(dJointCreateSlider(world, kept), ++place);
    dJointSetSliderAxis(joint, 1, 0, 0.2);
    dJointSetSliderParam(joint, dParamHiStop, 0.2);
    dJointSetSliderParam(joint, dParamLoStop, -0.2);
    joint = pair_with(dJointCreateUniversal(world, 0), ++place);
    dJointSetUniversalAnchor(joint, 6.3, 0, 2);
    dJointSetUniversalAxis1(joint, 0, 1, 0);
    dJointSetUniversalAxis2(joint, 0, 0, 1);
    dJointAddUniversalTorques(joint, 0.5, 0.1);
    joint = pair_with(dJointCreateHinge2(world, 0), ++place);
    dJointSetHinge2Anchor(joint, 8.6, 0, 2);
    dJointSetHinge2Axes(joint, up, across);
    dJointSetHinge2Param(joint, dParamVel2, 3);
    dJointSetHinge2Param(joint, dParamFMax2, 2);
    joint = pair_with(dJointCreateFixed(world, 0), ++place);
    dJointSetFixed(joint);
    joint = pair_with(dJointCreateAMotor(world, 0), ++place);
    dJointSetAMotorNumAxes(joint, 1);
    dJointSetAMotorAxis(joint, 0, 1, 0, 0, 1);
    dJointSetAMotorParam(joint, dParamVel, 1);
    dJointSetAMotorParam(joint, dParamFMax, 1);
    joint = pair_with(dJointCreateLMotor(world, 0), ++place);
    dJointSetLMotorNumAxes(joint, 1);
    dJointSetLMotorAxis(joint, 0, 0, 1, 0, 0);
    dJointSetLMotorParam(joint, dParamVel, 0.3);
    dJointSetLMotorParam(joint, dParamFMax, 2);
    joint = pair_with(dJointCreatePR(world, 0), ++place);
    dJointSetPRAnchor(joint, 4.3, 3, 2);
    dJointSetPRAxis1(joint, 1, 0, 0);
    dJointSetPRAxis2(joint, 0, 1, 0);
    joint = pair_with(dJointCreatePU(world, 0), ++place);
    dJointSetPUAnchor(joint, 6.3, 3, 2);
    dJointSetPUAxis1(joint, 0, 1, 0);
    dJointSetPUAxis2(joint, 0, 0, 1);
    joint = pair_with(dJointCreatePiston(world, 0), ++place);
    dJointSetPistonAnchor(joint, 8.3, 3, 2);
    dJointSetPistonAxis(joint, 1, 0, 0);
    dJointAddPistonForce(joint, 1);
    joint = pair_with(dJointCreateDBall(world, 0), ++place);
    dJointSetDBallAnchor1(joint, 10.1, 3, 2);
    dJointSetDBallAnchor2(joint, 10.5, 3, 2.1);
    joint = pair_with(dJointCreateDHinge(world, 0), ++place);
    dJointSetDHingeAxis(joint, 0, 1, 0);
    dJointSetDHingeAnchor1(joint, 0, 6, 2);
    dJointSetDHingeAnchor2(joint, 0.6, 6, 2);
    joint = pair_with(dJointCreateTransmission(world, 0), ++place);
    dJointSetTransmissionMode(joint, dTransmissionParallelAxes);
    dJointSetTransmissionAxis(joint, 0, 0, 1);
    dJointSetTransmissionAnchor1(joint, 2, 6, 2);
    dJointSetTransmissionAnchor2(joint, 2.6, 6, 2);
    dJointSetTransmissionRatio(joint, 2);
    pair_with(dJointCreateNull(world, 0), ++place);
    dJointAttach(dJointCreatePlane2D(world, 0), box_at(6, 6, 0), 0);
}

static void one_step(int i)
{
    dSpaceCollide(space, 0, near_callback);
    switch (i % 5) {
        case 0:
            dWorldStep(world, 0.01);
            break;
        case 1:
            dWorldQuickStep(world, 0.01);
            break;
        case 2:
            dWorldStepFast1(world, 0.01, 3);
            break;
        case 3:
            dWorldStepHybrid(world, 0.01);
            break;
        default:
            dWorldsStep(&world, 1, 0.005, dStepperQuick, 4, 2, 1, 0);
            break;
    }
    dJointGroupEmpty(contacts);
    ++steps;
}

int main(int argc, char** argv)
{
    const dQuaternion turn = {0.8, 0.6, 0, 0};
    dMatrix3 rotation;
    dJointGroupID kept;
    dBodyID loose, guest;
    dGeomID shell;
    int i;
    dInitODE2(0);
    world = dWorldCreate();
    space = dHashSpaceCreate(0);
    contacts = dJointGroupCreate(0);
    kept = dJointGroupCreate(0);
    dWorldSetGravity(world, 0, 0, -9.81);
    dWorldSetERP(world, 0.3);
    dWorldSetCFM(world, 1e-6);
    dWorldSetDamping(world, 0.001, 0.002);
    dWorldSetAutoDisableFlag(world, 1);
    dWorldSetQuickStepNumIterations(world, 15);
    dCreatePlane(space, 0, 0, 1, -0.5);
    build(kept);
    loose = box_at(-2, 0, 1);
    guest = box_at(-4, 0, 3);
    shell = dCreateSphere(space, 0.3);
    dGeomSetBody(shell, guest);
    dGeomSetOffsetPosition(shell, 0.4, 0, 0);
    dBodySetQuaternion(loose, turn);
    dBodySetAngularVel(guest, 0, 2, 1);
    if (argc > 1 && strcmp(argv[1], "space") == 0) dWorldSetContactSpace(world, space);
    if (argc > 1 && strcmp(argv[1], "watch") == 0) {
        dBodySetMovedCallback(loose, watch);
        dBodySetMovedCallback(guest, watch);
    }
    if (argc > 1 && strcmp(argv[1], "shove") == 0) dBodySetMovedCallback(loose, shove);
    for (i = 0; i < 100; ++i) {
        dBodyAddForceAtRelPos(loose, 0.2, 0, 0.1, 0, 0.1, 0);
        if (i == 20) dJointGroupEmpty(kept);
        if (i == 30) dGeomSetPosition(shell, -4, 1, 2);
        if (i == 40) dGeomSetPosition(dBodyGetFirstGeom(loose), -2, 0, 2);
        if (i == 50) {
            dRFromAxisAndAngle(rotation, 1, 0.2, 0, 0.7);
            dGeomSetRotation(dBodyGetFirstGeom(loose), rotation);
            dBodySetLinearVel(loose, 1, 0, 0);
        }
        if (i == 60) {
            dGeomDestroy(shell);
            dGeomDestroy(dBodyGetFirstGeom(guest));
            dBodyDestroy(guest);
            box_at(-4, 2, 1);
        }
        if (i == 70) dBodySetKinematic(loose);
        one_step(i);
    }
    printf("%.17g\n", (double)seen);
    dJointGroupDestroy(contacts);
    dJointGroupDestroy(kept);
    dSpaceDestroy(space);
    dWorldDestroy(world);
    dCloseODE();
    return 0;
}
