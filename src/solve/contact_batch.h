// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contacts as the kernels read them: a normal row and two friction rows (or the normal alone), between the
// same two points of the bodies, kLanes contacts side by side. 270 bytes per contact, where Jacobians and
// M^-1 J^T would take 480. A batch is one manifold per lane, none of which shares a dynamic body with
// another; lanes of shorter manifolds are filled with contacts that are zero throughout and do nothing.
#pragma once

#include "simd/lanes.h"

namespace epode {

inline constexpr int kManifoldPoints = 4;

struct BatchPoint {
    LaneVec3 r1, r2, n, t1, t2;
    Lanes k_n1, k_n2, k_12;              // gain of the later row times coupling with the earlier
    Lanes c[3], keep[3], gain[3], p[3];  // n, t1, t2
    Lanes mu[2], fixed[2];               // limit of friction: mu p_n + fixed
};

struct ContactBatch {
    int first, count;                  // of the points
    int body1[kLanes], body2[kLanes];  // into the velocities
    Lanes inv_mass1, inv_mass2;
    LaneSym3 inv_inertia1, inv_inertia2;
};

}  // namespace epode
