// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See rod.h. The row of a rod of length zero still removes one direction only; a ball joint is what removes
// three.
#include "joints/types/rod.h"

namespace epode {
namespace {

constexpr Real kNoLength = sizeof(Real) == 8 ? Real(1e-12) : Real(1e-6);

// Of the material points at both ends, where they are in one place.
Vec3 relative_velocity(const Joint& j, Vec3 p)
{
    const Vec3 v = j.body1()->point_velocity(p);
    return j.body2() ? v - j.body2()->point_velocity(p) : v;
}

}  // namespace

void Rod::measure(const Joint& j) { length = epode::length(end.world(j, 0) - end.world(j, 1)); }

void Rod::set_user_end(const Joint& j, int user_index, Vec3 point)
{
    const int k = node_of(j, user_index);
    end.local[k] = point_to_local(j.node[k].body, point);
    measure(j);
}

void Rod::lock(const Joint& j, RowWriter& out) const
{
    const Vec3 p1 = end.world(j, 0), p2 = end.world(j, 1);
    const Real now = epode::length(p1 - p2);
    const Vec3 d = normalized_or(now > kNoLength ? p1 - p2 : relative_velocity(j, p1), {1, 0, 0});
    const Vec3 r2 = j.body2() ? p2 - j.body2()->position() : Vec3{};
    softness.apply_to(out, out.row(point_jacobian(j, d, p1 - j.body1()->position(), r2), length - now));
}

}  // namespace epode
