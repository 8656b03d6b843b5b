// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A car of ode/vehicle.h, with suspension, tyres, engine and gears, drives over humps, turns and brakes. Keys: a faster, z slower,
// comma and full stop steer, space brakes.
#include <ode/ext.h>

#include <cmath>

#include "stage.h"

static dGeomID chassis, shown[4];
static dVehicleControls controls;
static double top_speed = 0, highest = 0;
static bool driven = false;

static dVehicleWheel wheel_of(int i)
{
    dVehicleWheel wheel;
    dVehicleWheelInit(&wheel, sizeof wheel);
    wheel.cast = dWheelSphere;
    wheel.position[0] = i < 2 ? 1.3 : -1.3;
    wheel.position[1] = i % 2 ? -0.8 : 0.8;
    wheel.position[2] = -0.4;
    wheel.axle = i / 2;
    wheel.steer = i < 2;
    wheel.drive = i >= 2;
    return wheel;
}

static void build()
{
    demo::paint(chassis = demo::box(0, 0, 0.7, 3.6, 1.5, 0.4, 520), 0.9f, 0.35f, 0.3f);
    dVehicleCreate(demo::body(chassis), nullptr);
    for (int i = 0; i < 4; ++i) {
        const dVehicleWheel wheel = wheel_of(i);
        dVehicleAddWheel(demo::body(chassis), &wheel);
        dGeomSetBody(shown[i] = dCreateCylinder(demo::space, wheel.radius, wheel.width), demo::body(chassis));
        dGeomSetCategoryBits(shown[i], 0);
        dGeomSetCollideBits(shown[i], 0);
        demo::paint(demo::draw(shown[i]), 0.3f, 0.3f, 0.32f, DS_CHECKERED);
    }
    for (int i = 0; i < 3; ++i) {
        const dGeomID hump = demo::draw(dCreateCapsule(demo::space, 0.5, 4));
        dMatrix3 across;
        dRFromAxisAndAngle(across, 1, 0, 0, M_PI / 2);
        dGeomSetRotation(hump, across);
        dGeomSetPosition(hump, 12 + 6 * i, 0, -0.35);
    }
    controls.struct_size = sizeof controls;
}

static void place_wheels()
{
    for (int i = 0; i < 4; ++i) {
        dVehicleWheelReport now;
        now.struct_size = sizeof now;
        dVehicleGetWheelReport(demo::body(chassis), i, &now);
        const dVehicleWheel wheel = wheel_of(i);
        dGeomSetOffsetPosition(shown[i], wheel.position[0], wheel.position[1],
                               wheel.position[2] + now.compression);
        dMatrix3 upright, rolled, steered, all;
        dRFromAxisAndAngle(upright, 1, 0, 0, M_PI / 2);
        dRFromAxisAndAngle(rolled, 0, 1, 0, now.angle);
        dRFromAxisAndAngle(steered, 0, 0, 1, now.steer);
        dMultiply0(all, rolled, upright, 3, 3, 3);
        dMultiply0(upright, steered, all, 3, 3, 3);
        dGeomSetOffsetRotation(shown[i], upright);
    }
}

// Until a key is pressed: straight over the humps, then a curve, then the brakes.
static void drive(double t)
{
    if (!driven) {
        controls.throttle = t < 5 ? 0.5 : t < 8 ? 0.15 : 0;
        controls.steer = t > 5 && t < 8 ? 0.4 : 0;
        controls.brake = t > 8;
    }
    dVehicleSetControls(demo::body(chassis), &controls);
    dVehicleUpdate(demo::body(chassis), demo::kStep);
    place_wheels();
    dVehicleReport report;
    report.struct_size = sizeof report;
    dVehicleGetReport(demo::body(chassis), &report);
    top_speed = std::fmax(top_speed, report.speed);
    highest = std::fmax(highest, demo::place(chassis)[2]);
}

static void key(int key)
{
    driven = true;
    controls.brake = key == ' ';
    controls.throttle = std::fmin(1, std::fmax(0, controls.throttle + (key == 'a'   ? 0.2
                                                                       : key == 'z' ? -0.2
                                                                                    : 0)));
    controls.steer = std::fmin(1, std::fmax(-1, controls.steer + (key == ',' ? 0.2 : key == '.' ? -0.2 : 0)));
}

static void judge()
{
    const dReal *p = demo::place(chassis), *v = dBodyGetLinearVel(demo::body(chassis));
    demo::claim(top_speed > 9, "it came only to %g m/s", top_speed);
    demo::claim(highest > 0.72, "the humps were not felt: %g m", highest);
    demo::claim(p[1] > 2, "it has not turned: y = %g m", p[1]);
    demo::claim(std::hypot(v[0], v[1]) < 0.05, "it still drives: %g m/s", std::hypot(v[0], v[1]));
    demo::claim(dBodyGetRotation(demo::body(chassis))[10] > 0.99, "it does not stand on its wheels");
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv,
                     {{14, -16, 7}, {80, -18, 0}, 13, build, judge, drive, key, nullptr, 2, true});
}
