// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The state of the scene, as far as the interface shows it: every function that reads, applied to every
// object and parameter number that it takes. Which ones these are is found by trying them once. Two equal
// hashes mean that no reader sees a difference.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene.h"

namespace hostile {

class State {
  public:
    explicit State(const Scene& scene) : scene_(scene) {}

    // Finds the readings that a fresh scene allows.
    void learn();

    // A hash of all readings. `fault`: a reading that is NaN, or a pose or velocity that is not finite.
    std::uint64_t hash(std::string* fault);

    std::size_t readings() const { return readings_.size(); }

  private:
    struct Reading {
        const Function* function;
        int object;       // place in its kind's list
        int number;       // second argument if it is an integer
        int reals = 0;    // how many stand behind the pointer that it returns
        int written = 0;  // how many reals it writes into its argument
        bool finite;      // must be finite, else only not NaN
    };
    void learn(const Function& function);
    bool take(const Reading& reading, std::uint64_t& hash, bool& healthy) const;

    const Scene& scene_;
    std::vector<Reading> readings_;
};

}  // namespace hostile
