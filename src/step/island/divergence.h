// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Finds parts of which sweeps have made energy out of nothing. With D the function that sweeps without friction never let
// grow, from impulses p = 0 and the velocity v* after all forces, and v_K of kinematic bodies,
//
//   D(p) = p J M^-1 J^T p/2 + p C p/2 + p (J v* - c'),    c' = c - J_K v_K
//   T(p) - T* - p c'  <=  D(p)  <=  D(0) = 0
//
// so the kinetic energy T of a solution, converged or not, is at most T* and what the targets put in. Impulses of the
// last step that no longer fit, along arms many times longer than the radius of gyration, begin with D > 0, and bounds of
// friction that shrink let go of what they held: then a few sweeps can end above any energy. A part has diverged if
//
//   T - T* - max(0, p c') - sum c^2/C  >  T* + m (3 m/s)^2
//
// with c^2/C of springs, which is twice what they hold; the speed is the largest of corrections of positions, of which
// relaxing may leave a part.
#pragma once

#include "step/island/problem/assemble.h"

namespace epode {

// After the solution and before the bodies get its velocities.
bool has_diverged(const IslandWork& work, int part, Real h, const Tasks& tasks, Arena& arena);

}  // namespace epode
