// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Three ways to drive a hinge: at a speed with much force, with little force against a load, and to an angle
// by a controller. Arms are level at first, so the weak motor must lose against gravity.
#include "stage.h"

constexpr double kSpeed = 2, kWeak = 5, kWanted = 0.8;
static dGeomID arms[3];
static dJointID hinges[3];

static void build()
{
    for (int i = 0; i < 3; ++i) {
        const double y = 1.2 * (i - 1);
        arms[i] = demo::box(0.4, y, 1.2, 0.8, 0.12, 0.12);
        const dGeomID post = demo::draw(dCreateCylinder(demo::space, 0.06, 1.2));
        dGeomSetPosition(post, 0, y + 0.15, 0.6);
        hinges[i] = dJointCreateHinge(demo::world, nullptr);
        dJointAttach(hinges[i], demo::body(arms[i]), nullptr);
        dJointSetHingeAnchor(hinges[i], 0, y, 1.2);
        dJointSetHingeAxis(hinges[i], 0, 1, 0);
        dJointSetHingeParam(hinges[i], dParamVel, kSpeed);
        dJointSetHingeParam(hinges[i], dParamFMax, i == 1 ? kWeak : 500);
    }
}

static void control(double)
{
    dJointSetHingeParam(hinges[2], dParamVel, 6 * (kWanted - dJointGetHingeAngle(hinges[2])));
}

static void judge()
{
    const double rate = dJointGetHingeAngleRate(hinges[0]);
    demo::claim(demo::near(rate, kSpeed, 0.01), "the strong motor turns at %g rad/s", rate);
    // An arm on a weak motor swings; it may not have gone over the top.
    demo::claim(demo::place(arms[1])[2] < 1.2, "the weak motor holds its arm at %g m",
                demo::place(arms[1])[2]);
    const double angle = dJointGetHingeAngle(hinges[2]);
    demo::claim(demo::near(angle, kWanted, 0.01), "the controller came to %g rad", angle);
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{3, -3, 2.2f}, {135, -14, 0}, 2.8, build, judge, control});
}
