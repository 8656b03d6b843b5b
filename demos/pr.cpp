// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Two rods hang from a rail, one by a hinge, one by a PR joint, whose anchor slides along the rail. Nothing
// pushes that one sideways, so its middle stays where it is, and it swings in half the hinged one's time: the
// inertia about the middle is a quarter of that about the end.
#include <cmath>

#include "stage.h"

constexpr double kLength = 1.2, kTilt = 0.2;
static dGeomID hinged, sliding;
static dJointID slide;
static double before[2], farthest = 0;
static int turns[2];

static dGeomID rod(double y)
{
    const dGeomID made = demo::box(0.5 * kLength * std::sin(kTilt), y, 2 - 0.5 * kLength * std::cos(kTilt),
                                   0.08, 0.08, kLength);
    dMatrix3 tilted;
    dRFromAxisAndAngle(tilted, 0, 1, 0, -kTilt);
    dBodySetRotation(demo::body(made), tilted);
    return made;
}

static void build()
{
    const dGeomID rail = demo::box(0, 0, 2, 2, 0.06, 0.06);
    dBodySetKinematic(demo::body(rail));
    const dJointID hinge = dJointCreateHinge(demo::world, nullptr);
    dJointAttach(hinge, demo::body(hinged = rod(-0.15)), demo::body(rail));
    dJointSetHingeAnchor(hinge, 0, -0.15, 2);
    dJointSetHingeAxis(hinge, 0, 1, 0);
    slide = dJointCreatePR(demo::world, nullptr);
    dJointAttach(slide, demo::body(rail), demo::body(sliding = rod(0.15)));
    dJointSetPRAnchor(slide, 0, 0.15, 2);
    dJointSetPRAxis1(slide, 1, 0, 0);
    dJointSetPRAxis2(slide, 0, 1, 0);
}

static void watch(double)
{
    for (int i = 0; i < 2; ++i) {
        const double now = dBodyGetAngularVel(demo::body(i == 0 ? hinged : sliding))[1];
        turns[i] += before[i] * now < 0;
        before[i] = now;
    }
    farthest = std::fmax(farthest, std::fabs(dJointGetPRPosition(slide)));
}

static void judge()
{
    const double end = 0.5 * kLength * std::sin(kTilt);
    demo::claim(turns[0] == 10, "the hinged rod turned back %d times", turns[0]);
    demo::claim(std::abs(turns[1] - 20) < 2, "the sliding rod turned back %d times", turns[1]);
    demo::claim(demo::near(demo::place(sliding)[0], end, 1e-4), "its middle is at %g m",
                demo::place(sliding)[0]);
    demo::claim(demo::near(farthest, 2 * end, 1e-3), "its anchor slid by %g m", farthest);
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{0, -3, 1.9f}, {90, -10, 0}, 9.1, build, judge, watch});
}
