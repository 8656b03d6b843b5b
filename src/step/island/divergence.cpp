// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/divergence.h"

#include <algorithm>
#include <cmath>

#include "joints/joint_manifolds.h"
#include "step/island/positions/asked.h"
#include "step/island/positions/solved_motion.h"
#include "tasks/prefetched.h"

namespace epode {
namespace {

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

// m^2/s^2: a gain of T that is looked at is more than this times the mass.
constexpr double kNeverThrown = 1;

// Twice the kinetic energy.
double energy_at_correcting(double mass) { return mass * double(kCorrecting * kCorrecting); }

// T <= sum (m v^2 + w^2 tr I) / 2, as no principal moment is larger than their sum: where that is below the mass's part of
// the bounds, nothing has diverged or is thrown. Nearly every step ends here.
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
    return fast <= 2 * kNeverThrown * mass;
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
    double by_corrections = 0;  // of by_targets
    double beyond = 0;          // what rows have worked past their targets
    Asked asked;

    void add_beyond(double p, double past) { beyond += std::max(0.0, p * past); }
    void add_correction(const Row& row, double p, double c) { by_corrections += p * c, asked.add(row, c); }
    void add_linear_correction(double p, double c) { by_corrections += p * c, asked.linear += c * c; }
};

Vec3 velocity_at(const RowSystem& system, int body, Vec3 r)
{
    if (body < 0) return {};
    const SolverBody& b = system.bodies[std::size_t(body)];
    return b.v + cross(b.w, r);
}

bool corrects(const Row& row, const RowNumbers& n)
{
    return row.error != 0 && row.erp != 0 && !row.drive && !row.given &&
           !(row.has_restitution && n.c == row.restitution_velocity);
}

void add(const RowSystem& system, const RowBlock& block, Supply& sum)
{
    for (int i = block.first; i < block.first + block.count; ++i) {
        const Row& row = system.rows[std::size_t(i)];
        const RowNumbers& n = system.numbers[std::size_t(i)];
        double c = double(n.c);
        if ((row.soft || row.drive) && n.C > 0) sum.by_springs += c * c / double(n.C);
        if (block.term_count == 0) c -= driven_velocity(system, block.body1, block.body2, row);
        sum.by_targets += double(n.p) * c;
        if (n.p != 0 && corrects(row, n)) sum.add_correction(row, double(n.p), double(n.c - row.speed));
        if (row.soft || row.drive) continue;  // springs, which substeps divide
        const double u = double(row_velocity(system, block, row, system.bodies));
        sum.add_beyond(double(n.p), u + double(n.C * n.p) - double(n.c));
    }
}

// Of a contact joint without rows; its bodies have the velocities that its rebound was found from.
void add_correction(const Joint& contact, const JointManifoldPoint& point, Real h, Supply& sum)
{
    const Row row = normal_of_contact(contact, step_info(*contact.world, h));
    RowNumbers n;
    n.c = point.c;
    if (row.soft && point.C > 0) sum.by_springs += double(point.c * point.c / point.C);
    if (corrects(row, n)) sum.add_linear_correction(double(point.p[0]), double(point.c - row.speed));
}

void add(const IslandWork& work, const JointManifold& m, Supply& sum)
{
    const RowSystem& system = work.system;
    const Vec3 axes[] = {m.n, m.t1, m.t2};
    for (int k = m.first; k < m.first + m.count; ++k) {
        const JointManifoldPoint& point = system.joint_contacts.points[std::size_t(k)];
        const Vec3 r2 = point.r1 + m.offset;
        const Vec3 u = velocity_at(system, m.body1, point.r1) - velocity_at(system, m.body2, r2);
        if (point.p[0] != 0 && point.error > 0)
            add_correction(*work.contacts[std::size_t(k)], point, system.h, sum);
        for (int i = 0; i < 3; ++i) {
            const Jacobian J{axes[i], cross(point.r1, axes[i]), -axes[i], -cross(r2, axes[i])};
            const double c = double(i == 0 ? point.c : m.c[i - 1]);
            sum.by_targets += double(point.p[i]) * (c - driven_velocity(system, m.body1, m.body2, J));
            sum.add_beyond(double(point.p[i]), double(dot(u, axes[i])) - c);
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
        const Vec3 u =
            velocity_at(system, m.body1, widen(point.r1)) - velocity_at(system, m.body2, widen(point.r2));
        sum.add_beyond(double(point.normal_impulse), double(dot(u, widen(m.normal))));
    }
}

Supply supply_to(const IslandWork& work, const SystemPart& from, const SystemPart& to)
{
    const RowSystem& system = work.system;
    Supply sum;
    for (int k = from.blocks; k < to.blocks; ++k) add(system, system.blocks[std::size_t(k)], sum);
    for (int k = from.joint_manifolds; k < to.joint_manifolds; ++k)
        add(work, system.joint_contacts.manifolds[std::size_t(k)], sum);
    for (int k = from.contact_manifolds; k < to.contact_manifolds; ++k)
        add(system, *system.contact_manifolds[std::size_t(k)], sum);
    return sum;
}

bool diverges(const PartMotion& motion, const Supply& sum, bool bounds_corrections)
{
    const double bound = motion.forced + energy_at_correcting(motion.mass),
                 gain = motion.solved - motion.forced;
    if (!(gain > bound)) return false;
    return gain - std::max(0.0, sum.by_targets) - sum.by_springs > bound ||
           (bounds_corrections && sum.beyond > gain);
}

// Of what has not diverged.
Real correctable_share(const PartMotion& motion, const Supply& sum, double asked)
{
    const double gain = motion.solved - motion.forced;
    const double A = std::min(asked, energy_at_correcting(motion.mass));
    const double others = std::max(0.0, sum.by_targets - sum.by_corrections) + sum.by_springs;
    const double allowed = A + motion.mass * kNeverThrown + others;
    return gain > allowed ? Real(std::sqrt(allowed / gain) / 2) : Real(1);
}

}  // namespace

SolutionEnergy judge_energy(const IslandWork& work, int part, Real h, bool bounds_corrections,
                            const Tasks& tasks, Arena& arena)
{
    const SystemPart from = work.system.begin_of(part), to = work.system.end_of(part);
    if (is_slow(work, from.bodies, to.bodies)) return {};
    const PartMotion motion = motion_of(work, from.bodies, to.bodies, h, tasks, arena);
    const double gain = motion.solved - motion.forced;
    if (!(gain > kNeverThrown * motion.mass)) return {};
    const Supply sum = supply_to(work, from, to);
    SolutionEnergy energy;
    energy.diverged = diverges(motion, sum, bounds_corrections);
    if (bounds_corrections)
        energy.correctable = correctable_share(motion, sum, energy_of(sum.asked, work, part));
    return energy;
}

}  // namespace epode
