// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Gyroscopic term: one Newton step of the implicit Euler equation for w (Lacoursiere, "Stabilizing gyroscopic
// forces in rigid multibody simulations", 2006). With L = I w, M = I - h [L]x, M u = L:
//     t = (I u - L) / h = L x u,   to first order -w x L;
// taken in the body's frame, where I is at hand.
// Orientation: q += h/2 (0, w) q and renormalised ("infinitesimal", ODE's default), or in finite mode the
// exact turn q <- (cos a, w h/2 sinc a) q, a = |w| h/2; with a finite axis only the part of w along it is
// turned exactly, the rest infinitesimally. (ODE advances that rest by h/2 only, which worlds with its behaviour do.)
#include "dynamics/integrate.h"

#include "dynamics/world.h"
#include "math/trig.h"

namespace epode {
namespace {

Quat turn_infinitesimally(Quat q, Vec3 w, Real h)
{
    const Quat dq = Quat{0, w.x, w.y, w.z} * q;
    const Real k = h * Real(0.5);
    return {q.w + k * dq.w, q.x + k * dq.x, q.y + k * dq.y, q.z + k * dq.z};
}

}  // namespace

Quat turn_exactly(Quat q, Vec3 w, Real h)
{
    if (w == Vec3{}) return q;
    const Real angle = length(w) * h * Real(0.5);
    const Vec3 v = (h * Real(0.5) * sinc(angle)) * w;
    return Quat{epode::cos(angle), v.x, v.y, v.z} * q;
}

Quat turned(const Body& body, Quat q, Vec3 w, Real h)
{
    if (!body.finite_rotation) return turn_infinitesimally(q, w, h);
    if (body.finite_axis == Vec3{}) return turn_exactly(q, w, h);
    const Vec3 along = dot(body.finite_axis, w) * body.finite_axis;
    const Real rest = body.world->acts_as_ode() ? h * Real(0.5) : h;
    return turn_infinitesimally(turn_exactly(q, along, h), w - along, rest);
}

Vec3 gyroscopic_torque(const Body& body, Vec3 w, Real h)
{
    // L is parallel to w where the inertia is the same about all axes.
    if (!body.gyroscopic || body.kinematic() || isotropic(body.inertia)) return {};
    return gyroscopic_torque(body, body.rotation(), w, h);
}

Vec3 gyroscopic_torque(const Body& body, const Mat3& R, Vec3 w, Real h)
{
    if (!body.gyroscopic || body.kinematic() || isotropic(body.inertia)) return {};
    const Sym3& J = body.inertia;
    const Vec3 L = J * transposed_times(R, w), k = h * L;
    // Rows of M, and u by Cramer's rule.
    const Vec3 x = {J.xx, J.xy + k.z, J.xz - k.y}, y = {J.xy - k.z, J.yy, J.yz + k.x},
               z = {J.xz + k.y, J.yz - k.x, J.zz};
    const Vec3 yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
    const Real determinant = dot(x, yz);
    if (!(determinant > 0) || !(determinant < kMaxGyroscopicRatio * (J.xx * J.yy * J.zz))) return {};
    const Vec3 u = (1 / determinant) * (L.x * yz + L.y * zx + L.z * xy);
    return R * cross(L, u);
}

void advance_pose(Body& body, Real h)
{
    Vec3 w = body.angular_velocity();
    if (body.max_angular_speed < kInf) {
        const Real speed = length(w);
        if (speed > body.max_angular_speed) {
            w *= body.max_angular_speed / speed;
            store(body.avel, w);
        }
    }
    store(body.pos, body.position() + h * body.velocity());
    Quat q = turned(body, body.orientation(), w, h);
    if (normalize(q)) set_orientation(body, q);
}

void damp(Body& body)
{
    const DampingRule& rule = body.damping;
    if (damps_motion(body)) store(body.lvel, (1 - rule.linear_scale) * body.velocity());
    if (damps_spin(body)) {
        store(body.avel, (1 - rule.angular_scale) * body.angular_velocity());
        body.spin_excess *= 1 - rule.angular_scale;
    }
}

}  // namespace epode
