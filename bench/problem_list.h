// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The problems that the exact stepper is measured on: from one box on the ground to a wall of 1,024 moving
// bricks and a chain of 4,096 links.
#pragma once

#include <string>
#include <vector>

#include "bench/problem.h"

namespace epode::bench {

struct ProblemRecipe {
    const char* name;
    bool (*build)(Problem&, int size);  // false, with a message: its file cannot be read
    int size;
};

const std::vector<ProblemRecipe>& all_problems();
const ProblemRecipe* find_problem(const std::string& name);

}  // namespace epode::bench
