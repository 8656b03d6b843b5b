// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Caches the symbolic factors of the last steps. A structure changes less often than the numbers in it: a
// chain keeps its structure for ever, and a pile at rest keeps the pairs that touch although contacts between
// them are created and removed. The key is the body graph, found by hash; a hit is a graph that is equal word
// by word. A symbolic factor is a function of its graph alone, so a hit gives the same bits as a new
// analysis, and islands of the same structure share one. The least recently used one is replaced, never one
// in use.
#pragma once

#include <cstdint>

#include "base/arena.h"
#include "base/array.h"
#include "solve/exact/factor/symbolic.h"
#include "tasks/lock.h"

namespace epode {

// May be used by several threads at once.
class SymbolicCache {
  public:
    static constexpr int kEntries = 24;

    SymbolicCache() = default;
    SymbolicCache(const SymbolicCache&) = delete;
    SymbolicCache& operator=(const SymbolicCache&) = delete;

    // Null: unknown. Otherwise the symbolic factor stays valid until it is given back.
    const SymbolicFactor* borrow(const BodyGraph& graph);
    void give_back(const SymbolicFactor& symbolic);
    // Copies both. Does nothing if there is no memory or no entry may be replaced.
    void keep(const BodyGraph& graph, const SymbolicFactor& symbolic);
    // Removes all entries and frees their memory; none may be in use.
    void clear();

  private:
    struct Entry {
        std::uint64_t hash = 0;
        unsigned used = 0;  // time of the last use, 0: empty
        int borrowers = 0;
        BodyGraph graph;
        SymbolicFactor symbolic;
        Array<int> memory;  // of the graph and its symbolic factor
    };

    Entry* find(const BodyGraph& graph, std::uint64_t hash);

    Lock lock_;  // held for at most one comparison of a graph or one copy of a symbolic factor
    unsigned time_ = 0;
    Entry entries_[kEntries];
};

// The symbolic factor for the pairs of an island: from the cache, or computed in the arena and added to the
// cache.
class SymbolicLease {
  public:
    SymbolicLease() = default;
    SymbolicLease(const SymbolicLease&) = delete;
    SymbolicLease& operator=(const SymbolicLease&) = delete;
    ~SymbolicLease()
    {
        if (borrowed_) cache_->give_back(*symbolic_);
    }

    // `cache` may be null. False: out of memory.
    bool take(int n, std::span<const BodyPair> pairs, SymbolicCache* cache, Arena& arena);
    const SymbolicFactor& symbolic() const { return *symbolic_; }

  private:
    SymbolicCache* cache_ = nullptr;
    const SymbolicFactor* symbolic_ = nullptr;
    bool borrowed_ = false;
    SymbolicFactor made_;
};

}  // namespace epode
