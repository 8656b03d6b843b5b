// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "solve/common/contact_rows.h"

#include <algorithm>

namespace epode {
namespace {

bool same_friction(const JointManifold& a, const JointManifold& b)
{
    for (int k = 0; k < 2; ++k)
        if (a.c[k] != b.c[k] || a.C[k] != b.C[k] || a.mu[k] != b.mu[k] || a.fixed[k] != b.fixed[k])
            return false;
    return a.t1 == b.t1 && a.t2 == b.t2 && a.cone == b.cone;
}

bool joins(const JointManifold& m, const JointManifold& next)
{
    return m.count < kManifoldPoints && m.body1 == next.body1 && m.body2 == next.body2 && m.n == next.n &&
           same_friction(m, next);
}

JointManifoldPoint point_of(const RowSystem& system, const RowBlock& block)
{
    const RowNumbers* numbers = &system.numbers[std::size_t(block.first)];
    JointManifoldPoint point{
        block.arms.r1, numbers[0].c, numbers[0].C, system.rows[std::size_t(block.first)].error, {}};
    for (int k = 0; k < block.count; ++k) point.p[k] = numbers[k].p;
    return point;
}

void expand_point(const JointManifold& m, const JointManifoldPoint& point, int first, Row* rows,
                  RowNumbers* numbers)
{
    const Vec3 d[3] = {m.n, m.t1, m.t2}, r2 = point.r1 + m.offset;
    for (int k = 0; k < 3; ++k) {
        rows[k] = {};
        static_cast<Jacobian&>(rows[k]) = {d[k], cross(point.r1, d[k]), -d[k], -cross(r2, d[k])};
        numbers[k] = {};
        numbers[k].p = point.p[k];
    }
    numbers[0].c = point.c, numbers[0].C = point.C, numbers[0].lo = 0;
    for (int k = 1; k < 3; ++k) {
        numbers[k].c = m.c[k - 1], numbers[k].C = m.C[k - 1];
        const bool shares = m.mu[k - 1] > 0;
        numbers[k].parent = shares ? first : -1;
        numbers[k].hi = shares ? m.mu[k - 1] : m.fixed[k - 1];
        numbers[k].lo = -numbers[k].hi;
    }
}

template <typename T>
std::span<T> with_capacity(std::span<T> from, int more, Arena& arena)
{
    auto out = arena.take<T>(int(from.size()) + more);
    if (!out.empty()) std::copy(from.begin(), from.end(), out.begin());
    return out;
}

}  // namespace

bool has_contact_form(const RowSystem& system, const RowBlock& block)
{
    if (!block.contact || (block.count != 1 && block.count != 3)) return false;
    const auto first = std::size_t(block.first);
    const RowNumbers& normal = system.numbers[first];
    if (normal.parent >= 0 || normal.lo != 0 || normal.hi < kInf) return false;
    for (std::size_t k = first + 1; k < first + std::size_t(block.count); ++k) {
        const RowNumbers& n = system.numbers[k];
        if (n.lo != -n.hi || !(n.hi >= 0) || (n.parent >= 0 && n.parent != block.first)) return false;
        if (system.rows[k].lin1 == Vec3{}) return false;  // rolling friction
    }
    return true;
}

JointManifold manifold_of(const RowSystem& system, const RowBlock& block)
{
    const Row* rows = &system.rows[std::size_t(block.first)];
    const RowNumbers* numbers = &system.numbers[std::size_t(block.first)];
    JointManifold m{};
    m.body1 = block.body1, m.body2 = block.body2;
    m.n = rows[0].lin1;
    m.cone = block.cone;
    if (block.body2 >= 0) m.offset = block.arms.r2 - block.arms.r1;
    if (block.count == 1) return m;
    m.t1 = rows[1].lin1, m.t2 = rows[2].lin1;
    for (int k = 0; k < 2; ++k) {
        const RowNumbers& n = numbers[k + 1];
        m.c[k] = n.c, m.C[k] = n.C;
        (n.parent >= 0 ? m.mu[k] : m.fixed[k]) = n.hi;
    }
    return m;
}

bool has_cone(const RowSystem& system, const RowBlock& block)
{
    if (!block.cone || block.count < 3) return false;
    const Row* rows = &system.rows[std::size_t(block.first)];
    return rows[1].lin1 != Vec3{} && rows[2].lin1 != Vec3{};
}

bool ContactRows::reserve(const RowSystem& system, int contacts, Arena& arena)
{
    list_.manifolds = with_capacity(system.joint_contacts.manifolds, contacts, arena);
    list_.points = with_capacity(system.joint_contacts.points, contacts, arena);
    rows_ = arena.take<PointRows>(contacts);
    return !arena.failed();
}

bool ContactRows::gather(const RowSystem& system, std::span<bool> taken, Arena& arena)
{
    list_ = system.joint_contacts;
    given_ = list_.points.size();
    int contacts = 0;
    for (std::size_t i = 0; i < system.blocks.size(); ++i) {
        taken[i] = has_contact_form(system, system.blocks[i]);
        contacts += taken[i];
    }
    if (contacts == 0) return true;
    std::size_t manifolds = list_.manifolds.size(), points = given_;
    if (!reserve(system, contacts, arena)) return false;
    bool open = false;  // true if the next block may join the last manifold
    for (std::size_t i = 0; i < system.blocks.size(); ++i) {
        const RowBlock& block = system.blocks[i];
        if (taken[i]) {
            JointManifold next = manifold_of(system, block);
            if (!open || !joins(list_.manifolds[manifolds - 1], next)) {
                next.first = int(points);
                list_.manifolds[manifolds++] = next;
            }
            ++list_.manifolds[manifolds - 1].count;
            rows_[points - given_] = {block.first, block.count};
            list_.points[points++] = point_of(system, block);
        }
        open = taken[i];
    }
    list_.manifolds = list_.manifolds.first(manifolds);
    list_.points = list_.points.first(points);
    rows_ = rows_.first(points - given_);
    return true;
}

void ContactRows::store_impulses(RowSystem& system) const
{
    if (list_.points.data() != system.joint_contacts.points.data())
        std::copy_n(list_.points.begin(), given_, system.joint_contacts.points.begin());
    for_each_impulse([&](int row, Real p) { system.numbers[std::size_t(row)].p = p; });
}

bool expand_manifolds(const RowSystem& system, Arena& arena, RowSystem& out)
{
    const int points = int(system.joint_contacts.points.size());
    out = system;
    out.joint_contacts = {};
    out.rows = with_capacity(system.rows, 3 * points, arena);
    out.numbers = with_capacity(system.numbers, 3 * points, arena);
    out.blocks = with_capacity(system.blocks, points, arena);
    if (arena.failed()) return false;
    int row = int(system.rows.size());
    std::size_t block = system.blocks.size();
    for (const JointManifold& m : system.joint_contacts.manifolds)
        for (int i = m.first; i < m.first + m.count; ++i, row += 3) {
            const JointManifoldPoint& point = system.joint_contacts.points[std::size_t(i)];
            expand_point(m, point, row, &out.rows[std::size_t(row)], &out.numbers[std::size_t(row)]);
            out.blocks[block] = {row, 3, m.body1, m.body2, true, {point.r1, point.r1 + m.offset}};
            out.blocks[block++].cone = m.cone;
        }
    return true;
}

}  // namespace epode
