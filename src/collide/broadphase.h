// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which members of a space may touch. Members are slots 0, 1, ... in order of joining; each has its true box
// and a fat one around it, which is in a tree. As long as the true box stays inside the fat one, the list of
// pairs with overlapping fat boxes does not change from call to call, and a settled scene pays only for the
// walk over it. A member that leaves its fat box gets a new one (larger by 4 times its last shift, within
// 2-10 % of its size), and its pairs are queried again, sorted and merged into the list. The list is ordered
// by (newer slot, older slot), both descending, whatever the history of motion: the order of callbacks
// depends on the order of joining only. Boxes without bounds, and those that are not ordered, are in a short
// list that is tested against everything. Rejected: hash grids (rebuilt each
// step, poor with mixed sizes) and a sort along an axis (clusters on floors).
#pragma once

#include <span>

#include "bvh/ray_tree.h"
#include "tasks/tasks.h"

namespace epode {

struct SlotPair {
    int newer, older;
};

// The order of the list.
inline bool in_order(const SlotPair& a, const SlotPair& b)
{
    return a.newer != b.newer ? a.newer > b.newer : a.older > b.older;
}

class Broadphase {
  public:
    // Room for slots below `slots`. False when memory is exhausted.
    [[nodiscard]] bool reserve(int slots);

    int slots() const { return proxies_.size(); }

    // A slot has joined or changed; absent ones have no pairs.
    void update(int slot, const Aabb& box, bool present);

    // Where a present slot will be for a while, as Notes::expect().
    void expect(int slot, const Aabb& way)
    {
        if (note_way(slot, way)) (void)escaped_.push(slot);
    }

    // What a parallel walk over many slots records.
    class Notes {
      public:
        // As Broadphase::update(), and no more of a slot that is absent now.
        void update(int slot, const Aabb& box, bool present)
        {
            if (present) return keep(slot, boxes_.note(slot, box));
            keep(kGone - slot, boxes_.present(slot));
            gone_ = slot;
        }
        // Where a present slot will be for a while; its pairs until then will have been found. Holds its box.
        void expect(int slot, const Aabb& way)
        {
            if (slot != gone_) keep(slot, boxes_.note_way(slot, way));
        }

      private:
        friend class Broadphase;
        static constexpr int kEnd = -1, kGone = -2;  // -2 - slot: the slot has gone
        Notes(Broadphase& boxes, int* out) : boxes_(boxes), out_(out) {}
        void keep(int note, bool so)
        {
            if (so) *out_++ = note;
        }
        Broadphase& boxes_;
        int* out_;
        int gone_ = -1;
    };
    // f(slot, notes) for the slots 0 ... count - 1, on all workers; it may record about that slot only.
    template <typename F>
    void note_all(const Tasks& tasks, int count, F&& f);
    void remove(int slot);
    void clear();

    // Slots have been renumbered without changing their order; new_slot[i] = -1 for removed ones.
    void renumber(std::span<const int> new_slot, int count);

    // Brings tree and pairs up to date. False when memory is exhausted: pairs() must not be used then.
    [[nodiscard]] bool find_pairs(const Tasks& tasks = Tasks(1));
    std::span<const SlotPair> pairs() const { return pairs_.span(); }

    bool present(int slot) const { return proxies_.data()[slot].present; }
    // What update() of the slot looks at, in two steps.
    void prefetch_box(int slot) const { prefetch<2>(proxies_.data() + slot); }
    void prefetch_fat_box(int slot) const
    {
        if (proxies_.data()[slot].leaf >= 0) prefetch<1>(&tree_.box(proxies_.data()[slot].leaf));
    }
    const Aabb& box(int slot) const { return proxies_.data()[slot].box; }
    const Aabb& way(int slot) const { return proxies_.data()[slot].way; }

    // visit(slot) for every present slot whose box meets `box`, in no promised order. False when the tree
    // could not be brought up to date; nothing has been visited then.
    template <typename Visit>
    [[nodiscard]] bool query(const Aabb& box, Visit&& visit)
    {
        if (!update_tree()) return false;
        query_fat(box, [&](int slot) {
            if (overlap(proxies_.data()[slot].box, box)) visit(slot);
        });
        return true;
    }

    // visit(other) for every other present slot whose way meets that of the slot, in no promised order.
    template <typename Visit>
    [[nodiscard]] bool query_way(int slot, Visit&& visit)
    {
        if (!update_tree()) return false;
        const Aabb way = proxies_.data()[slot].way;
        query_fat(way, [&](int other) {
            if (other != slot && overlap(proxies_.data()[other].way, way)) visit(other);
        });
        return true;
    }

    // Brings the tree up to date, and for many rays on an unchanged one makes it over for them: `rays` are
    // about to be cast. False when memory is exhausted: cast() must not be used then.
    [[nodiscard]] bool prepare(int rays);
    bool ready() const { return escaped_.empty() && tree_.sound(); }
    int waiting() const { return escaped_.size(); }  // for a new place in the tree

    // visit(slot) for every present slot whose box the ray (unit direction) meets, and for some that it
    // hardly misses, near ones first as a rule, in no promised order; it answers how far the ray has still to
    // be followed, less than 0 ends it. prefetch(slot) may come before, when there will be a visit soon.
    template <typename Visit, typename Prefetch>
    void cast(Vec3 origin, Vec3 direction, Real reach, Visit&& visit, Prefetch&& prefetch) const
    {
        for (int slot : unbounded_) reach = visit(slot);
        if (tree_.leaf_count() == 0 || reach < 0) return;
        const TreeRay ray(origin, direction, tree_.bounds());
        if (ray_tree_.serves(ray)) {
            ray_tree_.cast(ray, direction, tree_.bounds(), reach, visit, prefetch);
            return;
        }
        tree_.cast(ray, reach, [&](int slot) {
            if (ray.enters(proxies_.data()[slot].box, reach) < kInf) reach = visit(slot);
            return reach;
        });
    }

  private:
    // Two lines of the cache; walks over pairs look at the ways or at the boxes alone.
    struct alignas(kCacheLine) Proxy {
        Aabb way;        // its box, or what was expected since: lies in a new fat box too
        Real shift = 0;  // how far it moved when it last changed
        int leaf = -1;   // in the tree; -1: none
        bool present = false;
        bool settled = false;  // has had a place: gets a margin when it leaves it
        bool escaped = false;  // waits for a new fat box
        bool fresh = false;    // waits for its pairs
        alignas(kCacheLine) Aabb box;
    };

    // Whether the slot has left its fat box and is not listed yet.
    bool note(int slot, const Aabb& box);
    bool note_way(int slot, const Aabb& way);
    template <typename Visit>
    void query_fat(const Aabb& box, Visit&& visit) const
    {
        tree_.query(box, visit);
        for (int slot : unbounded_)
            if (overlap(proxies_.data()[slot].box, box)) visit(slot);
    }

    [[nodiscard]] bool update_tree(const Tasks& tasks = Tasks(1));
    [[nodiscard]] bool place(int slot, bool in_bulk);
    void withdraw(int slot);
    void leave_tree(Proxy& proxy);
    void tree_changes();
    void leave_unbounded(int slot);
    static Aabb fatten(const Proxy& proxy);
    void drop_stale_pairs();
    using Found = Array<SlotPair>;
    template <typename Look>
    bool in_parts(const Tasks& tasks, Look&& look);
    [[nodiscard]] bool collect_fresh(const Tasks& tasks);
    [[nodiscard]] bool collect_all(const Tasks& tasks);
    [[nodiscard]] bool keep_fresh(int a, int b, Found& found) const;
    [[nodiscard]] bool collect_unbounded(Found& found) const;
    [[nodiscard]] bool collect(int slot, Found& found) const;
    [[nodiscard]] bool join_found();
    [[nodiscard]] bool sort_found();
    [[nodiscard]] bool merge_found();
    const Aabb& fat_box(const Proxy& proxy) const;

    Array<Proxy> proxies_;
    DynamicTree tree_;
    RayTree ray_tree_;  // empty: not made since the tree has changed
    int rays_ = 0;      // since then
    Array<int> unbounded_;
    Array<int> escaped_;
    Array<int> fresh_;
    Array<int> notes_;  // range by range; kEnd where a range is not full
    static constexpr int kNoteRange = 256;
    Array<SlotPair> pairs_;
    // New pairs, in as many parts as may be collected in parallel.
    static constexpr int kParts = 16;
    Found parts_[kParts];
    Array<NodePair> subtrees_;
    Array<SlotPair> found_, sorted_;
    Array<int> first_of_;  // by newer slot, for sorting
    bool stale_pairs_ = false;
};

template <typename F>
void Broadphase::note_all(const Tasks& tasks, int count, F&& f)
{
    tasks.for_each((count + kNoteRange - 1) / kNoteRange, [&](int range, int) {
        const int first = range * kNoteRange, last = count < first + kNoteRange ? count : first + kNoteRange;
        Notes notes(*this, notes_.data() + first);
        for (int slot = first; slot < last; ++slot) f(slot, notes);
        if (notes.out_ < notes_.data() + last) *notes.out_ = Notes::kEnd;
    });
    for (int first = 0; first < count; first += kNoteRange)
        for (int i = first; i < count && i < first + kNoteRange; ++i) {
            const int note = notes_.data()[i];
            if (note == Notes::kEnd) break;
            if (note >= 0)
                (void)escaped_.push(note);
            else
                remove(Notes::kGone - note);
        }
}

}  // namespace epode
