// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies that substeps move, kLanes side by side: their poses and what moves them. Velocities are stored
// separately, one cache line per body, because joints and contacts change them.
#pragma once

#include "rows/row_system.h"
#include "simd/lanes.h"

namespace epode {

struct BodyLanes {
    Lanes x[3], q[4];
    Lanes next[4];  // q after the rotation, not yet normalised
    Lanes R[9];     // of q, row by row
    Lanes inv_mass;
    Lanes force[3], torque[3];
    Lanes inertia[6];       // body frame: xx, yy, zz, xy, xz, yz; zero where there is no gyroscopic torque
    Lanes inv_inertia[6];   // body frame
    Lanes inv_in_world[6];  // the same seen in the world
    Lanes uneven;           // 1: the inertia is not the same about all axes
    Lanes max_spin;         // rad/s
    bool any_gyroscopic, any_uneven, any_limit;
    // Bit by bit: the body uses ODE's finite rotation mode, or turns exactly. Neither is done here.
    unsigned char finite, exact;
};

}  // namespace epode
