// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "solve/substeps/impacts/restitution.h"

#include <algorithm>

#include "rows/wrench.h"
#include "solve/substeps/impacts/impact_friction.h"

namespace epode {
namespace {

constexpr int kSweeps = 50;
constexpr Real kSettled = Real(1e-4);  // velocity that is left, of the fastest rebound

}  // namespace

bool Restitution::rebounds_at(const RowBlock& block) const
{
    const auto normal = std::size_t(block.first);
    return block.contact && system_.rows[normal].has_restitution && system_.numbers[normal].p > 0;
}

bool Restitution::rebounds_in(int part) const
{
    const SystemPart from = system_.begin_of(part), to = system_.end_of(part);
    for (int k = from.blocks; k < to.blocks; ++k)
        if (rebounds_at(system_.blocks[std::size_t(k)])) return true;
    if (rebounds_.empty()) return false;
    const auto first = rebounds_.begin() + from.contact_manifolds * kManifoldPoints,
               last = rebounds_.begin() + to.contact_manifolds * kManifoldPoints;
    return std::any_of(first, last, [](float c) { return c > 0; });
}

bool Restitution::any() const
{
    for (int part = 0; part < system_.worlds(); ++part)
        if (rebounds_in(part)) return true;
    return false;
}

bool Restitution::apply(std::span<const Row> rows, Arena& arena)
{
    for (int part = 0; part < system_.worlds(); ++part) {
        if (!rebounds_in(part)) continue;
        Arena::Scope scope(arena);
        const SystemPart from = system_.begin_of(part), to = system_.end_of(part);
        list_ = arena.take<ImpactRow>(row_limit(from, to));
        changed_ = arena.take_zeroed<int>(int(system_.bodies.size()));
        if (arena.failed()) return false;
        list_rows(from, to, rows);
        clock_ = 0;
        for (int i = 0; i < kSweeps && sweep(); ++i) {}
        store();
        if (!rub(arena)) return false;
    }
    return true;
}

// Friction turns bodies, so that what rebounds may approach again: more impulses, none less, end that.
bool Restitution::rub(Arena& arena)
{
    ImpactFriction friction(system_, arena.take<ImpactFriction::Pair>(int(count_)));
    if (arena.failed()) return false;
    for (const ImpactRow& row : list_.first(count_)) {
        if (row.pulls || !(row.dp > 0)) continue;
        if (row.point)
            friction.add(*row.manifold, *row.point);
        else
            friction.add(system_.blocks[std::size_t(row.block)], row.block,
                         system_.numbers[std::size_t(row.source)].p);
    }
    friction.solve(kSettled * fastest_, kSweeps);
    friction.store();
    for (const ImpactFriction::Pair& pair : friction.pairs()) touch(pair.body1, pair.body2);
    for (ImpactRow& row : list_.first(count_)) {
        row.p = row.dp = 0;
        if (!row.pulls) row.c = std::min(row.c, Real(0));
    }
    for (int i = 0; i < kSweeps && sweep(); ++i) {}
    store();
    return true;
}

int Restitution::last_change(int body1, int body2) const
{
    return std::max(changed_[std::size_t(body1)], body2 >= 0 ? changed_[std::size_t(body2)] : 0);
}

void Restitution::touch(int body1, int body2)
{
    ++clock_;
    changed_[std::size_t(body1)] = clock_;
    if (body2 >= 0) changed_[std::size_t(body2)] = clock_;
}

int Restitution::row_limit(const SystemPart& from, const SystemPart& to) const
{
    int rows = (to.contact_manifolds - from.contact_manifolds) * kManifoldPoints;
    for (int k = from.blocks; k < to.blocks; ++k) {
        const RowBlock& block = system_.blocks[std::size_t(k)];
        rows += block.contact ? 1 : block.count;
    }
    return rows;
}

bool Restitution::is_fixed(int body1, int body2) const
{
    const auto moves = [&](int body) { return body >= 0 && system_.bodies[std::size_t(body)].inv_mass > 0; };
    return !moves(body1) || !moves(body2);
}

// Contacts against what cannot move have the last word.
void Restitution::list_rows(const SystemPart& from, const SystemPart& to, std::span<const Row> rows)
{
    count_ = 0, fastest_ = 0;
    list_contacts(from, to, false);
    list_joints(from, to, rows);
    list_contacts(from, to, true);
}

void Restitution::list_contacts(const SystemPart& from, const SystemPart& to, bool fixed)
{
    for (int k = from.blocks; k < to.blocks; ++k) {
        const RowBlock& block = system_.blocks[std::size_t(k)];
        if (!block.contact || is_fixed(block.body1, block.body2) != fixed) continue;
        const Row& row = system_.rows[std::size_t(block.first)];
        if (!(system_.numbers[std::size_t(block.first)].p > 0) && row.error < 0) continue;
        const Real p = system_.numbers[std::size_t(block.first)].p;
        add({row, block.body1, block.body2, 0, p, false, k, block.first, nullptr, nullptr},
            rebounds_at(block) ? row.restitution_velocity : std::min(row.restitution_velocity, Real(0)));
    }
    for (int k = from.contact_manifolds; k < to.contact_manifolds; ++k) {
        ContactManifold& manifold = *system_.contact_manifolds[std::size_t(k)];
        if (is_fixed(manifold.body1, manifold.body2) != fixed) continue;
        const Vec3 n = widen(manifold.normal);
        for (int i = 0; i < manifold.count; ++i) {
            ManifoldPoint& point = manifold.points[i];
            if (!(point.normal_impulse > 0) && point.separation > 0) continue;
            const Jacobian J{n, cross(widen(point.r1), n), -n, -cross(widen(point.r2), n)};
            const std::size_t at = std::size_t(k * kManifoldPoints + i);
            add({J, manifold.body1, manifold.body2, 0, Real(point.normal_impulse), false, -1, -1, &manifold,
                 &point},
                rebounds_.empty() ? Real(0) : Real(rebounds_[at]));
        }
    }
}

// Stops, motors and springs do not take part.
void Restitution::list_joints(const SystemPart& from, const SystemPart& to, std::span<const Row> rows)
{
    for (int k = from.blocks; k < to.blocks; ++k) {
        const RowBlock& block = system_.blocks[std::size_t(k)];
        for (int i = block.first; !block.contact && block.term_count == 0 && i < block.first + block.count;
             ++i) {
            const RowNumbers& n = system_.numbers[std::size_t(i)];
            const Row& row = block.followed ? rows[std::size_t(i)] : system_.rows[std::size_t(i)];
            if (n.lo > -kInf || n.hi < kInf || row.soft || row.drive) continue;
            add({row, block.body1, block.body2, row.speed, 0, true, k, i, nullptr, nullptr}, 0);
        }
    }
}

void Restitution::add(const ImpactRow& row, Real rebound)
{
    ImpactRow& to = list_[count_];
    to = row;
    if (to.body2 < 0) to.body2 = -1, to.J.lin2 = to.J.ang2 = {};
    to.d = bodies().freedom(to.J, to.J, to.body1, to.body2);
    if (!(to.d > 0)) return;
    if (row.manifold) to.hi = Real(row.manifold->largest_impulse());
    if (!to.pulls) to.c = rebound > 0 ? rebound : std::min(velocity_of(to), rebound);
    fastest_ = std::max(fastest_, rebound);
    ++count_;
}

Real Restitution::velocity_of(const ImpactRow& row) const
{
    return bodies().velocity(row.J, row.body1, row.body2);
}

// Visits the rows whose bodies have changed since their last visit. False: nothing has changed.
bool Restitution::sweep()
{
    bool any = false;
    for (ImpactRow& row : list_.first(count_)) {
        if (row.seen > last_change(row.body1, row.body2)) continue;
        row.seen = ++clock_;
        const Real wanted = (row.c - velocity_of(row)) / row.d;
        const Real dp =
            row.pulls ? wanted : std::min(std::max(wanted, -row.p - row.dp), row.hi - row.p - row.dp);
        if (!(std::fabs(dp) * row.d > kSettled * fastest_)) continue;
        row.dp += dp;
        bodies().push(row.J, row.body1, row.body2, dp);
        touch(row.body1, row.body2);
        row.seen = ++clock_;
        any = true;
    }
    return any;
}

// Joints begin the next step with what they carried before the impact.
void Restitution::store() const
{
    for (const ImpactRow& row : list_.first(count_)) {
        if (row.point) {
            row.point->normal_impulse += float(row.dp);
            continue;
        }
        if (!row.pulls) system_.numbers[std::size_t(row.source)].p += row.dp;
        const RowBlock& block = system_.blocks[std::size_t(row.block)];
        if (block.wrench < 0) continue;
        Row exerts;
        static_cast<Jacobian&>(exerts) = row.J;
        system_.wrenches[std::size_t(block.wrench)].add(block, row.source, exerts, row.dp);
    }
}

}  // namespace epode
