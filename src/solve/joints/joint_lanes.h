// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The joints of an island, or of several that are solved together, in lanes of floats or of Reals. Float
// lanes take half the time and half the memory. Their changes are added to velocities that stay Reals, and
// positions, which are far from the bodies, reach them as differences of Reals. An island has lanes of Reals
// where digits could show:
//
// - masses of more than 1 : 1000, as in solve/sweeps/quick_contacts.h;
// - arms so long compared with a body's radius of gyration that the block of a joint loses more than three
//   digits;
// - joints of free form, whose rows are unknown;
// - an island that is not attached to or standing on anything, whose momentum is kept to rounding of a Real;
// - numbers out of the range of floats;
//
// and all islands of a system have lanes of Reals if there are few joints, which converge fully, or more
// sweeps than are worthwhile otherwise, by which a program asks for more digits.
#pragma once

#include "solve/joints/joint_set.h"
#include "solve/joints/wide_rows.h"

namespace epode {

class JointLanes {
  public:
    // Order of a pass in substeps: contacts come first when errors are corrected, last when they are relaxed.
    static constexpr bool kHasBothEnds = false;

    // `sweeps`: the number of sweeps to come.
    explicit JointLanes(int sweeps) : sweeps_(sweeps) {}

    // As in JointSet.
    bool pack(const RowSystem& system, Arena& arena);
    void load(const RowSystem& system);
    bool follow(const RowSystem& system, const Substep& step, std::span<const Velocity> bodies, Arena& arena);
    void turn(const RowSystem& system) { floats_.turn(system), reals_.turn(system); }
    void load_substep(const RowSystem& system, const Substep& step);
    void apply_impulses(std::span<Velocity> bodies) const;
    void sweep(std::span<Velocity> bodies, const JointSweep& how);
    void store_impulses(std::span<RowNumbers> numbers) const;
    void sum_impulses();
    void store_sums(std::span<RowNumbers> numbers) const;
    void describe(std::span<RowNumbers> numbers, std::span<Row> rows) const;
    void apply_restitution(const RowSystem& system, std::span<Velocity> bodies);

    bool in_floats() const { return reals_.empty() && wide_.empty(); }  // all of them
    // Sweeps velocities in floats.
    void sweep(std::span<FloatVelocity> bodies, const JointSweep& how) { floats_.sweep(bodies, how); }

  private:
    bool part_fits_floats(const RowSystem& system, int part) const;

    int sweeps_;
    JointSet reals_;
    FloatJointSet floats_;
    WideRows wide_;  // of couplings, visited last
};

}  // namespace epode
