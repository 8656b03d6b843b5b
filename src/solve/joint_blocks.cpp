// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bounds within a block: solve all rows; put those that left their bounds on them; solve the rest for what
// remains; repeat, at most once per row. Rows are not released again within a visit: the next sweep starts
// afresh, and friction-like rows of joints are few.
#include "solve/joint_blocks.h"

#include <algorithm>

namespace epode {
namespace {

Real velocity(const JointRow& r, const Velocity& a, const Velocity& b)
{
    return (dot(r.lin1, a.v) + dot(r.ang1, a.w)) + (dot(r.lin2, b.v) + dot(r.ang2, b.w));
}

void apply(const JointRow& r, const JointBlock& block, Real dp, Velocity& a, Velocity& b)
{
    a.v += (block.inv_mass1 * dp) * r.lin1;
    a.w += dp * r.turn1;
    b.v += (block.inv_mass2 * dp) * r.lin2;
    b.w += dp * r.turn2;
}

void bounds(const JointRow& row, const JointRow* block_rows, Real& lo, Real& hi)
{
    lo = row.lo, hi = row.hi;
    if (row.parent < 0) return;
    const Real load = std::fabs(block_rows[row.parent].p);
    hi = load > 0 ? row.hi * load : 0;
    lo = -hi;
}

void load_row(const Row& row, const SolverBody& a, const SolverBody* b, const Substep& step, JointRow& out)
{
    out.lin1 = row.lin1, out.ang1 = row.ang1;
    out.turn1 = a.inv_inertia * row.ang1;
    out.lin2 = b ? row.lin2 : Vec3{};
    out.ang2 = b ? row.ang2 : Vec3{};
    out.turn2 = b ? b->inv_inertia * row.ang2 : Vec3{};
    const RowAim aim = map_row(row, step, row_mobility(row, a, b));
    out.C = aim.C;
    out.c = std::min(aim.rate * row.error + row.speed, row.cap);
    out.c_relaxed = aim.spring ? out.c : std::min(row.speed, row.cap);
}

void fill_matrix(const JointRow* rows, JointBlock& block)
{
    for (int i = 0; i < block.count; ++i) {
        for (int j = 0; j <= i; ++j) {
            const JointRow &r = rows[i], &s = rows[j];
            block.A[i][j] = block.A[j][i] = (block.inv_mass1 * dot(r.lin1, s.lin1) + dot(r.ang1, s.turn1)) +
                                            (block.inv_mass2 * dot(r.lin2, s.lin2) + dot(r.ang2, s.turn2));
        }
        block.A[i][i] += rows[i].C;
    }
}

}  // namespace

bool JointBlocks::prepare(const RowSystem& system, Arena& arena)
{
    int blocks = 0, rows = 0;
    for (const RowBlock& block : system.blocks)
        if (!block.contact) ++blocks, rows += block.count;
    blocks_ = arena.take<JointBlock>(blocks);
    rows_ = arena.take<JointRow>(rows);
    if (arena.failed()) return false;

    int next_block = 0, next_row = 0;
    for (const RowBlock& block : system.blocks) {
        if (block.contact) continue;
        JointBlock& out = blocks_[std::size_t(next_block++)];
        out.first = next_row, out.count = block.count, out.source = block.first;
        out.body1 = block.body1, out.body2 = second_slot(system, block.body2);
        out.inv_mass1 = system.bodies[std::size_t(block.body1)].inv_mass;
        out.inv_mass2 = block.body2 >= 0 ? system.bodies[std::size_t(block.body2)].inv_mass : 0;
        out.bounded = false;
        for (int k = block.first; k < block.first + block.count; ++k) {
            const RowNumbers& n = system.numbers[std::size_t(k)];
            JointRow& row = rows_[std::size_t(next_row++)];
            row.lo = n.lo, row.hi = n.hi, row.p = n.p;
            row.parent = n.parent >= 0 ? n.parent - block.first : -1;
            out.bounded |= n.parent >= 0 || n.lo > -kInf || n.hi < kInf;
        }
    }
    return true;
}

void JointBlocks::refresh(const RowSystem& system, const Substep& step)
{
    for (JointBlock& block : blocks_) {
        const SolverBody& a = system.bodies[std::size_t(block.body1)];
        const bool two = std::size_t(block.body2) < system.bodies.size();
        const SolverBody* b = two ? &system.bodies[std::size_t(block.body2)] : nullptr;
        JointRow* rows = &rows_[std::size_t(block.first)];
        for (int i = 0; i < block.count; ++i)
            load_row(system.rows[std::size_t(block.source + i)], a, b, step, rows[i]);
        fill_matrix(rows, block);
        block.factors.factor(block.A, block.count);
    }
}

void JointBlocks::apply_impulses(std::span<Velocity> bodies) const
{
    for (const JointBlock& block : blocks_)
        for (int i = block.first; i < block.first + block.count; ++i)
            apply(rows_[std::size_t(i)], block, rows_[std::size_t(i)].p, bodies[std::size_t(block.body1)],
                  bodies[std::size_t(block.body2)]);
}

void JointBlocks::sweep(std::span<Velocity> bodies, bool relax)
{
    for (const JointBlock& block : blocks_) visit(block, bodies, relax);
}

void JointBlocks::visit(const JointBlock& block, std::span<Velocity> bodies, bool relax)
{
    JointRow* rows = &rows_[std::size_t(block.first)];
    Velocity &a = bodies[std::size_t(block.body1)], &b = bodies[std::size_t(block.body2)];
    Real residual[kMaxJointRows] = {}, dp[kMaxJointRows] = {};
    for (int i = 0; i < block.count; ++i) {
        const Real c = relax ? rows[i].c_relaxed : rows[i].c;
        dp[i] = residual[i] = c - velocity(rows[i], a, b) - rows[i].C * rows[i].p;
    }
    block.factors.solve(dp, block.count);
    if (block.bounded) project(block, residual, dp);
    for (int i = 0; i < block.count; ++i) {
        rows[i].p += dp[i];
        apply(rows[i], block, dp[i], a, b);
    }
}

void JointBlocks::project(const JointBlock& block, const Real* residual, Real* dp)
{
    const JointRow* rows = &rows_[std::size_t(block.first)];
    const int m = block.count;
    Real lo[kMaxJointRows], hi[kMaxJointRows];
    bool held[kMaxJointRows] = {};
    for (int i = 0; i < m; ++i) bounds(rows[i], rows, lo[i], hi[i]);
    for (int round = 0; round < m; ++round) {
        bool left = false;
        for (int i = 0; i < m; ++i) {
            const Real q = rows[i].p + dp[i];
            if (held[i] || (q >= lo[i] && q <= hi[i])) continue;
            held[i] = left = true;
            dp[i] = (q < lo[i] ? lo[i] : hi[i]) - rows[i].p;
        }
        if (!left) return;
        int free[kMaxJointRows], count = 0;
        for (int i = 0; i < m; ++i)
            if (!held[i]) free[count++] = i;
        Real A[kMaxJointRows][kMaxJointRows], x[kMaxJointRows];
        for (int i = 0; i < count; ++i) {
            x[i] = residual[free[i]];
            for (int j = 0; j < m; ++j)
                if (held[j]) x[i] -= block.A[free[i]][j] * dp[j];
            for (int j = 0; j <= i; ++j) A[i][j] = block.A[free[i]][free[j]];
        }
        BlockLdlt reduced;
        reduced.factor(A, count);
        reduced.solve(x, count);
        for (int i = 0; i < count; ++i) dp[free[i]] = x[i];
    }
}

void JointBlocks::add_impulses(std::span<RowNumbers> numbers) const
{
    for (const JointBlock& block : blocks_)
        for (int i = 0; i < block.count; ++i)
            numbers[std::size_t(block.source + i)].p += rows_[std::size_t(block.first + i)].p;
}

void JointBlocks::describe(std::span<RowNumbers> numbers) const
{
    for (const JointBlock& block : blocks_)
        for (int i = 0; i < block.count; ++i) {
            const JointRow& row = rows_[std::size_t(block.first + i)];
            RowNumbers& n = numbers[std::size_t(block.source + i)];
            n.c = row.c, n.C = row.C, n.p = row.p;
        }
}

void JointBlocks::rebound(const RowSystem& system, std::span<Velocity> bodies)
{
    for (JointBlock& block : blocks_) {
        JointRow* rows = &rows_[std::size_t(block.first)];
        bool any = false;
        for (int i = 0; i < block.count; ++i) {
            const Row& row = system.rows[std::size_t(block.source + i)];
            const Real carried = system.numbers[std::size_t(block.source + i)].p + rows[i].p;
            if (!row.rebounds || carried == 0) continue;
            rows[i].c_relaxed = row.rebound;
            any = true;
        }
        if (any) visit(block, bodies, true);
    }
}

}  // namespace epode
