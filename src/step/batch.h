// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Steps of many worlds in one call. A world is a piece of work, stepped on one thread as if it were alone:
// worlds share nothing that a step changes, but for what the program lets them share. Two sorts are looked
// for before:
//   - worlds that hold the same working memory, or bodies with geoms in the same outermost space: they make
//     one piece, stepped in the order of the array;
//   - worlds in whose steps functions of the program are called, which expects them on its own thread: they,
//     and all that share with them, are stepped there when the others are done, in the order of the array.
// So what a world gets depends on those it shares with and on their order, and on nothing else. Stepping all
// islands of all worlds from one queue would balance better where worlds differ a lot in size, and would have
// to split a step at its middle: collision and finishing touch the space and stay with their world.
#pragma once

#include "base/array.h"
#include "dynamics/world.h"
#include "solve/solver.h"

namespace epode {

class WorldBatch {
  public:
    struct Step {
        const Solver* solver;  // null: hybrid
        Real h;
        int substeps;  // of solvers that have them
    };

    // The worlds are different and in no step; they are marked as stepping until the end of the batch, so
    // that functions of the program leave them alone. False: out of memory.
    [[nodiscard]] bool add(World& world);
    ~WorldBatch();

    // Looks for what the worlds share. False: out of memory, nothing has been stepped.
    [[nodiscard]] bool prepare(int threads);
    // Returns how many worlds have made all steps. `made` may be null.
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

    static void survey(Entry& entry);
    bool collect_shares();
    void join_sharers();
    int find(int entry);
    void make_pieces();
    int make_steps(int entry, const Step& step, int steps) const;

    Array<Entry> entries_;
    Array<Share> shares_;
    Array<int> order_;     // entries, piece after piece; those of the caller's thread last
    Array<Piece> pieces_;  // heavy ones first
    int own_ = 0;          // first place in order_ of the caller's thread
    int threads_ = 1;
};

}  // namespace epode
