// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Steps many worlds in one call. Each world is stepped on one thread as if it were alone: worlds share
// nothing that a step changes, except what the program lets them share. Two cases are detected first:
//   - worlds with the same working memory, or with bodies whose geoms are in the same outermost space, form
//     one piece, stepped in the order of the array;
//   - worlds whose steps call functions of the program, which expects them on its own thread: these worlds,
//     and all that share with them, are stepped there after the others, in the order of the array.
// All others work in memory that each worker lends to the worlds that it steps, one after another: a thousand
// worlds of their own memory each would not fit the cache. What is lent belongs to the first of these worlds.
// So the result of a world depends only on the worlds that it shares with and on their order. Rejected: one
// queue of all islands of all worlds. It would balance better where worlds differ a lot in size, but would
// split every step in the middle: collision and finishing touch the space and stay with their world.
#pragma once

#include "base/array.h"
#include "dynamics/world.h"

namespace epode {

struct Stepper;

class WorldBatch {
  public:
    struct Step {
        const Stepper& stepper;
        Real h;
        int substeps;  // of steppers with substeps
    };

    // The worlds are different and in no step; they are marked as stepping until the end of the batch, so
    // that functions of the program leave them alone. False: out of memory.
    [[nodiscard]] bool add(World& world);
    ~WorldBatch();

    // Finds what the worlds share. False: out of memory; nothing has been stepped.
    [[nodiscard]] bool prepare(int threads);
    // Returns how many worlds have completed all steps. `made` may be null.
    int run(const Step& step, int steps, int* made);

  private:
    static constexpr int kInline = 6;
    struct Entry {
        World* world;
        const void* shares[kInline];  // the first of what it may share
        int share_count;              // may be more than there are places
        bool calls_program;
        int piece;  // lowest index of those that it shares with, at any remove
    };
    struct Share {
        const void* what;
        int entry;
    };
    // Worlds order_[first] ... order_[first + count - 1].
    struct Piece {
        int first, count;
        long long weight;
    };

    static void unmark(void*, const void* entries, std::size_t count);
    static void survey(Entry& entry);
    bool collect_shares();
    void join_sharers();
    int find(int entry);
    void make_pieces();
    [[nodiscard]] bool lend_memory();
    StepMemory* memory_for(const World& world, int worker) const;
    void fetch_ahead(int piece) const;
    int make_steps(World& world, const Step& step, int steps, StepMemory* lent) const;

    Array<Entry> entries_;
    Array<Share> shares_;
    Array<int> order_;         // entries, piece after piece; those of the caller's thread last
    Array<Piece> pieces_;      // heavy ones first
    int own_ = 0;              // first place in order_ of the caller's thread
    Array<StepMemory*> lent_;  // by worker; empty: each world uses its own
    int threads_ = 1;
};

}  // namespace epode
