// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The body graph, the order of elimination and the structure of the factor, against elimination carried out
// literally on a dense pattern.
#include "solve/exact/factor/ordering.h"

#include <gtest/gtest.h>

#include <set>

#include "solve/exact/factor/symbolic.h"
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
    SymbolicFactor symbolic;

    Analysis(int n, const std::vector<BodyPair>& pairs)
    {
        order = arena.take<int>(n);
        EXPECT_TRUE(build_body_graph(n, pairs, arena, graph));
        EXPECT_TRUE(order_minimum_degree(graph, arena, order));
        EXPECT_TRUE(factor_symbolically(graph, order, arena, symbolic));
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

TEST(BodyGraph, lists_every_neighbour_once_in_order)
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

TEST(BodyGraph, does_not_depend_on_the_order_of_pairs)
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

TEST(Ordering, is_a_permutation_of_any_graph)
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

TEST(Symbolic, fronts_hold_what_elimination_produces)
{
    Dice dice(5);
    for (int n = 1; n <= 120; ++n) {
        const auto pairs = random_pairs(dice, n, n % 4 * n);
        const Analysis a(n, pairs);
        std::vector<int> body_at(std::size_t(n), -1);
        for (int body = 0; body < n; ++body)
            body_at[std::size_t(a.symbolic.position[std::size_t(body)])] = body;
        Pattern p = pattern_of(n, pairs);
        int column = 0, block = 0;
        for (const Front& f : a.symbolic.fronts) {
            ASSERT_EQ(f.first, column);
            ASSERT_EQ(f.block, block);
            block += f.width * (f.width + f.below);
            if (column >= n) {  // a border
                column += f.width;
                continue;
            }
            for (; column < f.first + f.width; ++column) {
                ASSERT_EQ(&a.symbolic.fronts[std::size_t(a.symbolic.front_of[std::size_t(column)])], &f);
                std::set<int> fill;
                for (const int other : p[std::size_t(body_at[std::size_t(column)])])
                    fill.insert(a.symbolic.position[std::size_t(other)]);
                const std::set<int> rows(a.symbolic.rows.begin() + f.rows,
                                         a.symbolic.rows.begin() + f.rows + f.below);
                for (const int row : fill)
                    ASSERT_TRUE((row > column && row < f.first + f.width) || rows.contains(row)) << n;
                // The last column has nothing that is zero.
                if (column == f.first + f.width - 1) { ASSERT_EQ(fill, rows) << n; }
                eliminate(p, body_at[std::size_t(column)]);
            }
        }
        ASSERT_EQ(column, a.symbolic.columns);
        ASSERT_EQ(a.symbolic.columns > n, !a.symbolic.subtrees.empty());
        ASSERT_EQ(block, a.symbolic.blocks);
    }
}

// Column of row i of what an update changes: of a border, that of the subtree's row.
int column_at(const SymbolicFactor& symbolic, int target, int place)
{
    const Front& f = symbolic.fronts[std::size_t(target)];
    if (target >= symbolic.end) {
        const Subtree& subtree = symbolic.subtrees[std::size_t(target - symbolic.end)];
        return symbolic.rows[std::size_t(symbolic.fronts[std::size_t(subtree.root)].rows + place)];
    }
    return place < f.width ? f.first + place : symbolic.rows[std::size_t(f.rows + place - f.width)];
}

TEST(Symbolic, updates_name_every_row_of_every_target)
{
    Dice dice(15);
    int borders = 0;
    std::vector<std::pair<std::vector<BodyPair>, int>> graphs;
    for (int n = 2; n <= 100; n += 7) graphs.push_back({random_pairs(dice, n, 2 * n), n});
    graphs.push_back({chain_of(3000), 3000});
    graphs.push_back({grid_of(28), 28 * 28});
    for (const auto& [pairs, n] : graphs) {
        const Analysis a(n, pairs);
        for (int s = 0; s < int(a.symbolic.fronts.size()); ++s) {
            const bool border = s >= a.symbolic.end;
            borders += border;
            const Front& f = a.symbolic.fronts[std::size_t(s)];
            const Front& of =
                border ? a.symbolic
                             .fronts[std::size_t(a.symbolic.subtrees[std::size_t(s - a.symbolic.end)].root)]
                       : f;
            int begin = 0;
            for (int u = f.updates; u < f.updates + f.update_count; ++u) {
                const FrontUpdate& update = a.symbolic.updates[std::size_t(u)];
                // From inside a subtree nothing outside is touched.
                ASSERT_TRUE(border || s >= a.symbolic.top || update.target < a.symbolic.top ||
                            update.target >= a.symbolic.end);
                ASSERT_EQ(update.begin, begin);
                for (int i = begin; i < of.below; ++i) {
                    const int place = a.symbolic.places[std::size_t(update.place + i - begin)];
                    ASSERT_EQ(column_at(a.symbolic, update.target, place),
                              a.symbolic.rows[std::size_t(of.rows + i)]);
                    ASSERT_EQ(i < begin + update.columns,
                              place < a.symbolic.fronts[std::size_t(update.target)].width);
                }
                begin += update.columns;
            }
            ASSERT_EQ(begin, of.below);
        }
    }
    EXPECT_GE(borders, 4);
}

// Entries of the factor below the diagonal when bodies are eliminated in this order.
int fill_of(Pattern p, std::span<const int> order)
{
    int total = 0;
    for (const int body : order) {
        total += int(p[std::size_t(body)].size());
        eliminate(p, body);
    }
    return total;
}

TEST(Ordering, fills_hardly_more_than_exact_minimum_degree)
{
    Dice dice(6);
    for (const int n : {20, 60, 150}) {
        for (int times = 1; times <= 3; ++times) {
            const auto pairs = random_pairs(dice, n, times * n);
            const int exact = fill_of_exact_minimum_degree(pattern_of(n, pairs));
            EXPECT_LE(fill_of(pattern_of(n, pairs), Analysis(n, pairs).order), exact + exact / 10 + 3) << n;
        }
    }
    for (const int side : {5, 10, 16}) {
        const Pattern p = pattern_of(side * side, grid_of(side));
        EXPECT_LE(fill_of(p, Analysis(side * side, grid_of(side)).order),
                  fill_of_exact_minimum_degree(p) * 11 / 10)
            << side;
    }
}

TEST(Ordering, a_tree_fills_nothing)
{
    const int n = 100;
    std::vector<BodyPair> pairs;
    for (int i = 1; i < n; ++i) pairs.push_back({i, (i - 1) / 3});
    EXPECT_EQ(fill_of(pattern_of(n, pairs), Analysis(n, pairs).order), n - 1);
}

TEST(Ordering, a_chain_is_eaten_from_both_ends_without_fill)
{
    const int n = 1001;
    const Analysis a(n, chain_of(n));
    EXPECT_EQ(fill_of(pattern_of(n, chain_of(n)), a.order), n - 1);
    std::vector<int> height(a.symbolic.fronts.size(), 1);
    for (std::size_t s = 0; s < a.symbolic.fronts.size(); ++s) {
        const Front& f = a.symbolic.fronts[s];
        if (!f.below) continue;
        const auto parent =
            std::size_t(a.symbolic.front_of[std::size_t(a.symbolic.rows[std::size_t(f.rows)])]);
        ASSERT_GT(parent, s);
        height[parent] = std::max(height[parent], height[s] + 1);
    }
    EXPECT_LE(height.back(), n / 2 + 2);
}

}  // namespace
