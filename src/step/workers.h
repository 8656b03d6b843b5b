// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The threads of a step: the library's own, or those of the threading implementation that the world has.
#pragma once

#include <algorithm>

#include "dynamics/world.h"
#include "tasks/tasks.h"

namespace epode {

class Workers {
  public:
    Tasks of_islands, of_an_island;

    // `alone`: the caller's thread only. False: the threading implementation refused; the world is unchanged.
    bool start(World& world, bool alone)
    {
        if (alone) return true;
        if (!world.threading) {
            of_islands = of_an_island = Tasks(number_for(world));
            return true;
        }
        const bool ready =
            posting_.open(world.threading_functions, world.threading, world.islands_max_threads);
        of_islands = Tasks(posting_, true);
        of_an_island = posting_.width() > 1 ? Tasks(posting_, false) : Tasks(1);
        return ready;
    }

    void stop() { posting_.close(); }

  private:
    // The number that the world requests, at most dWorldSetStepIslandsProcessingMaxThreadCount's.
    static int number_for(const World& world)
    {
        const int wanted = world.step_threads > 0 ? world.step_threads : processor_count();
        const unsigned max_threads = world.islands_max_threads;
        return max_threads == 0 ? wanted : int(std::min(unsigned(wanted), max_threads));
    }

    Posting posting_;
};

}  // namespace epode
