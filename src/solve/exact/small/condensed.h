// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The exact solve of an island whose joints form trees: a robot on the ground, a chain. Its rows without
// bounds, F, are condensed once (joint_tree.inc); what remains is a small dense box problem in the others, B,
//
//   w_B = S p_B - s,   S = A_BB - A_BF A_FF^-1 A_FB
//
// on which both phases of dWorldStep pivot (box_pivoting.h). Newton's steps on F and the rows of B that are
// between their bounds then correct the answer: in each phase for the compliance that the factors lack or have
// more of, at the end with the residual computed from velocities, as it will be judged. Compiled for several
// machines, with the same bits.
#pragma once

#include <span>

#include "solve/exact/small/small_island.h"

namespace epode {

// Bodies of a tree, each a bit of a word.
inline constexpr int kMaxLinks = 64;

struct CondensedKernels {
    const char* name;

    // kNotSolved: joints form loops, there are no joints, too many bodies or bounded rows, or the answer misses
    // the required precision.
    SmallResult (*solve)(RowSystem& system, double enough, Arena& arena, SolveReport& report);
};

std::span<const CondensedKernels* const>
condensed_kernels();  // the fastest that this machine can run is last

}  // namespace epode
