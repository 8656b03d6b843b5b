// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "solve/substeps/impacts/impact_friction.h"

#include <algorithm>
#include <cmath>

#include "rows/wrench.h"

namespace epode {
namespace {

// Within the ellipse with these half axes, along the ray from its middle, or within the box.
void bound(Real (&p)[2], const Real (&hi)[2], bool cone)
{
    if (!cone || !(hi[0] > 0) || !(hi[1] > 0)) {
        for (int i : {0, 1}) p[i] = std::clamp(p[i], -hi[i], hi[i]);
        return;
    }
    const Real x = p[0] / hi[0], y = p[1] / hi[1], length = std::sqrt(x * x + y * y);
    if (length > 1) p[0] /= length, p[1] /= length;
}

}  // namespace

void ImpactFriction::add(const RowBlock& block, int index, Real normal_impulse)
{
    Pair pair;
    pair.body1 = block.body1, pair.body2 = block.body2, pair.block = index, pair.cone = block.cone;
    int found = 0;
    for (int i = block.first + 1; i < block.first + block.count && found < 2; ++i) {
        const RowNumbers& n = system_.numbers[std::size_t(i)];
        const Row& row = system_.rows[std::size_t(i)];
        if (n.parent != block.first || !(length2(row.lin1) > 0)) continue;  // a constant bound; rolling
        pair.J[found] = row, pair.rows[found] = i;
        pair.c[found] = n.c, pair.C[found] = n.C, pair.p[found] = n.p;
        pair.hi[found] = n.hi * normal_impulse;
        ++found;
    }
    if (found > 0) keep(pair);
}

void ImpactFriction::add(const ContactManifold& manifold, ManifoldPoint& point)
{
    const FrictionAxes axes(manifold);
    if (!(axes.mu > 0)) return;
    Pair pair;
    pair.body1 = manifold.body1, pair.body2 = manifold.body2, pair.point = &point;
    for (int i : {0, 1}) {
        const Vec3 t = axes.scaled(i);
        pair.J[i] = {t, cross(widen(point.r1), t), -t, -cross(widen(point.r2), t)};
        pair.c[i] = dot(t, widen(manifold.surface_velocity));
        pair.p[i] = axes.part(i, widen(point.friction_impulse));
        pair.hi[i] = axes.mu * Real(point.normal_impulse);
    }
    keep(pair);
}

// The largest eigenvalue of a symmetric 2 x 2 matrix is at largest the larger sum of a row's magnitudes.
void ImpactFriction::keep(Pair& pair)
{
    if (pair.body2 < 0) pair.body2 = -1;
    const auto K = [&](int i, int j) {
        return bodies().freedom(pair.J[i], pair.J[j], pair.body1, pair.body2);
    };
    const Real largest = std::max(K(0, 0) + pair.C[0], K(1, 1) + pair.C[1]) + std::fabs(K(0, 1));
    if (!(largest > 0)) return;
    pair.gain = 1 / largest;
    for (int i : {0, 1}) pair.before[i] = pair.p[i], pair.hi[i] = std::max(pair.hi[i], std::fabs(pair.p[i]));
    buffer_[count_++] = pair;
}

// Returns how much velocity has changed.
Real ImpactFriction::visit(Pair& pair) const
{
    Real p[2];
    for (int i : {0, 1}) {
        const Real u = bodies().velocity(pair.J[i], pair.body1, pair.body2);
        p[i] = pair.p[i] + pair.gain * (pair.c[i] - u - pair.C[i] * pair.p[i]);
    }
    bound(p, pair.hi, pair.cone);
    const Real d[2] = {p[0] - pair.p[0], p[1] - pair.p[1]};
    for (int i : {0, 1}) bodies().push(pair.J[i], pair.body1, pair.body2, d[i]), pair.p[i] = p[i];
    return std::max(std::fabs(d[0]), std::fabs(d[1])) / pair.gain;
}

void ImpactFriction::solve(Real settled, int sweeps)
{
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        Real largest = 0;
        for (Pair& pair : buffer_.first(count_)) largest = std::max(largest, visit(pair));
        if (!(largest > settled)) return;
    }
}

void ImpactFriction::store() const
{
    for (const Pair& pair : pairs())
        for (int i : {0, 1}) store(pair, i);
}

void ImpactFriction::store(const Pair& pair, int i) const
{
    const Real dp = pair.p[i] - pair.before[i];
    if (pair.point) {
        pair.point->friction_impulse = narrow(widen(pair.point->friction_impulse) + dp * pair.J[i].lin1);
        return;
    }
    if (pair.rows[i] < 0) return;
    system_.numbers[std::size_t(pair.rows[i])].p += dp;
    const RowBlock& block = system_.blocks[std::size_t(pair.block)];
    if (block.wrench < 0) return;
    Row exerts;
    static_cast<Jacobian&>(exerts) = pair.J[i];
    system_.wrenches[std::size_t(block.wrench)].add(block, pair.rows[i], exerts, dp);
}

}  // namespace epode
