// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A node with 16 children, of the copy of a mesh's tree that is asked by box. As in a node of four
// (mesh_node.h) their boxes lie on a grid of 256 steps a side and the box that asks goes onto it; a bound of
// all 16 is one vector of bytes, so that they are told apart in no more work than four, and a walk passes
// through half as many nodes. Rays want distances, in floats, for which four are better.
#pragma once

#include "bvh/mesh_node.h"

namespace epode {

struct alignas(64) WideNode {
    static constexpr int kMost = 16;

    float origin[3], step[3];
    int count;  // of the children
    std::uint8_t lo[3][kMost], hi[3][kMost];
    int child[kMost];  // a wide node, or -1 - a packet of triangles

    unsigned met_by(const NodeBox& box) const;  // bits of the children met
};
static_assert(sizeof(WideNode) == 192);

inline unsigned WideNode::met_by(const NodeBox& box) const
{
    using namespace mesh_lanes;
    const BoxSteps on(origin, box);
    const Ints from = Ints(on.from), to = Ints(on.to);
    const Bytes met = (bytes_at(lo[0]) <= Bytes(__builtin_shufflevector(to, to, 0, 0, 0, 0))) &
                      (bytes_at(hi[0]) >= Bytes(__builtin_shufflevector(from, from, 0, 0, 0, 0))) &
                      (bytes_at(lo[1]) <= Bytes(__builtin_shufflevector(to, to, 1, 1, 1, 1))) &
                      (bytes_at(hi[1]) >= Bytes(__builtin_shufflevector(from, from, 1, 1, 1, 1))) &
                      (bytes_at(lo[2]) <= Bytes(__builtin_shufflevector(to, to, 2, 2, 2, 2))) &
                      (bytes_at(hi[2]) >= Bytes(__builtin_shufflevector(from, from, 2, 2, 2, 2)));
    return bits(met) & ((1u << count) - 1);
}

}  // namespace epode
