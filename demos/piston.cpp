// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Crank and piston: a motor turns the crank, a rod of hinges drives a piston joint to and fro by twice the
// crank.
#include <cmath>

#include "stage.h"

constexpr double kCrank = 0.3, kRod = 0.9;
static dGeomID crank, rod, head;
static dJointID motor, pin, wrist, piston;
static double least = 1e9, largest = -1e9;

static dJointID hinge(dGeomID a, dGeomID b, double x)
{
    const dJointID joint = dJointCreateHinge(demo::world, nullptr);
    dJointAttach(joint, demo::body(a), b ? demo::body(b) : nullptr);
    dJointSetHingeAnchor(joint, x, 0, 1);
    dJointSetHingeAxis(joint, 0, 1, 0);
    return joint;
}

static void build()
{
    crank = demo::box(kCrank / 2, 0, 1, kCrank + 0.1, 0.1, 0.1);
    rod = demo::box(kCrank + kRod / 2, 0.12, 1, kRod + 0.08, 0.06, 0.06);
    demo::paint(head = demo::cylinder(kCrank + kRod, 0, 1, 0.2, 0.25), 0.75f, 0.75f, 0.78f);
    dMatrix3 along;
    dRFromAxisAndAngle(along, 0, 1, 0, M_PI / 2);
    dBodySetRotation(demo::body(head), along);
    motor = hinge(crank, nullptr, 0);
    dJointSetHingeParam(motor, dParamVel, 4);
    dJointSetHingeParam(motor, dParamFMax, 2000);
    pin = hinge(rod, crank, kCrank);
    wrist = hinge(head, rod, kCrank + kRod);
    piston = dJointCreatePiston(demo::world, nullptr);
    dJointAttach(piston, demo::body(head), nullptr);
    dJointSetPistonAnchor(piston, kCrank + kRod, 0, 1);
    dJointSetPistonAxis(piston, 1, 0, 0);
}

static void watch(double)
{
    const double x = demo::place(head)[0];
    least = std::fmin(least, x);
    largest = std::fmax(largest, x);
}

static void judge()
{
    demo::claim(demo::near(largest, kRod + kCrank, 0.005), "it came out to %g m", largest);
    demo::claim(demo::near(least, kRod - kCrank, 0.01), "it came in to %g m", least);
    const dReal* p = demo::place(head);
    demo::claim(std::hypot(p[1], p[2] - 1) < 0.002, "it left its way by %g m", std::hypot(p[1], p[2] - 1));
    demo::claim(demo::near(dJointGetHingeAngleRate(motor), 4, 0.05), "the motor turns at %g",
                dJointGetHingeAngleRate(motor));
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{0.6f, -2.4f, 1.7f}, {90, -16, 0}, 4, build, judge, watch});
}
