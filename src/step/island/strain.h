// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Finds islands whose joints the sweeps of substeps do not hold. Where masses, arms and inertias are too
// unequal, errors that sweeps leave feed on the impulses kept for the next substep: joints come apart, and
// energy comes from nothing. A step strains its island if both are seen,
//
//   gap    e/(r1 + r2 + k1 + k2) > 0.001   of a row that should hold a distance e at zero between bodies
//                                          with arms r and radii of gyration k, or an angle e > 0.001
//   gain   E1 - E0 > g (T + sum m |a| k)   with E the energy of motion and weight, T that of motion, a
//                                          gravity; g = 0.003, and 0.05 where more than weight and
//                                          joints acts: contacts, stops, motors, forces of the program
//
// Either alone is common in health: blows part joints, motors raise energy. Such an island takes exact joints
// in its next steps (step/steppers/hybrid.h); a false alarm costs time only.
//
// A structure of many joints may give way without a gain: what a sweep removes of an error that many joints
// share is small (step/island/problem/joint_memory.h), and where weight presses harder than that, a wall leans
// and falls as if of jelly. Its gaps are wide, and stay: steps note the largest, and an island with loops of
// joints whose gaps stay wide takes more substeps, until they have closed.
#pragma once

#include "step/common/island_method.h"
#include "step/island/problem/assemble.h"

namespace epode {

class StrainWatch {
  public:
    // After the rows are written and before anything moves. False: out of memory.
    bool begin(const World& world, const IslandWork& work, Arena& arena);
    // After the bodies have moved: notes strain and gap in the methods, one for each part.
    void end(const World& world, const IslandWork& work, std::span<IslandMethod> methods) const;

  private:
    // Of a part at the beginning.
    struct Before {
        Real gap = 0;
        bool driven = false;  // more than weight and joints acts
        double energy = 0;
    };
    static Before before(const World& world, const IslandWork& work, int part);

    std::span<Before> before_;
};

// After a step whose joints began with this gap.
void note_gap(HybridState& state, Real gap);
// So many times the substeps for an island whose gaps stay wide: 1, 2 or 4.
int substep_factor(const Island& island);

}  // namespace epode
