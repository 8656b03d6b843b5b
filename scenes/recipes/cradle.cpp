// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Newton's cradle: five steel balls hung on hinges, the first raised, contacts that bounce fully. The balls
// hang 2 mm apart: contacts of one step are solved together, and a row of touching balls would share the
// impulse; apart, the blow goes down the row ball by ball.
#include "scenes/build.h"

namespace epode::scenes {

namespace {

constexpr int kBalls = 5;

void build(Scene& scene)
{
    const double radius = 0.1, gap = 0.002, length = 1, density = 7800, lift = 0.7;
    for (int i = 0; i < kBalls; ++i) {
        const Vec pivot{(i - 0.5 * (kBalls - 1)) * (2 * radius + gap), 0, 1.4};
        const Turn swing = turn(kY, i == 0 ? lift : 0);
        const Vec center = pivot + rotate(swing, {0, 0, -length});
        dBodyID ball = add_sphere(scene, radius, density, center);
        const dQuaternion q = {dReal(swing.w), dReal(swing.x), dReal(swing.y), dReal(swing.z)};
        dBodySetQuaternion(ball, q);
        dGeomID rod = attach_cylinder(scene, ball, 0.01, length - radius, {0, 0, (length + radius) / 2});
        dGeomSetCollideBits(rod, 0);
        dGeomSetCategoryBits(rod, 0);
        add_hinge(scene, ball, nullptr, pivot, kY);
    }
    scene.surface.mode = dContactBounce | dContactApprox1;
    scene.surface.mu = 0;
    scene.surface.bounce = 1;
    scene.surface.bounce_vel = 0;
    scene.tracked = {scene.bodies().front(), scene.bodies().back()};
    add_floor(scene);
    set_view(scene, {-1.0, -4.2, 1.4}, {-0.05, 0, 0.75});
}

}  // namespace

extern const Recipe kCradle = {
    .name = "cradle",
    .description = "Newton's cradle: five balls on hinges with full bounce",
    .dt = 0.001,
    .seconds = 5,
    .stepper = Stepper::kExact,
    .build = build,
};

}  // namespace epode::scenes
