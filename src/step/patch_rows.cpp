// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/patch_rows.h"

#include <algorithm>

#include "tasks/prefetched.h"

namespace epode {
namespace {

constexpr int kPointRows = 3, kRollingRows = 3;

int rows_of_point(const Patch& patch) { return kPointRows + (patch.rolling > 0 ? kRollingRows : 0); }

Row& point_row(RowWriter& out, Vec3 d, RowKind kind)
{
    const ContactArms& arms = out.arms();
    Row& row = out.row({d, cross(arms.r1, d), -d, -cross(arms.r2, d)}, 0, kind);
    row.lo = 0;
    return row;
}

Real approach_of(const Row& row, const Island& island, const Patch& patch)
{
    const auto velocity = [&](int index, Vec3 lin, Vec3 ang) {
        if (index < 0) return Real(0);
        const Body& body = *island.bodies[std::size_t(index)];
        return dot(lin, body.velocity()) + dot(ang, body.angular_velocity());
    };
    return -(velocity(patch.body1, row.lin1, row.ang1) + velocity(patch.body2, row.lin2, row.ang2));
}

// The spring and damper of ERP = h k / (h k + d) and CFM = 1 / (h k + d).
void soften(Row& normal, const Patch& patch, Real gap, Real h)
{
    const Real rest = h + Real(patch.damping_time);
    normal.erp = h / rest, normal.cfm = Real(patch.softness) / rest;
    normal.soft = true;
    normal.error = -gap;
}

void write_rolling(RowWriter& out, const Patch& patch)
{
    const Vec3 n = widen(patch.normal);
    Vec3 axes[3] = {{}, {}, n};
    plane_space(n, axes[0], axes[1]);
    for (const Vec3& a : axes) {
        Row& row = out.row({{}, a, {}, -a}, 0, RowKind::kFriction);
        row.hi = Real(patch.rolling), row.lo = -row.hi;
        row.parent = 0;
    }
}

// An open contact may close, but no further.
void write_point(RowWriter& out, const Island& island, const Patch& patch, const PatchPoint& point)
{
    out.contact_at(widen(point.r1), widen(point.r2));
    const Vec3 n = widen(patch.normal);
    Row& normal = point_row(out, n, RowKind::kNormal);
    const Real gap = point.gap;
    if (patch.softness > 0) {
        soften(normal, patch, gap, out.info().h);
    } else {
        normal.error = std::max(-gap, Real(0));
        normal.speed = gap > 0 ? -gap * out.info().fps : 0;
        normal.cap = out.info().contact_max_vel;
    }
    const Real approach = approach_of(normal, island, patch);
    if (patch.bounce > 0 && approach > patch.bounce_speed && approach > gap * out.info().fps) {
        normal.rebounds = true;
        normal.rebound = Real(patch.bounce) * approach;
    }
    Vec3 t[2];
    plane_space(n, t[0], t[1]);
    for (const Vec3& d : t) {
        Row& row = point_row(out, d, RowKind::kFriction);
        row.speed = dot(widen(patch.drift), d);
        row.hi = Real(patch.mu);
        row.lo = -row.hi;
        row.parent = 0;
    }
    if (patch.rolling > 0) write_rolling(out, patch);
}

// f(patch, point, block) for each point and its block, in order.
template <typename Visit>
void for_points(const IslandWork& work, Visit&& visit)
{
    std::size_t block = work.joints.size();
    for (PatchEdge* edge : work.island.patches)
        for (int i = 0; i < edge->patch->count; ++i)
            visit(*edge->patch, edge->patch->points[i], work.system.blocks[block++]);
}

}  // namespace

void place_patches(const Tasks& tasks, const Island& island)
{
    tasks.each_of(int(island.patches.size()), kObjectRange, [&](std::size_t i) {
        const PatchEdge& edge = *island.patches[i];
        edge.patch->body1 = edge.body[0]->island_index;
        edge.patch->body2 = edge.body[1] ? edge.body[1]->island_index : -1;
    });
}

int patch_point_count(const Island& island)
{
    int points = 0;
    for (const PatchEdge* edge : island.patches) points += edge->patch->count;
    return points;
}

int patch_row_count(const Island& island)
{
    int rows = 0;
    for (const PatchEdge* edge : island.patches) rows += edge->patch->count * rows_of_point(*edge->patch);
    return rows;
}

void emit_patches(const StepInfo& info, IslandWork& work, int& rows, int& blocks)
{
    for (PatchEdge* edge : work.island.patches) {
        const Patch& patch = *edge->patch;
        for (int i = 0; i < patch.count; ++i) {
            RowWriter out(&work.system.rows[std::size_t(rows)], info);
            write_point(out, work.island, patch, patch.points[i]);
            work.system.blocks[std::size_t(blocks++)] = {rows, out.count(), patch.body1, patch.body2,
                                                         true, out.arms(),  out.form()};
            rows += out.count();
        }
    }
}

// The couple of a patch is shared by its points.
void load_patch_impulses(IslandWork& work, Real share)
{
    for_points(work, [&](const Patch& patch, const PatchPoint& point, const RowBlock& block) {
        for (int k = 0; k < block.count; ++k) {
            const auto at = std::size_t(block.first + k);
            const Row& row = work.system.rows[at];
            const Real sliding = dot(widen(point.friction), row.lin1);
            const Real couple = dot(widen(patch.roll), row.ang1) / Real(patch.count);
            const Real p = k == 0 ? Real(point.push) : k < kPointRows ? sliding : couple;
            work.system.numbers[at].p = share * p;
        }
    });
}

void store_patch_impulses(const IslandWork& work)
{
    for (PatchEdge* edge : work.island.patches) edge->patch->roll = {};
    for_points(work, [&](Patch& patch, PatchPoint& point, const RowBlock& block) {
        Vec3 friction, couple = widen(patch.roll);
        for (int k = 1; k < block.count; ++k) {
            const auto at = std::size_t(block.first + k);
            const Row& row = work.system.rows[at];
            const Real p = work.system.numbers[at].p;
            if (k < kPointRows)
                friction += p * row.lin1;
            else
                couple += p * row.ang1;
        }
        point.push = float(work.system.numbers[std::size_t(block.first)].p);
        point.friction = narrow(friction);
        patch.roll = narrow(couple);
    });
}

}  // namespace epode
