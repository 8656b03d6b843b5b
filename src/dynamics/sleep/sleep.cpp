// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// ODE's average is that of the velocity vectors over the whole ring; until the ring has been filled once, no
// body is idle by it.
#include "dynamics/sleep/sleep.h"

#include <algorithm>

#include "dynamics/forces/vehicle.h"
#include "dynamics/joint.h"
#include "dynamics/sleep/sleeping_forces.h"

namespace epode {
namespace {

constexpr Real kTurn = 5;                      // times the threshold of angular velocity
constexpr Real kShort = Real(0.5), kLong = 4;  // windows, s
constexpr Real kCrowdTime = 1;                 // s of the long window that are enough
constexpr Real kCrowd = Real(0.9);             // where so many of an island are ready

// Notes the present velocity; true when the ring's average is under the thresholds.
bool is_slow(Body& body)
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

// The vector part of a unit quaternion is as long as the sine of half the angle.
bool is_within(const Body& body, const Stillness& from, Real window)
{
    const Vec3 half_turn = (conjugate(from.orientation) * body.orientation()).vec();
    const Real T2 = window * window;
    return length2(body.position() - from.position) <= T2 * body.sleep.linear_threshold2 &&
           4 * length2(half_turn) <= kTurn * kTurn * T2 * body.sleep.angular_threshold2;
}

void watch_pose(const Body& body, Real window, Real h, Stillness& state)
{
    state.time += h;
    const bool within = is_within(body, state, window);
    if (!within || state.time >= window) state = {body.position(), body.orientation(), 0, within};
}

// What the program drives is where the program wants it.
void watch_pose(Body& body, Real h)
{
    if (body.kinematic()) return;
    watch_pose(body, kShort, h, body.short_window);
    watch_pose(body, kLong, h, body.long_window);
}

bool is_still(const Body& body) { return body.short_window.still || body.long_window.still; }

bool is_nearly_still(const Body& body)
{
    return body.long_window.still || body.long_window.time >= kCrowdTime;
}

bool has_contacts(const Island& island)
{
    return !island.manifolds.empty() || std::any_of(island.joints.begin(), island.joints.end(),
                                                    [](const Joint* joint) { return is_contact(*joint); });
}

bool is_watched(const Body& body)
{
    const bool stands = body.vehicle && body.vehicle->stands;
    return body.auto_disable && body.sleep.samples > 0 && !body.fluid.restless &&
           (body.joints || body.manifolds || body.fluid.floats || stands);
}

// Counts a step at the beginning of which the body is idle, or is not; true if it is ready to sleep.
bool count_step(Body& body, bool idle, Real h)
{
    if (idle) {
        --body.idle_steps_left;
        body.idle_time_left -= h;
    } else {
        body.idle_steps_left = body.sleep.steps;
        body.idle_time_left = body.sleep.time;
    }
    return body.idle_steps_left <= 0 && body.idle_time_left <= 0;
}

void put_to_sleep(Body& body)
{
    body.disabled = true;
    store(body.lvel, {});
    store(body.avel, {});
    body.spin_excess = {};
    note_forces(body);
    // Where it lies it has come to rest, whatever it did before.
    for (Stillness* window : {&body.short_window, &body.long_window})
        *window = {body.position(), body.orientation(), 0, window->still};
}

}  // namespace

bool fall_asleep(const Island& island, Real h, Readiness& found)
{
    found = {int(island.bodies.size()), 0, true, has_contacts(island)};
    bool nearly_still = found.touches;
    for (Body* body : island.bodies) {
        bool ready = body->disabled;
        if (!ready && is_watched(*body)) {
            watch_pose(*body, h);
            const bool slow = is_slow(*body);
            ready = count_step(*body, slow || (found.touches && is_still(*body)), h);
            nearly_still = nearly_still && (ready || is_nearly_still(*body));
        } else if (!ready) {
            found.watched = false;
        }
        found.ready += ready;
    }
    const bool nearly_all = Real(found.ready) >= kCrowd * Real(found.bodies);
    if (!found.watched || !(found.ready == found.bodies || (nearly_all && nearly_still))) return false;
    for (Body* body : island.bodies)
        if (!body->disabled) put_to_sleep(*body);
    return true;
}

bool fall_asleep_alone(Body& body, Real h)
{
    if (!is_watched(body) || !count_step(body, is_slow(body), h)) return false;
    put_to_sleep(body);
    return true;
}

}  // namespace epode
