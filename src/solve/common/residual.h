// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The common measure of all solvers: the natural residual of the boxed complementarity problem,
//
//   r = max_i d_i |p_i - clip(p_i - w_i/d_i, lo_i, hi_i)| / scale = max_i |clip(w_i, d_i (p_i - hi_i), d_i (p_i - lo_i))| / scale,
//   w = J v + C p - c with v recomputed from p,  d_i = J_i M^-1 J_i^T + C_i,
//   scale = max_i max(|c_i - J_i v*|, |c_i|), 1 if that is 0.
//
// Where friction is a cone, a contact's two friction rows are clipped together, to the ellipse of their
// bounds and with the larger of their d. Where a manifold has one friction (RowSystem::frictions), that
// friction is judged instead of its points', clipped to its ball. The residual is zero exactly at the
// solution; d turns every row into a velocity, so rows of different kinds compare.
#pragma once

#include <span>

#include "base/arena.h"
#include "rows/row_system.h"

namespace epode {

// `v_star`: the bodies after all that is not the rows' own, forces and impulses of manifolds. lo, hi: the
// effective bounds, with friction limits resolved. Negative when the arena is exhausted.
Real natural_residual(const RowSystem& system, std::span<const SolverBody> v_star, std::span<const Real> lo,
                      std::span<const Real> hi, Arena& arena);

// The manifold frictions of one part of the system.
std::span<const ManifoldFriction> frictions_of(const RowSystem& system, int part);

// Bounds with friction limits from the parents' present impulses: what iterative solvers converge to.
void present_bounds(const RowSystem& system, std::span<Real> lo, std::span<Real> hi);

}  // namespace epode
