// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/problem/manifold_rows.h"

#include <algorithm>
#include <cmath>

#include "step/island/problem/slip_friction.h"
#include "tasks/prefetched.h"

namespace epode {
namespace {

constexpr int kPointRows = 3, kRollingRows = 3;

int rows_of_point(const ContactManifold& manifold)
{
    return kPointRows + (manifold.rolling_friction > 0 ? kRollingRows : 0);
}

Row& point_row(RowWriter& out, Vec3 d, RowKind kind)
{
    const ContactArms& arms = out.arms();
    Row& row = out.row({d, cross(arms.r1, d), -d, -cross(arms.r2, d)}, 0, kind);
    row.lo = 0;
    return row;
}

Real approach_of(const Row& row, const Island& island, const ContactManifold& manifold)
{
    const auto velocity = [&](int index, Vec3 lin, Vec3 ang) {
        if (index < 0) return Real(0);
        const Body& body = *island.bodies[std::size_t(index)];
        return dot(lin, body.velocity()) + dot(ang, body.angular_velocity());
    };
    return -(velocity(manifold.body1, row.lin1, row.ang1) + velocity(manifold.body2, row.lin2, row.ang2));
}

// What weight and other forces add to it in a second.
Real approach_by_forces(Vec3 n, const Island& island, const ContactManifold& manifold)
{
    const auto pushed = [&](int index) {
        if (index < 0) return Vec3{};
        const Body& body = *island.bodies[std::size_t(index)];
        return body.inv_mass * load(body.facc);
    };
    return dot(n, pushed(manifold.body2) - pushed(manifold.body1));
}

// A step does not begin where the points meet but with the separation s, after or before. With u and a the approach and what forces add to
// it, the square of the speed at the surface is u^2 + 2 a s; back at s, what rebounds at e of it has
//
//   v^2 = e^2 (u^2 + 2 a s) - 2 a s
//
// which is u^2 for e = 1. Below 0 it does not come back to s.
Real rebound_velocity(Real e, Real u, Real a, Real s)
{
    const Real fall = std::max(2 * a * s, -u * u);
    return std::sqrt(std::max(e * e * (u * u + fall) - fall, Real(0)));
}

// The spring and damper of ERP = h k / (h k + d) and CFM = 1 / (h k + d).
void soften(Row& normal, const ContactManifold& manifold, Real separation, Real h)
{
    const Real rest = h + Real(manifold.damping_time);
    normal.erp = h / rest, normal.cfm = Real(manifold.compliance) / rest;
    normal.soft = true;
    normal.error = -separation;
}

void write_rolling(RowWriter& out, const ContactManifold& manifold)
{
    const Vec3 n = widen(manifold.normal);
    Vec3 axes[3] = {{}, {}, n};
    plane_space(n, axes[0], axes[1]);
    for (const Vec3& a : axes) {
        Row& row = out.row({{}, a, {}, -a}, 0, RowKind::kFriction);
        row.hi = Real(manifold.rolling_friction), row.lo = -row.hi;
        row.parent = 0;
    }
}

// An open contact may close, but no further.
void write_point(RowWriter& out, const Island& island, const ContactManifold& manifold,
                 const ManifoldPoint& point, const Friction& friction)
{
    out.contact_at(widen(point.r1), widen(point.r2));
    const Vec3 n = widen(manifold.normal);
    Row& normal = point_row(out, n, RowKind::kNormal);
    const Real separation = point.separation;
    if (manifold.compliance > 0) {
        soften(normal, manifold, separation, out.info().h);
    } else if (std::fabs(separation) * out.info().fps > out.info().least_correction) {
        normal.error = std::max(-separation, Real(0));
        normal.speed = separation > 0 ? -separation * out.info().fps : 0;
        normal.cap = out.info().contact_max_vel;
    }
    if (manifold.is_bounded()) normal.hi = Real(manifold.largest_impulse()) * out.info().fps;
    const Real approach = approach_of(normal, island, manifold);
    if (manifold.restitution > 0 && approach > manifold.restitution_threshold &&
        approach > separation * out.info().fps) {
        const Real rebound = rebound_velocity(Real(manifold.restitution), approach,
                                              approach_by_forces(n, island, manifold), separation);
        if (rebound > 0) normal.has_restitution = true, normal.restitution_velocity = rebound;
    }
    for (int i = 0; i < 2; ++i) {
        Row& row = point_row(out, friction.t[i], RowKind::kFriction);
        row.speed = dot(widen(manifold.surface_velocity), friction.t[i]);
        row.hi = friction.mu[i];
        row.lo = -row.hi;
        row.parent = 0;
    }
    if (manifold.rolling_friction > 0) write_rolling(out, manifold);
}

// f(manifold, point, block) for each point and its block, in order.
template <typename Visit>
void for_points(const IslandWork& work, Visit&& visit)
{
    std::size_t block = work.joints.size();
    for (ManifoldEdge* edge : work.island.manifolds)
        for (int i = 0; i < edge->manifold->count; ++i)
            visit(*edge->manifold, edge->manifold->points[i], work.system.blocks[block++]);
}

bool is_finite(Float3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// Rounding leaves impulses below 0, but no contact pulls. Friction stays: without the cone it is bounded by
// what the normal impulse was before it acted. Floats end before a Real does, and the next step does not begin
// with what is not finite.
void keep_impulses(Real normal, Vec3 friction, ManifoldPoint& point)
{
    point.normal_impulse = float(std::max(normal, Real(0))), point.friction_impulse = narrow(friction);
    const bool is_sound = std::isfinite(point.normal_impulse) && is_finite(point.friction_impulse);
    if (!is_sound) point.normal_impulse = 0, point.friction_impulse = {};
}

}  // namespace

void place_manifolds(const Tasks& tasks, const Island& island)
{
    tasks.each_of(int(island.manifolds.size()), kObjectRange, [&](std::size_t i) {
        const ManifoldEdge& edge = *island.manifolds[i];
        edge.manifold->body1 = edge.body[0]->island_index;
        edge.manifold->body2 = edge.body[1] ? edge.body[1]->island_index : -1;
    });
}

int manifold_point_count(const Island& island)
{
    int points = 0;
    for (const ManifoldEdge* edge : island.manifolds) points += edge->manifold->count;
    return points;
}

int manifold_row_count(const Island& island)
{
    int rows = 0;
    for (const ManifoldEdge* edge : island.manifolds)
        rows += edge->manifold->count * rows_of_point(*edge->manifold);
    return rows;
}

void emit_manifolds(const StepInfo& info, bool cone, IslandWork& work, int& rows, int& blocks)
{
    for (ManifoldEdge* edge : work.island.manifolds) {
        const ContactManifold& manifold = *edge->manifold;
        const SlipFriction friction(info, work.island, manifold, cone);
        for (int i = 0; i < manifold.count; ++i) {
            RowWriter out(&work.system.rows[std::size_t(rows)], info);
            write_point(out, work.island, manifold, manifold.points[i], friction.at(manifold.points[i]));
            RowBlock& block = work.system.blocks[std::size_t(blocks++)];
            block = {rows, out.count(), manifold.body1, manifold.body2, true, out.arms(), out.form()};
            block.cone = cone;
            rows += out.count();
        }
    }
}

// The couple of a manifold is shared by its points.
void load_manifold_impulses(IslandWork& work, Real share)
{
    for_points(work, [&](const ContactManifold& manifold, const ManifoldPoint& point, const RowBlock& block) {
        for (int k = 0; k < block.count; ++k) {
            const auto at = std::size_t(block.first + k);
            const Row& row = work.system.rows[at];
            // Of a scaled tangent (rows/contact_manifold.h).
            const Real per =
                manifold.has_friction_axis() && length2(row.lin1) > 0 ? 1 / length2(row.lin1) : 1;
            const Real sliding = per * dot(widen(point.friction_impulse), row.lin1);
            const Real couple = dot(widen(manifold.rolling_impulse), row.ang1) / Real(manifold.count);
            const Real p = k == 0 ? Real(point.normal_impulse) : k < kPointRows ? sliding : couple;
            work.system.numbers[at].p = share * p;
        }
    });
}

void store_manifold_impulses(const IslandWork& work, Real times)
{
    for (ManifoldEdge* edge : work.island.manifolds)
        edge->manifold->rolling_impulse = {}, edge->manifold->struck = false;
    for_points(work, [&](ContactManifold& manifold, ManifoldPoint& point, const RowBlock& block) {
        Vec3 friction, couple = widen(manifold.rolling_impulse);
        for (int k = 1; k < block.count; ++k) {
            const auto at = std::size_t(block.first + k);
            const Row& row = work.system.rows[at];
            const Real p = times * work.system.numbers[at].p;
            if (k < kPointRows)
                friction += p * row.lin1;
            else
                couple += p * row.ang1;
        }
        keep_impulses(times * work.system.numbers[std::size_t(block.first)].p, friction, point);
        manifold.rolling_impulse = is_finite(narrow(couple)) ? narrow(couple) : Float3{};
    });
}

}  // namespace epode
