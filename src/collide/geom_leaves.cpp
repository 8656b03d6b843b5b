// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See geom_leaves.h. Of two threads that make them at once, one throws its own away.
#include "collide/geom_leaves.h"

#include <new>

#include "base/memory.h"

namespace epode {
namespace {

GeomLeaves* make_leaves(Geom& geom)
{
    void* memory = allocate(sizeof(GeomLeaves));
    if (!memory) return nullptr;
    GeomLeaves* made = new (memory) GeomLeaves;
    GeomLeaves* there = nullptr;
    if (geom.leaves.compare_exchange_strong(there, made, std::memory_order_acq_rel)) return made;
    release(made, sizeof(GeomLeaves));
    return there;
}

}  // namespace

GeomLeaves* take_leaves(Geom& geom)
{
    GeomLeaves* leaves = geom.leaves.load(std::memory_order_acquire);
    if (!leaves) leaves = make_leaves(geom);
    return leaves && leaves->lock.try_lock() ? leaves : nullptr;
}

void drop_leaves(Geom& geom)
{
    GeomLeaves* leaves = geom.leaves.exchange(nullptr, std::memory_order_relaxed);
    if (leaves) release(leaves, sizeof(GeomLeaves));
}

}  // namespace epode
