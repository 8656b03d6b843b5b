// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies and steps: rotations, contacts, solvers, bad numbers.
#include <limits>
#include <vector>

#include "difference.h"

namespace differences {
namespace {

DIFFERENCE(D1, rotation, "a matrix that is not orthogonal leaves a body with a rotation")
{
    const World world;
    const dBodyID b = world.body();
    const dMatrix3 skew = {1, 0.3, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    dBodySetRotation(b, skew);
    const dReal* R = dBodyGetRotation(b);
    const double slant = R[0] * R[4] + R[1] * R[5] + R[2] * R[6];
    note("row 0 . row 1", slant);
    return near(slant, 0, 1e-9);
}

DIFFERENCE(D2, finite, "a ball that spins about two axes turns as far in finite rotation as its speed says")
{
    const World world;
    const dBodyID b = world.body();
    dBodySetFiniteRotationMode(b, 1);
    dBodySetFiniteRotationAxis(b, 0, 0, 1);
    dBodySetAngularVel(b, 1, 0, 1e-6);
    world.step(100);
    const double turned = 2 * std::acos(std::fabs(dBodyGetQuaternion(b)[0]));
    note("turned", turned);
    return near(turned, 1, 0.01);
}

double spin_after(int mode, double rho)
{
    const World world;
    const dBodyID b = world.body(0, 0, 1);
    dWorldSetGravity(world.id, 0, 0, -10);
    dWorldSetCFM(world.id, 0);
    dBodySetAngularVel(b, 0, 0, 3);
    const dJointGroupID group = dJointGroupCreate(0);
    for (int i = 0; i < 20; ++i) {
        dContact contact = {};
        contact.surface.mode = mode;
        contact.surface.mu = 0.5;
        contact.surface.rho = contact.surface.rho2 = contact.surface.rhoN = rho;
        contact.geom.normal[2] = 1;
        contact.geom.depth = 1e-4;
        attached(dJointCreateContact(world.id, group, &contact), b, nullptr);
        world.step();
        dJointGroupEmpty(group);
    }
    return size(dBodyGetAngularVel(b)) + 1000 * std::fabs(dBodyGetLinearVel(b)[2]);
}

DIFFERENCE(D18, rolling, "rolling friction of zero is that of no rolling friction")
{
    note("without", spin_after(dContactApprox1, 0));
    note("zero", spin_after(dContactApprox1 | dContactRolling, 0));
    return near(spin_after(dContactApprox1, 0), spin_after(dContactApprox1 | dContactRolling, 0), 1e-6);
}

// ---- a pile that begins exactly touching ----

int g_messages = 0;
void count_message(int, const char*, va_list) { ++g_messages; }

struct Pile {
    World world;
    dSpaceID space = dHashSpaceCreate(nullptr);
    dJointGroupID group = dJointGroupCreate(0);
    std::vector<dBodyID> bodies;

    Pile()
    {
        dWorldSetGravity(world.id, 0, 0, -10);
        dCreatePlane(space, 0, 0, 1, 0);
    }
    void box(double x, double y, double z)
    {
        const dBodyID b = world.body(x, y, z);
        dGeomSetBody(dCreateBox(space, 1, 1, 1), b);
        bodies.push_back(b);
    }
    static void touch(void* self, dGeomID a, dGeomID b)
    {
        Pile& pile = *static_cast<Pile*>(self);
        dContact contact[8] = {};
        const int count = dCollide(a, b, 8, &contact[0].geom, sizeof(dContact));
        for (int i = 0; i < count; ++i) {
            contact[i].surface.mode = dContactApprox1;
            contact[i].surface.mu = 0.5;
            attached(dJointCreateContact(pile.world.id, pile.group, &contact[i]), dGeomGetBody(a),
                     dGeomGetBody(b));
        }
    }
    void step(int count, int (*how)(dWorldID, dReal))
    {
        for (int i = 0; i < count; ++i) {
            dSpaceCollide(space, this, &touch);
            how(world.id, kStep);
            dJointGroupEmpty(group);
        }
    }
};

DIFFERENCE(D30, touching, "boxes stacked exactly touching are solved, and nothing is said")
{
    g_messages = 0;
    dSetMessageHandler(&count_message);
    dSetErrorHandler(&count_message);
    Pile pile;
    for (int x = 0; x < 3; ++x)
        for (int z = 0; z < 4; ++z) pile.box(x, 0, z + 0.5);
    dWorldSetCFM(pile.world.id, 0);
    pile.step(60, &dWorldStep);
    note("messages", g_messages);
    return g_messages == 0;
}

DIFFERENCE(D43, samples, "another number of samples of automatic sleep is another buffer")
{
    const World world;
    dWorldSetAutoDisableFlag(world.id, 1);
    dWorldSetAutoDisableAverageSamplesCount(world.id, 2);
    std::vector<dBodyID> bodies;
    for (int i = 0; i < 200; ++i) bodies.push_back(world.body(i, 0, 0));
    for (int i = 0; i < 200; i += 2) attached(dJointCreateBall(world.id, nullptr), bodies[i], bodies[i + 1]);
    dWorldSetAutoDisableAverageSamplesCount(world.id, 2000);
    for (const dBodyID b : bodies) {
        dBodySetAutoDisableDefaults(b);
        dBodySetLinearVel(b, 1, 2, 3);
    }
    world.step(1000);
    for (const dBodyID b : bodies) {
        if (!near(dBodyGetPosition(b)[1], 20, 1e-6)) return false;
        dBodyDestroy(b);
    }
    return true;
}

DIFFERENCE(P2, slider, "a slow body keeps its speed while what is joined to it moves")
{
    const World world;
    const dBodyID slow = world.body(), fast = world.body(1, 0, 0);
    const dJointID slider = dJointCreateSlider(world.id, nullptr);
    attached(slider, slow, fast);
    dJointSetSliderAxis(slider, 1, 0, 0);
    for (const dBodyID b : {slow, fast}) {
        dBodySetAutoDisableFlag(b, 1);
        dBodySetAutoDisableSteps(b, 2);
        dBodySetAutoDisableTime(b, 0);
    }
    dBodySetLinearVel(slow, 0.005, 0, 0);
    dBodySetLinearVel(fast, 1, 0, 0);
    world.step(20);
    note("speed", dBodyGetLinearVel(slow)[0]);
    return near(dBodyGetLinearVel(slow)[0], 0.005, 1e-9);
}

DIFFERENCE(P4, wind, "a body that has slept in the wind wakes with the wind of one step")
{
    const World world;
    const dBodyID b = world.body();
    dBodyDisable(b);
    for (int i = 0; i < 100; ++i) {
        dBodyAddForce(b, 1, 0, 0);
        world.step(1);
    }
    dBodyEnable(b);
    dBodyAddForce(b, 1, 0, 0);
    world.step(1);
    note("speed", dBodyGetLinearVel(b)[0]);
    return near(dBodyGetLinearVel(b)[0], kStep, 1e-9);
}

DIFFERENCE(D49, top, "a body that tumbles in empty space keeps its energy")
{
    const World world;
    const dBodyID b = world.body();
    dMass mass;
    dMassSetParameters(&mass, 1, 0, 0, 0, 1, 2, 2.8, 0, 0, 0);
    dBodySetMass(b, &mass);
    dBodySetAngularVel(b, 0.01, 5, 0.01);
    const auto energy = [&] {
        dVector3 w;
        const dReal* v = dBodyGetAngularVel(b);
        dBodyVectorFromWorld(b, v[0], v[1], v[2], w);
        return 0.5 * (w[0] * w[0] + 2 * w[1] * w[1] + 2.8 * w[2] * w[2]);
    };
    const double before = energy();
    world.step(10000);
    note("share of the energy", energy() / before);
    return near(energy() / before, 1, 1e-6);
}

DIFFERENCE(E1, nan, "a position that is no number is refused")
{
    const World world;
    const dBodyID b = world.body(1, 2, 3);
    dBodySetPosition(b, std::numeric_limits<double>::quiet_NaN(), 0, 0);
    return dBodyGetPosition(b)[0] == 1;
}

DIFFERENCE(E2, abort, "a bad argument does not end the program")
{
    const World world;
    dMass mass;
    dMassSetZero(&mass);
    dBodySetMass(world.body(), &mass);
    return true;
}

DIFFERENCE(P1, random, "what else draws random numbers does not change dWorldQuickStep")
{
    double height[2];
    for (int k = 0; k < 2; ++k) {
        dRandSetSeed(k ? 12345 : 1);
        Pile pile;
        for (int z = 0; z < 6; ++z) pile.box(0.2 * z, 0.1 * z, z + 0.5);
        pile.step(100, &dWorldQuickStep);
        height[k] = dBodyGetPosition(pile.bodies[5])[2];
        note("height", height[k]);
    }
    return height[0] == height[1];
}

DIFFERENCE(P3, infinite, "an infinite motor at its own stop leaves numbers")
{
    const World world;
    const dBodyID b = world.body();
    const dJointID hinge = attached(dJointCreateHinge(world.id, nullptr), b, nullptr);
    dJointSetHingeAxis(hinge, 0, 0, 1);
    dJointSetHingeParam(hinge, dParamHiStop, 0.1);
    dJointSetHingeParam(hinge, dParamVel, 1);
    dJointSetHingeParam(hinge, dParamFMax, dInfinity);
    world.step(50);
    note("angle", dJointGetHingeAngle(hinge));
    return near(dJointGetHingeAngle(hinge), 0.1, 0.02);
}

DIFFERENCE(J1, axes, "a hinge-2's axes may be set one after the other")
{
    const World world;
    const dJointID j = attached(dJointCreateHinge2(world.id, nullptr), world.body(), world.body(1, 0, 0));
    dJointSetHinge2Axis1(j, 0, 1, 0);
    dJointSetHinge2Axis2(j, 0, 0, 1);
    dVector3 axis;
    dJointGetHinge2Axis2(j, axis);
    return near(axis[2], 1, 1e-9);
}

DIFFERENCE(J2, ratio, "a transmission's ratio of zero is refused and the program goes on")
{
    const World world;
    const dJointID j =
        attached(dJointCreateTransmission(world.id, nullptr), world.body(), world.body(1, 0, 0));
    dJointSetTransmissionMode(j, dTransmissionParallelAxes);
    dJointSetTransmissionRatio(j, 0);
    return dJointGetTransmissionRatio(j) > 0;
}

DIFFERENCE(J3, apart, "wheels that cannot touch exert nothing and the program goes on")
{
    const World world;
    const dBodyID a = world.body(), b = world.body(0, 0, 1);
    const dJointID j = attached(dJointCreateTransmission(world.id, nullptr), a, b);
    dJointSetTransmissionMode(j, dTransmissionIntersectingAxes);
    dJointSetTransmissionAxis1(j, 0, 0, 1);
    dJointSetTransmissionAxis2(j, 0, 0, 1);
    dJointSetTransmissionAnchor1(j, 0, 0, 0);
    dJointSetTransmissionAnchor2(j, 2, 0, 1);
    dBodySetAngularVel(a, 0, 0, 1);
    world.step(5);
    return near(dBodyGetAngularVel(a)[2], 1, 1e-9);
}

}  // namespace
}  // namespace differences
