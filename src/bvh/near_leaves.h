// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What one who asks a mesh's tree again and again keeps of it: the leaves that meet a box somewhat larger
// than his own (MeshTree::query). While his box stays in there, the tree need not be gone through; the leaves
// are looked at as ever, in the order of the tree, so that the answers are the same. An edition is one state
// of one tree and no other's: what is kept is never believed of a tree that has changed, or of another.
// To gather them takes longer than one question does. So they are when he is met again near where he was;
// of who jumps about, or is asked of two trees in turn, the place alone is kept.
#pragma once

#include <cstdint>

#include "bvh/mesh_node.h"

namespace epode {

struct NearLeaves {
    static constexpr int kCapacity = 15;
    static constexpr int kOnlyPlace = kCapacity + 2;

    std::uint64_t edition = 0;  // of the tree; 0: nothing is kept
    FloatBox box;               // in the tree's frame
    int count;  // kCapacity + 1: there are more than there is room for; kOnlyPlace: not gathered
    int leaf[kCapacity];

    bool knows(std::uint64_t of, const FloatBox& asked) const
    {
        if (edition != of) return false;
        bool in = true;
        for (int i = 0; i < 3; ++i) in = in && box.lo[i] <= asked.lo[i] && asked.hi[i] <= box.hi[i];
        return in;
    }
    // Of the same edition: whether they are worth gathering.
    bool is_near(std::uint64_t of, const FloatBox& asked) const
    {
        if (edition != of) return false;
        bool meet = true;
        for (int i = 0; i < 3; ++i) meet = meet && box.lo[i] <= asked.hi[i] && asked.lo[i] <= box.hi[i];
        return meet;
    }
};

}  // namespace epode
