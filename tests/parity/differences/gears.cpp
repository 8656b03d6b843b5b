// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Transmissions: momentum, energy, chains anywhere, ratios that change.
#include "difference.h"

namespace differences {
namespace {

struct Wheels {
    World world;
    dBodyID wheel[2];
    dJointID hinge[2], gear = dJointCreateTransmission(world.id, nullptr);

    Wheels(const double (&p)[2][3], const double (&n)[2][3])
    {
        for (int i = 0; i < 2; ++i) {
            wheel[i] = world.body(p[i][0], p[i][1], p[i][2]);
            hinge[i] = attached(dJointCreateHinge(world.id, nullptr), wheel[i], nullptr);
            dJointSetHingeAnchor(hinge[i], p[i][0], p[i][1], p[i][2]);
            dJointSetHingeAxis(hinge[i], n[i][0], n[i][1], n[i][2]);
        }
        dJointAttach(gear, wheel[0], wheel[1]);
    }
    double rate(int i) const { return dJointGetHingeAngleRate(hinge[i]); }
    double total() const { return energy(wheel[0]) + energy(wheel[1]); }
};

constexpr double kUp[2][3] = {{0, 0, 1}, {0, 0, 1}};

// Of two free wheels, one of which is leant after the gear is set.
double momentum_made(double height, double lean)
{
    const World world;
    const dBodyID a = world.body(0, 0, 0), b = world.body(2, 0, height);
    const dJointID gear = attached(dJointCreateTransmission(world.id, nullptr), a, b);
    dJointSetTransmissionAxis(gear, 0, 0, 1);
    dJointSetTransmissionAnchor1(gear, 0, 0, 0);
    dJointSetTransmissionAnchor2(gear, 2, 0, height);
    dJointSetTransmissionRatio(gear, 2);
    dMatrix3 R;
    dRFromAxisAndAngle(R, 1, 0.3, 0, lean);
    dBodySetRotation(b, R);
    dBodySetAngularVel(a, 0, 0, 3);
    double before[3], after[3], worst = 0;
    angular_momentum(a, b, before);
    world.step();
    angular_momentum(a, b, after);
    for (int k = 0; k < 3; ++k) worst = std::fmax(worst, std::fabs(after[k] - before[k]));
    return worst;
}

DIFFERENCE(D36, momentum, "gears at different heights or out of true make no momentum of their own")
{
    note("height", momentum_made(0.5, 0)), note("lean", momentum_made(0, 0.3));
    return momentum_made(0.5, 0) < 1e-9 && momentum_made(0, 0.3) < 1e-9;
}

// Bevel gears on either side: neither may drive itself.
double bevel_energy(double side)
{
    const double p[2][3] = {{0, 0, 0}, {2, 0, 3 * side}}, n[2][3] = {{0, 0, 1}, {1, 0, 0}};
    Wheels w(p, n);
    dJointSetTransmissionMode(w.gear, dTransmissionIntersectingAxes);
    dJointSetTransmissionAxis1(w.gear, 0, 0, 1);
    dJointSetTransmissionAxis2(w.gear, 1, 0, 0);
    dBodySetAngularVel(w.wheel[0], 0, 0, 1);
    const double before = w.total();
    w.world.step(300);
    return w.total() / before;
}

DIFFERENCE(D37, energy, "a bevel gear makes no energy, on whichever side its wheels meet")
{
    note("one side", bevel_energy(1)), note("other side", bevel_energy(-1));
    return bevel_energy(1) < 1.01 && bevel_energy(-1) < 1.01;
}

// The force that the chain of two free wheels exerts, one of which is braked: it points along the line
// between them, within the angle of the tangent, and draws them together.
DIFFERENCE(D38, chain, "a chain pulls its wheels together, wherever they are")
{
    const World world;
    const dBodyID a = world.body(1, 2, 0), b = world.body(1, 5, 0);
    const dJointID gear = attached(dJointCreateTransmission(world.id, nullptr), a, b);
    dJointSetTransmissionMode(gear, dTransmissionChainDrive);
    dJointSetTransmissionAxis(gear, 0, 0, 1);
    dJointSetTransmissionAnchor1(gear, 1, 2, 0);
    dJointSetTransmissionAnchor2(gear, 1, 5, 0);
    dJointSetTransmissionRadius1(gear, 0.4);
    dJointSetTransmissionRadius2(gear, 0.4);
    dBodySetAngularVel(a, 0, 0, 3);
    world.step(2);
    const dReal* v = dBodyGetLinearVel(b);
    note("aside", v[0]), note("towards", -v[1]);
    return v[1] < -0.1 && std::fabs(v[0]) < 0.1 * -v[1];
}

DIFFERENCE(D39, ratio, "a ratio that changes on the way does not jerk the wheels back")
{
    const double p[2][3] = {{0, 0, 0}, {2, 0, 0}};
    Wheels w(p, kUp);
    dJointSetTransmissionAxis(w.gear, 0, 0, 1);
    dJointSetTransmissionRatio(w.gear, 1);
    dJointSetHingeParam(w.hinge[0], dParamVel, 2);
    dJointSetHingeParam(w.hinge[0], dParamFMax, 50);
    w.world.step(300);
    dJointSetTransmissionRatio(w.gear, 2);
    double fastest = 0;
    for (int i = 0; i < 100; ++i) {
        w.world.step();
        fastest = std::fmax(fastest, std::fmax(std::fabs(w.rate(0)), std::fabs(w.rate(1))));
    }
    note("fastest", fastest);
    return fastest < 4.2;
}

}  // namespace
}  // namespace differences
