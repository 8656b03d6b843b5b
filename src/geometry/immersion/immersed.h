// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a half space n . x <= d has of a solid: V = the volume, Q = the integral of x over it, so that Q / V is its centre.
#pragma once

#include "math/pose.h"

namespace epode {

struct WaterPlane {
    Vec3 normal{0, 0, 1};  // unit, out of it
    Real offset = 0;

    Real height(Vec3 x) const { return dot(normal, x) - offset; }
};

// The same half space in the frame of the pose.
inline WaterPlane in_frame(const WaterPlane& world, const Pose& pose)
{
    return {transposed_times(pose.R, world.normal), -world.height(pose.p)};
}

struct Immersed {
    Real volume = 0;
    Vec3 moment;

    void add(const Immersed& part) { volume += part.volume, moment += part.moment; }
    Vec3 centre() const { return volume > 0 ? moment / volume : Vec3{}; }
};

}  // namespace epode
