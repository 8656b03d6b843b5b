// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Ragdolls: six figures fall onto a flight of stairs. Each has 11 limbs of human proportion (1.75 m, water's
// density) and 10 joints: a ball in the neck, universal joints with stops in waist, shoulders and hips,
// hinges with stops in elbows and knees. Shoulders are universal and not ball joints: a ball joint has no
// stops, and an arm through the chest is not a ragdoll.
#include "scenes/build.h"

namespace epode::scenes {

namespace {

constexpr double kDensity = 1000;
constexpr int kSteps = 9;

// Points of a standing figure facing +x, its left at +y; feet at z = 0.
struct Figure {
    Vec at;
    Turn facing;
    Vec operator()(Vec p) const { return at + rotate(facing, p); }
    Vec axis(Vec a) const { return rotate(facing, a); }
};

dBodyID limb(Scene& scene, const Figure& f, double radius, Vec from, Vec to)
{
    return add_limb(scene, radius, kDensity, f(from), f(to));
}

// Swing forward about y, spread about x; stops turn with the side so that both sides bend alike.
void add_leg(Scene& scene, const Figure& f, dBodyID pelvis, double side)
{
    dBodyID thigh = limb(scene, f, 0.075, {0, side * 0.10, 0.92}, {0, side * 0.10, 0.46});
    dBodyID shin = limb(scene, f, 0.055, {0, side * 0.10, 0.48}, {0, side * 0.10, 0.02});
    dJointID hip = add_universal(scene, pelvis, thigh, f({0, side * 0.10, 0.88}), f.axis(kY), f.axis(kX));
    set_universal_stops(hip, -1.6, 0.5, -0.5, 0.5);
    dJointID knee = add_hinge(scene, thigh, shin, f({0, side * 0.10, 0.47}), f.axis(kY));
    set_hinge_stops(knee, -0.05, 2.2);
}

void add_arm(Scene& scene, const Figure& f, dBodyID chest, double side)
{
    dBodyID upper = limb(scene, f, 0.045, {0, side * 0.22, 1.42}, {0, side * 0.22, 1.10});
    dBodyID fore = limb(scene, f, 0.040, {0, side * 0.22, 1.12}, {0, side * 0.22, 0.82});
    dJointID shoulder = add_universal(scene, chest, upper, f({0, side * 0.20, 1.39}), f.axis(kY), f.axis(kX));
    set_universal_stops(shoulder, -2.4, 0.8, -0.9, 0.9);
    dJointID elbow = add_hinge(scene, upper, fore, f({0, side * 0.22, 1.11}), f.axis(kY));
    set_hinge_stops(elbow, -2.3, 0.05);
}

void add_ragdoll(Scene& scene, const Figure& f, Vec velocity)
{
    const size_t first = scene.bodies().size();
    dBodyID pelvis = limb(scene, f, 0.11, {0, -0.17, 0.95}, {0, 0.17, 0.95});
    dBodyID chest = add_box(scene, {0.20, 0.32, 0.36}, kDensity, f({0, 0, 1.26}), f.facing);
    dBodyID head = add_sphere(scene, 0.11, kDensity, f({0, 0, 1.62}));
    dJointID waist = add_universal(scene, pelvis, chest, f({0, 0, 1.05}), f.axis(kY), f.axis(kX));
    set_universal_stops(waist, -0.9, 0.4, -0.4, 0.4);
    add_ball(scene, chest, head, f({0, 0, 1.49}));
    for (double side : {-1.0, 1.0}) {
        add_leg(scene, f, pelvis, side);
        add_arm(scene, f, chest, side);
    }
    for (size_t i = first; i < scene.bodies().size(); ++i) set_velocity(scene.bodies()[i], velocity);
}

// Limbs of one figure pass through each other except where they matter for the looks: figures meet only other
// figures and the stairs.
void separate_limbs(Scene& scene, size_t first, int figure)
{
    for (size_t i = first; i < scene.bodies().size(); ++i) {
        set_bits(scene.bodies()[i], 2ul << figure, ~(2ul << figure));
    }
}

void build(Scene& scene)
{
    const double tread = 0.45, rise = 0.22, width = 6;
    add_ground(scene);
    for (int i = 0; i < kSteps; ++i) {
        const double height = (kSteps - i) * rise;
        add_static_box(scene, {tread, width, height}, {(i + 0.5) * tread, 0, height / 2});
    }
    add_static_box(scene, {2, width, kSteps * rise}, {-1, 0, kSteps * rise / 2});

    Lcg random(scene.seed());
    for (int figure = 0; figure < 6; ++figure) {
        const size_t first = scene.bodies().size();
        const Vec at{-0.7 + 0.8 * (figure % 2), -2.0 + 0.8 * figure,
                     kSteps * rise + 0.15 + 0.1 * (figure % 3)};
        add_ragdoll(scene, {at, turn(kZ, random.uniform(-0.7, 0.7))}, {random.uniform(1.6, 2.4), 0, 0});
        separate_limbs(scene, first, figure);
    }
    scene.surface.mu = dReal(0.5);
    dWorldSetContactSurfaceLayer(scene.world(), dReal(0.001));
    dWorldSetContactMaxCorrectingVel(scene.world(), 5);
    set_view(scene, {8.6, -6.6, 3.6}, {2.1, 0, 0.8});
}

}  // namespace

extern const Recipe kRagdolls = {
    .name = "ragdolls",
    .description = "six ragdolls of 11 limbs falling down a flight of stairs",
    .dt = 0.005,
    .seconds = 4,
    .stepper = Stepper::kQuick,
    .build = build,
};

}  // namespace epode::scenes
