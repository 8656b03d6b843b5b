// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is carried, held or pushed goes along, and slips where Coulomb's law says so.
#include "measure.h"

#include <algorithm>

namespace epode::trials {

namespace {

// At `share` of the rate at which a block at 1 m slips. A step along the tangent ends w^2 h^2/2 farther out.
void turn_table(Run& run, double share)
{
    constexpr double kFriction = 0.5, kSeconds = 4;
    const double rate = share * std::sqrt(kFriction * kGravity);
    Stage stage(run);
    stage.surface.friction = kFriction;
    const dBodyID table = stage.cylinder(2, 0.2, 100, {0, 0, -0.1});
    dBodySetKinematic(table);
    const dBodyID block = stage.box({0.2, 0.2, 0.1}, 2, {1, 0, 0.05});
    set_velocity(block, {0, rate, 0}, {0, 0, rate}), set_velocity(table, {}, {0, 0, rate});
    stage.advance(kSeconds);
    const double way = across(rotate(inverse(orientation(table)), position(block)) - kX);
    if (share < 1)
        run.record("table", 1000 * (way - 1.1 * rate * rate * stage.h * kSeconds / 2));
    else
        run.record("slips", way < 0.1);
}

// A lift on a slider's motor, driven up and down at 2 m/s with 3 m/s^2.
void lift_pile(Run& run)
{
    Stage stage(run);
    const dBodyID lift = stage.box({2, 2, 0.2}, 500, {0, 0, -0.1});
    const dJointID slider = dJointCreateSlider(stage.world, nullptr);
    dJointAttach(slider, lift, nullptr);
    dJointSetSliderAxis(slider, 0, 0, 1);
    dJointSetSliderParam(slider, dParamFMax, 25000);
    dBodyID top = nullptr;
    for (int i = 0; i < 4; ++i) top = stage.box({0.5, 0.5, 0.5}, 100, {0, 0, 0.25 + 0.5 * i});
    double speed = 0;
    for (double wanted : {0.0, 2.0, 0.0, -2.0, 0.0})
        stage.advance(1.2, [&] {
            speed += std::clamp(wanted - speed, -3 * stage.h, 3 * stage.h);
            dJointSetSliderParam(slider, dParamVel, dReal(speed));
            run.record("lift", 1000 * std::fabs(position(top).z - position(lift).z - 1.85));
        });
    run.record("lift_aside", 1000 * across(position(top)));
}

// Two jaws press with 20 N each and rise by 0.4 m; 2 mu F carries 2 kg.
void grip(Run& run, double mass)
{
    Stage stage(run);
    stage.toys();
    stage.surface.friction = 0.5;
    stage.floor();
    const dBodyID hand = stage.bar({0.1, 0.2, 0.05}, 1, {0, 0, 0.3});
    dBodySetKinematic(hand);
    const dBodyID block = stage.box({0.06, 0.06, 0.1}, mass, {0, 0, 0.05});
    for (int side : {1, -1}) {
        const dBodyID jaw = stage.box({0.04, 0.02, 0.08}, 0.2, {0, side * 0.045, 0.06});
        const dJointID slider = dJointCreateSlider(stage.world, nullptr);
        dJointAttach(slider, jaw, hand);
        dJointSetSliderAxis(slider, 0, 1, 0);
        dDrive drive;
        dDriveInit(&drive, sizeof drive);
        drive.force = -side * 20;
        dJointSetDrive(slider, 0, &drive);
    }
    stage.advance(0.5);
    const Vec held = position(block) - position(hand);
    set_velocity(hand, {0, 0, 0.2});
    stage.advance(2);
    set_velocity(hand, {});
    stage.advance(1);
    const double way = length(position(block) - position(hand) - held);
    if (mass < 2)
        run.record("grip", 1000 * way);
    else
        run.record("drops", way < 0.05);
}

// A ball rolls down a V of 90 degrees on two lines, r / sqrt 2 from its centre: a = g sin / (1 + 2 (2/5)).
void roll_in_groove(Run& run)
{
    constexpr double kSlope = 15 * kPi / 180, kRadius = 0.1;
    const Turn tilt = turn(kY, kSlope);
    const Vec down = rotate(tilt, kX);
    Stage stage(run);
    stage.surface.friction = 0.8;
    for (int side : {1, -1}) {
        const Turn q = tilt * turn(kX, side * kPi / 4);
        stage.block({20, 2, 0.2}, 8 * down - 0.1 * rotate(q, kZ) + rotate(q, {0, double(side), 0}), q);
    }
    const dBodyID ball = stage.ball(kRadius, 2, kRadius * std::sqrt(2.0) * rotate(tilt, kZ));
    stage.advance(0.5);
    const double before = dot(velocity(ball), down), time = stage.steps_in(1.5) * stage.h;
    stage.advance(1.5);
    const double right = kGravity * std::sin(kSlope) / 1.8;
    run.record("groove", 100 * std::fabs((dot(velocity(ball), down) - before) / time / right - 1));
}

// Balls that slide until they roll: v = 5/7 v_0 + 2/7 r w_0.
void spin_back(Run& run)
{
    constexpr double kRadius = 0.11, kSpeed = 4;
    Stage stage(run);
    stage.surface.friction = 0.3;
    stage.floor();
    const double spins[] = {0, -60, 60};
    dBodyID balls[3];
    for (int i = 0; i < 3; ++i) {
        balls[i] = stage.ball(kRadius, 6, {0, double(i), kRadius});
        set_velocity(balls[i], {kSpeed, 0, 0}, {0, spins[i], 0});
    }
    stage.advance(3);
    for (int i = 0; i < 3; ++i) {
        const double right = 5 / 7.0 * kSpeed + 2 / 7.0 * kRadius * spins[i];
        run.record("backspin", 100 * std::fabs(velocity(balls[i]).x - right) / kSpeed);
    }
}

double backspin_bound(const Setting& setting) { return 1.5 * 60 * setting.h(); }

void run_carried(Run& run)
{
    turn_table(run, 0.9);
    turn_table(run, 1.1);
    lift_pile(run);
    grip(run, 0.5);
    grip(run, 2.5);
}

void run_rolled(Run& run)
{
    roll_in_groove(run);
    spin_back(run);
}

double lift_bound(const Setting& setting)
{
    return contains(Method::kSubsteps | Method::kGame, setting.method) ? 6.5 : 2;
}

}  // namespace

extern const Scene kCarried{
    "Rolling and sliding",
    "carried",
    "a block on a turntable at 0.9 and 1.1 of the rate at which it slips, a pile in a lift, blocks of 0.5 "
    "and 2.5 kg in a gripper",
    {{"table", "way on the table at 0.9, beyond w^2 h t / 2", "mm", 2},
     {"slips", "1 if that at 1.1 stays", "1", 0},
     {"lift", "height of the top crate over the lift, off the law", "mm", &lift_bound},
     {"lift_aside", "its way aside", "mm", 1},
     {"grip", "way of 0.5 kg in the jaws", "mm", 0.5},
     {"drops", "1 if 2.5 kg are held", "1", 0}},
    &run_carried};

extern const Scene kRolled{
    "Rolling and sliding",
    "rolled",
    "a ball in a V groove; balls with backspin and forward spin slide until they roll",
    {{"groove", "acceleration in the groove, off the law", "%", 2},
     {"backspin", "speed when they roll, off the law, of the first", "%", &backspin_bound}},
    &run_rolled};

}  // namespace epode::trials
