// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldQuickStep as it is in ODE 0.16, for worlds that ask for that behaviour (dynamics/behaviour.h). The
// iteration is that of solve/sweeps/quick,
//
//   q_i = clip(p_i + W (c_i - J_i v - C_i p_i) / d_i, lo_i, hi_i),   d_i = J_i M^-1 J_i^T + C_i
//
// but p = 0 at first, W is the same in all sweeps, and the order is one of single rows: first those with bounds
// of their own, then those bounded by another row (friction), each in the order of the joints. Before sweeps 8,
// 16, 24 ... the whole order is shuffled, by m - 1 numbers of the process-wide generator. So steps depend on
// whatever else draws from it, islands have to be solved one after the other, and states do not hold it.
#include <algorithm>

#include "base/random.h"
#include "solve/common/residual.h"
#include "solve/common/velocities.h"
#include "solve/solver.h"
#include "solve/sweeps/row_sweep.h"

namespace epode {
namespace {

constexpr int kShuffleEvery = 8;

struct Place {
    int block, row;
};

class ShuffledSweeps {
  public:
    bool pack(const RowSystem& system, Real w, Arena& arena)
    {
        const auto none = arena.take_zeroed<bool>(int(system.blocks.size()));
        if (arena.failed() || !rows_.pack(system, w, none, arena)) return false;
        order_ = arena.take<Place>(int(rows_.rows().size()));
        if (arena.failed()) return false;
        const std::size_t independent = append_rows(0, false);
        append_rows(independent, true);
        return true;
    }

    void run(std::span<Velocity> bodies, int iterations)
    {
        for (int i = 0; i < iterations; ++i) {
            if (i > 0 && i % kShuffleEvery == 0) shuffle();
            for (const Place& place : order_) rows_.visit(bodies, place.block, place.row);
        }
    }

    void store_impulses(RowSystem& system) const { rows_.store_impulses(system.numbers); }

  private:
    // Those with a parent, or those without; returns where the order ends then.
    std::size_t append_rows(std::size_t end, bool with_parent)
    {
        const auto blocks = rows_.blocks();
        for (std::size_t b = 0; b < blocks.size(); ++b)
            for (int row = blocks[b].first; row < blocks[b].first + blocks[b].count; ++row)
                if ((rows_.rows()[std::size_t(row)].parent >= 0) == with_parent)
                    order_[end++] = {int(b), row};
        return end;
    }

    void shuffle()
    {
        for (std::size_t i = 1; i < order_.size(); ++i)
            std::swap(order_[i], order_[std::size_t(ProcessRandom::below(int(i) + 1))]);
    }

    RowSweep rows_;
    std::span<Place> order_;
};

bool has_wide_rows(const RowSystem& system)
{
    return std::any_of(system.blocks.begin(), system.blocks.end(),
                       [](const RowBlock& block) { return block.term_count > 0; });
}

// False: out of memory.
bool find_residual(const RowSystem& system, std::span<const SolverBody> before, Arena& arena,
                   SolveReport& report)
{
    const auto lo = arena.take<Real>(int(system.rows.size())), hi = arena.take<Real>(int(system.rows.size()));
    if (arena.failed()) return false;
    present_bounds(system, lo, hi);
    report.residual = natural_residual(system, before, lo, hi, arena);
    return report.residual >= 0;
}

}  // namespace

bool solve_by_shuffled_sweeps(RowSystem& system, const SweepSettings& settings, Arena& arena,
                              SolveReport& report)
{
    if (has_wide_rows(system))
        return solve_by_sweeps(system, settings, arena, report);  // couplings are no ODE's
    report.method = dIslandMethodSweeps;
    report.iterations = std::max(settings.iterations, 0);
    if (system.rows.empty()) return true;
    Arena::Scope scope(arena);
    const auto before = arena.take<SolverBody>(settings.want_residual ? int(system.bodies.size()) : 0);
    const auto velocities = take_velocities(system, arena);
    ShuffledSweeps sweeps;
    for (RowNumbers& n : system.numbers) n.p = 0;
    if (arena.failed() || !sweeps.pack(system, settings.w, arena)) return false;
    std::copy_n(system.bodies.begin(), before.size(), before.begin());
    load_velocities(system, velocities);
    sweeps.run(velocities, settings.iterations);
    store_velocities(velocities, system);
    sweeps.store_impulses(system);
    return before.empty() || find_residual(system, before, arena, report);
}

}  // namespace epode
