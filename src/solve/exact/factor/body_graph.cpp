// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Two passes of bucket sort: first the ends of all pairs are stored with their body; then the bodies in
// ascending order append themselves to each of their neighbours, which leaves every list sorted. Linear in
// bodies and pairs; a comparison sort of the pairs would cost more than the elimination of a chain.
#include "solve/exact/factor/body_graph.h"

#include <algorithm>

namespace epode {
namespace {

// From counts to starts: first[v + 1] holds the size of list v; afterwards first[v] is where it begins.
void accumulate(std::span<int> first)
{
    for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
}

}  // namespace

bool build_body_graph(int n, std::span<const BodyPair> pairs, Arena& arena, BodyGraph& out)
{
    out.first = arena.take_zeroed<int>(n + 1);
    out.neighbour = arena.take<int>(2 * int(pairs.size()));
    auto first = arena.take_zeroed<int>(n + 1);
    auto fill = arena.take<int>(n);
    auto unsorted = arena.take<int>(2 * int(pairs.size()));
    if (arena.failed()) return false;

    for (const auto [a, b] : pairs)
        if (a != b) ++first[std::size_t(a) + 1], ++first[std::size_t(b) + 1];
    accumulate(first);
    std::copy_n(first.begin(), n, fill.begin());
    for (const auto [a, b] : pairs) {
        if (a == b) continue;
        unsorted[std::size_t(fill[std::size_t(a)]++)] = b;
        unsorted[std::size_t(fill[std::size_t(b)]++)] = a;
    }

    // In a sorted list a repeated neighbour follows itself. The sorted lists are written where the unsorted
    // ones would be, and then moved together.
    std::copy_n(first.begin(), n, fill.begin());
    for (int v = 0; v < n; ++v)
        for (int k = first[std::size_t(v)]; k < first[std::size_t(v) + 1]; ++k) {
            const auto u = std::size_t(unsorted[std::size_t(k)]);
            int& end = fill[u];
            if (end == first[u] || out.neighbour[std::size_t(end) - 1] != v)
                out.neighbour[std::size_t(end++)] = v;
        }
    int total = 0;
    for (int v = 0; v < n; ++v) {
        out.first[std::size_t(v)] = total;
        for (int k = first[std::size_t(v)]; k < fill[std::size_t(v)]; ++k)
            out.neighbour[std::size_t(total++)] = out.neighbour[std::size_t(k)];
    }
    out.first[std::size_t(n)] = total;
    out.neighbour = out.neighbour.first(std::size_t(total));
    return true;
}

}  // namespace epode
