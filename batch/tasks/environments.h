// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A vector of environments: a batch whose copies have actions, observations, rewards and episodes, as a task says. What a copy does
// depends on the seed, its own number and its actions alone.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "batch/tasks/task.h"

namespace epode::batch {

// When an episode that has ended begins again: with the next step, which ignores the action; within the same one; when it is asked to.
enum class Autoreset { kNextStep, kSameStep, kDisabled };

// Arrays with a row for each copy, which live as long as the environments; of final_ ones (same step alone) rows that have ended count.
struct Results {
    void *observations = nullptr,
         *final_observations = nullptr;  // (n, observation size), in the batch's numbers
    double *rewards = nullptr, *infos = nullptr, *final_infos = nullptr;  // (n), (n, columns)
    bool *terminated = nullptr, *truncated = nullptr;                     // (n)
    bool *begun = nullptr, *bad = nullptr;  // (n): was reset; had left the finite
};

class Environments {
  public:
    virtual ~Environments() = default;
    // Of the copies that the mask says, or all; a seed begins their count of episodes. False: no copy is wanted.
    virtual void reset(const bool* mask, const std::uint64_t* seed) = 0;
    // actions: (n, controls), or n choices. Returns what is wrong with them, or with what is to be stepped: nothing has changed then.
    virtual std::string step(const double* actions) = 0;
};

// first: the number of the first copy, among many such vectors. The batch must outlive them.
std::unique_ptr<Environments> make_environments(AnyBatch& batch, Task task, Autoreset autoreset,
                                                std::uint32_t first, const Results& results);

}  // namespace epode::batch
