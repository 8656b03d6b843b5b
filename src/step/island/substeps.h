// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The model that a solver with inner steps drives: the bodies and joints of one island.
#pragma once

#include "base/arena.h"
#include "rows/row_system.h"
#include "solve/substeps/body_kernels.h"
#include "step/island/problem/assemble.h"
#include "step/island/prompt_forces.h"
#include "tasks/tasks.h"

namespace epode {

class SubstepModel {
  public:
    // `info` is that of the whole step. `tension`: inertias of the solver may be raised (step/island/positions/tension.h).
    // `borne`: of each body, or none; what is left of the program's force (step/island/prompt_forces.h).
    SubstepModel(IslandWork& work, const World& world, const StepInfo& info, bool tension,
                 std::span<const BorneForce> borne, const Tasks& tasks)
        : work_(work), world_(world), info_(info), tension_(tension), borne_(borne), tasks_(tasks)
    {
        info_.inner = true;  // joints keep the rows that they wrote at the beginning of the step
    }

    // Before the first call: bodies into lanes, and the system's poses. False: out of memory.
    bool prepare(Arena& arena);
    Substeps callbacks();

  private:
    std::span<Body* const> island_bodies() const { return work_.island.bodies; }
    template <typename F>
    void in_groups(F&& f) const;
    void load_body(std::size_t i, const Body& body, const SolverBody& solver);
    void turn_finitely(std::size_t group, const Velocity* bodies, Real h);

    static void apply_forces(void* model, Velocity* bodies, Real h);
    static void advance(void* model, RowSystem& system, Velocity* bodies, Real h);
    static void settle(void* model, RowSystem& system);
    static void refresh(void* model, RowSystem& system, const Velocity* bodies);
    static void gather_contacts(void* model, RowSystem& system);

    IslandWork& work_;
    const World& world_;
    StepInfo info_;
    bool tension_;
    std::span<const BorneForce> borne_;
    Tasks tasks_;
    const BodyKernels& kernels_ = *body_kernels().back();
    std::span<BodyLanes> lanes_;
};

// Lets a contact of two bodies act at one point of their present poses again: its arms are those of earlier
// ones, and half way between their ends lies the point that both bodies share.
void gather_contact(const Island& island, RowBlock& block, std::span<Row> rows);

}  // namespace epode
