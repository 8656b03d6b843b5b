// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See vectors.h.
#include "scenes/vectors.h"

namespace epode::scenes {

Turn turn(Vec axis, double angle)
{
    const double length = std::sqrt(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z);
    const double s = std::sin(angle / 2) / length;
    return {std::cos(angle / 2), s * axis.x, s * axis.y, s * axis.z};
}

Turn operator*(Turn a, Turn b)
{
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

Vec rotate(Turn q, Vec v)
{
    const Turn r = q * Turn{0, v.x, v.y, v.z} * Turn{q.w, -q.x, -q.y, -q.z};
    return {r.x, r.y, r.z};
}

}  // namespace epode::scenes
