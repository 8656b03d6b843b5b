// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldStep: ODE's mixed complementarity problem, solved exactly. Friction limits make it non-convex; ODE
// defines the answer in two phases, each a strictly convex box problem with one solution (C > 0):
//
//   1. without the rows that have a parent (their bounds are 0)           -> p1
//   2. all rows, with limits  hi = mu |p1[parent]|,  lo = -hi, frozen     -> p
//
// Phase 1 must be exact including the split among redundant contacts, because phase 2 takes it as limits.
// Small islands have methods of their own (small_island.h). All others, and those that these give up, take
// per phase: the active set from the warm start; the interior point where the guess does not settle; then the
// active set again from its tags. The answer with the smaller natural residual counts. Nothing is ever
// printed. The alternative, Dantzig's principal pivoting on the dense J M^-1 J^T, is what ODE does: its cost
// is cubic in the rows, and a pivot near zero on redundant contacts ends it.
#include <algorithm>
#include <cmath>

#include "solve/common/cut_blocks.h"
#include "solve/common/stored_residual.h"
#include "solve/common/work_meter.h"
#include "solve/exact/active_set.h"
#include "solve/exact/coulomb.h"
#include "solve/exact/extended/primal_active_set.h"
#include "solve/exact/interior_point.h"
#include "solve/exact/small/box_phases.h"
#include "solve/exact/small/small_island.h"
#include "solve/solver.h"

namespace epode {
namespace {

constexpr double kPromised = 1e-9;  // natural residual that every answer must reach
constexpr int kQuickRounds = 30;    // of the first active set
constexpr double kInteriorTolerance = 2e-10;

class DirectSolve {
  public:
    // `give_up_early`: fail where the active set does not settle, because a better method than the interior
    // point is available.
    explicit DirectSolve(bool give_up_early) : give_up_early_(give_up_early) {}

    bool prepare(RowSystem& system, const ExactSettings& settings, Arena& arena)
    {
        refine_above_ = settings.refine_above;
        const int m = int(system.rows.size());
        if (!problem_.build(system, settings.work, arena)) return false;
        state_.lo = arena.take<double>(m);
        state_.hi = arena.take<double>(m);
        state_.p = arena.take<double>(m);
        state_.tag = arena.take<BoxState::Tag>(m);
        state_.v = arena.take<double>(problem_.unknowns());
        kept_ = arena.take<double>(m);
        begun_ = arena.take<double>(m);
        scratch_ = arena.take<double>(problem_.unknowns());
        return !arena.failed() &&
               problem_.build_factor(system, settings.symbolic_cache, settings.tasks, arena) &&
               packed_.prepare(problem_, arena) && active_.prepare(problem_, packed_.max_places(), arena);
    }

    bool gives_up() const { return problem_.gives_up(); }
    int factorisations() const { return problem_.factorisations(); }

    // Both phases; false: out of memory, or given up.
    bool run(RowSystem& system, Arena& arena, SolveReport& report)
    {
        const bool friction = bound_without_friction(problem_, system, state_);
        if (!solve_phase(arena, report)) return false;
        if (friction) {
            freeze_friction(problem_, system, state_);
            if (!solve_phase(arena, report)) return false;
        }
        problem_.store(system, state_.p, scratch_);
        report.factorisations += problem_.factorisations();
        report.method = report.fallback ? dIslandMethodInteriorPoint : dIslandMethodActiveSet;
        report.residual = Real(residual_);
        return true;
    }

  private:
    bool solve_phase(Arena& arena, SolveReport& report)
    {
        if (!solve_box(arena, report) || gives_up()) return false;
        residual_ = problem_.residual(state_, scratch_);
        if (!(residual_ > refine_above_)) return true;
        if (!fallback_ready_ && !(fallback_ready_ = fallback_.prepare(problem_, arena))) return false;
        residual_ = fallback_.solve(problem_, state_, scratch_, report.iterations);
        if (!(residual_ > kPromised)) return true;
        if (gives_up()) return false;
        if (!problem_.soften()) return solve_densely(arena, report);
        std::copy(begun_.begin(), begun_.end(), state_.p.begin());
        return solve_phase(arena, report);
    }

    // Improves the answer or leaves it as it was.
    bool solve_densely(Arena& arena, SolveReport& report)
    {
        if (problem_.row_count() > ExtendedFactor::kMaxRows) return true;
        problem_.count_work(ExtendedFactor::work(problem_.row_count()));
        if (gives_up()) return false;
        if (!fallback_dense_ && !(fallback_dense_ = fallback_.prepare_dense(problem_, arena))) return false;
        residual_ = fallback_.solve(problem_, state_, scratch_, report.iterations);
        return true;
    }

    bool solve_box(Arena& arena, SolveReport& report)
    {
        const ActiveSetSettings settings{kQuickRounds, false};
        std::copy(state_.p.begin(), state_.p.end(), begun_.begin());
        packed_.pack(problem_, state_);
        if (active_.solve(problem_, packed_, state_.v, settings, report.iterations)) {
            packed_.unpack(state_);
            return true;
        }
        if (give_up_early_ || gives_up()) return false;
        if (!problem_.wide_rows().empty()) return persist(report);
        report.fallback = true;
        if (!interior_ready_) interior_ready_ = interior_.prepare(problem_, packed_.max_places(), arena);
        if (!interior_ready_) return false;
        // A wrong guess of the active set may have left impulses of any size.
        packed_.take_impulses(begun_);
        interior_.solve(problem_, packed_, state_.v, kInteriorTolerance, report.iterations);
        packed_.unpack(state_);
        if (!gives_up()) keep_better_of_polish(report);
        return true;
    }

    // With couplings, whose rows the interior point does not know: one flip at a time if need be. What this
    // leaves is the fallback's.
    bool persist(SolveReport& report)
    {
        const int rounds = kQuickRounds + problem_.row_count();
        packed_.take_impulses(begun_);
        if (!active_.solve(problem_, packed_, state_.v, {rounds, true}, report.iterations))
            packed_.take_impulses(begun_);
        packed_.unpack(state_);
        for (std::size_t i = 0; i < state_.p.size(); ++i)
            state_.p[i] = std::min(std::max(state_.p[i], state_.lo[i]), state_.hi[i]);
        return true;
    }

    // The active set from the interior point's tags usually ends exactly; otherwise the answer of the
    // interior point is kept.
    void keep_better_of_polish(SolveReport& report)
    {
        const double before = problem_.residual(state_, scratch_);
        std::copy(state_.p.begin(), state_.p.end(), kept_.begin());
        const int rounds = 30 + problem_.row_count() / 2;
        const bool exact = active_.solve(problem_, packed_, state_.v, {before > kPromised ? rounds : 8, true},
                                         report.iterations);
        packed_.unpack(state_);
        if (exact) return;
        for (std::size_t i = 0; i < state_.p.size(); ++i)
            state_.p[i] = std::min(std::max(state_.p[i], state_.lo[i]), state_.hi[i]);
        if (problem_.residual(state_, scratch_) > before)
            std::copy(kept_.begin(), kept_.end(), state_.p.begin());
    }

    double refine_above_ = 0;
    ExactProblem problem_;
    PackedRows packed_;
    ActiveSet active_;
    InteriorPoint interior_;
    PrimalActiveSet fallback_;
    bool give_up_early_;
    bool interior_ready_ = false, fallback_ready_ = false, fallback_dense_ = false;
    double residual_ = 0;  // residual of scratch_ and state_
    BoxState state_;
    std::span<double> kept_, begun_, scratch_;
};

bool give_up(SolveReport& report)
{
    report.gave_up = true;
    return true;
}

bool solve_large(RowSystem& system, const ExactSettings& settings, bool pivot, Arena& arena,
                 SolveReport& report)
{
    {
        Arena::Scope scope(arena);
        DirectSolve direct(pivot);
        if (!direct.prepare(system, settings, arena)) return false;
        if (direct.run(system, arena, report)) return true;
        if (!arena.failed() && direct.gives_up()) {
            report.factorisations += direct.factorisations();
            return give_up(report);
        }
    }
    if (!pivot || arena.failed()) return false;
    const SmallResult result = solve_by_pivoting(system, settings, arena, report);
    if (result != SmallResult::kNotSolved) return result == SmallResult::kSolved;
    return solve_large(system, settings, false, arena, report);
}

bool solve_boxes(RowSystem& system, const ExactSettings& settings, Arena& arena, SolveReport& report)
{
    if (!system.terms.empty()) return solve_large(system, settings, false, arena, report);
    switch (solve_small(system, settings, arena, report)) {
        case SmallResult::kSolved:
            return true;
        case SmallResult::kNoMemory:
            return false;
        case SmallResult::kNotSolved:
            break;
    }
    if (settings.work && settings.work->exhausted()) return give_up(report);
    return solve_large(system, settings, can_pivot(system), arena, report);
}

bool solve_pieces(const RowSystem& whole, const ExactSettings& settings, Arena& arena, SolveReport& report)
{
    RowSystem system = whole;
    if (!cut_blocks(system, arena)) return false;
    return system.coulomb ? solve_coulomb(solve_boxes, system, settings, arena, report)
                          : solve_boxes(system, settings, arena, report);
}

// As its caller sees it.
void judge(const RowSystem& system, std::span<const SolverBody> before, SolveReport& report)
{
    const StoredResidual stored = stored_residual(system, before);
    report.residual = std::max(report.residual, Real(stored.worst));
    report.unsolved_joint = stored.worst_joint, report.unsolved_joints = stored.unsolved_joints;
}

}  // namespace

bool solve_exactly(RowSystem& system, const ExactSettings& settings, Arena& arena, SolveReport& report)
{
    if (system.rows.empty()) return true;
    Arena::Scope scope(arena);
    if (!settings.want_residual) return solve_pieces(system, settings, arena, report);
    const auto before = arena.take<SolverBody>(int(system.bodies.size()));
    if (arena.failed()) return false;
    std::copy(system.bodies.begin(), system.bodies.end(), before.begin());
    if (!solve_pieces(system, settings, arena, report)) return false;
    if (!report.gave_up) judge(system, before, report);
    return true;
}

}  // namespace epode
