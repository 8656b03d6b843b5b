// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Breach: a wall that stands as one kinematic body of bricks (ode/fracture.h) is hit by three cannon balls; what is near a blow comes
// off, and the balls go on through it. Before it a vase of twelve staves falls from a pillar and breaks on the floor.
#include <cmath>

#include "scenes/assemblies.h"
#include "scenes/build.h"

namespace epode::scenes {

namespace {

constexpr Vec kBrick{0.5, 0.25, 0.25};
constexpr double kBricks = 1800, kClay = 2000;
constexpr int kCourses = 12, kAlong = 10;

dFracturePart part(Scene& scene, Vec size, Vec at, double density, Turn q = {})
{
    return {add_static_box(scene, size, at, q), dReal(density)};
}

void add_wall(Scene& scene)
{
    std::vector<dFracturePart> bricks;
    for (int course = 0; course < kCourses; ++course)
        for (int i = 0; i < kAlong; ++i) {
            const double shift = course % 2 ? 0.25 : -0.25;
            const double x = (i - (kAlong - 1) / 2.0) * kBrick.x + shift;
            bricks.push_back(part(scene, kBrick, {x, 0, (course + 0.5) * kBrick.z}, kBricks));
        }
    if (const dBodyID wall = add_breakable(scene, bricks, 300, 0.45)) dBodySetKinematic(wall);
}

void add_vase(Scene& scene, Vec at)
{
    constexpr int kStaves = 12;
    constexpr double kRadius = 0.3, kHeight = 0.7, kThick = 0.06;
    std::vector<dFracturePart> staves;
    for (int i = 0; i < kStaves; ++i) {
        const double angle = 2 * kPi * i / kStaves;
        const Vec out{kRadius * std::cos(angle), kRadius * std::sin(angle), kHeight / 2};
        const double width = 2 * (kRadius - kThick / 2) * std::tan(kPi / kStaves);
        staves.push_back(part(scene, {kThick, width, kHeight}, at + out, kClay, turn(kZ, angle)));
    }
    const dBodyID vase = add_breakable(scene, staves, 12, 10);
    if (vase) set_velocity(vase, {0, -1.2, 0}, {0.6, 0.3, 0});
}

void build(Scene& scene)
{
    add_ground(scene);
    add_wall(scene);
    add_static_box(scene, {0.8, 0.8, 1.6}, {3.4, -2.2, 0.8});
    add_vase(scene, {3.4, -2.5, 1.65});
    for (int i = 0; i < 3; ++i) {
        const dBodyID ball =
            add_sphere(scene, 0.19, 7700, {1.7 * (i - 1), -6.0 - 9 * i, 1.2 + 0.35 * ((i + 1) % 3)});
        set_velocity(ball, {0, 14, 1.6 + 2.7 * i});
        scene.tracked.push_back(ball);
    }
    set_view(scene, {-6.5, -8, 4}, {0.3, 0.6, 1});
}

}  // namespace

extern const Recipe kBreach = {
    .name = "breach",
    .description = "a brick wall breached by three cannon balls, and a vase that breaks",
    .dt = 0.005,
    .seconds = 2.5,
    .stepper = Stepper::kQuick,
    .build = build,
};

}  // namespace epode::scenes
