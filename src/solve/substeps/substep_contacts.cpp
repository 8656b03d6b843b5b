// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// `begin_pass` writes what a sweep reads, with the same formula for one contact and for several in a
// register.
#include "solve/substeps/substep_contacts.h"

#include <algorithm>
#include <cmath>

#include "simd/pack_memory.h"

namespace epode {
namespace {

[[gnu::always_inline]] inline Real at_most(Real bound, Real x) { return bound < x ? bound : x; }
[[gnu::always_inline]] inline Real if_positive(Real test, Real yes, Real no) { return test > 0 ? yes : no; }

using NumberPack = TwoVectors<Lanes>;

// A contact that has closed exactly is open or not by rounding, and an open one is rigid where a closed one
// is soft: up to this gap, in m, it counts as closed.
constexpr Real kJustClosed = kSingle ? Real(1e-6) : Real(1e-10);

// T: Real or NumberPack.
template <typename T>
struct PassInput {
    T error, speed, cap, rate, max_bias_velocity, effective_mass, C, rigid_mass;
};

template <typename T>
[[gnu::always_inline]] inline void begin_pass(const PassInput<T>& in, T zero, T per_hs, T& c, T& C,
                                              T& effective_mass)
{
    const T separation = -in.error - T(kJustClosed);
    const T bias = at_most(in.max_bias_velocity, in.rate * in.error);
    c = at_most(in.cap, if_positive(separation, per_hs * in.error, bias) + in.speed);
    C = if_positive(separation, zero, in.C);
    effective_mass = if_positive(separation, in.rigid_mass, in.effective_mass);
}

void begin_pass(const NormalAim<Real>& a, int pass, Real per_hs, PackedRow& row)
{
    const PassInput<Real> in{
        a.error,   a.speed,     a.cap, a.rate[pass], a.max_bias_velocity, a.effective_mass[pass],
        a.C[pass], a.rigid_mass};
    Real C;
    begin_pass(in, Real(0), per_hs, row.c, C, row.effective_mass);
    row.impulse_scale = 1 - row.effective_mass * C;
}

void begin_pass(const NormalAim<Lanes>& a, int pass, Real per_hs, BatchPoint& point)
{
    for (Part<NumberPack> part{}; part.first() < kLanes; ++part) {
        const PassInput<NumberPack> in{load(a.error, part),
                                       load(a.speed, part),
                                       load(a.cap, part),
                                       load(a.rate[pass], part),
                                       load(a.max_bias_velocity, part),
                                       load(a.effective_mass[pass], part),
                                       load(a.C[pass], part),
                                       load(a.rigid_mass, part)};
        NumberPack c, C, effective_mass;
        begin_pass(in, NumberPack{}, NumberPack(per_hs), c, C, effective_mass);
        store(point.c, part, c), store(point.C, part, C),
            store(point.effective_mass[0], part, effective_mass);
    }
}

NormalAim<Real> aim_of(const Row& row, const Substep& step, Real inverse_mass, bool against_static)
{
    const RowAim aim =
        row.soft ? map_row(row, step, inverse_mass) : default_contact(step, inverse_mass, against_static);
    NormalAim<Real> out{};
    if (!(inverse_mass > 0)) return out;
    out.error = row.error, out.speed = row.speed, out.cap = row.cap;
    out.max_bias_velocity = aim.max_bias_velocity;
    out.rigid_mass = 1 / inverse_mass;
    const Real effective_mass = 1 / (inverse_mass + aim.C);
    out.rate[0] = aim.rate, out.effective_mass[0] = effective_mass, out.C[0] = aim.C;
    out.rate[1] = aim.spring ? out.rate[0] : 0;
    out.effective_mass[1] = aim.spring ? effective_mass : out.rigid_mass;
    out.C[1] = aim.spring ? aim.C : 0;
    return out;
}

void set_lane(const NormalAim<Real>& a, int lane, NormalAim<Lanes>& out)
{
    out.error[lane] = a.error, out.speed[lane] = a.speed, out.cap[lane] = a.cap,
    out.max_bias_velocity[lane] = a.max_bias_velocity;
    out.rigid_mass[lane] = a.rigid_mass;
    for (int k = 0; k < 2; ++k) {
        out.rate[k][lane] = a.rate[k], out.effective_mass[k][lane] = a.effective_mass[k],
        out.C[k][lane] = a.C[k];
    }
}

// Friction and rolling rows are dampers: the same in every pass.
void set_tangent_numbers(RowSystem& system, const RowBlock& block, const Substep& step)
{
    RowNumbers* numbers = &system.numbers[std::size_t(block.first)];
    const Row* rows = &system.rows[std::size_t(block.first)];
    numbers[0].c = numbers[0].C = 0;  // set again in every pass
    for (int k = 1; k < block.count; ++k) {
        numbers[k].c = std::min(rows[k].speed, rows[k].cap);
        numbers[k].C = rows[k].cfm / step.hs;
    }
}

const SolverBody* body_or_null(const RowSystem& system, int index)
{
    return index >= 0 ? &system.bodies[std::size_t(index)] : nullptr;
}

}  // namespace

bool SubstepContacts::prepare(RowSystem& system, const Substep& step, std::uint64_t seed, Arena& arena)
{
    random_ = CounterRandom(seed);
    hs_ = step.hs;
    auto skip = arena.take<bool>(int(system.blocks.size()));
    if (skip.empty()) return false;
    for (const RowBlock& block : system.blocks)
        if (block.contact) set_tangent_numbers(system, block, step);
    if (!rows_.gather(system, skip, arena) || !set_.pack(system, rows_.list(), 1, arena)) return false;
    for (std::size_t i = 0; i < skip.size(); ++i) skip[i] = skip[i] || !system.blocks[i].contact;
    if (!others_.pack(system, 1, skip, arena)) return false;
    aims_ = arena.take_zeroed<NormalAim<Lanes>>(int(set_.points().size()));
    other_aims_ = arena.take<NormalAim<Real>>(int(others_.blocks().size()));
    if (arena.failed()) return false;
    aim(system, step);
    return true;
}

template <typename Visit>
void SubstepContacts::for_each_lane(Visit&& f) const
{
    for (std::size_t i = 0; i < set_.sources().size(); ++i)
        for (int lane = 0; lane < kLanes; ++lane)
            if (const int point = set_.sources()[i].point[lane]; point >= 0) f(rows_.row_of(point), i, lane);
}

void SubstepContacts::aim(const RowSystem& system, const Substep& step)
{
    const auto aim_block = [&](int row, int body1, int body2) {
        const SolverBody& a = system.bodies[std::size_t(body1)];
        const SolverBody* b = body_or_null(system, std::size_t(body2) < system.bodies.size() ? body2 : -1);
        const Row& normal = system.rows[std::size_t(row)];
        const bool against_static = !b || !(a.inv_mass > 0) || !(b->inv_mass > 0);
        return aim_of(normal, step, inverse_effective_mass(normal, a, b), against_static);
    };
    for (const ContactBatch& batch : set_.batches())
        for (int i = batch.first; i < batch.first + batch.count; ++i)
            for (int lane = 0; lane < kLanes; ++lane)
                if (const int point = set_.sources()[std::size_t(i)].point[lane]; point >= 0)
                    set_lane(aim_block(rows_.row_of(point), batch.body1(lane), batch.body2(lane)), lane,
                             aims_[std::size_t(i)]);
    for (std::size_t i = 0; i < other_aims_.size(); ++i) {
        const PackedBlock& block = others_.blocks()[i];
        other_aims_[i] = aim_block(others_.rows()[std::size_t(block.first)].source, block.body1, block.body2);
    }
}

void SubstepContacts::apply_impulses(std::span<Velocity> bodies) const
{
    set_.apply_impulses(bodies);
    others_.apply_impulses(bodies);
}

void SubstepContacts::sweep(std::span<Velocity> bodies, bool relax)
{
    const int pass = relax ? 1 : 0;
    const Real per_hs = 1 / hs_;
    for (std::size_t i = 0; i < aims_.size(); ++i) begin_pass(aims_[i], pass, per_hs, set_.points()[i]);
    for (std::size_t i = 0; i < other_aims_.size(); ++i) {
        PackedRow& row = others_.rows()[std::size_t(others_.blocks()[i].first)];
        begin_pass(other_aims_[i], pass, per_hs, row);
    }
    others_.sweep(bodies, relax);
    set_.shuffle(random_);
    set_.sweep(bodies);
}

void SubstepContacts::follow_motion(std::span<const Velocity> bodies)
{
    Lanes approach[kManifoldPoints];
    for (const ContactBatch& batch : set_.batches()) {
        set_.normal_velocities(batch, bodies, approach);
        for (int i = 0; i < batch.count; ++i)
            for (int lane = 0; lane < kLanes; ++lane)
                aims_[std::size_t(batch.first + i)].error[lane] -= hs_ * approach[i][lane];
    }
    for (std::size_t i = 0; i < other_aims_.size(); ++i) {
        const PackedBlock& block = others_.blocks()[i];
        other_aims_[i].error -=
            hs_ * row_velocity(others_.rows()[std::size_t(block.first)], bodies[std::size_t(block.body1)],
                               bodies[std::size_t(block.body2)]);
    }
}

void SubstepContacts::add_impulses(std::span<RowNumbers> numbers)
{
    set_.store_impulses(rows_.list().points);
    rows_.for_each_impulse([&](int row, Real p) { numbers[std::size_t(row)].p += p; });
    for (const PackedRow& row : others_.rows()) numbers[std::size_t(row.source)].p += row.p;
}

bool SubstepContacts::may_rebound(const RowSystem& system) const
{
    return std::any_of(system.blocks.begin(), system.blocks.end(), [&](const RowBlock& block) {
        return block.contact && system.rows[std::size_t(block.first)].has_restitution;
    });
}

bool SubstepContacts::expect_rebounds(const RowSystem& system, std::span<const Velocity> now,
                                      std::span<const Velocity> by_forces, Arena& arena)
{
    falls_ = arena.take<Fall>(int(system.blocks.size()));
    if (arena.failed()) return false;
    std::size_t count = 0;
    for (const RowBlock& block : system.blocks) {
        const Row& row = system.rows[std::size_t(block.first)];
        if (!block.contact || !row.has_restitution) continue;
        const auto approach = [&](std::span<const Velocity> of) {
            const Velocity &a = of[std::size_t(block.body1)],
                           &b = of[std::size_t(second_slot(system, block.body2))];
            return -(dot(row.lin1, a.v) + dot(row.ang1, a.w) + dot(row.lin2, b.v) + dot(row.ang2, b.w));
        };
        falls_[count++] = {block.first, approach(now), approach(by_forces)};
    }
    falls_ = falls_.first(count);
    return true;
}

void SubstepContacts::correct_rebounds(RowSystem& system)
{
    const auto correct = [&](int index, Real error) {
        const auto fall = std::lower_bound(falls_.begin(), falls_.end(), index,
                                           [](const Fall& f, int row) { return f.row < row; });
        if (fall == falls_.end() || fall->row != index || !(fall->d > 0) || !(fall->u > 0)) return;
        Row& row = system.rows[std::size_t(index)];
        const Real out = row.error - error, middle = fall->u + fall->d / 2;
        const Real left = middle * middle - 2 * out * fall->d / hs_;
        const Real w = fall->d / 2 + std::sqrt(std::max(left, Real(0)));
        row.restitution_velocity = row.speed + (row.restitution_velocity - row.speed) * (w / fall->u);
    };
    if (falls_.empty()) return;
    for_each_lane([&](int row, std::size_t point, int lane) { correct(row, aims_[point].error[lane]); });
    for (std::size_t i = 0; i < other_aims_.size(); ++i)
        correct(others_.rows()[std::size_t(others_.blocks()[i].first)].source, other_aims_[i].error);
}

void SubstepContacts::describe(std::span<RowNumbers> numbers)
{
    set_.store_impulses(rows_.list().points);
    rows_.for_each_impulse([&](int row, Real p) { numbers[std::size_t(row)].p = p; });
    others_.store_impulses(numbers);
    for_each_lane([&](int row, std::size_t point, int lane) {
        const BatchPoint& p = set_.points()[point];
        numbers[std::size_t(row)].c = p.c[lane];
        numbers[std::size_t(row)].C = p.effective_mass[0][lane] > 0 ? p.C[lane] : 0;
    });
    for (const PackedBlock& block : others_.blocks()) {
        const PackedRow& row = others_.rows()[std::size_t(block.first)];
        RowNumbers& normal = numbers[std::size_t(row.source)];
        normal.c = row.c;
        normal.C = row.effective_mass > 0 ? (1 - row.impulse_scale) / row.effective_mass : 0;
    }
}

}  // namespace epode
