// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/steppers/manifold_substeps.h"

#include "solve/substeps/impacts/restitution.h"
#include "solve/substeps/manifold_set.h"

namespace epode {
namespace {

class ManifoldSubsteps {
  public:
    ManifoldSubsteps(RowSystem& system, SubstepModel& model, int n, const Tasks& tasks,
                     std::span<Velocity> ends)
        : system_(system), model_(model), step_{system.h / Real(n), n}, tasks_(tasks), ends_(ends)
    {}

    bool prepare(Arena& arena)
    {
        const int bodies = int(system_.bodies.size());
        velocities_ = take_velocities(system_, arena);
        force_velocity_ = arena.take<Velocity>(bodies);
        mean_ = arena.take_zeroed<Velocity>(bodies);
        if (arena.failed() || !manifolds_.prepare(system_, step_, tasks_, arena)) return false;
        for (Velocity& world : velocities_.subspan(force_velocity_.size())) world = {};
        each_body([&](std::size_t i) {
            const SolverBody& body = system_.bodies[i];
            velocities_[i] = {body.v, 0, body.w, 0};
            force_velocity_[i] = {body.v, 0, body.w, 0};
        });
        model_.apply_forces(force_velocity_, system_.h);
        const Real share = 1 / Real(step_.n);
        each_body([&](std::size_t i) {
            const Velocity &now = velocities_[i], then = force_velocity_[i];
            force_velocity_[i] = {share * (then.v - now.v), 0, share * (then.w - now.w), 0};
        });
        model_.kick_spins(velocities_.first(force_velocity_.size()), system_.h);
        manifolds_.expect_impacts(system_, force_velocity_);
        return true;
    }

    // False: out of memory.
    bool run(Arena& arena)
    {
        manifolds_.run_substeps(step_.n, velocities_, force_velocity_, mean_, ends_);
        move();
        each_body([&](std::size_t i) {
            system_.bodies[i].v = velocities_[i].v, system_.bodies[i].w = velocities_[i].w;
        });
        manifolds_.store_impulses(system_.contact_manifolds);
        std::span<float> rebounds;
        if (!manifolds_.find_rebounds(system_.contact_manifolds, arena, rebounds)) return false;
        return rebounds.empty() || Restitution(system_, rebounds).apply({}, arena);
    }

  private:
    void move()
    {
        const Real share = 1 / Real(step_.n);
        each_body([&](std::size_t i) { mean_[i] = {share * mean_[i].v, 0, share * mean_[i].w, 0}; });
        model_.advance(mean_, velocities_.first(mean_.size()), system_.h);
        model_.settle();
    }

    template <typename F>
    void each_body(F&& f) const
    {
        tasks_.each_of(int(force_velocity_.size()), kRange, f);
    }

    static constexpr int kRange = 512;  // bodies that one worker does
    RowSystem& system_;
    SubstepModel& model_;
    const Substep step_;
    const Tasks& tasks_;
    ManifoldSet manifolds_;
    std::span<Velocity> velocities_;
    std::span<Velocity> force_velocity_;  // by forces, in one substep
    std::span<Velocity> mean_;            // times n
    const std::span<Velocity> ends_;
};

}  // namespace

bool make_manifold_substeps(RowSystem& system, SubstepModel& model, int n, const Tasks& tasks,
                            std::span<Velocity> ends, Arena& arena)
{
    Arena::Scope scope(arena);
    ManifoldSubsteps substeps(system, model, n, tasks, ends);
    return substeps.prepare(arena) && substeps.run(arena);
}

}  // namespace epode
