// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints: axes of any length, joints from the world to a body, momentum, stops.
#include "difference.h"

namespace differences {
namespace {

// Speed of correction in one step of a hinge to the world whose body is out of line by 0.01 rad.
double correction(double length)
{
    const World world;
    const dBodyID b = world.body();
    const dJointID hinge = attached(dJointCreateHinge(world.id, nullptr), b, nullptr);
    dJointSetHingeAnchor(hinge, 0, 0, 0);
    dJointSetHingeAxis(hinge, 0, 0, length);
    dMatrix3 R;
    dRFromAxisAndAngle(R, 1, 0, 0, 0.01);
    dBodySetRotation(b, R);
    world.step();
    return size(dBodyGetAngularVel(b));
}

DIFFERENCE(D8, length, "a hinge's axis to the world corrects alike, however long it was given")
{
    note("unit", correction(1)), note("four", correction(4));
    return near(correction(1), correction(4), 1e-9);
}

DIFFERENCE(D13, offsets, "both offsets of a universal joint to the world are the angles it then has")
{
    const World world;
    const dJointID j = attached(dJointCreateUniversal(world.id, nullptr), nullptr, world.body());
    dJointSetUniversalAnchor(j, 0, 0, 0);
    dJointSetUniversalAxis2(j, 0, 1, 0);
    dJointSetUniversalAxis1Offset(j, 1, 0, 0, 0.3, 0.2);
    note("angle1", dJointGetUniversalAngle1(j)), note("angle2", dJointGetUniversalAngle2(j));
    return near(dJointGetUniversalAngle1(j), 0.3, 1e-6) && near(dJointGetUniversalAngle2(j), 0.2, 1e-6);
}

DIFFERENCE(D17, removed_stop, "a stop taken away at its hinge holds it no more")
{
    const World world;
    const dBodyID b = world.body();
    const dJointID hinge = attached(dJointCreateHinge(world.id, nullptr), b, nullptr);
    dJointSetHingeAxis(hinge, 0, 0, 1);
    dJointSetHingeParam(hinge, dParamHiStop, -0.1);
    dJointSetHingeParam(hinge, dParamFMax, 0.1);
    world.step();
    dJointSetHingeParam(hinge, dParamHiStop, dInfinity);
    dBodySetAngularVel(b, 0, 0, 0);
    world.step(5);
    note("rate", dBodyGetAngularVel(b)[2]);
    return std::fabs(dBodyGetAngularVel(b)[2]) < 1e-6;
}

DIFFERENCE(D33, euler_stops, "stops of an Euler motor from the world to a body keep the body within them")
{
    const World world;
    const dBodyID b = world.body();
    const dJointID motor = attached(dJointCreateAMotor(world.id, nullptr), nullptr, b);
    dJointSetAMotorMode(motor, dAMotorEuler);
    dJointSetAMotorAxis(motor, 0, 1, 1, 0, 0);
    dJointSetAMotorAxis(motor, 2, 2, 0, 0, 1);
    dJointSetAMotorParam(motor, dParamLoStop3, -0.2);
    dJointSetAMotorParam(motor, dParamHiStop3, 0.2);
    dMatrix3 R;
    dRFromAxisAndAngle(R, 0, 0, 1, 0.4);
    dBodySetRotation(b, R);
    world.step(300);
    const double turned = std::atan2(dBodyGetRotation(b)[4], dBodyGetRotation(b)[0]);
    note("turned", turned), note("rate", size(dBodyGetAngularVel(b)));
    return std::fabs(turned) < 0.25;
}

DIFFERENCE(D51, gimbal_lock,
           "stops of Euler angles near gimbal lock give a body no more than ERP asks of each")
{
    const World world;
    const dBodyID b = world.body();
    const dJointID motor = attached(dJointCreateAMotor(world.id, nullptr), b, nullptr);
    dJointSetAMotorMode(motor, dAMotorEuler);
    dJointSetAMotorAxis(motor, 0, 1, 1, 0, 0);
    dJointSetAMotorAxis(motor, 2, 2, 0, 0, 1);
    for (const int group : {0, int(dParamGroup3)}) {
        dJointSetAMotorParam(motor, dParamLoStop + group, -0.5);
        dJointSetAMotorParam(motor, dParamHiStop + group, 0.5);
    }
    double fastest = 0;
    for (const double x : {-1.0, -0.7, 0.7, 1.0})
        for (const double z : {-1.0, -0.7, 0.7, 1.0}) {
            dMatrix3 X, Y, Z, YX, R;
            dRFromAxisAndAngle(X, 1, 0, 0, x), dRFromAxisAndAngle(Y, 0, 1, 0, 1.57);
            dRFromAxisAndAngle(Z, 0, 0, 1, z);
            dMultiply0(YX, Y, X, 3, 3, 3), dMultiply0(R, Z, YX, 3, 3, 3);
            dBodySetRotation(b, R), dBodySetAngularVel(b, 0, 0, 0);
            world.step();
            fastest = std::fmax(fastest, size(dBodyGetAngularVel(b)));
        }
    note("fastest", fastest);
    return fastest < 2 * 2 * 0.2 * (3.15 - 0.5) / kStep;
}

bool stays_together(dJointID joint, const World& world, dBodyID b)
{
    static_cast<void>(joint);
    double fastest = 0;
    for (int i = 0; i < 200; ++i) {
        world.step();
        fastest = std::fmax(fastest, size(dBodyGetLinearVel(b)));
    }
    note("fastest", fastest);
    return fastest < 3;
}

DIFFERENCE(D10, pr, "a PR joint from the world to a body holds it though it is off its anchor")
{
    const World world;
    const dBodyID b = world.body();
    const dJointID j = attached(dJointCreatePR(world.id, nullptr), nullptr, b);
    dJointSetPRAnchor(j, 0, 0, 0.5);
    dJointSetPRAxis1(j, 1, 0, 0);
    dJointSetPRAxis2(j, 0, 0, 1);
    dBodySetPosition(b, 0, 0.1, 0);
    return stays_together(j, world, b);
}

DIFFERENCE(D10, piston, "a piston from the world to a body holds it though it is off its line")
{
    const World world;
    const dBodyID b = world.body();
    const dJointID j = attached(dJointCreatePiston(world.id, nullptr), nullptr, b);
    dJointSetPistonAnchor(j, 0.5, 0, 0);
    dJointSetPistonAxis(j, 1, 0, 0);
    dBodySetPosition(b, 0, 0.1, 0);
    return stays_together(j, world, b);
}

DIFFERENCE(D11, slide, "the slide of a PU joint from the world to a turned body is the body's")
{
    const World world;
    const dBodyID b = world.body();
    dMatrix3 R;
    dRFromAxisAndAngle(R, 0, 0, 1, 1.0);
    dBodySetRotation(b, R);
    const dJointID j = attached(dJointCreatePU(world.id, nullptr), nullptr, b);
    dJointSetPUAnchor(j, 0, 0, 0);
    dJointSetPUAxis1(j, 0, 1, 0);
    dJointSetPUAxis2(j, 0, 0, 1);
    dJointSetPUAxis3(j, 1, 0, 0);
    for (int i = 0; i < 20; ++i) {
        dBodyAddForce(b, 1, 0, 0);
        world.step();
    }
    note("speed", dBodyGetLinearVel(b)[0]), note("aside", dBodyGetLinearVel(b)[1]);
    return near(dBodyGetLinearVel(b)[0], 0.2, 1e-6);
}

DIFFERENCE(D12, to_world, "a piston's force moves a body that is attached as the second")
{
    const World world;
    const dBodyID b = world.body();
    const dJointID j = attached(dJointCreatePiston(world.id, nullptr), nullptr, b);
    dJointSetPistonAnchor(j, 0, 0, 0);
    dJointSetPistonAxis(j, 1, 0, 0);
    dJointAddPistonForce(j, 5);
    world.step();
    note("speed", dBodyGetLinearVel(b)[0]);
    return near(std::fabs(dBodyGetLinearVel(b)[0]), 0.05, 1e-6);
}

DIFFERENCE(D12, torques, "a piston's force between two bodies makes no angular momentum")
{
    const World world;
    const dBodyID a = world.body(0, 0, 0), b = world.body(1, 0.6, 0);
    const dJointID j = attached(dJointCreatePiston(world.id, nullptr), a, b);
    dJointSetPistonAnchor(j, 0.2, 0.3, 0);
    dJointSetPistonAxis(j, 1, 0, 0);
    for (int i = 0; i < 20; ++i) {
        dJointAddPistonForce(j, 5);
        world.step();
    }
    double sum[3];
    note("momentum", angular_momentum(a, b, sum));
    return angular_momentum(a, b, sum) < 1e-3;
}

DIFFERENCE(D34, momentum, "a PR joint out of line between two bodies makes no angular momentum")
{
    const World world;
    const dBodyID a = world.body(0, 0, 0), b = world.body(1, 0, 0);
    const dJointID j = attached(dJointCreatePR(world.id, nullptr), a, b);
    dJointSetPRAnchor(j, 1, 0.5, 0.3);
    dJointSetPRAxis1(j, 1, 0, 0);
    dJointSetPRAxis2(j, 0, 0, 1);
    dMatrix3 R;
    dRFromAxisAndAngle(R, 0, 1, 0, 0.3);
    dBodySetRotation(b, R);
    dBodySetPosition(b, 1, 0.1, 0.1);
    world.step();
    double sum[3];
    note("momentum", angular_momentum(a, b, sum));
    return angular_momentum(a, b, sum) < 1e-9;
}

DIFFERENCE(D35, momentum, "a PU joint drawn out between two bodies makes no angular momentum")
{
    const World world;
    const dBodyID a = world.body(0, 0, 0), b = world.body(1, 0, 0);
    const dJointID j = attached(dJointCreatePU(world.id, nullptr), a, b);
    dJointSetPUAnchor(j, 0.5, 0, 0);
    dJointSetPUAxis1(j, 0, 1, 0);
    dJointSetPUAxis2(j, 0, 0, 1);
    dJointSetPUAxis3(j, 1, 0, 0);
    dBodySetPosition(b, 2, 0.2, 0.1);
    world.step();
    double sum[3];
    note("momentum", angular_momentum(a, b, sum));
    return angular_momentum(a, b, sum) < 1e-9;
}

// A pair at rest whose joint, of any of these types, has come apart; the angular momentum after a step.
double momentum_with_anchors_apart(dJointID (*create)(dWorldID, dJointGroupID))
{
    const World world;
    const dBodyID a = world.body(0, 0, 0), b = world.body(1, 0, 0);
    const dJointID j = attached(create(world.id, nullptr), a, b);
    if (create == dJointCreateBall) dJointSetBallAnchor(j, 0.5, 0.1, 0);
    if (create == dJointCreateHinge) dJointSetHingeAnchor(j, 0.5, 0.1, 0);
    if (create == dJointCreateUniversal) dJointSetUniversalAnchor(j, 0.5, 0.1, 0);
    if (create == dJointCreateHinge2) dJointSetHinge2Anchor(j, 0.5, 0.1, 0);
    if (create == dJointCreateFixed) dJointSetFixed(j);
    dBodySetPosition(b, 1.03, 0.05, -0.04);
    world.step();
    double sum[3];
    return angular_momentum(a, b, sum);
}

DIFFERENCE(D48, momentum, "joints that have come apart make no angular momentum")
{
    double largest = 0;
    for (auto create :
         {dJointCreateBall, dJointCreateHinge, dJointCreateUniversal, dJointCreateHinge2, dJointCreateFixed})
        largest = std::max(largest, momentum_with_anchors_apart(create));
    note("momentum", largest);
    return largest < 1e-9;
}

DIFFERENCE(D40, sideways, "a PR joint whose axes are not perpendicular still holds its body")
{
    const World world;
    const dBodyID b = world.body(0, 0, 0);
    const dJointID j = attached(dJointCreatePR(world.id, nullptr), b, nullptr);
    dJointSetPRAnchor(j, 0, 0, 0);
    dJointSetPRAxis1(j, 1, 0, 0.6);
    dJointSetPRAxis2(j, 0, 0, 1);
    for (int i = 0; i < 50; ++i) {
        dBodyAddForce(b, 0, 3, 2);
        dBodyAddTorque(b, 0.2, 0.3, 0);
        world.step();
    }
    const dReal *p = dBodyGetPosition(b), *w = dBodyGetAngularVel(b);
    note("y", p[1]), note("z - 0.6 x", p[2] - 0.6 * p[0]), note("wx", w[0]), note("wy", w[1]);
    return std::fabs(p[2] - 0.6 * p[0]) < 1e-3 && std::hypot(w[0], w[1]) < 1e-3;
}

DIFFERENCE(D41, axis, "a double hinge without an axis keeps its bodies' numbers finite")
{
    const World world;
    const dBodyID a = world.body(0, 0, 0), b = world.body(1, 0, 0);
    const dJointID j = attached(dJointCreateDHinge(world.id, nullptr), a, b);
    dJointSetDHingeAnchor1(j, 0, 0, 0);
    dJointSetDHingeAnchor2(j, 1, 0, 0);
    dBodySetLinearVel(b, 0, 1, 0);
    world.step(50);
    double d[3];
    for (int k = 0; k < 3; ++k) d[k] = dBodyGetPosition(b)[k] - dBodyGetPosition(a)[k];
    note("distance", size(d));
    return near(size(d), 1, 0.01);
}

DIFFERENCE(D45, stop, "the stop of a PR joint's slide adds no energy to a body that swings off the slide")
{
    const World world;
    const dBodyID b = world.body(0.2, 0, -0.4);
    dWorldSetGravity(world.id, 2, 0, -9.81);
    const dJointID j = attached(dJointCreatePR(world.id, nullptr), b, nullptr);
    dJointSetPRAnchor(j, 0, 0, 0);
    dJointSetPRAxis1(j, 1, 0, 0);
    dJointSetPRAxis2(j, 0, 1, 0);
    dJointSetPRParam(j, dParamLoStop, -0.3);
    dJointSetPRParam(j, dParamHiStop, 0.3);
    double fastest = 0;
    for (int i = 0; i < 1000; ++i) {
        world.step();
        fastest = std::fmax(fastest, size(dBodyGetLinearVel(b)));
    }
    note("fastest", fastest);
    return fastest < 10;
}

// The largest rate of a hinge with a motor of 2 rad/s that turns to one of its stops.
double fastest_turn(double low, double high, double step, double speed)
{
    const World world;
    const dBodyID b = world.body(0, 0, 0);
    const dJointID j = attached(dJointCreateHinge(world.id, nullptr), b, nullptr);
    dJointSetHingeAnchor(j, 0, 0, 0);
    dJointSetHingeAxis(j, 0, 0, 1);
    dJointSetHingeParam(j, dParamLoStop, low), dJointSetHingeParam(j, dParamHiStop, high);
    dJointSetHingeParam(j, dParamVel, speed), dJointSetHingeParam(j, dParamFMax, 5);
    double fastest = 0, turned = 0;
    for (int i = 0; i < 1500; ++i) {
        dWorldStep(world.id, step);
        const double rate = dBodyGetAngularVel(b)[2];
        fastest = std::fmax(fastest, std::fabs(rate)), turned += rate * step;
    }
    note("turned", turned);
    return turned < high + 0.1 ? fastest : HUGE_VAL;
}

DIFFERENCE(D47, far, "a hinge with a stop at 270 degrees turns to it and rests")
{
    const double fastest = fastest_turn(-0.1, 4.712, 0.01, 2);
    note("fastest", fastest);
    return fastest < 2.1;
}

DIFFERENCE(D47, gap, "a hinge whose step is longer than the gap between its stops does not go round")
{
    const double fastest = fastest_turn(-3.1, 3.1, 0.032, 5);
    note("fastest", fastest);
    return fastest < 5.1;
}

// The rate at which a stop throws back a hinge that begins 0.25 rad beyond it, in a world that corrects at 1 m/s at most.
DIFFERENCE(D52, thrown_back,
           "what is beyond its stop is brought back without a speed where corrections are bounded")
{
    const World world;
    const dBodyID b = world.body(0, 0, 0);
    dWorldSetContactMaxCorrectingVel(world.id, 1);
    const dJointID j = attached(dJointCreateHinge(world.id, nullptr), b, nullptr);
    dJointSetHingeAnchor(j, 0, 0, 0);
    dJointSetHingeAxis(j, 0, 0, 1);
    dJointSetHingeParam(j, dParamHiStop, -0.25);
    double fastest = 0;
    for (int i = 0; i < 400; ++i) {
        dWorldStep(world.id, 0.001);
        fastest = std::fmax(fastest, std::fabs(dBodyGetAngularVel(b)[2]));
    }
    note("fastest", fastest), note("angle", dJointGetHingeAngle(j));
    return fastest < 0.05 && std::fabs(dJointGetHingeAngle(j) + 0.25) < 0.01;
}

DIFFERENCE(D42, linear, "a fourth group of a linear motor's parameters is none of its axes")
{
    const World world;
    const dJointID j = attached(dJointCreateLMotor(world.id, nullptr), world.body(), nullptr);
    dJointSetLMotorNumAxes(j, 3);
    dJointSetLMotorParam(j, dParamVel3, 1);
    dJointSetLMotorParam(j, dParamVel + 3 * dParamGroup, 7);
    note("third", dJointGetLMotorParam(j, dParamVel3));
    return dJointGetLMotorParam(j, dParamVel3) == 1;
}

DIFFERENCE(D42, angular, "a fourth group of an angular motor's parameters does not end the program")
{
    const World world;
    const dJointID j = attached(dJointCreateAMotor(world.id, nullptr), world.body(), nullptr);
    dJointSetAMotorParam(j, dParamVel + 3 * dParamGroup, 7);
    return true;
}

}  // namespace
}  // namespace differences
