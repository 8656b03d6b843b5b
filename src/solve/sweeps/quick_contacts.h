// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contacts of dWorldQuickStep, in lanes of floats or of Reals. Float sweeps take half the time, and after
// twenty of them a pile is a thousand times further from its solution than their rounding. Lanes are Reals
// where digits could show:
//
// - few contacts, which converge fully;
// - more sweeps than are worthwhile otherwise, by which a program asks for more digits;
// - masses of more than 1 : 1000, since a velocity is as accurate as the largest impulse over the lightest
//   mass;
// - bodies that touch nothing static, whose momentum is kept to the rounding of a Real;
// - numbers out of the range of floats.
//
// All of this is a function of the island and the settings. The velocities themselves are Reals: float sweeps
// begin with them rounded and add their changes to them, once for all sweeps if joints are in floats too
// (solve/joints/joint_lanes.h).
#pragma once

#include "solve/solver.h"
#include "solve/sweeps/contact_set.h"

namespace epode {

class QuickContacts {
  public:
    // `alone`: no other code needs the Real velocities between begin() and end(). False: out of memory.
    bool pack(const RowSystem& system, const JointManifoldList& list, const SweepSettings& settings,
              bool alone, Arena& arena);

    void begin(std::span<Velocity> bodies);  // v += M^-1 J^T p
    void sweep(std::span<Velocity> bodies, CounterRandom& random);
    void relax_by(Real factor);
    void end(std::span<Velocity> bodies) const;
    void store_impulses(std::span<JointManifoldPoint> points) const;
    // The velocities between begin() and end(); empty if they stay where they are.
    std::span<FloatVelocity> floats() const
    {
        return in_floats_ && alone_ ? velocities_ : std::span<FloatVelocity>{};
    }
    std::span<ManifoldFriction> manifold_frictions(Arena& arena) const
    {
        return in_floats_ ? floats_.manifold_frictions(arena) : reals_.manifold_frictions(arena);
    }

  private:
    template <typename Change>
    void change(std::span<Velocity> bodies, Change&& change);

    const ContactKernels& machine_ = *contact_kernels().back();
    bool in_floats_ = false, alone_ = false;
    ContactSet reals_;
    FloatContactSet floats_;
    std::span<FloatVelocity> velocities_;
};

}  // namespace epode
