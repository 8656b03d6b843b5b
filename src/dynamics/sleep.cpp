// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The average is that of the velocity vectors over the whole ring, so a trembling body counts as idle; until
// the ring has been filled once, no body is.
#include "dynamics/sleep.h"

namespace epode {
namespace {

// Notes the present velocity; true when the ring's average is under the thresholds.
bool idle(Body& body)
{
    const int n = body.sleep.samples;
    body.sample_v[body.sample_next] = body.velocity();
    body.sample_w[body.sample_next] = body.angular_velocity();
    if (++body.sample_next >= n) {
        body.sample_next = 0;
        body.samples_ready = true;
    }
    if (!body.samples_ready) return false;
    Vec3 v, w;
    for (int i = 0; i < n; ++i) v += body.sample_v[i], w += body.sample_w[i];
    const Real k = Real(1) / Real(n);
    return length2(k * v) <= body.sleep.linear_threshold2 && length2(k * w) <= body.sleep.angular_threshold2;
}

void put_to_sleep(Body& body)
{
    body.disabled = true;
    store(body.lvel, {});
    store(body.avel, {});
    body.spin_excess = {};
}

}  // namespace

void auto_disable(World& world, Real h)
{
    if (!world.watches_bodies) return;
    world.bodies.for_each_active([&](Body& b) {
        if ((!b.joints && !b.patched) || !b.auto_disable || b.disabled || b.sleep.samples <= 0) return;
        if (idle(b)) {
            --b.idle_steps_left;
            b.idle_time_left -= h;
        } else {
            b.idle_steps_left = b.sleep.steps;
            b.idle_time_left = b.sleep.time;
        }
        if (b.idle_steps_left <= 0 && b.idle_time_left <= 0) put_to_sleep(b);
    });
}

}  // namespace epode
