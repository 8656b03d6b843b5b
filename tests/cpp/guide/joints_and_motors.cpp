// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The guide's chapters on joint types, stops and motors, in C++. A pendulum swings with the period of the
// textbook and its joint feedback is the weight; a hinge stops where its stop is; a motor that may use a
// torque T turns a flywheel up at T / I and then holds the speed it was asked for; a motor of speed 0 is dry
// friction; soft constraints with the guide's ERP and CFM are a spring and damper; Euler angles read what was
// turned.
#include <ode/ode.h>

#include "check.h"

namespace {

const double kPi = 3.14159265358979323846;

/** The period of a rod that swings by a small angle about its end: T = 2 pi sqrt(2 L / (3 g)). */
void swing_a_pendulum()
{
    const dReal length = 1, gravity = REAL(9.81), step = REAL(0.001);
    dWorld world;
    world.setGravity(0, 0, -gravity);
    world.setCFM(REAL(1e-9));  // the default of a library of floats is soft
    dBody rod(world);
    dMass mass;
    mass.setBoxTotal(3, REAL(0.001), REAL(0.001), length);
    rod.setMass(mass);
    rod.setPosition(0, 0, -length / 2);
    dHingeJoint hinge(world);
    hinge.attach(rod, 0);
    hinge.setAnchor(0, 0, 0);
    hinge.setAxis(0, 1, 0);
    dJointFeedback feedback;
    hinge.setFeedback(&feedback);
    world.step(step);
    expect_close("the hinge carries the weight, N", feedback.f1[2], 3 * gravity, 0.01);

    rod.setAngularVel(0, REAL(0.05), 0);
    rod.setLinearVel(-REAL(0.05) * length / 2, 0, 0);
    int steps = 0, crossings = 0;
    double first = 0, last = 0;
    dReal before = hinge.getAngle();
    while (crossings < 5 && ++steps < 20000) {
        world.step(step);
        const dReal angle = hinge.getAngle();
        if (before < 0 && angle >= 0) {
            last = steps * step;
            if (crossings++ == 0) first = last;
        }
        before = angle;
    }
    expect_close("period of the pendulum, s", (last - first) / 4,
                 2 * kPi * std::sqrt(2 * length / (3 * gravity)), 5e-3);
}

void reach_a_stop()
{
    dWorld world;
    world.setGravity(0, 0, REAL(-9.81));
    dBody arm(world);
    arm.setPosition(1, 0, 0);
    dHingeJoint hinge(world);
    hinge.attach(arm, 0);
    hinge.setAnchor(0, 0, 0);
    hinge.setAxis(0, 1, 0);
    hinge.setParam(dParamLoStop, REAL(-0.3));
    hinge.setParam(dParamHiStop, REAL(0.3));
    for (int i = 0; i < 1000; ++i) world.step(REAL(0.005));
    expect_close("the arm hangs on its stop, rad", std::fabs(hinge.getAngle()), 0.3, 5e-3);
    expect_close("and does not move, rad/s", hinge.getAngleRate(), 0, 1e-3);
    expect_close("and the anchor holds, m", arm.getPosition()[0], std::cos(0.3), 5e-3);
}

void turn_a_flywheel()
{
    const dReal torque = REAL(0.5), inertia = 2, wanted = 1, step = REAL(0.01);
    dWorld world;
    dBody wheel(world);
    dMass mass;
    mass.setParameters(1, 0, 0, 0, inertia, inertia, inertia, 0, 0, 0);
    wheel.setMass(mass);
    dHingeJoint axle(world);
    axle.attach(wheel, 0);
    axle.setAxis(0, 0, 1);
    axle.setParam(dParamVel, wanted);
    axle.setParam(dParamFMax, torque);
    for (int i = 0; i < 100; ++i) world.step(step);
    expect_close("after 1 s the motor has made T t / I, rad/s", wheel.getAngularVel()[2], torque / inertia,
                 1e-3);
    for (int i = 0; i < 400; ++i) world.step(step);
    expect_close("later it holds its speed, rad/s", wheel.getAngularVel()[2], wanted, 1e-3);

    axle.setParam(dParamVel, 0);
    for (int i = 0; i < 200; ++i) world.step(step);
    expect_close("speed 0 is dry friction, rad/s", wheel.getAngularVel()[2], wanted - 2 * torque / inertia,
                 1e-3);
    axle.addTorque(torque / 2);
    for (int i = 0; i < 400; ++i) world.step(step);
    axle.addTorque(torque / 2);
    world.step(step);
    expect_close("which a smaller torque does not move, rad/s", wheel.getAngularVel()[2], 0, 1e-3);
}

/** Guide, "how to use ERP and CFM": ERP = h kp / (h kp + kd), CFM = 1 / (h kp + kd). */
void hang_on_a_spring()
{
    const dReal kp = 200, kd = 20, step = REAL(0.01), weight = REAL(9.81);
    dWorld world;
    world.setGravity(0, 0, -weight);
    dBody load(world);
    dSliderJoint slider(world);
    slider.attach(load, 0);
    slider.setAxis(0, 0, 1);
    slider.setParam(dParamLoStop, 0);
    slider.setParam(dParamHiStop, 0);
    slider.setParam(dParamStopERP, step * kp / (step * kp + kd));
    slider.setParam(dParamStopCFM, 1 / (step * kp + kd));
    for (int i = 0; i < 1000; ++i) world.step(step);
    expect_close("the spring gives by m g / kp, m", load.getPosition()[2], -weight / kp, 1e-4);
    expect_close("which the slider reads, m", slider.getPosition(), load.getPosition()[2], 1e-4);
}

void read_euler_angles()
{
    dWorld world;
    dBody first(world), second(world);
    dBallJoint ball(world);
    ball.attach(first, second);
    dAMotorJoint motor(world);
    motor.attach(first, second);
    motor.setMode(dAMotorEuler);
    motor.setAxis(0, 1, 1, 0, 0);
    motor.setAxis(2, 2, 0, 0, 1);
    expect("Euler mode has three axes", motor.getNumAxes() == 3);
    dQuaternion turned;
    dQFromAxisAndAngle(turned, 1, 0, 0, REAL(0.4));
    second.setQuaternion(turned);
    world.step(REAL(0.001));
    expect_close("first Euler angle, rad", std::fabs(motor.getAngle(0)), 0.4, 1e-4);
    expect_close("second Euler angle, rad", motor.getAngle(1), 0, 1e-4);
    expect_close("third Euler angle, rad", motor.getAngle(2), 0, 1e-4);
}

}  // namespace

int main()
{
    dInitODE();
    swing_a_pendulum();
    reach_a_stop();
    turn_a_flywheel();
    hang_on_a_spring();
    read_euler_angles();
    dCloseODE();
    return 0;
}
