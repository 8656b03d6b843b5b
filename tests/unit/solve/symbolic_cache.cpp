// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Plans are found again exactly when the pairs are the same, and hold what a fresh analysis finds.
#include "solve/exact/factor/symbolic_cache.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <vector>

#include "systems.h"

namespace {

using namespace epode_test;
using Pairs = std::vector<BodyPair>;

Pairs chain_of(int n)
{
    Pairs pairs;
    for (int i = 1; i < n; ++i) pairs.push_back({i - 1, i});
    return pairs;
}

const SymbolicFactor* known(SymbolicCache& cache, int n, const Pairs& pairs)
{
    Arena arena;
    BodyGraph graph;
    EXPECT_TRUE(build_body_graph(n, pairs, arena, graph));
    const SymbolicFactor* symbolic = cache.borrow(graph);
    if (symbolic) cache.give_back(*symbolic);
    return symbolic;
}

void use(SymbolicCache& cache, int n, const Pairs& pairs)
{
    Arena arena;
    SymbolicLease lease;
    ASSERT_TRUE(lease.take(n, pairs, &cache, arena));
}

bool same(std::span<const int> a, std::span<const int> b) { return std::ranges::equal(a, b); }

TEST(SymbolicCache, knows_what_it_has_seen)
{
    SymbolicCache cache;
    Pairs pairs = chain_of(20);
    EXPECT_FALSE(known(cache, 20, pairs));
    use(cache, 20, pairs);
    EXPECT_TRUE(known(cache, 20, pairs));
    // The same pairs in another order, turned round and repeated.
    std::reverse(pairs.begin(), pairs.end());
    std::swap(pairs[3].a, pairs[3].b);
    pairs.push_back(pairs[5]);
    pairs.push_back({7, 7});
    EXPECT_TRUE(known(cache, 20, pairs));
    pairs.push_back({0, 19});
    EXPECT_FALSE(known(cache, 20, pairs));
    EXPECT_FALSE(known(cache, 21, chain_of(20)));
}

TEST(SymbolicCache, holds_what_an_analysis_finds)
{
    Dice dice(3);
    SymbolicCache cache;
    for (int round = 0; round < 10; ++round) {
        const int n = 10 + 5 * round;
        Pairs pairs;
        for (int i = 0; i < 2 * n; ++i) pairs.push_back({dice.below(n), dice.below(n)});
        use(cache, n, pairs);
        Arena arena;
        SymbolicLease fresh, found;
        ASSERT_TRUE(fresh.take(n, pairs, nullptr, arena));
        ASSERT_TRUE(found.take(n, pairs, &cache, arena));
        ASSERT_NE(&fresh.symbolic(), &found.symbolic());
        const SymbolicFactor &a = fresh.symbolic(), &b = found.symbolic();
        EXPECT_EQ(a.bodies, b.bodies);
        EXPECT_EQ(a.blocks, b.blocks);
        EXPECT_TRUE(same(a.position, b.position) && same(a.front_of, b.front_of) && same(a.rows, b.rows) &&
                    same(a.places, b.places));
        ASSERT_EQ(a.fronts.size(), b.fronts.size());
        for (std::size_t s = 0; s < a.fronts.size(); ++s)
            EXPECT_TRUE(a.fronts[s].block == b.fronts[s].block && a.fronts[s].updates == b.fronts[s].updates);
        ASSERT_EQ(a.updates.size(), b.updates.size());
        for (std::size_t u = 0; u < a.updates.size(); ++u)
            EXPECT_TRUE(a.updates[u].target == b.updates[u].target &&
                        a.updates[u].place == b.updates[u].place);
    }
}

TEST(SymbolicCache, forgets_the_least_recently_used)
{
    SymbolicCache cache;
    for (int k = 0; k < SymbolicCache::kEntries; ++k) use(cache, 10 + k, chain_of(10 + k));
    use(cache, 10, chain_of(10));
    use(cache, 500, chain_of(500));
    EXPECT_TRUE(known(cache, 10, chain_of(10)));
    EXPECT_FALSE(known(cache, 11, chain_of(11)));
    EXPECT_TRUE(known(cache, 500, chain_of(500)));
}

TEST(SymbolicCache, never_takes_a_factor_from_its_borrower)
{
    SymbolicCache cache;
    Arena arena;
    use(cache, 10, chain_of(10));
    SymbolicLease lease;
    ASSERT_TRUE(lease.take(10, chain_of(10), &cache, arena));
    const std::vector<int> before(lease.symbolic().position.begin(), lease.symbolic().position.end());
    for (int n = 100; n < 100 + 3 * SymbolicCache::kEntries; ++n) use(cache, n, chain_of(n));
    EXPECT_TRUE(same(lease.symbolic().position, before));
    EXPECT_TRUE(known(cache, 10, chain_of(10)));
}

TEST(SymbolicCache, serves_several_threads)
{
    SymbolicCache cache;
    std::vector<std::thread> threads;
    std::vector<int> wrong(4, 0);
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&cache, &wrong, t] {
            for (int round = 0; round < 300; ++round) {
                const int n = 5 + (round * (t + 1)) % 40;
                Arena arena;
                SymbolicLease lease;
                if (!lease.take(n, chain_of(n), &cache, arena) || lease.symbolic().bodies != n ||
                    lease.symbolic().position.size() != std::size_t(n))
                    ++wrong[std::size_t(t)];
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

}  // namespace
