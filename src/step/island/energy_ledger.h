// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where the energy of a step goes (dEnergyLedger). For a step or substep from (v0, w0) to (v1, w1) at one pose,
//
//   M (v1 - v0) = h f + J^T p      =>      T1 - T0 = h f.vm + sum p_i u_i,     vm = (v0 + v1)/2,  u_i = J_i vm
//
// exactly: an impulse works along the mean of the velocities before and after. What bodies at rest exert on each
// other works nothing, then; with the mean of the velocities around the solution alone, which begins after
// gravity's kick, gravity and every contact of a stack would seem to exchange energy in each step. Which share
// p_i u_i is depends on the kind of row:
//
//   motor, drive, spring, soft row        drives
//   friction with surface speed s         p s: drives, the rest as below
//   stop, contact, no deeper than 0       impacts
//   rigid joint                           joints
//   of the last two, what the target c of error correction asks for:
//                                         p (u0' + u1')/2, u' = u between 0 and c: correction
//                                         (relaxed, without restitution: whatever opens a contact)
//   kinematic body K, of every row        -p J_K v_K: drives. Its own energy does not count
//
// Friction brakes, so of its slips s0 = u0 - s and s1 = u1 - s only what it opposes is `friction`,
//
//   (min(p s0, 0) + min(p s1, 0))/2,     p s summed over the directions of a contact or a joint
//
// Where p s0 > 0, friction has acted on a slip that arose within the step: an oblique blow turns the slip, and the
// normal impulse that does so works against friction. That work belongs to what made the slip: impacts, or joints
// for friction in axes. (The mean of the slips, which is what is left of them at the end, made friction seem to
// give energy: 11 J of 17 J in a fall.)
//
// Gravity works along the path, -(V1 - V0). Poses that change and leave the velocities alone (projection, bodies
// stopped on their way, the corrections that substeps relax) are corrections too: T + V after less before. The
// rest is the error of the integration: for a falling body h m g.(v0 - v1)/2; for a turning one the change of its
// inertia in the world's frame; in substeps also that Jacobians turn under the sum of their impulses.
#pragma once

#include "ode/report.h"
#include "solve/common/velocities.h"
#include "step/island/problem/assemble.h"

namespace epode {

struct BodyEnergy {
    double kinetic, potential;
};
// With the pose and velocity that it has; gravity that leaves a body alone gives it no potential energy.
BodyEnergy energy_of(const World& world, const Body& body);

class EnergyLedger {
  public:
    // `out`: one for each member; none: nobody wants the ledger, and nothing may be called but wanted().
    EnergyLedger(const World& world, std::span<const Island> members, std::span<dEnergyLedger> out)
        : world_(world),
          members_(members),
          bodies_(members.front().bodies.data(), members.back().bodies.data() + members.back().bodies.size()),
          out_(out)
    {}
    bool wanted() const { return !out_.empty(); }

    // The step begins. False: out of memory.
    [[nodiscard]] bool begin(Arena& arena);
    // A substep begins that the bodies themselves take part in.
    void load_motion();
    // The solution of a step or substep of h, before the bodies get its velocities. `relaxed`: the solver has
    // removed the velocities that correct positions.
    void add_solution(const IslandWork& work, int part, bool relaxed);
    // The work of the forces in a step of length h, by the velocities before it and those that the bodies have now.
    void add_forces(int part, Real h);
    // What a solver with n relaxed substeps has corrected: the way from the step's beginning to the present poses
    // without `ends`, the sum of the velocities at the end of each substep, times h/n.
    void add_relaxed_corrections(int part, std::span<const Velocity> ends, Real substep);
    // Around a change of poses that is a correction.
    void begin_correction();
    void end_correction();
    // No force has acted: the island is contained.
    void forget();
    // The step has ended, but for damping, which is added in advance.
    void end();

  private:
    struct Before {
        Vec3 x, v, w;
        Vec3 force, torque;  // of the program
    };
    std::size_t first_body(int part) const
    {
        return std::size_t(members_[std::size_t(part)].bodies.data() - bodies_.data());
    }
    void add_rows(const IslandWork& work, const RowBlock& block, bool relaxed, dEnergyLedger& to) const;
    void add_contacts(const IslandWork& work, const JointManifold& m, dEnergyLedger& to) const;
    void add_manifold(const IslandWork& work, const ContactManifold& m, dEnergyLedger& to) const;
    void add_rolling(std::span<const SolverBody> bodies, const ContactManifold& m, dEnergyLedger& to) const;
    double energy_of_member(std::size_t i) const;

    const World& world_;
    std::span<const Island> members_;
    std::span<Body* const> bodies_;  // of all members
    std::span<dEnergyLedger> out_;
    std::span<SolverBody> motion_;  // velocities at the beginning of the step or substep
    std::span<Before> before_;
};

// The step has taken bodies of the island back on their way since end().
void add_stop(const World& world, const Island& island, dEnergyLedger& ledger);

dEnergyLedger sum_of(std::span<const dEnergyLedger> islands);

}  // namespace epode
