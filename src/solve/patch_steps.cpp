// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "solve/patch_steps.h"

#include <algorithm>

#include "solve/patch_set.h"

namespace epode {
namespace {

class PatchSteps {
  public:
    PatchSteps(RowSystem& system, const Substeps& model, int n)
        : system_(system), model_(model), step_{system.h / Real(n), n}
    {}

    bool prepare(const Tasks& tasks, Arena& arena)
    {
        const int bodies = int(system_.bodies.size());
        velocities_ = take_velocities(system_, arena);
        gain_ = arena.take<Velocity>(bodies);
        mean_ = arena.take_zeroed<Velocity>(bodies);
        if (arena.failed() || !patches_.prepare(system_, step_, tasks, arena)) return false;
        load_velocities(system_, velocities_);
        std::copy_n(velocities_.begin(), gain_.size(), gain_.begin());
        model_.apply_forces(model_.model, gain_.data(), system_.h);
        const Real share = 1 / Real(step_.n);
        for (std::size_t i = 0; i < gain_.size(); ++i)
            gain_[i] = {share * (gain_[i].v - velocities_[i].v), 0, share * (gain_[i].w - velocities_[i].w),
                        0};
        return true;
    }

    void run()
    {
        for (int i = 0; i < step_.n; ++i) patches_.small_step(velocities_, gain_, mean_);
        move();
        patches_.rebound(velocities_);
        store_velocities(velocities_, system_);
        patches_.store_impulses(system_.patches);
    }

  private:
    void move()
    {
        const Real share = 1 / Real(step_.n);
        for (Velocity& mean : mean_) mean = {share * mean.v, 0, share * mean.w, 0};
        model_.advance(model_.model, system_, mean_.data(), system_.h);
        model_.settle(model_.model, system_);
    }

    RowSystem& system_;
    const Substeps& model_;
    const Substep step_;
    PatchSet patches_;
    std::span<Velocity> velocities_;
    std::span<Velocity> gain_;  // by forces, in one small step
    std::span<Velocity> mean_;  // times n
};

}  // namespace

bool solve_patches(RowSystem& system, const SolverSettings& settings, Arena& arena)
{
    Arena::Scope scope(arena);
    PatchSteps steps(system, *settings.substeps, std::max(1, settings.iterations));
    if (!steps.prepare(settings.tasks, arena)) return false;
    steps.run();
    return true;
}

}  // namespace epode
