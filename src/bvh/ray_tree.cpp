// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Folds a binary tree into one of four children. Nodes are numbered in the order in which their parents are
// created.
#include "bvh/ray_tree.h"

#include <algorithm>

namespace epode {
namespace {

Real extent_of(const Aabb& box)
{
    const Vec3 s = box.hi - box.lo;
    return s.x + s.y + s.z;
}

}  // namespace

void RayTree::set_child(RayNode& node, int k, const Aabb& box, int child) const
{
    for (int i = 0; i < 3; ++i) {
        node.lo[i][k] = float(box.lo[i] - centre_[i] - pad_);
        node.hi[i][k] = float(box.hi[i] - centre_[i] + pad_);
    }
    node.child[k] = child;
    if (child < 0) node.leaves |= 1u << k;
}

bool RayTree::build(const DynamicTree& tree)
{
    nodes_.clear();
    folds_.clear();
    if (tree.leaf_count() == 0) return false;
    const Aabb& all = tree.bounds();
    const Real size = max_component(max(abs(all.lo), abs(all.hi)));
    if (!(size < kLargest) || !nodes_.reserve(tree.leaf_count()) || !folds_.reserve(tree.leaf_count()))
        return false;
    const Vec3 half = Real(0.5) * (all.hi - all.lo);
    centre_ = all.lo + half;
    pad_ = kPad * max_component(half) + 32 * kEpsilon * size + (kSingle ? Real(1e-30) : Real(1e-36));
    (void)nodes_.push(RayNode{});
    if (tree.is_leaf(tree.root())) {
        set_child(nodes_[0], 0, all, ~tree.item(tree.root()));
        return true;
    }
    (void)folds_.push({tree.root(), 0});
    for (int f = 0; f < folds_.size(); ++f) {
        const Fold fold = folds_[f];
        int open[4] = {tree.child(fold.from), tree.other(fold.from)};
        int count = 2;
        while (count < 4) {
            int largest = -1;
            for (int k = 0; k < count; ++k)
                if (!tree.is_leaf(open[k]) &&
                    (largest < 0 || extent_of(tree.box(open[k])) > extent_of(tree.box(open[largest]))))
                    largest = k;
            if (largest < 0) break;
            const int opened = open[largest];
            open[largest] = tree.child(opened);
            open[count++] = tree.other(opened);
        }
        for (int k = 0; k < count; ++k) {
            int child = ~0;
            if (tree.is_leaf(open[k])) {
                child = ~tree.item(open[k]);
            } else {
                child = nodes_.size();
                (void)nodes_.push(RayNode{});
                (void)folds_.push({open[k], child});
            }
            set_child(nodes_[fold.to], k, tree.box(open[k]), child);
        }
    }
    return true;
}

}  // namespace epode
