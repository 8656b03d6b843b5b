// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joint manifolds as the kernels read them, eight in Reals or sixteen in floats side by side. A batch has one
// manifold per lane, none of which shares a dynamic body with another. What the points of a manifold share
// (rows/joint_manifold.h) is here, and a point has 14 numbers of its own: a sweep is as fast as they arrive
// from the caches. In floats twice as many fit a register and a cache. Lanes of shorter manifolds are filled
// with points of zero effective mass, which do nothing.
#pragma once

#include <cstdint>

#include "rows/joint_manifold.h"
#include "simd/lanes.h"
#include "solve/common/velocities.h"

namespace epode {

// The velocities that lanes L, Lanes or BroadLanes, sweep over.
template <typename L>
struct VelocityOf;
template <>
struct VelocityOf<Lanes> {
    using Type = Velocity;
};
template <>
struct VelocityOf<BroadLanes> {
    using Type = FloatVelocity;
};

template <typename L>
struct BatchPointOf {
    LaneVec3Of<L> r1;
    L c, C;                     // of the normal
    L effective_mass[3], p[3];  // n, t1, t2
    L k_n1, k_n2, k_12;         // effective mass of the later row times its coupling with the earlier one
};

// Manifold friction (contact_friction.inc): a force along t1 and t2 at an anchor, which is the mean of the
// points, and a torque about n.
template <typename L>
struct ManifoldFrictionLanesOf {
    LaneVec3Of<L> r1;                          // of the anchor; r2 = r1 + offset
    L x[kManifoldPoints], y[kManifoldPoints];  // positions of the points along t1 and t2, from there
    L k_11, k_22, k_12, k_1n, k_2n, k_nn;      // J M^-1 J^T of the tangents there and of the rotation about n
    L min_radius;                              // below this radius a torque is only rounding
    L C;                                       // that of one point divided by the number of points
    L w;                                       // over-relaxation
    L p[3];                                    // force, torque
};

// Which parts of a batch need not be computed, as with cubes and balls, and with friction as most programs
// define it. Of a step of S1, S2 or S6 this saves 3 to 4 percent of the instructions (docs/notes/lanes.md).
enum class BatchForm : std::uint8_t {
    kAny,
    kPlain,  // friction has target zero and one C and one limit mu p_n for both tangents
    kEven,   // also, every inverse inertia is a multiple of 1: that in xx
};

template <typename L>
struct ContactBatchOf {
    int first, count;  // of the points
    BatchForm form;
    bool cone;                                     // of all its manifolds
    ManifoldFrictionLanesOf<L>* friction;          // null: each point has its own
    std::uint32_t at1[L::kCount], at2[L::kCount];  // of the bodies, in bytes after the first velocity
    L inv_mass1, inv_mass2;
    LaneSym3Of<L> inv_inertia1, inv_inertia2;
    LaneVec3Of<L> n, t1, t2, offset;  // r2 = r1 + offset
    L c[2], C[2];                     // of the tangents
    L mu[2], fixed[2];                // limit of friction: mu p_n + fixed

    // Into the velocities.
    int body1(int lane) const { return int(at1[lane] / sizeof(typename VelocityOf<L>::Type)); }
    int body2(int lane) const { return int(at2[lane] / sizeof(typename VelocityOf<L>::Type)); }
};

using BatchPoint = BatchPointOf<Lanes>;
using ContactBatch = ContactBatchOf<Lanes>;

}  // namespace epode
