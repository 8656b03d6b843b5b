// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A step of h as n exact steps of h/n with the contacts of its beginning (dWorldSetExactSubsteps).
#pragma once

#include "step/island/island_run.h"
#include "step/island/positions/projection.h"

namespace epode {

class ExactSubsteps {
  public:
    // `form`: of the problem of each.
    ExactSubsteps(IslandRun& run, const ProblemForm& form, int n)
        : run_(run),
          world_(run.world),
          island_(run.work.island),
          first_(run.work),
          form_(form),
          hs_(run.context.h / Real(n)),
          n_(n),
          ledger_(run.ledger),
          arena_(run.arena)
    {}

    Real substep() const { return hs_; }

    // Before anything is assembled: saves what undo() restores. False: out of memory.
    bool begin();
    // Converts the numbers of an island that has been assembled with substep() to those of a substep.
    void map(RowSystem& system) const;
    // Before the first is solved: the program's forces move what they can at once (step/island/prompt_forces.h).
    void kick(Real warm_share);
    // The run has been solved, with raised inertias or not (step/island/positions/tension.h): moves the bodies by it, then makes the other n - 1 substeps. Its contacts get
    // the impulses of the last substep. False: a solution that is not finite, or out of memory; undo() must
    // follow.
    bool run(const ExactSettings& settings, ProjectionReport& projected);
    void undo();

  private:
    struct Before {
        Vec3 v, w, force, torque;
        Vec3 moving_force, moving_torque;  // parts of the program's that have become a kick
    };
    struct Feedback {
        Vec3 f1, t1, f2, t2;
        bool any;
        Real drive[kMaxAxes];
        Real coupling;
    };

    bool throws(const IslandWork& work);  // has its solution, by what it corrects?
    bool next(const ExactSettings& settings, IslandWork& work, bool& raised);
    void load_forces();
    void restore_forces() const;
    void add_to_ledger(const IslandWork& work);  // before contacts follow the motion and change
    void carry_out(IslandWork& work, bool raised, const ExactSettings& settings);
    void add_feedback(const IslandWork& work);
    void store_feedback() const;

    IslandRun& run_;
    World& world_;
    const Island& island_;
    IslandWork& first_;  // the run's
    const ProblemForm form_;
    const Real hs_;
    const int n_;
    EnergyLedger& ledger_;
    Arena& arena_;
    std::span<Before> before_;
    std::span<Feedback> feedback_;  // parallel to the island's joints
};

}  // namespace epode
