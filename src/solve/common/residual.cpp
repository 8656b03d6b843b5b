// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Two passes over the rows: J^T p into velocities, then each row's own residual. Both in double whatever Real is:
// at 300 m/s, or where a light body passes on the load of heavy ones, J v is a small difference of terms that floats
// round more than any solver does.
#include "solve/common/residual.h"

#include <algorithm>

#include "solve/common/contact_rows.h"
#include "solve/common/manifold_friction.h"

namespace epode {
namespace {

// Velocity of a body.
struct Twist {
    double v[3], w[3];
};

Twist twist_of(const SolverBody& body)
{
    return {{body.v.x, body.v.y, body.v.z}, {body.w.x, body.w.y, body.w.z}};
}

double along(Vec3 a, const double* v) { return double(a.x) * v[0] + double(a.y) * v[1] + double(a.z) * v[2]; }
double along(Vec3 lin, Vec3 ang, const Twist& t) { return along(lin, t.v) + along(ang, t.w); }

// t += M^-1 (lin, ang) p
void push(const SolverBody& body, Vec3 lin, Vec3 ang, double p, Twist& t)
{
    const Sym3& s = body.inv_inertia;
    const double by_mass = double(body.inv_mass) * p, a[3] = {ang.x, ang.y, ang.z};
    const double turn[3] = {along({s.xx, s.xy, s.xz}, a), along({s.xy, s.yy, s.yz}, a),
                            along({s.xz, s.yz, s.zz}, a)};
    for (int i = 0; i < 3; ++i) t.v[i] += by_mass * double(lin[i]), t.w[i] += p * turn[i];
}

// The bodies of a system, whose masses do not change, and velocities that do.
struct Motion {
    std::span<const SolverBody> bodies;
    std::span<Twist> twists;

    bool has(int body) const { return body >= 0 && std::size_t(body) < bodies.size(); }
    const SolverBody* body(int i) const { return has(i) ? &bodies[std::size_t(i)] : nullptr; }

    // J v of a row between two bodies, the second perhaps none.
    double along(const Jacobian& J, int body1, int body2) const
    {
        double sum = epode::along(J.lin1, J.ang1, twists[std::size_t(body1)]);
        if (has(body2)) sum += epode::along(J.lin2, J.ang2, twists[std::size_t(body2)]);
        return sum;
    }
    double along(const RowSystem& system, const RowBlock& block, const Row& row) const
    {
        if (block.term_count == 0) return along(row, block.body1, block.body2);
        double sum = 0;
        for (const WideTerm& term : terms_of(system, block))
            sum += epode::along(term.lin, term.ang, twists[std::size_t(term.body)]);
        return sum;
    }

    void push_one(int i, Vec3 lin, Vec3 ang, double p)
    {
        if (has(i)) push(bodies[std::size_t(i)], lin, ang, p, twists[std::size_t(i)]);
    }
    void push_both(const Jacobian& J, int body1, int body2, double p)
    {
        push_one(body1, J.lin1, J.ang1, p), push_one(body2, J.lin2, J.ang2, p);
    }
    void push_all(const RowSystem& system, const RowBlock& block, const Row& row, double p)
    {
        if (block.term_count == 0) return push_both(row, block.body1, block.body2, p);
        for (const WideTerm& term : terms_of(system, block)) push_one(term.body, term.lin, term.ang, p);
    }
};

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
    Wanted(const RowSystem& system, const Motion& motion, std::span<const Real> lo, std::span<const Real> hi)
        : system_(system), motion_(motion), lo_(lo), hi_(hi)
    {}

    // |clip(w, d (p - hi), d (p - lo))|, the largest over the rows of the block.
    double residual(const RowBlock& block) const
    {
        const int own = own_rows(system_, block);
        const bool cone = own > 1 && in_cone(block);
        double worst = 0;
        for (int i = 0; i < own; ++i) {
            if (cone && (i == 1 || i == 2)) continue;  // both at once, below
            const auto k = std::size_t(block.first + i);
            const double d = inverse_mass(block, k), p = double(system_.numbers[k].p);
            if (!(d > 0)) continue;  // an empty row constrains nothing
            const double w = violation(block, k);
            worst = std::max(
                worst, std::fabs(std::min(std::max(w, d * (p - double(hi_[k]))), d * (p - double(lo_[k])))));
        }
        return cone ? std::max(worst, friction_residual(block)) : worst;
    }

    // The same for a manifold friction in the ball of its limit, with the largest d of its rows.
    double residual(const ManifoldFriction& f) const
    {
        double d = 0, p[3], q[3], length2 = 0, worst = 0;
        for (int k = 0; k < 3; ++k)
            d = std::max(d, double(inverse_effective_mass(row_of(f, k), *motion_.body(f.body1),
                                                          motion_.body(f.body2)) +
                                   f.C));
        if (!(d > 0)) return 0;
        const double limit = double(f.limit);
        for (int k = 0; k < 3; ++k) {
            p[k] = double(f.p[k]);
            const double w = motion_.along(f.rows[k], f.body1, f.body2) + double(f.C) * p[k] - double(f.c[k]);
            q[k] = p[k] - w / d;
            length2 += q[k] * q[k];
        }
        const double scale = length2 > limit * limit ? limit / std::sqrt(length2) : 1;
        for (int k = 0; k < 3; ++k) worst = std::max(worst, d * std::fabs(p[k] - scale * q[k]));
        return worst;
    }

  private:
    // Impulses that the caller holds where they are have no ellipse.
    bool in_cone(const RowBlock& block) const
    {
        const auto k = std::size_t(block.first) + 1;
        return has_cone(system_, block) && lo_[k] < hi_[k] && lo_[k + 1] < hi_[k + 1];
    }

    double inverse_mass(const RowBlock& block, std::size_t k) const
    {
        return double(inverse_effective_mass(system_, block, system_.rows[k], motion_.bodies) +
                      system_.numbers[k].C);
    }

    double violation(const RowBlock& block, std::size_t k) const
    {
        const RowNumbers& n = system_.numbers[k];
        return motion_.along(system_, block, system_.rows[k]) + double(n.C) * double(n.p) - double(n.c);
    }

    double friction_residual(const RowBlock& block) const
    {
        const auto k = std::size_t(block.first) + 1;
        const double d = std::max(inverse_mass(block, k), inverse_mass(block, k + 1));
        if (!(d > 0)) return 0;
        double p[2], q[2], length2 = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            p[i] = double(system_.numbers[k + i].p);
            q[i] = p[i] - violation(block, k + i) / d;
            const double share = hi_[k + i] > 0 ? q[i] / double(hi_[k + i]) : double(kInf);
            length2 += q[i] == 0 ? 0 : share * share;
        }
        const double scale = length2 > 1 ? 1 / std::sqrt(length2) : 1;
        return d * std::max(std::fabs(p[0] - scale * q[0]), std::fabs(p[1] - scale * q[1]));
    }

    const RowSystem& system_;
    const Motion& motion_;
    std::span<const Real> lo_, hi_;
};

double scale_of(const RowSystem& system, const Motion& motion)
{
    double scale = 0;
    for (const RowBlock& block : system.blocks)
        for (int i = block.first; i < block.first + block.count; ++i) {
            const auto k = std::size_t(i);
            const double c = double(system.numbers[k].c), now = motion.along(system, block, system.rows[k]);
            scale = std::max({scale, std::fabs(c), std::fabs(c - now)});
        }
    return scale;
}

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
    Motion motion{v_star, arena.take<Twist>(int(v_star.size()))};
    if (motion.twists.empty()) return -1;
    std::transform(v_star.begin(), v_star.end(), motion.twists.begin(), twist_of);

    const double scale = scale_of(system, motion);
    for (const ManifoldFriction& f : system.frictions)
        for (int k = 0; k < 3; ++k) motion.push_both(f.rows[k], f.body1, f.body2, double(f.p[k]));
    for (const RowBlock& block : system.blocks)
        for (int i = block.first; i < block.first + own_rows(system, block); ++i)
            motion.push_all(system, block, system.rows[std::size_t(i)],
                            double(system.numbers[std::size_t(i)].p));

    const Wanted wanted(system, motion, lo, hi);
    double worst = 0;
    for (const RowBlock& block : system.blocks) worst = std::max(worst, wanted.residual(block));
    for (const ManifoldFriction& f : system.frictions) worst = std::max(worst, wanted.residual(f));
    return Real(worst / (scale > 0 ? scale : 1));
}

}  // namespace epode
