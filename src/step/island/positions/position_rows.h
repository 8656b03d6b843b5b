// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which rows hold positions, and the levers that make their errors comparable.
#pragma once

#include <algorithm>
#include <cmath>

#include "joints/rod_length.h"
#include "step/island/problem/assemble.h"

namespace epode {

inline constexpr std::size_t kFewRows = 64;  // a dense solution is shorter
inline constexpr Real kSoftness =
    kSingle ? Real(1e-6) : Real(1e-9);   // of the inverse mass, for redundant rows
inline constexpr Real kLargestTurn = 1;  // rad, of one Newton step

// Of a displacement, v and w: with which no body turns further than kLargestTurn; 0: it is not finite.
inline Real largest_share(std::span<const SolverBody> displacement)
{
    Real largest = 0;
    for (const SolverBody& s : displacement) {
        const Real turn = length(s.w), way = length(s.v);
        if (!usable(turn) || !usable(way)) return 0;
        largest = std::max(largest, turn);
    }
    return largest > kLargestTurn ? kLargestTurn / largest : 1;
}

// Softness above this share of the inverse effective mass is meant: a spring.
inline bool is_spring(const Row& row, const RowBlock& block, const RowSystem& system)
{
    constexpr Real kSpringShare = Real(1e-3);
    if (row.drive) return true;
    return row.cfm / system.h > kSpringShare * inverse_effective_mass(system, block, row, system.bodies);
}

// Holds a joint together, and nothing else.
inline bool is_equality(const Row& row)
{
    return row.kind == RowKind::kLock && row.lo == -kInf && row.hi == kInf && !row.drive;
}

// The same of a joint that is rigid there: what SHAKE closes (shake.h).
inline bool is_closed(const Row& row, const RowBlock& block, const RowSystem& system)
{
    return !block.contact && is_equality(row) && !row.given && !is_spring(row, block, system);
}

inline bool turns_only(const Row& row) { return row.lin1 == Vec3{} && row.lin2 == Vec3{}; }

// The longest lever arm of the rows of a block of the step, or the rod's length, but not less than its bodies' radius of gyration.
inline Real longest_arm(const IslandWork& work, const RowBlock& block)
{
    Real longest = 0;
    const auto at_joint = std::size_t(&block - work.system.blocks.data());
    if (at_joint < work.joints.size()) longest = rod_length(*work.joints[at_joint]);
    for (int k = 0; k < 2; ++k) {
        const int at = k == 0 ? block.body1 : block.body2;
        if (at < 0 || work.island.bodies[std::size_t(at)]->kinematic()) continue;
        const Body& b = *work.island.bodies[std::size_t(at)];
        const Real largest = std::max(b.inertia.xx, std::max(b.inertia.yy, b.inertia.zz));
        longest = std::max(longest, std::sqrt(largest * b.inv_mass));
        for (int i = block.first; i < block.first + block.count; ++i) {
            const Row& row = work.system.rows[std::size_t(i)];
            if (!(row.lin1 == Vec3{})) longest = std::max(longest, length(k == 0 ? row.ang1 : row.ang2));
        }
    }
    return longest > 0 ? longest : 1;
}

}  // namespace epode
