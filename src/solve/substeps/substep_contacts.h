// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contact joints over the substeps of one step. Arms, directions and masses are those of the beginning; only
// the separation follows the motion, to first order: error -= hs J v. A separated (speculative) contact may
// close exactly (c = error/hs < 0), never earlier and never softly.
#pragma once

#include <span>

#include "solve/common/contact_rows.h"
#include "solve/common/substep_rows.h"
#include "solve/sweeps/contact_set.h"
#include "solve/sweeps/row_sweep.h"

namespace epode {

// A normal row, T = Real or Lanes. Index 0: correcting, 1: relaxing.
template <typename T>
struct NormalAim {
    T error, speed, cap;
    T rate[2], max_bias_velocity;
    T effective_mass[2], C[2];
    T rigid_mass;  // 1/d: effective mass of a speculative contact
};

class SubstepContacts {
  public:
    // `system.numbers` hold bounds and warm start of one substep; c and C are set here. False: out of memory.
    bool prepare(RowSystem& system, const Substep& step, std::uint64_t seed, Arena& arena);

    void apply_impulses(std::span<Velocity> bodies) const;
    void sweep(std::span<Velocity> bodies, bool relax);
    void follow_motion(std::span<const Velocity> bodies);  // error -= hs J v
    void add_impulses(std::span<RowNumbers> numbers);      // numbers.p += p
    // Restitution velocities are those of the energy at the beginning of the step. A body approaches with u,
    // moves out of a contact by s while it touches, and a substep of forces adds d = hs a to u: what leads
    // back to where it came from is
    //
    //   w = d/2 + sqrt((u + d/2)^2 - 2 a s)        (ManifoldSet::expect_impacts)
    //
    // expect_rebounds, before the first substep, with the velocities now and what forces add to them in one;
    // false: out of memory. correct_rebounds, after the last, writes the rows.
    bool may_rebound(const RowSystem& system) const;
    bool expect_rebounds(const RowSystem& system, std::span<const Velocity> now,
                         std::span<const Velocity> by_forces, Arena& arena);
    void correct_rebounds(RowSystem& system);
    // The problem that the last correcting sweep worked on, into c, C and p: for the residual.
    void describe(std::span<RowNumbers> numbers);
    std::span<ManifoldFriction> manifold_frictions(Arena& arena) const
    {
        return set_.manifold_frictions(arena);
    }

  private:
    struct Fall {
        int row;
        Real u, d;
    };

    void aim(const RowSystem& system, const Substep& step);

    // Calls f(row of the normal, point of the set, its lane).
    template <typename Visit>
    void for_each_lane(Visit&& f) const;

    ContactRows rows_;
    ContactSet set_;
    RowSweep others_;
    std::span<NormalAim<Lanes>> aims_;       // per point of the set
    std::span<NormalAim<Real>> other_aims_;  // per block of the others
    std::span<Fall> falls_;                  // of rows that may rebound, by row
    Real hs_ = 0;
    CounterRandom random_{0};
};

}  // namespace epode
