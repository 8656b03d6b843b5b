// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The plans of the factors of the last steps. A structure changes less often than the numbers in it: a chain
// keeps its plan for ever, a pile at rest keeps the pairs that touch although contacts between them come and
// go. What is looked up is the body graph, by hash, and a hit is a graph that is equal word by word. A plan
// is a function of its graph alone, so a hit gives the same bits as a fresh analysis, and islands of the same
// structure share one. The least recently used plan makes room; one in use never does.
#pragma once

#include <atomic>
#include <cstdint>

#include "base/arena.h"
#include "base/array.h"
#include "solve/exact/factor/symbolic.h"

namespace epode {

// May be used by several threads at once.
class PlanCache {
  public:
    static constexpr int kEntries = 24;

    PlanCache() = default;
    PlanCache(const PlanCache&) = delete;
    PlanCache& operator=(const PlanCache&) = delete;

    // Null: unknown. Otherwise the plan stays until it is given back.
    const FactorPlan* borrow(const BodyGraph& graph);
    void give_back(const FactorPlan& plan);
    // Copies both; does nothing when there is no memory or no plan that may go.
    void keep(const BodyGraph& graph, const FactorPlan& plan);
    // Forgets all plans and gives their memory back; none may be in use.
    void clear();

  private:
    struct Entry {
        std::uint64_t hash = 0;
        unsigned used = 0;  // time of the last use, 0: empty
        int borrowers = 0;
        BodyGraph graph;
        FactorPlan plan;
        Array<int> memory;  // that graph and plan lie in
    };
    class Lock;

    Entry* find(const BodyGraph& graph, std::uint64_t hash);

    std::atomic_flag busy_ = ATOMIC_FLAG_INIT;
    unsigned time_ = 0;
    Entry entries_[kEntries];
};

// The plan for the pairs of an island: from the cache, or made in the arena and left in the cache.
class PlanLease {
  public:
    PlanLease() = default;
    PlanLease(const PlanLease&) = delete;
    PlanLease& operator=(const PlanLease&) = delete;
    ~PlanLease()
    {
        if (borrowed_) cache_->give_back(*plan_);
    }

    // `cache` may be null. False: out of memory.
    bool take(int n, std::span<const BodyPair> pairs, PlanCache* cache, Arena& arena);
    const FactorPlan& plan() const { return *plan_; }

  private:
    PlanCache* cache_ = nullptr;
    const FactorPlan* plan_ = nullptr;
    bool borrowed_ = false;
    FactorPlan made_;
};

}  // namespace epode
