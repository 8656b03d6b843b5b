// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/tree/closing_rows.h"

#include <algorithm>
#include <cmath>

#include "joints/drive_rows.h"
#include "rows/policy.h"
#include "step/island/positions/position_rows.h"

namespace epode {

bool ClosingRows::begin(const World& world, IslandWork& work, const JointTree& tree, Arena& arena)
{
    world_ = &world, work_ = &work;
    const int rows = int(work.system.rows.size());
    flags_ = arena.take_zeroed<bool>(rows), rows_ = {}, closing_ = 0, farthest_ = 0;
    if (arena.failed()) return false;
    const int count = mark(tree);
    if (count == 0) return true;
    rows_ = arena.take<Closing>(count), starts_ = arena.take<Start>(int(work.system.bodies.size()));
    if (arena.failed()) return false;
    collect();
    save_poses(tree);
    return true;
}

// Their number.
int ClosingRows::mark(const JointTree& tree)
{
    const RowSystem& system = work_->system;
    int motors = 0;
    for (int k = 0; k < int(work_->joints.size()); ++k) {
        const RowBlock& block = system.blocks[std::size_t(k)];
        const bool branch = block.term_count == 0 && tree.branch(system, k) != nullptr;
        for (int i = block.first; i < block.first + block.count; ++i) {
            motors += is_motor(i);
            if (branch || !is_closed(system.rows[std::size_t(i)], block, system)) continue;
            flags_[std::size_t(i)] = true, ++closing_;
        }
    }
    return closing_ + motors;
}

// Of no drive, which yields.
bool ClosingRows::is_motor(int source) const
{
    const Row& row = work_->system.rows[std::size_t(source)];
    return row.kind == RowKind::kLimit && row.lo != 0 && row.hi != 0 && row.parent < 0 && !row.drive;
}

void ClosingRows::collect()
{
    std::size_t to = 0;
    for (int k = 0; k < int(work_->joints.size()); ++k) {
        const RowBlock& block = work_->system.blocks[std::size_t(k)];
        for (int i = 0; i < block.count; ++i) {
            const auto source = std::size_t(block.first + i);
            if (!flags_[source] && !is_motor(int(source))) continue;
            const bool turns = turns_only(work_->system.rows[source]);
            rows_[to++] = {.block = k,
                           .place = i,
                           .source = int(source),
                           .closes = flags_[source],
                           .per_arm = turns ? Real(1) : 1 / longest_arm(*work_, block),
                           .expected = 0,
                           .end = {},
                           .wanted = 0,
                           .p = 0};
            if (flags_[source]) farthest_ = std::max(farthest_, rows_[to - 1].per_arm * distance_of(block));
        }
    }
}

// Of its bodies from the origin.
Real ClosingRows::distance_of(const RowBlock& block) const
{
    Real farthest = 0;
    for (const int body : {block.body1, block.body2})
        if (body >= 0)
            farthest = std::max(farthest, length(work_->island.bodies[std::size_t(body)]->position()));
    return farthest;
}

void ClosingRows::save_poses(const JointTree& tree)
{
    std::size_t count = 0;
    int last = -1;
    const auto save = [&](int body) {
        const int link = body < 0 ? -1 : tree.link_of_body(body);
        const auto has = [&](const Start& start) { return start.link == link; };
        if (link < 0 || std::any_of(starts_.begin(), starts_.begin() + std::ptrdiff_t(count), has)) return;
        const Body& b = *work_->island.bodies[std::size_t(body)];
        starts_[count++] = {body, link, b.position(), b.orientation(), b.rotation()};
    };
    for (const Closing& row : rows_) {
        if (row.block == last || !row.closes) continue;
        const RowBlock& block = work_->system.blocks[std::size_t(last = row.block)];
        if (block.term_count == 0) save(block.body1), save(block.body2);
        for (const WideTerm& term : terms_of(work_->system, block)) save(term.body);
    }
    starts_ = starts_.first(count);
}

void ClosingRows::expect()
{
    for (Closing& row : rows_) {
        const RowNumbers& n = work_->system.numbers[std::size_t(row.source)];
        row.expected =
            work_->system.rows[std::size_t(row.source)].error - work_->system.h * (n.c - n.C * n.p);
    }
}

template <typename F>
void ClosingRows::for_each(F&& f)
{
    StepInfo info = step_info(*world_, work_->system.h);
    info.inner = true;
    Row now[kMaxBlockRows];
    int emitted = -1, count = 0;
    for (Closing& row : rows_) {
        if (!acts(row)) continue;
        if (row.block != emitted) {
            RowWriter out(now, info);
            emit_joint(*work_->joints[std::size_t(row.block)], out);
            emitted = row.block, count = out.count();
        }
        if (row.place < count) f(row, now[row.place]);
    }
}

bool ClosingRows::acts(const Closing& row) const
{
    const RowNumbers& n = work_->system.numbers[std::size_t(row.source)];
    return row.closes || (n.p > n.lo && n.p < n.hi);
}

Real ClosingRows::measure(const TreePoses& poses, TreeSolve& solve)
{
    for (const Start& start : starts_)
        poses.store(start.link, *work_->island.bodies[std::size_t(start.body)]);
    Real worst = 0;
    for_each([&](Closing& row, const Row& now) {
        if (!row.closes) return;
        const Real excess = now.error - row.expected;
        worst = std::max(worst, std::fabs(excess) * row.per_arm);
        solve.set_excess(row.source, double(excess / work_->system.h));
    });
    return worst;
}

void ClosingRows::restore_poses() const
{
    for (const Start& start : starts_) {
        Body& b = *work_->island.bodies[std::size_t(start.body)];
        epode::store(b.pos, start.x), store_quat(b.q, start.q), store_mat(b.R, start.R);
    }
}

Real ClosingRows::find_gaps(std::span<double> errors) const
{
    Real worst = 0;
    for (const Closing& row : rows_) {
        if (!row.closes) continue;
        errors[std::size_t(row.source)] = double(row.expected);
        worst = std::max(worst, std::fabs(row.expected) * row.per_arm);
    }
    return worst;
}

bool ClosingRows::hold(const TreeSolve& solve, const TreeFactor& factor, std::span<double> u, Arena& arena)
{
    if (rows_.empty()) return false;
    Arena::Scope scope(arena);
    const auto n = rows_.size(), dofs = u.size();
    const auto Y = arena.take_zeroed<double>(int(n * dofs)), dp = arena.take_zeroed<double>(int(n));
    DenseFactor A(arena.take<double>(int(n * n)), int(n));
    if (arena.failed()) return false;
    for_each([](Closing& row, const Row& now) { row.end = now, row.wanted = wanted_velocity(now, 0); });
    for (std::size_t i = 0; i < n; ++i) {
        const Closing& row = rows_[i];
        const RowBlock& block = work_->system.blocks[std::size_t(row.block)];
        const std::span<double> y = Y.subspan(i * dofs, dofs);
        if (acts(row) && block.term_count == 0) {  // terms are those of the beginning
            solve.jacobian(block, row.end, y);
            dp[i] = double(row.wanted) - product(y.data(), u.data(), dofs);
            factor.to_factor_space(y);
        }
        for (std::size_t k = 0; k <= i; ++k) A.row(int(i))[k] = product(y.data(), &Y[k * dofs], dofs);
        double& own = A.row(int(i))[i];
        own += std::max(double(work_->system.numbers[std::size_t(row.source)].C), kRedundant * own);
        if (!(own > 0)) own = 1;  // it moves nothing
    }
    if (!A.factor()) return false;
    A.solve(dp);
    push(Y, dp, factor, u, arena);
    return !arena.failed();
}

// u += H1^-1 sum j dp
void ClosingRows::push(std::span<const double> Y, std::span<const double> dp, const TreeFactor& factor,
                       std::span<double> u, Arena& arena)
{
    const auto z = arena.take_zeroed<double>(int(u.size()));
    if (arena.failed()) return;
    for (std::size_t i = 0; i < dp.size(); ++i) {
        for (std::size_t k = 0; k < u.size(); ++k) z[k] += dp[i] * Y[i * u.size() + k];
        rows_[i].p = Real(dp[i]), work_->system.numbers[std::size_t(rows_[i].source)].p += rows_[i].p;
    }
    factor.to_velocities(z);
    for (std::size_t k = 0; k < u.size(); ++k) u[k] += z[k];
}

void ClosingRows::subtract_impulses(const JointTree& tree, std::span<Spatial> of_links) const
{
    for (const Closing& row : rows_) {
        const RowBlock& block = work_->system.blocks[std::size_t(row.block)];
        const auto subtract = [&](int body, Vec3 lin, Vec3 ang) {
            const int at = tree.link_of_body(body);
            if (at >= 0) of_links[std::size_t(at)] = of_links[std::size_t(at)] - row.p * Spatial{ang, lin};
        };
        subtract(block.body1, row.end.lin1, row.end.ang1), subtract(block.body2, row.end.lin2, row.end.ang2);
    }
}

}  // namespace epode
