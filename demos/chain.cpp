// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A chain of ball joints, let go level, swings under the point that holds it: no joint opens, no energy is
// made.
#include <cmath>

#include "stage.h"

constexpr int kLinks = 12;
constexpr double kLength = 0.25;
static dGeomID links[kLinks];
static dJointID joints[kLinks];
static double highest = 0;

static double energy()
{
    double sum = 0;
    for (const dGeomID link : links) {
        const dReal *v = dBodyGetLinearVel(demo::body(link)), *w = dBodyGetAngularVel(demo::body(link));
        dMass mass;
        dBodyGetMass(demo::body(link), &mass);
        dVector3 spin, own;
        dBodyVectorFromWorld(demo::body(link), w[0], w[1], w[2], own);
        dMultiply0_331(spin, mass.I, own);
        sum += mass.mass * (0.5 * dCalcVectorDot3(v, v) + 9.81 * demo::place(link)[2]) +
               0.5 * dCalcVectorDot3(own, spin);
    }
    return sum;
}
static double at_first = 0;

static void build()
{
    dWorldSetERP(demo::world, 0.8);
    dMatrix3 level;
    dRFromAxisAndAngle(level, 0, 1, 0, M_PI / 2);
    for (int i = 0; i < kLinks; ++i) {
        links[i] = demo::capsule(kLength * (i + 0.5), 0, 3.3, 0.05, kLength - 0.1);
        dBodySetRotation(demo::body(links[i]), level);
        joints[i] = dJointCreateBall(demo::world, nullptr);
        dJointAttach(joints[i], demo::body(links[i]), i ? demo::body(links[i - 1]) : nullptr);
        dJointSetBallAnchor(joints[i], kLength * i, 0, 3.3);
    }
    at_first = energy();
}

static void watch(double) { highest = std::fmax(highest, energy()); }

static void judge()
{
    demo::claim(highest < at_first + 0.02 * std::fabs(at_first), "energy rose from %g J to %g J", at_first,
                highest);
    for (int i = 0; i < kLinks; ++i) {
        dVector3 a, b;
        dJointGetBallAnchor(joints[i], a);
        dJointGetBallAnchor2(joints[i], b);
        const double open = dCalcPointsDistance3(a, b);
        demo::claim(open < 0.005, "joint %d is open by %g m", i, open);
    }
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{0, -4.2f, 2}, {90, 0, 0}, 0.8, build, judge, watch});
}
