// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Vectors and poses of three libraries: Eigen's in gz-physics, gz-math's in SDF and those of robots/geometry.h, with which the
// plugin computes.
#pragma once

#include <ode/ode.h>

#include "integrations/gazebo/names.h"
#include "robots/geometry.h"

namespace epode::gazebo {

using robots::Pose;
using robots::Quat;
using robots::Vec;
using EigenPose = gz::physics::Pose3d;
using EigenVec = Eigen::Vector3d;

inline Vec vec_of(const EigenVec& v) { return {v.x(), v.y(), v.z()}; }
inline Vec vec_of(const gz::math::Vector3d& v) { return {v.X(), v.Y(), v.Z()}; }
inline Vec vec_of(const dReal* v) { return {double(v[0]), double(v[1]), double(v[2])}; }
inline Quat quat_of(const dReal* q) { return {double(q[0]), double(q[1]), double(q[2]), double(q[3])}; }

inline Pose pose_of(const EigenPose& pose)
{
    const Eigen::Quaterniond q(pose.linear());
    return {vec_of(EigenVec(pose.translation())), robots::normalised({q.w(), q.x(), q.y(), q.z()})};
}
inline Pose pose_of(const gz::math::Pose3d& pose)
{
    const auto& q = pose.Rot();
    return {vec_of(pose.Pos()), robots::normalised({q.W(), q.X(), q.Y(), q.Z()})};
}

inline EigenVec eigen_of(Vec v) { return {v.x, v.y, v.z}; }
inline EigenPose eigen_of(const Pose& pose)
{
    EigenPose out = EigenPose::Identity();
    out.translate(eigen_of(pose.p));
    out.rotate(Eigen::Quaterniond(pose.q.w, pose.q.x, pose.q.y, pose.q.z));
    return out;
}
inline gz::math::Pose3d math_of(const Pose& pose)
{
    return {pose.p.x, pose.p.y, pose.p.z, pose.q.w, pose.q.x, pose.q.y, pose.q.z};
}

inline bool is_finite(const Pose& pose)
{
    return robots::is_finite(pose.p) && std::isfinite(pose.q.w + pose.q.x + pose.q.y + pose.q.z);
}

}  // namespace epode::gazebo
