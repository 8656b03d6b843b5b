// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where lanes read a SolverBody, in groups of four neighbouring numbers: 1/m and the diagonal of the inverse
// inertia, then its off-diagonal elements and an unused number.
#pragma once

#include <cstddef>

#include "rows/row_system.h"
#include "simd/pack_memory.h"

namespace epode {

inline constexpr std::size_t kMassRow = offsetof(SolverBody, inv_mass);
inline constexpr std::size_t kProductsRow = offsetof(SolverBody, inv_inertia) + offsetof(Sym3, xy);
static_assert(offsetof(SolverBody, inv_inertia) == kMassRow + sizeof(Real));
static_assert(offsetof(SolverBody, mass) == kProductsRow + 3 * sizeof(Real));

namespace {

// 1/m and the inverse inertia of the body of each lane.
template <typename P, typename L>
EPODE_LANEWISE void gather_masses(const SolverBody* const* bodies, Part<P> part, L& inv_mass,
                                  LaneSym3Of<L>& inv_inertia)
{
    const SolverBody* const* from = bodies + part.first();
    const auto main = gather_members<P, Real>(from, kMassRow),
               products = gather_members<P, Real>(from, kProductsRow);
    store(inv_mass, part, main.w);
    store(inv_inertia.xx, part, main.x), store(inv_inertia.yy, part, main.y);
    store(inv_inertia.zz, part, main.z), store(inv_inertia.xy, part, products.w);
    store(inv_inertia.xz, part, products.x), store(inv_inertia.yz, part, products.y);
}

}  // namespace
}  // namespace epode
