// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "solve/exact/frozen_friction.h"

#include <algorithm>
#include <cmath>

#include "math/hypotenuse.h"

namespace epode {
namespace {

constexpr Real kLeastCompliance = sizeof(Real) == 8 ? Real(1e-8) : Real(1e-6);  // of J M^-1 J^T

}  // namespace

bool FrozenFriction::prepare(Arena& arena)
{
    const int rows = int(system_.rows.size()), blocks = int(system_.blocks.size());
    const int bodies = int(system_.bodies.size());
    frozen_.rows = arena.take<Row>(rows);
    frozen_.numbers = arena.take<RowNumbers>(rows);
    kept_impulses_ = arena.take<Real>(rows);
    begun_ = arena.take<Twist>(bodies), kept_twists_ = arena.take<Twist>(bodies);
    normals_ = arena.take_zeroed<double>(blocks), weights_ = arena.take_zeroed<double>(blocks);
    turns_ = arena.take<Turn>(blocks);
    if (arena.failed() || !anderson_.prepare(blocks, arena)) return false;
    std::copy(system_.rows.begin(), system_.rows.end(), frozen_.rows.begin());
    for (std::size_t i = 0; i < system_.blocks.size(); ++i)
        if (const RowBlock& block = system_.blocks[i]; block.coulomb) {
            weights_[i] = double(inverse_mass(block, std::size_t(block.first)));
            for (int k = block.first; k < block.first + block.count; ++k) yield(block, std::size_t(k));
        }
    frozen_.nearly_solved = true;
    save(begun_);
    measure_scale();
    return true;
}

// Without any compliance a load has many distributions over redundant contacts, and each solve may find another.
void FrozenFriction::yield(const RowBlock& block, std::size_t row)
{
    Real& C = system_.numbers[row].C;
    C = std::max(C, kLeastCompliance * inverse_mass(block, row));
}

Real FrozenFriction::judge()
{
    Real worst = 0;
    for (std::size_t i = 0; i < system_.blocks.size(); ++i) {
        const RowBlock& block = system_.blocks[i];
        if (!block.coulomb) continue;
        normals_[i] = double(normal_impulse(block));
        worst = std::max(worst, judge(block));
    }
    return worst / scale_;
}

// d |p - clip(q)|, the largest over the disc and the rows with limits of their own.
Real FrozenFriction::judge(const RowBlock& block) const
{
    const auto last = std::size_t(block.first + block.count);
    const Real normal = normal_impulse(block);
    Real worst = 0;
    std::size_t k = std::size_t(block.first) + 1;
    if (is_disc(block)) {
        const Sliding now = sliding(block);
        const Real L = limit(k, normal), share = now.length > L ? L / now.length : 1;
        for (int i = 0; i < 2; ++i) worst = std::max(worst, now.d * std::fabs(now.p[i] - share * now.q[i]));
        k += 2;
    }
    for (; k < last; ++k) {
        const Real d = inverse_mass(block, k), p = system_.numbers[k].p, L = limit(k, normal);
        if (!(d > 0)) continue;
        const Real q = p - slip(block, k) / d;
        worst = std::max(worst, d * std::fabs(p - std::min(std::max(q, -L), L)));
    }
    return worst;
}

RowSystem& FrozenFriction::freeze()
{
    anderson_.advance(normals_, weights_);
    std::copy(system_.numbers.begin(), system_.numbers.end(), frozen_.numbers.begin());
    for (std::size_t i = 0; i < system_.blocks.size(); ++i)
        if (system_.blocks[i].coulomb) freeze(system_.blocks[i], Real(anderson_.x()[i]), turns_[i]);
    load(begun_);
    return frozen_;
}

void FrozenFriction::freeze(const RowBlock& block, Real normal, Turn& turn)
{
    const auto last = std::size_t(block.first + block.count);
    std::size_t k = std::size_t(block.first) + 1;
    turn = {};
    if (is_disc(block)) turn = freeze_disc(block, normal), k += 2;
    for (; k < last; ++k) set_limit(k, limit(k, normal));
}

FrozenFriction::Turn FrozenFriction::freeze_disc(const RowBlock& block, Real normal)
{
    const auto k = std::size_t(block.first) + 1;
    const Sliding now = sliding(block);
    const Real L = limit(k, normal);
    Turn turn{.ratio = ratio(k)};
    if (now.length > 0 && L > 0) turn.c = now.q[0] / now.length, turn.s = now.q[1] / now.length;
    turn_tangents(k, turn);
    set_limit(k, L), set_limit(k + 1, L);
    frozen_.numbers[k].p = std::min(now.length, L), frozen_.numbers[k + 1].p = 0;
    if (L > 0) frozen_.numbers[k + 1].C += now.speed / L;
    couple(k, turn, now);
    return turn;
}

void FrozenFriction::turn_tangents(std::size_t first, Turn turn)
{
    const Row *a = &system_.rows[first], *b = a + 1;
    const RowNumbers *m = &system_.numbers[first], *n = m + 1;
    const Real c = turn.c, s = turn.s, rc = turn.ratio * c, rs = turn.ratio * s;
    const auto mix = [&](Real x, Real y) {
        return Jacobian{x * a->lin1 + y * b->lin1, x * a->ang1 + y * b->ang1, x * a->lin2 + y * b->lin2,
                        x * a->ang2 + y * b->ang2};
    };
    static_cast<Jacobian&>(frozen_.rows[first]) = mix(c, rs);
    static_cast<Jacobian&>(frozen_.rows[first + 1]) = mix(-s, rc);
    RowNumbers* out = &frozen_.numbers[first];
    out[0].c = c * m->c + rs * n->c, out[1].c = rc * n->c - s * m->c;
    out[0].C = c * c * m->C + rs * rs * n->C, out[1].C = s * s * m->C + rc * rc * n->C;
}

// Where the compliances of the two differ, each turned direction yields to the other's impulse, too: that of the last answer.
void FrozenFriction::couple(std::size_t first, Turn turn, const Sliding& last)
{
    const RowNumbers *m = &system_.numbers[first], *n = m + 1;
    const Real mixed = turn.c * turn.s * (turn.ratio * turn.ratio * n->C - m->C);
    if (mixed == 0) return;
    frozen_.numbers[first].c -= mixed * (turn.c * last.p[1] - turn.s * last.p[0]);
    frozen_.numbers[first + 1].c -= mixed * (turn.c * last.p[0] + turn.s * last.p[1]);
}

void FrozenFriction::turn_back(std::size_t first, Turn turn)
{
    RowNumbers* n = &system_.numbers[first];
    const Real along = n[0].p, across = n[1].p;
    n[0].p = turn.c * along - turn.s * across;
    n[1].p = turn.ratio * (turn.s * along + turn.c * across);
}

void FrozenFriction::set_limit(std::size_t row, Real limit)
{
    RowNumbers& n = frozen_.numbers[row];
    n.parent = -1, n.hi = limit, n.lo = -limit;
}

void FrozenFriction::thaw()
{
    for (std::size_t i = 0; i < system_.numbers.size(); ++i) system_.numbers[i].p = frozen_.numbers[i].p;
    for (std::size_t i = 0; i < system_.blocks.size(); ++i)
        if (const RowBlock& block = system_.blocks[i]; block.coulomb && is_disc(block))
            turn_back(std::size_t(block.first) + 1, turns_[i]);
}

void FrozenFriction::keep()
{
    save(kept_twists_);
    for (std::size_t i = 0; i < kept_impulses_.size(); ++i) kept_impulses_[i] = system_.numbers[i].p;
}

void FrozenFriction::restore()
{
    load(kept_twists_);
    for (std::size_t i = 0; i < kept_impulses_.size(); ++i) system_.numbers[i].p = kept_impulses_[i];
}

// Two directions of sliding, whose limits are in a fixed ratio. All other rows have limits of their own.
bool FrozenFriction::is_disc(const RowBlock& block) const
{
    if (block.count < 3) return false;
    const auto k = std::size_t(block.first) + 1;
    const RowNumbers &a = system_.numbers[k], &b = system_.numbers[k + 1];
    const bool tangents = system_.rows[k].lin1 != Vec3{} && system_.rows[k + 1].lin1 != Vec3{};
    return tangents && a.parent == b.parent && a.hi > 0 && a.hi < kInf && b.hi > 0 && b.hi < kInf;
}

Real FrozenFriction::ratio(std::size_t first) const
{
    return system_.numbers[first + 1].hi / system_.numbers[first].hi;
}

FrozenFriction::Sliding FrozenFriction::sliding(const RowBlock& block) const
{
    const auto k = std::size_t(block.first) + 1;
    const Real r = ratio(k);
    Sliding out;
    out.d = std::max(inverse_mass(block, k), r * r * inverse_mass(block, k + 1));
    if (!(out.d > 0)) return out;
    const Real w[2] = {slip(block, k), r * slip(block, k + 1)};
    out.p[0] = system_.numbers[k].p, out.p[1] = system_.numbers[k + 1].p / r;
    for (int i = 0; i < 2; ++i) out.q[i] = out.p[i] - w[i] / out.d;
    out.length = hypotenuse(out.q[0], out.q[1]);
    if (out.length > 0) out.speed = std::max(-(w[0] * out.q[0] + w[1] * out.q[1]) / out.length, Real(0));
    return out;
}

Real FrozenFriction::limit(std::size_t row, Real normal) const
{
    const RowNumbers& n = system_.numbers[row];
    if (n.parent < 0) return n.hi;
    return normal > 0 ? n.hi * normal : 0;  // not infinity times 0
}

Real FrozenFriction::normal_impulse(const RowBlock& block) const
{
    return std::fabs(system_.numbers[std::size_t(block.first)].p);
}

Real FrozenFriction::inverse_mass(const RowBlock& block, std::size_t row) const
{
    return inverse_effective_mass(system_, block, system_.rows[row], system_.bodies) + system_.numbers[row].C;
}

// w = J v + C p - c
Real FrozenFriction::slip(const RowBlock& block, std::size_t row) const
{
    const RowNumbers& n = system_.numbers[row];
    return row_velocity(system_, block, system_.rows[row], system_.bodies) + n.C * n.p - n.c;
}

// That of the natural residual (solve/common/residual.h).
void FrozenFriction::measure_scale()
{
    Real scale = 0;
    for (const RowBlock& block : system_.blocks)
        for (int i = block.first; i < block.first + block.count; ++i) {
            const Real c = system_.numbers[std::size_t(i)].c;
            const Real now = row_velocity(system_, block, system_.rows[std::size_t(i)], system_.bodies);
            scale = std::max({scale, std::fabs(c), std::fabs(c - now)});
        }
    scale_ = scale > 0 ? scale : 1;
}

void FrozenFriction::save(std::span<Twist> out) const
{
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = {system_.bodies[i].v, system_.bodies[i].w};
}

void FrozenFriction::load(std::span<const Twist> in)
{
    for (std::size_t i = 0; i < in.size(); ++i) system_.bodies[i].v = in[i].v, system_.bodies[i].w = in[i].w;
}

}  // namespace epode
