// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Pairs of shapes with a contact of their own (MJCF's <pair>) as what geoms have. One of the two has a numbered material against the
// kind of the other one's material, which counts alone. Two that would not touch by their bits get one more: each shape that
// holds such pairs has a category of its own above MJCF's 32, which its partners collide with. The one with more pairs
// holds, so that a floor needs one category for all feet.
#pragma once

#include <map>

#include "robots/model.h"

namespace epode::robots {

struct PairRules {  // of one shape
    int kind = 0;
    unsigned long category = 0, collide = 0;    // beyond its own
    std::vector<std::array<int, 2>> materials;  // number, and the pair that says it
};

class PairMaterials {
  public:
    explicit PairMaterials(const RobotModel& model);
    // Null: no pair has it.
    const PairRules* of(const Shape& shape) const;
    // Pairs for which there were no more numbers or bits.
    int left_out() const { return left_out_; }

  private:
    std::map<const Shape*, PairRules> rules_;
    int left_out_ = 0;
};

// A shape that touches, by its name; null: none. link: whose it is.
const Shape* shape_named(const RobotModel& model, const std::string& name, int& link);
// The pair of two shapes; null: they have none.
const ShapePair* pair_of(const RobotModel& model, const Shape& one, const Shape& two);
// Whether a joint connects the links, what is fixed to them counted, or an exclusion keeps them apart, so that nothing of them touches.
bool are_kept_apart(const RobotModel& model, int one, int two);

}  // namespace epode::robots
