// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The body graph, the order of elimination and the structure of the factor, against elimination carried out
// literally on a dense pattern.
#include "solve/ordering.h"

#include <gtest/gtest.h>

#include <set>

#include "solve/symbolic.h"
#include "systems.h"

namespace {

using namespace epode_test;
using Pattern = std::vector<std::set<int>>;

std::vector<BodyPair> random_pairs(Dice& dice, int n, int count)
{
    std::vector<BodyPair> pairs;
    for (int i = 0; i < count; ++i) pairs.push_back({dice.below(n), dice.below(n)});
    return pairs;
}

Pattern pattern_of(int n, const std::vector<BodyPair>& pairs)
{
    Pattern p(std::size_t(n), std::set<int>{});
    for (const auto [a, b] : pairs)
        if (a != b) p[std::size_t(a)].insert(b), p[std::size_t(b)].insert(a);
    return p;
}

// Eliminates v: its neighbours become a clique and forget it.
void eliminate(Pattern& p, int v)
{
    const std::set<int> around = p[std::size_t(v)];
    for (const int a : around) {
        p[std::size_t(a)].erase(v);
        for (const int b : around)
            if (a != b) p[std::size_t(a)].insert(b);
    }
}

// Fill of true minimum degree, lowest index first.
int fill_of_exact_minimum_degree(Pattern p)
{
    std::set<int> left;
    int total = 0;
    for (int v = 0; v < int(p.size()); ++v) left.insert(v);
    while (!left.empty()) {
        int best = *left.begin();
        for (const int v : left)
            if (p[std::size_t(v)].size() < p[std::size_t(best)].size()) best = v;
        total += int(p[std::size_t(best)].size());
        eliminate(p, best);
        left.erase(best);
    }
    return total;
}

struct Analysis {
    Arena arena;
    BodyGraph graph;
    std::span<int> order;
    FactorStructure structure;

    Analysis(int n, const std::vector<BodyPair>& pairs)
    {
        order = arena.take<int>(n);
        EXPECT_TRUE(build_body_graph(n, pairs, arena, graph));
        EXPECT_TRUE(order_minimum_degree(graph, arena, order));
        EXPECT_TRUE(find_structure(graph, order, arena, structure));
    }
};

std::vector<BodyPair> chain_of(int n)
{
    std::vector<BodyPair> pairs;
    for (int i = 1; i < n; ++i) pairs.push_back({i - 1, i});
    return pairs;
}

std::vector<BodyPair> grid_of(int side)
{
    std::vector<BodyPair> pairs;
    for (int r = 0; r < side; ++r)
        for (int c = 0; c < side; ++c) {
            if (c) pairs.push_back({r * side + c, r * side + c - 1});
            if (r) pairs.push_back({r * side + c, (r - 1) * side + c});
        }
    return pairs;
}

TEST(BodyGraph, ListsEveryNeighbourOnceInOrder)
{
    Dice dice(11);
    for (int n = 1; n <= 40; ++n) {
        const auto pairs = random_pairs(dice, n, 3 * n);
        const Pattern wanted = pattern_of(n, pairs);
        Arena arena;
        BodyGraph graph;
        ASSERT_TRUE(build_body_graph(n, pairs, arena, graph));
        ASSERT_EQ(graph.size(), n);
        for (int v = 0; v < n; ++v) {
            const auto of = graph.of(v);
            EXPECT_EQ(std::vector<int>(of.begin(), of.end()),
                      std::vector<int>(wanted[std::size_t(v)].begin(), wanted[std::size_t(v)].end()));
        }
    }
}

TEST(BodyGraph, DoesNotDependOnTheOrderOfPairs)
{
    Dice dice(12);
    auto pairs = random_pairs(dice, 30, 80);
    const Analysis one(30, pairs);
    std::reverse(pairs.begin(), pairs.end());
    for (BodyPair& pair : pairs) std::swap(pair.a, pair.b);
    const Analysis other(30, pairs);
    EXPECT_TRUE(std::ranges::equal(one.graph.neighbour, other.graph.neighbour));
    EXPECT_TRUE(std::ranges::equal(one.order, other.order));
}

TEST(Ordering, IsAPermutationOfAnyGraph)
{
    Dice dice(4);
    for (int n = 1; n <= 200; ++n) {
        // From a few pairs, many pieces, to nearly all.
        const Analysis a(n, random_pairs(dice, n, n % 5 * n));
        std::vector<int> seen(std::size_t(n), 0);
        for (const int body : a.order) ++seen[std::size_t(body)];
        EXPECT_EQ(seen, std::vector<int>(std::size_t(n), 1)) << n;
    }
}

TEST(Symbolic, IsWhatEliminationProduces)
{
    Dice dice(5);
    for (int n = 1; n <= 120; ++n) {
        const auto pairs = random_pairs(dice, n, n % 4 * n);
        const Analysis a(n, pairs);
        Pattern p = pattern_of(n, pairs);
        for (int j = 0; j < n; ++j) {
            const int body = a.order[std::size_t(j)];
            ASSERT_EQ(a.structure.position[std::size_t(body)], j);
            std::set<int> wanted;
            for (const int other : p[std::size_t(body)])
                wanted.insert(a.structure.position[std::size_t(other)]);
            const auto first = std::size_t(a.structure.first[std::size_t(j)]);
            const auto count = std::size_t(a.structure.first[std::size_t(j) + 1]) - first;
            const auto rows = a.structure.rows.subspan(first, count);
            ASSERT_EQ(std::vector<int>(rows.begin(), rows.end()),
                      std::vector<int>(wanted.begin(), wanted.end()))
                << n << " " << j;
            eliminate(p, body);
        }
    }
}

TEST(Ordering, FillsHardlyMoreThanExactMinimumDegree)
{
    Dice dice(6);
    for (const int n : {20, 60, 150}) {
        for (int times = 1; times <= 3; ++times) {
            const auto pairs = random_pairs(dice, n, times * n);
            const int exact = fill_of_exact_minimum_degree(pattern_of(n, pairs));
            EXPECT_LE(int(Analysis(n, pairs).structure.rows.size()), exact + exact / 10 + 3) << n;
        }
    }
    for (const int side : {5, 10, 16}) {
        const int exact = fill_of_exact_minimum_degree(pattern_of(side * side, grid_of(side)));
        EXPECT_LE(int(Analysis(side * side, grid_of(side)).structure.rows.size()), exact + exact / 10)
            << side;
    }
}

TEST(Ordering, ATreeFillsNothing)
{
    const int n = 100;
    std::vector<BodyPair> pairs;
    for (int i = 1; i < n; ++i) pairs.push_back({i, (i - 1) / 3});
    EXPECT_EQ(Analysis(n, pairs).structure.rows.size(), std::size_t(n - 1));
}

TEST(Ordering, AChainIsEatenFromBothEndsWithoutFill)
{
    const int n = 1001;
    const Analysis a(n, chain_of(n));
    EXPECT_EQ(a.structure.rows.size(), std::size_t(n - 1));
    std::vector<int> height(std::size_t(n), 1);
    for (int k = 0; k + 1 < n; ++k) {
        const auto parent = std::size_t(a.structure.rows[std::size_t(a.structure.first[std::size_t(k)])]);
        height[parent] = std::max(height[parent], height[std::size_t(k)] + 1);
    }
    EXPECT_LE(height.back(), n / 2 + 2);
}

}  // namespace
