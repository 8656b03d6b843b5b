// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Accurate integration of rotation: of bodies on nothing, and with dWorldSetExactRotation of the others as far as they turn; ODE's own is in
// integrate.h. The state is the angular momentum; `Body::spin_excess` is the part of it that the stored angular velocity does not show.
#pragma once

#include "dynamics/world.h"

namespace epode {

inline bool is_unattached(const Body& body) { return !body.joints && !body.manifolds; }

// A turn in a step, rad, below which the rotations are the same to rounding: bodies at rest pay nothing. (At 1e-4, trees of joints that passed it made energy.)
inline constexpr Real kSlowTurn = Real(1e-6);

inline bool turns_exactly(const World& world, const Body& body, Real h)
{
    if (is_unattached(body)) return world.exact_rotation || !world.acts_as_ode();
    return world.exact_rotation && length2(body.angular_velocity()) * (h * h) > kSlowTurn * kSlowTurn;
}

// What the velocity lacks of a body that does not turn exactly any more.
inline Vec3 release_excess(Body& body)
{
    if (!body.world->exact_rotation || body.spin_excess == Vec3{}) return {};
    const Vec3 lacking = body.rotation() * (body.inv_inertia * body.spin_excess);
    body.spin_excess = {};
    return lacking;
}

// The angular velocity w of the world after torque and gyroscopic effect over a step h, of a body with rotation R: the v* of
// constraints. Leaves the momentum that this velocity lacks in the body's excess.
Vec3 kicked_spin(Body& body, const Mat3& R, Vec3 torque, Vec3 w, Real h);
Vec3 kicked_spin(Body& body, Vec3 torque, Vec3 w, Real h);

// The orientation q after a turn by exp(h m); the excess follows of a body that has the velocity w, most often m.
Quat turned_exactly(Body& body, Quat q, Vec3 m, Vec3 w, Real h);

// The momentum in the world, about the centre, of a free body of inertia I (in the world, where it begins) that turns by exp(h W) in a step.
Vec3 spin_momentum(const Sym3& I, Vec3 W, Real h);

// advance_pose with the exponential map. The body's angular velocity is that of the middle of the step;
// `free`: no constraint has acted on it, and it becomes that of the end.
void advance_pose_exactly(Body& body, Real h, bool free);

}  // namespace epode
