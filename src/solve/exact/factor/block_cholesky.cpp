// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Right-looking by fronts: a front is factored as a dense matrix, then its outer product B B^T is subtracted,
// block by block, directly from the fronts that own its rows. A multifrontal method would first collect the
// products in a matrix per front and pass it up the tree: the same arithmetic, and a stack of copies.
#include "solve/exact/factor/block_cholesky.h"

#include <algorithm>

namespace epode {
namespace {

constexpr int kHeavy = 1500;  // so many block products are worth several threads

}  // namespace

bool BlockCholesky::prepare(const SymbolicFactor& symbolic, const Tasks& tasks, Arena& arena)
{
    symbolic_ = &symbolic;
    kernels_ = front_kernels().back();
    blocks_ = arena.take<double>(kBlock * symbolic.blocks);
    work_ = arena.take<double>(6 * symbolic.columns);
    bad_ = arena.take<int>(int(symbolic.subtrees.size()));
    tasks_ = tasks;
    return !arena.failed();
}

double* BlockCholesky::diagonal(int body)
{
    const int at = symbolic_->position[std::size_t(body)];
    return blocks_.data() + kBlock * std::size_t(symbolic_->block_at(at, at));
}

double* BlockCholesky::between(int a, int b, bool& transposed)
{
    int row = symbolic_->position[std::size_t(a)], column = symbolic_->position[std::size_t(b)];
    transposed = row < column;
    if (transposed) std::swap(row, column);
    return blocks_.data() + kBlock * std::size_t(symbolic_->block_at(row, column));
}

void BlockCholesky::clear() { std::fill(blocks_.begin(), blocks_.end(), 0.0); }

FrontLists BlockCholesky::lists() const
{
    const auto& entries = symbolic_->entries.empty() ? symbolic_->rows : symbolic_->entries;
    return {symbolic_->fronts.data(), entries.data(), symbolic_->updates.data(), symbolic_->places.data()};
}

// A single thread works through all subtrees together: the arithmetic of one fills the time in which another
// waits for its own results.
template <typename Work>
void BlockCholesky::for_subtrees(Work work) const
{
    if (tasks_.workers() == 1) {
        work(0, FrontRange{nullptr, 0, symbolic_->top});
        return;
    }
    const int count = int(symbolic_->subtrees.size());
    tasks_.for_each(count, [&](int t, int) {
        const Subtree& subtree = symbolic_->subtrees[std::size_t(t)];
        work(t, FrontRange{symbolic_->subtree_fronts.data(), subtree.fronts, subtree.fronts + subtree.count});
    });
}

int BlockCholesky::factor()
{
    std::fill(bad_.begin(), bad_.end(), 0);
    for_subtrees([this](int t, FrontRange range) {
        const int bad = kernels_->factor(lists(), range, blocks_.data());
        if (!bad_.empty()) bad_[std::size_t(t)] = bad;
    });
    int bad = 0;
    for (const int b : bad_) bad += b;
    for (const Subtree& subtree : symbolic_->subtrees)
        kernels_->add_border(lists(), subtree.border, blocks_.data());
    return bad + factor_top();
}

int BlockCholesky::factor_top()
{
    if (tasks_.workers() == 1)
        return kernels_->factor(lists(), {nullptr, symbolic_->top, symbolic_->end}, blocks_.data());
    int bad = 0;
    for (int s = symbolic_->top; s < symbolic_->end; ++s) {
        const Front& f = symbolic_->fronts[std::size_t(s)];
        if (f.width * f.below * (f.below + 1) / 2 < kHeavy) {
            bad += kernels_->factor(lists(), {nullptr, s, s + 1}, blocks_.data());
            continue;
        }
        bad += kernels_->factor_columns(lists(), s, blocks_.data());
        tasks_.for_each((f.below + 1) / 2, [&](int piece, int) {
            kernels_->subtract_outer(lists(), s, 2 * piece, std::min(2 * piece + 2, f.below), blocks_.data());
        });
    }
    return bad;
}

// visit(row, entry) for the six numbers of every row of a border and of its entry, subtree after subtree.
template <typename Visit>
void BlockCholesky::for_borders(Visit visit)
{
    for (const Subtree& subtree : symbolic_->subtrees) {
        const int* rows = symbolic_->rows.data() + symbolic_->fronts[std::size_t(subtree.root)].rows;
        const Front& border = symbolic_->fronts[std::size_t(subtree.border)];
        for (int k = 0; k < border.width; ++k)
            visit(work_.data() + 6 * rows[k], work_.data() + 6 * (border.first + k));
    }
}

void BlockCholesky::solve(std::span<double> x)
{
    double* work = work_.data();
    for (int body = 0; body < symbolic_->bodies; ++body)
        std::copy_n(x.data() + 6 * body, 6, work + 6 * symbolic_->position[std::size_t(body)]);
    std::fill(work + 6 * symbolic_->bodies, work + work_.size(), 0.0);
    const FrontRange top{nullptr, symbolic_->top, symbolic_->end};
    for_subtrees([&](int, FrontRange range) { kernels_->forward(lists(), range, blocks_.data(), work); });
    for_borders([](double* row, const double* border) {
        for (int i = 0; i < 6; ++i) row[i] += border[i];
    });
    kernels_->forward(lists(), top, blocks_.data(), work);
    kernels_->backward(lists(), top, blocks_.data(), work);
    for_borders([](const double* row, double* border) { std::copy_n(row, 6, border); });
    for_subtrees([&](int, FrontRange range) { kernels_->backward(lists(), range, blocks_.data(), work); });
    for (int body = 0; body < symbolic_->bodies; ++body)
        std::copy_n(work + 6 * symbolic_->position[std::size_t(body)], 6, x.data() + 6 * body);
}

}  // namespace epode
