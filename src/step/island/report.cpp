// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// E = sum m v.v/2 + w.I w/2 - m g.x over the dynamic bodies, with the pose and velocity that they have;
// bodies that gravity leaves alone have no potential energy. Errors are those that the rows were written
// with: the pose at the beginning of the step.
#include "step/island/report.h"

#include <algorithm>
#include <cmath>

#include "solve/common/residual.h"
#include "step/island/energy_ledger.h"

namespace epode {
namespace {

double energy(const World& world, const Island& island)
{
    double sum = 0;
    for (const Body* body : island.bodies) {
        const BodyEnergy now = energy_of(world, *body);
        sum += now.kinetic;
        sum += now.potential;
    }
    return sum;
}

void report_error(const Row& row, dIslandStepReport& report)
{
    const double error = std::fabs(double(row.error));
    if (row.kind == RowKind::kNormal) report.penetration = std::max(report.penetration, error);
    if (row.kind != RowKind::kLock) return;
    const bool turns = row.lin1 == Vec3{} && row.lin2 == Vec3{};
    double& worst = turns ? report.joint_angle_error : report.joint_error;
    worst = std::max(worst, error);
}

}  // namespace

void begin_report(const World& world, const Island& island, dIslandStepReport& report)
{
    report = {};
    report.struct_size = sizeof report;
    report.body = to_handle(island.bodies[0]);
    report.bodies = int(island.bodies.size());
    report.energy_before = energy(world, island);
}

void report_errors(const IslandWork& work, int part, dIslandStepReport& report)
{
    const RowSystem& system = work.system;
    const SystemPart from = system.begin_of(part), to = system.end_of(part);
    report.joints = to.blocks - from.blocks;
    for (int k = from.joint_manifolds; k < to.joint_manifolds; ++k) {
        const JointManifold& m = system.joint_contacts.manifolds[std::size_t(k)];
        report.joints += m.count;
        report.rows += m.count * (m.t1 == Vec3{} ? 1 : 3);
        for (int i = m.first; i < m.first + m.count; ++i)
            report.penetration =
                std::max(report.penetration, double(system.joint_contacts.points[std::size_t(i)].error));
    }
    for (int k = from.blocks; k < to.blocks; ++k) {
        const RowBlock& block = system.blocks[std::size_t(k)];
        report.rows += block.count;
        for (int i = block.first; i < block.first + block.count; ++i)
            report_error(system.rows[std::size_t(i)], report);
    }
}

void report_solution(const IslandWork& work, const SolveReport& solved, dIslandStepReport& report)
{
    report.method = solved.method;
    report.residual = double(solved.residual);
    report.iterations = solved.iterations;
    report.factorisations = solved.factorisations;
    report.fallback = solved.fallback;
    report.friction_error = double(solved.friction_error);
    report.raised_residual = report.residual;
    report.unsolved_joints = solved.unsolved_joints;
    if (solved.unsolved_joint >= 0)
        report.unsolved_joint = to_handle(work.joints[std::size_t(solved.unsolved_joint)]);
}

void report_raised(const RowSystem& system, std::span<const SolverBody> plain, Arena& arena,
                   std::span<dIslandStepReport> reports)
{
    Arena::Scope scope(arena);
    const auto lo = arena.take<Real>(int(system.numbers.size())),
               hi = arena.take<Real>(int(system.numbers.size()));
    if (reports.empty() || arena.failed()) return;
    for (std::size_t i = 0; i < lo.size(); ++i) {
        const RowNumbers& n = system.numbers[i];
        const bool friction = n.parent >= 0;
        lo[i] = friction ? n.p : n.lo, hi[i] = friction ? n.p : n.hi;
    }
    RowSystem one = system;
    for (int part = 0; part < system.worlds(); ++part) {
        dIslandStepReport& report = reports[std::size_t(part)];
        const int from = system.begin_of(part).blocks, to = system.end_of(part).blocks;
        one.blocks = system.blocks.subspan(std::size_t(from), std::size_t(to - from));
        one.frictions = frictions_of(system, part);
        if (report.raised_bodies > 0)
            report.raised_residual = double(natural_residual(one, plain, lo, hi, arena));
    }
}

void report_projection(const ProjectionReport& done, dIslandStepReport& report)
{
    report.projection_iterations = done.iterations;
    report.projection_unconverged = done.open;
    report.projection_error = done.error;
}

void end_report(const World& world, const Island& island, dIslandStepReport& report)
{
    report.energy_after = energy(world, island);
}

void report_stopped(const World& world, const Island& island, const Continuous& continuous,
                    dIslandStepReport& report)
{
    for (const Body* body : island.bodies) report.stopped_bodies += continuous.stopped(*body);
    if (report.stopped_bodies) report.energy_after = energy(world, island);
}

dWorldStepReport sum_of(std::span<const dIslandStepReport> islands)
{
    dWorldStepReport total{};
    total.islands = int(islands.size());
    for (const dIslandStepReport& one : islands) {
        total.bodies += one.bodies;
        total.joints += one.joints;
        total.rows += one.rows;
        if (one.unsolved_joint && one.residual > total.residual) total.unsolved_joint = one.unsolved_joint;
        total.unsolved_joints += one.unsolved_joints;
        total.residual = std::max(total.residual, one.residual);
        total.iterations += one.iterations;
        total.factorisations += one.factorisations;
        total.fallbacks += one.fallback;
        total.raised_bodies += one.raised_bodies;
        total.raised_residual = std::max(total.raised_residual, one.raised_residual);
        total.contained_islands += one.contained;
        total.joint_error = std::max(total.joint_error, one.joint_error);
        total.joint_angle_error = std::max(total.joint_angle_error, one.joint_angle_error);
        total.penetration = std::max(total.penetration, one.penetration);
        total.projection_iterations += one.projection_iterations;
        total.projections_unconverged += one.projection_unconverged;
        total.projection_error = std::max(total.projection_error, one.projection_error);
        total.stopped_bodies += one.stopped_bodies;
        total.friction_error = std::max(total.friction_error, one.friction_error);
        total.energy_before += one.energy_before;
        total.energy_after += one.energy_after;
    }
    return total;
}

}  // namespace epode
