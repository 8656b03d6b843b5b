// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A graph and its symbolic factor are a handful of integer arrays. An entry holds them in one block of
// memory, which grows to the largest it has held. Entries are few, so they are searched one after another.
#include "solve/exact/factor/symbolic_cache.h"

#include <algorithm>
#include <cstring>

#include "solve/exact/factor/ordering.h"

namespace epode {
namespace {

// The number of bodies of the smallest island worth caching; for smaller ones the analysis costs as little as
// the search.
constexpr int kSmallest = 4;

// FNV-1a over words instead of bytes: it only preselects which graphs are compared.
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

// Calls visit(array) for every array of a graph and its symbolic factor, in a fixed order.
template <typename Visit>
void for_arrays(BodyGraph& graph, SymbolicFactor& symbolic, Visit visit)
{
    visit(graph.first), visit(graph.neighbour);
    visit(symbolic.position), visit(symbolic.front_of), visit(symbolic.fronts);
    visit(symbolic.rows), visit(symbolic.entries), visit(symbolic.updates), visit(symbolic.places);
    visit(symbolic.subtrees), visit(symbolic.subtree_fronts);
}

}  // namespace

SymbolicCache::Entry* SymbolicCache::find(const BodyGraph& graph, std::uint64_t hash)
{
    for (Entry& e : entries_)
        if (e.used && e.hash == hash && equal(e.graph.first, graph.first) &&
            equal(e.graph.neighbour, graph.neighbour))
            return &e;
    return nullptr;
}

const SymbolicFactor* SymbolicCache::borrow(const BodyGraph& graph)
{
    const std::uint64_t hash = hash_of(graph);
    const Guard guard(lock_);
    Entry* e = find(graph, hash);
    if (!e) return nullptr;
    e->used = ++time_;
    ++e->borrowers;
    return &e->symbolic;
}

void SymbolicCache::give_back(const SymbolicFactor& symbolic)
{
    const Guard guard(lock_);
    for (Entry& e : entries_)
        if (&e.symbolic == &symbolic) --e.borrowers;
}

void SymbolicCache::keep(const BodyGraph& graph, const SymbolicFactor& symbolic)
{
    const std::uint64_t hash = hash_of(graph);
    const Guard guard(lock_);
    if (find(graph, hash)) return;  // another thread has added the same graph first
    Entry* oldest = nullptr;
    for (Entry& e : entries_)
        if (e.borrowers == 0 && (!oldest || e.used < oldest->used)) oldest = &e;
    if (!oldest) return;
    oldest->used = 0;
    oldest->graph = graph;
    oldest->symbolic = symbolic;
    int words = 0;
    const auto count = [&](auto& array) { words += int(array.size_bytes() / sizeof(int)); };
    for_arrays(oldest->graph, oldest->symbolic, count);
    if (!oldest->memory.resize(words)) return;
    int* to = oldest->memory.data();
    const auto copy = [&](auto& array) {
        using T = typename std::remove_reference_t<decltype(array)>::element_type;
        static_assert(sizeof(T) % sizeof(int) == 0 && alignof(T) == alignof(int));
        if (!array.empty()) std::memcpy(to, array.data(), array.size_bytes());
        array = {reinterpret_cast<T*>(to), array.size()};
        to += array.size_bytes() / sizeof(int);
    };
    for_arrays(oldest->graph, oldest->symbolic, copy);
    oldest->hash = hash;
    oldest->used = ++time_;
}

void SymbolicCache::clear()
{
    const Guard guard(lock_);
    for (Entry& e : entries_) {
        e.memory.reset();
        e.graph = {};
        e.symbolic = {};
        e.used = 0;
    }
}

bool SymbolicLease::take(int n, std::span<const BodyPair> pairs, SymbolicCache* cache, Arena& arena)
{
    BodyGraph graph;
    if (!build_body_graph(n, pairs, arena, graph)) return false;
    if (n < kSmallest) cache = nullptr;
    cache_ = cache;
    if (cache && (symbolic_ = cache->borrow(graph))) {
        borrowed_ = true;
        return true;
    }
    auto order = arena.take<int>(n);
    symbolic_ = &made_;
    if (arena.failed() || !order_minimum_degree(graph, arena, order) ||
        !factor_symbolically(graph, order, arena, made_))
        return false;
    if (cache) cache->keep(graph, made_);
    return true;
}

}  // namespace epode
