// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contacts that a step has struck. Their impulses ended an approach and say nothing of what the bodies
// weigh; as the beginning of the next step they would throw the bodies, and their friction would hold what
// leaves: with much friction a box that had landed gained a tenth of its energy. A contact with the effective
// mass m of its normal that began the step with the normal velocity u was struck if
//
//   sum of min(p, max(0, -m u)) > kBlowShare sum of p        over the points of its manifold
//
// What rests begins with a velocity near zero and carries g h in a step. Friction without end may strike, too, in
// a single point of the world: where it exceeds the normal impulse, the part of it that ended a slip counts. (It
// turned a rod into the floor, which had no more than a tenth of its normal impulse from its approach; the rod
// gained 6 % in the next step.) What slides on has ended no slip. Here for contact joints; contacts of the world by
// solve/substeps/manifold_math.inc.
#pragma once

#include "step/island/problem/assemble.h"

namespace epode {

class Blows {
  public:
    // After the rows are written and before anything moves. False: out of memory.
    bool begin(const RowSystem& system, Arena& arena);
    // With the impulses of the step. False without begin().
    bool struck(const RowSystem& system, const JointManifold& manifold) const;
    bool struck(const RowSystem& system, std::size_t block) const;

  private:
    std::span<Real> points_;  // -m u of each point of a manifold
    std::span<Real> blocks_;  // and of each block, 0 if it is no contact
};

}  // namespace epode
