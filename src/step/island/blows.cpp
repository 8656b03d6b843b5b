// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/blows.h"

#include <algorithm>

namespace epode {
namespace {

struct Ends {
    int body1, body2;  // below zero: the world
    Vec3 n, r1, r2;
};

// The momentum along n of the approach, negative of a separation.
Real approach(const RowSystem& system, const Ends& at)
{
    const auto end = [&](int body, Vec3 r, Real& u, Real& freedom) {
        if (body < 0) return;
        const SolverBody& b = system.bodies[std::size_t(body)];
        const Vec3 arm = cross(r, at.n);
        u = dot(at.n, b.v) + dot(arm, b.w);
        freedom += b.inv_mass + dot(arm, b.inv_inertia * arm);
    };
    Real u1 = 0, u2 = 0, freedom = 0;
    end(at.body1, at.r1, u1, freedom), end(at.body2, at.r2, u2, freedom);
    return freedom > 0 ? (u2 - u1) / freedom : 0;
}

Real blow(Real p, Real approach) { return std::max(Real(0), std::min(p, approach)); }

}  // namespace

bool Blows::begin(const RowSystem& system, Arena& arena)
{
    points_ = arena.take<Real>(int(system.joint_contacts.points.size()));
    blocks_ = arena.take_zeroed<Real>(int(system.blocks.size()));
    if (arena.failed()) return false;
    for (const JointManifold& m : system.joint_contacts.manifolds)
        for (auto i = std::size_t(m.first); i < std::size_t(m.first + m.count); ++i) {
            const Vec3 r1 = system.joint_contacts.points[i].r1;
            points_[i] = approach(system, {m.body1, m.body2, m.n, r1, r1 + m.offset});
        }
    for (std::size_t k = 0; k < system.blocks.size(); ++k) {
        const RowBlock& block = system.blocks[k];
        const Vec3 n = system.rows[std::size_t(block.first)].lin1;
        if (block.contact)
            blocks_[k] = approach(system, {block.body1, block.body2, n, block.arms.r1, block.arms.r2});
    }
    return true;
}

bool Blows::struck(const RowSystem& system, const JointManifold& manifold) const
{
    if (points_.empty()) return false;
    Real blows = 0, all = 0;
    for (auto i = std::size_t(manifold.first); i < std::size_t(manifold.first + manifold.count); ++i) {
        const Real p = system.joint_contacts.points[i].p[0];
        blows += blow(p, points_[i]), all += p;
    }
    return blows > Real(kBlowShare) * all;
}

bool Blows::struck(const RowSystem& system, std::size_t block) const
{
    if (blocks_.empty()) return false;
    const Real p = system.numbers[std::size_t(system.blocks[block].first)].p;
    return blow(p, blocks_[block]) > Real(kBlowShare) * p;
}

}  // namespace epode
