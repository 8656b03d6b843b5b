// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a solid keeps in itself of the mesh that it was collided with last (bvh/near_leaves.h): programs that
// call dCollide have no pair to keep it in. Contacts are the same bits with it and without. It comes with the
// first mesh that the geom meets, and goes with the geom. Several threads may collide one geom at once: who
// finds it taken, or no memory for it, asks the mesh's tree as if there were none.
#pragma once

#include "base/pool.h"
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
