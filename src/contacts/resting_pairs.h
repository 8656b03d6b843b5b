// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The pairs that no step looks at: neither geom's body is active, and nothing has happened to either geom.
// They stay as they are, whatever their number, until something wants those of one geom back. Each pair is in
// the lists of both of its geoms, which a table finds by serial number. What is taken leaves its place to
// what is put, so that taking and putting cost the same however many pairs rest.
#pragma once

#include "contacts/pair_list.h"

namespace epode {

class RestingPairs {
  public:
    bool empty() const { return count_ == 0; }

    // Those pairs of the list for which step_of(pair) is positive, the size of the step that their impulses are
    // of; without their bodies' addresses: bodies may go meanwhile. False: out of memory; each pair is in one of
    // the two lists.
    template <typename StepOf>
    [[nodiscard]] bool put(PairList& from, StepOf&& step_of);
    // Moves all pairs of the geom to the end of `to`, with the impulses that their forces have in a step of size
    // h. False: out of memory; some may have been moved.
    [[nodiscard]] bool take(std::uint64_t serial, float h, PairList& to);
    [[nodiscard]] bool take_all(float h, PairList& to);
    // Of a pair that for_each() has visited.
    float step_of(const ContactPair& pair) const { return links_[int(&pair - list_.pairs.data())].step; }
    void clear();

    // What is broken, in words; null: nothing.
    const char* fault() const;

    // f(pair, its manifolds), in no promised order.
    template <typename F>
    void for_each(F&& f) const
    {
        for (const ContactPair& pair : list_.pairs)
            if (is_there(pair)) f(pair, list_.of(pair));
    }

    template <typename F>
    void for_each_own(F&& f)
    {
        for (const ContactPair& pair : list_.pairs)
            if (is_there(pair)) f(pair, list_.own(pair));
    }

  private:
    static constexpr int kEnd = -1;

    struct Link {
        int next[2], previous[2];  // in the lists of the pair's geoms
        float step;                // size of the step that its impulses are of
    };
    struct Head {
        std::uint64_t serial;  // 0: free
        int first;
    };

    static bool is_there(const ContactPair& pair) { return pair.id1 != nullptr; }
    [[nodiscard]] bool put_one(const PairList& from, const ContactPair& pair, float step);
    [[nodiscard]] bool append(int pair, float h, PairList& to) const;
    [[nodiscard]] bool reserve_heads();
    Head& place_of(std::uint64_t serial);  // its head, or where that would be
    int side_of(int pair, std::uint64_t serial) const
    {
        return list_.pairs.data()[pair].serial1 == serial ? 0 : 1;
    }
    std::uint64_t serial_of(int pair, int side) const
    {
        const ContactPair& p = list_.pairs.data()[pair];
        return side == 0 ? p.serial1 : p.serial2;
    }
    [[nodiscard]] bool link(int pair);
    void unlink(int pair);
    // With impulses for a step of size h; 0: as they are.
    [[nodiscard]] bool move(int pair, float h, PairList& to);

    PairList list_;
    Array<Link> links_;   // of each pair
    Array<Head> heads_;   // open addressing; its size is a power of two
    int head_count_ = 0;  // that are not free
    int count_ = 0;       // pairs that are there
    // Places that nobody has: of pairs, of leaves, and of so many manifolds side by side. Where these lists
    // are full, places are lost until all pairs have been taken.
    Array<int> free_pairs_, free_leaves_, free_manifolds_[kSurfaceManifolds + 1];
};

// Where nothing rests yet the whole list moves in, and the others back: mostly a world falls asleep at once.
template <typename StepOf>
bool RestingPairs::put(PairList& from, StepOf&& step_of)
{
    if (empty()) {
        clear();
        if (!links_.resize(from.pairs.size())) return false;
        list_.swap(from);
        count_ = list_.pairs.size();
        for (int i = 0; i < list_.pairs.size(); ++i) {
            links_[i].step = 0;
            if (!link(i)) return false;
        }
        for (int i = 0; i < list_.pairs.size(); ++i) {
            links_[i].step = step_of(list_.pairs.data()[i]);
            if (!(links_[i].step > 0) && !move(i, 0, from)) return false;
        }
        return true;
    }
    int left = 0;
    bool complete = true;
    for (const ContactPair& pair : from.pairs) {
        const float step = complete ? step_of(pair) : 0;
        const bool moves = step > 0;
        complete = complete && (!moves || put_one(from, pair, step));
        if (!moves || !complete) from.pairs.data()[left++] = pair;
    }
    from.pairs.truncate(left);
    return complete;
}

}  // namespace epode
