// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// SimBenchmark's tests with spheres of 10 kg and 0.1 m, without friction and error correction (ERP = 0):
//   bouncing     7 x 7 spheres fall from 5 m, restitution 1, 20 s: energy must stay
//   666          6 x 6 x 6 spheres 0.21 m apart, each moved by up to 1 mm, collapse on the ground,
//                restitution 0, 10 s: nothing may penetrate
//   elastic-666  the same from 1 m higher with restitution 1: energy must stay
// Its random numbers are its own, so our cube starts otherwise than the published one.
#include <fmt/format.h>

#include <cmath>

#include "bench/truth/accuracy.h"
#include "scenes/build.h"
#include "scenes/measure.h"

namespace epode::bench {

namespace {

using namespace scenes;

constexpr double kRadius = 0.1, kMass = 10, kGap = 0.21, kShift = 0.001;
constexpr std::uint32_t kSeed = 42;

struct Drop {
    int across, layers;
    double gap, height, shift, restitution, seconds;
};

void build(Scene& scene, const Drop& drop)
{
    const double volume = 4.0 / 3 * kPi * kRadius * kRadius * kRadius;
    const double middle = 0.5 * (drop.across - 1);
    Lcg random(kSeed);
    add_ground(scene);
    for (int i = 0; i < drop.across * drop.across * drop.layers; ++i) {
        const int column = i % drop.across, row = i / drop.across % drop.across,
                  layer = i / (drop.across * drop.across);
        const auto shift = [&] { return random.uniform(-drop.shift, drop.shift); };
        const double x = drop.gap * (column - middle) + shift(), y = drop.gap * (row - middle) + shift();
        add_sphere(scene, kRadius, kMass / volume, {x, y, drop.height + drop.gap * layer + shift()});
    }
    dWorldSetERP(scene.world(), 0);
    scene.surface.mode = dContactBounce;
    scene.surface.mu = 0;
    scene.surface.bounce = dReal(drop.restitution);
    scene.surface.bounce_vel = 0;
}

double sum_of_squares(const std::vector<ContactRecord>& contacts)
{
    double sum = 0;
    for (const ContactRecord& contact : contacts) sum += contact.depth * contact.depth;
    return sum;
}

AccuracyResult run(const AccuracyOptions& options, const Drop& drop)
{
    const Recipe recipe = {"spheres", "", options.dt, drop.seconds, options.stepper, [](Scene&) {}};
    Scene scene(recipe);
    build(scene, drop);
    scene.set_iterations(int(options.size));

    const double energy = measure(scene).energy();
    const int steps = int(std::lround(drop.seconds / options.dt));
    const bool elastic = drop.restitution > 0;
    double contacts = 0;
    AccuracyResult result;
    for (int i = 0; i < steps; ++i) {
        scene.step(options.stepper, options.dt);
        result.seconds += scene.times().total_ms() * 1e-3;
        contacts += double(scene.contacts().size());
        const double error =
            elastic ? std::pow(measure(scene).energy() - energy, 2) : sum_of_squares(scene.contacts());
        result.error += error / steps;
    }
    result.ok = bodies_not_finite(scene) == 0;
    result.details = fmt::format(" contacts {:.1f}", contacts / steps);
    return result;
}

}  // namespace

AccuracyResult run_bouncing(const AccuracyOptions& options)
{
    return run(options, {7, 1, 10 * kRadius, 5, 0, 1, 20});
}

AccuracyResult run_666(const AccuracyOptions& options)
{
    return run(options, {6, 6, kGap, kRadius + 0.001, kShift, 0, 10});
}

AccuracyResult run_elastic_666(const AccuracyOptions& options)
{
    return run(options, {6, 6, kGap, kRadius + 1.001, kShift, 1, 10});
}

}  // namespace epode::bench
