// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "solve/joints/wide_rows.h"

#include <algorithm>

namespace epode {

bool WideRows::pack(const RowSystem& system, Arena& arena)
{
    int rows = 0, terms = 0;
    for (const RowBlock& block : system.blocks)
        if (block.term_count > 0) rows += block.count, terms += block.count * block.term_count;
    rows_ = arena.take<WideRow>(rows);
    terms_ = arena.take<Term>(terms);
    if (arena.failed()) return false;
    std::size_t next = 0;
    int first = 0;
    for (std::size_t k = 0; k < system.blocks.size(); ++k) {
        const RowBlock& block = system.blocks[k];
        for (int i = 0; block.term_count > 0 && i < block.count; ++i, first += block.term_count) {
            const RowNumbers& n = system.numbers[std::size_t(block.first + i)];
            rows_[next++] = {
                block.first + i, int(k), first, block.term_count, 0, 0, 0, 0, n.lo, n.hi, n.p, 0};
        }
    }
    return true;
}

// Leaves J M^-1 J^T in d.
void WideRows::load_terms(const RowSystem& system, WideRow& row)
{
    row.d = 0;
    const auto from = terms_of(system, system.blocks[std::size_t(row.block)]);
    for (std::size_t i = 0; i < from.size(); ++i) {
        const SolverBody& body = system.bodies[std::size_t(from[i].body)];
        Term& term = terms_[std::size_t(row.first) + i];
        term = {from[i].body, body.inv_mass, from[i].lin, from[i].ang, body.inv_inertia * from[i].ang};
        row.d += term.inv_mass * length2(term.lin) + dot(term.ang, term.turn);
    }
}

void WideRows::load(const RowSystem& system)
{
    for (WideRow& row : rows_) {
        load_terms(system, row);
        const RowNumbers& n = system.numbers[std::size_t(row.source)];
        row.c = row.relaxed = n.c, row.C = n.C;
        row.d += row.C;
    }
}

void WideRows::load_substep(const RowSystem& system, const Substep& step)
{
    for (WideRow& row : rows_) {
        load_terms(system, row);
        const Row& from = system.rows[std::size_t(row.source)];
        const RowAim aim = map_row(from, step, row.d);
        row.c = std::min(aim.rate * from.error + target_speed(from, step), from.cap);
        row.relaxed = aim.spring ? row.c : std::min(from.speed, from.cap);
        row.C = aim.C;
        row.d += row.C;
    }
}

void WideRows::apply(const WideRow& row, Real dp, std::span<Velocity> bodies) const
{
    for (const Term& term : terms_.subspan(std::size_t(row.first), std::size_t(row.count))) {
        Velocity& body = bodies[std::size_t(term.body)];
        body.v += (term.inv_mass * dp) * term.lin;
        body.w += dp * term.turn;
    }
}

void WideRows::visit(WideRow& row, std::span<Velocity> bodies, Real target, Real w) const
{
    if (!(row.d > 0)) return;
    Real speed = 0;
    for (const Term& term : terms_.subspan(std::size_t(row.first), std::size_t(row.count))) {
        const Velocity& body = bodies[std::size_t(term.body)];
        speed += dot(term.lin, body.v) + dot(term.ang, body.w);
    }
    const Real wanted = row.p + w * (target - speed - row.C * row.p) / row.d;
    const Real p = std::min(std::max(wanted, row.lo), row.hi), dp = p - row.p;
    row.p = p;
    apply(row, dp, bodies);
}

void WideRows::apply_impulses(std::span<Velocity> bodies) const
{
    for (const WideRow& row : rows_) apply(row, row.p, bodies);
}

void WideRows::sweep(std::span<Velocity> bodies, const JointSweep& how)
{
    for (WideRow& row : rows_) visit(row, bodies, how.relax ? row.relaxed : row.c, how.w);
}

void WideRows::store_impulses(std::span<RowNumbers> numbers) const
{
    for (const WideRow& row : rows_) numbers[std::size_t(row.source)].p = row.p;
}

void WideRows::sum_impulses()
{
    for (WideRow& row : rows_) row.sum += row.p;
}

void WideRows::store_sums(std::span<RowNumbers> numbers) const
{
    for (const WideRow& row : rows_) numbers[std::size_t(row.source)].p = row.sum;
}

void WideRows::describe(std::span<RowNumbers> numbers) const
{
    for (const WideRow& row : rows_) {
        RowNumbers& n = numbers[std::size_t(row.source)];
        n.c = row.c, n.C = row.C, n.p = row.p;
    }
}

void WideRows::apply_restitution(const RowSystem& system, std::span<Velocity> bodies)
{
    for (WideRow& row : rows_) {
        const Row& from = system.rows[std::size_t(row.source)];
        if (from.has_restitution && row.sum + row.p != 0) visit(row, bodies, from.restitution_velocity, 1);
    }
}

}  // namespace epode
