// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Projected Gauss-Seidel with over-relaxation, row by row. The second half of a one-body row is zero, so the
// world's slot takes part without a branch.
#include "solve/sweeps/row_sweep.h"

#include <algorithm>

namespace epode {
namespace {

void limits(const PackedRow& row, const PackedRow* rows, Real& lo, Real& hi)
{
    lo = row.lo, hi = row.hi;
    if (row.parent < 0) return;
    hi = row.hi * std::fabs(rows[row.parent].p);  // infinity times zero is NaN, which never limits
    lo = -hi;
}

Real clip(Real q, Real lo, Real hi)
{
    q = q > hi ? hi : q;
    return q < lo ? lo : q;
}

void apply(const PackedRow& row, const PackedBlock& block, Real dp, Velocity& a, Velocity& b)
{
    a.v += (block.inv_mass1 * dp) * row.lin1;
    a.w += dp * row.turn1;
    b.v += (block.inv_mass2 * dp) * row.lin2;
    b.w += dp * row.turn2;
}

void visit_row(PackedRow& row, const PackedRow* rows, const PackedBlock& block, Velocity& a, Velocity& b)
{
    Real lo, hi;
    limits(row, rows, lo, hi);
    const Real q =
        clip(row.impulse_scale * row.p + row.effective_mass * (row.c - row_velocity(row, a, b)), lo, hi);
    apply(row, block, q - row.p, a, b);
    row.p = q;
}

void pack_row(const Row& row, const RowNumbers& n, const SolverBody& a, const SolverBody* b, Real w,
              PackedRow& out)
{
    out.lin1 = row.lin1, out.ang1 = row.ang1;
    out.turn1 = a.inv_inertia * row.ang1;
    out.lin2 = b ? row.lin2 : Vec3{};
    out.ang2 = b ? row.ang2 : Vec3{};
    out.turn2 = b ? b->inv_inertia * row.ang2 : Vec3{};
    const Real d = inverse_effective_mass(row, a, b) + n.C;
    out.c = n.c;
    out.effective_mass = d > 0 ? w / d : 0;
    out.impulse_scale = 1 - out.effective_mass * n.C;
    out.p = d > 0 ? n.p : 0;
    out.lo = n.lo, out.hi = n.hi;
}

}  // namespace

bool RowSweep::pack(const RowSystem& system, Real w, std::span<const bool> skip, Arena& arena)
{
    int blocks = 0, rows = 0;
    for (std::size_t i = 0; i < system.blocks.size(); ++i)
        if (!skip[i]) ++blocks, rows += system.blocks[i].count;
    blocks_ = arena.take<PackedBlock>(blocks);
    rows_ = arena.take<PackedRow>(rows);
    if (arena.failed()) return false;

    int next_block = 0, next_row = 0;
    for (std::size_t i = 0; i < system.blocks.size(); ++i) {
        if (skip[i]) continue;
        const RowBlock& block = system.blocks[i];
        const SolverBody& a = system.bodies[std::size_t(block.body1)];
        const SolverBody* b = block.body2 >= 0 ? &system.bodies[std::size_t(block.body2)] : nullptr;
        blocks_[std::size_t(next_block++)] = {next_row,    block.count,
                                              block.body1, second_slot(system, block.body2),
                                              a.inv_mass,  b ? b->inv_mass : 0};
        for (int k = block.first; k < block.first + block.count; ++k) {
            PackedRow& out = rows_[std::size_t(next_row + k - block.first)];
            const RowNumbers& n = system.numbers[std::size_t(k)];
            pack_row(system.rows[std::size_t(k)], n, a, b, w, out);
            out.source = k;
            out.parent = n.parent >= 0 ? next_row + n.parent - block.first : -1;
            Real lo, hi;
            limits(out, rows_.data(), lo, hi);
            out.p = clip(out.p, lo, hi);
        }
        next_row += block.count;
    }
    return true;
}

void RowSweep::apply_impulses(std::span<Velocity> bodies) const
{
    for (const PackedBlock& block : blocks_)
        for (int i = block.first; i < block.first + block.count; ++i) {
            const PackedRow& row = rows_[std::size_t(i)];
            apply(row, block, row.p, bodies[std::size_t(block.body1)], bodies[std::size_t(block.body2)]);
        }
}

void RowSweep::sweep(std::span<Velocity> bodies, bool backwards)
{
    const std::size_t n = blocks_.size();
    for (std::size_t i = 0; i < n; ++i) {
        const PackedBlock& block = blocks_[backwards ? n - 1 - i : i];
        Velocity a = bodies[std::size_t(block.body1)], b = bodies[std::size_t(block.body2)];
        for (int k = block.first; k < block.first + block.count; ++k)
            visit_row(rows_[std::size_t(k)], rows_.data(), block, a, b);
        bodies[std::size_t(block.body1)] = a;
        bodies[std::size_t(block.body2)] = b;
    }
}

void RowSweep::visit(std::span<Velocity> bodies, int block, int row)
{
    const PackedBlock& of = blocks_[std::size_t(block)];
    visit_row(rows_[std::size_t(row)], rows_.data(), of, bodies[std::size_t(of.body1)],
              bodies[std::size_t(of.body2)]);
}

void RowSweep::store_impulses(std::span<RowNumbers> numbers) const
{
    for (const PackedRow& row : rows_) numbers[std::size_t(row.source)].p = row.p;
}

}  // namespace epode
