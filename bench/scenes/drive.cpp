// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See drive.h.
#include "bench/scenes/drive.h"

#include <cmath>

namespace epode::bench {

namespace {

Vec orbited(const BodyData& body, double time)
{
    const Vec centre = body.drive.axis_point;
    return centre + rotate(scenes::turn(scenes::kZ, body.drive.orbit * time), body.pos - centre);
}

// x folded back into -half ... half, as often as it takes.
double folded(double x, double half)
{
    const double period = 4 * half;
    double u = std::fmod(x + half, period);
    if (u < 0) u += period;
    return (u < 2 * half ? u : period - u) - half;
}

}  // namespace

BodyState start_state(const BodyData& body) { return {body.pos, body.turn, body.linear, body.angular}; }

BodyState driven(const BodyData& body, double time, double dt)
{
    BodyState state = start_state(body);
    state.pos = orbited(body, time);
    state.linear = (1 / dt) * (orbited(body, time + dt) - state.pos);
    state.angular = body.drive.spin;
    const double rate = length(body.drive.spin);
    if (rate > 0) state.turn = scenes::turn(body.drive.spin, rate * time) * body.turn;
    return state;
}

Vec flown(const SceneData& scene, const BodyData& body, double time)
{
    const Vec there = body.pos + time * body.linear;
    const double half = scene.cube_side / 2;
    return {folded(there.x, half), folded(there.y, half), folded(there.z, half)};
}

std::vector<int> driven_bodies(const SceneData& scene)
{
    std::vector<int> driven;
    for (size_t i = 0; i < scene.bodies.size(); ++i)
        if (scene.bodies[i].motion == Motion::kDriven) driven.push_back(int(i));
    return driven;
}

}  // namespace epode::bench
