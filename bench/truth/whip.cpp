// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A chain of 32 links on ball joints, let go horizontally, its last link heavier by a factor of 1 to 10^6. It
// swings down and whips: at time steps of 1/60 s the velocities are exact but the positions they lead to are
// not, and the joints gap. Measured: the worst gap of any joint over 10 s, in links; energy; the time of a
// step. Variant projected: the library's own closing of joints after each step, where it has one. A whip is
// chaotic, so two libraries part after some seconds for rounding alone: variant nudgedN shows how soon, and how
// far apart, by a velocity of N times 1e-12 m/s at the end, and the trace has the gap of every step.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "bench/truth/accuracy.h"
#include "scenes/build.h"
#include "scenes/extensions.h"
#include "scenes/measure.h"

namespace epode::bench {

namespace {

using namespace scenes;

constexpr int kLinks = 32;
constexpr int kProjections = 4;  // at most, in a step
constexpr std::string_view kNudged = "nudged";
constexpr double kPitch = 0.25, kRadius = 0.05, kSeconds = 10;

void build(Scene& scene, double end_mass)
{
    dBodyID previous = nullptr;
    for (int i = 0; i < kLinks; ++i) {
        const Vec from = (i * kPitch) * kX;
        dBodyID link = add_limb(scene, kRadius, 1000, from, from + kPitch * kX);
        set_bits(link, 1, 0);
        if (i == kLinks - 1) {
            dMass mass;
            dBodyGetMass(link, &mass);
            dMassAdjust(&mass, dReal(end_mass * mass.mass));
            dBodySetMass(link, &mass);
        }
        add_ball(scene, link, previous, from);
        previous = link;
    }
}

// What the chain gives up from the start until it hangs straight down.
double energy_of_fall(const Scene& scene)
{
    double sum = 0;
    for (dBodyID body : scene.bodies()) {
        dMass mass;
        dBodyGetMass(body, &mass);
        sum += mass.mass * 9.81 * dBodyGetPosition(body)[0];
    }
    return sum;
}

void write_trace(const std::string& path, const std::vector<double>& gaps)
{
    if (path.empty()) return;
    std::ofstream file(path);
    for (double gap : gaps) file << fmt::format("{:.17g}\n", gap);
}

}  // namespace

AccuracyResult run_whip(const AccuracyOptions& options)
{
    AccuracyResult result;
    const Recipe recipe = {"whip", "", options.dt, kSeconds, options.stepper, [](Scene&) {}};
    Scene scene(recipe);
    if (options.variant == "projected" && !set_step_projection(scene.world(), kProjections)) {
        result.available = false;
        return result;
    }
    build(scene, options.size > 0 ? options.size : 1);
    if (options.variant.starts_with(kNudged))
        set_velocity(scene.bodies().back(), 1e-12 * std::atoi(options.variant.c_str() + kNudged.size()) * kX);

    const double start = measure(scene).energy(), scale = energy_of_fall(scene);
    double rise = 0, end = 0;
    std::vector<double> times, gaps;
    for (int i = 0; i < int(std::lround(kSeconds / options.dt)); ++i) {
        scene.step(options.stepper, options.dt);
        times.push_back(scene.times().step_ms);
        result.seconds += scene.times().step_ms * 1e-3;
        gaps.push_back(worst_joint_error(scene) / kPitch);
        end = measure(scene).energy() - start;
        rise = std::max(rise, end);
    }
    result.error = *std::max_element(gaps.begin(), gaps.end());
    result.ok = bodies_not_finite(scene) == 0;
    result.details =
        fmt::format(" rise {:.3e} end {:.3e} ms {:.5f}", rise / scale, end / scale, quantile(times, 0.5));
    write_trace(options.trace, gaps);
    return result;
}

}  // namespace epode::bench
