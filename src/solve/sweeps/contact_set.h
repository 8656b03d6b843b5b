// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joint manifolds packed for sweeping (solve/sweeps/contact_batch.h) and the operations on all of them.
// Manifolds that share no dynamic body are put side by side into batches, greedily from a short window, in
// order. So the packing is a function of the island alone, and neighbours in memory stay neighbours.
#pragma once

#include <span>

#include "base/arena.h"
#include "base/random.h"
#include "rows/row_system.h"
#include "solve/common/manifold_friction.h"
#include "solve/sweeps/contact_batch.h"
#include "solve/sweeps/contact_kernels.h"

namespace epode {

// The points that the lanes of a batch's point came from; -1: none.
template <typename L>
struct ContactSourceOf {
    int point[L::kCount];
};

// L: Lanes or BroadLanes.
template <typename L>
class ContactSetOf {
  public:
    using Batch = ContactBatchOf<L>;
    using Point = BatchPointOf<L>;
    using Source = ContactSourceOf<L>;
    using Bodies = typename VelocityOf<L>::Type;

    explicit ContactSetOf(const ContactKernels& kernels = *contact_kernels().back())
        : machine_(&kernels), kernels_(&kernels.of(static_cast<const L*>(nullptr)))
    {}

    // False: out of memory. `w`: over-relaxation.
    bool pack(const RowSystem& system, const JointManifoldList& list, Real w, Arena& arena);

    void apply_impulses(std::span<Bodies> bodies) const;  // v += M^-1 J^T p
    void shuffle(CounterRandom& random);                  // the order of the sweeps to come
    void sweep(std::span<Bodies> bodies);
    void relax_by(Real factor);  // multiplies the over-relaxation of the sweeps to come
    void store_impulses(std::span<JointManifoldPoint> points) const;
    // One for each manifold with manifold friction, in the order of the manifolds. Empty: none, or out of
    // memory.
    std::span<ManifoldFriction> manifold_frictions(Arena& arena) const;
    // J_n v of the points of a batch; for Lanes only.
    void normal_velocities(const Batch& batch, std::span<const Velocity> bodies,
                           std::span<Lanes, kManifoldPoints> out) const;

    bool empty() const { return batches_.empty(); }
    std::span<Batch> batches() { return batches_; }
    std::span<Point> points() { return points_; }
    std::span<const Source> sources() const { return sources_; }

  private:
    using Number = typename L::Number;
    static constexpr int kCount = L::kCount;

    // The manifolds of a batch, -1: none; and its points.
    struct Choice {
        int manifold[kCount];
        int first, count;
    };

    bool choose(const RowSystem& system, std::span<const JointManifold> manifolds, Arena& arena);
    void fill_batch(const RowSystem& system, const JointManifoldList& list, const Choice& choice,
                    Batch& batch);
    void choose_lane(const RowSystem& system, const JointManifoldList& list, int manifold, Batch& batch,
                     int lane, ContactSourcesOf<L>& from);
    bool place_frictions(std::span<const JointManifold> manifolds, Arena& arena);
    void fill_friction(const JointManifoldList& list, std::size_t batch);
    ManifoldFriction friction_of(const Batch& batch, int lane) const;

    const ContactKernels* machine_;
    const ContactKernelsOf<L>* kernels_;
    bool manifold_friction_ = false;  // manifolds that allow it have one friction
    int manifolds_ = 0;
    std::span<Choice> chosen_;
    std::span<Batch> batches_;
    std::span<int> order_;  // of the batches in a sweep
    std::span<Point> points_;
    std::span<Source> sources_;
};

template <>
void ContactSetOf<Lanes>::normal_velocities(const ContactBatch& batch, std::span<const Velocity> bodies,
                                            std::span<Lanes, kManifoldPoints> out) const;

using ContactSet = ContactSetOf<Lanes>;
using FloatContactSet = ContactSetOf<BroadLanes>;

}  // namespace epode
