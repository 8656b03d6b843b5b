// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// SimBenchmark's rolling test: a box of M = 10 kg on the ground, n = 25 balls of m = 1 kg on it, friction
// mu = 0.4 under the box and 0.8 under the balls, F = 150 N on the box, ERP = CFM = 0. With g = 9.81 the
// ground's friction is f1 = mu (M + n m) g; a solid ball that rolls on a box of acceleration a gets 2/7 a; so
//   a = (F - f1) / (M + 2/7 n m),
// and semi-implicit Euler makes v = a t exact. The force pushes along y, or at 45 degrees to x and y. ODE's
// friction is a pyramid whose axes come from the normal alone unless the user says otherwise, so that at 45
// degrees it holds sqrt(2) times too much and the box stays. Variant xy-fdir does what a user of a pyramid
// can do: gives the direction of sliding as the first friction direction of the contacts under the box.
#include <cmath>
#include <string>

#include "bench/truth/accuracy.h"
#include "scenes/build.h"
#include "scenes/measure.h"

namespace epode::bench {

namespace {

using namespace scenes;

constexpr int kAcross = 5;
constexpr double kBoxMass = 10, kBallMass = 1, kForce = 150, kGravity = 9.81;
constexpr double kGroundFriction = 0.4, kBallFriction = 0.8;
constexpr double kSeconds = 4, kPenetration = 2e-5, kRadius = 0.5;

struct Rig {
    dBodyID box = nullptr, ball = nullptr;
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
    const Vec size{20, 20, 1};
    const double pitch = 2, middle = 0.5 * (kAcross - 1);
    Rig rig;
    add_ground(scene);
    rig.box = add_box(scene, size, 1, {0, 0, size.z / 2 - kPenetration});
    set_mass(rig.box, kBoxMass);
    for (int i = 0; i < kAcross * kAcross; ++i) {
        const double x = pitch * (i % kAcross - middle), y = pitch * (i / kAcross - middle);
        rig.ball = add_sphere(scene, kRadius, 1, {x, y, size.z + kRadius - 2 * kPenetration});
        set_mass(rig.ball, kBallMass);
    }
    dWorldSetERP(scene.world(), 0);
    dWorldSetCFM(scene.world(), 0);
    return rig;
}

double squared(Vec a) { return a.x * a.x + a.y * a.y + a.z * a.z; }

Vec velocity(dBodyID body)
{
    const dReal* v = dBodyGetLinearVel(body);
    return {v[0], v[1], v[2]};
}

}  // namespace

AccuracyResult run_rolling(const AccuracyOptions& options)
{
    const bool diagonal = options.variant != "y", steered = options.variant == "xy-fdir";
    const double root = std::sqrt(0.5);
    const Vec along = diagonal ? Vec{root, root, 0} : kY;

    const Recipe recipe = {"rolling", "", options.dt, kSeconds, options.stepper, [](Scene&) {}};
    Scene scene(recipe);
    const Rig rig = build(scene);
    scene.on_contact = [&](dGeomID a, dGeomID b, dContact& contact) {
        const bool ground = !dGeomGetBody(a) || !dGeomGetBody(b);
        contact.surface.mu = dReal(ground ? kGroundFriction : kBallFriction);
        if (ground && steered) {
            contact.surface.mode |= dContactFDir1;
            contact.fdir1[0] = dReal(along.x);
            contact.fdir1[1] = dReal(along.y);
            contact.fdir1[2] = 0;
        }
        return true;
    };
    scene.set_iterations(int(options.size));

    const double balls = kAcross * kAcross;
    const double friction = kGroundFriction * (kBoxMass + balls * kBallMass) * kGravity;
    const double box_acceleration = (kForce - friction) / (kBoxMass + 2.0 / 7 * balls * kBallMass);
    const int steps = int(std::lround(kSeconds / options.dt));
    AccuracyResult result;
    for (int i = 0; i < steps; ++i) {
        dBodyAddForce(rig.box, dReal(kForce * along.x), dReal(kForce * along.y), 0);
        scene.step(options.stepper, options.dt);
        result.seconds += scene.times().total_ms() * 1e-3;
        const double speed = box_acceleration * (i + 1) * options.dt;
        result.error += (squared(velocity(rig.box) - speed * along) +
                         squared(velocity(rig.ball) - (2.0 / 7 * speed) * along)) /
                        steps;
    }
    result.ok = bodies_not_finite(scene) == 0;
    return result;
}

}  // namespace epode::bench
