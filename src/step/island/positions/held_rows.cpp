// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/positions/held_rows.h"

#include <algorithm>
#include <cmath>

#include "joints/drive_rows.h"
#include "step/island/positions/position_rows.h"

namespace epode {
namespace {

// Blocks of joints between two bodies at most.
bool has_equalities(const RowBlock& block) { return !block.contact && block.term_count == 0; }

bool has_rotor(const Row& row) { return row.drive && row.drive->inertia > 0; }

bool holds_position(const Row& row, const RowBlock& block, const RowSystem& system)
{
    if (row.kind == RowKind::kFriction) return false;
    if (row.kind == RowKind::kLimit && row.lo != 0 && row.hi != 0) return false;  // a motor
    return !is_spring(row, block, system);
}

}  // namespace

HeldRows::HeldRows(const World& world, const IslandWork& work)
    : world_(world), work_(work), info_(step_info(world, work.system.h))
{
    info_.inner = true;
}

bool HeldRows::choose(Arena& arena, RowSystem& to)
{
    const int rows = int(work_.system.rows.size()), blocks = int(work_.system.blocks.size());
    holds_ = arena.take<Hold>(rows), before_ = arena.take<Hold>(rows);
    to.rows = arena.take<Row>(rows), to.numbers = arena.take<RowNumbers>(rows);
    to.blocks = arena.take<RowBlock>(blocks), from_ = arena.take<int>(blocks);
    to.terms = arena.take<WideTerm>(int(work_.system.terms.size()));
    if (arena.failed()) return false;
    std::copy(work_.system.terms.begin(), work_.system.terms.end(), to.terms.begin());
    choose_rows(to);
    measure();
    return !to.rows.empty();
}

void HeldRows::choose_rows(RowSystem& to)
{
    int rows = 0, blocks = 0;
    Row now[kMaxBlockRows];
    for (std::size_t k = 0; k < work_.system.blocks.size(); ++k) {
        const RowBlock& block = work_.system.blocks[k];
        RowWriter out(now, info_);
        if (!block.contact) emit_joint(*work_.joints[k], out);
        const int first = rows;
        rows = choose_rows_of(int(k), {now, std::size_t(out.count())}, to, rows);
        if (rows == first) continue;
        from_[std::size_t(blocks)] = int(k);
        RowBlock& held = to.blocks[std::size_t(blocks++)];
        held = {first, rows - first, block.body1, block.body2, block.contact, block.arms};
        held.first_term = block.first_term, held.term_count = block.term_count;
    }
    to.rows = to.rows.first(std::size_t(rows)), to.numbers = to.numbers.first(std::size_t(rows));
    to.blocks = to.blocks.first(std::size_t(blocks)), holds_ = holds_.first(std::size_t(rows));
}

// Of block k; `now`: its rows at the present pose, if it is a joint's. Returns the number of rows with them.
int HeldRows::choose_rows_of(int k, std::span<const Row> now, RowSystem& to, int rows)
{
    const RowBlock& block = work_.system.blocks[std::size_t(k)];
    const Real per_arm = 1 / longest_arm(work_, block);
    for (int i = 0; i < block.count; ++i) {
        const int source = block.first + i;
        const Row& row = work_.system.rows[std::size_t(source)];
        const Row* const present = std::size_t(i) < now.size() ? &now[std::size_t(i)] : nullptr;
        if (has_rotor(row) && has_equalities(block)) {
            holds_[std::size_t(rows)] = {source, 0, 0, false, row.drive->inertia};
        } else if (holds_position(row, block, work_.system)) {
            holds_[std::size_t(rows)] = hold_of(row, k, source, present, per_arm);
            one_sided_ |= row.lo == 0 || row.hi == 0;
        } else {
            continue;
        }
        to.rows[std::size_t(rows++)] = present ? *present : row;
    }
    return rows;
}

Hold HeldRows::hold_of(const Row& row, int k, int source, const Row* now, Real per_arm) const
{
    const RowBlock& block = work_.system.blocks[std::size_t(k)];
    Hold hold{source, 0, turns_only(row) ? Real(1) : per_arm, !now || row.given};
    hold.error = hold.follows ? row.error - motion(row, block) : now->error;
    if (row.kind == RowKind::kNormal) aim_at_depth(row, k, per_arm, hold);
    return hold;
}

void HeldRows::aim_at_depth(const Row& normal, int block, Real per_arm, Hold& hold) const
{
    // An open point of a manifold has its gap as a velocity (step/island/problem/manifold_rows).
    if (std::size_t(block) >= work_.joints.size())
        hold.error += work_.system.h * std::min(normal.speed, Real(0));
    hold.error -= world_.projection_tolerance / 2 / per_arm;
    const Real share = std::min(normal.erp, Real(1));
    // The tolerance is one of the depth, not of the share that this step removes.
    if (hold.error > 0 && share > 0) hold.error *= share, hold.per_arm /= share;
    if (!(share > 0)) hold.error = std::min(hold.error, Real(0));
}

// J times the step's displacement.
Real HeldRows::motion(const Row& row, const RowBlock& block) const
{
    if (block.term_count > 0) {
        Real rate = 0;
        for (const WideTerm& term : terms_of(work_.system, block)) {
            const Body& b = body(term.body);
            rate += dot(term.lin, b.velocity()) + dot(term.ang, b.angular_velocity());
        }
        return work_.system.h * rate;
    }
    const Body& a = body(block.body1);
    Real s = dot(row.lin1, a.velocity()) + dot(row.ang1, a.angular_velocity());
    if (block.body2 >= 0) {
        const Body& b = body(block.body2);
        s += dot(row.lin2, b.velocity()) + dot(row.ang2, b.angular_velocity());
    }
    return work_.system.h * s;
}

void HeldRows::measure()
{
    worst_ = merit_ = 0;
    for (const Hold& hold : holds_) {
        const Real e = to_close(hold) * hold.per_arm;
        worst_ = std::max(worst_, e);
        merit_ += e * e;
    }
}

Real HeldRows::to_close(const Hold& hold) const
{
    const Row& row = step_row(hold);
    const Real e = hold.error;
    return row.lo == 0 ? std::max(e, Real(0)) : row.hi == 0 ? std::max(-e, Real(0)) : std::fabs(e);
}

Asked HeldRows::asked(bool by_contacts) const
{
    Asked asked;
    for (const Hold& hold : holds_) {
        const Row& row = step_row(hold);
        if ((row.kind == RowKind::kNormal) == by_contacts) asked.add(row, double(to_close(hold)));
    }
    return asked;
}

Real HeldRows::followed_errors() const
{
    Real errors = 0;
    for (const Hold& hold : holds_) errors += hold.follows ? std::fabs(hold.error) : 0;
    return errors;
}

const RowBlock& HeldRows::source_of(std::size_t block) const
{
    return work_.system.blocks[std::size_t(from_[block])];
}

void HeldRows::load_numbers(RowSystem& system, Real softness) const
{
    for (const RowBlock& block : system.blocks)
        for (int i = block.first; i < block.first + block.count; ++i) {
            const Row& row = system.rows[std::size_t(i)];
            const Row& bounds = step_row(holds_[std::size_t(i)]);
            RowNumbers& n = system.numbers[std::size_t(i)];
            n = {};
            const Hold& hold = holds_[std::size_t(i)];
            n.c = hold.error;
            n.C = hold.inertia > 0 ? 1 / hold.inertia
                                   : softness * inverse_effective_mass(system, block, row, system.bodies);
            if (bounds.lo == 0) n.lo = 0;
            if (bounds.hi == 0) n.hi = 0;
        }
}

void HeldRows::begin() { std::copy(holds_.begin(), holds_.end(), before_.begin()); }

void HeldRows::follow(RowSystem& system, Real share)
{
    for (std::size_t k = 0; k < system.blocks.size(); ++k) update(system, k, share);
    measure();
}

void HeldRows::update(RowSystem& system, std::size_t k, Real share)
{
    const RowBlock& block = system.blocks[k];
    Row now[kMaxBlockRows];
    RowWriter out(now, info_);
    if (!block.contact) emit_joint(*work_.joints[std::size_t(from_[k])], out);
    if (block.term_count > 0) place_terms(out.terms(), system, block);
    const int base = source_of(k).first;
    for (int i = block.first; i < block.first + block.count; ++i) {
        Hold& hold = holds_[std::size_t(i)];
        Row& row = system.rows[std::size_t(i)];
        if (hold.follows) {
            hold.error =
                before_[std::size_t(i)].error - share * row_velocity(system, block, row, system.bodies);
        } else if (const int at = hold.source - base; at < out.count()) {
            if (!(hold.inertia > 0)) hold.error = now[at].error;
            static_cast<Jacobian&>(row) = now[at];
        }
    }
}

}  // namespace epode
