// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a joint carries: a crate of 200 kg hangs by three ropes (double ball joints); the sum of their forces
// is its weight, and each pulls along its rope.
#include <cmath>

#include "stage.h"

static dGeomID crate;
static dJointID ropes[3];
static dJointFeedback forces[3];

static void build()
{
    demo::paint(crate = demo::box(0, 0, 1, 0.8, 0.8, 0.3125), 0.9f, 0.7f, 0.45f, DS_WOOD);
    const double corners[3][2] = {{0.4, 0}, {-0.4, 0.4}, {-0.4, -0.4}};
    for (int i = 0; i < 3; ++i) {
        ropes[i] = dJointCreateDBall(demo::world, nullptr);
        dJointAttach(ropes[i], demo::body(crate), nullptr);
        dJointSetDBallAnchor1(ropes[i], corners[i][0], corners[i][1], 1.15625);
        dJointSetDBallAnchor2(ropes[i], 2 * corners[i][0], 2 * corners[i][1], 2.6);
        dJointSetFeedback(ropes[i], &forces[i]);
    }
    dBodySetLinearDamping(demo::body(crate), 0.02);
    dBodySetAngularDamping(demo::body(crate), 0.02);
}

static void show_ropes(double)
{
    // Drawing belongs to the frame; steps come within it.
    dsSetColor(0.3f, 0.25f, 0.2f);
    for (const dJointID rope : ropes) {
        dVector3 a, b;
        dJointGetDBallAnchor1(rope, a);
        dJointGetDBallAnchor2(rope, b);
        dsDrawLine(a, b);
    }
}

static void judge()
{
    double up = 0;
    for (int i = 0; i < 3; ++i) {
        dVector3 a, b;
        dJointGetDBallAnchor1(ropes[i], a);
        dJointGetDBallAnchor2(ropes[i], b);
        const dReal* f = forces[i].f1;
        const dReal along[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        const double force = std::sqrt(dCalcVectorDot3(f, f));
        const double cosine = dCalcVectorDot3(f, along) / (force * dCalcPointsDistance3(a, b));
        demo::claim(cosine > 0.999, "rope %d pulls %g off its way", i, cosine);
        up += f[2];
    }
    demo::claim(demo::near(up, 200 * 9.81, 0.01 * 200 * 9.81), "the ropes carry %g N", up);
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{2.6f, -2.8f, 2}, {133, -9, 0}, 12, build, judge, show_ropes});
}
