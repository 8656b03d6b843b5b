// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A gripper of two loops of four bars, one of which mimics the other, opens and closes. With projection of positions
// (dWorldSetStepProjection) loops stay closed and the mimic joint follows to 1e-9, and fingers stay upright.
#include <ode/ext.h>

#include <cmath>

#include "robot_stage.h"

static demo::Robot gripper;
static double loop = 0, mimic = 0, tilt = 0, widest = 0, narrowest = 1;

static double distance(const char* a, const char* b)
{
    dVector3 p, q;
    gripper.place(a, p), gripper.place(b, q);
    return std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                     (p[2] - q[2]) * (p[2] - q[2]));
}

static void build()
{
    dWorldSetStepProjection(demo::world, 20);
    dWorldSetStepProjectionTolerance(demo::world, demo::kIsDouble ? dReal(1e-12) : dReal(1e-6));
    gripper.load("fourbar_gripper.xml");
    const dGeomID palm = demo::draw(dCreateBox(demo::space, 0.08, 0.14, 0.04)),
                  post = demo::draw(dCreateCylinder(demo::space, 0.025, 0.4));
    dGeomSetPosition(palm, 0, 0, 0.4), dGeomSetPosition(post, 0, 0, 0.2);
    for (dGeomID geom : {palm, post}) {
        demo::paint(geom, 0.35f, 0.40f, 0.5f);
        dGeomSetCategoryBits(geom, 0), dGeomSetCollideBits(geom, 0);  // only to be looked at
    }
}

static void every_step(double t)
{
    dRobotSetControl(gripper.robot, gripper.actuator("grip"), -0.35 + 0.5 * std::sin(2 * t));
    loop = std::fmax(loop, std::fmax(distance("left_loop", "left_end"), distance("right_loop", "right_end")));
    const std::vector<dReal> q = gripper.positions();
    const auto at = [&](const char* name) { return double(q[size_t(gripper.joint(name).position)]); };
    mimic = std::fmax(mimic, std::fabs(at("left_crank") + at("right_crank")));
    tilt = std::fmax(tilt, std::fabs(at("left_crank") + at("left_finger")));
    const double gap = distance("left_loop", "right_loop");
    widest = std::fmax(widest, gap), narrowest = std::fmin(narrowest, gap);
}

static void judge()
{
    demo::print("largest gap of a loop", loop, "m");
    demo::print("largest error of the mimic joint", mimic, "rad");
    demo::print("largest tilt of a finger", tilt, "rad");
    demo::print("fingers move by", 1000 * (widest - narrowest), "mm");
    const double exact = demo::kIsDouble ? 1e-9 : 1e-5;
    demo::claim(loop < exact, "a loop opens by %g m", loop);
    demo::claim(mimic < exact, "the mimic joint is off by %g rad", mimic);
    demo::claim(tilt < 1e3 * exact, "a finger tilts by %g rad", tilt);
    demo::claim(widest - narrowest > 0.08, "the fingers move by %g m", widest - narrowest);
    gripper.destroy();
}

int main(int argc, char** argv)
{
    return demo::run(
        argc, argv,
        {{0.62f, -0.28f, 0.60f}, {155, -11, 0}, 10, build, judge, every_step, nullptr, nullptr, 4, true});
}
