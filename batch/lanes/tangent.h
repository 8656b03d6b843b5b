// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The tangent space of states: a number for each velocity and, again, for each velocity's change. Of positions it is what a velocity
// along it reaches in a unit of time: q (+) d = integrate(q, d), turns by the exponential map; and d = q (-) p is the inverse,
//     q = p exp(d):   d = 2 asin(|s|) / |s| s,   s the vector part of p* q, both as seen in the link's axes.
// Angular velocities of floating bases are in the world's axes in a group (group.h) and in the link's axes here, so a turned base
// carries its angular velocity along.
#pragma once

#include "batch/lanes/step.h"

namespace epode::batch {
namespace {

// A group's state moves along sign times seed: tangents of positions, then of velocities.
template <typename P>
void move_state(const ModelView& model, const P* seed, const P& sign, P* q, P* v, P* tangent)
{
    const int dofs = model.velocities;
    turn_rates(model, q, false, v);
    for (int i = 0; i < dofs; ++i) tangent[i] = sign * seed[i], v[i] = v[i] + sign * seed[dofs + i];
    turn_rates(model, q, true, tangent);
    integrate(model, tangent, P(1), q);
    turn_rates(model, q, true, v);
}

// 2 asin(s) / s by its series, of x = s^2 below a quarter: what a derivative asks for is near 0.
template <typename P>
EPODE_LANEWISE P arc_over_chord(const P& x)
{
    using T = typename P::Number;
    P sum(1);
    for (int k = 14; k >= 1; --k) {
        const T ratio = T(double(2 * k - 1) * (2 * k - 1) / (double(2 * k) * (2 * k + 1)));
        sum = P(1) + P(ratio) * x * sum;
    }
    return sum + sum;
}

template <typename P>
EPODE_LANEWISE Vec3Of<P> turn_between(const P* from, const P* to)
{
    const Vec4Of<P> a{from[0], from[1], from[2], from[3]}, b{to[0], to[1], to[2], to[3]};
    const Vec4Of<P> c = conjugate(a) * b;
    const Vec3Of<P> s = c.vector_part();
    return (if_greater(P(0), c.w, P(-1), P(1)) * arc_over_chord(dot(s, s))) * s;
}

// to (-) from, times rate.
template <typename P>
void difference(const ModelView& model, const P* from, const P* to, const P& rate, P* out)
{
    for (const BatchJoint& joint : model.joints) {
        const P *a = from + joint.position, *b = to + joint.position;
        P* d = out + joint.dof;
        if (joint.kind == JointKind::kHinge || joint.kind == JointKind::kSlide) {
            d[0] = rate * (b[0] - a[0]);
            continue;
        }
        if (joint.kind == JointKind::kFree) {
            for (int k = 0; k < 3; ++k) d[k] = rate * (b[k] - a[k]);
            a += 3, b += 3, d += 3;
        }
        const Vec3Of<P> turn = rate * turn_between(a, b);
        d[0] = turn.x, d[1] = turn.y, d[2] = turn.z;
    }
}

}  // namespace
}  // namespace epode::batch
