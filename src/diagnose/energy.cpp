// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Energy from nowhere: the step's change of kinetic energy and that of weight, less the work of the program's
// forces over the mean of the velocities before and after. Worlds whose joints and contacts may add energy
// (motors, drives, soft joints, kinematic bodies) are not judged. Below what bodies gain in thirty steps of
// falling, nothing is said: piles settle with as much.
#include "diagnose/cause.h"

#include "joints/limit_motor.h"
#include "joints/parts.h"

namespace epode {
namespace {

constexpr Real kGain = Real(0.5);
constexpr double kMost = 1e9;

bool adds_energy(Joint& joint)
{
    const OwnSoftness* const own = joint.type->softness ? joint.type->softness(joint) : nullptr;
    if (own && (own->chosen || own->spring.acts)) return true;
    if (is_contact(joint))
        return joint.mode & (dContactMotion1 | dContactMotion2 | dContactMotionN | dContactSoftERP);
    const int axes = joint.type->axes ? joint.type->axes(joint) : 0;
    for (int i = 0; i < axes && joint.type->stops; ++i) {
        Real fmax = 0;
        const LimitMotor* const motor = joint.type->stops(joint, i);
        if (motor && motor->get(dParamFMax, fmax) && fmax > 0) return true;
    }
    return joint.driven;
}

bool is_powered(const StepFacts& facts)
{
    for (const Body& body : facts.world.bodies)
        if (body.kinematic()) return true;
    for (Joint& joint : facts.world.joints)
        if (acting(joint) && adds_energy(joint)) return true;
    return false;
}

}  // namespace

const char* const k_text_of_energy =
    "a step made energy out of nothing; look at the causes before this one, try a shorter step, or step with "
    "dWorldStep()";

void find_energy(const StepFacts& facts)
{
    double work = 0, kinetic = 0, mass = 0, fastest = 0;
    Body* quickest = nullptr;
    facts.for_each_body([&](Body& body, const BodyBefore& b) {
        const Vec3 v = Real(0.5) * (b.v + body.velocity()), w = Real(0.5) * (b.w + body.angular_velocity());
        work += double(facts.h * (dot(b.force, v) + dot(b.torque, w)));
        const Vec3 local = transposed_times(body.rotation(), b.w);
        kinetic += 0.5 * double(body.mass.mass * length2(b.v) + dot(local, body.inertia * local));
        mass += double(body.mass.mass);
        const double speed = double(length2(body.velocity() - b.v));
        if (speed > fastest) fastest = speed, quickest = &body;
    });
    const double fall = 30 * double(length(facts.world.gravity) * facts.h);
    const double scale = kinetic + 0.5 * mass * fall * fall;
    const double gain = facts.report.energy_after - facts.report.energy_before - work;
    if (!quickest || !(gain > double(kGain) * scale) || is_powered(facts)) return;
    facts.findings.add({.kind = dDiagnosisEnergy,
                        .severity = dSeverityWarning,
                        .body = to_handle(quickest),
                        .figure = scale * kMost > gain ? gain / scale : kMost,
                        .threshold = double(kGain)});
}

}  // namespace epode
