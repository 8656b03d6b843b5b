// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contact manifolds packed for sweeping (solve/substeps/manifold_batch.h). Graph colouring: manifolds of one
// colour share no dynamic body. Each gets the smallest colour that its bodies have free, in the order of the
// manifolds; manifolds against static bodies come after all others, so that they have the last word. Sixteen
// of one colour make a batch, or eight, manifolds with as many points together. Since colours depend on the
// neighbours alone, an island has the same answer whether it is packed alone or with others: many small
// islands fill the lanes that one would leave empty.
#pragma once

#include <initializer_list>
#include <span>

#include "base/arena.h"
#include "rows/row_system.h"
#include "solve/common/substep_rows.h"
#include "solve/common/velocities.h"
#include "solve/substeps/manifold_kernels.h"
#include "tasks/tasks.h"

namespace epode {

class ManifoldSet {
  public:
    explicit ManifoldSet(const ManifoldKernels& kernels = *manifold_kernels().back()) : kernels_(&kernels) {}

    // False: out of memory. Velocities are those before any force. `tasks` runs the batches of a colour, and
    // the bodies, in parallel if there are many.
    bool prepare(const RowSystem& system, const Substep& step, const Tasks& tasks, Arena& arena);
    bool empty() const { return batches_.empty(); }
    bool may_rebound() const { return any_elastic_; }

    // Sweeps over the velocities in floats; their changes are added to the doubles.
    void correct(std::span<Velocity> bodies);
    void relax(std::span<Velocity> bodies);
    // For bodies that only manifolds hold: the approach from which points rebound is that of the place where
    // they will meet, after what forces add on the way there (`force_velocity`, of one substep). Without it a
    // body that starts a step at the height s rebounds without the energy m g s.
    void expect_impacts(const RowSystem& system, std::span<const Velocity> force_velocity);
    // n substeps for bodies that only manifolds hold, with three visits to a body in each: first forces
    // (`force_velocity`) and impulses; after its contacts are corrected, motion (velocities summed in
    // `mean`); after they are relaxed, that change. `ends`, unless empty, gets the sum of the velocities then.
    void run_substeps(int n, std::span<Velocity> bodies, std::span<const Velocity> force_velocity,
                      std::span<Velocity> mean, std::span<Velocity> ends);
    // v += M^-1 J^T p with the impulses at the end of the last substep: the sum of all changes since its
    // beginning, body by body, so it needs no visit to the contacts.
    void apply_impulses(std::span<Velocity> bodies) const;
    void apply_impulses(std::span<SolverBody> bodies) const;  // the same
    void follow_motion(std::span<const Velocity> bodies);     // the bodies move for hs
    void store_impulses(std::span<ContactManifold* const> manifolds) const;
    // After that: the restitution times the approach of each point of each manifold, if it approached fast
    // enough and carried an impulse, or separated; else 0. Empty if nothing has restitution. False: out of
    // memory.
    bool find_rebounds(std::span<ContactManifold* const> manifolds, Arena& arena,
                       std::span<float>& rebounds) const;

  private:
    void colour(std::span<ContactManifold* const> manifolds, std::span<const SolverBody> bodies,
                std::span<int> colours, Arena& arena);
    void sort(std::span<ContactManifold* const> manifolds, std::span<const int> colours,
              std::span<int> starts);
    template <typename F>
    void for_each_batch(std::span<ContactManifold* const> manifolds, std::span<const int> starts,
                        F&& f) const;
    int count_batches(std::span<ContactManifold* const> manifolds, std::span<const int> starts) const;
    int cut(std::span<ContactManifold* const> manifolds, std::span<const int> starts);
    bool place_extras(std::span<ContactManifold* const> manifolds, Arena& arena);
    void fill_extra(const ContactManifold& manifold, int substeps, ManifoldBatch& batch, int lane) const;
    void fill(const RowSystem& system, const Substep& step);
    void prefetch_lanes(const RowSystem& system, std::size_t batch) const;
    void fill_batch(const RowSystem& system, const Substep& step, const ManifoldSprings& springs,
                    std::size_t batch);
    void choose_lane(const RowSystem& system, std::size_t batch, int lane, ManifoldSources& from);
    BroadLanes& initial_velocity_of(const ManifoldBatch& batch, int point) const;
    ManifoldBodies view(std::span<Velocity> bodies);
    // One pass over all bodies, or over all batches colour by colour.
    enum class Visit { kLoad, kAccelerate, kMove, kTake, kApplyImpulses, kCorrect, kRelax };
    static bool is_of_bodies(Visit visit) { return visit < Visit::kApplyImpulses; }
    // Bodies or batches that are independent of each other.
    struct Stage {
        Visit visit;
        int first, last;
        int pieces;  // of work, of nearly equal size
    };
    static constexpr int kMaxVisits = 5;
    void perform(std::initializer_list<Visit> round, int times, const ManifoldBodies& bodies);
    Stage stage(Visit visit, int first, int last) const;
    int list_stages(std::initializer_list<Visit> round);
    void visit(Visit visit, const ManifoldBodies& bodies, int first, int last) const;

    const ManifoldKernels* kernels_;
    std::span<ManifoldBatch> batches_;
    std::span<ManifoldLanes> points_;             // if each point has its own friction
    std::span<ManifoldFrictionLanes> frictions_;  // else one per batch
    std::span<FloatMotion> motions_;              // the last is the world
    std::span<Velocity> impulse_velocity_;        // effect of the impulses of the last substep on each body
    std::span<int> order_;            // of the manifolds, by colour and number of points; lane by lane
    std::span<int> chosen_;           // the manifold in each lane of each batch; -1: none
    std::span<int> first_of_colour_;  // batch; one more at the end
    std::span<Stage> stages_;         // of a round
    int colours_ = 0;
    bool any_special_ = false, any_elastic_ = false;
    bool manifold_friction_ = false;  // one friction per manifold
    Tasks tasks_;
    Real hs_ = 0;
    ManifoldSweep sweep_{};
};

}  // namespace epode
