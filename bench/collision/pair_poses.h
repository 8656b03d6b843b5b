// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Poses of two members of pairs that depend on seeds alone, not on a library's answers:
//   resting  the first stands upright on the second, turned about the vertical and moved a little, sunk in by
//            1 mm at most: what a solver sees most. On a ground it stands anywhere, its foot sunk in by up to
//            5 cm
//   tumbled  any rotation, centres 0.45 to 1 of the sum of the reaches apart: hits of all depths, and misses
//   apart    the same, 1.0 to 1.2: boxes that overlap without a touch, what a broad phase lets through
// A ray starts where the first solid would stand and points down (resting) or about at the other's middle.
#pragma once

#include <ode/ode.h>

#include <memory>
#include <string>
#include <vector>

#include "bench/collision/pair_shapes.h"

namespace epode::bench {

enum class Poses { kResting, kTumbled, kApart };
inline constexpr Poses kAllPoses[] = {Poses::kResting, Poses::kTumbled, Poses::kApart};

const char* name_of(Poses poses);

// A plane and a ground are always the second, a ray the first: true when the two had to be exchanged for
// that.
bool put_in_order(std::string& first, std::string& second);

// A geom for each pose, so that placing it is not timed, nor the first look at its rotation and box. What
// stays where it is made is there once.
class PosedPairs {
  public:
    // `first` and `second` are in order.
    PosedPairs(std::string first, std::string second);
    void add(Poses poses, int count);

    std::size_t size() const { return at_.size(); }
    dGeomID first(std::size_t i) const { return a_[i]->geom(); }
    dGeomID second(std::size_t i) const { return b_[at_[i]]->geom(); }

  private:
    const PairShape& next_second();

    std::string kinds_[2];
    std::vector<std::unique_ptr<PairShape>> a_, b_;
    std::vector<std::size_t> at_;  // of the second
};

}  // namespace epode::bench
