// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where lanes read a SolverBody, in groups of four neighbouring numbers: 1/m and the diagonal of the inverse
// inertia, then its off-diagonal elements and an unused number.
#pragma once

#include <cstddef>

#include "rows/row_system.h"

namespace epode {

inline constexpr std::size_t kMassRow = offsetof(SolverBody, inv_mass);
inline constexpr std::size_t kProductsRow = offsetof(SolverBody, inv_inertia) + offsetof(Sym3, xy);
static_assert(offsetof(SolverBody, inv_inertia) == kMassRow + sizeof(Real));
static_assert(offsetof(SolverBody, mass) == kProductsRow + 3 * sizeof(Real));

}  // namespace epode
