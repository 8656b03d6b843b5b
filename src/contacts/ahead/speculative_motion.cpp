// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A point of the geom strays from where its translation takes it by at most the angle times its distance from
// the body's centre, and no point is farther from there than the middle of the box and half its diagonal.
#include "contacts/ahead/speculative_motion.h"

#include "dynamics/integrate.h"
#include "math/rotation.h"

namespace epode {

Vec3 SpeculativeMotion::velocity(const Body* body) const
{
    if (!body) return {};
    const bool falls = body->gravity && !body->kinematic() && !body->disabled;
    return falls ? body->velocity() + h * gravity : body->velocity();
}

Pose SpeculativeMotion::pose(const Body* body, const Pose& now) const
{
    if (!body) return now;
    Quat q = turned(*body, {}, body->angular_velocity(), h);  // all orientations are turned alike
    if (!normalize(q)) return now;
    const Mat3 turn = to_matrix(q);
    const Vec3 x = body->position();
    return {x + h * velocity(body) + turn * (now.p - x), turn * now.R};
}

Aabb SpeculativeMotion::box(const Body* body, const Aabb& now) const
{
    if (!body) return now;
    const Vec3 way = h * velocity(body), middle = Real(0.5) * (now.lo + now.hi);
    const Real reach = length(middle - body->position()) + length(now.hi - middle);
    const Real turn = h * length(body->angular_velocity()) * reach;
    const Vec3 round{turn, turn, turn};
    return {now.lo + way - round, now.hi + way + round};
}

}  // namespace epode
