// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Two shafts at an angle, coupled by a universal joint: one is driven, the other follows, once round for once
// round.
#include <cmath>

#include "stage.h"

constexpr double kBend = 0.5, kSpeed = 4;
static dGeomID driver, follower;
static dJointID motor, bearing, coupling;
static double driven = 0, followed = 0;

static dJointID hold(dGeomID shaft, const double (&axis)[3])
{
    dMatrix3 along;
    dRFromZAxis(along, axis[0], axis[1], axis[2]);
    dBodySetRotation(demo::body(shaft), along);
    const dJointID hinge = dJointCreateHinge(demo::world, nullptr);
    const dReal* p = demo::place(shaft);
    dJointAttach(hinge, demo::body(shaft), nullptr);
    dJointSetHingeAnchor(hinge, p[0], p[1], p[2]);
    dJointSetHingeAxis(hinge, axis[0], axis[1], axis[2]);
    return hinge;
}

static void build()
{
    const double first[3] = {1, 0, 0}, second[3] = {std::cos(kBend), 0, std::sin(kBend)};
    driver = demo::cylinder(-0.5, 0, 1, 0.08, 0.9);
    follower = demo::cylinder(0.5 * second[0], 0, 1 + 0.5 * second[2], 0.08, 0.9);
    motor = hold(driver, first);
    bearing = hold(follower, second);
    dJointSetHingeParam(motor, dParamVel, kSpeed);
    dJointSetHingeParam(motor, dParamFMax, 1000);
    coupling = dJointCreateUniversal(demo::world, nullptr);
    dJointAttach(coupling, demo::body(driver), demo::body(follower));
    dJointSetUniversalAnchor(coupling, 0, 0, 1);
    dJointSetUniversalAxis1(coupling, 0, 1, 0);
    dJointSetUniversalAxis2(coupling, -second[2], 0, second[0]);
}

static void watch(double)
{
    driven += demo::kStep * dJointGetHingeAngleRate(motor);
    followed += demo::kStep * dJointGetHingeAngleRate(bearing);
}

static void judge()
{
    demo::claim(std::fabs(driven) > 20, "the driver turned by %g rad only", driven);
    // Within a turn the follower is ahead or behind by less than the bend allows.
    demo::claim(demo::near(driven, followed, 0.1), "%g rad became %g", driven, followed);
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{0, -2.4f, 1.6f}, {90, -10, 0}, 6, build, judge, watch});
}
