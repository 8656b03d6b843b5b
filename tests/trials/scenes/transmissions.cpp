// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Machines with a closed form: what couples axes, what holds a load, what swings.
#include "measure.h"

#include <algorithm>

namespace epode::trials {

namespace {

dJointID slide(Stage& stage, dBodyID body, Vec axis)
{
    const dJointID joint = dJointCreateSlider(stage.world, nullptr);
    dJointAttach(joint, body, nullptr);
    dJointSetSliderAxis(joint, axis.x, axis.y, axis.z);
    return joint;
}

dBodyID disc(Stage& stage, double mass, double radius, Vec at)
{
    dMass m;
    dMassSetCylinderTotal(&m, mass, 3, radius, 0.05);
    return stage.part(m, at);
}

dJointID couple(Stage& stage, dJointID first, dJointID second, double factor)
{
    const dJointID coupling = dJointCreateCoupling(stage.world, nullptr);
    dJointSetCouplingAxis(coupling, 0, first, 0, 1);
    dJointSetCouplingAxis(coupling, 1, second, 0, dReal(factor));
    return coupling;
}

// 5 and 4.5 kg over a pulley; 4 kg on a rack whose pinion has I / r^2 = 12 kg, three tenths of a second.
void run_couplings(Run& run)
{
    {
        Stage stage(run);
        const dBodyID heavy = stage.bar({0.1, 0.1, 0.1}, 5, {}), light = stage.bar({0.1, 0.1, 0.1}, 4.5, kX);
        couple(stage, slide(stage, heavy, kZ), slide(stage, light, kZ), 1);
        stage.advance(2);
        const double time = stage.steps_in(2) * stage.h;
        run.record("pulley", 100 * std::fabs(-velocity(heavy).z / time / (kGravity * 0.5 / 9.5) - 1));
    }
    Stage stage(run);
    const dBodyID rack = stage.bar({0.1, 0.1, 0.1}, 4, {}), pinion = disc(stage, 6, 0.2, kX);
    couple(stage, slide(stage, rack, kZ), stage.hinge(pinion, nullptr, kX, kZ), -0.1);
    stage.advance(0.3);
    const double time = stage.steps_in(0.3) * stage.h;
    run.record("rack", 100 * std::fabs(-velocity(rack).z / time / (kGravity * 4 / 16) - 1));
}

// Gears of 1 : 3 : 9 by transmissions, 0.05 N m at the first.
void run_gears(Run& run)
{
    const double radius[] = {0.05, 0.15, 0.45}, mass[] = {0.2, 1, 5};
    Stage stage(run.setting, {});
    dBodyID gears[3];
    double inertia = 0, x = 0;
    for (int i = 0; i < 3; ++i) {
        if (i) x += radius[i - 1] + radius[i];
        gears[i] = disc(stage, mass[i], radius[i], {x, 0, 0});
        stage.hinge(gears[i], nullptr, {x, 0, 0}, kZ);
        inertia += mass[i] * radius[0] * radius[0] / 2;
        if (i == 0) continue;
        const dJointID teeth = dJointCreateTransmission(stage.world, nullptr);
        dJointAttach(teeth, gears[i - 1], gears[i]);
        dJointSetTransmissionMode(teeth, dTransmissionParallelAxes);
        const Vec first = position(gears[i - 1]), second = position(gears[i]);
        dJointSetTransmissionAnchor1(teeth, first.x, first.y, first.z);
        dJointSetTransmissionAnchor2(teeth, second.x, second.y, second.z);
        dJointSetTransmissionAxis(teeth, 0, 0, 1);
        dJointSetTransmissionRatio(teeth, radius[i - 1] / radius[i]);
    }
    const int steps = stage.steps_in(1);
    for (int i = 0; i < steps; ++i) {
        dBodyAddTorque(gears[0], 0, 0, dReal(0.05));
        stage.step();
    }
    const double rate = spin(gears[0]).z;
    run.record("gears", 100 * std::fabs(rate * inertia / (0.05 * steps * stage.h) - 1));
    for (int i = 1; i < 3; ++i)
        run.record("ratio", 100 * std::fabs(std::fabs(spin(gears[i]).z / rate) * radius[i] / radius[0] - 1));
}

// A ball goes round on a rod, its end at the ball's centre: cos a = g / (w^2 L).
void run_conical(Run& run)
{
    constexpr double kRate = 5, kMass = 2, kCosine = kGravity / (kRate * kRate);
    const double sine = std::sqrt(1 - kCosine * kCosine);
    Stage stage(run);
    dMass mass;
    dMassSetSphereTotal(&mass, kMass, 0.1);
    const dBodyID ball = stage.part(mass, {sine, 0, -kCosine});
    const dJointID rod = dJointCreateDBall(stage.world, nullptr);
    dJointAttach(rod, ball, nullptr);
    dJointSetDBallAnchor1(rod, sine, 0, -kCosine), dJointSetDBallAnchor2(rod, 0, 0, 0);
    dJointFeedback feedback;
    dJointSetFeedback(rod, &feedback);
    set_velocity(ball, {0, kRate * sine, 0});
    double tension = 0;
    stage.advance(4, [&] {
        tension += length(vec(feedback.f1)) / stage.steps_in(4);
        const double angle = std::atan2(across(position(ball)), -position(ball).z);
        run.record("angle", degrees(std::fabs(angle - std::acos(kCosine))));
    });
    run.record("tension", 100 * std::fabs(tension * kCosine / (kMass * kGravity) - 1));
}

double conical_bound(const Setting& setting)
{
    return (setting.method == Method::kSubsteps ? 5 : 2) * 60 * setting.h();
}
double tension_bound(const Setting& setting)
{
    return (setting.method == Method::kSubsteps ? 12 : 3) * 60 * setting.h();
}

// A crate of 800 kg on eight links of 2 kg is lifted by 1 m, stopped, held.
void run_crane(Run& run)
{
    Stage stage(run);
    stage.floor();
    const dBodyID hoist = stage.bar({0.3, 0.3, 0.3}, 100, {0, 0, 6});
    const dJointID motor = slide(stage, hoist, kZ);
    dJointSetSliderParam(motor, dParamFMax, 50000);
    std::vector<dJointID> joints;
    dBodyID last = hoist;
    for (int i = 0; i < 8; ++i) {
        const dBodyID link = stage.bar({0.05, 0.05, 0.5}, 2, {0, 0, 5.75 - 0.5 * i});
        joints.push_back(stage.ball_joint(link, last, {0, 0, 6 - 0.5 * i}));
        last = link;
    }
    const dBodyID crate = stage.box({1, 1, 1}, 800, {0, 0, 1.5});
    joints.push_back(stage.ball_joint(crate, last, {0, 0, 2}));
    for (double speed : {0.0, 0.5, 0.0}) {
        dJointSetSliderParam(motor, dParamVel, dReal(speed));
        stage.advance(speed > 0 ? 2 : 1, [&] {
            for (dJointID joint : joints) run.record("rope", 1000 * gap(joint));
        });
    }
    run.record("load", 1000 * std::fabs(position(crate).z - 1.5 - 0.5 * stage.steps_in(2) * stage.h));
}

// Hooks in a row, each with a share of the load that it carries as its limit.
void hang(Run& run, double share)
{
    Stage stage(run);
    std::vector<dJointID> hooks;
    dBodyID last = nullptr;
    for (int i = 0; i < 4; ++i) {
        const dBodyID load = stage.bar({0.2, 0.2, 0.2}, 50, {0, 0, -0.4 * i - 0.2});
        hooks.push_back(i % 2 ? stage.ball_joint(load, last, {0, 0, -0.4 * i})
                              : stage.hinge(load, last, {0, 0, -0.4 * i}, kY));
        dJointSetBreakLimits(hooks.back(), dReal(share * (4 - i) * 50 * kGravity), 0);
        last = load;
    }
    stage.advance(share > 1 ? 2 : 0.5);
    int broken = 0;
    for (dJointID hook : hooks) broken += dJointIsBroken(hook);
    if (share > 1)
        run.record("broken", broken);
    else
        run.record("held", broken == 0);
}

void run_hooks(Run& run)
{
    hang(run, 1.1);
    hang(run, 0.9);
}

}  // namespace

extern const Scene kCouplings{"Machines",
                              "couplings",
                              "5 and 4.5 kg over a pulley for 2 s; 4 kg on a rack and pinion for 0.3 s",
                              {{"pulley", "acceleration over the pulley, off the law", "%", 0.1},
                               {"rack", "acceleration on the rack, off the law", "%", 0.2}},
                              &run_couplings};

extern const Scene kGears{"Machines",
                          "gears",
                          "gears of 1 : 3 : 9 under 0.05 N m at the first, 1 s",
                          {{"gears", "acceleration, off that of the reflected inertia", "%", 0.5},
                           {"ratio", "rates, off the ratios", "%", 0.1}},
                          &run_gears};

extern const Scene kConical{"Machines",
                            "conical",
                            "a ball of 2 kg goes round on a rod of 1 m at 5 rad/s, 4 s",
                            {{"angle", "angle of the rod, off the law", "degrees", &conical_bound},
                             {"tension", "mean tension, off the law", "%", &tension_bound}},
                            &run_conical};

extern const Scene kCrane{"Machines",
                          "crane",
                          "a crate of 800 kg on eight links of 2 kg is lifted by 1 m and held",
                          {{"rope",
                            "gap of a joint",
                            "mm",
                            3,
                            {{kSweeps | Method::kSubsteps, 1000,
                              "Light bodies that carry heavy ones (guide/howto/mass_ratios.md)"}}},
                           {"load",
                            "height of the crate, off the law",
                            "mm",
                            5,
                            {{kSweeps | Method::kSubsteps, 1000,
                              "Light bodies that carry heavy ones (guide/howto/mass_ratios.md)"}}}},
                          &run_crane};

extern const Scene kHooks{
    "Joints",
    "hooks",
    "four loads of 50 kg on hooks with break limits of 1.1 and 0.9 of what they carry",
    {{"broken",
      "hooks at 1.1 that break",
      "1",
      0,
      {{set_of(Method::kSubsteps), 4, "Substeps find the forces of a load by ringing (guide/steppers.md)"}}},
     {"held", "1 if all at 0.9 hold", "1", 0}},
    &run_hooks};

}  // namespace epode::trials
