// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Right-looking by fronts: a front is factored as a dense matrix, then its outer product is subtracted, block
// by block, straight from the fronts that own its rows. A multifrontal method would first gather the
// products in a matrix per front and pass it up the tree: the same arithmetic, and a stack of copies.
#include "solve/block_cholesky.h"

#include <algorithm>

namespace epode {

bool BlockCholesky::prepare(const FactorPlan& plan, Arena& arena)
{
    plan_ = &plan;
    kernels_ = front_kernels().back();
    blocks_ = arena.take<double>(kBlock * plan.blocks);
    work_ = arena.take<double>(6 * plan.bodies);
    return !arena.failed();
}

double* BlockCholesky::diagonal(int body)
{
    const int at = plan_->position[std::size_t(body)];
    return blocks_.data() + kBlock * std::size_t(plan_->block_at(at, at));
}

double* BlockCholesky::between(int a, int b, bool& transposed)
{
    int row = plan_->position[std::size_t(a)], column = plan_->position[std::size_t(b)];
    transposed = row < column;
    if (transposed) std::swap(row, column);
    return blocks_.data() + kBlock * std::size_t(plan_->block_at(row, column));
}

void BlockCholesky::clear() { std::fill(blocks_.begin(), blocks_.end(), 0.0); }

int BlockCholesky::factor()
{
    int bad = 0;
    for (const Front& f : plan_->fronts) {
        bad += kernels_->factor(blocks_of(f), f.width, f.width + f.below);
        subtract_outer(f);
    }
    return bad;
}

void BlockCholesky::subtract_outer(const Front& f)
{
    for (int u = f.updates; u < f.updates + f.update_count; ++u) {
        const FrontUpdate& update = plan_->updates[std::size_t(u)];
        const Front& target = plan_->fronts[std::size_t(update.target)];
        kernels_->update(blocks_of(f) + kBlock * (f.width + update.begin) * f.width, f.width, update.columns,
                         f.below - update.begin, &plan_->places[std::size_t(update.place)],
                         blocks_of(target), target.width);
    }
}

void BlockCholesky::solve(std::span<double> x)
{
    double* work = work_.data();
    const int* rows = plan_->rows.data();
    for (int body = 0; body < plan_->bodies; ++body)
        std::copy_n(x.data() + 6 * body, 6, work + 6 * plan_->position[std::size_t(body)]);
    for (const Front& f : plan_->fronts)
        kernels_->forward(blocks_of(f), f.width, f.width + f.below, rows + f.rows, work + 6 * f.first, work);
    for (std::size_t s = plan_->fronts.size(); s-- > 0;) {
        const Front& f = plan_->fronts[s];
        kernels_->backward(blocks_of(f), f.width, f.width + f.below, rows + f.rows, work + 6 * f.first, work);
    }
    for (int body = 0; body < plan_->bodies; ++body)
        std::copy_n(work + 6 * plan_->position[std::size_t(body)], 6, x.data() + 6 * body);
}

}  // namespace epode
