// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A program's own spring: a force of -K x by dBodyAddForce before each step. With v' = v - h w^2 x and x' = x + h v' the quantity
// v^2/2 + w^2 x^2/2 - h w^2 x v/2 is constant, so that the energy is at most 1/(1 - w h/2) of what it was at first.
#include "measure.h"

#include <algorithm>

namespace epode::trials {

namespace {

constexpr double kStiffness = 400, kMass = 1, kStart = 0.1;
const double kRate = std::sqrt(kStiffness / kMass);

enum class Held { kOnFloor, kFree, kOnSlider };

void swing(Run& run, Held held, const char* law)
{
    Stage stage(run, held == Held::kOnFloor ? Vec{0, 0, -kGravity} : Vec{});
    stage.surface.friction = 0;
    if (held == Held::kOnFloor) stage.floor();
    const dBodyID box = stage.box({0.2, 0.2, 0.2}, kMass, {kStart, 0, 0.1});
    if (held == Held::kOnSlider) {
        const dJointID slider = dJointCreateSlider(stage.world, nullptr);
        dJointAttach(slider, box, nullptr);
        dJointSetSliderAxis(slider, 1, 0, 0);
    }
    const double start = kStiffness * kStart * kStart / 2;
    double least = HUGE_VAL;
    for (int i = stage.steps_in(3); i-- > 0;) {
        dBodyEnable(box);
        dBodyAddForce(box, -kStiffness * position(box).x, 0, 0);
        stage.step();
        const double x = position(box).x, v = velocity(box).x,
                     now = (kStiffness * x * x + kMass * v * v) / 2 / start;
        run.record(law, now);
        if (i * stage.h < 0.5) least = std::min(least, now);
    }
    run.record("least", 1 / least);
}

void swing_all(Run& run)
{
    swing(run, Held::kOnFloor, "floor");
    swing(run, Held::kFree, "free");
    swing(run, Held::kOnSlider, "slider");
}

double most_energy(const Setting& setting) { return 1.01 / (1 - kRate * setting.h() / 2); }
double least_energy(const Setting& setting) { return 1.01 * (1 + kRate * setting.h() / 2); }

// A steady wind on a body that sleeps: what it got asleep does not act when it wakes.
void wake_in_wind(Run& run)
{
    Stage stage(run, {});
    const dBodyID body = stage.bar({1, 1, 1}, 10, {});
    dBodyDisable(body);
    for (int i = 0; i < 1200; ++i) {
        dBodyAddForce(body, 10, 0, 0);
        stage.step();
    }
    dBodyEnable(body);
    dBodyAddForce(body, 10, 0, 0);
    stage.step();
    run.record("speed", velocity(body).x / stage.h);
}

}  // namespace

extern const Scene kSpring{
    "Machines",
    "spring",
    "a program's own spring of 3.2 Hz on a box that lies on a floor, is free, or is on a slider, 3 s",
    {{"floor", "largest energy over that of the start, on a floor without friction", "1", &most_energy},
     {"free", "the same, free", "1", &most_energy},
     {"slider", "the same, on a slider", "1", &most_energy},
     {"least", "energy of the start over the least of the last half second", "1", &least_energy}},
    &swing_all};

extern const Scene kWind{
    "Rest",
    "wind",
    "a program adds 10 N to a disabled body of 10 kg for 1,200 steps and then wakes it",
    {{"speed", "acceleration in the first step awake, 1 m/s^2 is right", "m/s^2", 1.001}},
    &wake_in_wind};

}  // namespace epode::trials
