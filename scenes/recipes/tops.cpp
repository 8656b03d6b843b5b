// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Tops: three spinning tops on the floor with friction, a gyroscope that precesses on a ball joint, and a box
// that floats without gravity and turns about its middle axis, which is unstable: every few seconds it flips
// (Dzhanibekov). Spin is where an explicit gyroscopic term gains energy and an implicit one loses it; the
// box's energy and spin are constants of the motion, which the exact stepper keeps here by exact rotation
// (and 5 parts, for the precession).
#include "scenes/build.h"

namespace epode::scenes {

namespace {

// A disc on a thin stem with a round tip. Masses first, then shapes: the body's origin stays the centre of
// mass.
dBodyID add_top(Scene& scene, Vec tip, double radius, Turn lean, double spin)
{
    const double height = 0.9 * radius, tip_radius = 0.1 * radius;
    const Vec center = tip + rotate(lean, {0, 0, height}) + tip_radius * kZ;
    dBodyID top = add_cylinder(scene, radius, 0.3 * radius, 2000, center, lean);
    attach_cylinder(scene, top, tip_radius, 1.9 * height, {0, 0, 0.05 * height});
    attach_sphere(scene, top, tip_radius, {0, 0, -height});
    set_velocity(top, {}, spin * rotate(lean, kZ));
    return top;
}

void add_gyroscope(Scene& scene, Vec pivot)
{
    const Turn level = turn(kY, kPi / 2.4);
    const double arm = 0.45;
    dBodyID rotor = add_cylinder(scene, 0.25, 0.06, 3000, pivot + rotate(level, {0, 0, arm}), level);
    attach_cylinder(scene, rotor, 0.02, arm, {0, 0, -arm / 2});
    add_ball(scene, rotor, nullptr, pivot);
    set_velocity(rotor, {}, 90.0 * rotate(level, kZ));
    add_static_box(scene, {0.12, 0.12, pivot.z - 0.03}, {pivot.x, pivot.y, (pivot.z - 0.03) / 2});
}

void build(Scene& scene)
{
    add_ground(scene);
    add_top(scene, {-0.9, -0.2, 0}, 0.25, turn({1, 0.4, 0}, 0.15), 60);
    add_top(scene, {-0.1, -0.5, 0}, 0.18, turn({0, 1, 0}, 0.25), 90);
    add_top(scene, {0.6, -0.2, 0}, 0.32, turn({-1, 0.2, 0}, 0.10), 45);
    add_gyroscope(scene, {-0.6, 1.2, 1.0});

    dBodyID floating = add_box(scene, {0.6, 0.3, 0.12}, 800, {0.8, 1.0, 1.4});
    dBodySetGravityMode(floating, 0);
    set_velocity(floating, {}, {0.02, 6, 0.01});

    scene.step_precisely(5);
    scene.tracked = {floating, scene.bodies()[0]};
    scene.surface.mu = dReal(0.3);
    dWorldSetContactSurfaceLayer(scene.world(), dReal(0.0005));
    set_view(scene, {-1.2, -4.6, 2.3}, {0, 0.3, 0.55});
}

}  // namespace

extern const Recipe kTops = {
    .name = "tops",
    .description = "spinning tops, a gyroscope, and a floating box that flips about its middle axis",
    .dt = 0.002,
    .seconds = 5,
    .stepper = Stepper::kExact,
    .build = build,
};

}  // namespace epode::scenes
