// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Stops near half a turn and beyond it. What turned is summed from step to step, so that a wrapped angle cannot hide.
#include "measure.h"

#include <algorithm>

namespace epode::trials {

namespace {

constexpr double kStop = 3.1, kSpeed = 10;

dBodyID arm(Stage& stage) { return stage.bar({0.5, 0.05, 0.05}, 0.2, {0.25, 0, 0}); }

struct Turning {
    Stage& stage;
    dBodyID body;
    double turned = 0;
    double rate() const { return spin(body).z; }
    // About z; corrections of poses have no rates.
    void step()
    {
        dQuaternion before, turn;
        std::copy_n(dBodyGetQuaternion(body), 4, before);
        stage.step();
        dQMultiply2(turn, dBodyGetQuaternion(body), before);
        turned += std::remainder(2 * std::atan2(turn[3], turn[0]), 2 * M_PI);
    }
};

void judge(Run& run, const Turning& arm, double stop, bool settled)
{
    run.record("beyond", std::fabs(arm.turned) - stop);
    if (!settled) return;
    run.record("rest", std::fabs(std::fabs(arm.turned) - stop));
    run.record("rate", std::fabs(arm.rate()));
}

void drive_hinge(Run& run, double speed, double low, double high, bool pulse)
{
    Stage stage(run, {});
    Turning turning{stage, arm(stage)};
    const dJointID joint = stage.hinge(turning.body, nullptr, {}, kZ);
    dJointSetHingeParam(joint, dParamLoStop, low);
    dJointSetHingeParam(joint, dParamHiStop, high);
    dJointSetHingeParam(joint, dParamVel, speed);
    dJointSetHingeParam(joint, dParamFMax, 2);
    const double stop = speed > 0 ? high : -low;
    const int steps = stage.steps_in(4), hit = stage.steps_in(1.5);
    for (int i = 0; i < steps; ++i) {
        if (pulse && i == hit) {
            dJointSetHingeParam(joint, dParamFMax, 0);
            dBodyEnable(turning.body);
            dBodyAddTorque(turning.body, 0, 0, 50);
        }
        turning.step();
        judge(run, turning, stop, i > steps / 2);
    }
}

// One axis of a universal joint, the other one locked.
void drive_universal(Run& run, int axis, double speed)
{
    Stage stage(run, {});
    Turning turning{stage, arm(stage)};
    const dJointID joint = dJointCreateUniversal(stage.world, nullptr);
    dJointAttach(joint, turning.body, nullptr);
    dJointSetUniversalAnchor(joint, 0, 0, 0);
    if (axis == 0) {
        dJointSetUniversalAxis1(joint, 0, 0, 1);
        dJointSetUniversalAxis2(joint, 1, 0, 0);
    } else {
        dJointSetUniversalAxis1(joint, 1, 0, 0);
        dJointSetUniversalAxis2(joint, 0, 0, 1);
    }
    const int group = axis == 0 ? 0 : dParamGroup2, other = axis == 0 ? dParamGroup2 : 0;
    for (int stop : {dParamLoStop, dParamHiStop}) {
        dJointSetUniversalParam(joint, other + stop, 0);
        dJointSetUniversalParam(joint, group + stop, stop == dParamLoStop ? -kStop : kStop);
    }
    dJointSetUniversalParam(joint, group + dParamVel, speed);
    dJointSetUniversalParam(joint, group + dParamFMax, 2);
    const int steps = stage.steps_in(4);
    for (int i = 0; i < steps; ++i) {
        turning.step();
        judge(run, turning, kStop, i > steps / 2);
    }
}

void stop_near_half_turn(Run& run)
{
    for (double speed : {kSpeed, -kSpeed}) {
        drive_hinge(run, speed, -kStop, kStop, false);
        for (int axis : {0, 1}) drive_universal(run, axis, speed);
    }
    drive_hinge(run, kSpeed, -dInfinity, 3.14159, false);
    drive_hinge(run, kSpeed, -kStop, kStop, true);
}

struct Range {
    double low, high, speed;
};

// Limits that the function refuses are a right answer, too: they are not as they were set then.
bool set_stops(dJointID joint, const Range& range)
{
    dJointSetAxisContinuous(joint, 0, 1);
    dJointSetHingeParam(joint, dParamLoStop, range.low);
    dJointSetHingeParam(joint, dParamHiStop, range.high);
    return dJointGetHingeParam(joint, dParamLoStop) == range.low &&
           dJointGetHingeParam(joint, dParamHiStop) == range.high;
}

void turn_disc(Run& run, const Range& range)
{
    Stage stage(run, {});
    dMass mass;
    dMassSetCylinderTotal(&mass, 1, 3, 0.3, 0.05);
    Turning turning{stage, stage.part(mass, {})};
    const dJointID joint = stage.hinge(turning.body, nullptr, {}, kZ);
    if (!set_stops(joint, range)) return;
    dJointSetHingeParam(joint, dParamVel, range.speed);
    dJointSetHingeParam(joint, dParamFMax, 5);
    const double stop = range.speed > 0 ? range.high : -range.low;
    const int steps = stage.steps_in(15);
    for (int i = 0; i < steps; ++i) {
        turning.step();
        const double ahead = stop - std::fabs(turning.turned);
        if (i > stage.steps_in(0.2) && ahead > 0.1)
            run.record("speed", 100 * std::fabs(turning.rate() / range.speed - 1));
        if (i > steps - stage.steps_in(2)) run.record("rest", std::fabs(ahead));
    }
}

void stop_after_turns(Run& run)
{
    for (const char* law : {"rest", "speed"}) run.record(law, 0);
    for (const Range& range :
         {Range{-3.49, 0.785, -2}, Range{-0.1, 4.712, 2}, Range{-6.28, 6.28, 2}, Range{0, 18.85, 2}})
        turn_disc(run, range);
}

}  // namespace

extern const Scene kStopNearHalfTurn{
    "Joints",
    "stop_near_half_turn",
    "a motor drives an arm at 10 rad/s against stops of 3.1 and 3.14159 rad of hinges and universal joints, "
    "4 s (C4)",
    {{"beyond", "largest turn beyond the stop", "rad", 0.16},
     {"rest", "turn of the arm that has come to rest, off the stop", "rad", 0.02},
     {"rate", "rate then", "rad/s", 0.02}},
    &stop_near_half_turn};

extern const Scene kStopAfterTurns{
    "Joints",
    "stop_after_turns",
    "a motor of 2 rad/s and stops at -200, 270, 360 and 1080 degrees of an axis that counts turns (C5)",
    {{"rest", "turn of the disc that has come to rest, off the stop", "rad", 0.01},
     {"speed", "rate on the way, off 2 rad/s", "%", 1}},
    &stop_after_turns};

}  // namespace epode::trials
