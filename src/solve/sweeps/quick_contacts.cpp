// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "solve/sweeps/quick_contacts.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

constexpr std::size_t kFewPoints = 48;
constexpr int kFloatSweeps = 50;
constexpr Real kFloatRatio = 1000;  // of masses
constexpr Real kFloatRange = Real(1e12);

bool in_range(Real sum) { return sum <= kFloatRange; }  // false for NaN

Real size(Real a) { return std::abs(a); }

Real size(Vec3 a)
{
    const Vec3 b = abs(a);
    return b.x + b.y + b.z;
}

bool bodies_fit_floats(std::span<const SolverBody> bodies)
{
    Real smallest = kFloatRange, largest = 1 / kFloatRange;
    for (const SolverBody& b : bodies) {
        const Sym3& I = b.inv_inertia;
        if (!in_range(size(b.v) + size(b.w) + I.xx + I.yy + I.zz)) return false;
        if (b.inv_mass > 0)
            smallest = std::min(smallest, b.inv_mass), largest = std::max(largest, b.inv_mass);
    }
    return largest <= kFloatRatio * smallest && in_range(largest) && in_range(1 / smallest);
}

// Ignores friction limits, which may be infinite.
bool contacts_fit_floats(const JointManifoldList& list)
{
    for (const JointManifold& m : list.manifolds)
        if (!in_range(size(m.offset) + size(m.c[0]) + size(m.c[1]) + m.C[0] + m.C[1])) return false;
    for (const JointManifoldPoint& point : list.points)
        if (!in_range(size(point.r1) + size(point.c) + point.C + size(point.p[0]) + size(point.p[1]) +
                      size(point.p[2])))
            return false;
    return true;
}

bool stands(const RowSystem& system, int body)
{
    return body < 0 || !(system.bodies[std::size_t(body)].inv_mass > 0);
}

// True if every part with contact joints touches something that absorbs momentum.
bool all_parts_stand(const RowSystem& system, const JointManifoldList& list)
{
    const auto joints = list.manifolds.first(system.joint_contacts.manifolds.size());
    const auto others = list.manifolds.subspan(joints.size());
    if (joints.empty()) return true;
    const auto none_on_static = [&](auto from, auto to) {
        return std::none_of(from, to, [&](const JointManifold& m) {
            return stands(system, m.body1) || stands(system, m.body2);
        });
    };
    auto own = others.begin();
    for (int part = 0; part < system.worlds(); ++part) {
        const auto from = joints.begin() + system.begin_of(part).joint_manifolds;
        const auto to = joints.begin() + system.end_of(part).joint_manifolds;
        const int end = system.end_of(part).bodies;
        const auto first = own;
        own = std::find_if(own, others.end(), [end](const JointManifold& m) { return m.body1 >= end; });
        if (from != to && none_on_static(from, to) && none_on_static(first, own)) return false;
    }
    return true;
}

}  // namespace

bool QuickContacts::pack(const RowSystem& system, const JointManifoldList& list,
                         const SweepSettings& settings, bool alone, Arena& arena)
{
    in_floats_ = list.points.empty()
                     ? alone
                     : list.points.size() >= kFewPoints && settings.iterations <= kFloatSweeps &&
                           bodies_fit_floats(system.bodies) && contacts_fit_floats(list) &&
                           all_parts_stand(system, list);
    if (!in_floats_) return reals_.pack(system, list, settings.w, arena);
    alone_ = alone;
    const int slots = int(system.bodies.size()) + system.worlds();
    velocities_ = arena.take<FloatVelocity>(slots);
    return !arena.failed() && floats_.pack(system, list, settings.w, arena);
}

// For floats: from begin() to end() if no other code uses the velocities meanwhile, else each time.
template <typename Change>
void QuickContacts::change(std::span<Velocity> bodies, Change&& change)
{
    const int count = int(velocities_.size());
    if (!alone_) machine_.round_velocities(bodies.data(), count, velocities_.data());
    change();
    if (!alone_) machine_.add_changes(velocities_.data(), count, bodies.data());
}

void QuickContacts::begin(std::span<Velocity> bodies)
{
    if (!in_floats_) return reals_.apply_impulses(bodies);
    if (alone_) machine_.round_velocities(bodies.data(), int(velocities_.size()), velocities_.data());
    change(bodies, [this] { floats_.apply_impulses(velocities_); });
}

void QuickContacts::sweep(std::span<Velocity> bodies, CounterRandom& random)
{
    if (!in_floats_) {
        reals_.shuffle(random);
        return reals_.sweep(bodies);
    }
    floats_.shuffle(random);
    change(bodies, [this] { floats_.sweep(velocities_); });
}

void QuickContacts::relax_by(Real factor) { in_floats_ ? floats_.relax_by(factor) : reals_.relax_by(factor); }

void QuickContacts::end(std::span<Velocity> bodies) const
{
    if (in_floats_ && alone_)
        machine_.add_changes(velocities_.data(), int(velocities_.size()), bodies.data());
}

void QuickContacts::store_impulses(std::span<JointManifoldPoint> points) const
{
    in_floats_ ? floats_.store_impulses(points) : reals_.store_impulses(points);
}

}  // namespace epode
