// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One island under work, or several small ones that together fill the SIMD lanes, and what every stepper does with them: numbers
// before the solution, reports and shares of energy after it. A run reads and writes its own bodies, joints and contacts only, so
// islands may be stepped in any order and concurrently.
#pragma once

#include "dynamics/island.h"
#include "dynamics/world.h"
#include "solve/solver.h"
#include "step/common/contact_cache.h"
#include "step/common/island_method.h"
#include "step/common/runaway.h"
#include "step/common/undo.h"
#include "step/island/energy_ledger.h"
#include "step/island/problem/assemble.h"

namespace epode {

struct StepContext {
    World& world;
    const Stepper& stepper;
    Real h;
    int iterations;
    ContactCache& contacts;
    SymbolicCache& symbolic_cache;
    StepUndo& undo;
    Runaways& runaways;
    bool manages_contacts;            // the world has world-managed contacts
    std::span<IslandMethod> methods;  // by island; empty: all have this stepper, and nothing is noted
    // Solutions of the island that have diverged in this step: more than none start from no impulses.
    int diverged = 0;
    Real correction =
        1;  // share of the errors of positions that is corrected, once corrections have thrown bodies
};

// The context with another stepper.
StepContext with_stepper(const StepContext& context, const Stepper& stepper, int iterations);

struct IslandPlace {
    int index;          // of the group
    int draw;           // part of the random seed, whatever else has been grouped
    int first_contact;  // its first ticket in the contact cache: one per joint
    int first_island;   // index of the group's first island
};

// What is wanted: one for each island, or none.
struct IslandRecords {
    std::span<dIslandStepReport> reports;
    std::span<dEnergyLedger> ledgers;
};

// How an attempt at an island ended.
enum class Outcome {
    kMade,
    kRefused,   // the solution is not finite: nothing of it counts
    kGaveUp,    // it would have taken more work than it may: the method's fallback has its turn
    kNoMemory,  // the bodies may be half stepped, and the caller must restore them
};

// Consecutive islands as one.
Island joined(std::span<const Island> islands);

class IslandRun {
  public:
    // `may_try_again`: what diverges is solved in another way.
    IslandRun(const StepContext& step, std::span<const Island> members, IslandPlace at, bool tries_again,
              const Tasks& all_tasks, const IslandRecords& records, Arena& memory);

    // Writes the island's problem for a step of h, which is solved in so many substeps, and reports its errors. False: out of
    // memory.
    [[nodiscard]] bool begin(const ProblemForm& form, Real h, int substeps = 1);
    // Of bodies whose loads a step of h is too long for (positions/tension.h). False: out of memory.
    [[nodiscard]] bool raise_inertias(Real h, Real resolved);
    // So many times the iterations, for an island that settles.
    int settling_iterations(int factor) const;
    // Seed for a solver's order.
    std::uint64_t seed() const;

    // Is the solution finite? An island of parts is looked at part by part, later.
    bool is_sound() const;
    void report_solution();
    // Of a problem whose bodies began with the velocities after all forces.
    void report_raised() const;

    // Of each part that is sound; `relaxed`: the solver has removed the velocities that correct positions.
    void add_solution_to_ledger(bool relaxed);
    void add_forces_to_ledger();
    // Around changes of poses that are corrections.
    template <typename Change>
    void correct_poses(Change&& change)
    {
        if (ledger.wanted()) ledger.begin_correction();
        change();
        if (ledger.wanted()) ledger.end_correction();
    }

    bool has_parts() const { return !work.system.parts.empty(); }
    bool is_sound(int part) const;
    // Has the part nothing to solve?
    bool is_free(int part) const;
    std::span<Body* const> bodies_of(int part) const;
    std::span<IslandMethod> methods() const;  // of the members; none if nothing is noted

    const StepContext& context;
    World& world;
    const IslandPlace place;
    const bool may_try_again;
    const Tasks& tasks;
    Arena& arena;
    const std::span<dIslandStepReport> reports;
    IslandWork work;
    EnergyLedger ledger;
    SolveReport solved;
    std::span<Real> part_residuals;  // if reports are wanted
    // Parts that are to be solved again: with less correction, or, where this is 1, because they have diverged.
    struct Aside {
        bool is = false;
        Real correction = 1;
    };
    std::span<Aside> set_aside;
    Real correction_of_all = 1;  // of an attempt that is refused: below 1, the next one corrects less
    int raised = 0;              // bodies whose inertia is

  private:
    std::span<SolverBody> plain_;  // the bodies as they are, if reports are wanted
};

}  // namespace epode
