// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Vectors and poses of models, from and to the numbers and bodies of a world.
#pragma once

#include <ode/ode.h>

#include <algorithm>
#include <cmath>

#include "robots/geometry.h"

namespace epode::robots {

// Null, which destroyed bodies give, is 0 and no turn.
inline Vec vec_of(const dReal* v) { return v ? Vec{double(v[0]), double(v[1]), double(v[2])} : Vec{}; }
inline Quat quat_of(const dReal* q)
{
    return q ? Quat{double(q[0]), double(q[1]), double(q[2]), double(q[3])} : Quat{};
}

inline Pose pose_of(dBodyID body)
{
    return {vec_of(dBodyGetPosition(body)), quat_of(dBodyGetQuaternion(body))};
}

inline void set_pose(dBodyID body, const Pose& pose)
{
    const dQuaternion q = {dReal(pose.q.w), dReal(pose.q.x), dReal(pose.q.y), dReal(pose.q.z)};
    dBodySetPosition(body, dReal(pose.p.x), dReal(pose.p.y), dReal(pose.p.z));
    dBodySetQuaternion(body, q);
}

// What libode would refuse is as much as it takes: absurd springs and controls stay without a message.
inline void add_force(dBodyID body, Vec force, Vec torque)
{
    static constexpr double kLargest = sizeof(dReal) == 8 ? 1e25 : 1e8;
    const auto bounded = [](double value) {
        return std::isnan(value) ? dReal(0) : dReal(std::clamp(value, -kLargest, kLargest));
    };
    dBodyAddForce(body, bounded(force.x), bounded(force.y), bounded(force.z));
    dBodyAddTorque(body, bounded(torque.x), bounded(torque.y), bounded(torque.z));
}

}  // namespace epode::robots
