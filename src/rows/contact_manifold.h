// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The contact manifold of two bodies whose contacts the world manages, as solvers see it: up to four points
// with one normal n. Floats suffice, because everything is relative to the bodies: an arm of one metre is
// known to 60 nm wherever the bodies are. The impulses that a solver finds come back in the manifold and warm
// start the next step, but not those of a blow.
//
//   u = v1 + w1 x r1 - v2 - w2 x r2       relative velocity at a point
//   separation' = n . u                   negative: penetration beyond the layer
//   normal_impulse >= 0,  |friction_impulse| <= mu normal_impulse        (Coulomb's cone)
//   |rolling_impulse| <= rolling_friction * (sum of the normal impulses)
//
// Friction is bounded in the contact plane as a whole, by a disc or, with an axis a and b = n x a, by an
// ellipse: (f_a / mu)^2 + (f_b / cross_mu)^2 <= normal_impulse^2. What slides takes the point of it that has most
// power. Scaled tangents make a disc of it (FrictionAxes). The torque against rolling and spinning is bounded in all
// three directions together.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/float3.h"

namespace epode {

inline constexpr int kManifoldPoints = 4;
// Of normal impulses, from which on they are a blow's (step/island/blows.h).
inline constexpr float kBlowShare = 0.1f;

// The order of members matters here and below: kernels read groups of four floats at a time
// (solve/substeps/manifold_gather.inc).
struct ManifoldPoint {
    Float3 r1;                // from the centre of body 1, world frame, at the beginning of the step
    float separation;         // along n, m; below zero: deeper than the layer allows
    Float3 r2;                // from the centre of body 2
    float normal_impulse;     // over the whole step, N s; in: of the last step, out: of this step
    Float3 friction_impulse;  // likewise, a vector of the world in the contact plane
};

struct ContactManifold {
    int body1, body2;         // in the island; body2 = -1: the world
    int count;                // points; 0: the bodies do not touch
    Float3 normal;            // unit, into body1
    float mu;                 // coefficient of friction
    Float3 surface_velocity;  // tangential u that friction aims at, m/s: conveyor belts
    float restitution;
    float restitution_threshold;  // approach below which nothing bounces, m/s
    float rolling_friction;       // coefficient of rolling friction, m
    float compliance;             // of each point, m/N; 0: rigid
    float damping_time;           // of a compliant point: damper over spring, s
    float cross_mu;               // coefficient of friction across the axis
    Float3 friction_axis;         // unit, in the contact plane; zero: mu counts in all directions
    float max_impulse;            // sum of the normal impulses in the step, N s; of each point its share
    Float3 rolling_impulse;       // angular, on body1, over the whole step, N m s; in and out
    bool struck;                  // in the last step: its impulses are a blow's, and say nothing of this one
    bool at_border;               // of a surface, with another normal than its own
    ManifoldPoint points[kManifoldPoints];

    bool has_friction_axis() const
    {
        return friction_axis.x != 0 || friction_axis.y != 0 || friction_axis.z != 0;
    }
    bool is_bounded() const { return max_impulse <= std::numeric_limits<float>::max(); }
    // Of each point in the step.
    float largest_impulse() const { return is_bounded() ? max_impulse / float(count) : max_impulse; }
    bool special() const
    {
        return rolling_friction > 0 || compliance > 0 || has_friction_axis() || is_bounded();
    }
};

// Two tangents s_k t_k, t_k unit, s_k <= 1, so that friction g_1 s_1 t_1 + g_2 s_2 t_2 with |g| <= mu N fills the ellipse and
// is the friction of most power where g opposes the velocities along them: a problem of these is one of isotropic
// friction. Of what has no axis s = 1.
struct FrictionAxes {
    Vec3 t[2];
    Real s[2] = {1, 1};
    Real mu;

    explicit FrictionAxes(const ContactManifold& m) : mu(m.mu)
    {
        const Vec3 n = widen(m.normal);
        if (!m.has_friction_axis()) {
            plane_space(n, t[0], t[1]);
            return;
        }
        t[0] = widen(m.friction_axis), t[1] = cross(n, t[0]);
        mu = Real(std::max(m.mu, m.cross_mu));
        if (mu > 0) s[0] = Real(m.mu) / mu, s[1] = Real(m.cross_mu) / mu;
    }
    Vec3 scaled(int k) const { return s[k] * t[k]; }
    // g_k of a friction.
    Real part(int k, Vec3 friction) const { return s[k] > 0 ? dot(friction, t[k]) / s[k] : 0; }
};

// |g| of a friction.
inline Real friction_size(const ContactManifold& m, Vec3 friction)
{
    if (!m.has_friction_axis()) return length(friction);
    const FrictionAxes axes(m);
    const Real a = axes.part(0, friction), b = axes.part(1, friction);
    return std::sqrt(a * a + b * b);
}
// What bounds it, of a normal impulse 1.
inline Real largest_mu(const ContactManifold& m)
{
    return Real(m.has_friction_axis() ? std::max(m.mu, m.cross_mu) : m.mu);
}

inline void clear_impulses(ContactManifold& manifold)
{
    manifold.rolling_impulse = {}, manifold.struck = false;
    for (ManifoldPoint& point : manifold.points) point.normal_impulse = 0, point.friction_impulse = {};
}

// Of steps of different size the forces are the same, not the impulses.
inline void scale_impulses(ContactManifold& manifold, float times)
{
    const auto scale = [times](Float3& a) { a = {times * a.x, times * a.y, times * a.z}; };
    scale(manifold.rolling_impulse);
    for (ManifoldPoint& point : manifold.points) point.normal_impulse *= times, scale(point.friction_impulse);
}

}  // namespace epode
