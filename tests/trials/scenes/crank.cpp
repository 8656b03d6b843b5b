// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A crank of radius r turns at a constant rate w and moves a slider of mass m by a rod of length l. With c = cos(w t), s = sin(w t)
// and q = sqrt(l^2 - r^2 s^2) the slider is at x = r c + q, and the pin pulls it with
//     m x'' = -m r w^2 (c + r (c^2 - s^2)/q + r^3 s^2 c^2/q^3).
#include "measure.h"

#include <algorithm>

namespace epode::trials {

namespace {

constexpr double kRadius = 0.1, kRod = 0.3, kRate = 10, kSlider = 1;

double pin_force(double angle)
{
    const double c = std::cos(angle), s = std::sin(angle),
                 q = std::sqrt(kRod * kRod - kRadius * kRadius * s * s);
    return -kSlider * kRadius * kRate * kRate *
           (c + kRadius * (c * c - s * s) / q + std::pow(kRadius, 3) * s * s * c * c / (q * q * q));
}

void turn_crank(Run& run)
{
    Stage stage(run, {});
    const dBodyID crank = stage.bar({kRadius, 0.02, 0.02}, 0.2, {kRadius / 2, 0, 0}),
                  rod = stage.bar({kRod, 0.02, 0.02}, 0.3, {kRadius + kRod / 2, 0, 0}),
                  slider = stage.bar({0.05, 0.05, 0.05}, kSlider, {kRadius + kRod, 0, 0});
    const dJointID shaft = stage.hinge(crank, nullptr, {}, kZ);
    dJointSetHingeParam(shaft, dParamVel, kRate);
    dJointSetHingeParam(shaft, dParamFMax, 1e4);
    stage.hinge(crank, rod, {kRadius, 0, 0}, kZ);
    const dJointID pin = stage.hinge(rod, slider, {kRadius + kRod, 0, 0}, kZ);
    const dJointID guide = dJointCreateSlider(stage.world, nullptr);
    dJointAttach(guide, slider, nullptr);
    dJointSetSliderAxis(guide, 1, 0, 0);
    // All bodies move at once as the crank asks for: x' = 0 here, the rod turns by -r/l of the crank's rate.
    set_velocity(crank, {0, kRate * kRadius / 2, 0}, {0, 0, kRate});
    set_velocity(rod, {0, kRate * kRadius / 2, 0}, {0, 0, -kRate * kRadius / kRod});
    dJointFeedback feedback;
    dJointSetFeedback(pin, &feedback);
    const double largest = std::fabs(pin_force(0));
    double angle = 0, time = 0;
    stage.advance(3, [&] {
        const double rate = spin(crank).z;
        time += stage.h;
        if (time > 0.2)  // the mean of a step is the force at its middle
            run.record(
                "force",
                100 * std::fabs(double(feedback.f2[0]) - pin_force(angle + rate * stage.h / 2)) / largest);
        angle += rate * stage.h;
        run.record("gap", 1000 * gap(pin));
    });
    run.record("rate", 100 * std::fabs(angle / (kRate * time) - 1));
}

// A step is of first order: so far the crank turns in one.
double force_bound(const Setting& setting) { return 100 * kRate * setting.h(); }
double gap_bound(const Setting& setting)
{
    const double turned = kRate * setting.h();
    return 1000 * kRod * turned * turned;
}

}  // namespace

extern const Scene kSliderCrank{
    "Machines",
    "slider_crank",
    "a motor turns a crank of 0.1 m at 10 rad/s, a rod moves a slider of 1 kg",
    {{"force", "error of the force at the slider's pin, of its largest", "%", &force_bound},
     {"rate", "error of the crank's rate", "%", 0.1},
     {"gap", "opening of the pin", "mm", &gap_bound}},
    &turn_crank};

}  // namespace epode::trials
