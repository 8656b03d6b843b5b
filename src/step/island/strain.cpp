// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/strain.h"

#include <algorithm>
#include <cmath>

#include "step/island/energy_ledger.h"

namespace epode {
namespace {

constexpr Real kGap = Real(0.001);
constexpr double kGain = 0.003, kGainIfDriven = 0.05;
constexpr Real kWide = Real(0.02), kClosed = Real(0.0002);  // gaps
constexpr std::ptrdiff_t kLoops = 4;
constexpr std::uint8_t kTwice = 4, kFourTimes = 10, kLongest = 15;  // steps with wide gaps

// The radius of gyration, from the mean of the principal moments; 0 of what cannot move.
Real gyration(const Body& body)
{
    if (body.kinematic()) return 0;
    return std::sqrt((body.inertia.xx + body.inertia.yy + body.inertia.zz) / (3 * body.mass.mass));
}

Real gyration(const IslandWork& work, int body)
{
    return body < 0 ? Real(0) : gyration(*work.island.bodies[std::size_t(body)]);
}

// Rows that the program has made soft, stops and drives are not meant to hold.
bool holds(const Row& row) { return row.kind == RowKind::kLock && !row.soft && !row.drive; }

// The largest of an angle and of a distance over arms and radii.
Real gap_of(const IslandWork& work, const RowBlock& block)
{
    Real distance = 0, arms = 0, angle = 0;
    for (int i = block.first; i < block.first + block.count; ++i) {
        const Row& row = work.system.rows[std::size_t(i)];
        if (!holds(row)) continue;
        const bool turns = row.lin1 == Vec3{} && row.lin2 == Vec3{};
        Real& largest = turns ? angle : distance;
        largest = std::max(largest, std::abs(row.error));
        if (!turns) arms = std::max(arms, length(row.ang1) + length(row.ang2));
    }
    if (!(distance > 0)) return angle;
    return std::max(angle, distance / (arms + gyration(work, block.body1) + gyration(work, block.body2)));
}

Real gap_of(const IslandWork& work, int part)
{
    Real gap = 0;
    const SystemPart from = work.system.begin_of(part), to = work.system.end_of(part);
    for (int k = from.blocks; k < to.blocks; ++k) {
        const RowBlock& block = work.system.blocks[std::size_t(k)];
        const bool joint = !block.contact && block.term_count == 0;
        if (joint) gap = std::max(gap, gap_of(work, block));
    }
    return gap;
}

// Has it a force or a torque besides its weight? Its accumulators have both by now.
bool is_pushed(const World& world, const Body& body)
{
    if (body.kinematic()) return true;
    const Vec3 weight = body.gravity ? body.mass.mass * world.gravity : Vec3{};
    return length(load(body.facc) - weight) > Real(1e-5) * length(weight) || load(body.tacc) != Vec3{};
}

bool is_driven(const World& world, const IslandWork& work, int part)
{
    const SystemPart from = work.system.begin_of(part), to = work.system.end_of(part);
    if (from.joint_manifolds != to.joint_manifolds || from.contact_manifolds != to.contact_manifolds)
        return true;
    for (int k = from.blocks; k < to.blocks; ++k) {
        const RowBlock& block = work.system.blocks[std::size_t(k)];
        for (int i = block.first; i < block.first + block.count; ++i)
            if (work.system.rows[std::size_t(i)].kind != RowKind::kLock) return true;
    }
    for (int i = from.bodies; i < to.bodies; ++i)
        if (is_pushed(world, *work.island.bodies[std::size_t(i)])) return true;
    return false;
}

struct PartEnergy {
    double sum = 0;    // of motion and weight
    double scale = 0;  // of motion, and m |a| k
};

PartEnergy energy_of_part(const World& world, const IslandWork& work, int part)
{
    PartEnergy energy;
    const double a = double(length(world.gravity));
    for (int i = work.system.begin_of(part).bodies; i < work.system.end_of(part).bodies; ++i) {
        const Body& body = *work.island.bodies[std::size_t(i)];
        const BodyEnergy e = energy_of(world, body);
        energy.sum += e.kinetic + e.potential;
        energy.scale += e.kinetic + double(body.mass.mass) * a * double(gyration(body));
    }
    return energy;
}

}  // namespace

StrainWatch::Before StrainWatch::before(const World& world, const IslandWork& work, int part)
{
    const Real gap = gap_of(work, part);
    if (!(gap > kGap)) return {gap};
    return {gap, is_driven(world, work, part), energy_of_part(world, work, part).sum};
}

bool StrainWatch::begin(const World& world, const IslandWork& work, Arena& arena)
{
    before_ = arena.take<Before>(work.system.worlds());
    if (arena.failed()) return false;
    for (int part = 0; part < int(before_.size()); ++part)
        before_[std::size_t(part)] = before(world, work, part);
    return true;
}

void StrainWatch::end(const World& world, const IslandWork& work, std::span<IslandMethod> methods) const
{
    for (int part = 0; part < int(before_.size()); ++part) {
        const Before& then = before_[std::size_t(part)];
        methods[std::size_t(part)].gap = then.gap;
        if (!(then.gap > kGap)) continue;
        const PartEnergy now = energy_of_part(world, work, part);
        const double gain = then.driven ? kGainIfDriven : kGain;
        methods[std::size_t(part)].strained = now.sum - then.energy > gain * now.scale;
    }
}

void note_gap(HybridState& state, Real gap)
{
    if (gap > kWide)
        state.apart = std::min<std::uint8_t>(state.apart + 1, kLongest);
    else if (gap < kClosed && state.apart > 0)
        --state.apart;
}

int substep_factor(const Island& island)
{
    const auto lasting = std::count_if(island.joints.begin(), island.joints.end(),
                                       [](const Joint* joint) { return !is_contact(*joint); });
    // Trees and single loops, which may turn by much in a step, sweeps do hold.
    if (lasting <= std::ptrdiff_t(island.bodies.size()) + kLoops) return 1;
    int apart = 0;
    for (const Body* body : island.bodies) apart = std::max(apart, int(body->hybrid.apart));
    return apart < kTwice ? 1 : apart < kFourTimes ? 2 : 4;
}

}  // namespace epode
