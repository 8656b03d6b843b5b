// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The operations of substeps on bodies in lanes, once per kind of machine, with the same bits as result; the
// processor is queried as in contact_kernels.h. Plain pointers and counts for the reason given there.
// `groups` have eight bodies.
#pragma once

#include <span>

#include "solve/common/velocities.h"
#include "solve/substeps/body_lanes.h"

namespace epode {

struct BodyKernels {
    const char* name;
    // v += h M^-1 f with the gyroscopic torque
    void (*accelerate)(const BodyLanes* groups, int bodies, Velocity* v, Real h);
    // Limits angular velocities; x += h v; computes `next` from q.
    void (*turn)(BodyLanes* groups, int bodies, Velocity* v, Real h);
    // Normalises `next` into q; computes R, inertia and, unless null, poses.
    void (*place)(BodyLanes* groups, int bodies, SolverPose* poses);
};

// The kernels that this machine can run; the first is the baseline, the last the fastest.
std::span<const BodyKernels* const> body_kernels();

}  // namespace epode
