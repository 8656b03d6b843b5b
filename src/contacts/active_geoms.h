// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which members of a space a step looks at where most of the world sleeps: the geoms of active bodies, and
// those at rest to which something has happened. What is between two others stays as it is.
#pragma once

#include <span>

#include "base/array.h"
#include "collide/space.h"
#include "dynamics/world.h"

namespace epode {

class ActiveGeoms {
  public:
    // `since`: the disturbances of the space before this have been looked at. False: out of memory.
    [[nodiscard]] bool gather(const World& world, const Space& space, std::uint64_t since);

    std::span<const int> slots() const { return slots_.span(); }
    bool has(int slot) const { return listed_.data()[slot] != 0; }

  private:
    [[nodiscard]] bool add(int slot);
    void clear();

    Array<int> slots_;
    Array<std::uint8_t> listed_;  // by slot
};

}  // namespace epode
