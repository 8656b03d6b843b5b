// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/patch_rows.h"

#include <algorithm>

namespace epode {
namespace {

constexpr int kPointRows = 3;

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

// An open contact may close, but no further.
void write_point(RowWriter& out, const Island& island, const Patch& patch, const PatchPoint& point)
{
    out.contact_at(widen(point.r1), widen(point.r2));
    const Vec3 n = widen(patch.normal);
    Row& normal = point_row(out, n, RowKind::kNormal);
    const Real gap = point.gap;
    normal.error = std::max(-gap, Real(0));
    normal.speed = gap > 0 ? -gap * out.info().fps : 0;
    normal.cap = out.info().contact_max_vel;
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
}

// f(point, block) for each point and its block, in order.
template <typename Visit>
void for_points(const IslandWork& work, Visit&& visit)
{
    std::size_t block = work.joints.size();
    for (PatchEdge* edge : work.island.patches)
        for (int i = 0; i < edge->patch->count; ++i)
            visit(edge->patch->points[i], work.system.blocks[block++]);
}

}  // namespace

void place_patches(const Island& island)
{
    for (PatchEdge* edge : island.patches) {
        edge->patch->body1 = edge->body[0]->island_index;
        edge->patch->body2 = edge->body[1] ? edge->body[1]->island_index : -1;
    }
}

int patch_point_count(const Island& island)
{
    int points = 0;
    for (const PatchEdge* edge : island.patches) points += edge->patch->count;
    return points;
}

int patch_row_count(const Island& island) { return kPointRows * patch_point_count(island); }

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

void load_patch_impulses(IslandWork& work, Real share)
{
    for_points(work, [&](const PatchPoint& point, const RowBlock& block) {
        for (int k = 0; k < block.count; ++k) {
            const auto at = std::size_t(block.first + k);
            const Vec3 d = work.system.rows[at].lin1;
            work.system.numbers[at].p = share * (k == 0 ? Real(point.push) : dot(widen(point.friction), d));
        }
    });
}

void store_patch_impulses(const IslandWork& work)
{
    for_points(work, [&](PatchPoint& point, const RowBlock& block) {
        Vec3 friction;
        for (int k = 1; k < block.count; ++k) {
            const auto at = std::size_t(block.first + k);
            friction += work.system.numbers[at].p * work.system.rows[at].lin1;
        }
        point.push = float(work.system.numbers[std::size_t(block.first)].p);
        point.friction = narrow(friction);
    });
}

}  // namespace epode
