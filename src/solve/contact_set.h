// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contacts packed for sweeping: a normal row and two friction rows (or the normal alone), between the same
// two points of the bodies. With arms r1, r2 from the centres, u = v1 + w1 x r1 - v2 - w2 x r2 is the
// velocity that all three rows share, so a visit to a contact is
//
//   u_k = d_k . u,  d = n, t1, t2;    then for k = n, t1, t2:
//   q_k = clip(keep_k p_k + gain_k (c_k - u_k)),  u_j += K_jk (q_k - p_k) for j > k
//   P = sum d_k (q_k - p_k);   v1 += P/m1, w1 += I1^-1 (r1 x P), v2 -= ..., w2 -= ...
//
// which is Gauss-Seidel row by row (K_jk = J_j M^-1 J_k^T), but reads 270 bytes per contact where Jacobians
// and M^-1 J^T take 480, and touches the velocities once. Consecutive contacts of one pair of bodies make a
// manifold, during which the velocities stay in registers; the lanes of a vector work on different manifolds,
// none of which shares a dynamic body with another. The alternative, one contact spread over the lanes,
// waits for its own sums.
#pragma once

#include <span>

#include "base/arena.h"
#include "base/random.h"
#include "rows/row_system.h"
#include "simd/lanes.h"
#include "solve/velocities.h"

namespace epode {

struct ContactPoint {
    LaneVec3 r1, r2, n, t1, t2;
    Lanes k_n1, k_n2, k_12;              // coupling of normal and tangents
    Lanes c[3], keep[3], gain[3], p[3];  // n, t1, t2
    Lanes mu[2], fixed[2];               // limit of friction: mu p_n + fixed
};

struct ContactBatch {
    int first = 0, count = 0;          // of the points
    int body1[kLanes], body2[kLanes];  // into the velocities
    Lanes inv_mass1, inv_mass2;
    LaneSym3 inv_inertia1, inv_inertia2;
};

// The normal row that a lane of a point came from; -1: none.
struct ContactSource {
    int row[kLanes];
    bool friction[kLanes];
};

class ContactSet {
  public:
    // Packs the blocks that have the form above and marks them; false: out of memory. `w`: over-relaxation.
    bool pack(const RowSystem& system, Real w, std::span<bool> packed, Arena& arena);

    void apply_impulses(std::span<Velocity> bodies) const;  // v += M^-1 J^T p
    void shuffle(CounterRandom& random);                    // the order of the sweeps to come
    void sweep(std::span<Velocity> bodies);
    void store_impulses(std::span<RowNumbers> numbers) const;

    std::span<ContactBatch> batches() { return batches_; }
    std::span<ContactPoint> points() { return points_; }
    std::span<const ContactSource> sources() const { return sources_; }

  private:
    struct Manifold {
        int block, count;
        int body1, body2;
    };

    void prefetch(const ContactBatch& batch) const;
    void find_manifolds(const RowSystem& system, std::span<bool> packed);
    void batch_manifolds(const RowSystem& system, std::span<bool> used);
    void fill(const RowSystem& system, Real w);
    void fill_lane(const RowSystem& system, Real w, const Manifold& manifold, ContactBatch& batch, int lane);

    std::span<Manifold> manifolds_;
    std::span<int> chosen_;  // kLanes manifolds per batch, -1: none
    std::span<ContactBatch> batches_;
    std::span<int> order_;  // of the batches in a sweep
    std::span<ContactPoint> points_;
    std::span<ContactSource> sources_;
    int manifold_count_ = 0;
};

// Jn of the normal rows at the present velocities.
Lanes normal_velocity(const ContactBatch& batch, const ContactPoint& point, std::span<const Velocity> bodies);

}  // namespace epode
