// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Four-bar linkages: closed loops of four hinges with parallel axes. Counted blindly each has 3 bodies, 18
// freedoms, and 4 hinges, 20 rows, so it should not move; it does, because three rows of the twenty only
// repeat others. The row matrix is singular: the case where a factorisation without regularisation breaks.
// One linkage is driven by a motor in its crank (Grashof: shortest + longest < sum of the others, so the
// crank goes round); the other swings freely, without a
// loss: exact rotation and 10 parts for the exact stepper.
#include <cmath>

#include "scenes/build.h"

namespace epode::scenes {

namespace {

constexpr double kDensity = 2000, kThick = 0.05;

struct Linkage {
    double ground, crank, coupler, rocker;
    double side;  // of the line from crank to rocker on which coupler and rocker meet
};

// Where circles around a and b with radii ra and rb meet, on the left of a->b, or for side = -1 on the right.
// All in the plane y = const.
Vec meet(Vec a, double ra, Vec b, double rb, double side)
{
    const Vec ab = b - a;
    const double d = std::sqrt(ab.x * ab.x + ab.z * ab.z);
    const double along = (ra * ra - rb * rb + d * d) / (2 * d), up = std::sqrt(ra * ra - along * along);
    const Vec e = (1 / d) * ab;
    return a + along * e + side * up * Vec{-e.z, 0, e.x};
}

dBodyID add_bar(Scene& scene, Vec from, Vec to)
{
    dBodyID bar = add_limb(scene, kThick, kDensity, from, to);
    set_bits(bar, 1, 0);
    return bar;
}

dJointID add_linkage(Scene& scene, const Linkage& sizes, Vec a, double crank_angle)
{
    const Vec d = a + sizes.ground * kX;
    const Vec b = a + sizes.crank * Vec{std::cos(crank_angle), 0, std::sin(crank_angle)};
    const Vec c = meet(b, sizes.coupler, d, sizes.rocker, sizes.side);
    dBodyID crank = add_bar(scene, a, b), coupler = add_bar(scene, b, c), rocker = add_bar(scene, c, d);
    dJointID drive = add_hinge(scene, crank, nullptr, a, kY);
    add_hinge(scene, crank, coupler, b, kY);
    add_hinge(scene, coupler, rocker, c, kY);
    add_hinge(scene, rocker, nullptr, d, kY);
    return drive;
}

void build(Scene& scene)
{
    dJointID drive = add_linkage(scene, {1.0, 0.35, 0.95, 0.75, 1}, {-1.4, 0, 0.8}, 1.0);
    dJointSetHingeParam(drive, dParamVel, dReal(2 * kPi));
    dJointSetHingeParam(drive, dParamFMax, 200);
    // Hung from above: coupler and rocker meet below the ground link, so it swings like a pendulum.
    add_linkage(scene, {1.0, 0.8, 0.6, 0.8, -1}, {0.5, 0, 1.9}, -1.65);
    scene.step_precisely(10);
    scene.tracked = {scene.bodies()[1], scene.bodies()[4]};
    add_floor(scene);
    set_view(scene, {0.4, -5.2, 1.9}, {0.25, 0, 1.15});
}

}  // namespace

extern const Recipe kFourbar = {
    .name = "fourbar",
    .description = "two four-bar linkages, redundant closed loops, one driven and one swinging",
    .dt = 0.005,
    .seconds = 10,
    .stepper = Stepper::kExact,
    .build = build,
};

}  // namespace epode::scenes
