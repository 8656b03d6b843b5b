// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The heights that functions of the program give, sampled before a world is saved: such a function may change
// anything, and a file must have the world as it is at one moment.
#pragma once

#include <span>

#include "base/array.h"
#include "collide/surfaces/heightfield.h"

namespace epode {

class HeightSamples {
  public:
    // Calls the field's function, if it has one and has not been sampled. False: out of memory.
    [[nodiscard]] bool take(const HeightfieldData& data);
    // By columns within rows; empty: they have not been sampled.
    std::span<const Real> of(const HeightfieldData& data) const;

  private:
    struct Field {
        const HeightfieldData* data;
        int first, count;
    };
    Array<Field> fields_;
    Array<Real> heights_;
};

}  // namespace epode
