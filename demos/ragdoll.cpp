// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Ragdolls of capsules on ball joints and hinges with stops fall down stairs: no limb comes off, no knee
// bends wrongly.
#include <vector>

#include "stage.h"

struct Joint {
    dJointID id;
    bool is_knee;
};
static std::vector<Joint> joints;
static double worst_bend = 0, worst_gap = 0;

static void join(dGeomID a, dGeomID b, double x, double y, double z, bool knee)
{
    const dJointID id =
        knee ? dJointCreateHinge(demo::world, nullptr) : dJointCreateBall(demo::world, nullptr);
    dJointAttach(id, demo::body(a), demo::body(b));
    if (knee) {
        dJointSetHingeAnchor(id, x, y, z);
        dJointSetHingeAxis(id, 0, 1, 0);
        dJointSetHingeParam(id, dParamLoStop, 0);
        dJointSetHingeParam(id, dParamHiStop, 2);
    } else {
        dJointSetBallAnchor(id, x, y, z);
    }
    joints.push_back({id, knee});
}

static void make_doll(double x, double y, double z)
{
    const dGeomID trunk = demo::capsule(x, y, z, 0.14, 0.4), head = demo::sphere(x, y, z + 0.52, 0.13);
    join(trunk, head, x, y, z + 0.37, false);
    for (int side = -1; side <= 1; side += 2) {
        const double hip = y + 0.1 * side, shoulder = y + 0.24 * side;
        const dGeomID thigh = demo::capsule(x, hip, z - 0.55, 0.07, 0.26),
                      shin = demo::capsule(x, hip, z - 0.95, 0.055, 0.27);
        const dGeomID arm = demo::capsule(x, shoulder, z - 0.05, 0.05, 0.4);
        join(trunk, thigh, x, hip, z - 0.35, false);
        join(thigh, shin, x, hip, z - 0.75, true);
        join(trunk, arm, x, shoulder, z + 0.2, false);
    }
}

static void build()
{
    dWorldSetERP(demo::world, 0.5);
    for (int i = 0; i < 6; ++i) {
        const dGeomID stair =
            demo::paint(demo::draw(dCreateBox(demo::space, 0.5, 3, 0.3 * (i + 1))), 0.8f, 0.75f, 0.68f);
        dGeomSetPosition(stair, -0.5 * i, 0, 0.15 * (i + 1));
    }
    for (int i = 0; i < 3; ++i) make_doll(-2.3 + 0.1 * i, i - 1, 3.1);
    for (const Joint& joint : joints) dBodySetLinearVel(dJointGetBody(joint.id, 0), 1.5, 0, 0);
}

static void watch(double)
{
    for (const Joint& joint : joints) {
        dVector3 a, b;
        joint.is_knee ? dJointGetHingeAnchor(joint.id, a) : dJointGetBallAnchor(joint.id, a);
        joint.is_knee ? dJointGetHingeAnchor2(joint.id, b) : dJointGetBallAnchor2(joint.id, b);
        worst_gap = std::fmax(worst_gap, dCalcPointsDistance3(a, b));
        if (joint.is_knee)
            worst_bend = std::fmax(
                worst_bend, std::fmax(-dJointGetHingeAngle(joint.id), dJointGetHingeAngle(joint.id) - 2));
    }
}

static void judge()
{
    demo::claim(worst_gap < 0.03, "a limb was %g m off", worst_gap);
    demo::claim(worst_bend < 0.25, "a knee bent %g rad too far", worst_bend);
    for (const Joint& joint : joints) {
        const dReal* p = dBodyGetPosition(dJointGetBody(joint.id, 0));
        demo::claim(p[2] > 0 && p[2] < 3.5, "a limb is at %g m", p[2]);
    }
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{3.2f, -3.6f, 2.6f}, {135, -16, 0}, 4, build, judge, watch});
}
