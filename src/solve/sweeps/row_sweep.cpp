// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Projected Gauss-Seidel with over-relaxation, row by row. The second half of a one-body row is zero, so the
// world's slot takes part without a branch.
#include "solve/sweeps/row_sweep.h"

#include <algorithm>

#include "solve/common/contact_rows.h"

namespace epode {
namespace {

constexpr Real kLeastLimit = Real(1e-30);  // a divisor instead of zero

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

Real stepped(const PackedRow& row, const Velocity& a, const Velocity& b)
{
    return row.impulse_scale * row.p + row.effective_mass * (row.c - row_velocity(row, a, b));
}

void visit_row(PackedRow& row, const PackedRow* rows, const PackedBlock& block, Velocity& a, Velocity& b)
{
    Real lo, hi;
    limits(row, rows, lo, hi);
    const Real q = clip(stepped(row, a, b), lo, hi);
    apply(row, block, q - row.p, a, b);
    row.p = q;
}

// By what (q1, q2) has to be multiplied to be in the ellipse of the limits of two rows.
Real into_ellipse(const PackedRow* tangents, const PackedRow* rows, Real q1, Real q2)
{
    const Real q[2] = {q1, q2};
    Real length2 = 0;
    for (int k = 0; k < 2; ++k) {
        Real lo, hi;
        limits(tangents[k], rows, lo, hi);
        const bool bound = hi < kInf && q[k] != 0;
        const Real share = bound ? q[k] / std::max(hi, kLeastLimit) : 0;
        length2 += share * share;
    }
    return length2 > 1 ? 1 / std::sqrt(length2) : 1;
}

void visit_cone(PackedRow* tangents, const PackedRow* rows, const PackedBlock& block, Velocity& a,
                Velocity& b)
{
    const Real q[2] = {stepped(tangents[0], a, b), stepped(tangents[1], a, b)};
    const Real scale = into_ellipse(tangents, rows, q[0], q[1]);
    for (int k = 0; k < 2; ++k) {
        apply(tangents[k], block, scale * q[k] - tangents[k].p, a, b);
        tangents[k].p = scale * q[k];
    }
}

// Of the rows one by one, and of the two tangents together: d + C.
Real larger_eigenvalue(Real k11, Real k22, Real k12)
{
    const Real apart = (k11 - k22) / 2;
    return (k11 + k22) / 2 + std::sqrt(apart * apart + k12 * k12);
}

void give_one_gain(PackedRow* tangents, const PackedBlock& block, const PackedRow* rows, const RowNumbers* n,
                   Real w)
{
    PackedRow &s = tangents[0], &t = tangents[1];
    const auto inverse = [w](const PackedRow& row) {
        return row.effective_mass > 0 ? w / row.effective_mass : 0;
    };
    const Real k12 = block.inv_mass1 * dot(s.lin1, t.lin1) + dot(s.turn1, t.ang1) +
                     block.inv_mass2 * dot(s.lin2, t.lin2) + dot(s.turn2, t.ang2);
    const Real d = larger_eigenvalue(inverse(s), inverse(t), k12);
    const Real scale = into_ellipse(tangents, rows, s.p, t.p);
    for (int k = 0; k < 2; ++k) {
        PackedRow& row = tangents[k];
        row.effective_mass = d > 0 ? w / d : 0;
        row.impulse_scale = 1 - row.effective_mass * n[k].C;
        row.p *= scale;
    }
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
        blocks_[std::size_t(next_block++)] = {next_row,
                                              block.count,
                                              block.body1,
                                              second_slot(system, block.body2),
                                              a.inv_mass,
                                              b ? b->inv_mass : 0,
                                              has_cone(system, block)};
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
        if (const PackedBlock& packed = blocks_[std::size_t(next_block - 1)]; packed.cone)
            give_one_gain(&rows_[std::size_t(next_row + 1)], packed, rows_.data(),
                          &system.numbers[std::size_t(block.first + 1)], w);
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
        for (int k = 0; k < block.count; k += k == 1 && block.cone ? 2 : 1) {
            PackedRow& row = rows_[std::size_t(block.first + k)];
            k == 1 && block.cone ? visit_cone(&row, rows_.data(), block, a, b)
                                 : visit_row(row, rows_.data(), block, a, b);
        }
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
