// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Course: three characters (ode/character.h), a capsule, a box and a cylinder, climb stairs, walk down a slope, push crates away, ride a
// lift up to a deck and jump down from it.
#include <cmath>
#include <memory>

#include "scenes/build.h"
#include "scenes/characters.h"

namespace epode::scenes {

namespace {

constexpr int kStairs = 6;
constexpr double kRise = 0.25, kTread = 0.35, kStairsAt = 3, kDeck = kStairs * kRise, kWidth = 5;
constexpr double kStairsEnd = kStairsAt + kStairs * kTread, kSlopeAt = kStairsEnd + 2,
                 kSlopeEnd = kSlopeAt + 3.2;
constexpr double kCrates = kSlopeEnd + 1.6, kLift = kCrates + 8, kLiftHalf = 1.2, kEnd = kLift + 7;
constexpr double kPeriod = 6, kPace = 2;

void add_stairs(Scene& scene)
{
    for (int i = 0; i < kStairs; ++i) {
        const double height = (i + 1) * kRise;
        add_static_box(scene, {kTread, kWidth, height}, {kStairsAt + (i + 0.5) * kTread, 0, height / 2});
    }
    add_static_box(scene, {kSlopeAt - kStairsEnd, kWidth, kDeck},
                   {(kStairsEnd + kSlopeAt) / 2, 0, kDeck / 2});
}

// A slab whose upper side leads from the deck to the ground.
void add_slope(Scene& scene)
{
    const double run = kSlopeEnd - kSlopeAt, angle = std::atan2(kDeck, run), thick = 0.1;
    const Vec middle{(kSlopeAt + kSlopeEnd) / 2 - thick / 2 * std::sin(angle), 0,
                     kDeck / 2 - thick / 2 * std::cos(angle)};
    add_static_box(scene, {std::hypot(run, kDeck), kWidth, thick}, middle, turn(kY, angle));
}

// Up and down between the ground and the deck behind it, with a rest at both ends.
double lift_height(double time) { return (0.5 - 0.5 * std::cos(2 * kPi * time / kPeriod)) * kDeck; }

dBodyID add_lift(Scene& scene)
{
    const dBodyID lift = add_box(scene, {2 * kLiftHalf, kWidth, 0.2}, 500, {kLift, 0, -0.08});
    dBodySetKinematic(lift);
    set_bits(lift, 2, ~2ul);
    add_static_box(scene, {kEnd - kLift - kLiftHalf, kWidth, 0.3},
                   {(kEnd + kLift + kLiftHalf) / 2 + 0.02, 0, kDeck - 0.13});
    return lift;
}

struct Walker {
    dGeomID character;
    double lane;
    int rides;  // 0: before the lift; 1: on it; 2: behind it
};

// To the lift, when it is down; off it, when it is up.
Vec wanted(Walker& walker, double lift)
{
    const Vec feet = feet_of(walker.character);
    const double edge = kLift - kLiftHalf - 0.5;
    if (walker.rides == 0 && feet.x > kLift - 0.3) walker.rides = 1;
    if (walker.rides == 1 && lift > kDeck - 0.04) walker.rides = 2;
    const bool waits =
        (walker.rides == 0 && feet.x > edge && feet.x < edge + 0.4 && lift > 0.06) || walker.rides == 1;
    return {waits || feet.x > kEnd + 1.5 ? 0 : kPace, std::fmin(1, std::fmax(-1, 2 * (walker.lane - feet.y))),
            0};
}

void build(Scene& scene)
{
    add_ground(scene);
    add_stairs(scene);
    add_slope(scene);
    for (int i = 0; i < 6; ++i)
        add_box(scene, {0.55, 0.55, 0.55}, 200, {kCrates + 0.7 * (i / 3), 1.4 * (i % 3 - 1), 0.275});
    const dBodyID lift = add_lift(scene);
    const int shapes[3] = {dCapsuleClass, dBoxClass, dCylinderClass};
    const auto walkers = std::make_shared<std::vector<Walker>>();
    for (int i = 0; i < 3; ++i) {
        const double lane = 1.4 * (i - 1);
        if (const dGeomID character = add_character(scene, shapes[i], {0.9 * i - 0.9, lane, 0}))
            walkers->push_back({character, lane, 0});
    }
    scene.before_step([lift, walkers](double time, double dt) {
        const double height = lift_height(time);
        set_velocity(lift, {0, 0, (lift_height(time + dt) - height) / dt});
        for (Walker& walker : *walkers) {
            const bool edge = feet_of(walker.character).x > kEnd - 0.35;
            walk(walker.character, wanted(walker, height), edge ? 3.5 : 0, dt);
        }
    });
    scene.tracked = {lift};
    set_view(scene, {15.5, -17, 9.5}, {13.2, 0.5, 0});
}

}  // namespace

extern const Recipe kCourse = {
    .name = "course",
    .description = "three characters on stairs, a slope, among crates and on a lift",
    .dt = 1.0 / 60,
    .seconds = 20,
    .stepper = Stepper::kQuick,
    .build = build,
};

}  // namespace epode::scenes
