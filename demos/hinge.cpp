// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A door on a hinge with stops: thrown open it hits the stop, swings back, and never leaves its range or its
// frame.
#include <cmath>

#include "stage.h"

constexpr double kStop = 1.9;
static dGeomID door;
static dJointID hinge;
static double widest = 0, narrowest = 0, worst = 0;

static void build()
{
    demo::paint(door = demo::box(0.45, 0, 1.05, 0.9, 0.06, 2, 600), 0.9f, 0.6f, 0.4f, DS_WOOD);
    dGeomID frame = demo::draw(dCreateBox(demo::space, 0.1, 0.1, 2.2));
    dGeomSetPosition(frame, -0.1, 0, 1.1);
    hinge = dJointCreateHinge(demo::world, nullptr);
    dJointAttach(hinge, demo::body(door), nullptr);
    dJointSetHingeAnchor(hinge, 0, 0, 1.05);
    dJointSetHingeAxis(hinge, 0, 0, -1);
    dJointSetHingeParam(hinge, dParamLoStop, -kStop);
    dJointSetHingeParam(hinge, dParamHiStop, kStop);
    dJointSetHingeParam(hinge, dParamBounce, 0.5);
    dBodySetAngularVel(demo::body(door), 0, 0, 3);
    dBodySetLinearVel(demo::body(door), 0, 1.35, 0);
}

static void watch(double)
{
    const double angle = dJointGetHingeAngle(hinge);
    widest = std::fmax(widest, angle);
    narrowest = std::fmin(narrowest, angle);
    dVector3 a, b;
    dJointGetHingeAnchor(hinge, a);
    dJointGetHingeAnchor2(hinge, b);
    worst = std::fmax(worst, dCalcPointsDistance3(a, b));
}

static void judge()
{
    demo::claim(widest - narrowest > kStop, "it hardly moved: %g to %g rad", narrowest, widest);
    demo::claim(std::fmax(widest, -narrowest) < kStop + 0.03, "it broke through a stop: %g, %g rad",
                narrowest, widest);
    const double rate = std::fabs(dJointGetHingeAngleRate(hinge));
    demo::claim(rate > 0.5 && rate < 2, "after its first bounce 3 rad/s have become %g", rate);
    demo::claim(worst < 2e-3, "the hinge is open by %g m", worst);
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{2.2f, -2.6f, 2}, {125, -15, 0}, 1.5, build, judge, watch});
}
