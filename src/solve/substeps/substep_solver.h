// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The velocity problem of one substep, solved twice: at the poses where it begins and, without the correction of
// position errors, at those where it ends (TGS; Macklin, Storey et al., "Small Steps in Physics Simulation", 2019):
//
//   v += M^-1 J^T p                           the impulses of the substep before (warm start)
//   correct: contacts, then joints as blocks  J v + C p = c, correcting position errors
//   relax:   joints, then contacts            without it: removes the velocity that the correction added
//
// Who calls it moves the bodies (step/steppers/substep_loop.h). After the last substep, what approached fast and carried load
// rebounds (impacts/restitution.h). The impulse of a step is the sum over its substeps; the next step starts from its n-th part.
// The reported residual is that of the last substep after its correcting solve, because for the whole step no single problem
// exists. Contact manifolds are solved in float lanes in the same passes; their rows are not judged, but v* contains
// what their impulses have done to the bodies.
//
// Joints are lanes that are swept (JointLanes), or all of an island one block that is solved exactly (JointNetwork),
// before and after the contacts of each pass: an articulated body in a pile keeps its joints together, and only contacts iterate.
#pragma once

#include "solve/joints/joint_lanes.h"
#include "solve/solver.h"
#include "solve/substeps/joint_network.h"
#include "solve/substeps/manifold_set.h"
#include "solve/substeps/substep_contacts.h"

namespace epode {

struct SubstepSettings {
    std::uint64_t seed = 0;               // a function of world, step and island: for shuffles
    bool want_residual = false;           // costs an evaluation
    std::span<Real> part_residuals = {};  // also of each part of a system of several
    Tasks tasks{};
};

// `Joints`: JointLanes or JointNetwork. Functions that return a bool: false, out of memory.
template <typename Joints>
class SubstepSolver {
  public:
    SubstepSolver(RowSystem& system, int substeps, Joints& joints)
        : system_(system), step_{system.h / Real(substeps), substeps}, joints_(joints)
    {}

    // Converts the numbers of the whole step to those of a substep, and packs everything. Velocities are those before any force.
    bool prepare(const SubstepSettings& settings, Arena& arena);
    // May something rebound? Then, before the first substep: `pushed`, the velocities after the forces of one substep.
    bool may_rebound() const { return contacts_.may_rebound(system_) || manifolds_.may_rebound(); }
    bool expect_rebounds(std::span<Velocity> pushed, Arena& arena);
    // The last that is called before the first substep.
    void begin();

    const Substep& step() const { return step_; }
    // Of the bodies and the worlds.
    std::span<Velocity> velocities() const { return velocities_; }

    // Is the residual of the last substep wanted? Then, after its forces and with inertias at its poses, what it begins with.
    bool judges() const { return !before_.empty(); }
    void begin_judged();
    // Solves the substep with the rows and inertias of the system.
    void correct();
    // After the last correct() that begin_judged() preceded.
    bool judge(SolveReport& report, Arena& arena);
    // The bodies are about to move for hs.
    void follow_motion();
    // They have.
    void turn() { joints_.turn(system_); }
    void relax();
    // The substep ends: its impulses are added to those of the step.
    void end(bool last);

    // Into the system: impulses and velocities of the step.
    void store();
    // With the bodies where they are then: what contacts have exerted.
    void add_contact_wrenches();
    // Impulses of manifolds, and restitution.
    bool finish(Arena& arena);

  private:
    bool take_scratch(Arena& arena);
    bool hangs(int part) const;
    void add_joint_wrenches();
    void add_wrench(const RowBlock& block, int i, const Row& row, Real p);

    RowSystem& system_;
    const Substep step_;
    Joints& joints_;
    SubstepContacts contacts_;
    ManifoldSet manifolds_;
    std::span<Velocity> velocities_;
    std::span<Real> part_residuals_;
    std::span<SolverBody> before_;  // only when the residual is wanted
    std::span<RowNumbers> described_;
    std::span<Row> rows_;
    std::span<Real> summed_;  // impulses of the substep that the wrenches contain
    std::span<Real> lo_, hi_;
};

extern template class SubstepSolver<JointLanes>;
extern template class SubstepSolver<JointNetwork>;

}  // namespace epode
