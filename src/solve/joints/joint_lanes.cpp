// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "solve/joints/joint_lanes.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

constexpr std::size_t kFewJoints = 2 * kLanes;
constexpr int kFloatSweeps = 50;
constexpr Real kFloatRatio = 1000;  // of masses
constexpr Real kFloatArms = 1000;   // m r x I^-1 r x
constexpr Real kFloatRange = Real(1e12);

bool in_range(Real sum) { return sum <= kFloatRange; }  // false for NaN

Real size(Vec3 a)
{
    const Vec3 b = abs(a);
    return b.x + b.y + b.z;
}

bool is_joint(const RowBlock& block) { return !block.contact && block.count > 0 && block.term_count == 0; }

const SolverBody* moving(const RowSystem& system, int body)
{
    const SolverBody* b = body >= 0 ? &system.bodies[std::size_t(body)] : nullptr;
    return b && b->inv_mass > 0 ? b : nullptr;
}

struct Masses {
    Real smallest = kFloatRange, largest = 1 / kFloatRange;  // inverse ones

    void add(Real inv_mass)
    {
        smallest = std::min(smallest, inv_mass), largest = std::max(largest, inv_mass);
    }
    bool fit() const
    {
        return largest <= kFloatRatio * smallest && in_range(largest) && in_range(1 / smallest);
    }
};

// An impulse at the arm r rotates a body by I^-1 (r x p) and so moves the point in addition to what the mass
// allows: the trace of the one over the other is the number of digits that the block of a joint may lose.
bool arm_fits(const SolverBody& b, Vec3 r)
{
    const Sym3& I = b.inv_inertia;
    const Real trace = I.xx + I.yy + I.zz, largest = trace * length2(r), bound = kFloatArms * b.inv_mass;
    return in_range(trace) && (largest <= bound || largest - dot(r, I * r) <= bound);
}

bool speed_fits(const RowSystem& system, int body)
{
    if (body < 0) return true;
    const SolverBody& b = system.bodies[std::size_t(body)];
    return in_range(size(b.v) + size(b.w));
}

bool rows_fit(const RowSystem& system, const RowBlock& block)
{
    const RowNumbers* rows = &system.numbers[std::size_t(block.first)];
    for (int i = 0; i < std::min(block.count, 3); ++i)
        if (rows[i].bounded()) return false;  // becomes a joint of free form
    Real sum = 0;
    for (int i = 0; i < block.count; ++i) sum += std::abs(rows[i].c) + rows[i].C + std::abs(rows[i].p);
    return in_range(sum);
}

template <typename List, typename Test>
bool any(const List& list, int from, int to, const Test& test)
{
    return std::any_of(list.begin() + from, list.begin() + to, test);
}

// True if some body of the part is attached to something that absorbs momentum.
bool stands(const RowSystem& system, const SystemPart& from, const SystemPart& to)
{
    const auto fixed = [&](const auto& x) { return !moving(system, x.body1) || !moving(system, x.body2); };
    return any(system.blocks, from.blocks, to.blocks, fixed) ||
           any(system.joint_contacts.manifolds, from.joint_manifolds, to.joint_manifolds, fixed) ||
           any(system.contact_manifolds, from.contact_manifolds, to.contact_manifolds,
               [&](const ContactManifold* p) { return fixed(*p); });
}

}  // namespace

bool JointLanes::part_fits_floats(const RowSystem& system, int part) const
{
    const SystemPart from = system.begin_of(part), to = system.end_of(part);
    Masses masses;
    for (int i = from.blocks; i < to.blocks; ++i) {
        const RowBlock& block = system.blocks[std::size_t(i)];
        if (!is_joint(block)) continue;
        if (block.form == RowForm::kFree || !rows_fit(system, block)) return false;
        for (const bool second : {false, true}) {
            const int body = second ? block.body2 : block.body1;
            if (!speed_fits(system, body)) return false;
            const SolverBody* b = moving(system, body);
            if (b && !arm_fits(*b, second ? block.arms.r2 : block.arms.r1)) return false;
            if (b) masses.add(b->inv_mass);
        }
    }
    return masses.fit() && stands(system, from, to);
}

bool JointLanes::pack(const RowSystem& system, Arena& arena)
{
    const auto blocks = arena.take<int>(int(system.blocks.size()));
    if (arena.failed()) return false;
    const auto joints = std::size_t(std::count_if(system.blocks.begin(), system.blocks.end(), is_joint));
    const bool may = joints > kFewJoints && sweeps_ <= kFloatSweeps;
    // Floats from the front, Reals from the back.
    std::size_t floats = 0, reals = blocks.size();
    for (int part = 0; part < system.worlds(); ++part) {
        const bool fits = may && part_fits_floats(system, part);
        for (int i = system.begin_of(part).blocks; i < system.end_of(part).blocks; ++i)
            if (is_joint(system.blocks[std::size_t(i)])) blocks[fits ? floats++ : --reals] = i;
    }
    const auto last = blocks.subspan(reals);
    std::reverse(last.begin(), last.end());
    return floats_.pack(system, blocks.first(floats), arena) && reals_.pack(system, last, arena) &&
           wide_.pack(system, arena);
}

void JointLanes::load(const RowSystem& system)
{
    floats_.load(system), reals_.load(system), wide_.load(system);
}

bool JointLanes::follow(const RowSystem& system, const Substep& step, std::span<const Velocity> bodies,
                        Arena& arena)
{
    return floats_.follow(system, step, bodies, arena) && reals_.follow(system, step, bodies, arena);
}

void JointLanes::load_substep(const RowSystem& system, const Substep& step)
{
    floats_.load_substep(system, step), reals_.load_substep(system, step), wide_.load_substep(system, step);
}

void JointLanes::apply_impulses(std::span<Velocity> bodies) const
{
    floats_.apply_impulses(bodies), reals_.apply_impulses(bodies), wide_.apply_impulses(bodies);
}

void JointLanes::sweep(std::span<Velocity> bodies, const JointSweep& how)
{
    floats_.sweep(bodies, how), reals_.sweep(bodies, how), wide_.sweep(bodies, how);
}

void JointLanes::store_impulses(std::span<RowNumbers> numbers) const
{
    floats_.store_impulses(numbers), reals_.store_impulses(numbers), wide_.store_impulses(numbers);
}

void JointLanes::sum_impulses() { floats_.sum_impulses(), reals_.sum_impulses(), wide_.sum_impulses(); }

void JointLanes::store_sums(std::span<RowNumbers> numbers) const
{
    floats_.store_sums(numbers), reals_.store_sums(numbers), wide_.store_sums(numbers);
}

void JointLanes::describe(std::span<RowNumbers> numbers, std::span<Row> rows) const
{
    floats_.describe(numbers, rows), reals_.describe(numbers, rows), wide_.describe(numbers);
}

void JointLanes::apply_restitution(const RowSystem& system, std::span<Velocity> bodies)
{
    floats_.apply_restitution(system, bodies), reals_.apply_restitution(system, bodies);
    wide_.apply_restitution(system, bodies);
}

}  // namespace epode
