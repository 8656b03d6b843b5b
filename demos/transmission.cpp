// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Gears: a transmission joint couples two wheels, twenty to forty: the large one turns at half the speed, the
// other way.
#include <cmath>

#include "stage.h"

static dGeomID wheels[2];
static dJointID hinges[2], gears;

static void build()
{
    const double radii[2] = {0.2, 0.4}, x[2] = {0, 0.6};
    dMatrix3 across;
    dRFromAxisAndAngle(across, 1, 0, 0, M_PI / 2);
    for (int i = 0; i < 2; ++i) {
        wheels[i] = demo::paint(demo::cylinder(x[i], 0, 1, radii[i] - 0.005, 0.1), i ? 0.9f : 0.4f, 0.7f,
                                i ? 0.4f : 0.9f, DS_CHECKERED);
        dBodySetRotation(demo::body(wheels[i]), across);
        hinges[i] = dJointCreateHinge(demo::world, nullptr);
        dJointAttach(hinges[i], demo::body(wheels[i]), nullptr);
        dJointSetHingeAnchor(hinges[i], x[i], 0, 1);
        dJointSetHingeAxis(hinges[i], 0, 1, 0);
    }
    gears = dJointCreateTransmission(demo::world, nullptr);
    dJointAttach(gears, demo::body(wheels[0]), demo::body(wheels[1]));
    dJointSetTransmissionMode(gears, dTransmissionParallelAxes);
    dJointSetTransmissionAnchor1(gears, x[0], 0, 1);
    dJointSetTransmissionAnchor2(gears, x[1], 0, 1);
    dJointSetTransmissionAxis(gears, 0, 1, 0);
    dJointSetTransmissionRatio(gears, 0.5);
    dJointSetHingeParam(hinges[0], dParamVel, 5);
    dJointSetHingeParam(hinges[0], dParamFMax, 200);
}

static void judge()
{
    const double fast = dJointGetHingeAngleRate(hinges[0]), slow = dJointGetHingeAngleRate(hinges[1]);
    demo::claim(demo::near(std::fabs(fast), 5, 0.05), "the small wheel turns at %g rad/s", fast);
    demo::claim(demo::near(std::fabs(slow / fast), 0.5, 0.01), "the large wheel turns at %g rad/s to %g",
                slow, fast);
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{0.35f, -1.6f, 1.2f}, {90, -8, 0}, 3, build, judge});
}
