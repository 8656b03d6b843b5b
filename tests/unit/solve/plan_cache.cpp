// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Plans are found again exactly when the pairs are the same, and hold what a fresh analysis finds.
#include "solve/exact/factor/plan_cache.h"

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

const FactorPlan* known(PlanCache& cache, int n, const Pairs& pairs)
{
    Arena arena;
    BodyGraph graph;
    EXPECT_TRUE(build_body_graph(n, pairs, arena, graph));
    const FactorPlan* plan = cache.borrow(graph);
    if (plan) cache.give_back(*plan);
    return plan;
}

void use(PlanCache& cache, int n, const Pairs& pairs)
{
    Arena arena;
    PlanLease lease;
    ASSERT_TRUE(lease.take(n, pairs, &cache, arena));
}

bool same(std::span<const int> a, std::span<const int> b) { return std::ranges::equal(a, b); }

TEST(PlanCache, KnowsWhatItHasSeen)
{
    PlanCache cache;
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

TEST(PlanCache, HoldsWhatAnAnalysisFinds)
{
    Dice dice(3);
    PlanCache cache;
    for (int round = 0; round < 10; ++round) {
        const int n = 10 + 5 * round;
        Pairs pairs;
        for (int i = 0; i < 2 * n; ++i) pairs.push_back({dice.below(n), dice.below(n)});
        use(cache, n, pairs);
        Arena arena;
        PlanLease fresh, found;
        ASSERT_TRUE(fresh.take(n, pairs, nullptr, arena));
        ASSERT_TRUE(found.take(n, pairs, &cache, arena));
        ASSERT_NE(&fresh.plan(), &found.plan());
        const FactorPlan &a = fresh.plan(), &b = found.plan();
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

TEST(PlanCache, ForgetsTheLeastRecentlyUsed)
{
    PlanCache cache;
    for (int k = 0; k < PlanCache::kEntries; ++k) use(cache, 10 + k, chain_of(10 + k));
    use(cache, 10, chain_of(10));
    use(cache, 500, chain_of(500));
    EXPECT_TRUE(known(cache, 10, chain_of(10)));
    EXPECT_FALSE(known(cache, 11, chain_of(11)));
    EXPECT_TRUE(known(cache, 500, chain_of(500)));
}

TEST(PlanCache, NeverTakesAPlanFromItsBorrower)
{
    PlanCache cache;
    Arena arena;
    use(cache, 10, chain_of(10));
    PlanLease lease;
    ASSERT_TRUE(lease.take(10, chain_of(10), &cache, arena));
    const std::vector<int> before(lease.plan().position.begin(), lease.plan().position.end());
    for (int n = 100; n < 100 + 3 * PlanCache::kEntries; ++n) use(cache, n, chain_of(n));
    EXPECT_TRUE(same(lease.plan().position, before));
    EXPECT_TRUE(known(cache, 10, chain_of(10)));
}

TEST(PlanCache, ServesSeveralThreads)
{
    PlanCache cache;
    std::vector<std::thread> threads;
    std::vector<int> wrong(4, 0);
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&cache, &wrong, t] {
            for (int round = 0; round < 300; ++round) {
                const int n = 5 + (round * (t + 1)) % 40;
                Arena arena;
                PlanLease lease;
                if (!lease.take(n, chain_of(n), &cache, arena) || lease.plan().bodies != n ||
                    lease.plan().position.size() != std::size_t(n))
                    ++wrong[std::size_t(t)];
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

}  // namespace
