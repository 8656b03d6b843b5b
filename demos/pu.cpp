// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A splined drive shaft: the far shaft, at an angle, is carried to and fro while it turns. The PU joint lets
// it slide along the near shaft and hands every turn on.
#include <cmath>

#include "stage.h"

constexpr double kBend = 0.25, kSpeed = 5, kReach = 0.15;
static dGeomID near_shaft, far_shaft, carriage;
static dJointID motor, bearing, way, spline;
static double driven = 0, followed = 0, least = 1e9, largest = -1e9;

static dJointID hold(dGeomID shaft, const double (&axis)[3], dBodyID by)
{
    dMatrix3 along;
    dRFromZAxis(along, axis[0], axis[1], axis[2]);
    dBodySetRotation(demo::body(shaft), along);
    const dJointID hinge = dJointCreateHinge(demo::world, nullptr);
    const dReal* p = demo::place(shaft);
    dJointAttach(hinge, demo::body(shaft), by);
    dJointSetHingeAnchor(hinge, p[0], p[1], p[2]);
    dJointSetHingeAxis(hinge, axis[0], axis[1], axis[2]);
    return hinge;
}

static void build()
{
    const double first[3] = {1, 0, 0}, second[3] = {std::cos(kBend), 0, std::sin(kBend)};
    near_shaft = demo::cylinder(-0.5, 0, 1, 0.035, 1.2);
    far_shaft = demo::cylinder(0.5 * second[0], 0, 1 + 0.5 * second[2], 0.07, 0.9);
    const dGeomID house = demo::draw(dCreateSphere(demo::space, 0.12));
    dGeomSetBody(house, demo::body(far_shaft));
    dGeomSetOffsetPosition(house, 0, 0, -0.45);
    carriage = demo::box(0.5 * second[0], 0, 0.55, 0.5, 0.5, 0.1);
    motor = hold(near_shaft, first, nullptr);
    dJointSetHingeParam(motor, dParamVel, kSpeed);
    dJointSetHingeParam(motor, dParamFMax, 1000);
    bearing = hold(far_shaft, second, demo::body(carriage));
    way = dJointCreateSlider(demo::world, nullptr);
    dJointAttach(way, demo::body(carriage), nullptr);
    dJointSetSliderAxis(way, 1, 0, 0);
    dJointSetSliderParam(way, dParamFMax, 5000);
    spline = dJointCreatePU(demo::world, nullptr);
    dJointAttach(spline, demo::body(near_shaft), demo::body(far_shaft));
    dJointSetPUAnchor(spline, 0, 0, 1);
    dJointSetPUAxis1(spline, 0, 1, 0);
    dJointSetPUAxis2(spline, -second[2], 0, second[0]);
    dJointSetPUAxisP(spline, 1, 0, 0);
}

static void drive(double t)
{
    dJointSetSliderParam(way, dParamVel, kReach * 2 * std::cos(2 * t));
    driven += demo::kStep * dJointGetHingeAngleRate(motor);
    followed += demo::kStep * dJointGetHingeAngleRate(bearing);
    least = std::fmin(least, dJointGetPUPosition(spline));
    largest = std::fmax(largest, dJointGetPUPosition(spline));
}

static void judge()
{
    demo::claim(std::fabs(driven) > 25, "the near shaft turned by %g rad only", driven);
    demo::claim(demo::near(driven, followed, 0.1), "%g rad became %g", driven, followed);
    demo::claim(demo::near(largest, kReach, 0.01) && demo::near(least, -kReach, 0.01),
                "it slid from %g to %g m", least, largest);
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{0.1f, -2.6f, 1.7f}, {90, -12, 0}, 6, build, judge, drive});
}
