// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What substeps move: the bodies and joints of one island.
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

    // v += h M^-1 f with gravity, and gyroscopic torque where bodies turn as ODE turns them.
    void apply_forces(std::span<Velocity> bodies, Real h) const;
    // The same effect on the others (dynamics/exact_spin.h), once before each advance().
    void kick_spins(std::span<Velocity> bodies, Real h) const;
    // x += h v, and bodies rotate; angular velocities above a body's limit are cut. Updates the system's poses
    // and nothing else.
    void advance(std::span<Velocity> bodies, Real h) { advance(bodies, bodies, h); }
    // Along `motion`, where the bodies' velocities have become others.
    void advance(std::span<Velocity> motion, std::span<const Velocity> bodies, Real h);
    // Updates the bodies themselves and the inertia in the SolverBodies to the poses.
    void settle();
    // Settles everything and rewrites Jacobians and errors of the rows at the present pose and velocities,
    // except those that are followed and those of contacts. Numbers of rows, kinds and bounds do not change.
    void refresh(std::span<const Velocity> bodies);
    // After everything has settled: contact rows act at one point of the present pose again, so that impulses
    // conserve angular momentum.
    void gather_contacts();

  private:
    std::span<Body* const> island_bodies() const { return work_.island.bodies; }
    template <typename F>
    void in_groups(F&& f) const;
    void load_body(std::size_t i, Body& body, SolverBody& solver);
    bool begin_exact_turn(Body& body, SolverBody& solver, bool raised) const;
    template <typename F>
    void for_bits(std::size_t group, unsigned char bits, F&& f) const;
    void turn_few(std::size_t group, const Velocity* motion, const Velocity* bodies, Real h);
    void refresh_block(std::size_t k, std::span<const Velocity> bodies);

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
