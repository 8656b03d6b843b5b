// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Finds parts whose solutions have made energy out of nothing. With D the function that sweeps without friction never let
// grow, from impulses p = 0 and the velocity v* after all forces, and v_K of kinematic bodies,
//
//   D(p) = p J M^-1 J^T p/2 + p C p/2 + p (J v* - c'),    c' = c - J_K v_K
//   T(p) - T* - p c'  <=  D(p)  <=  D(0) = 0
//
// so the kinetic energy T of a solution, converged or not, is at most T* and what the targets put in. Impulses of the
// last step that no longer fit, along arms many times longer than the radius of gyration, begin with D > 0, and bounds of
// friction that shrink let go of what they held, or grow with what they hold: then a few sweeps can end above any energy.
// Only gains G = T - T* above m (3 m/s)^2 are looked at; the speed is the largest of corrections of positions, of which relaxing may
// leave a part. A part has diverged if G > T* + m (3 m/s)^2 and
//
//   G - max(0, p c') - sum c^2/C  >  T* + m (3 m/s)^2     with c^2/C of springs, twice what they hold, or
//   sum max(0, p_i (J_i v + C p_i - c_i))  >  G           what rigid rows have worked past their targets; 0 of a solution.
//                                                         Without it, diverged p vouch for themselves where c' > 0
//
// A solution that has not diverged may throw bodies too: near a dead centre a correction of 1 cm asks levers for a thousand
// times its own velocity. Corrections c_i = rate_i error_i of a joint give its bodies at most their energy at these velocities, and
//
//   A = min(m sum c_i^2 + I (the same of angles), m (3 m/s)^2),     m of all of the part, I about its centre of mass (positions/asked.h),
//
// is twice that of all joints in all bodies at once, as far as 3 m/s go. The solution v is nearest to v* in the metric of M, so the
// part v_c that corrections add to the solution v_0 without them is at right angles to it, v_0 M v_c = (J v_0) p_c = 0 while contacts
// hold, and T(v) = T(v_0) + T(v_c) with T(v_0) <= T* and what motors put in. T(v_c) is the least of all motions that make the
// corrections, A/2 at most where the part is not wedged. If G exceeds A + m (1 m/s)^2 and what motors, springs and rebounds put
// in, a share of the corrections is solved again: T(v_c) goes with its square, so half the root of the ratio. Joints
// that are open by more than this closes in a step close in several. What rows work past their targets, and what corrections throw,
// is judged where bounds_corrections (containment.h) says so.
#pragma once

#include "step/island/problem/assemble.h"

namespace epode {

struct SolutionEnergy {
    bool diverged = false;
    Real correctable = 1;  // share of the errors of positions; 1: nothing is thrown
};

// After the solution and before the bodies get its velocities.
SolutionEnergy judge_energy(const IslandWork& work, int part, Real h, bool bounds_corrections,
                            const Tasks& tasks, Arena& arena);

}  // namespace epode
