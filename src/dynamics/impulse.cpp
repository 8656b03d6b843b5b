// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "dynamics/impulse.h"

namespace epode {

Vec3 turned_by(const Body& body, Vec3 angular_impulse)
{
    const Mat3 R = body.rotation();
    return R * (body.inv_inertia * transposed_times(R, angular_impulse));
}

Real yielding(const Body& body, Vec3 arm, Vec3 d)
{
    const Vec3 turn = cross(arm, d);
    return body.inv_mass + dot(turn, turned_by(body, turn));
}

void add_impulse(Body& body, Vec3 impulse, Vec3 arm, Vec3 angular)
{
    store(body.lvel, body.velocity() + body.inv_mass * impulse);
    const Vec3 turn = cross(arm, impulse) + angular;
    if (turn == Vec3{}) return;
    store(body.avel, body.angular_velocity() + turned_by(body, turn));
    body.spin_excess = {};
}

}  // namespace epode
