// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Mechanisms under weight, without friction and motors, keep their energy.
#include "energy_kept.h"

#include <algorithm>

namespace epode::trials {

namespace {

// A heavy top of mass 1 on a ball joint, moments A, A about its centre, C about its axis, tilted by 1 rad,
// in steady precession: with I = A + m l^2, W solves I cos(t) W^2 - C w W + m g l = 0, w the spin in all.
struct Top {
    static constexpr double kArm = 0.5, kA = 0.05, kC = 0.02, kTilt = 1, kSpin = 100;
    static double rate()
    {
        const double a = (kA + kArm * kArm) * std::cos(kTilt), b = kC * kSpin, q = kGravity * kArm;
        return (b - std::sqrt(b * b - 4 * a * q)) / (2 * a);
    }
    static dBodyID build(Stage& stage)
    {
        const Vec axis{std::sin(kTilt), 0, std::cos(kTilt)};
        dMass mass;
        dMassSetParameters(&mass, 1, 0, 0, 0, kA, kA, kC, 0, 0, 0);
        const dBodyID top = stage.part(mass, kArm * axis, turn(kY, kTilt));
        stage.ball_joint(top, nullptr, {});
        const Vec w = (kSpin - rate() * std::cos(kTilt)) * axis + rate() * kZ;
        set_velocity(top, cross(w, kArm * axis), w);
        return top;
    }
};

double top_error(Stage& stage)
{
    Top::build(stage);
    return energy_error(stage, 3, kinetic_energy(stage));
}

void run_top(Run& run)
{
    record_energy(run, &top_error);
    Stage stage(run);
    const dBodyID top = Top::build(stage);
    double turned = 0, time = 0;
    Vec last = position(top);
    stage.advance(3, [&] {
        const Vec now = position(top);
        turned += std::atan2(last.x * now.y - last.y * now.x, last.x * now.x + last.y * now.y);
        last = now;
        time += stage.h;
        run.record("tilt", std::fabs(degrees(std::atan2(across(now), now.z) - Top::kTilt)));
    });
    run.record("precession", 100 * std::fabs(turned / (Top::rate() * time) - 1));
}

double top_bound(const Setting& setting)
{
    return setting.step_size == 0 ? 5 : setting.step_size == 1 ? 0.2 : 0.02;
}
double tilt_bound(const Setting& setting)
{
    return setting.step_size == 0 ? 20 : setting.step_size == 1 ? 1 : 0.2;
}
double precession_bound(const Setting& setting)
{
    return setting.step_size == 0 ? 20 : setting.step_size == 1 ? 1 : 0.2;
}

std::vector<Law> top_laws()
{
    std::vector<Law> laws = energy_laws(&top_bound);
    laws.push_back({"tilt", "change of the tilt", "degrees", &tilt_bound});
    laws.push_back({"precession", "error of the rate of precession", "%", &precession_bound});
    return laws;
}

// A robot's arm: two bars of half a metre swing from level on hinges.
double arm_error(Stage& stage)
{
    const dBodyID upper = stage.bar({0.5, 0.05, 0.05}, 1, {0.25, 0, 0}),
                  lower = stage.bar({0.5, 0.05, 0.05}, 1, {0.75, 0, 0});
    stage.hinge(upper, nullptr, {}, kY);
    stage.hinge(upper, lower, {0.5, 0, 0}, kY);
    return energy_error(stage, 10, 2 * kGravity * 0.75);
}

double arm_bound(const Setting& setting)
{
    return setting.step_size == 0 ? 50 : setting.step_size == 1 ? 15 : 0.5;
}

void run_arm(Run& run) { record_energy(run, &arm_error); }

// A stone whose principal axes are turned against those of its ellipsoid turns back by itself. Rolling without
// slip does no work.
double stone_error(Stage& stage)
{
    stage.surface.friction = dInfinity;
    stage.floor();
    dMass mass;
    dMassSetParameters(&mass, 1, 0, 0, 0, 0.04, 0.2, 0.21, 0.02, 0, 0);
    const dBodyID stone = stage.body(dCreateEllipsoid(stage.space, 1, 0.3, 0.2), mass, {0, 0, 0.2});
    stage.advance(1);  // into the surface layer
    dBodyEnable(stone);
    set_velocity(stone, {}, {0.05, 0.05, -5});
    return energy_error(stage, 5, kinetic_energy(stage));
}

double stone_bound(const Setting& setting)
{
    return setting.step_size == 0 ? 10 : setting.step_size == 1 ? 3 : 1;
}

void run_stone(Run& run) { record_energy(run, &stone_error); }

}  // namespace

extern const Scene kHeavyTop{"Machines", "heavy_top",
                             "a top at 100 rad/s on a ball joint in steady precession, 3 s", top_laws(),
                             &run_top};
extern const Scene kSwingingArm{"Machines", "swinging_arm",
                                "two bars of half a metre swing on hinges from level, 10 s",
                                energy_laws(&arm_bound), &run_arm};
extern const Scene kRattleback{"Machines", "rattleback",
                               "an ellipsoid with skewed inertia spins on a floor without slip, 5 s",
                               energy_laws(&stone_bound), &run_stone};

}  // namespace epode::trials
