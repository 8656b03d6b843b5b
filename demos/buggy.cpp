// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A three-wheeled buggy on hinge-2 joints with springs drives off, climbs a ramp and comes down on its
// wheels. Keys: a faster, z slower, comma and full stop steer.
#include <cmath>

#include "stage.h"

static dGeomID chassis, ramp, wheels[3];
static dJointID axles[3];
static double speed = 12, steer = 0, highest = 0;

static void build()
{
    demo::paint(chassis = demo::box(0, 0, 0.55, 1.2, 0.6, 0.2, 150), 0.9f, 0.35f, 0.3f);
    const double places[3][2] = {{0.55, 0}, {-0.55, 0.45}, {-0.55, -0.45}};
    dMatrix3 across;
    dRFromAxisAndAngle(across, 1, 0, 0, M_PI / 2);
    for (int i = 0; i < 3; ++i) {
        demo::paint(wheels[i] = demo::sphere(places[i][0], places[i][1], 0.35, 0.25, 60), 0.3f, 0.3f, 0.32f,
                    DS_CHECKERED);
        dBodySetRotation(demo::body(wheels[i]), across);
        axles[i] = dJointCreateHinge2(demo::world, nullptr);
        dJointAttach(axles[i], demo::body(chassis), demo::body(wheels[i]));
        const dReal* p = demo::place(wheels[i]);
        dJointSetHinge2Anchor(axles[i], p[0], p[1], p[2]);
        const dReal up[3] = {0, 0, 1}, along[3] = {0, 1, 0};
        dJointSetHinge2Axes(axles[i], up, along);
        dJointSetHinge2Param(axles[i], dParamSuspensionERP, 0.3);
        dJointSetHinge2Param(axles[i], dParamSuspensionCFM, 0.0005);
        dJointSetHinge2Param(axles[i], dParamLoStop, 0);
        dJointSetHinge2Param(axles[i], dParamHiStop, 0);
    }
    demo::paint(ramp = demo::draw(dCreateBox(demo::space, 3, 2, 0.4)), 0.8f, 0.7f, 0.55f, DS_WOOD);
    dMatrix3 slope;
    dRFromAxisAndAngle(slope, 0, 1, 0, -0.2);
    dGeomSetRotation(ramp, slope);
    dGeomSetPosition(ramp, 5, 0, 0.1);
}

static void drive(double)
{
    for (const dJointID axle : axles) {
        dJointSetHinge2Param(axle, dParamVel2, -speed);
        dJointSetHinge2Param(axle, dParamFMax2, 40);
    }
    dJointSetHinge2Param(axles[0], dParamLoStop, steer);
    dJointSetHinge2Param(axles[0], dParamHiStop, steer);
    highest = std::fmax(highest, demo::place(chassis)[2]);
}

static void key(int key)
{
    speed += key == 'a' ? 2 : key == 'z' ? -2 : 0;
    steer += key == ',' ? 0.1 : key == '.' ? -0.1 : 0;
}

static void judge()
{
    const dReal* p = demo::place(chassis);
    demo::claim(highest > 0.9, "the ramp was not climbed: %g m", highest);
    demo::claim(p[0] > 7, "it came only to x = %g m", p[0]);
    demo::claim(std::fabs(p[1]) < 0.3, "it left its way by %g m", p[1]);
    demo::claim(dBodyGetRotation(demo::body(chassis))[10] > 0.95, "it does not stand on its wheels");
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{4, -6, 2.2f}, {90, -14, 0}, 5, build, judge, drive, key});
}
