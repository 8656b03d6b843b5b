// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where the joints of a rope lie at first: on a line, or where the rope is longer than the way, on an arc, the
// polygon of n equal links l that turn by t from one to the next:
//   chord  d = l sin(n t / 2) / sin(t / 2),  0 <= t <= 2 pi / n
// Gravity makes a catenary of it; an arc has a closed form for any way, also straight down.
#pragma once

#include "math/vec.h"

namespace epode {

class RopeShape {
  public:
    // `length` is at least |to - from|; `down` is a unit vector.
    RopeShape(Vec3 from, Vec3 to, int links, Real length, Vec3 down);

    Real link() const { return link_; }
    Vec3 direction(int i) const;             // of a link, unit
    Vec3 across() const { return across_; }  // unit, level, at right angles to all links

  private:
    int links_;
    Real link_, turn_ = 0;
    Vec3 along_, up_, across_;
};

}  // namespace epode
