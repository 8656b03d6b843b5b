// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/free_flight.h"

#include "dynamics/exact_spin.h"
#include "dynamics/integrate.h"

namespace epode {
namespace {

// After substep i the velocity is v + i hs g, so its mean is v + (n + 1)/2 hs g.
void turn_exactly_over_step(const World& world, Body& body, Vec3 kicked, Real h, int substeps)
{
    const Vec3 fall = weight_field(world, body);
    store(body.avel, kicked_spin(body, load(body.tacc), body.angular_velocity(), h));
    store(body.lvel, kicked + (Real(0.5) * h * (1 + Real(1) / Real(substeps))) * fall);
    advance_pose_exactly(body, h, true);
    store(body.lvel, kicked + h * fall);
}

void turn_by_substeps(const World& world, Body& body, Vec3 kicked, Real h, int substeps)
{
    const Real hs = h / Real(substeps);
    const auto turned_by = [&](Vec3 torque, Real time) {
        return time * (rotate(body.rotation(), body.inv_inertia) * torque);
    };
    Vec3 v = kicked, w = body.angular_velocity() + turned_by(load(body.tacc), h);
    for (int i = 0; i < substeps; ++i) {
        v += hs * weight_field(world, body);
        w += turned_by(gyroscopic_torque(body, w, hs), hs);
        store(body.lvel, v), store(body.avel, w);
        advance_pose(body, hs);
        w = body.angular_velocity();  // limited by the body's maximum
    }
}

}  // namespace

void fly(const World& world, Body& body, Real h, int substeps)
{
    const Vec3 kicked = body.velocity() + (h * body.inv_mass) * force_on(world, body);
    const bool exactly = world.exact_rotation || !world.acts_as_ode();
    exactly ? turn_exactly_over_step(world, body, kicked, h, substeps)
            : turn_by_substeps(world, body, kicked, h, substeps);
}

}  // namespace epode
