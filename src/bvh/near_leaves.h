// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A cache for a caller that queries a mesh's tree again and again: the leaves that overlap a somewhat larger
// box (MeshTree::query). While the caller's box stays inside, the tree need not be walked. The leaves are
// visited in the order of the tree, so the results are the same. An edition identifies one state of one tree:
// a cache of another state or another tree is never used. Collecting the leaves takes longer than one query,
// so they are collected only when the caller is met again near its last place. For a caller that moves far or
// alternates between two trees, only the place is kept.
#pragma once

#include <cstdint>

#include "bvh/mesh_node.h"

namespace epode {

struct NearLeaves {
    static constexpr int kCapacity = 15;
    static constexpr int kOnlyPlace = kCapacity + 2;

    std::uint64_t edition = 0;  // of the tree; 0: nothing is kept
    FloatBox box;               // in the tree's frame
    int count;                  // kCapacity + 1: more than fit; kOnlyPlace: not collected
    int leaf[kCapacity];

    bool knows(std::uint64_t of, const FloatBox& query_box) const
    {
        if (edition != of) return false;
        bool in = true;
        for (int i = 0; i < 3; ++i) in = in && box.lo[i] <= query_box.lo[i] && query_box.hi[i] <= box.hi[i];
        return in;
    }
    // For the same edition: true if collecting the leaves is worth it.
    bool is_near(std::uint64_t of, const FloatBox& query_box) const
    {
        if (edition != of) return false;
        bool meet = true;
        for (int i = 0; i < 3; ++i)
            meet = meet && box.lo[i] <= query_box.hi[i] && query_box.lo[i] <= box.hi[i];
        return meet;
    }
};

}  // namespace epode
