// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The angular momentum of an island that nothing outside of it holds, kept while its poses are projected.
//
// Where a step is too long for SHAKE (step/island/positions/shake.h) bodies fly h v along the tangent and are drawn back by poses alone: their
// arms change, and velocities do not. A pair that tumbles at 20 rad/s in steps of 1/60 s lost half of its angular momentum in 5 s. Forces
// of joints cannot do that, so the island turns as a whole by
//
//   dw = J^-1 (L - L'),  v += dw x (x - c),  w += dw,   J its inertia about its centre c
//
// which joints allow in every pose. The energy of a rigid turn is then what it was: of the velocity h v brought the bodies here with, the next
// step takes the part along the arms, and dw has made up for it.
#pragma once

#include "step/island/problem/assemble.h"

namespace epode {

class FreeMomentum {
  public:
    explicit FreeMomentum(const IslandWork& work);  // before poses change
    void restore() const;                           // and after

  private:
    const IslandWork& work_;
    const bool free_;
    const Vec3 L_;
};

}  // namespace epode
