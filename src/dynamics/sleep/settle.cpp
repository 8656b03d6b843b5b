// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "dynamics/sleep/settle.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

constexpr Real kPatience = 10;               // s
constexpr Real kCalmShare = Real(0.9);       // of the bodies,
constexpr Real kCalm = 30, kCalmSpin = 100;  // whose speeds are at most this many times their thresholds,
constexpr Real kFastest = 100;               // while no body exceeds this
constexpr Real kDepthTime = Real(0.1);   // s; the depth that contacts may keep is as long at the threshold
constexpr Real kReadyShare = Real(0.7);  // of bodies that are ready to sleep: the others are stragglers,
constexpr Real kMaxExcess = 50, kMaxSpinExcess = 200;  // thresholds: faster bodies are not braked
constexpr Real kBrakeTime = Real(0.1);                 // s

// Speeds over thresholds, squared.
struct Excess {
    Real linear, angular;
};

Excess excess_of(const Body& body)
{
    const Real tiny = Real(1e-12);  // thresholds may be zero
    return {length2(body.velocity()) / std::max(body.sleep.linear_threshold2, tiny),
            length2(body.angular_velocity()) / std::max(body.sleep.angular_threshold2, tiny)};
}

bool is_under(const Excess& excess, Real linear, Real angular)
{
    return excess.linear <= linear * linear && excess.angular <= angular * angular;
}

// Do nearly all bodies hardly move, and is none fast?
bool is_calm(const Island& island)
{
    int calm = 0;
    for (const Body* body : island.bodies) {
        const Excess excess = excess_of(*body);
        if (!(excess.linear <= kFastest * kFastest)) return false;
        calm += is_under(excess, kCalm, kCalmSpin);
    }
    return Real(calm) >= kCalmShare * Real(island.bodies.size());
}

// The time since which all awake bodies are in islands that settle; `settles`: this one does.
Real count_time(const Island& island, bool settles, Real h)
{
    Real least = kPatience;
    for (Body* body : island.bodies) {
        if (body->disabled) continue;
        least = std::min(least, body->settling_time);
        body->settling_time = settles ? body->settling_time + h : 0;
    }
    return least;
}

Real depth_of(const Island& island)
{
    Real least2 = kInf;
    for (const Body* body : island.bodies) least2 = std::min(least2, body->sleep.linear_threshold2);
    return kDepthTime * std::sqrt(least2);
}

void brake(Body& body, Real h)
{
    const Excess excess = excess_of(body);
    if (is_under(excess, 1, 1) || !is_under(excess, kMaxExcess, kMaxSpinExcess)) return;
    const Real k = kBrakeTime / (kBrakeTime + h);
    store(body.lvel, k * body.velocity());
    store(body.avel, k * body.angular_velocity());
}

}  // namespace

void settle(Island& island, Real h, const Readiness& found)
{
    const bool settles = found.watched && found.touches && is_calm(island);
    if (count_time(island, settles, h) >= kPatience || !settles) return;
    island.kept_depth = depth_of(island);
    if (Real(found.ready) < kReadyShare * Real(found.bodies)) return;
    for (Body* body : island.bodies)
        if (!body->disabled && !body->kinematic()) brake(*body, h);
}

}  // namespace epode
