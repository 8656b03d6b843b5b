// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Coulomb's friction in the exact stepper. ODE's two phases (direct.cpp) take friction limits from normal
// impulses without friction, which is wrong where friction carries load: under a ladder, in an arch, around a
// capstan. For blocks marked `coulomb` the limits are those of the answer itself, and a disc:
//
//   |(p_1, p_2)| <= mu p_n;   where they are equal, the slip w is opposed to p
//
// solved as a fixed point of box problems, each of them strictly convex and exact (Haslinger's for normal
// impulses; Newton's step for directions):
//
//   x = p_n of the last answers, extrapolated (anderson.h);  L = mu x
//   q = p - w/d, d the larger of the tangents' J M^-1 J^T + C
//   |q| <= L: the contact sticks, and its box is [-L, L]^2
//   else it slides along e = q/|q|: tangents are turned so that the first is e. The disc near L e is the line
//   p_1 <= L, and the slip follows the direction of p: w_2 + (|w_1|/L) p_2 = 0, a compliance of p_2.
//
// The answer's error is the largest d |p - clip(q)|, the natural residual of residual.h for discs. Existence
// is not guaranteed for large mu (Painleve's rod): then the best iterate counts, at worst ODE's.
// (Haslinger, Hlavacek, Necas 1996; Alart, Curnier 1991; De Saxce, Feng 1998.)
#pragma once

#include "solve/solver.h"

namespace epode {

// Solves a system as in direct.cpp. False: out of memory.
using SolveBoxes = bool (*)(RowSystem& system, const ExactSettings& settings, Arena& arena,
                            SolveReport& report);

// Has `solve` solve the system until friction is Coulomb's. False: out of memory.
bool solve_coulomb(SolveBoxes solve, RowSystem& system, const ExactSettings& settings, Arena& arena,
                   SolveReport& report);

}  // namespace epode
