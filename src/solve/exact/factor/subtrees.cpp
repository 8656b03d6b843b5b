// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// From the roots down, the heaviest subtree is replaced by its branches (Geist & Ng, Int. J. Parallel
// Program. 18, 1989) until all are light enough to be shared out. The fronts above the point where it
// branches then wait for all subtrees; this is worth it while they weigh less than the time that working on
// the branches in parallel saves. A chain stays in its two halves, because going down one of them only moves
// work above. Branches too light for a thread of their own stay above.
#include "solve/exact/factor/subtrees.h"

#include <algorithm>

namespace epode {
namespace {

constexpr double kWorth = 6000;    // weight from which a tree is cut: about a tenth of a millisecond
constexpr int kMaxSubtrees = 32;   // subtrees
constexpr double kLight = 1 / 4.;  // of the whole: no need to divide
constexpr double kWorthy = 0.6;    // weight moved above per weight that runs in parallel
constexpr double kTiny = 1 / 64.;  // of the whole, not worth a subtree

class Cutter {
  public:
    bool cut(const FrontTree& tree, Arena& arena, std::span<int>& subtree_of, int& count)
    {
        const int n = int(tree.parent.size());
        subtree_of = arena.take<int>(n);
        count = 0;
        if (arena.failed()) return false;
        std::fill(subtree_of.begin(), subtree_of.end(), -1);
        whole_ = 0;
        for (const double w : tree.weight) whole_ += w;
        if (whole_ < kWorth) return true;
        if (!prepare(tree, arena)) return false;
        divide();
        if (count_ < 2) return true;
        // Numbered in the order of their roots, and inherited downwards.
        std::sort(roots_, roots_ + count_);
        for (int t = 0; t < count_; ++t) subtree_of[std::size_t(roots_[t])] = t;
        for (int s = n - 1; s >= 0; --s) {
            const int up = tree.parent[std::size_t(s)];
            if (up >= 0 && subtree_of[std::size_t(up)] >= 0)
                subtree_of[std::size_t(s)] = subtree_of[std::size_t(up)];
        }
        count = count_;
        return true;
    }

  private:
    bool prepare(const FrontTree& tree, Arena& arena)
    {
        const int n = int(tree.parent.size());
        total_ = arena.take<double>(n);
        child_ = arena.take<int>(n), sibling_ = arena.take<int>(n);
        if (arena.failed()) return false;
        std::fill(child_.begin(), child_.end(), -1);
        std::copy(tree.weight.begin(), tree.weight.end(), total_.begin());
        for (int s = 0; s < n; ++s) {
            const int up = tree.parent[std::size_t(s)];
            if (up < 0) {
                sibling_[std::size_t(s)] = -1;
                add(s);
                continue;
            }
            total_[std::size_t(up)] += total_[std::size_t(s)];
            sibling_[std::size_t(s)] = child_[std::size_t(up)];
            child_[std::size_t(up)] = s;
        }
        return true;
    }

    void add(int s)
    {
        if (count_ < kMaxSubtrees && total_[std::size_t(s)] >= kTiny * whole_) roots_[count_++] = s;
    }

    void divide()
    {
        int whole_ones = 0;  // roots_[0 .. whole_ones) are not divided any further
        while (whole_ones < count_) {
            const auto lighter = [this](int a, int b) {
                return total_[std::size_t(a)] < total_[std::size_t(b)];
            };
            int& root = *std::max_element(roots_ + whole_ones, roots_ + count_, lighter);
            if (total_[std::size_t(root)] <= kLight * whole_) return;
            const int branching = find_branching(root);
            if (branching < 0) {
                std::swap(root, roots_[whole_ones++]);
                continue;
            }
            root = roots_[--count_];
            for (int c = child_[std::size_t(branching)]; c >= 0; c = sibling_[std::size_t(c)]) add(c);
        }
    }

    // The first front at or below the root with two children that are worth a thread; -1: there is none, or
    // it is not worth it.
    int find_branching(int root) const
    {
        for (int s = root; s >= 0;) {
            double branches = 0;
            int worthy = 0, heaviest = child_[std::size_t(s)];
            for (int c = heaviest; c >= 0; c = sibling_[std::size_t(c)]) {
                if (total_[std::size_t(c)] >= kTiny * whole_) ++worthy, branches += total_[std::size_t(c)];
                if (total_[std::size_t(c)] > total_[std::size_t(heaviest)]) heaviest = c;
            }
            if (worthy < 2) {
                s = heaviest;
                continue;
            }
            const double all = total_[std::size_t(root)], largest = total_[std::size_t(heaviest)];
            return all - branches < kWorthy * (all - largest) ? s : -1;
        }
        return -1;
    }

    double whole_ = 0;
    std::span<double> total_;  // weight of the subtree
    std::span<int> child_, sibling_;
    int roots_[kMaxSubtrees];
    int count_ = 0;
};

}  // namespace

bool cut_subtrees(const FrontTree& tree, Arena& arena, std::span<int>& subtree_of, int& count)
{
    return Cutter().cut(tree, arena, subtree_of, count);
}

}  // namespace epode
