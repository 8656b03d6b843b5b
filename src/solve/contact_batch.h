// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contacts as the kernels read them, kLanes manifolds side by side. A batch is one manifold per lane, none of
// which shares a dynamic body with another; what the points of a manifold have in common (rows/manifold.h) is
// here, 270 bytes per manifold, and a point has 112 bytes of its own: a sweep is as fast as they come out of
// the caches. Lanes of shorter manifolds are filled with points of zero gain, which do nothing.
#pragma once

#include "rows/manifold.h"
#include "simd/lanes.h"

namespace epode {

struct BatchPoint {
    LaneVec3 r1;
    Lanes c, C;              // of the normal
    Lanes gain[3], p[3];     // n, t1, t2
    Lanes k_n1, k_n2, k_12;  // gain of the later row times coupling with the earlier
};

struct ContactBatch {
    int first, count;                  // of the points
    int body1[kLanes], body2[kLanes];  // into the velocities
    Lanes inv_mass1, inv_mass2;
    LaneSym3 inv_inertia1, inv_inertia2;
    LaneVec3 n, t1, t2, offset;  // r2 = r1 + offset
    Lanes c[2], C[2];            // of the tangents
    Lanes mu[2], fixed[2];       // limit of friction: mu p_n + fixed
};

}  // namespace epode
