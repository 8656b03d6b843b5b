// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Accurate integration of rotation: of bodies on nothing, and with dWorldSetExactRotation of all; ODE's own is in
// integrate.h. The state is the angular momentum; `Body::spin_excess` is the part of it that the stored angular velocity does not show.
#pragma once

#include "dynamics/world.h"

namespace epode {

inline bool is_unattached(const Body& body) { return !body.joints && !body.manifolds; }

inline bool turns_exactly(const World& world, const Body& body)
{
    return world.exact_rotation || (is_unattached(body) && !world.acts_as_ode());
}

// What bodies turn by in a step, rad/s: by their velocities, where those are the step's.
struct Turning {
    virtual Vec3 of(const Body& body) const { return body.angular_velocity(); }

  protected:
    ~Turning() = default;
};

// What the velocity lacks of a body that does not turn exactly any more.
inline Vec3 release_excess(Body& body)
{
    if (body.spin_excess == Vec3{}) return {};
    const Vec3 lacking = body.rotation() * (body.inv_inertia * body.spin_excess);
    body.spin_excess = {};
    return lacking;
}

// The angular velocity w of the world after torque and gyroscopic effect over a step h, of a body with rotation R: the v* of
// constraints. Leaves the momentum that this velocity lacks in the body's excess.
Vec3 kicked_spin(Body& body, const Mat3& R, Vec3 torque, Vec3 w, Real h);
Vec3 kicked_spin(Body& body, Vec3 torque, Vec3 w, Real h);

// The orientation q after a turn by exp(h m); the excess follows of a body that has the velocity w, most often m.
Quat turned_exactly(Body& body, Quat q, Vec3 m, Vec3 w, Real h, const Turning& turning);

// The momentum in the world, about the centre, of a free body of inertia I (in the world, where it begins) that turns by exp(h W) in a step.
Vec3 spin_momentum(const Sym3& I, Vec3 W, Real h);

// advance_pose with the exponential map. The body's angular velocity is that of the middle of the step;
// `free`: no constraint has acted on it, and it becomes that of the end.
void advance_pose_exactly(Body& body, Real h, bool free);

}  // namespace epode
