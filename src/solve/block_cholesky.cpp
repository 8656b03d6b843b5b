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

FrontLists BlockCholesky::lists() const
{
    return {plan_->fronts.data(), plan_->rows.data(), plan_->updates.data(), plan_->places.data()};
}

int BlockCholesky::factor()
{
    return kernels_->factor(lists(), 0, int(plan_->fronts.size()), blocks_.data());
}

void BlockCholesky::solve(std::span<double> x)
{
    double* work = work_.data();
    const int fronts = int(plan_->fronts.size());
    for (int body = 0; body < plan_->bodies; ++body)
        std::copy_n(x.data() + 6 * body, 6, work + 6 * plan_->position[std::size_t(body)]);
    kernels_->forward(lists(), 0, fronts, blocks_.data(), work);
    kernels_->backward(lists(), 0, fronts, blocks_.data(), work);
    for (int body = 0; body < plan_->bodies; ++body)
        std::copy_n(work + 6 * plan_->position[std::size_t(body)], 6, x.data() + 6 * body);
}

}  // namespace epode
