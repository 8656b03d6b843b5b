// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Semi-implicit Euler: q+ = q + h v+. Turns by the exponential map, then back to unit length.
#pragma once

#include "batch/lanes/angles.h"
#include "batch/lanes/work.h"

namespace epode::batch {
namespace {

// exp of half a turn about w for a time h: sin(a/2)/a is continued through a = 0 by the shortest angle that T can divide by.
template <typename P>
EPODE_LANEWISE Vec4Of<P> turned_by(const Vec3Of<P>& w, const P& h)
{
    using T = typename P::Number;
    const P tiny(T(sizeof(T) == 4 ? 1e-18 : 1e-150)), square = dot(w, w) + tiny, rate = square_root(square);
    const SineCosine<P> half = half_turn(h * rate);
    const P along = half.sine / rate;
    return {half.cosine, along * w.x, along * w.y, along * w.z};
}

template <typename P>
EPODE_LANEWISE Vec4Of<P> unit(const Vec4Of<P>& q)
{
    const P inverse = P(1) / square_root(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    return {inverse * q.w, inverse * q.x, inverse * q.y, inverse * q.z};
}

// A ball's velocity is in its link's axes (the turn comes last), a floating base's in the world's (it comes first).
template <typename P>
void integrate(const ModelView& model, const P* v, const P& h, P* q)
{
    for (const BatchJoint& joint : model.joints) {
        P* its = q + joint.position;
        const P* u = v + joint.dof;
        if (joint.kind == JointKind::kHinge || joint.kind == JointKind::kSlide) {
            its[0] = its[0] + h * u[0];
            continue;
        }
        const bool floats = joint.kind == JointKind::kFree;
        P* at = floats ? its + 3 : its;
        const P* w = floats ? u + 3 : u;
        if (floats)
            for (int k = 0; k < 3; ++k) its[k] = its[k] + h * u[k];
        const Vec4Of<P> was{at[0], at[1], at[2], at[3]}, by = turned_by<P>({w[0], w[1], w[2]}, h);
        const Vec4Of<P> now = unit(floats ? by * was : was * by);
        at[0] = now.w, at[1] = now.x, at[2] = now.y, at[3] = now.z;
    }
}

}  // namespace
}  // namespace epode::batch
