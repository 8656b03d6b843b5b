// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Boxes on a slope of 25 degrees, each with its own friction: they stay where mu > tan 25 = 0.466 and slide
// elsewhere, with the acceleration g (sin a - mu cos a). Contacts are made here, for the stage knows only one
// friction.
#include <cmath>

#include "stage.h"

constexpr int kBoxes = 7;
constexpr double kAngle = 25 * M_PI / 180, kDuration = 1;
static dGeomID slope, boxes[kBoxes];
static dJointGroupID contacts;

static double mu(int i) { return 0.1 + 0.12 * i; }

static void build()
{
    slope = demo::paint(demo::draw(dCreateBox(nullptr, 8, 6, 0.2)), 0.8f, 0.75f, 0.65f, DS_WOOD);
    contacts = dJointGroupCreate(0);
    dMatrix3 tilted;
    dRFromAxisAndAngle(tilted, 0, 1, 0, kAngle);
    dGeomSetRotation(slope, tilted);
    dGeomSetPosition(slope, 0, 0, 2);
    for (int i = 0; i < kBoxes; ++i) {
        const double up = 2.5, away = 0.1 + 0.15;
        boxes[i] = demo::box(-up * std::cos(kAngle) + away * std::sin(kAngle), 0.7 * (i - 3),
                             2 + up * std::sin(kAngle) + away * std::cos(kAngle), 0.4, 0.4, 0.3);
        dBodySetRotation(demo::body(boxes[i]), tilted);
    }
}

static void hold(double)
{
    dJointGroupEmpty(contacts);
    for (int i = 0; i < kBoxes; ++i) {
        dContact points[4] = {};
        const int count = dCollide(slope, boxes[i], 4, &points[0].geom, sizeof(dContact));
        for (int k = 0; k < count; ++k) {
            points[k].surface.mode = dContactApprox1;
            points[k].surface.mu = mu(i);
            dJointAttach(dJointCreateContact(demo::world, contacts, &points[k]), nullptr,
                         demo::body(boxes[i]));
        }
    }
}

static void judge()
{
    for (int i = 0; i < kBoxes; ++i) {
        const double a = std::fmax(0, 9.81 * (std::sin(kAngle) - mu(i) * std::cos(kAngle)));
        const dReal* v = dBodyGetLinearVel(demo::body(boxes[i]));
        const double speed = std::sqrt(dCalcVectorDot3(v, v)), expected = a * kDuration;
        demo::claim(demo::near(speed, expected, 0.02 + 0.04 * expected), "mu = %g: %g m/s instead of %g",
                    mu(i), speed, expected);
    }
    dJointGroupEmpty(contacts);
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{5.5f, -3.5f, 4.5f}, {145, -24, 0}, kDuration, build, judge, hold});
}
