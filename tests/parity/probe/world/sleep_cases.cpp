// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sleeping, waking, and the order in which a world visits its things: auto-disable sequences, island wake-up
// through joints, joint enumeration, moved callbacks.
#include "rig.h"

namespace parity {
namespace {

// One digit per step: is the body enabled after it?
std::string enabled_sequence(dWorldID world, dBodyID body, int steps, double step_size)
{
    std::string digits;
    for (int i = 0; i < steps; ++i) {
        dWorldStep(world, step_size);
        digits += dBodyIsEnabled(body) ? '1' : '0';
    }
    return digits;
}

void null_joint(dWorldID world, dBodyID a, dBodyID b)
{
    dJointAttach(dJointCreateNull(world, nullptr), a, b);
}

PARITY_CASE(sleep_counters)
{
    for (int trial = 0; trial < 60; ++trial) {
        out.open_block("t" + std::to_string(trial));
        const dWorldID world = dWorldCreate();
        dWorldSetAutoDisableFlag(world, 1);
        dWorldSetAutoDisableSteps(world, rng.below(12));
        dWorldSetAutoDisableTime(world, rng.unit() < 0.5 ? 0.0 : rng.range(0, 0.2));
        dWorldSetAutoDisableAverageSamplesCount(world, static_cast<unsigned>(rng.below(5)));
        const dBodyID body = dBodyCreate(world);
        if (trial % 5 != 0) { null_joint(world, body, nullptr); }
        dBodySetLinearVel(body, rng.unit() < 0.5 ? 0.0 : rng.range(0.005, 0.02), 0, 0);
        if (rng.unit() < 0.3) {
            dBodySetLinearDamping(body, 0.1);
            dBodySetLinearDampingThreshold(body, 0);
        }
        out.put_text("enabled", enabled_sequence(world, body, 40, 0.01));
        out.put_body("after", body);
        dBodyEnable(body);
        out.put_text("again", enabled_sequence(world, body, 30, 0.01));
        dBodySetAutoDisableFlag(body, 0);
        out.put("cleared", {static_cast<double>(dBodyIsEnabled(body)),
                            static_cast<double>(dBodyGetAutoDisableFlag(body)),
                            static_cast<double>(dBodyGetAutoDisableSteps(body))});
        dWorldDestroy(world);
    }
}

PARITY_CASE(sleep_pair_wakes)
{
    for (int kind = 0; kind < 8; ++kind) {
        out.open_block("k" + std::to_string(kind));
        const dWorldID world = dWorldCreate();
        const dBodyID a = dBodyCreate(world), b = dBodyCreate(world), c = dBodyCreate(world);
        dBodySetPosition(b, 1, 0, 0);
        dBodySetPosition(c, 2, 0, 0);
        const dJointID ab = dJointCreateBall(world, nullptr), bc = dJointCreateBall(world, nullptr);
        dJointAttach(ab, a, b);
        dJointSetBallAnchor(ab, 0.5, 0, 0);
        dJointAttach(bc, b, c);
        dJointSetBallAnchor(bc, 1.5, 0, 0);
        if (kind & 1) { dBodySetKinematic(b); }
        if (kind & 2) { dJointDisable(bc); }
        if (kind & 4) { dBodySetKinematic(c); }
        dBodyDisable(b);
        dBodyDisable(c);
        dBodyAddForce(c, 1, 2, 3);
        dBodySetLinearVel(a, 0, 1, 0);
        for (int step = 0; step < 3; ++step) {
            dWorldStep(world, 0.01);
            const std::string when = "s" + std::to_string(step);
            out.put(when + ".enabled",
                    {static_cast<double>(dBodyIsEnabled(a)), static_cast<double>(dBodyIsEnabled(b)),
                     static_cast<double>(dBodyIsEnabled(c))});
            out.put_body(when + ".a", a);
            out.put_body(when + ".b", b);
            out.put_body(when + ".c", c);
            out.put(when + ".force", dBodyGetForce(c), 3);
        }
        dWorldDestroy(world);
    }
}

std::string moved_order;

void note_moved(dBodyID body) { moved_order += static_cast<const char*>(dBodyGetData(body)); }

PARITY_CASE(body_moved_order)
{
    static char names[8][2] = {"a", "b", "c", "d", "e", "f", "g", "h"};
    for (int trial = 0; trial < 40; ++trial) {
        out.open_block("t" + std::to_string(trial));
        const dWorldID world = dWorldCreate();
        dBodyID bodies[8];
        for (int i = 0; i < 8; ++i) {
            bodies[i] = dBodyCreate(world);
            dBodySetData(bodies[i], names[i]);
            dBodySetMovedCallback(bodies[i], &note_moved);
            if (rng.unit() < 0.2) { dBodyDisable(bodies[i]); }
        }
        for (int k = 0; k < trial % 9; ++k) {
            const int i = rng.below(8), j = rng.below(8);
            null_joint(world, bodies[i], i == j ? nullptr : bodies[j]);
        }
        moved_order = "=";
        dWorldStep(world, 0.01);
        out.put_text("exact", moved_order);
        moved_order = "=";
        dWorldQuickStep(world, 0.01);
        out.put_text("quick", moved_order);
        dWorldDestroy(world);
    }
}

// Joint lists: newest first for each body; re-attachment moves to the front.
PARITY_CASE(body_joint_order)
{
    static char names[10][2] = {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9"};
    for (int trial = 0; trial < 30; ++trial) {
        out.open_block("t" + std::to_string(trial));
        const dWorldID world = dWorldCreate();
        const dBodyID bodies[4] = {dBodyCreate(world), dBodyCreate(world), dBodyCreate(world), nullptr};
        dJointID joints[10];
        for (int i = 0; i < 10; ++i) {
            joints[i] = i % 2 ? dJointCreateBall(world, nullptr) : dJointCreateHinge(world, nullptr);
            dJointSetData(joints[i], names[i]);
        }
        for (int k = 0; k < 16; ++k) {
            const int i = rng.below(4), j = rng.below(4);
            dJointAttach(joints[rng.below(10)], bodies[i], i == j ? nullptr : bodies[j]);
        }
        dJointDestroy(joints[3]);
        for (int i = 0; i < 3; ++i) {
            std::string order = "=";
            for (int k = 0; k < dBodyGetNumJoints(bodies[i]); ++k) {
                order += static_cast<const char*>(dJointGetData(dBodyGetJoint(bodies[i], k)));
            }
            out.put_text("order" + std::to_string(i), order);
            for (int j = 0; j < 4; ++j) {
                if (j == i) { continue; }
                dJointID found[10];
                const int count = dConnectingJointList(bodies[i], bodies[j], found);
                const dJointID one = dConnectingJoint(bodies[i], bodies[j]);
                out.put("connect" + std::to_string(i) + std::to_string(j),
                        {static_cast<double>(count), static_cast<double>(dAreConnected(bodies[i], bodies[j])),
                         static_cast<double>(dAreConnectedExcluding(bodies[i], bodies[j], dJointTypeBall)),
                         one == nullptr ? -1.0 : static_cast<const char*>(dJointGetData(one))[0] - '0'});
            }
        }
        dBodyDestroy(bodies[1]);
        for (int i = 0; i < 10; ++i) {
            if (i != 3) {
                out.put("bodies" + std::to_string(i), {static_cast<double>(dJointGetNumBodies(joints[i])),
                                                       dJointGetBody(joints[i], 0) == nullptr ? 0.0 : 1.0,
                                                       dJointGetBody(joints[i], 1) == nullptr ? 0.0 : 1.0});
            }
        }
        dWorldDestroy(world);
    }
}

}  // namespace
}  // namespace parity
