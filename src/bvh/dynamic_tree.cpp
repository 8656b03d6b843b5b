// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A tree of n leaves has n - 1 inner nodes. Removal gives the parent of the leaf free and puts the sibling in
// its place; insertion takes one and puts it above the chosen sibling.
#include "bvh/dynamic_tree.h"

#include <algorithm>

namespace epode {
namespace {

// Half the surface.
Real area(const Aabb& box)
{
    const Vec3 s = box.hi - box.lo;
    return s.x * s.y + s.y * s.z + s.z * s.x;
}

Vec3 twice_centre(const Aabb& box) { return box.lo + box.hi; }

int longest_axis(Vec3 extent)
{
    int axis = extent.y > extent.x ? 1 : 0;
    if (extent.z > extent[axis]) axis = 2;
    return axis;
}

}  // namespace

int DynamicTree::take_node()
{
    if (free_ >= 0) {
        const int node = free_;
        free_ = nodes_[node].next_free;
        nodes_[node] = Node{};
        return node;
    }
    return nodes_.push(Node{}) ? nodes_.size() - 1 : -1;
}

void DynamicTree::give_node(int node)
{
    nodes_[node].next_free = free_;
    free_ = node;
}

int DynamicTree::insert(const Aabb& box, int item)
{
    const int leaf = insert_beside(root_ < 0 ? -1 : find_sibling(box), box, item);
    if (leaf >= 0) changed(leaf);
    return leaf;
}

int DynamicTree::insert_loose(const Aabb& box, int item)
{
    const int leaf = insert_beside(root_, box, item);
    if (leaf >= 0) sound_ = false;
    return leaf;
}

void DynamicTree::set_box(int leaf, const Aabb& box)
{
    nodes_[leaf].box = box;
    sound_ = false;
}

// Beside no node: as the root of an empty tree.
int DynamicTree::insert_beside(int sibling, const Aabb& box, int item)
{
    const int leaf = take_node();
    if (leaf < 0) return -1;
    nodes_[leaf].box = box;
    nodes_[leaf].item = item;
    if (sibling < 0) {
        root_ = leaf;
    } else {
        const int pair = take_node();
        if (pair < 0) {
            give_node(leaf);
            return -1;
        }
        attach(leaf, pair, sibling);
    }
    ++leaves_;
    return leaf;
}

void DynamicTree::remove(int leaf)
{
    const int pair = detach(leaf);
    if (pair >= 0) give_node(pair);
    give_node(leaf);
    --leaves_;
    ++changes_;
}

void DynamicTree::move(int leaf, const Aabb& box)
{
    const int pair = detach(leaf);
    nodes_[leaf].box = box;
    if (pair < 0)
        root_ = leaf;
    else
        attach(leaf, pair, find_sibling(box));
    changed(leaf);
}

void DynamicTree::clear()
{
    nodes_.clear();
    root_ = free_ = -1;
    leaves_ = changes_ = 0;
    sound_ = true;
}

// The node that a leaf with this box shall stand beside; the boxes on the way down are enlarged already.
int DynamicTree::find_sibling(const Aabb& box)
{
    int sibling = root_;
    while (nodes_[sibling].child >= 0) {
        Node& node = nodes_[sibling];
        node.box = merge(node.box, box);
        const Aabb &a = nodes_[node.child].box, &b = nodes_[node.other].box;
        const Real grow_a = area(merge(a, box)) - area(a), grow_b = area(merge(b, box)) - area(b);
        sibling = grow_a <= grow_b ? node.child : node.other;
    }
    return sibling;
}

// Puts `leaf` and `sibling` under the inner node `pair`, in the sibling's place.
void DynamicTree::attach(int leaf, int pair, int sibling)
{
    const int parent = nodes_[sibling].parent;
    Node& top = nodes_[pair];
    top.box = merge(nodes_[sibling].box, nodes_[leaf].box);
    top.parent = parent;
    top.child = sibling;
    top.other = leaf;
    nodes_[sibling].parent = nodes_[leaf].parent = pair;
    if (parent < 0)
        root_ = pair;
    else
        (nodes_[parent].child == sibling ? nodes_[parent].child : nodes_[parent].other) = pair;
}

// Takes the leaf out; the inner node that is free now, or -1 when the leaf was alone.
int DynamicTree::detach(int leaf)
{
    const int pair = nodes_[leaf].parent;
    nodes_[leaf].parent = -1;
    if (pair < 0) {
        root_ = -1;
        return -1;
    }
    const int sibling = nodes_[pair].child == leaf ? nodes_[pair].other : nodes_[pair].child;
    const int parent = nodes_[pair].parent;
    nodes_[sibling].parent = parent;
    if (parent < 0)
        root_ = sibling;
    else
        (nodes_[parent].child == pair ? nodes_[parent].child : nodes_[parent].other) = sibling;
    refit_above(sibling);
    return pair;
}

void DynamicTree::refit_above(int node)
{
    for (int i = nodes_[node].parent; i >= 0; i = nodes_[i].parent)
        nodes_[i].box = merge(nodes_[nodes_[i].child].box, nodes_[nodes_[i].other].box);
}

int DynamicTree::depth_of(int node) const
{
    int depth = 0;
    for (int i = nodes_[node].parent; i >= 0; i = nodes_[i].parent) ++depth;
    return depth;
}

void DynamicTree::changed(int leaf)
{
    const bool high = depth_of(leaf) >= kMaxHeight;
    if (++changes_ > 4 * leaves_ + 64 || high) sound_ = rebuild() || (sound_ && !high);
}

int DynamicTree::height() const
{
    int most = 0;
    for (int i = 0; i < nodes_.size(); ++i)
        if (i == root_ || nodes_[i].parent >= 0) most = std::max(most, depth_of(i));
    return most;
}

// The leaves are found by a walk along the child links, which also gathers the inner nodes for reuse: both
// lists live in `next_free`, so that only the array of leaves needs memory.
bool DynamicTree::rebuild()
{
    if (leaves_ < 2) return sound_ = true;
    order_.clear();
    if (!order_.reserve(leaves_)) return false;
    changes_ = 0;
    int spare = -1;
    int node = root_;
    int pending = -1;  // inner nodes whose second child waits
    for (;;) {
        if (nodes_[node].child >= 0) {
            nodes_[node].next_free = pending;
            pending = node;
            node = nodes_[node].child;
            continue;
        }
        (void)order_.push(node);
        if (pending < 0) break;
        const int inner = pending;
        pending = nodes_[inner].next_free;
        node = nodes_[inner].other;
        nodes_[inner].next_free = spare;
        spare = inner;
    }
    root_ = build(order_.data(), order_.size(), 0, spare);
    nodes_[root_].parent = -1;
    return sound_ = true;
}

int DynamicTree::build(int* first, int count, int depth, int& spare)
{
    if (count == 1) return first[0];
    const int node = spare;
    spare = nodes_[node].next_free;
    const int left = split(first, count, depth);
    const int a = build(first, left, depth + 1, spare);
    const int b = build(first + left, count - left, depth + 1, spare);
    Node& n = nodes_[node];
    n.box = merge(nodes_[a].box, nodes_[b].box);
    n.child = a;
    n.other = b;
    nodes_[a].parent = nodes_[b].parent = node;
    return node;
}

// Orders the leaves so that the first `result` of them form one side.
int DynamicTree::split(int* first, int count, int depth) const
{
    const Node* nodes = nodes_.data();
    Vec3 lo = twice_centre(nodes[first[0]].box), hi = lo;
    for (int i = 1; i < count; ++i) {
        const Vec3 c = twice_centre(nodes[first[i]].box);
        lo = min(lo, c);
        hi = max(hi, c);
    }
    const int axis = longest_axis(hi - lo);
    const Real middle = Real(0.5) * (lo[axis] + hi[axis]);
    auto key = [&](int leaf) { return twice_centre(nodes[leaf].box)[axis]; };
    int* cut = std::partition(first, first + count, [&](int leaf) { return key(leaf) < middle; });
    const int left = int(cut - first);
    // A lopsided cut is taken only near the root, which bounds the height.
    const int least = depth < 20 ? count / 16 + 1 : count / 2;
    if (left >= least && count - left >= least) return left;
    std::nth_element(first, first + count / 2, first + count, [&](int a, int b) {
        const Real ka = key(a), kb = key(b);
        return ka != kb ? ka < kb : a < b;
    });
    return count / 2;
}

}  // namespace epode
