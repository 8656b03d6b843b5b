// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Manifolds packed for sweeping (solve/contact_batch.h) and what is done to all of them. Those that share no
// dynamic body are put side by side into batches, greedily from a short window, in order, so that the packing
// is a function of the island alone and neighbours in memory stay neighbours.
#pragma once

#include <span>

#include "base/arena.h"
#include "base/random.h"
#include "rows/row_system.h"
#include "solve/contact_batch.h"
#include "solve/contact_kernels.h"
#include "solve/velocities.h"

namespace epode {

// The points that the lanes of a batch's point came from; -1: none.
struct ContactSource {
    int point[kLanes];
};

class ContactSet {
  public:
    explicit ContactSet(const ContactKernels& kernels = *contact_kernels().back()) : kernels_(&kernels) {}

    // False: out of memory. `w`: over-relaxation.
    bool pack(const RowSystem& system, const ManifoldList& list, Real w, Arena& arena);

    void apply_impulses(std::span<Velocity> bodies) const;  // v += M^-1 J^T p
    void shuffle(CounterRandom& random);                    // the order of the sweeps to come
    void sweep(std::span<Velocity> bodies);
    void relax_by(Real factor);  // multiplies the over-relaxation of the sweeps to come
    void store_impulses(std::span<ManifoldPoint> points) const;
    // J_n v of the points of a batch.
    void normal_velocities(const ContactBatch& batch, std::span<const Velocity> bodies,
                           std::span<Lanes, kManifoldPoints> out) const;

    std::span<ContactBatch> batches() { return batches_; }
    std::span<BatchPoint> points() { return points_; }
    std::span<const ContactSource> sources() const { return sources_; }

  private:
    // The manifolds of a batch, -1: none; and its points.
    struct Choice {
        int manifold[kLanes];
        int first, count;
    };

    bool choose(const RowSystem& system, std::span<const Manifold> manifolds, Arena& arena);
    void fill_lane(const RowSystem& system, const ManifoldList& list, int manifold, ContactBatch& batch,
                   int lane);

    const ContactKernels* kernels_;
    std::span<Choice> chosen_;
    std::span<ContactBatch> batches_;
    std::span<int> order_;  // of the batches in a sweep
    std::span<BatchPoint> points_;
    std::span<ContactSource> sources_;
};

}  // namespace epode
