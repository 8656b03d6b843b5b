// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Buggy: a chassis on four hinge-2 wheels drives up a ramp, jumps, and steers into a curve. Each wheel's
// suspension is a spring and damper given as ERP and CFM for the step in use, h k / (h k + c) and 1 / (h k +
// c); a hinge-2 has no other spring. The rear wheels are driven by motors of limited torque, the front ones
// steered by a motor that follows an angle; the rear ones are locked straight by stops.
#include <algorithm>

#include "scenes/build.h"

namespace epode::scenes {

namespace {

constexpr double kStiffness = 40000, kDamping = 3500;
constexpr double kWheelRadius = 0.34, kWheelWidth = 0.24;
constexpr double kSpeed = 11;  // m/s at the rim

struct Wheels {
    dJointID joint[4];  // front left, front right, rear left, rear right
};

dBodyID add_wheel(Scene& scene, Vec pos)
{
    // A cylinder's axis is its local z; the wheel's is y.
    dBodyID wheel = add_cylinder(scene, kWheelRadius, kWheelWidth, 250, pos, turn(kX, kPi / 2));
    dBodySetFiniteRotationMode(wheel, 1);
    return wheel;
}

void suspend(dJointID joint, double dt)
{
    const double spring = dt * kStiffness, sum = spring + kDamping;
    dJointSetHinge2Param(joint, dParamSuspensionERP, dReal(spring / sum));
    dJointSetHinge2Param(joint, dParamSuspensionCFM, dReal(1 / sum));
}

void steer(dJointID joint, double angle)
{
    const double error = angle - dJointGetHinge2Angle1(joint);
    dJointSetHinge2Param(joint, dParamVel, dReal(std::clamp(10 * error, -1.5, 1.5)));
    dJointSetHinge2Param(joint, dParamFMax, 400);
}

// Straight over the ramp, then a curve to the left.
double steering_at(double time) { return time < 4.6 ? 0.0 : -0.2; }

void drive(const Wheels& wheels, double time, double dt)
{
    for (int i = 0; i < 4; ++i) {
        suspend(wheels.joint[i], dt);
        if (i < 2) {
            steer(wheels.joint[i], steering_at(time));
        } else {
            // Rates count body 1 against body 2: the wheel turns forward, about +y, when the chassis turns
            // back against it.
            dJointSetHinge2Param(wheels.joint[i], dParamVel2, dReal(-kSpeed / kWheelRadius));
            dJointSetHinge2Param(wheels.joint[i], dParamFMax2, 450);
        }
    }
}

void add_track(Scene& scene)
{
    const double slope = 0.20, length = 5, thick = 0.2;
    add_ground(scene);
    const Turn up = turn(kY, -slope);
    const Vec middle{12, 0, 0.4};
    add_static_box(scene, {length, 3.2, thick}, middle, up);
    for (int i = 0; i < 5; ++i) add_static_box(scene, {0.25, 3.2, 0.06}, {3.0 + 1.1 * i, 0, 0.03});
}

void build(Scene& scene)
{
    add_track(scene);
    const Vec start{0, 0, 0.62};
    dBodyID chassis = add_box(scene, {2.4, 1.1, 0.3}, 700, start);
    attach_box(scene, chassis, {1.0, 0.95, 0.42}, {-0.25, 0, 0.34});
    scene.tracked = {chassis};

    Wheels wheels{};
    for (int i = 0; i < 4; ++i) {
        const bool front = i < 2;
        const double side = i % 2 == 0 ? 1 : -1;
        const Vec pos = start + Vec{front ? 0.95 : -0.95, side * 0.75, kWheelRadius + 0.01 - start.z};
        dBodyID wheel = add_wheel(scene, pos);
        wheels.joint[i] = add_hinge2(scene, chassis, wheel, pos, kZ, kY);
        dJointSetHinge2Param(wheels.joint[i], dParamLoStop, dReal(front ? -0.6 : 0));
        dJointSetHinge2Param(wheels.joint[i], dParamHiStop, dReal(front ? 0.6 : 0));
        suspend(wheels.joint[i], scene.recipe().dt);
    }
    scene.before_step([wheels](double time, double dt) { drive(wheels, time, dt); });
    scene.surface.mu = dReal(1.0);
    dWorldSetContactSurfaceLayer(scene.world(), dReal(0.001));
    set_view(scene, {6.5, -9.5, 3.8}, {-2.6, 0, 0.5});
    scene.view.follow = chassis;
}

}  // namespace

extern const Recipe kBuggy = {
    .name = "buggy",
    .description = "a car on four hinge-2 wheels with springs and motors, over a ramp",
    .dt = 0.005,
    .seconds = 6,
    .stepper = Stepper::kExact,
    .build = build,
};

}  // namespace epode::scenes
