// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Steps that are tried with more and more working memory until they are made. What is stepped is a `Scene`
// with world(), go() and hash(), the latter of all that can be read.
#pragma once

#include <cstdlib>

#include "heap.h"

namespace epode::memory {

// Blocks of working memory, as many as are left.
inline long blocks_left = 0;
inline void* take_block(dsizeint size) { return blocks_left-- > 0 ? std::malloc(size) : nullptr; }
inline void give_block(void* block, dsizeint) { std::free(block); }

inline void limit_blocks(dWorldID world)
{
    const dWorldStepMemoryFunctionsInfo functions = {sizeof functions, take_block, nullptr, give_block};
    dWorldSetStepMemoryManager(world, &functions);
}

// Tries the step; true when it was made.
template <typename Scene>
bool tried(Scene& scene)
{
    const std::uint64_t before = scene.hash();
    const int messages_before = messages();
    const bool made = scene.go();
    EXPECT_EQ(messages() - messages_before, made ? 0 : 1);
    if (!made) { EXPECT_EQ(scene.hash(), before) << "a refused step has changed something"; }
    return made;
}

// The step with blocks of the working memory that grow by `stride` bytes; how often it was refused.
// prepare(n) comes before the n-th trial.
template <typename Scene, typename Prepare>
int step_with_little(Scene& scene, int threads, unsigned first, unsigned stride, Prepare&& prepare)
{
    int refused = 0;
    for (unsigned size = first; size < 1u << 28; size += stride, ++refused) {
        const dWorldStepReserveInfo policy = {sizeof policy, 1, size};
        dWorldCleanupWorkingMemory(scene.world());
        dWorldSetStepMemoryReservationPolicy(scene.world(), &policy);
        blocks_left = threads;
        prepare(refused);
        if (tried(scene) || testing::Test::HasFailure()) return refused;
    }
    ADD_FAILURE() << "no memory is enough";
    return refused;
}

}  // namespace epode::memory
