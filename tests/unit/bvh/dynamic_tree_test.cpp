// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The tree of boxes against a list of boxes.
#include "bvh/dynamic_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "../math/random_numbers.h"

namespace epode {
namespace {

struct Entry {
    int leaf;
    Aabb box;
};

Aabb random_box(RandomNumbers& random)
{
    const Vec3 c = 10 * random.vec(), e = abs(random.vec()) * random.in(Real(0.1), 2);
    return {c - e, c + e};
}

std::vector<int> ask(const DynamicTree& tree, const Aabb& box)
{
    std::vector<int> found;
    tree.query(box, [&](int item) { found.push_back(item); });
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<int> ask(const std::vector<Entry>& entries, const Aabb& box)
{
    std::vector<int> found;
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (entries[i].leaf >= 0 && overlap(entries[i].box, box)) found.push_back(int(i));
    return found;
}

Entry random_leaf(DynamicTree& tree, RandomNumbers& random, int item)
{
    const Aabb box = random_box(random);
    return {tree.insert_loose(box, item), box};
}

void shift(DynamicTree& tree, Entry& entry, Vec3 way)
{
    entry.box = {entry.box.lo + way, entry.box.hi + way};
    tree.set_box(entry.leaf, entry.box);
}

TEST(DynamicTree, finds_what_a_list_finds_through_random_changes)
{
    RandomNumbers random(1);
    DynamicTree tree;
    std::vector<Entry> entries(200, Entry{-1, {}});
    for (int step = 0; step < 6000; ++step) {
        const int i = random.below(200);
        Entry& entry = entries[std::size_t(i)];
        entry.box = random_box(random);
        if (entry.leaf < 0) {
            entry.leaf = tree.insert(entry.box, i);
        } else if (random.below(3) == 0) {
            tree.remove(entry.leaf);
            entry.leaf = -1;
        } else {
            tree.move(entry.leaf, entry.box);
        }
        const Aabb box = random_box(random);
        ASSERT_EQ(ask(tree, box), ask(entries, box)) << "step " << step;
    }
}

TEST(DynamicTree, loose_insertion_and_rebuild_give_the_same_answers)
{
    RandomNumbers random(2);
    DynamicTree tree;
    std::vector<Entry> entries;
    for (int i = 0; i < 500; ++i) entries.push_back(random_leaf(tree, random, i));
    EXPECT_FALSE(tree.sound());
    ASSERT_TRUE(tree.rebuild());
    EXPECT_TRUE(tree.sound());
    for (int k = 0; k < 200; ++k) {
        const Aabb box = random_box(random);
        ASSERT_EQ(ask(tree, box), ask(entries, box));
    }
}

// Boxes move by little, with leaps and newcomers between: mostly refitted, built again when the tree has become bad.
TEST(DynamicTree, boxes_that_move_together_are_found_after_settling)
{
    RandomNumbers random(4);
    DynamicTree tree;
    std::vector<Entry> entries;
    const auto add = [&] { entries.push_back(random_leaf(tree, random, int(entries.size()))); };
    for (int i = 0; i < 300; ++i) add();
    int kept = 0;
    for (int round = 0; round < 120; ++round) {
        if (round % 40 == 20) add();
        for (Entry& entry : entries) shift(tree, entry, (round % 30 == 29 ? 5 : Real(0.05)) * random.vec());
        if (round % 7 == 3) tree.move(entries[5].leaf, entries[5].box = random_box(random));
        EXPECT_FALSE(tree.sound());
        const int top = tree.root(), below = tree.child(top);
        ASSERT_TRUE(tree.settle());
        EXPECT_TRUE(tree.sound());
        kept += tree.root() == top && tree.child(top) == below;
        for (int k = 0; k < 20; ++k) {
            const Aabb box = random_box(random);
            ASSERT_EQ(ask(tree, box), ask(entries, box));
        }
    }
    EXPECT_GT(kept, 60);
}

// What flies apart gets a new tree: the surface of all inner boxes stays near that of one built from above.
TEST(DynamicTree, does_not_wear_out)
{
    RandomNumbers random(5);
    DynamicTree tree;
    std::vector<Entry> entries;
    for (int i = 0; i < 400; ++i) entries.push_back(random_leaf(tree, random, i));
    ASSERT_TRUE(tree.settle());
    const auto surface = [](const DynamicTree& t) {
        Real sum = 0;
        const auto add = [&](const auto& self, int node) -> void {
            if (t.is_leaf(node)) return;
            const Vec3 s = t.box(node).hi - t.box(node).lo;
            sum += s.x * s.y + s.y * s.z + s.z * s.x;
            self(self, t.child(node)), self(self, t.other(node));
        };
        add(add, t.root());
        return sum;
    };
    for (int round = 0; round < 60; ++round) {
        for (Entry& entry : entries) shift(tree, entry, Real(0.2) * random.vec());
        ASSERT_TRUE(tree.settle());
        DynamicTree fresh;
        for (std::size_t i = 0; i < entries.size(); ++i) (void)fresh.insert_loose(entries[i].box, int(i));
        ASSERT_TRUE(fresh.rebuild());
        EXPECT_LT(surface(tree), Real(1.4) * surface(fresh));
    }
}

TEST(DynamicTree, pairs_are_those_of_a_query_for_each_leaf)
{
    RandomNumbers random(3);
    DynamicTree tree;
    std::vector<Entry> entries;
    for (int i = 0; i < 400; ++i) {
        const Aabb box = random_box(random);
        entries.push_back({tree.insert(box, i), box});
    }
    std::vector<std::pair<int, int>> expected;
    for (int i = 0; i < 400; ++i)
        for (int other : ask(entries, entries[std::size_t(i)].box))
            if (other < i) expected.push_back({other, i});
    std::sort(expected.begin(), expected.end());
    EXPECT_GT(expected.size(), 50u);
    for (const int wanted : {1, 2, 64, 1000000}) {
        std::vector<std::pair<int, int>> found;
        Array<NodePair> pieces;
        ASSERT_TRUE(tree.split_pairs(wanted, pieces));
        EXPECT_GE(pieces.size(), std::min(wanted, 400));
        for (const NodePair& piece : pieces)
            tree.query_pairs(piece, [&](int a, int b) { found.push_back(std::minmax(a, b)); });
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, expected) << wanted;
    }
}

TEST(DynamicTree, stays_low_when_boxes_come_in_a_row)
{
    DynamicTree tree;
    for (int i = 0; i < 3000; ++i) (void)tree.insert({{Real(i), 0, 0}, {Real(i) + 1, 1, 1}}, i);
    EXPECT_LE(tree.height(), 60);
    EXPECT_EQ(ask(tree, {{Real(0.5), 0, 0}, {Real(1.5), 1, 1}}), (std::vector<int>{0, 1}));
}

TEST(DynamicTree, bears_many_equal_boxes)
{
    DynamicTree tree;
    for (int i = 0; i < 2000; ++i) (void)tree.insert_loose({{0, 0, 0}, {1, 1, 1}}, i);
    ASSERT_TRUE(tree.rebuild());
    EXPECT_LE(tree.height(), 40);
    EXPECT_EQ(ask(tree, {{1, 1, 1}, {2, 2, 2}}).size(), 2000u);
    EXPECT_TRUE(ask(tree, {{Real(1.01), 1, 1}, {2, 2, 2}}).empty());
}

TEST(DynamicTree, knows_which_boxes_it_can_hold)
{
    EXPECT_TRUE(bounded({{-1, -1, -1}, {1, 1, 1}}));
    EXPECT_TRUE(bounded({{1, 1, 1}, {1, 1, 1}}));
    EXPECT_FALSE(bounded({{-kInf, -1, -1}, {1, 1, 1}}));
    EXPECT_FALSE(bounded({{-1, -1, 2}, {1, 1, 1}}));
    EXPECT_FALSE(bounded({{-1, -1, -1}, {1, 1, std::numeric_limits<Real>::quiet_NaN()}}));
}

}  // namespace
}  // namespace epode
