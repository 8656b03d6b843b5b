// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Exact minimum degree (Tinney & Walker 1967): eliminate a body with the fewest neighbours, join its
// neighbours into a clique, repeat; ties go to the lowest index. The graph is a bit matrix, so joining is a
// union of words, and what the neighbours of an eliminated body are *is* its column of the factor. A quotient
// graph would need less memory above ten thousand bodies; below that this is faster and 60 lines.
#include "solve/ordering.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace epode {
namespace {

class BitGraph {
  public:
    BitGraph(int n, Arena& arena)
        : n_(n),
          words_((std::size_t(n) + 63) / 64),
          bits_(arena.take_zeroed<std::uint64_t>(n * int(words_))),
          degree_(arena.take_zeroed<int>(n))
    {}

    void connect(int a, int b)
    {
        if (a == b) return;
        set(a, b);
        set(b, a);
    }

    void count_degrees()
    {
        for (int v = 0; v < n_; ++v) degree_[std::size_t(v)] = count(v);
    }

    // A remaining vertex of least degree; eliminated ones carry n as their degree.
    int least() const { return int(std::min_element(degree_.begin(), degree_.end()) - degree_.begin()); }
    int degree(int v) const { return degree_[std::size_t(v)]; }

    template <typename Visit>
    void for_neighbours(int v, Visit visit) const
    {
        for (std::size_t w = 0; w < words_; ++w)
            for (std::uint64_t bits = row(v)[w]; bits; bits &= bits - 1)
                visit(int(w * 64) + std::countr_zero(bits));
    }

    void eliminate(int v)
    {
        for_neighbours(v, [&](int u) {
            std::uint64_t* r = row(u);
            for (std::size_t w = 0; w < words_; ++w) r[w] |= row(v)[w];
            r[std::size_t(u) / 64] &= ~(std::uint64_t(1) << (u & 63));
            r[std::size_t(v) / 64] &= ~(std::uint64_t(1) << (v & 63));
            degree_[std::size_t(u)] = count(u);
        });
        degree_[std::size_t(v)] = n_;
    }

  private:
    std::uint64_t* row(int v) { return bits_.data() + std::size_t(v) * words_; }
    const std::uint64_t* row(int v) const { return bits_.data() + std::size_t(v) * words_; }
    void set(int a, int b) { row(a)[std::size_t(b) / 64] |= std::uint64_t(1) << (b & 63); }
    int count(int v) const
    {
        int sum = 0;
        for (std::size_t w = 0; w < words_; ++w) sum += std::popcount(row(v)[w]);
        return sum;
    }

    int n_;
    std::size_t words_;
    std::span<std::uint64_t> bits_;
    std::span<int> degree_;
};

}  // namespace

bool order_minimum_degree(int n, std::span<const BodyPair> pairs, Arena& arena, FactorStructure& out)
{
    out.position = arena.take<int>(n);
    out.first = arena.take<int>(n + 1);
    BitGraph graph(n, arena);
    auto order = arena.take<int>(n);
    if (arena.failed()) return false;
    for (const BodyPair& pair : pairs) graph.connect(pair.a, pair.b);
    graph.count_degrees();

    // First pass: the order, and how long each column is. The neighbours of an eliminated vertex stay in its
    // row of the graph, for the second pass.
    int total = 0;
    for (int k = 0; k < n; ++k) {
        const int v = graph.least();
        order[std::size_t(k)] = v;
        out.position[std::size_t(v)] = k;
        out.first[std::size_t(k)] = total;
        total += graph.degree(v);
        graph.eliminate(v);
    }
    out.first[std::size_t(n)] = total;
    out.rows = arena.take<int>(total);
    if (arena.failed()) return false;

    for (int k = 0; k < n; ++k) {
        int* column = out.rows.data() + out.first[std::size_t(k)];
        int* end = column;
        graph.for_neighbours(order[std::size_t(k)], [&](int u) { *end++ = out.position[std::size_t(u)]; });
        std::sort(column, end);
    }
    return true;
}

}  // namespace epode
