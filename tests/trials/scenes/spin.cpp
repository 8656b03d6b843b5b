// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Free rigid bodies. Without torques the energy w.Iw/2 and the vector Iw (in the world's axes) are constant, a
// spin about the axis of the largest or the smallest moment stays there, and the axis of a symmetric body with
// moments A, A, C goes round the angular momentum L on a cone at the rate |L|/A.
#include "measure.h"

#include <algorithm>

namespace epode::trials {

namespace {

struct Spinner {
    Vec size, rate;
    int axis;  // of the spin if it is that of the largest moment, else -1
};
constexpr Vec kLong{1, 0.1, 0.02}, kPlate{0.5, 0.5, 0.01}, kRod{0.02, 0.02, 1};
const Spinner kSpinners[] = {
    {kLong, {40, 0.5, 0.5}, -1},  {kLong, {0.5, 40, 0.5}, -1},  {kLong, {0.5, 0.5, 40}, 2},
    {kPlate, {40, 0.5, 0.5}, -1}, {kPlate, {0.5, 40, 0.5}, -1}, {kPlate, {0.5, 0.5, 40}, 2},
    {kRod, {40, 0.5, 0.5}, -1},   {kRod, {0.5, 40, 0.5}, -1},   {kRod, {0.5, 0.5, 40}, -1},
};

void spin_freely(Run& run, const Spinner& spinner)
{
    Stage stage(run, {});
    const dBodyID body = stage.bar(spinner.size, 1, {});
    set_velocity(body, {}, spinner.rate);
    const double energy = kinetic_energy(body);
    const Vec start = angular_momentum(body);
    stage.advance(60, [&] {
        const Vec now = angular_momentum(body);
        run.record("energy", 100 * (kinetic_energy(body) / energy - 1));
        run.record("momentum", 100 * std::fabs(length(now) / length(start) - 1));
        run.record("direction", degrees_between(now, start));
        if (spinner.axis < 0) return;
        const Vec axis = rotate(orientation(body), spinner.axis == 0 ? kX : kZ);
        run.record("axis", std::min(degrees_between(axis, now), degrees_between(-1 * axis, now)));
    });
}

void spin_all(Run& run)
{
    for (const Spinner& spinner : kSpinners) spin_freely(run, spinner);
}

constexpr double kAcross = 0.01, kAlong = 0.02;  // kg m^2
constexpr Vec kTopRate{1, 0, 10};

// A midpoint rule turns by 2 tan(x/2) where x is right: (x^2)/12 off, of which the law allows twice.
double precession_bound(const Setting& setting)
{
    const double turned = length({kAcross * kTopRate.x, 0, kAlong * kTopRate.z}) / kAcross * setting.h();
    return 100 * turned * turned / 6 + 0.1;
}

void precess(Run& run)
{
    Stage stage(run, {});
    dMass mass;
    dMassSetParameters(&mass, 1, 0, 0, 0, kAcross, kAcross, kAlong, 0, 0, 0);
    const dBodyID top = stage.part(mass, {});
    set_velocity(top, {}, kTopRate);
    const Vec momentum = angular_momentum(top), about = (1 / length(momentum)) * momentum;
    const double rate = length(momentum) / kAcross, cone = degrees_between(kZ, momentum);
    const auto flat = [&](Vec axis) { return axis - dot(axis, about) * about; };
    Vec last = flat(kZ);
    double turned = 0, time = 0;
    stage.advance(5, [&] {
        const Vec axis = rotate(orientation(top), kZ), now = flat(axis);
        turned += std::atan2(dot(cross(last, now), about), dot(last, now));
        last = now;
        time += stage.h;
        run.record("cone", 100 * std::fabs(degrees_between(axis, momentum) / cone - 1));
    });
    run.record("precession", 100 * std::fabs(turned / (rate * time) - 1));
}

}  // namespace

extern const Scene kSpinningBoxes{
    "Free motion",
    "spinning_boxes",
    "long boxes, plates and rods spin at 40 rad/s in empty space for a minute (C3)",
    {{"energy", "gain of energy", "%", 0.5},
     {"momentum", "change of the length of the angular momentum", "%", 1},
     {"direction", "turn of the angular momentum", "degrees", 1},
     {"axis", "angle between a stable axis and the angular momentum", "degrees", 5}},
    &spin_all};

extern const Scene kFreeTop{"Free motion",
                            "free_top",
                            "a symmetric top precesses in empty space at |L|/A on a cone",
                            {{"precession", "error of the rate of precession", "%", &precession_bound},
                             {"cone", "change of the cone's angle", "%", 2}},
                            &precess};

}  // namespace epode::trials
