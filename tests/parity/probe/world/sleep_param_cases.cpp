// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Auto-disable, parameter by parameter, per body and by the world's defaults, in both steppers: thresholds,
// samples, steps, time, changes on the way, and everything that may or may not wake a sleeping body.
#include "rig.h"

#include <vector>

namespace parity {
namespace {

using Step = int (*)(dWorldID, dReal);

const std::pair<const char*, Step> kSteppers[] = {{"exact", &dWorldStep}, {"quick", &dWorldQuickStep}};

struct Sleeper {
    dWorldID world = dWorldCreate();
    dBodyID body = dBodyCreate(world);

    Sleeper()
    {
        dBodySetAutoDisableFlag(body, 1);
        dJointAttach(dJointCreateNull(world, nullptr), body, nullptr);
    }
    ~Sleeper() { dWorldDestroy(world); }
    Sleeper(const Sleeper&) = delete;
    Sleeper& operator=(const Sleeper&) = delete;
};

std::string enabled_digits(const Sleeper& s, Step step, int steps, double step_size)
{
    std::string digits;
    for (int i = 0; i < steps; ++i) {
        step(s.world, step_size);
        digits += dBodyIsEnabled(s.body) ? '1' : '0';
    }
    return digits;
}

// Speeds just below, at and just above the threshold, linear and angular.
PARITY_CASE(sleep_thresholds)
{
    for (const auto& [name, step] : kSteppers) {
        for (const double threshold : {0.0, 0.125, 0.5}) {
            for (const double speed : {0.0, 0.0625, 0.12499, 0.125, 0.12501, 0.5, 0.6}) {
                for (const bool angular : {false, true}) {
                    out.open_block(std::string(name) + "/" + std::to_string(threshold) + "/" +
                                   std::to_string(speed) + (angular ? "a" : "l"));
                    Sleeper s;
                    dBodySetAutoDisableLinearThreshold(s.body, threshold);
                    dBodySetAutoDisableAngularThreshold(s.body, threshold);
                    angular ? dBodySetAngularVel(s.body, 0, speed, 0)
                            : dBodySetLinearVel(s.body, 0, 0, speed);
                    out.put_text("enabled", enabled_digits(s, step, 15, 0.01));
                    out.put_body("after", s.body);
                }
            }
        }
    }
}

// Steps and time have both to run out.
PARITY_CASE(sleep_steps_and_time)
{
    for (const auto& [name, step] : kSteppers) {
        for (const int steps : {0, 1, 7}) {
            for (const double time : {0.0, 0.025, 0.2}) {
                for (const double step_size : {0.01, 0.03}) {
                    out.open_block(std::string(name) + "/" + std::to_string(steps) + "." +
                                   std::to_string(time) + "." + std::to_string(step_size));
                    Sleeper s;
                    dBodySetAutoDisableSteps(s.body, steps);
                    dBodySetAutoDisableTime(s.body, time);
                    dBodyEnable(s.body);
                    out.put_text("enabled", enabled_digits(s, step, 25, step_size));
                    dBodyEnable(s.body);
                    out.put_text("again", enabled_digits(s, step, 25, step_size));
                    dBodySetLinearVel(s.body, 1, 0, 0);
                    dBodyEnable(s.body);
                    out.put_text("moving.again", enabled_digits(s, step, 12, step_size));
                    out.put_body("after", s.body);
                }
            }
        }
    }
}

// A body that swings to and fro: its average over the samples says whether it rests.
PARITY_CASE(sleep_average_samples)
{
    for (const auto& [name, step] : kSteppers) {
        for (unsigned samples = 0; samples < 7; ++samples) {
            for (const int period : {1, 2, 4}) {
                out.open_block(std::string(name) + "/" + std::to_string(samples) + "." +
                               std::to_string(period));
                Sleeper s;
                dBodySetAutoDisableAverageSamplesCount(s.body, samples);
                dBodySetAutoDisableSteps(s.body, 3);
                std::string digits;
                for (int i = 0; i < 40; ++i) {
                    if (dBodyIsEnabled(s.body)) {
                        dBodySetLinearVel(s.body, i / period % 2 == 0 ? 0.05 : -0.05, 0, 0);
                    }
                    step(s.world, 0.01);
                    digits += dBodyIsEnabled(s.body) ? '1' : '0';
                    if (i == 25) { dBodyEnable(s.body); }
                    if (i == 32) { dBodySetAutoDisableAverageSamplesCount(s.body, samples + 1); }
                }
                out.put_text("enabled", digits);
            }
        }
    }
}

// Parameters changed while the counters run: a change counts from the next reset.
PARITY_CASE(sleep_changed_on_the_way)
{
    for (int kind = 0; kind < 8; ++kind) {
        for (int when = 0; when < 12; when += 3) {
            out.open_block("k" + std::to_string(kind) + "." + std::to_string(when));
            Sleeper s;
            std::string digits = enabled_digits(s, &dWorldStep, when, 0.01);
            switch (kind) {
                case 0:
                    dBodySetAutoDisableSteps(s.body, 3);
                    break;
                case 1:
                    dBodySetAutoDisableTime(s.body, 0.05);
                    break;
                case 2:
                    dBodySetAutoDisableFlag(s.body, 0);
                    break;
                case 3:
                    dBodySetAutoDisableFlag(s.body, 0);
                    dBodySetAutoDisableFlag(s.body, 1);
                    break;
                case 4:
                    dWorldSetAutoDisableSteps(s.world, 4);
                    dWorldSetAutoDisableFlag(s.world, 1);
                    dBodySetAutoDisableDefaults(s.body);
                    break;
                case 5:
                    dBodySetAutoDisableDefaults(s.body);
                    break;
                case 6:
                    dBodySetLinearVel(s.body, 1, 0, 0);
                    digits += enabled_digits(s, &dWorldStep, 2, 0.01);
                    dBodySetLinearVel(s.body, 0, 0, 0);
                    break;
                default:
                    dBodyDisable(s.body);
                    digits += enabled_digits(s, &dWorldStep, 2, 0.01);
                    dBodyEnable(s.body);
                    break;
            }
            out.put_text("enabled", digits + enabled_digits(s, &dWorldStep, 25, 0.01));
            out.put("after.enabled", {static_cast<double>(dBodyGetAutoDisableSteps(s.body)),
                                      static_cast<double>(dBodyGetAutoDisableFlag(s.body))});
        }
    }
}

// What the world's defaults give to bodies made under them, and to those made before.
PARITY_CASE(sleep_world_defaults)
{
    for (int trial = 0; trial < 30; ++trial) {
        out.open_block("t" + std::to_string(trial));
        const dWorldID world = dWorldCreate();
        // The same for both bodies: the original's dBodySetAutoDisableDefaults takes over the number and
        // keeps the old buffer (differences.tsv, D43).
        dWorldSetAutoDisableAverageSamplesCount(world, static_cast<unsigned>(rng.below(4)));
        const dBodyID early = dBodyCreate(world);
        dWorldSetAutoDisableFlag(world, trial % 3);
        dWorldSetAutoDisableLinearThreshold(world, rng.range(0, 0.2));
        dWorldSetAutoDisableAngularThreshold(world, rng.range(0, 0.2));
        dWorldSetAutoDisableSteps(world, rng.below(8));
        dWorldSetAutoDisableTime(world, rng.range(0, 0.1));
        const dBodyID late = dBodyCreate(world);
        std::string digits[2];
        for (const dBodyID body : {early, late}) {
            dJointAttach(dJointCreateNull(world, nullptr), body, nullptr);
            dBodySetLinearVel(body, rng.range(0, 0.2), 0, 0);
            dBodySetAngularVel(body, 0, rng.range(0, 0.2), 0);
        }
        for (int i = 0; i < 30; ++i) {
            dWorldStep(world, 0.01);
            digits[0] += dBodyIsEnabled(early) ? '1' : '0';
            digits[1] += dBodyIsEnabled(late) ? '1' : '0';
            if (i == 15) { dBodySetAutoDisableDefaults(early); }
        }
        out.put_text("early.enabled", digits[0]);
        out.put_text("late.enabled", digits[1]);
        dWorldDestroy(world);
    }
}

// ---- waking ----

struct Pair {
    dWorldID world = dWorldCreate();
    dBodyID asleep = dBodyCreate(world), awake = dBodyCreate(world);
    dJointGroupID group = dJointGroupCreate(0);

    Pair()
    {
        dBodySetPosition(awake, 1, 0, 0);
        dBodySetAutoDisableFlag(asleep, 1);
        dBodyDisable(asleep);
    }
    ~Pair()
    {
        dWorldDestroy(world);
        dJointGroupDestroy(group);
    }
    Pair(const Pair&) = delete;
    Pair& operator=(const Pair&) = delete;

    void touch(dBodyID a, dBodyID b) const
    {
        dContact c = dContact();
        c.surface.mu = 1;
        c.geom.normal[0] = 1;
        c.geom.depth = 0.01;
        dJointAttach(dJointCreateContact(world, group, &c), a, b);
    }
    void join(dBodyID a, dBodyID b) const { dJointAttach(dJointCreateNull(world, nullptr), a, b); }
};

using Deed = void (*)(const Pair&);

const std::pair<const char*, Deed> kDeeds[] = {
    {"nothing", [](const Pair&) {}},
    {"force", [](const Pair& p) { dBodyAddForce(p.asleep, 1, 2, 3); }},
    {"torque", [](const Pair& p) { dBodyAddTorque(p.asleep, 1, 2, 3); }},
    {"velocity", [](const Pair& p) { dBodySetLinearVel(p.asleep, 1, 2, 3); }},
    {"position", [](const Pair& p) { dBodySetPosition(p.asleep, 1, 2, 3); }},
    {"enable", [](const Pair& p) { dBodyEnable(p.asleep); }},
    {"flag-off", [](const Pair& p) { dBodySetAutoDisableFlag(p.asleep, 0); }},
    {"flag-on", [](const Pair& p) { dBodySetAutoDisableFlag(p.asleep, 1); }},
    {"defaults", [](const Pair& p) { dBodySetAutoDisableDefaults(p.asleep); }},
    {"mass",
     [](const Pair& p) {
         dMass m;
         dMassSetSphereTotal(&m, 2, 1);
         dBodySetMass(p.asleep, &m);
     }},
    {"kinematic", [](const Pair& p) { dBodySetKinematic(p.asleep); }},
    {"contact-world", [](const Pair& p) { p.touch(p.asleep, nullptr); }},
    {"contact-awake", [](const Pair& p) { p.touch(p.asleep, p.awake); }},
    {"contact-reversed", [](const Pair& p) { p.touch(p.awake, p.asleep); }},
    {"contact-kinematic",
     [](const Pair& p) {
         dBodySetKinematic(p.awake);
         p.touch(p.asleep, p.awake);
     }},
    {"contact-disabled",
     [](const Pair& p) {
         p.touch(p.asleep, p.awake);
         dJointDisable(dBodyGetJoint(p.asleep, 0));
     }},
    {"joint-world", [](const Pair& p) { p.join(p.asleep, nullptr); }},
    {"joint-awake", [](const Pair& p) { p.join(p.asleep, p.awake); }},
    {"joint-disabled",
     [](const Pair& p) {
         p.join(p.asleep, p.awake);
         dJointDisable(dBodyGetJoint(p.asleep, 0));
     }},
    {"joint-motor",
     [](const Pair& p) {
         const dJointID joint = dJointCreateHinge(p.world, nullptr);
         dJointAttach(joint, p.asleep, nullptr);
         dJointSetHingeParam(joint, dParamVel, 2);
         dJointSetHingeParam(joint, dParamFMax, 5);
     }},
    {"joint-torque",
     [](const Pair& p) {
         const dJointID joint = dJointCreateHinge(p.world, nullptr);
         dJointAttach(joint, p.asleep, nullptr);
         dJointAddHingeTorque(joint, 2);
     }},
};

PARITY_CASE(sleep_waking)
{
    for (const auto& [stepper, step] : kSteppers) {
        for (const auto& [name, deed] : kDeeds) {
            out.open_block(std::string(stepper) + "/" + name);
            const Pair pair;
            deed(pair);
            std::string digits = dBodyIsEnabled(pair.asleep) ? "1" : "0";
            for (int i = 0; i < 25; ++i) {
                step(pair.world, 0.01);
                digits += dBodyIsEnabled(pair.asleep) ? '1' : '0';
                if (i == 3) { dJointGroupEmpty(pair.group); }
                if (i == 16) { dBodyEnable(pair.asleep); }
            }
            out.put_text("enabled", digits);
            out.put_body("after", pair.asleep);
            out.put("after.force", dBodyGetForce(pair.asleep), 3);
        }
    }
}

// A chain that falls asleep from one end and is woken at the other.
PARITY_CASE(sleep_chain)
{
    for (const auto& [stepper, step] : kSteppers) {
        out.open_block(stepper);
        const dWorldID world = dWorldCreate();
        dWorldSetAutoDisableFlag(world, 1);
        std::vector<dBodyID> links;
        for (int i = 0; i < 6; ++i) {
            links.push_back(dBodyCreate(world));
            dBodySetPosition(links.back(), i, 0, 0);
            const dJointID ball = dJointCreateBall(world, nullptr);
            dJointAttach(ball, links.back(), i == 0 ? nullptr : links[static_cast<std::size_t>(i - 1)]);
            dJointSetBallAnchor(ball, i - 0.5, 0, 0);
        }
        for (int i = 0; i < 60; ++i) {
            if (i == 20) { dBodyEnable(links[5]); }
            if (i == 35) { dBodySetAutoDisableFlag(links[0], 0); }
            if (i == 36) { dBodyEnable(links[0]); }
            if (i == 50) { dBodySetLinearVel(links[2], 0, 0.5, 0); }
            step(world, 0.01);
            std::string digits;
            for (const dBodyID link : links) { digits += dBodyIsEnabled(link) ? '1' : '0'; }
            out.put_text("s" + std::to_string(i) + ".enabled", digits);
        }
        dWorldDestroy(world);
    }
}

}  // namespace
}  // namespace parity
