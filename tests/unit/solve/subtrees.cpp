// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where trees are cut for several threads.
#include "solve/exact/factor/subtrees.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "base/random.h"

namespace {

using namespace epode;

struct Cut {
    Arena arena;
    std::vector<int> parent;
    std::vector<double> weight;
    std::span<int> subtree_of;
    int count = -1;

    Cut(std::vector<int> parents, std::vector<double> weights)
        : parent(std::move(parents)), weight(std::move(weights))
    {
        EXPECT_TRUE(cut_subtrees({parent, weight}, arena, subtree_of, count));
    }

    // Every subtree is whole: below its root nothing is missing, and what is above is in none.
    void check() const
    {
        std::map<int, int> root;
        for (int s = 0; s < int(parent.size()); ++s) {
            const int t = subtree_of[std::size_t(s)], up = parent[std::size_t(s)];
            ASSERT_GE(t, -1);
            ASSERT_LT(t, count);
            const int above = up < 0 ? -1 : subtree_of[std::size_t(up)];
            if (above >= 0) {
                ASSERT_EQ(t, above);
            } else if (t >= 0) {
                ASSERT_TRUE(root.emplace(t, s).second) << "two roots";
            }
        }
        ASSERT_EQ(int(root.size()), count);
    }

    double share(int t) const
    {
        double of = 0, all = 0;
        for (std::size_t s = 0; s < parent.size(); ++s) {
            all += weight[s];
            if (subtree_of[s] == t) of += weight[s];
        }
        return of / all;
    }
};

TEST(Subtrees, small_trees_stay_whole)
{
    const Cut cut({2, 2, -1}, {10, 10, 10});
    EXPECT_EQ(cut.count, 0);
    EXPECT_EQ(cut.share(-1), 1);
}

TEST(Subtrees, a_chain_eaten_from_both_ends_is_two_halves)
{
    const int n = 4001;
    std::vector<int> parent;
    for (int s = 0; s < n; ++s) parent.push_back(s + 2 < n ? s + 2 : s + 1 < n ? s + 1 : -1);
    const Cut cut(parent, std::vector<double>(n, 3));
    cut.check();
    EXPECT_EQ(cut.count, 2);
    EXPECT_LT(cut.share(-1), 0.01);
    EXPECT_NEAR(cut.share(0), 0.5, 0.01);
}

TEST(Subtrees, a_balanced_tree_gives_work_for_many)
{
    const int n = 1023;  // the heap order backwards: children before parents
    std::vector<int> parent;
    for (int s = 0; s < n; ++s) parent.push_back(s == n - 1 ? -1 : n - 1 - (n - 1 - s - 1) / 2);
    const Cut cut(parent, std::vector<double>(n, 20));
    cut.check();
    EXPECT_GE(cut.count, 4);
    EXPECT_LT(cut.share(-1), 0.05);
    for (int t = 0; t < cut.count; ++t) EXPECT_LT(cut.share(t), 0.3);
}

TEST(Subtrees, any_forest_is_cut_into_whole_subtrees)
{
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        CounterRandom dice(seed);
        const int n = 1 + int(dice.next() % 400);
        std::vector<int> parent;
        std::vector<double> weight;
        for (int s = 0; s < n; ++s) {
            const int reach = 1 + int(dice.next() % (1 + seed % 40));
            parent.push_back(s + reach < n ? s + reach : -1);
            weight.push_back(double(dice.next() % 1000));
        }
        const Cut cut(parent, weight);
        cut.check();
        EXPECT_NE(cut.count, 1);
        EXPECT_LE(cut.count, 32);
    }
}

}  // namespace
