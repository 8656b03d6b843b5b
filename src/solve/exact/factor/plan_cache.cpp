// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Graph and plan are a handful of integer arrays: an entry holds them in one block of memory that grows to
// the largest it has held. Entries are few, so they are searched one after another.
#include "solve/exact/factor/plan_cache.h"

#include <algorithm>
#include <cstring>

#include "solve/exact/factor/ordering.h"

namespace epode {
namespace {

// Bodies of the smallest island worth remembering; below that the analysis costs as little as the search.
constexpr int kSmallest = 4;

// FNV-1a over words instead of bytes: it only chooses whom to compare.
std::uint64_t hash_of(const BodyGraph& graph)
{
    std::uint64_t h = 0xcbf29ce484222325u ^ std::uint64_t(graph.size());
    for (const int x : graph.first) h = (h ^ std::uint64_t(x)) * 0x100000001b3u;
    for (const int x : graph.neighbour) h = (h ^ std::uint64_t(x)) * 0x100000001b3u;
    return h;
}

bool equal(std::span<const int> a, std::span<const int> b)
{
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

// visit(array) for every array of a graph and its plan, in a fixed order.
template <typename Visit>
void for_arrays(BodyGraph& graph, FactorPlan& plan, Visit visit)
{
    visit(graph.first), visit(graph.neighbour);
    visit(plan.position), visit(plan.front_of), visit(plan.fronts);
    visit(plan.rows), visit(plan.entries), visit(plan.updates), visit(plan.places);
    visit(plan.subtrees), visit(plan.subtree_fronts);
}

}  // namespace

// Held for the comparison of one graph or the copy of one plan at most.
class PlanCache::Lock {
  public:
    explicit Lock(std::atomic_flag& busy) : busy_(busy)
    {
        while (busy_.test_and_set(std::memory_order_acquire)) busy_.wait(true, std::memory_order_relaxed);
    }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;
    ~Lock()
    {
        busy_.clear(std::memory_order_release);
        busy_.notify_one();
    }

  private:
    std::atomic_flag& busy_;
};

PlanCache::Entry* PlanCache::find(const BodyGraph& graph, std::uint64_t hash)
{
    for (Entry& e : entries_)
        if (e.used && e.hash == hash && equal(e.graph.first, graph.first) &&
            equal(e.graph.neighbour, graph.neighbour))
            return &e;
    return nullptr;
}

const FactorPlan* PlanCache::borrow(const BodyGraph& graph)
{
    const std::uint64_t hash = hash_of(graph);
    const Lock lock(busy_);
    Entry* e = find(graph, hash);
    if (!e) return nullptr;
    e->used = ++time_;
    ++e->borrowers;
    return &e->plan;
}

void PlanCache::give_back(const FactorPlan& plan)
{
    const Lock lock(busy_);
    for (Entry& e : entries_)
        if (&e.plan == &plan) --e.borrowers;
}

void PlanCache::keep(const BodyGraph& graph, const FactorPlan& plan)
{
    const std::uint64_t hash = hash_of(graph);
    const Lock lock(busy_);
    if (find(graph, hash)) return;  // a twin on another thread was first
    Entry* oldest = nullptr;
    for (Entry& e : entries_)
        if (e.borrowers == 0 && (!oldest || e.used < oldest->used)) oldest = &e;
    if (!oldest) return;
    oldest->used = 0;
    oldest->graph = graph;
    oldest->plan = plan;
    int words = 0;
    const auto count = [&](auto& array) { words += int(array.size_bytes() / sizeof(int)); };
    for_arrays(oldest->graph, oldest->plan, count);
    if (!oldest->memory.resize(words)) return;
    int* to = oldest->memory.data();
    const auto copy = [&](auto& array) {
        using T = typename std::remove_reference_t<decltype(array)>::element_type;
        static_assert(sizeof(T) % sizeof(int) == 0 && alignof(T) == alignof(int));
        if (!array.empty()) std::memcpy(to, array.data(), array.size_bytes());
        array = {reinterpret_cast<T*>(to), array.size()};
        to += array.size_bytes() / sizeof(int);
    };
    for_arrays(oldest->graph, oldest->plan, copy);
    oldest->hash = hash;
    oldest->used = ++time_;
}

void PlanCache::clear()
{
    const Lock lock(busy_);
    for (Entry& e : entries_) {
        e.memory.reset();
        e.graph = {};
        e.plan = {};
        e.used = 0;
    }
}

bool PlanLease::take(int n, std::span<const BodyPair> pairs, PlanCache* cache, Arena& arena)
{
    BodyGraph graph;
    if (!build_body_graph(n, pairs, arena, graph)) return false;
    if (n < kSmallest) cache = nullptr;
    cache_ = cache;
    if (cache && (plan_ = cache->borrow(graph))) {
        borrowed_ = true;
        return true;
    }
    auto order = arena.take<int>(n);
    plan_ = &made_;
    if (arena.failed() || !order_minimum_degree(graph, arena, order) ||
        !make_plan(graph, order, arena, made_))
        return false;
    if (cache) cache->keep(graph, made_);
    return true;
}

}  // namespace epode
