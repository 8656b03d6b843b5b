// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies that substeps move, kLanes side by side: what moves them and where they are. Velocities stay
// beside, one line of the cache per body, since joints and contacts change them.
#pragma once

#include "rows/row_system.h"
#include "simd/lanes.h"

namespace epode {

struct BodyLanes {
    Lanes x[3], q[4];
    Lanes next[4];  // q when it has turned, not yet of length one
    Lanes R[9];     // of q, row by row
    Lanes inv_mass;
    Lanes force[3], torque[3];
    Lanes inertia[6];       // body frame: xx, yy, zz, xy, xz, yz; zero where there is no gyroscopic torque
    Lanes inv_inertia[6];   // body frame
    Lanes inv_in_world[6];  // the same seen in the world
    Lanes uneven;           // 1: the inertia is not the same about all axes
    Lanes max_spin;         // rad/s
    bool any_gyroscopic, any_uneven, any_limit;
    unsigned char finite;  // bit by bit: turns as ODE's finite rotation mode has it, which is not done here
};

}  // namespace epode
