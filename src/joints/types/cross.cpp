// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See cross.h. While the joint is out of true the arms are not quite perpendicular: each angle is taken
// against a cross whose own arm is exact and whose other arm is the nearest perpendicular.
#include "joints/types/cross.h"

#include "math/rotation.h"

namespace epode {

// The cross with its first arm exactly on axis i and the second nearly on the other.
Quat Cross::orientation(const Joint& j, int i) const
{
    Mat3 R;
    const Vec3 a = axis(j, i);
    if (!rotation_from_axes(a, axis(j, 1 - i), R)) rotation_from_axes(a, some_perpendicular(a), R);
    return to_quat(R);
}

// Rotation of body i against the cross about axis i; the second angle has the opposite sense.
Real Cross::body_angle(const Joint& j, int i) const
{
    const Turn now{rotation_of(j.body1()),
                   rotation_of(j.body2()),
                   orientation_of(j.node[i].body),
                   zero[i],
                   local[0],
                   local[1]};
    return turn[i].of(now, [&] { return hinge_angle(now.own, orientation(j, i), zero[i], local[i]); });
}

void Cross::set_zero(const Joint& j, Real reading1, Real reading2)
{
    const Real reading[2] = {reading1, -reading2};
    for (int i = 0; i < 2; ++i)
        zero[i] = hinge_zero(orientation_of(j.node[i].body), orientation(j, i), local[i], reading[i]);
}

void Cross::lock_right_angle(const Joint& j, RowWriter& out) const
{
    const Vec3 a1 = axis(j, 0), a2 = axis(j, 1);
    const Vec3 n = normalized_or(cross(a1, a2), some_perpendicular(a1));
    out.row(angular_jacobian(j, n), -dot(a1, a2));
}

}  // namespace epode
