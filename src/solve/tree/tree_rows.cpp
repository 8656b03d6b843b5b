// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The rows of a tree: which of them only yield, what each moves, and the problem that all others make.
#include "solve/tree/tree_solve.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

// Without any compliance a load has many distributions over redundant contacts (solve/exact/frozen_friction.cpp).
constexpr double kLeastCompliance = sizeof(Real) == 8 ? 1e-8 : 1e-6;

}  // namespace

bool TreeSolve::collect(Arena& arena)
{
    const int m = int(system_->rows.size());
    rows_ = arena.take<TreeRow>(m), yields_ = arena.take<Yield>(m), row_of_source_ = arena.take<int>(m);
    if (arena.failed()) return false;
    std::size_t rows = 0, yields = 0;
    std::fill(row_of_source_.begin(), row_of_source_.end(), -1);
    const std::span<Yield> all = yields_;
    for (std::size_t k = 0; k < system_->blocks.size(); ++k) {
        const RowBlock& block = system_->blocks[k];
        const bool of_joint = !block.contact && block.term_count == 0;
        const TreeLink* const branch = of_joint ? tree_->branch(*system_, int(k)) : nullptr;
        const int first = branch != nullptr ? lock_rows(branch->joint) : 0;
        for (int i = block.first + first; i < block.first + block.count; ++i) {
            yields_ = all.first(yields + 1);
            if (take_yield(block, i)) {
                ++yields;
                continue;
            }
            row_of_source_[std::size_t(i)] = int(rows);
            rows_[rows++] = {i, int(k), 1};
        }
    }
    rows_ = rows_.first(rows), yields_ = all.first(yields);
    return true;
}

bool TreeSolve::is_joint_of(int link, int parent) const
{
    if (link < 0) return false;
    const TreeLink& its = tree_->link(link);
    return its.parent == parent && its.joint != LinkJoint::kFree;
}

// Between a link and its parent only the link's own dofs move.
bool TreeSolve::take_yield(const RowBlock& block, int source)
{
    const RowNumbers& n = system_->numbers[std::size_t(source)];
    if (closing_[std::size_t(source)]) return false;
    if (block.contact || block.term_count > 0 || n.bounded() || n.parent >= 0 || !(n.C > 0)) return false;
    const int a = tree_->link_of_body(block.body1), b = tree_->link_of_body(block.body2);
    const bool is_first = is_joint_of(a, b);
    if (!is_first && !is_joint_of(b, a)) return false;
    const TreeLink& link = tree_->link(is_first ? a : b);
    if ((is_first ? block.body2 : block.body1) >= 0 && link.parent < 0)
        return false;  // a kinematic body that may move
    const Row& row = system_->rows[std::size_t(source)];
    const Spatial f = is_first ? on_body(a, row.lin1, row.ang1) : on_body(b, row.lin2, row.ang2);
    Yield& yield = yields_.back();
    yield = {source, link.first, link.count, double(n.C), double(n.c), {}};
    for (int i = 0; i < link.count; ++i) yield.j[i] = double(dot(tree_->motion(link.first + i), f));
    return true;
}

Spatial TreeSolve::on_body(int link, Vec3 force, Vec3 torque) const
{
    return JointTree::about_root(tree_->link(link), force, torque);
}

void TreeSolve::add_own(const TreeLink& link, const Spatial& f, std::span<double> j) const
{
    for (int i = link.first; i < link.first + link.count; ++i)
        j[std::size_t(i)] += double(dot(tree_->motion(i), f));
}

void TreeSolve::add_chain(int link, const Spatial& f, std::span<double> j) const
{
    if (link < 0) return;
    for (int i = tree_->link(link).last; i >= 0; i = tree_->up(i))
        j[std::size_t(i)] += double(dot(tree_->motion(i), f));
}

void TreeSolve::jacobian(const RowBlock& block, const Jacobian& row, std::span<double> j) const
{
    std::fill(j.begin(), j.end(), 0);
    if (block.term_count > 0) {
        for (const WideTerm& term : terms_of(*system_, block))
            if (const int at = tree_->link_of_body(term.body); at >= 0)
                add_chain(at, on_body(at, term.lin, term.ang), j);
        return;
    }
    const int a = tree_->link_of_body(block.body1), b = tree_->link_of_body(block.body2);
    if (a >= 0 && b >= 0 && tree_->link(a).parent == b)
        return add_own(tree_->link(a), on_body(a, row.lin1, row.ang1), j);
    if (a >= 0 && b >= 0 && tree_->link(b).parent == a)
        return add_own(tree_->link(b), on_body(b, row.lin2, row.ang2), j);
    if (a >= 0) add_chain(a, on_body(a, row.lin1, row.ang1), j);
    if (b >= 0) add_chain(b, on_body(b, row.lin2, row.ang2), j);
}

// J v of bodies that no force moves.
double TreeSolve::kinematic_part(const RowBlock& block, const Row& row) const
{
    double sum = 0;
    const auto add = [&](int body, Vec3 lin, Vec3 ang) {
        if (body < 0 || tree_->link_of_body(body) >= 0) return;
        const SolverBody& its = system_->bodies[std::size_t(body)];
        sum += double(dot(lin, its.v) + dot(ang, its.w));
    };
    if (block.term_count > 0) {
        for (const WideTerm& term : terms_of(*system_, block)) add(term.body, term.lin, term.ang);
        return sum;
    }
    add(block.body1, row.lin1, row.ang1), add(block.body2, row.lin2, row.ang2);
    return sum;
}

void TreeSolve::write_rows()
{
    const std::size_t n = u_.size();
    scale_ = 0;
    for (int i = 0; i < int(rows_.size()); ++i) write_row(i);
    for (int i = 0; i < int(rows_.size()); ++i) {
        const TreeRow& its = rows_[std::size_t(i)];
        const RowBlock& block = system_->blocks[std::size_t(its.block)];
        double* const row = problem_.row(i);
        for (int k = 0; k <= i; ++k) row[k] = problem_.row(k)[i] = product(y(i), y(k), n);
        double C = its.ratio * its.ratio * double(system_->numbers[std::size_t(its.source)].C);
        if (block.coulomb) C = std::max(C, kLeastCompliance * row[i]);
        if (closing_[std::size_t(its.source)]) C = std::max(C, kRedundant * row[i]);
        if (!(C > 0)) C = 1e-14 * row[i];
        row[i] += C;
        if (!(row[i] > 0)) row[i] = 1;  // it moves nothing
    }
    if (!(scale_ > 0)) scale_ = 1;
    bind_parents();
}

void TreeSolve::write_row(int i)
{
    TreeRow& its = rows_[std::size_t(i)];
    const RowBlock& block = system_->blocks[std::size_t(its.block)];
    const Row& row = system_->rows[std::size_t(its.source)];
    const RowNumbers& n = system_->numbers[std::size_t(its.source)];
    const std::span<double> its_y{y(i), u_.size()};
    jacobian(block, row, its_y);
    factor_.to_factor_space(its_y);
    FrictionRow& to = problem_.rows()[std::size_t(i)];
    to = {double(n.lo), double(n.hi), -1, false, false};
    problem_.p()[std::size_t(i)] = double(n.p);
    const double v = product(its_y.data(), z_.data(), u_.size()) + kinematic_part(block, row),
                 c = double(n.c);
    problem_.b()[std::size_t(i)] = v - c;
    scale_ = std::max({scale_, std::fabs(c), std::fabs(v - c)});
}

bool TreeSolve::is_disc(int i) const
{
    const TreeRow& first = rows_[std::size_t(i)];
    if (!system_->blocks[std::size_t(first.block)].coulomb || i + 1 >= int(rows_.size())) return false;
    const TreeRow& next = rows_[std::size_t(i) + 1];
    const auto bounds_friction = [&](const TreeRow& row) {
        const Real hi = system_->numbers[std::size_t(row.source)].hi;
        return hi > 0 && hi < kInf && system_->rows[std::size_t(row.source)].lin1 != Vec3{};
    };
    const auto parent = [&](const TreeRow& row) { return system_->numbers[std::size_t(row.source)].parent; };
    return next.block == first.block && parent(next) == parent(first) && bounds_friction(first) &&
           bounds_friction(next);
}

// The second row is measured by the ratio of the two bounds, so that the disc is round.
void TreeSolve::make_disc(int i)
{
    const auto limit = [&](int row) {
        return double(system_->numbers[std::size_t(rows_[std::size_t(row)].source)].hi);
    };
    problem_.rows()[std::size_t(i)].disc = true, problem_.rows()[std::size_t(i) + 1].second = true;
    const double ratio = limit(i + 1) / limit(i);
    rows_[std::size_t(i) + 1].ratio = ratio;
    if (ratio == 1) return;
    for (int k = 0; k < problem_.size(); ++k)
        problem_.row(i + 1)[k] *= ratio, problem_.row(k)[i + 1] *= ratio;
    for (std::size_t k = 0; k < u_.size(); ++k) y(i + 1)[k] *= ratio;
    problem_.b()[std::size_t(i) + 1] *= ratio, problem_.p()[std::size_t(i) + 1] /= ratio;
}

void TreeSolve::bind_parents()
{
    for (int i = 0; i < int(rows_.size()); ++i) {
        const RowNumbers& n = system_->numbers[std::size_t(rows_[std::size_t(i)].source)];
        if (n.parent < 0) continue;
        FrictionRow& row = problem_.rows()[std::size_t(i)];
        row.parent = row_of_source_[std::size_t(n.parent)];
        if (!row.second && is_disc(i)) make_disc(i);
    }
}

}  // namespace epode
