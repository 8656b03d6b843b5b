// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contacts packed for sweeping (solve/contact_batch.h) and what is done to all of them. Consecutive contacts
// of one pair of bodies make a manifold; manifolds that share no dynamic body are put side by side into
// batches, greedily from a short window, in order, so that the packing is a function of the island alone and
// neighbours in memory stay neighbours. Blocks that are not a normal row with none or two tangents are left
// to others.
#pragma once

#include <span>

#include "base/arena.h"
#include "base/random.h"
#include "rows/row_system.h"
#include "solve/contact_batch.h"
#include "solve/contact_kernels.h"
#include "solve/velocities.h"

namespace epode {

// The normal row that a lane of a point came from; -1: none.
struct ContactSource {
    int row[kLanes];
    bool friction[kLanes];
};

class ContactSet {
  public:
    explicit ContactSet(const ContactKernels& kernels = *contact_kernels().back()) : kernels_(&kernels) {}

    // Packs the blocks that have the form above and marks them; false: out of memory. `w`: over-relaxation.
    bool pack(const RowSystem& system, Real w, std::span<bool> packed, Arena& arena);

    void apply_impulses(std::span<Velocity> bodies) const;  // v += M^-1 J^T p
    void shuffle(CounterRandom& random);                    // the order of the sweeps to come
    void sweep(std::span<Velocity> bodies);
    void relax_by(Real factor);  // multiplies the over-relaxation of the sweeps to come
    void store_impulses(std::span<RowNumbers> numbers) const;
    // J_n v of the points of a batch.
    void normal_velocities(const ContactBatch& batch, std::span<const Velocity> bodies,
                           std::span<Lanes, kManifoldPoints> out) const;

    std::span<ContactBatch> batches() { return batches_; }
    std::span<BatchPoint> points() { return points_; }
    std::span<const ContactSource> sources() const { return sources_; }

  private:
    struct Manifold {
        int block, count;
        int body1, body2;
    };

    void find_manifolds(const RowSystem& system, std::span<bool> packed);
    void batch_manifolds(const RowSystem& system, std::span<bool> used);
    bool is_full(const RowSystem& system, std::size_t batch) const;
    void fill(const RowSystem& system, Real w);
    void fill_lane(const RowSystem& system, const Manifold& manifold, ContactBatch& batch, int lane);

    const ContactKernels* kernels_;
    std::span<Manifold> manifolds_;
    std::span<int> chosen_;  // kLanes manifolds per batch, -1: none
    std::span<ContactBatch> batches_;
    std::span<int> order_;  // of the batches in a sweep
    std::span<BatchPoint> points_;
    std::span<ContactSource> sources_;
    int manifold_count_ = 0;
};

}  // namespace epode
