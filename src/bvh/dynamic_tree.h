// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A binary tree of boxes for objects that are created, move and are removed. Each leaf holds the client's box
// and number; each inner node holds the union of its children. A leaf is inserted next to the node whose
// surface grows least on the way down (Goldsmith and Salmon 1987, greedy). For many changes at once a rebuild
// from the top is cheaper (split in the middle of the longest axis). Rotations, the usual repair after single
// changes, are left out: after 4 times as many changes as it has leaves, or when it is too high for the stack
// of a walk, the tree is rebuilt. Boxes must be ordered and finite (bounded()), or their areas would not be
// numbers.
#pragma once

#include <cmath>
#include <utility>

#include "base/array.h"
#include "base/prefetch.h"
#include "geometry/shapes.h"
#include "tasks/tasks.h"

namespace epode {

// A box that the tree can hold: squares of its sides are far from overflow, in float too.
constexpr bool bounded(const Aabb& box)
{
    constexpr Real reach = Real(1e15);
    return box.lo.x >= -reach && box.lo.y >= -reach && box.lo.z >= -reach && box.hi.x <= reach &&
           box.hi.y <= reach && box.hi.z <= reach && box.lo.x <= box.hi.x && box.lo.y <= box.hi.y &&
           box.lo.z <= box.hi.z;
}

constexpr Aabb merge(const Aabb& a, const Aabb& b) { return {min(a.lo, b.lo), max(a.hi, b.hi)}; }

constexpr bool contains(const Aabb& outer, const Aabb& inner)
{
    return outer.lo.x <= inner.lo.x && outer.lo.y <= inner.lo.y && outer.lo.z <= inner.lo.z &&
           outer.hi.x >= inner.hi.x && outer.hi.y >= inner.hi.y && outer.hi.z >= inner.hi.z;
}

// A ray prepared for tests against boxes inside `all`. `slack` widens each box by more than its rounding, so
// that nothing is missed. Components of the direction that are next to zero are replaced by a tiny number.
struct TreeRay {
    TreeRay(Vec3 o, Vec3 d, const Aabb& all)
        : origin(o), slack(16 * kEpsilon * max_component(max(abs(o), max(abs(all.lo), abs(all.hi)))))
    {
        constexpr Real limit = kSingle ? Real(1e30) : Real(1e290);
        for (int i = 0; i < 3; ++i) inverse.set(i, std::fabs(d[i]) * limit > 1 ? 1 / d[i] : limit);
    }
    // The distance at which the ray enters the box, or kInf if that is beyond `reach`.
    Real enters(const Aabb& box, Real reach) const
    {
        Real near = 0, far = reach;
        for (int i = 0; i < 3; ++i) {
            const Real a = (box.lo[i] - origin[i] - slack) * inverse[i];
            const Real b = (box.hi[i] - origin[i] + slack) * inverse[i];
            const Real first = a < b ? a : b, last = a < b ? b : a;
            near = first > near ? first : near;
            far = last < far ? last : far;
        }
        return near <= far ? near : kInf;
    }
    Vec3 origin, inverse;
    Real slack;
};

// A piece of the walk over all pairs of leaves: leaves below a with leaves below b, or leaves below a with
// one another if b is negative.
struct NodePair {
    int a, b;
};

class DynamicTree {
  public:
    // The leaf's name, or -1 when memory is exhausted (nothing has changed then).
    int insert(const Aabb& box, int item);
    void remove(int leaf);
    void move(int leaf, const Aabb& box);

    // For many changes at once: leaves are inserted anywhere or get new boxes, and the tree must be settled
    // before the next query. If leaves have only moved, and mostly together, settling refits the inner boxes;
    // otherwise it rebuilds the tree. False when memory is exhausted.
    int insert_loose(const Aabb& box, int item);
    void set_box(int leaf, const Aabb& box);
    [[nodiscard]] bool settle(const Tasks& tasks = Tasks(1));
    [[nodiscard]] bool rebuild(const Tasks& tasks = Tasks(1));

    // True if the tree can be queried; otherwise settle() must be called first.
    bool sound() const { return sound_; }

    const Aabb& box(int leaf) const { return nodes_[leaf].box; }
    void set_item(int leaf, int item) { nodes_[leaf].item = item; }
    int leaf_count() const { return leaves_; }
    int height() const;
    void clear();

    // Calls visit(item) for every leaf whose box overlaps `box`, in no promised order.
    template <typename Visit>
    void query(const Aabb& box, Visit&& visit) const
    {
        if (root_ < 0 || !overlap(nodes_.data()[root_].box, box)) return;
        int stack[kMaxHeight + 2];
        int top = 0;
        stack[top++] = root_;
        // Nodes on the stack have been tested, and the memory that they lead to is being prefetched.
        const auto look = [&](int at) {
            const Node& node = nodes_.data()[at];
            if (!meet(node.box, box)) return;
            if (node.child >= 0)
                prefetch<1>(nodes_.data() + node.child), prefetch<1>(nodes_.data() + node.other);
            stack[top++] = at;
        };
        while (top > 0) {
            const Node& node = nodes_.data()[stack[--top]];
            if (node.child < 0) {
                visit(node.item);
            } else {
                look(node.other);
                look(node.child);
            }
        }
    }

    // Calls visit(item) for every leaf whose box the ray meets, mostly the near ones first. visit returns how
    // far the ray must still be followed; a negative value ends the walk.
    template <typename Visit>
    void cast(const TreeRay& ray, Real reach, Visit&& visit) const
    {
        if (root_ < 0) return;
        struct Waiting {
            int node;
            Real near;
        } stack[kMaxHeight + 2];
        int top = 0;
        const Real first = ray.enters(nodes_.data()[root_].box, reach);
        if (first < kInf) stack[top++] = {root_, first};
        while (top > 0) {
            const Waiting next = stack[--top];
            if (next.near > reach) continue;
            const Node& node = nodes_.data()[next.node];
            if (node.child < 0) {
                reach = visit(node.item);
                continue;
            }
            Waiting a = {node.child, ray.enters(nodes_.data()[node.child].box, reach)};
            Waiting b = {node.other, ray.enters(nodes_.data()[node.other].box, reach)};
            if (a.near < b.near) std::swap(a, b);
            if (a.near < kInf) stack[top++] = a;
            if (b.near < kInf) stack[top++] = b;
        }
    }

    // The union of all leaves' boxes; the tree must not be empty.
    const Aabb& bounds() const { return nodes_.data()[root_].box; }

    // For copies of the tree; box() serves inner nodes too.
    static constexpr int kMaxHeight = 60;
    int root() const { return root_; }
    bool is_leaf(int node) const { return nodes_.data()[node].child < 0; }
    int child(int node) const { return nodes_.data()[node].child; }
    int other(int node) const { return nodes_.data()[node].other; }
    int item(int leaf) const { return nodes_.data()[leaf].item; }

    // Finds every pair of leaves whose boxes overlap, each once, by a walk over all pairs of nodes. With many
    // leaves this is several times faster than a query for each leaf, because common ancestors are compared
    // once. split_pairs() opens the upper nodes until there are about `wanted` pieces of the walk or nothing
    // is left to open; false when memory is exhausted. query_pairs() calls visit(item, item) for the pairs of
    // one piece.
    [[nodiscard]] bool split_pairs(int wanted, Array<NodePair>& pieces) const;
    template <typename Visit>
    void query_pairs(const NodePair& piece, Visit&& visit) const
    {
        if (piece.b < 0)
            pairs_within(piece.a, visit);
        else if (meet(piece.a, piece.b))
            pairs_between(piece.a, piece.b, visit);
    }

  private:
    struct Node {
        Aabb box;
        int parent = -1;
        int child = -1;  // -1: a leaf
        union {
            int other = -1;  // second child
            int item;        // of a leaf
        };
        int next_free = -1;
    };

    template <typename Visit>
    void pairs_within(int top, Visit& visit) const
    {
        const Node& node = nodes_.data()[top];
        if (node.child < 0) return;
        pairs_within(node.child, visit);
        pairs_within(node.other, visit);
        if (meet(node.child, node.other)) pairs_between(node.child, node.other, visit);
    }

    // For nodes that overlap.
    template <typename Visit>
    void pairs_between(int a, int b, Visit& visit) const
    {
        const Node &na = nodes_.data()[a], &nb = nodes_.data()[b];
        if (na.child < 0 && nb.child < 0) {
            visit(na.item, nb.item);
        } else if (opens_first(na, nb)) {
            prefetch<1>(nodes_.data() + na.other);
            if (meet(na.child, b)) pairs_between(na.child, b, visit);
            if (meet(na.other, b)) pairs_between(na.other, b, visit);
        } else {
            prefetch<1>(nodes_.data() + nb.other);
            if (meet(a, nb.child)) pairs_between(a, nb.child, visit);
            if (meet(a, nb.other)) pairs_between(a, nb.other, visit);
        }
    }
    bool meet(int a, int b) const { return meet(nodes_.data()[a].box, nodes_.data()[b].box); }
    // overlap() with all six comparisons and no branch between them: half of the tests succeed, in an order
    // that no processor can predict.
    static bool meet(const Aabb& p, const Aabb& q)
    {
        const bool x = (p.lo.x <= q.hi.x) & (q.lo.x <= p.hi.x), y = (p.lo.y <= q.hi.y) & (q.lo.y <= p.hi.y),
                   z = (p.lo.z <= q.hi.z) & (q.lo.z <= p.hi.z);
        return x & y & z;
    }
    // The larger of two nodes, at least one of which is an inner node.
    static bool opens_first(const Node& a, const Node& b)
    {
        return b.child < 0 || (a.child >= 0 && extent(a.box) >= extent(b.box));
    }
    [[nodiscard]] bool open_pair(int i, Array<NodePair>& pieces) const;
    static constexpr Real extent(const Aabb& box)
    {
        const Vec3 s = box.hi - box.lo;
        return s.x + s.y + s.z;
    }

    int take_node();
    void give_node(int node);
    void attach(int leaf, int pair, int sibling);
    int detach(int leaf);
    void refit_above(int node);
    bool refit();
    Real refit(int top);
    int depth_of(int node) const;
    int insert_as_sibling(int sibling, const Aabb& box, int item);
    int find_sibling(const Aabb& box);
    // Leaves `first` ... of order_, and the inner nodes that hold them: count - 1 of inner_.
    struct Branch {
        int first, count, depth, inner;
    };
    int top_of(const Branch& b) const
    {
        return b.count == 1 ? order_.data()[b.first] : inner_.data()[b.inner];
    }
    std::pair<Branch, Branch> cut(const Branch& branch);
    int join(const Branch& whole, int a, int b);
    int build(const Branch& branch);
    int build_in_pieces(const Branch& all, const Tasks& tasks);
    int split(int* first, int count, int depth) const;
    void changed(int leaf);

    Array<Node> nodes_;
    Array<int> order_, inner_;  // nodes during a rebuild; kept, so that a steady scene allocates nothing
    int root_ = -1;
    int free_ = -1;
    int leaves_ = 0;
    int changes_ = 0;    // since the last rebuild
    Real surface_ = -1;  // of the inner nodes, when they were refitted first after it; -1: not yet
    bool sound_ = true;
    bool loose_ = false;  // leaves have been put in anywhere
};

}  // namespace epode
