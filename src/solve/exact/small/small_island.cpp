// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which islands are small, and for which method, was determined by measurement (docs/solvers.md).
#include "solve/exact/small/small_island.h"

#include <algorithm>

#include "solve/common/residual.h"
#include "solve/common/work_meter.h"
#include "solve/exact/small/condensed.h"
#include "solve/exact/small/few_bodies.h"
#include "solve/exact/small/small_island.inc"

namespace epode {
namespace {

constexpr std::size_t kMaxBlocks = SmallIsland::kMaxBlocks;
constexpr std::size_t kPivotFirst = 36;  // rows up to which the active set is not tried before
constexpr std::size_t kPivotMax = 64;    // rows up to which it beats the interior point

constexpr double kNearly = 0.01;  // natural residual of a guess that is almost right

// Microseconds of a row, once; of a row in a tree of few joints.
constexpr double kSmallRow = 0.1, kCondensedRow = 0.1;

enum class Method { kNewton, kPivoting };

void count_work(WorkMeter* work, double time)
{
    if (work) work->spent += time;
}

SmallResult solve_with(Method method, RowSystem& system, const ExactSettings& settings, Arena& arena,
                       SolveReport& report)
{
    Arena::Scope scope(arena);
    SmallIsland island;
    if (!island.prepare(system, arena)) return SmallResult::kNoMemory;
    if (method == Method::kPivoting && !island.bounded()) return SmallResult::kNotSolved;
    const SmallResult result = method == Method::kNewton ? island.newton(system, arena, report.iterations)
                                                         : island.pivoting(system, arena, report.iterations);
    const double rows = double(system.rows.size());
    count_work(settings.work, kSmallRow * rows + island.work(rows));
    if (result != SmallResult::kSolved) return result;
    // Answers that these methods accept may still lack digits; the general path has more.
    const double residual = island.residual();
    if (!(residual <= settings.refine_above)) return SmallResult::kNotSolved;
    island.store(system);
    report.method = dIslandMethodDense;
    report.factorisations += island.factorisations();
    report.residual = Real(residual);
    return result;
}

// At rest the impulses of the last step are almost those of this one. The active set that they name then
// needs one or two factorisations, where pivoting enters row by row.
bool almost_right(const RowSystem& system, Arena& arena)
{
    Arena::Scope scope(arena);
    const std::span<Real> lo = arena.take<Real>(int(system.rows.size()));
    const std::span<Real> hi = arena.take<Real>(int(system.rows.size()));
    if (arena.failed()) return false;
    present_bounds(system, lo, hi);
    const Real residual = natural_residual(system, system.bodies, lo, hi, arena);
    return residual >= 0 && residual < kNearly;
}

bool has_joints(const RowSystem& system)
{
    return std::any_of(system.blocks.begin(), system.blocks.end(),
                       [](const RowBlock& block) { return !block.contact; });
}

}  // namespace

bool can_pivot(const RowSystem& system)
{
    return system.rows.size() <= kPivotMax && system.blocks.size() <= kMaxBlocks;
}

SmallResult solve_by_pivoting(RowSystem& system, const ExactSettings& settings, Arena& arena,
                              SolveReport& report)
{
    return solve_with(Method::kPivoting, system, settings, arena, report);
}

SmallResult solve_small(RowSystem& system, const ExactSettings& settings, Arena& arena, SolveReport& report)
{
    std::size_t dynamic = 0;
    for (const SolverBody& body : system.bodies) dynamic += body.inv_mass > 0;
    if (dynamic <= kMaxLinks && has_joints(system)) {
        const SmallResult result =
            condensed_kernels().back()->solve(system, settings.refine_above, arena, report);
        count_work(settings.work, kCondensedRow * double(system.rows.size()));
        if (result != SmallResult::kNotSolved) return result;
    }
    if (system.blocks.size() > kMaxBlocks) return SmallResult::kNotSolved;
    if (system.rows.size() <= 6 * dynamic) {
        const SmallResult result = solve_with(Method::kNewton, system, settings, arena, report);
        if (result != SmallResult::kNotSolved || !can_pivot(system)) return result;
        return solve_by_pivoting(system, settings, arena, report);
    }
    if (dynamic <= FewBodies::kMaxBodies && system.rows.size() <= kPivotMax) {
        Arena::Scope scope(arena);
        FewBodies few;
        const SmallResult result = few.solve(system, settings.refine_above, arena, report, settings.work);
        if (result != SmallResult::kNotSolved) return result;
    }
    if (system.rows.size() > kPivotFirst || almost_right(system, arena)) return SmallResult::kNotSolved;
    return solve_by_pivoting(system, settings, arena, report);
}

}  // namespace epode
