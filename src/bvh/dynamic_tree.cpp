// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A tree of n leaves has n - 1 inner nodes. Removing a leaf frees its parent and puts the sibling in the
// parent's place; inserting a leaf takes a free inner node and puts it above the chosen sibling.
#include "bvh/dynamic_tree.h"

#include <algorithm>

namespace epode {
namespace {

// A tree whose inner boxes have grown to this many times their surface costs more to query than to rebuild.
constexpr Real kWorn = Real(1.15);

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
    const int leaf = insert_as_sibling(root_ < 0 ? -1 : find_sibling(box), box, item);
    if (leaf >= 0) changed(leaf);
    return leaf;
}

int DynamicTree::insert_loose(const Aabb& box, int item)
{
    const int leaf = insert_as_sibling(root_, box, item);
    if (leaf >= 0) sound_ = false, loose_ = true;
    return leaf;
}

void DynamicTree::set_box(int leaf, const Aabb& box)
{
    nodes_[leaf].box = box;
    sound_ = false;
}

// Without a sibling the leaf becomes the root of an empty tree.
int DynamicTree::insert_as_sibling(int sibling, const Aabb& box, int item)
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
    sound_ = true, loose_ = false;
    surface_ = -1;
}

// The node that becomes the sibling of a leaf with this box; the boxes on the way down are already enlarged.
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

// Removes the leaf. Returns the inner node that is free now, or -1 when the leaf was alone.
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
    for (int i = nodes_[node].parent; i >= 0; i = nodes_[i].parent) {
        const Aabb box = merge(nodes_[nodes_[i].child].box, nodes_[nodes_[i].other].box);
        if (box.lo == nodes_[i].box.lo && box.hi == nodes_[i].box.hi)
            return;  // all above are the unions of their children already
        nodes_[i].box = box;
    }
}

// Refits the inner nodes below `top` and returns their total surface, `top` included. Leaves are scattered in
// memory: all children's memory below a node is prefetched before anything waits for it.
Real DynamicTree::refit(int top)
{
    Node* nodes = nodes_.data();
    Node& node = nodes[top];
    if (node.child < 0) return 0;
    for (const int k : {node.child, node.other})
        if (nodes[k].child >= 0) prefetch<1>(nodes + nodes[k].child), prefetch<1>(nodes + nodes[k].other);
    const Real below = refit(node.child) + refit(node.other);
    node.box = merge(nodes[node.child].box, nodes[node.other].box);
    return below + area(node.box);
}

// False when the tree has degraded and must be rebuilt.
bool DynamicTree::refit()
{
    const Real surface = refit(root_);
    if (surface_ < 0) surface_ = surface;
    return surface <= kWorn * surface_;
}

bool DynamicTree::settle(const Tasks& tasks)
{
    if (!loose_ && leaves_ >= 2 && refit()) return sound_ = true;
    return rebuild(tasks);
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
    if ((++changes_ <= 4 * leaves_ + 64 && !high) || rebuild() || !high) return;
    sound_ = false, loose_ = true;
}

int DynamicTree::height() const
{
    int largest = 0;
    for (int i = 0; i < nodes_.size(); ++i)
        if (i == root_ || nodes_[i].parent >= 0) largest = std::max(largest, depth_of(i));
    return largest;
}

// Finds the leaves by a walk along the child links, which also collects the inner nodes for reuse.
bool DynamicTree::rebuild(const Tasks& tasks)
{
    if (leaves_ < 2) return loose_ = false, sound_ = true;
    order_.clear(), inner_.clear();
    if (!order_.reserve(leaves_) || !inner_.resize(leaves_ - 1)) return false;
    changes_ = 0, surface_ = -1, loose_ = false;
    int node = root_, spare = leaves_ - 1;
    int pending = -1;  // inner nodes whose second child waits, linked by `next_free`
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
        inner_[--spare] = inner;
    }
    const Branch all{0, leaves_, 0, 0};
    root_ = tasks.workers() > 1 ? build_in_pieces(all, tasks) : build(all);
    nodes_[root_].parent = -1;
    return sound_ = true;
}

std::pair<DynamicTree::Branch, DynamicTree::Branch> DynamicTree::cut(const Branch& b)
{
    const int left = split(order_.data() + b.first, b.count, b.depth);
    return {{b.first, left, b.depth + 1, b.inner + 1},
            {b.first + left, b.count - left, b.depth + 1, b.inner + left}};
}

// Joins two complete branches.
int DynamicTree::join(const Branch& whole, int a, int b)
{
    const int node = inner_.data()[whole.inner];
    Node* nodes = nodes_.data();
    nodes[node].box = merge(nodes[a].box, nodes[b].box);
    nodes[node].child = a;
    nodes[node].other = b;
    nodes[a].parent = nodes[b].parent = node;
    return node;
}

// The top node.
int DynamicTree::build(const Branch& branch)
{
    if (branch.count == 1) return order_.data()[branch.first];
    const auto [one, two] = cut(branch);
    const int a = build(one);
    return join(branch, a, build(two));
}

// Cuts the upper branches one after the other until there are enough for all workers; the tree is the same.
int DynamicTree::build_in_pieces(const Branch& all, const Tasks& tasks)
{
    constexpr int kPieces = 32;
    Branch cut_off[kPieces], whole[kPieces];
    std::pair<Branch, Branch> parts[kPieces];
    int pieces = 1, cuts = 0;
    cut_off[0] = all;
    for (bool grows = true; grows;) {
        grows = false;
        for (int i = 0, n = pieces; i < n && pieces < kPieces; ++i) {
            if (cut_off[i].count < 64) continue;
            whole[cuts] = cut_off[i];
            parts[cuts] = cut(cut_off[i]);
            cut_off[i] = parts[cuts].first, cut_off[pieces++] = parts[cuts].second;
            ++cuts, grows = true;
        }
    }
    tasks.for_each(pieces, [&](int i, int) { build(cut_off[i]); });
    while (cuts-- > 0) join(whole[cuts], top_of(parts[cuts].first), top_of(parts[cuts].second));
    return top_of(all);
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
    // An unbalanced cut is allowed only near the root, which bounds the height.
    const int least = depth < 20 ? count / 16 + 1 : count / 2;
    if (left >= least && count - left >= least) return left;
    std::nth_element(first, first + count / 2, first + count, [&](int a, int b) {
        const Real ka = key(a), kb = key(b);
        return ka != kb ? ka < kb : a < b;
    });
    return count / 2;
}

// Level by level, so that pieces are of about equal size.
bool DynamicTree::split_pairs(int wanted, Array<NodePair>& pieces) const
{
    pieces.clear();
    if (root_ < 0) return true;
    if (!pieces.push({root_, -1})) return false;
    for (int before = 0; before < pieces.size() && pieces.size() < wanted;) {
        before = pieces.size();
        for (int i = 0; i < before; ++i)
            if (!open_pair(i, pieces)) return false;
    }
    return true;
}

// Replaces the piece by the first of its parts; the others are appended.
bool DynamicTree::open_pair(int i, Array<NodePair>& pieces) const
{
    const auto [a, b] = pieces[i];
    const Node& na = nodes_.data()[a];
    if (b < 0) {
        if (na.child < 0) return true;
        pieces[i] = {na.child, na.other};
        return pieces.push({na.child, -1}) && pieces.push({na.other, -1});
    }
    const Node& nb = nodes_.data()[b];
    if (!overlap(na.box, nb.box) || (na.child < 0 && nb.child < 0)) return true;
    const bool first = opens_first(na, nb);
    pieces[i] = first ? NodePair{na.child, b} : NodePair{a, nb.child};
    return pieces.push(first ? NodePair{na.other, b} : NodePair{a, nb.other});
}

}  // namespace epode
