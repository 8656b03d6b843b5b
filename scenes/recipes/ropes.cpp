// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Ropes: a bridge of planks with a hand rope on either side, hung on from loops (ode/rope.h), on which crates fall; and a ball on a
// rope that swings into a tower. Links and loads are within a few times each other's mass: substeps hold them.
#include <cmath>

#include "scenes/assemblies.h"
#include "scenes/build.h"

namespace epode::scenes {

namespace {

constexpr double kSpan = 9, kHeight = 2.4, kWidth = 1.6, kRail = 1.1;
constexpr int kPlanks = 30;

void add_towers(Scene& scene)
{
    for (const double side : {-1.0, 1.0}) {
        const double x = side * (kSpan / 2 + 0.75);
        add_static_box(scene, {1.4, 2.2, kHeight}, {x, 0, kHeight / 2});
        for (const double y : {-1.0, 1.0})
            add_static_box(scene, {0.14, 0.14, kRail},
                           {side * (kSpan / 2 + 0.12), 0.95 * y, kHeight + kRail / 2});
    }
}

void add_bridge(Scene& scene)
{
    dRopeSettings planks = rope_settings();
    planks.links = kPlanks, planks.length = dReal(1.012 * kSpan), planks.mass = 420,
    planks.width = dReal(kWidth);
    planks.radius = dReal(0.04);
    scene.tracked = add_rope(scene, {-kSpan / 2, 0, kHeight - 0.04}, {kSpan / 2, 0, kHeight - 0.04}, planks);
    dRopeSettings rail = rope_settings();
    rail.links = 36, rail.length = dReal(1.05 * kSpan), rail.mass = 30, rail.radius = dReal(0.03);
    for (const double y : {-0.95, 0.95})
        add_rope(scene, {-kSpan / 2 + 0.05, y, kHeight + kRail - 0.05},
                 {kSpan / 2 - 0.05, y, kHeight + kRail - 0.05}, rail);
}

void add_load(Scene& scene)
{
    for (int i = 0; i < 7; ++i)
        add_box(scene, {0.5, 0.5, 0.5}, 250,
                {0.75 * (i - 3), i % 2 ? 0.25 : -0.25, kHeight + 0.7 + 0.35 * (i % 3)}, turn(kZ, 0.4 * i));
}

// A ball of 70 kg on a rope of 25 links of 2 kg, drawn aside.
void add_pendulum(Scene& scene, Vec top)
{
    const double length = 3.2, angle = 1.0;
    const Vec end = top + Vec{-length * std::sin(angle), 0, -length * std::cos(angle)};
    const double radius = 0.13;
    const Vec centre = end + Vec{-radius * std::sin(angle), 0, -radius * std::cos(angle)};
    const dBodyID ball = add_sphere(scene, radius, 7600, centre);
    dRopeSettings rope = rope_settings();
    rope.links = 25, rope.mass = 50, rope.radius = dReal(0.03);
    add_rope(scene, top, end, rope, ball);
    add_static_box(scene, {0.2, 2.4, 0.2}, top + Vec{0, 0, 0.12});
    for (const double y : {-1.1, 1.1})
        add_static_box(scene, {0.2, 0.2, top.z}, {top.x, top.y + y, top.z / 2});
    for (int i = 0; i < 5; ++i) add_box(scene, {0.4, 0.4, 0.4}, 150, {top.x + 0.35, top.y, 0.2 + 0.4 * i});
}

void build(Scene& scene)
{
    add_ground(scene);
    add_towers(scene);
    add_bridge(scene);
    add_load(scene);
    add_pendulum(scene, {1.4, -3.8, 4});
    dWorldSetContactSurfaceLayer(scene.world(), dReal(0.001));
    set_view(scene, {-5.5, -11.5, 5}, {0.2, -0.9, 1.9});
}

}  // namespace

extern const Recipe kRopes = {
    .name = "ropes",
    .description = "a bridge of planks with hand ropes, loaded with crates, and a ball on a rope",
    .dt = 0.005,
    .seconds = 4,
    .stepper = Stepper::kQuick,
    .build = build,
};

}  // namespace epode::scenes
