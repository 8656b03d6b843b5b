// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A fast flywheel whose axle is held at one end goes round at m g l / L and nods about that, without a loss.
#include "measure.h"

namespace epode::trials {

namespace {

void run_gyroscope(Run& run)
{
    constexpr double kArm = 0.2, kMass = 2, kArmMass = 0.5, kRadius = 0.15, kSpin = 100, kSeconds = 6;
    Stage stage(run);
    dMass mass;
    dMassSetBoxTotal(&mass, kArmMass, 0.02, 0.02, 0.02);
    const dBodyID arm = stage.part(mass, {});
    dMassSetCylinderTotal(&mass, kMass, 1, kRadius, 0.04);
    const dBodyID wheel = stage.part(mass, {});
    stage.ball_joint(arm, nullptr, {-kArm, 0, 0});
    stage.hinge(arm, wheel, {}, kX);
    set_velocity(wheel, {}, {kSpin, 0, 0});
    double heading = 0, turned = 0;
    stage.advance(kSeconds, [&] {
        const Vec x = position(wheel);
        const double now = std::atan2(x.y, x.x + kArm);
        turned += std::remainder(now - heading, 2 * kPi), heading = now;
        run.record("sinks", -100 * x.z / kArm);
        run.record("spin", 100 * std::fabs(length(spin(wheel)) / kSpin - 1));
    });
    const double momentum = kMass * kRadius * kRadius / 2 * kSpin,
                 law = (kMass + kArmMass) * kGravity * kArm / momentum * kSeconds;
    run.record("precession", 100 * std::fabs(turned / law - 1));
}

}  // namespace

extern const Scene kGyroscope{
    "Machines",
    "gyroscope",
    "a flywheel of 2 kg at 100 rad/s on a hinge of an arm that a ball joint holds, 6 s",
    {{"precession", "way round, off m g l/L", "%", 3},
     {"sinks", "how far it sinks, of its arm (it nods by 21)", "%", 25},
     {"spin", "its spin, off", "%", 0.5}},
    &run_gyroscope};

}  // namespace epode::trials
