// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Blast: a charge goes off among towers of crates (dSpaceApplyRadialImpulse), and eight figures (ode/ragdoll.h) that stand around them by
// their motors are thrown back, each as a whole: one impulse for every bone would tear off the hands. A tower behind a wall stays:
// nothing that is hidden is struck.
#include <cmath>
#include <memory>

#include "scenes/assemblies.h"
#include "scenes/build.h"

namespace epode::scenes {

namespace {

constexpr double kSide = 0.5, kWhen = 0.4, kReach = 7, kImpulse = 150, kSpeed = 5;
constexpr unsigned long kCrates = 1, kFlesh = 2;
constexpr Vec kCharge{0, 0, 0.25};
constexpr int kTowers = 6, kStoreys = 4, kFigures = 8;

void add_tower(Scene& scene, Vec at, double angle)
{
    for (int i = 0; i < kStoreys; ++i)
        add_box(scene, {kSide, kSide, kSide}, 160, at + Vec{0, 0, (i + 0.5) * kSide}, turn(kZ, angle));
}

// All bones away from the charge with one speed, less with the distance.
void throw_back(const std::vector<dBodyID>& figure)
{
    const Vec way = vec(dBodyGetPosition(figure[0])) - kCharge;
    const double r = length(way), speed = kSpeed * (1 - r / kReach);
    for (const dBodyID bone : figure) set_velocity(bone, (speed / r) * way);
}

Vec on_circle(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle), 0}; }

void build(Scene& scene)
{
    add_ground(scene);
    for (int i = 0; i < kTowers; ++i) {
        const double angle = 2 * kPi * i / kTowers;
        add_tower(scene, on_circle(1.6, angle), angle);
    }
    std::vector<std::vector<dBodyID>> figures;
    for (int i = 0; i < kFigures; ++i) {
        const double angle = 2 * kPi * (i + 0.5) / kFigures;
        const auto figure = add_human(scene, on_circle(3, angle), turn(kZ, angle + kPi), 1.8, 75, 0.6);
        for (const dBodyID bone : figure) set_bits(bone, kFlesh, ~0ul);
        if (!figure.empty()) figures.push_back(figure);
    }
    add_static_box(scene, {0.3, 3, 2.2}, {4.3, 0, 1.1});
    add_tower(scene, {4.9, 0, 0}, 0);
    scene.tracked = {scene.bodies().front()};
    const auto gone = std::make_shared<bool>(false);
    scene.before_step([&scene, gone, figures](double time, double) {
        if (*gone || time < kWhen) return;
        *gone = true;
        blow_up(scene, kCharge, kReach, kImpulse, kCrates);
        for (const auto& figure : figures) throw_back(figure);
    });
    set_view(scene, {-8, -10.5, 5.5}, {0.4, 0.3, 0.9});
}

}  // namespace

extern const Recipe kBlast = {
    .name = "blast",
    .description = "a charge among towers of crates and figures; a wall hides one tower",
    .dt = 0.005,
    .seconds = 3,
    .stepper = Stepper::kQuick,
    .build = build,
};

}  // namespace epode::scenes
