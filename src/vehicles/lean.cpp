// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "vehicles/lean.h"

#include <algorithm>

#include "dynamics/world.h"
#include "math/trig.h"

namespace epode {
namespace {
// Of gravity, that leaning may ask of the tyres.
constexpr Real kSideways = Real(0.8);
}  // namespace

Real lean_of(const Body& body, const VehicleFrame& frame)
{
    const Vec3 up = -body.world->gravity;
    return atan2(dot(up, frame.left), dot(up, frame.up));
}

Real lean_moment(const Body& body, const WheelForces& forces, Real h)
{
    const dVehicleSettings& s = body.vehicle->settings;
    const Vec3 gravity = body.world->gravity, arm = forces.mean_contact(), forward = forces.frame().forward;
    const Real g = length(gravity), wn = s.lean_frequency;
    if (!(g > 0) || !(wn > 0) || arm == Vec3{} || body.kinematic()) return 0;
    const Vec3 w = body.angular_velocity();
    const Real yaw = -dot(w, gravity) / g, v = dot(body.velocity(), forward);
    const Real wanted = std::clamp(-atan2(v * yaw, g), -s.lean_limit, s.lean_limit);
    const Vec3 about = transposed_times(body.rotation(), forward);
    const Vec3 sideways = arm - dot(arm, forward) * forward;
    const Real J = dot(about, body.inertia * about) + body.mass.mass * length2(sideways);
    const Real off = wanted - lean_of(body, forces.frame());
    const Real turn = wn * (wn * off - 2 * dot(w, forward)) / (1 + 2 * wn * h + wn * h * wn * h);
    const Real l = length(sideways), limit = l > 0 ? kSideways * g / l : kInf;
    return J * std::clamp(turn, -limit, limit);
}

}  // namespace epode
