// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The cached leaves of the mesh that a solid was last collided with (bvh/near_leaves.h), stored in the solid:
// programs that call dCollide have no pair to store them in. Contacts have the same bits with and without
// them. They are created with the first mesh that the geom collides with and removed with the geom. Several
// threads may collide one geom at once: a thread that finds the leaves in use, or has no memory for them,
// queries the mesh's tree without them.
#pragma once

#include "base/objects/pool.h"
#include "bvh/near_leaves.h"
#include "collide/geom.h"

namespace epode {

struct GeomLeaves {
    NearLeaves leaves;
    SpinLock lock;
};

// Those of the geom, or null while another has them.
GeomLeaves* take_leaves(Geom& geom);
void drop_leaves(Geom& geom);

class GeomLeavesHold {
  public:
    explicit GeomLeavesHold(Geom& geom) : held_(take_leaves(geom)) {}
    GeomLeavesHold(const GeomLeavesHold&) = delete;
    GeomLeavesHold& operator=(const GeomLeavesHold&) = delete;
    ~GeomLeavesHold()
    {
        if (held_) held_->lock.unlock();
    }
    NearLeaves* leaves() const { return held_ ? &held_->leaves : nullptr; }

  private:
    GeomLeaves* const held_;
};

}  // namespace epode
