// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Friction of what rebounds. The substeps have solved friction under the impulses p_n that end an approach; the
// rebound adds dp to them (restitution.h), and Coulomb's law holds for both together:
//
//   minimise  1/2 v^T M v   over the friction impulses p_t,   |p_t| <= mu (p_n + dp)
//
// or, for contact joints with a friction pyramid, each component below its own share. Only points with dp > 0
// take part, so that what the substeps found is allowed, and projected gradients with steps below the inverse
// of the largest eigenvalue of J M^-1 J^T, contact by contact, never add energy:
//
//   p_t := P(p_t + (c - u_t - C p_t)/(largest eigenvalue)),   P: the nearest point within the bound
#pragma once

#include <span>

#include "solve/substeps/impacts/impact.h"

namespace epode {

class ImpactFriction {
  public:
    struct Pair {
        Jacobian J[2];
        int body1 = -1, body2 = -1;
        Real c[2] = {}, C[2] = {};       // target velocity; compliance
        Real p[2] = {}, before[2] = {};  // impulses, now and after the substeps
        Real hi[2] = {};                 // bounds
        Real gain = 0;
        bool cone = true;
        int block = -1, rows[2] = {-1, -1};  // of a contact joint
        ManifoldPoint* point = nullptr;      // of a manifold
    };

    // `buffer`: large enough for all pairs.
    ImpactFriction(RowSystem& system, std::span<Pair> buffer) : system_(system), buffer_(buffer) {}

    // A contact whose normal impulse is `normal_impulse` now: of a joint, or a point of a manifold.
    void add(const RowBlock& block, int index, Real normal_impulse);
    void add(const ContactManifold& manifold, ManifoldPoint& point);

    // Until no sweep changes a velocity by more than `settled`; `sweeps` at most.
    void solve(Real settled, int sweeps);
    void store() const;
    std::span<const Pair> pairs() const { return buffer_.first(count_); }

  private:
    ImpactBodies bodies() const { return {system_.bodies}; }
    void keep(Pair& pair);
    Real visit(Pair& pair) const;
    void store(const Pair& pair, int i) const;

    RowSystem& system_;
    std::span<Pair> buffer_;
    std::size_t count_ = 0;
};

}  // namespace epode
