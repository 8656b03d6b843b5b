// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Closed loops: a lattice of pairs of crossed bars, a lazy tongs, is driven at its foot and stretches to the
// far end; no joint of it opens, though it has far more joints than freedom.
#include <cmath>
#include <vector>

#include "stage.h"

constexpr int kPairs = 6;
constexpr double kBar = 0.8, kStart = 0.5;
static dGeomID bars[2 * kPairs];
static std::vector<dJointID> joints;
static dJointID motor;

static void join(dGeomID a, dGeomID b, double x, double z)
{
    joints.push_back(dJointCreateHinge(demo::world, nullptr));
    dJointAttach(joints.back(), demo::body(a), b ? demo::body(b) : nullptr);
    dJointSetHingeAnchor(joints.back(), x, 0, z);
    dJointSetHingeAxis(joints.back(), 0, 1, 0);
}

static void build()
{
    dWorldSetGravity(demo::world, 0, 0, 0);
    const double wide = kBar * std::cos(kStart), tall = kBar * std::sin(kStart);
    for (int i = 0; i < kPairs; ++i) {
        for (int k = 0; k < 2; ++k) {
            const dGeomID bar = bars[2 * i + k] =
                demo::box(0, 0.07 * (k ? 1 : -1), 0.5 + tall * (i + 0.5), kBar, 0.06, 0.08);
            dMatrix3 tilted;
            dRFromAxisAndAngle(tilted, 0, 1, 0, k ? kStart : -kStart);
            dBodySetRotation(demo::body(bar), tilted);
            dGeomSetCollideBits(bar, 0);
            dGeomSetCategoryBits(bar, 0);
        }
        join(bars[2 * i], bars[2 * i + 1], 0, 0.5 + tall * (i + 0.5));
        if (i == 0) motor = joints.back();
        if (i == 0) continue;
        join(bars[2 * i], bars[2 * i - 1], -wide / 2, 0.5 + tall * i);
        join(bars[2 * i + 1], bars[2 * i - 2], wide / 2, 0.5 + tall * i);
    }
    join(bars[0], nullptr, -wide / 2, 0.5);
    dJointSetHingeParam(motor, dParamVel, -0.5);
    dJointSetHingeParam(motor, dParamFMax, 1000);
}

static void judge()
{
    for (const dJointID joint : joints) {
        dVector3 a, b;
        dJointGetHingeAnchor(joint, a);
        dJointGetHingeAnchor2(joint, b);
        demo::claim(dCalcPointsDistance3(a, b) < 0.003, "a hinge is open by %g m",
                    dCalcPointsDistance3(a, b));
    }
    // All crossings open alike.
    const double first =
        std::fabs(dBodyGetRotation(demo::body(bars[0]))[8] - dBodyGetRotation(demo::body(bars[1]))[8]);
    const double last =
        std::fabs(dBodyGetRotation(demo::body(bars[10]))[8] - dBodyGetRotation(demo::body(bars[11]))[8]);
    demo::claim(demo::near(first, last, 0.02), "the foot opens by %g, the end by %g", first, last);
    demo::claim(std::fabs(first - 2 * std::sin(kStart)) > 0.2, "it did not move: %g", first);
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{0.4f, -4.2f, 2}, {95, -3, 0}, 1.2, build, judge});
}
