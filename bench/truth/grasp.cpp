// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A capsule of 45 g and 4 mm radius hangs upright between two pads, one held in place by a motor, the other
// pushed against it with a given force; friction 0.7 could hold far more than its weight. Hard contact should
// not let it creep: what is left of slip is CFM times the friction force, for that is what CFM means.
// Measured over 9 s after 1 s of settling: how far the capsule's centre moves past the pads' faces, per
// second.
#include <fmt/format.h>

#include <cmath>

#include "bench/truth/accuracy.h"
#include "scenes/build.h"
#include "scenes/measure.h"

namespace epode::bench {

namespace {

using namespace scenes;

constexpr double kRadius = 0.004, kLength = 0.06, kMass = 0.045;
constexpr double kPadMass = 0.1, kFriction = 0.7, kDefaultLoad = 12, kHolding = 1e4;
constexpr double kOverlap = 1e-6;  // so that they touch from the first step on
constexpr double kSettle = 1, kSeconds = 10;

struct Rig {
    dBodyID capsule, held, pushed;
};

void set_mass(dBodyID body, double mass)
{
    dMass m;
    dBodyGetMass(body, &m);
    dMassAdjust(&m, dReal(mass));
    dBodySetMass(body, &m);
}

Rig build(Scene& scene)
{
    const Vec pad{0.01, 0.03, 0.03};
    const double reach = kRadius + pad.x / 2 - kOverlap;
    Rig rig;
    rig.capsule = add_capsule(scene, kRadius, kLength, 1000, {0, 0, 0});
    set_mass(rig.capsule, kMass);
    rig.held = add_box(scene, pad, 1000, {-reach, 0, 0});
    rig.pushed = add_box(scene, pad, 1000, {reach, 0, 0});
    for (dBodyID body : {rig.held, rig.pushed}) set_mass(body, kPadMass);
    dJointID motor = add_slider(scene, rig.held, nullptr, kX);
    dJointSetSliderParam(motor, dParamVel, 0);
    dJointSetSliderParam(motor, dParamFMax, dReal(kHolding));
    add_slider(scene, rig.pushed, nullptr, kX);
    scene.surface.mu = dReal(kFriction);
    return rig;
}

// Across the pads' normal.
Vec slip(const Rig& rig)
{
    const dReal *c = dBodyGetPosition(rig.capsule), *a = dBodyGetPosition(rig.held),
                *b = dBodyGetPosition(rig.pushed);
    return {0, c[1] - 0.5 * (a[1] + b[1]), c[2] - 0.5 * (a[2] + b[2])};
}

}  // namespace

AccuracyResult run_grasp(const AccuracyOptions& options)
{
    const double load = options.size > 0 ? options.size : kDefaultLoad;
    const Recipe recipe = {"grasp", "", options.dt, kSeconds, options.stepper, [](Scene&) {}};
    Scene scene(recipe);
    const Rig rig = build(scene);

    const int steps = int(std::lround(kSeconds / options.dt)),
              settled = int(std::lround(kSettle / options.dt));
    Vec before;
    AccuracyResult result;
    double contacts = 0;
    for (int i = 0; i < steps; ++i) {
        if (i == settled) before = slip(rig);
        dBodyAddForce(rig.pushed, dReal(-load), 0, 0);
        scene.step(options.stepper, options.dt);
        result.seconds += scene.times().total_ms() * 1e-3;
        contacts += double(scene.contacts().size());
    }
    const Vec moved = slip(rig) - before;
    result.error = std::hypot(moved.y, moved.z) / (kSeconds - kSettle);
    result.ok = bodies_not_finite(scene) == 0;
    result.details = fmt::format(" contacts {:.2f} fallen {:.3e}", contacts / steps, -slip(rig).z);
    return result;
}

}  // namespace epode::bench
