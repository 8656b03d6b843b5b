// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/divergence.h"

#include <algorithm>

#include "tasks/prefetched.h"

namespace epode {
namespace {

constexpr Real kCorrecting = 3;  // m/s, as in solve/common/substep_rows.h

bool moves_by_itself(const SolverBody& body) { return !(body.inv_mass > 0); }

double kinetic_of(const Body& body, Vec3 v, Vec3 w_local)
{
    return 0.5 * (double(body.mass.mass) * double(length2(v)) + double(dot(w_local, body.inertia * w_local)));
}

struct PartMotion {
    double solved = 0, forced = 0, mass = 0;

    void add(const PartMotion& other) { solved += other.solved, forced += other.forced, mass += other.mass; }
};

PartMotion motion_of(const IslandWork& work, std::size_t i, Real h)
{
    const SolverBody& solved = work.system.bodies[i];
    if (moves_by_itself(solved)) return {};
    const Body& body = *work.island.bodies[i];
    const Mat3 R = body.rotation();
    const Vec3 kick = body.inv_inertia * transposed_times(R, load(body.tacc));
    return {kinetic_of(body, solved.v, transposed_times(R, solved.w)),
            kinetic_of(body, body.velocity() + (h * solved.inv_mass) * load(body.facc),
                       transposed_times(R, body.angular_velocity()) + h * kick),
            double(body.mass.mass)};
}

// By ranges, so that any number of workers adds in the same order.
PartMotion motion_of(const IslandWork& work, int first, int last, Real h, const Tasks& tasks, Arena& arena)
{
    Arena::Scope scope(arena);
    const auto sums = arena.take_zeroed<PartMotion>((last - first + kObjectRange - 1) / kObjectRange);
    if (arena.failed()) return {};
    tasks.for_each(int(sums.size()), [&](int range, int) {
        const int begin = first + range * kObjectRange;
        for (int i = begin; i < std::min(last, begin + kObjectRange); ++i)
            sums[std::size_t(range)].add(motion_of(work, std::size_t(i), h));
    });
    PartMotion all;
    for (const PartMotion& sum : sums) all.add(sum);
    return all;
}

// T <= sum (m v^2 + w^2 tr I) / 2, as no principal moment is larger than their sum: where that is below the mass's part of
// the bound, nothing has diverged. Nearly every step ends here.
bool is_slow(const IslandWork& work, int first, int last)
{
    double fast = 0, mass = 0;
    for (auto i = std::size_t(first); i < std::size_t(last); ++i) {
        const SolverBody& solved = work.system.bodies[i];
        if (moves_by_itself(solved)) continue;
        const Body& body = *work.island.bodies[i];
        const Real trace = body.inertia.xx + body.inertia.yy + body.inertia.zz;
        mass += double(body.mass.mass);
        fast += double(body.mass.mass * length2(solved.v) + trace * length2(solved.w));
    }
    return fast <= 2 * mass * double(kCorrecting * kCorrecting);
}

// J_K v_K of the bodies that move by themselves.
double driven_velocity(const RowSystem& system, int body1, int body2, const Jacobian& J)
{
    double sum = 0;
    const auto add = [&](int body, Vec3 lin, Vec3 ang) {
        if (body < 0 || !moves_by_itself(system.bodies[std::size_t(body)])) return;
        const SolverBody& b = system.bodies[std::size_t(body)];
        sum += double(dot(lin, b.v) + dot(ang, b.w));
    };
    add(body1, J.lin1, J.ang1), add(body2, J.lin2, J.ang2);
    return sum;
}

struct Supply {
    double by_targets = 0, by_springs = 0;
};

void add(const RowSystem& system, const RowBlock& block, Supply& sum)
{
    for (int i = block.first; i < block.first + block.count; ++i) {
        const Row& row = system.rows[std::size_t(i)];
        const RowNumbers& n = system.numbers[std::size_t(i)];
        double c = double(n.c);
        if ((row.soft || row.drive) && n.C > 0) sum.by_springs += c * c / double(n.C);
        if (block.term_count == 0) c -= driven_velocity(system, block.body1, block.body2, row);
        sum.by_targets += double(n.p) * c;
    }
}

void add(const RowSystem& system, const JointManifold& m, Supply& sum)
{
    const Vec3 axes[] = {m.n, m.t1, m.t2};
    for (int k = m.first; k < m.first + m.count; ++k) {
        const JointManifoldPoint& point = system.joint_contacts.points[std::size_t(k)];
        const Vec3 r2 = point.r1 + m.offset;
        for (int i = 0; i < 3; ++i) {
            const Jacobian J{axes[i], cross(point.r1, axes[i]), -axes[i], -cross(r2, axes[i])};
            const double c = double(i == 0 ? point.c : m.c[i - 1]);
            sum.by_targets += double(point.p[i]) * (c - driven_velocity(system, m.body1, m.body2, J));
        }
    }
}

void add(const RowSystem& system, const ContactManifold& m, Supply& sum)
{
    for (int k = 0; k < m.count; ++k) {
        const ManifoldPoint& point = m.points[k];
        const Vec3 friction = widen(point.friction_impulse);
        const Vec3 p = Real(point.normal_impulse) * widen(m.normal) + friction;
        const Jacobian J{p, cross(widen(point.r1), p), -p, -cross(widen(point.r2), p)};
        sum.by_targets +=
            double(dot(friction, widen(m.surface_velocity))) - driven_velocity(system, m.body1, m.body2, J);
    }
}

double supply_to(const RowSystem& system, const SystemPart& from, const SystemPart& to)
{
    Supply sum;
    for (int k = from.blocks; k < to.blocks; ++k) add(system, system.blocks[std::size_t(k)], sum);
    for (int k = from.joint_manifolds; k < to.joint_manifolds; ++k)
        add(system, system.joint_contacts.manifolds[std::size_t(k)], sum);
    for (int k = from.contact_manifolds; k < to.contact_manifolds; ++k)
        add(system, *system.contact_manifolds[std::size_t(k)], sum);
    return std::max(0.0, sum.by_targets) + sum.by_springs;
}

}  // namespace

bool has_diverged(const IslandWork& work, int part, Real h, const Tasks& tasks, Arena& arena)
{
    const SystemPart from = work.system.begin_of(part), to = work.system.end_of(part);
    if (is_slow(work, from.bodies, to.bodies)) return false;
    const PartMotion motion = motion_of(work, from.bodies, to.bodies, h, tasks, arena);
    const double bound = motion.forced + motion.mass * double(kCorrecting * kCorrecting);
    const double gain = motion.solved - motion.forced;
    return gain > bound && gain - supply_to(work.system, from, to) > bound;
}

}  // namespace epode
