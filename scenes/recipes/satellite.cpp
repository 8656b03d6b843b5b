// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Satellite: six bodies joined by every articulated joint type tumble in empty space, with no gravity and
// nothing to touch. Whatever the joints do inside, linear and angular momentum of the whole are conserved by
// the motion: what drifts is the stepper's error. Linear momentum stays to rounding with all of them; angular
// momentum to 4e-4 in 10 s with ODE's step, to 5e-6 with the exact rotation and 20 parts of the exact
// stepper. Energy goes where the stops of the panel and the rail are met.
#include "scenes/build.h"

namespace epode::scenes {

namespace {

void build(Scene& scene)
{
    dWorldSetGravity(scene.world(), 0, 0, 0);
    const double density = 300;
    const Vec middle{0, 0, 2};
    dBodyID hub = add_box(scene, {0.8, 0.8, 1.0}, density, middle);
    dBodyID left = add_box(scene, {0.6, 1.6, 0.05}, density, middle + Vec{0, -1.3, 0});
    dBodyID right = add_box(scene, {0.6, 1.6, 0.05}, density, middle + Vec{0, 1.3, 0});
    dBodyID boom = add_limb(scene, 0.06, density, middle + Vec{0, 0, 0.55}, middle + Vec{0, 0, 1.7});
    dBodyID dish = add_cylinder(scene, 0.5, 0.1, density, middle + Vec{0, 0, 1.8});
    dBodyID mast = add_box(scene, {0.9, 0.12, 0.12}, density, middle + Vec{0.95, 0, 0});

    dJointID panel = add_hinge(scene, hub, left, middle + Vec{0, -0.45, 0}, kY);
    set_hinge_stops(panel, -1, 1);
    add_hinge(scene, hub, right, middle + Vec{0, 0.45, 0}, kX);
    add_universal(scene, hub, boom, middle + Vec{0, 0, 0.52}, kX, kY);
    add_ball(scene, boom, dish, middle + Vec{0, 0, 1.72});
    dJointID rail = add_slider(scene, hub, mast, kX);
    dJointSetSliderParam(rail, dParamLoStop, dReal(-0.2));
    dJointSetSliderParam(rail, dParamHiStop, dReal(0.2));

    set_velocity(dish, {0.4, 0, 0}, {0, 0.5, 3});
    set_velocity(left, {}, {0, 1.0, 0});
    set_velocity(hub, {}, {0.3, 0.2, 0.5});
    for (dBodyID body : scene.bodies()) set_bits(body, 1, 0);
    scene.step_precisely(20);
    scene.isolated = true;
    scene.tracked = {hub};
    set_view(scene, {-3.2, -6.5, 4.2}, {0, 0, 2.4});
}

}  // namespace

extern const Recipe kSatellite = {
    .name = "satellite",
    .description = "six jointed bodies tumbling in empty space, where momentum is conserved",
    .dt = 0.005,
    .seconds = 10,
    .stepper = Stepper::kExact,
    .build = build,
};

}  // namespace epode::scenes
