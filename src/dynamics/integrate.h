// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// From forces to velocities and from velocities to poses: semi-implicit Euler, as ODE's.
#pragma once

#include "dynamics/body.h"

namespace epode {

// Torque of gyroscopic precession of a body with rotation R over a step h, so chosen that no spin rate makes it unstable; zero when the
// body does not want it.
Vec3 gyroscopic_torque(const Body& body, const Mat3& R, Vec3 angular_velocity, Real h);
Vec3 gyroscopic_torque(const Body& body, Vec3 angular_velocity, Real h);

// The orientation after a turn of q with w for h: by the exponential map, and as the body's finite rotation
// mode asks.
Quat turn_exactly(Quat q, Vec3 w, Real h);
Quat turned(const Body& body, Quat q, Vec3 w, Real h);

// Limits the spin, then x += h v and the orientation accordingly. Velocities are those in the body.
void advance_pose(Body& body, Real h);

// Velocity damping after a step, as ODE applies it (independent of h).
inline bool damps_motion(const Body& b)
{
    return b.damping.linear_scale != 0 && length2(b.velocity()) > b.damping.linear_threshold2;
}
inline bool damps_spin(const Body& b)
{
    return b.damping.angular_scale != 0 && length2(b.angular_velocity()) > b.damping.angular_threshold2;
}
void damp(Body& body);

}  // namespace epode
