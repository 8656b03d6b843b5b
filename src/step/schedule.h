// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Islands are independent, so they are the units of parallel work: consecutive small ones form groups, which a stepper steps
// together if it shares (steppers/stepper.h); large ones come first, one after another with all workers on each, if the stepper can
// use them; then the other groups concurrently, in parcels of about equal weight.
#pragma once

#include "step/island/island_run.h"
#include "step/workers.h"

namespace epode {

struct Stepper;

// Consecutive islands that one stepper steps together.
struct IslandGroup {
    const Stepper* stepper;
    int iterations;
    int first, count;
    int weight;
    int draw;           // part of the random seed
    int first_contact;  // of its joints, among those of all groups
};

class Schedule {
  public:
    // `context.methods` has the methods of the islands, if any. False: out of memory.
    [[nodiscard]] bool make(const StepContext& context, std::span<const Island> islands, Arena& arena);

    std::span<const IslandGroup> groups() const { return groups_; }
    int joints() const { return joints_; }  // of all islands

    // Calls step(number of the group, tasks, worker) for each group.
    template <typename Step>
    void run(const Workers& workers, Step&& step)
    {
        const bool alone = workers.of_an_island.workers() <= 1;
        const auto is_large = [&](int i) { return !alone && large_[std::size_t(i)]; };
        for (int i = 0; i < int(groups_.size()); ++i)
            if (is_large(i)) step(i, workers.of_an_island, 0);
        const Tasks one(1);
        workers.of_islands.for_each(cut_parcels(alone), [&](int p, int worker) {
            for (int i = parcels_[std::size_t(p)]; i < parcels_[std::size_t(p) + 1]; ++i)
                if (!is_large(i)) step(i, one, worker);
        });
    }

  private:
    bool may_join(const StepContext& context, std::span<const Island> islands, std::size_t i) const;
    int cut_parcels(bool alone);

    std::span<IslandGroup> groups_;
    std::span<bool> large_;   // of each group: has it work for all workers?
    std::span<int> parcels_;  // parcel p is the groups from parcels_[p] to parcels_[p + 1]
    int joints_ = 0;
};

}  // namespace epode
