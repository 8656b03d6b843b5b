// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Restitution. A ball that is dropped from a height H comes back to e^2 H. While it slides, an impact with normal impulse p changes
// its tangential velocity by mu p / m: the impulse of the rebound included.
#include "measure.h"

#include <algorithm>

namespace epode::trials {

namespace {

constexpr double kRadius = 0.5, kDrop = 5;

// Heights above rest of the tops of the flight, the start included.
std::vector<double> peaks(Run& run, double restitution, double seconds, bool with_energy)
{
    Stage stage(run);
    stage.surface.friction = 0;
    stage.surface.bounce = restitution;
    stage.surface.bounce_speed = 0.01;
    stage.floor();
    const dBodyID ball = stage.ball(kRadius, 1, {0, 0, kRadius + kDrop});
    std::vector<double> tops;
    double rising = -1;
    stage.advance(seconds, [&] {
        const double z = position(ball).z, v = velocity(ball).z;
        if (with_energy) run.record("energy", 100 * ((z - kRadius + v * v / (2 * kGravity)) / kDrop - 1));
        if (v > 0) rising = std::max(rising, z - kRadius + v * v / (2 * kGravity));
        if (v <= 0 && rising >= 0) {
            tops.push_back(z - kRadius);
            rising = -1;
        }
    });
    return tops;
}

void bounce(Run& run)
{
    const std::vector<double> elastic = peaks(run, 1, 60, true), half = peaks(run, 0.5, 3.5, false);
    if (elastic.size() < 20) return run.record("peak", HUGE_VAL);
    for (double top : elastic) run.record("peak", 1000 * std::fabs(top - kDrop));
    double mean = 0;
    for (size_t i = elastic.size() - 5; i < elastic.size(); ++i) mean += elastic[i] / 5;
    run.record("mean", 100 * std::fabs(mean / kDrop - 1));
    for (size_t i = 0; i < 3; ++i) {
        const double right = kDrop * std::pow(0.25, double(i + 1));
        run.record("half", i < half.size() ? 100 * std::fabs(half[i] / right - 1) : HUGE_VAL);
    }
}

// A ball is found up to v h deep.
double peak_bound(const Setting& setting) { return 1000 * 1.2 * 9.9 * setting.h(); }
double mean_bound(const Setting& setting) { return setting.step_size == 0 ? 3 : 1; }
double half_bound(const Setting& setting) { return setting.step_size == 0 ? 20 : 5; }

void graze(Run& run)
{
    constexpr double kFriction = 0.1, kSize = 0.1;
    for (double restitution : {0.0, 0.5, 0.8, 1.0}) {
        Stage stage(run);
        stage.surface.friction = kFriction;
        stage.surface.bounce = restitution;
        stage.surface.bounce_speed = 0;
        stage.floor();
        const dBodyID ball = stage.ball(kSize, 1, {0, 0, 0.5});
        set_velocity(ball, {5, 0, -2});
        double approach = 2;
        for (int i = stage.steps_in(0.6); i-- > 0 && velocity(ball).x == 5;) {
            approach = -velocity(ball).z;
            stage.step();
        }
        const Vec v = velocity(ball);
        // Weight acts in the step of the impact, too.
        const double normal = v.z + approach + kGravity * stage.h;
        run.record("friction", 100 * std::fabs((5 - v.x) / (kFriction * normal) - 1));
        if (restitution > 0) run.record("rebound", 100 * std::fabs(v.z / (restitution * approach) - 1));
    }
}

// An impact is seen where a step ends, in which weight adds g h to the speed of about 3.5 m/s.
double rebound_bound(const Setting& setting) { return 1 + 100 * kGravity * setting.h() / 3.5 / 0.5; }

// Two continuous boxes of 0.1 m meet at +-200 m/s and stop.
void meet(Run& run)
{
    Stage stage(run, {});
    stage.surface.friction = 0;
    dBodyID box[2];
    for (int i = 0; i < 2; ++i) {
        const double side = i ? 1 : -1;
        box[i] = stage.box({0.1, 0.1, 0.1}, 0.1, {10 * side, 0, 0});
        dGeomSetContinuous(dBodyGetFirstGeom(box[i]), dContinuousOn);
        set_velocity(box[i], {-200 * side, 0, 0});
    }
    stage.advance(0.5);
    for (dBodyID body : box) run.record("speed", std::fabs(velocity(body).x));
    run.record("momentum", 100 * std::fabs(momentum(stage).x) / 20);
    run.record("order", position(box[0]).x < position(box[1]).x ? 0 : 1);
}

}  // namespace

extern const Scene kBounce{
    "Impacts",
    "bounce",
    "a ball drops 5 m, restitution 1 for a minute, and restitution 0.5 (C2)",
    {{"peak", "height of a bounce, off 5 m", "mm", &peak_bound},
     {"mean", "mean of the last five, off 5 m", "%", &mean_bound},
     {"energy", "gain of energy", "%", 2},
     {"half", "heights of three bounces with restitution 0.5, off a quarter each", "%", &half_bound}},
    &bounce};

extern const Scene kGrazing{
    "Impacts",
    "grazing",
    "a ball at 5 m/s hits a floor with restitution 0 to 1 and slides through the impact",
    {{"friction", "tangential impulse, off mu times the normal impulse", "%", 2},
     {"rebound", "speed of the rebound, off the restitution's", "%", &rebound_bound}},
    &graze};

extern const Scene kHeadOn{"Impacts",
                           "head_on",
                           "two continuous boxes of 0.1 m meet at +-200 m/s without restitution",
                           {{"speed", "speed afterwards", "m/s", 1},
                            {"momentum", "change of momentum, of a box's", "%", 1e-7},
                            {"order", "boxes that passed each other", "1", 0}},
                           &meet};

}  // namespace epode::trials
