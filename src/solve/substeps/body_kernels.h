// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What substeps do to bodies in lanes, once per kind of machine, with the same bits as result; chosen as
// contact_kernels.h tells. Plain pointers and counts for the reason given there. `groups` are of eight.
#pragma once

#include <span>

#include "solve/common/velocities.h"
#include "solve/substeps/body_lanes.h"

namespace epode {

struct BodyKernels {
    const char* name;
    // v += h M^-1 f with the gyroscopic torque
    void (*accelerate)(const BodyLanes* groups, int bodies, Velocity* v, Real h);
    // Spins cut to their limit; x += h v; `next`, from q.
    void (*turn)(BodyLanes* groups, int bodies, Velocity* v, Real h);
    // q of length one from `next`, R, inertia; poses, unless null.
    void (*place)(BodyLanes* groups, int bodies, SolverPose* poses);
};

// Those that this machine can run; the first is the baseline, the last the fastest.
std::span<const BodyKernels* const> body_kernels();

}  // namespace epode
