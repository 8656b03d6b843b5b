// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What JointNetwork (joint_network.h) and its factors know of joints: those between two bodies as one block of
// rows, and where each row is solved.
#pragma once

#include "math/vec.h"

namespace epode {

// Share of its diagonal element that is added to each row of a factor: redundant rows have a factor then, and
// since each visit starts from the true residual, the next one recovers the digits that this costs.
inline constexpr double kFirm = 1e-9;

// Where a row is solved: with all others in the factor; on its bound, which holds it, until it pulls away from there; or by
// sweeps, kLeft for the rest of the step.
enum class RowPlace : unsigned char { kFactor, kHeld, kSwept, kLeft };

struct NetworkRow {
    Vec3 lin[2], ang[2], turn[2];  // turn = I^-1 ang
    Real c, c_relaxed, C;
    Real lo, hi, p;  // of a row with a parent: hi is the coefficient
    Real sum;        // of p over the earlier substeps
    Real step;       // impulse per velocity, where the row is swept
    int parent;      // in the rows of the network, or -1
    RowPlace place;
};

struct NetworkJoint {
    int first, count, source;
    int body[2];  // into the velocities
    Real inv_mass[2];

    bool moves(int side) const { return inv_mass[side] > 0; }
};

}  // namespace epode
