// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "solve/tree/tree_solve.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

constexpr double kWanted = sizeof(Real) == 8 ? 1e-10 : 1e-6, kPromised = sizeof(Real) == 8 ? 1e-9 : 1e-5;
constexpr double kCoulomb = sizeof(Real) == 8 ? 1e-7 : 1e-5;

}  // namespace

bool TreeSolve::prepare(RowSystem& system, const JointTree& tree, std::span<const bool> closing, int max_rows,
                        Arena& arena)
{
    system_ = &system, tree_ = &tree, closing_ = closing;
    const int n = tree.dofs(), links = int(tree.links().size());
    u_ = arena.take<double>(n), z_ = arena.take<double>(n), solved_ = arena.take<double>(n);
    scratch_ = arena.take<Spatial>(links);
    for (std::span<double>& spins : spins_) spins = arena.take<double>(n);
    if (arena.failed() || !factor_.prepare(tree, arena)) return false;
    factor_.assemble(tree, [&](const TreeLink& link) {
        const SolverBody& body = system.bodies[std::size_t(link.body)];
        return LinkInertia{body.mass, body.inertia};
    });
    if (!collect(arena)) return false;
    fits_ = int(rows_.size()) <= max_rows;
    if (!fits_) return true;
    for (std::size_t i = 0; i < scratch_.size(); ++i) {
        const SolverBody& body = system.bodies[std::size_t(tree.link(int(i)).body)];
        scratch_[i] = {body.inertia * body.w, body.mass * body.v};
    }
    tree.gather(scratch_, z_);
    for (const Yield& yield : yields_)
        for (int i = 0; i < yield.count; ++i)
            z_[std::size_t(yield.first + i)] += yield.j[i] * yield.c / yield.C;
    add_yields_to(factor_);
    factor_.factor();
    factor_.to_factor_space(z_);
    Y_ = arena.take<double>(int(rows_.size()) * n);
    acting_ = arena.take<int>(int(rows_.size()));
    if (arena.failed() || !problem_.prepare(int(rows_.size()), arena)) return false;
    write_rows();
    return true;
}

// ODE's two phases (solve/exact/direct.cpp), where friction is a box.
bool TreeSolve::solve_phases()
{
    const std::span<FrictionRow> rows = problem_.rows();
    bool friction = false;
    for (FrictionRow& row : rows)
        if (row.parent >= 0) friction = true;
    if (!friction) return problem_.solve(scale_, kWanted, kPromised);
    const auto bound = [&](bool by_normals) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const RowNumbers& n = system_->numbers[std::size_t(rows_[i].source)];
            if (n.parent < 0) continue;
            const double normal = std::fabs(problem_.p()[std::size_t(row_of_source_[std::size_t(n.parent)])]);
            rows[i].parent = -1;
            rows[i].hi = by_normals && normal > 0 ? double(n.hi) * normal : 0, rows[i].lo = -rows[i].hi;
        }
    };
    bound(false);
    if (!problem_.solve(scale_, kWanted, kPromised)) return false;
    bound(true);
    return problem_.solve(scale_, kWanted, kPromised);
}

bool TreeSolve::solve(SolveReport& report)
{
    if (!rows_.empty()) {
        const bool found = system_->coulomb ? problem_.solve(scale_, kPromised, kCoulomb) : solve_phases();
        if (!found) return false;
        report.iterations += problem_.systems();
        report.residual = Real(problem_.residual()), report.friction_error = Real(problem_.friction_error());
    }
    ++report.factorisations;
    std::copy(z_.begin(), z_.end(), u_.begin());
    for (int i = 0; i < int(rows_.size()); ++i) {
        const double p = problem_.p()[std::size_t(i)];
        if (p == 0) continue;
        const double* const its = y(i);
        for (std::size_t k = 0; k < u_.size(); ++k) u_[k] += p * its[k];
    }
    factor_.to_velocities(u_);
    const auto is_usable = [](double x) { return std::fabs(x) < 1e15; };
    if (!std::all_of(u_.begin(), u_.end(), is_usable)) return false;
    std::copy(u_.begin(), u_.end(), solved_.begin());
    store_impulses(), store_yield();
    return true;
}

void TreeSolve::store_velocities()
{
    tree_->velocities(u_, scratch_);
    for (std::size_t i = 0; i < scratch_.size(); ++i) {
        SolverBody& body = system_->bodies[std::size_t(tree_->link(int(i)).body)];
        body.w = scratch_[i].ang, body.v = scratch_[i].lin;
    }
}

void TreeSolve::store_impulses()
{
    for (int i = 0; i < int(rows_.size()); ++i)
        system_->numbers[std::size_t(rows_[std::size_t(i)].source)].p =
            Real(rows_[std::size_t(i)].ratio * problem_.p()[std::size_t(i)]);
}

void TreeSolve::subtract_impulses(std::span<Spatial> of_links) const
{
    const auto subtract = [&](int body, double p, Vec3 lin, Vec3 ang) {
        const int at = tree_->link_of_body(body);
        if (at < 0) return;
        Spatial& to = of_links[std::size_t(at)];
        to = {to.ang - Real(p) * ang, to.lin - Real(p) * lin};
    };
    const auto subtract_row = [&](const RowBlock& block, int source) {
        const Row& row = system_->rows[std::size_t(source)];
        const double p = double(system_->numbers[std::size_t(source)].p);
        if (p == 0) return;
        if (block.term_count > 0)
            for (const WideTerm& term : terms_of(*system_, block)) subtract(term.body, p, term.lin, term.ang);
        else
            subtract(block.body1, p, row.lin1, row.ang1), subtract(block.body2, p, row.lin2, row.ang2);
    };
    for (const RowBlock& block : system_->blocks)
        for (int i = block.first; i < block.first + block.count; ++i)
            if (row_of_source_[std::size_t(i)] >= 0) subtract_row(block, i);
    for (const Yield& yield : yields_)
        for (const RowBlock& block : system_->blocks)
            if (yield.source >= block.first && yield.source < block.first + block.count)
                subtract_row(block, yield.source);
}

void TreeSolve::store_joint_impulses(std::span<const Spatial> impulses)
{
    for (std::size_t i = 0; i < impulses.size(); ++i) {
        const TreeLink& link = tree_->link(int(i));
        if (link.block < 0) continue;
        const RowBlock& block = system_->blocks[std::size_t(link.block)];
        const Row* const rows = &system_->rows[std::size_t(block.first)];
        RowNumbers* const n = &system_->numbers[std::size_t(block.first)];
        const Spatial f = link.is_body1 ? impulses[i] : Real(-1) * impulses[i];  // on body 1
        if (link.joint == LinkJoint::kSlider) {
            Vec3 torque = f.ang;
            for (int k = 3; k < 5; ++k) n[k].p = dot(f.lin, rows[k].lin1), torque -= n[k].p * rows[k].ang1;
            for (int k = 0; k < 3; ++k) n[k].p = torque[k];
            continue;
        }
        for (int k = 0; k < 3; ++k) n[k].p = f.lin[k];
        for (int k = 3; k < lock_rows(link.joint); ++k) n[k].p = dot(f.ang, rows[k].ang1);
    }
}

// minimise dq H dq / 2
bool TreeSolve::least_displacement(std::span<const double> errors, std::span<double> dq, Arena& arena)
{
    Arena::Scope scope(arena);
    int count = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const double e = errors[std::size_t(rows_[i].source)];
        if (e > -double(kInf)) acting_[std::size_t(count++)] = int(i);
    }
    FrictionProblem problem;
    if (!problem.prepare(count, arena)) return false;
    double scale = 0;
    for (int i = 0; i < count; ++i) {
        const int from = acting_[std::size_t(i)], source = rows_[std::size_t(from)].source;
        const RowNumbers& n = system_->numbers[std::size_t(source)];
        for (int k = 0; k < count; ++k) problem.row(i)[k] = problem_.row(from)[acting_[std::size_t(k)]];
        problem.row(i)[i] *= 1 + 1e-9;
        const double e = errors[std::size_t(source)];
        problem.rows()[std::size_t(i)] = {n.lo == 0 ? 0 : -double(kInf), n.hi == 0 ? 0 : double(kInf), -1,
                                          false, false};
        problem.b()[std::size_t(i)] = -e;
        scale = std::max(scale, std::fabs(e));
    }
    if (!(scale > 0) || !problem.solve(scale, 1e-6, 1e-6)) return false;
    std::fill(dq.begin(), dq.end(), 0);
    for (int i = 0; i < count; ++i) {
        const double p = problem.p()[std::size_t(i)];
        const double* const its = y(acting_[std::size_t(i)]);
        for (std::size_t k = 0; k < dq.size(); ++k) dq[k] += p * its[k];
    }
    factor_.to_velocities(dq);
    return true;
}

}  // namespace epode
