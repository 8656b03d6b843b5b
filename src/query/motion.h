// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The motion of a rigid body over one step, as far as its first and last pose determine it: its
// centre moves straight, c(t) = c + t d, and it turns about one axis, R(t) = exp(t [w]x) R, 0 <= t <= 1, by
// less than half a turn. A motion may end early (`until`): then the body stands still from there. A point
// at r from the centre strays by |w|^2 r / 8 at most from the straight line between its two ends.
#pragma once

#include <algorithm>

#include "math/pose.h"
#include "math/trig.h"

namespace epode {

// exp(v / 2) as a unit quaternion: the turn by |v| about v.
inline Quat turn_by(Vec3 v)
{
    const Real half = Real(0.5) * length(v);
    const Vec3 u = (Real(0.5) * sinc(half)) * v;
    return {epode::cos(half), u.x, u.y, u.z};
}

struct Motion {
    Vec3 centre;       // at the beginning
    Vec3 shift, turn;  // over the whole step
    Real until = 1;

    // The pose at time t of an object that begins at `start`.
    Pose at(Real t, const Pose& start) const
    {
        const Real s = std::min(t, until);
        if (turn == Vec3{}) return {start.p + s * shift, start.R};
        const Mat3 R = to_matrix(turn_by(s * turn));
        return {centre + s * shift + R * (start.p - centre), R * start.R};
    }
    bool moves() const { return !(shift == Vec3{}) || !(turn == Vec3{}); }
    // The longest path of a point at this distance from the centre.
    Real max_travel(Real arm) const
    {
        const Real angle = length(turn);
        return length(shift) + (angle > 0 ? angle * arm : Real(0));
    }
};

inline Motion motion_between(Vec3 from, Quat begin, Vec3 to, Quat end)
{
    Motion m;
    m.centre = from;
    m.shift = to - from;
    Quat q = end * conjugate(begin);
    if (q.w < 0) q = {-q.w, -q.x, -q.y, -q.z};
    const Real sine = length(q.vec());
    if (sine > 0) m.turn = (2 * epode::atan2(sine, q.w) / sine) * q.vec();
    return m;
}

}  // namespace epode
