// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A direction that separates two convex geoms. Most pairs of a pile are near and do not touch: to see that
// along a direction that is known from the step before takes two support points, a tenth of what their collision
// takes, and what it answers is the same. With n from g2 to g1, of length 1, and h the support functions,
//   gap(n) = n . (p1 - p2) - h1(-n) - h2(n)
// is a lower bound of their distance, whatever n is. After a step that only turns and moves them it is at
// least gap(n) + h n . (v1 - v2) less what they turn by times how far they reach; or, with the support
// functions in the directions that turned bodies see, less half the square of the turn times the reach.
#pragma once

#include <cstdint>

#include "contacts/ahead/speculative_motion.h"

namespace epode {

// A unit vector in 32 bits, to about 1/30000 (on an octahedron: Meyer et al. 2010); 0: none.
std::uint32_t pack_direction(Vec3 n);
Vec3 unpack_direction(std::uint32_t code);

class PairSeparation {
  public:
    // Of two solids (collide/solid_type.h).
    PairSeparation(const Geom& g1, const Geom& g2);

    // A direction that separates them at these poses, in the world; zero: none has been found.
    Vec3 find(const Pose& pose1, const Pose& pose2, Vec3 guess) const;
    Real gap(const Pose& pose1, const Pose& pose2, Vec3 n) const;
    // Whether they are apart along n at the end of the step too, `gap` being the present one.
    bool lasts(const Pose& pose1, const Pose& pose2, Vec3 n, Real gap, const SpeculativeMotion& soon,
               const Body* body1, const Body* body2) const;
    // What may be rounding, of a gap.
    Real hair() const { return hair_; }

  private:
    const Geom &g1_, &g2_;
    Real size1_, size2_;  // farthest points of the cores from their places
    Real rounding_;       // sum
    Real hair_;
};

}  // namespace epode
