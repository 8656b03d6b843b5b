// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Two passes over the rows: J^T p into velocities, then each row's own residual.
#include "solve/common/residual.h"

#include <algorithm>

#include "solve/common/contact_rows.h"
#include "solve/common/manifold_friction.h"

namespace epode {
namespace {

template <typename B>
B* second(std::span<B> bodies, const ManifoldFriction& f)
{
    return std::size_t(f.body2) < bodies.size() ? &bodies[std::size_t(f.body2)] : nullptr;
}

Row row_of(const ManifoldFriction& f, int k)
{
    Row row;
    static_cast<Jacobian&>(row) = f.rows[k];
    return row;
}

// True if the friction of the block is part of its manifold's friction.
bool in_manifold_friction(const RowSystem& system, const RowBlock& block)
{
    return system.manifold_friction && block.count == 3 && has_contact_form(system, block) &&
           allows_manifold_friction(manifold_of(system, block));
}

// The number of the block's rows that are judged one by one.
int own_rows(const RowSystem& system, const RowBlock& block)
{
    return in_manifold_friction(system, block) ? 1 : block.count;
}

// Measures how far impulses are from the box of their bounds; the two friction rows of a contact may be
// bounded by an ellipse.
class Wanted {
  public:
    Wanted(const RowSystem& system, std::span<const SolverBody> bodies, std::span<const Real> lo,
           std::span<const Real> hi)
        : system_(system), bodies_(bodies), lo_(lo), hi_(hi)
    {}

    // d |p - clip(p - w/d)|, the largest over the rows of the block.
    Real residual(const RowBlock& block) const
    {
        const int own = own_rows(system_, block);
        const bool cone = own > 1 && in_cone(block);
        Real worst = 0;
        for (int i = 0; i < own; ++i) {
            if (cone && (i == 1 || i == 2)) continue;  // both at once, below
            const auto k = std::size_t(block.first + i);
            const Real d = inverse_mass(block, k), p = system_.numbers[k].p;
            if (!(d > 0)) continue;  // an empty row constrains nothing
            const Real clipped = std::min(std::max(p - violation(block, k) / d, lo_[k]), hi_[k]);
            worst = std::max(worst, d * std::fabs(p - clipped));
        }
        return cone ? std::max(worst, friction_residual(block)) : worst;
    }

    // The same for a manifold friction in the ball of its limit, with the largest d of its rows.
    Real residual(const ManifoldFriction& f) const
    {
        const SolverBody& one = bodies_[std::size_t(f.body1)];
        Real d = 0, q[3], length2 = 0, worst = 0;
        for (int k = 0; k < 3; ++k)
            d = std::max(d, inverse_effective_mass(row_of(f, k), one, second(bodies_, f)) + f.C);
        if (!(d > 0)) return 0;
        for (int k = 0; k < 3; ++k) {
            const Real w = row_velocity(row_of(f, k), one, second(bodies_, f)) + f.C * f.p[k] - f.c[k];
            q[k] = f.p[k] - w / d;
            length2 += q[k] * q[k];
        }
        const Real scale = length2 > f.limit * f.limit ? f.limit / std::sqrt(length2) : 1;
        for (int k = 0; k < 3; ++k) worst = std::max(worst, d * std::fabs(f.p[k] - scale * q[k]));
        return worst;
    }

  private:
    // Impulses that the caller holds where they are have no ellipse.
    bool in_cone(const RowBlock& block) const
    {
        const auto k = std::size_t(block.first) + 1;
        return has_cone(system_, block) && lo_[k] < hi_[k] && lo_[k + 1] < hi_[k + 1];
    }

    Real inverse_mass(const RowBlock& block, std::size_t k) const
    {
        return inverse_effective_mass(system_, block, system_.rows[k], bodies_) + system_.numbers[k].C;
    }

    Real violation(const RowBlock& block, std::size_t k) const
    {
        const RowNumbers& n = system_.numbers[k];
        return row_velocity(system_, block, system_.rows[k], bodies_) + n.C * n.p - n.c;
    }

    Real friction_residual(const RowBlock& block) const
    {
        const auto k = std::size_t(block.first) + 1;
        const Real d = std::max(inverse_mass(block, k), inverse_mass(block, k + 1));
        if (!(d > 0)) return 0;
        Real p[2], q[2], length2 = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            p[i] = system_.numbers[k + i].p;
            q[i] = p[i] - violation(block, k + i) / d;
            const Real share = hi_[k + i] > 0 ? q[i] / hi_[k + i] : kInf;
            length2 += q[i] == 0 ? 0 : share * share;
        }
        const Real scale = length2 > 1 ? 1 / std::sqrt(length2) : 1;
        return d * std::max(std::fabs(p[0] - scale * q[0]), std::fabs(p[1] - scale * q[1]));
    }

    const RowSystem& system_;
    std::span<const SolverBody> bodies_;
    std::span<const Real> lo_, hi_;
};

}  // namespace

void present_bounds(const RowSystem& system, std::span<Real> lo, std::span<Real> hi)
{
    for (std::size_t i = 0; i < system.numbers.size(); ++i) {
        const RowNumbers& n = system.numbers[i];
        lo[i] = n.lo, hi[i] = n.hi;
        if (n.parent < 0) continue;
        const Real p = std::fabs(system.numbers[std::size_t(n.parent)].p);
        hi[i] = p > 0 ? n.hi * p : 0;
        lo[i] = -hi[i];
    }
}

std::span<const ManifoldFriction> frictions_of(const RowSystem& system, int part)
{
    const auto begin_at = [&](int body) {
        return std::partition_point(system.frictions.begin(), system.frictions.end(),
                                    [body](const ManifoldFriction& f) { return f.body1 < body; });
    };
    return {begin_at(system.begin_of(part).bodies), begin_at(system.end_of(part).bodies)};
}

Real natural_residual(const RowSystem& system, std::span<const SolverBody> v_star, std::span<const Real> lo,
                      std::span<const Real> hi, Arena& arena)
{
    if (system.rows.empty()) return 0;
    Arena::Scope scope(arena);
    auto bodies = arena.take<SolverBody>(int(v_star.size()));
    if (bodies.empty()) return -1;
    std::copy(v_star.begin(), v_star.end(), bodies.begin());

    Real scale = 0;
    for (const ManifoldFriction& f : system.frictions)
        for (int k = 0; k < 3; ++k)
            apply_impulse(row_of(f, k), f.p[k], bodies[std::size_t(f.body1)], second(std::span(bodies), f));
    for (const RowBlock& block : system.blocks) {
        const int own = own_rows(system, block);
        for (int i = block.first; i < block.first + block.count; ++i) {
            const auto k = std::size_t(i);
            const Real c = system.numbers[k].c, now = row_velocity(system, block, system.rows[k], v_star);
            scale = std::max({scale, std::fabs(c), std::fabs(c - now)});
            if (i < block.first + own)
                apply_impulse(system, block, system.rows[k], system.numbers[k].p, bodies);
        }
    }

    const Wanted wanted(system, bodies, lo, hi);
    Real worst = 0;
    for (const RowBlock& block : system.blocks) worst = std::max(worst, wanted.residual(block));
    for (const ManifoldFriction& f : system.frictions) worst = std::max(worst, wanted.residual(f));
    return worst / (scale > 0 ? scale : 1);
}

}  // namespace epode
