// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the equations of an exact answer are off by as the caller gets it: with the velocities and impulses of
// the system, rounded to Reals, and with the compliance that was asked for,
//
//   r_i = d_i |p_i - clip(p_i - w_i/d_i, lo_i, hi_i)| / scale = |clip(w_i, d_i (p_i - hi_i), d_i (p_i - lo_i))| / scale,
//   w = J v + C p - c,
//   scale = max_i max(|c_i - J_i v*|, sum |J_ik v*_k| / 1000),   1 if that is 0
//
// in double; the second form keeps w where p is so large that w/d is below its rounding. A solver measures its own iterate, which has more digits than floats keep, and may have given rows
// that contradict each other the compliance without which they have no solution: then its answer solves other
// equations than those of the caller, and only this measure shows it. Limits of friction have been forgotten, so
// its impulse is taken for the limit: friction that does not oppose the slip shows, too little of it does not.
#pragma once

#include <span>

#include "rows/row_system.h"

namespace epode {

// Relative; above it a row is unsolved. In double it is what a step promises; rounding stays below it in either precision.
inline constexpr double kUnsolved = kSingle ? 1e-2 : 1e-9;

struct StoredResidual {
    double worst = 0;
    int worst_joint = -1;     // block of the worst unsolved row; -1: none, or a contact's
    int unsolved_joints = 0;  // blocks with unsolved rows, without contacts
};

// `v_star`: velocities after forces, before impulses.
StoredResidual stored_residual(const RowSystem& system, std::span<const SolverBody> v_star);

}  // namespace epode
