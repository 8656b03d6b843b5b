// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Approximate minimum degree on a quotient graph (Amestoy, Davis & Duff, SIAM J. Matrix Anal. Appl. 17,
// 1996). Eliminating body p turns its neighbours into a clique; the clique is not written out but stored as
// one "element" p with the list L_p of its members. A body i then has two lists, bodies A_i and elements E_i,
// and its neighbours are A_i joined with L_e for e in E_i. What keeps the method near linear:
//
//   L_p = A_p joined with L_e for e in E_p;  those e are inside L_p from now on and disappear
//   degree of i in L_p, from above:  |A_i \ L_p| + |L_p \ i| + sum over e in E_i of |L_e \ L_p|,
//     where |L_e \ L_p| for all e at once costs one pass over the E_i; an e for which it is 0 disappears too
//   bodies of L_p with equal lists stay equal for ever: they continue as one with a weight
//   bodies of L_p with no other neighbours than L_p are eliminated together with p
//
// Of equal degrees, the body that has waited longest comes first. On a chain this takes both ends by turns,
// and on a grid it works inwards from all sides: the elimination tree gets several branches, where the usual
// last-in-first-out gives one long path. Exact degrees over a bit matrix would cost memory of n^2, and time
// to match. Everything depends on indices only, so the order is the same on every machine.
#include "solve/exact/factor/ordering.h"

#include <algorithm>
#include <cstdint>

namespace epode {
namespace {

// Bodies by degree, each degree a queue.
class DegreeQueues {
  public:
    bool prepare(int n, Arena& arena)
    {
        head_ = arena.take<int>(n), tail_ = arena.take<int>(n);
        next_ = arena.take<int>(n), previous_ = arena.take<int>(n);
        if (arena.failed()) return false;
        std::fill(head_.begin(), head_.end(), -1);
        return true;
    }

    void push(int v, int degree)
    {
        const auto d = std::size_t(degree), i = std::size_t(v);
        next_[i] = -1;
        previous_[i] = head_[d] < 0 ? -1 : tail_[d];
        (head_[d] < 0 ? head_[d] : next_[std::size_t(tail_[d])]) = v;
        tail_[d] = v;
        least_ = std::min(least_, degree);
    }

    void remove(int v, int degree)
    {
        const auto d = std::size_t(degree), i = std::size_t(v);
        const int before = previous_[i], after = next_[i];
        (before < 0 ? head_[d] : next_[std::size_t(before)]) = after;
        (after < 0 ? tail_[d] : previous_[std::size_t(after)]) = before;
    }

    // Removes the first body of the least degree; there must be one.
    int pop()
    {
        while (head_[std::size_t(least_)] < 0) ++least_;
        const int v = head_[std::size_t(least_)];
        remove(v, least_);
        return v;
    }

  private:
    std::span<int> head_, tail_;      // per degree
    std::span<int> next_, previous_;  // per body
    int least_ = 0;
};

class QuotientGraph {
  public:
    bool prepare(const BodyGraph& graph, Arena& arena)
    {
        n_ = left_ = graph.size();
        node_ = arena.take<Node>(n_);
        lists_ = arena.take<int>(int(graph.neighbour.size()));
        bucket_ = arena.take<int>(n_);
        if (arena.failed() || !queues_.prepare(n_, arena)) return false;
        arena_ = &arena;
        std::copy(graph.neighbour.begin(), graph.neighbour.end(), lists_.begin());
        std::fill(bucket_.begin(), bucket_.end(), -1);
        for (int v = 0; v < n_; ++v) {
            const int degree = int(graph.of(v).size());
            Node& node = at(v);
            node = {};
            node.list = lists_.data() + graph.first[std::size_t(v)];
            node.bodies = node.degree = degree;
            node.weight = 1;
            node.last = v;
            node.follower = -1;
            queues_.push(v, degree);
        }
        return true;
    }

    bool eliminate_all(std::span<int> order)
    {
        std::size_t done = 0;
        while (done < order.size()) {
            const int p = queues_.pop();
            left_ -= at(p).weight;
            if (!form_element(p)) return false;
            measure_outside(p);
            update_members(p);
            merge_equal_members(p);
            requeue_members(p);
            for (int v = p; v >= 0; v = at(v).follower) order[done++] = v;
        }
        return true;
    }

  private:
    // First a body, then the element that its elimination created, or nothing once that is absorbed.
    struct Node {
        int* list;           // of a body: E_i, then A_i. Of an element: L_e
        int elements;        // |E_i|, or of an element |L_e|
        int bodies;          // |A_i|
        int weight;          // bodies that this one represents; 0 when eliminated or merged
        int degree;          // of a body
        int size;            // of an element: the weights of L_e together
        int outside;         // of an element: weights of L_e \ L_p, valid while `seen` is this round
        int seen;            // round in which this node was last marked
        bool alive;          // of an element
        int follower, last;  // the bodies it represents, and those eliminated with it
        int next;            // in its bucket of equal hashes
        unsigned hash;
    };

    Node& at(int v) { return node_[std::size_t(v)]; }

    // Forms L_p from the neighbours of p. Absorbed elements die.
    bool form_element(int p)
    {
        Node& pivot = at(p);
        int capacity = pivot.bodies;
        for (int k = 0; k < pivot.elements; ++k) capacity += at(pivot.list[k]).elements;
        int* list = take_list(std::min(capacity, n_));
        if (!list) return false;
        ++round_;
        pivot.seen = round_;
        pivot.weight = 0;
        int count = 0, size = 0;
        const auto join = [&](const int* from, int length) {
            for (int k = 0; k < length; ++k) {
                Node& member = at(from[k]);
                if (member.weight == 0 || member.seen == round_) continue;
                member.seen = round_;
                queues_.remove(from[k], member.degree);
                list[count++] = from[k];
                size += member.weight;
            }
        };
        for (int k = 0; k < pivot.elements; ++k) {
            Node& e = at(pivot.list[k]);
            join(e.list, e.elements);
            e.alive = false;
        }
        join(pivot.list + pivot.elements, pivot.bodies);
        used_ += count;
        pivot.list = list, pivot.elements = count, pivot.size = size, pivot.alive = true;
        return true;
    }

    // Memory for a list of at most `count`; what the list uses of it is added to used_ afterwards.
    int* take_list(int count)
    {
        if (chunk_.empty() || used_ + count > int(chunk_.size())) {
            chunk_ = arena_->take<int>(std::max(count, 4 * n_));
            used_ = 0;
        }
        return chunk_.empty() ? nullptr : chunk_.data() + used_;
    }

    // Computes |L_e \ L_p| for every element that a member of L_p touches: each member subtracts its weight.
    void measure_outside(int p)
    {
        const Node& pivot = at(p);
        for (int k = 0; k < pivot.elements; ++k) {
            const Node& i = at(pivot.list[k]);
            for (int l = 0; l < i.elements; ++l) {
                Node& e = at(i.list[l]);
                if (!e.alive) continue;
                if (e.seen != round_) e.seen = round_, e.outside = e.size;
                e.outside -= i.weight;
            }
        }
    }

    void update_members(int p)
    {
        Node& pivot = at(p);
        for (int k = 0; k < pivot.elements; ++k) update_member(p, pivot.list[k]);
    }

    // Removes from the lists of i what L_p covers and inserts p instead. Something was removed, so there is
    // space.
    void update_member(int p, int i)
    {
        Node& member = at(i);
        int* list = member.list;
        int kept = 0, beyond = 0;
        unsigned hash = unsigned(p);
        for (int k = 0; k < member.elements; ++k) {
            Node& e = at(list[k]);
            if (!e.alive) continue;
            if (e.outside == 0) {
                e.alive = false;
                continue;
            }
            beyond += e.outside;
            hash += unsigned(list[k]);
            list[kept++] = list[k];
        }
        int end = kept;
        for (int k = member.elements; k < member.elements + member.bodies; ++k) {
            const Node& other = at(list[k]);
            if (other.weight == 0 || other.seen == round_) continue;
            beyond += other.weight;
            hash += unsigned(list[k]);
            list[end++] = list[k];
        }
        if (beyond == 0) {
            eliminate_along(p, i);
            return;
        }
        list[end] = list[kept];
        list[kept] = p;
        member.elements = kept + 1;
        member.bodies = end - kept;
        member.degree = std::min(member.degree, beyond);
        member.hash = hash;
    }

    void eliminate_along(int p, int i)
    {
        Node &pivot = at(p), &member = at(i);
        pivot.size -= member.weight;
        left_ -= member.weight;
        member.weight = 0;
        append(pivot, i);
    }

    // Appends i and the bodies that it represents to `to`.
    void append(Node& to, int i)
    {
        at(to.last).follower = i;
        to.last = at(i).last;
    }

    void merge_equal_members(int p)
    {
        const Node& pivot = at(p);
        for (int k = 0; k < pivot.elements; ++k) {
            const int i = pivot.list[k];
            Node& member = at(i);
            if (member.weight == 0) continue;
            int& bucket = bucket_[member.hash % unsigned(n_)];
            member.next = bucket;
            bucket = i;
        }
        for (int k = 0; k < pivot.elements; ++k) {
            const Node& member = at(pivot.list[k]);
            if (member.weight == 0) continue;
            int& bucket = bucket_[member.hash % unsigned(n_)];
            for (int i = bucket; i >= 0; i = at(i).next) merge_equals_of(i);
            bucket = -1;
        }
    }

    void merge_equals_of(int i)
    {
        Node& one = at(i);
        if (one.weight == 0 || one.next < 0) return;
        ++round_;
        for (int k = 0; k < one.elements + one.bodies; ++k) at(one.list[k]).seen = round_;
        for (int j = one.next; j >= 0; j = at(j).next) {
            Node& other = at(j);
            if (other.weight == 0 || other.hash != one.hash || !same_lists(one, other)) continue;
            one.weight += other.weight;
            other.weight = 0;
            append(one, j);
        }
    }

    // The nodes in the lists of `one` are marked.
    bool same_lists(const Node& one, const Node& other)
    {
        if (one.elements != other.elements || one.bodies != other.bodies) return false;
        for (int k = 0; k < other.elements + other.bodies; ++k)
            if (at(other.list[k]).seen != round_) return false;
        return true;
    }

    void requeue_members(int p)
    {
        Node& pivot = at(p);
        int count = 0;
        for (int k = 0; k < pivot.elements; ++k) {
            const int i = pivot.list[k];
            Node& member = at(i);
            if (member.weight == 0) continue;
            member.degree = std::min(member.degree + pivot.size, left_) - member.weight;
            queues_.push(i, member.degree);
            pivot.list[count++] = i;
        }
        pivot.elements = count;
        if (count == 0) pivot.alive = false;
    }

    int n_ = 0;
    int left_ = 0;   // bodies not yet eliminated
    int round_ = 0;  // of marking
    int used_ = 0;   // of the chunk
    Arena* arena_ = nullptr;
    DegreeQueues queues_;
    std::span<Node> node_;
    std::span<int> lists_, chunk_;
    std::span<int> bucket_;  // by hash, -1: empty
};

}  // namespace

bool order_minimum_degree(const BodyGraph& graph, Arena& arena, std::span<int> order)
{
    Arena::Scope scope(arena);
    QuotientGraph quotient;
    return quotient.prepare(graph, arena) && quotient.eliminate_all(order);
}

}  // namespace epode
