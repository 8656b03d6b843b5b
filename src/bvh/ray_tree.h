// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A copy of a dynamic tree for rays: nodes of four children with their boxes as floats side by side, in two
// cache lines. It folds two levels of the dynamic tree into one (the larger of two children is opened first)
// and is valid until that tree changes; many rays between two changes pay for it. Boxes are relative to the
// centre of all boxes and larger than their contents by kPad of its extent, which is more than all rounding,
// because rays are first moved to where they enter the whole. So nothing is missed, and a caller that needs
// the exact box reads it from the leaf. Boxes beyond what floats can square are not taken, and rays whose own rounding,
// from where they begin, is more than that padding are not served: both are the dynamic tree's.
#pragma once

#include <cfloat>

#include "bvh/dynamic_tree.h"
#include "bvh/mesh_node.h"

namespace epode {

// Which of four children a ray meets (all bits of their lanes are set), and how far away.
struct MetNodes {
    mesh_lanes::Ints yes;
    mesh_lanes::Floats near;
};

// Sorts four, the nearest last and empty ones first. A sorting network without branches, because the
// comparisons cannot be predicted.
inline void far_first(WaitingNode* w)
{
    const auto order = [w](int i, int j) {
        const std::uint64_t a = w[i].key_, b = w[j].key_;
        w[i].key_ = a > b ? a : b;
        w[j].key_ = a > b ? b : a;
    };
    order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
}

// The children that are met, and empty entries for the others, also without branches. As a pair of numbers a key is
// a child and a distance, the low half first where the processor is little-endian.
inline void put_met(const MetNodes& met, const int* children, WaitingNode* w)
{
    using namespace mesh_lanes;
    static_assert(sizeof(WaitingNode) == 8);
    Ints child;
    __builtin_memcpy(&child, children, sizeof child);
    child &= met.yes;
    const Ints near = Ints(met.near) & met.yes;
    constexpr bool kLittle = std::endian::native == std::endian::little;
    const Ints first = kLittle ? child : near, second = kLittle ? near : child;
    const Ints low = __builtin_shufflevector(first, second, 0, 4, 1, 5),
               high = __builtin_shufflevector(first, second, 2, 6, 3, 7);
    __builtin_memcpy(static_cast<void*>(w), &low, sizeof low);
    __builtin_memcpy(static_cast<void*>(w + 2), &high, sizeof high);
}

// The number of set bits of four, as a table of digits.
inline int count_of_four(unsigned bits) { return int(0x4332322132212110u >> 4 * bits & 7); }

struct alignas(64) RayNode {
    float lo[3][4], hi[3][4];
    int child[4];     // a node, or ~item
    unsigned leaves;  // a bit for each child that is one

    RayNode();  // of children that no ray meets
    MetNodes met_by(const NodeRay& ray, float reach) const
    {
        using namespace mesh_lanes;
        Floats first = Floats{}, last = floats(reach);
        for (int i = 0; i < 3; ++i) {
            const Floats o = floats(ray.origin[i]), inverse = floats(ray.inverse[i]);
            Floats a, b;
            __builtin_memcpy(&a, ray.down[i] ? hi[i] : lo[i], sizeof a);
            __builtin_memcpy(&b, ray.down[i] ? lo[i] : hi[i], sizeof b);
            first = larger((a - o) * inverse, first);
            last = smaller((b - o) * inverse, last);
        }
        return {first <= last, first};
    }
};

class RayTree {
  public:
    // False when memory is exhausted, or boxes are too large: the tree is empty then.
    [[nodiscard]] bool build(const DynamicTree& tree);
    bool empty() const { return nodes_.empty(); }
    bool serves(const TreeRay& ray) const { return !empty() && ray.slack <= pad_; }
    void clear() { nodes_.clear(); }

    // Calls visit(item) for every leaf whose box the ray may meet, as DynamicTree::cast; before that
    // prefetch(item), which may prefetch what the visit needs.
    template <typename Visit, typename Prefetch>
    void cast(const TreeRay& ray, Vec3 direction, const Aabb& all, Real reach, Visit&& visit,
              Prefetch&& prefetch) const;

  private:
    static constexpr Real kPad = Real(0x1p-17), kLargest = Real(1e18);
    struct Fold {
        int from, to;  // a node of the dynamic tree and what becomes of it
    };
    void set_child(RayNode& node, int k, const Aabb& box, int child) const;

    Array<RayNode> nodes_;
    Array<Fold> folds_;  // while it is made
    Vec3 centre_;
    Real pad_ = 0;
};

// Were one met by a fault of floats, it would be the first item again, and never a node: walks end.
inline RayNode::RayNode() : lo{}, hi{}, child{~0, ~0, ~0, ~0}, leaves(0)
{
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 4; ++k) lo[i][k] = FLT_MAX, hi[i][k] = -FLT_MAX;
}

template <typename Visit, typename Prefetch>
void RayTree::cast(const TreeRay& ray, Vec3 direction, const Aabb& all, Real reach, Visit&& visit,
                   Prefetch&& prefetch) const
{
    const Real start = ray.enters(all, reach);
    if (!(start < kInf)) return;
    const NodeRay node_ray(ray.origin + start * direction - centre_, direction);
    const auto left = [&](Real until) { return float(until - start + pad_) * (1 + 0x1p-20f); };
    WaitingNode stack[3 * DynamicTree::kMaxHeight + 4];
    int top = 0;
    stack[top++] = WaitingNode(0, 0);
    float limit = left(reach);
    while (top > 0) {
        const WaitingNode next = stack[--top];
        if (next.near() > limit) continue;
        if (next.child() < 0) {
            reach = visit(~next.child());
            if (reach < 0) return;
            limit = left(reach);
            continue;
        }
        const RayNode& node = nodes_.data()[next.child()];
        const MetNodes children = node.met_by(node_ray, limit);
        const unsigned met = mesh_lanes::bits(children.yes);
        put_met(children, node.child, stack + top);
        for (unsigned soon = met & node.leaves; soon != 0; soon &= soon - 1)
            prefetch(~node.child[__builtin_ctz(soon)]);
        far_first(stack + top);
        top += count_of_four(met);
    }
}

}  // namespace epode
