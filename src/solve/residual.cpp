// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Two passes over the rows: J^T p into velocities, then each row's own residual.
#include "solve/residual.h"

#include <algorithm>

namespace epode {
namespace {

SolverBody* second(std::span<SolverBody> bodies, const RowBlock& block)
{
    return block.body2 >= 0 ? &bodies[std::size_t(block.body2)] : nullptr;
}

}  // namespace

void present_bounds(const RowSystem& system, std::span<Real> lo, std::span<Real> hi)
{
    for (std::size_t i = 0; i < system.numbers.size(); ++i) {
        const RowNumbers& n = system.numbers[i];
        lo[i] = n.lo, hi[i] = n.hi;
        if (n.parent < 0) continue;
        const Real p = std::fabs(system.numbers[std::size_t(n.parent)].p);
        hi[i] = p > 0 ? n.hi * p : 0;
        lo[i] = -hi[i];
    }
}

Real natural_residual(const RowSystem& system, std::span<const SolverBody> v_star, std::span<const Real> lo,
                      std::span<const Real> hi, Arena& arena)
{
    if (system.rows.empty()) return 0;
    Arena::Scope scope(arena);
    auto bodies = arena.take<SolverBody>(int(v_star.size()));
    if (bodies.empty()) return -1;
    std::copy(v_star.begin(), v_star.end(), bodies.begin());

    Real scale = 0;
    for (const RowBlock& block : system.blocks)
        for (int i = block.first; i < block.first + block.count; ++i) {
            const auto k = std::size_t(i);
            const SolverBody& a = v_star[std::size_t(block.body1)];
            const SolverBody* b = block.body2 >= 0 ? &v_star[std::size_t(block.body2)] : nullptr;
            const Real c = system.numbers[k].c;
            scale = std::max({scale, std::fabs(c), std::fabs(c - row_velocity(system.rows[k], a, b))});
            apply_impulse(system.rows[k], system.numbers[k].p, bodies[std::size_t(block.body1)],
                          second(bodies, block));
        }

    Real worst = 0;
    for (const RowBlock& block : system.blocks)
        for (int i = block.first; i < block.first + block.count; ++i) {
            const auto k = std::size_t(i);
            const RowNumbers& n = system.numbers[k];
            const SolverBody& a = bodies[std::size_t(block.body1)];
            const SolverBody* b = second(bodies, block);
            const Real d = row_mobility(system.rows[k], a, b) + n.C;
            if (!(d > 0)) continue;  // an empty row constrains nothing
            const Real w = row_velocity(system.rows[k], a, b) + n.C * n.p - n.c;
            const Real clipped = std::min(std::max(n.p - w / d, lo[k]), hi[k]);
            worst = std::max(worst, d * std::fabs(n.p - clipped));
        }
    return worst / (scale > 0 ? scale : 1);
}

}  // namespace epode
