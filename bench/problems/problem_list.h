// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The problems that the exact stepper is measured on. The first ones go from one box on the ground to a wall
// of 1,024 moving bricks and a chain of 4,096 links. Those named size-KIND-ROWS are islands of 12 to 300
// rows, where a dense method is at home and a cleverer one must show that it costs nothing; a world holds as
// many equal ones as make about 600 rows, so that small ones are timed above the clock's grain.
#pragma once

#include <string>
#include <vector>

#include "bench/problems/problem.h"

namespace epode::bench {

struct ProblemRecipe {
    std::string name;
    // One island, or for a pile a few, around `at`. False, with a message: its file cannot be read.
    bool (*add)(Problem&, const ProblemRecipe&, scenes::Vec at);
    int size;        // links, loops, boxes, or bricks in the lowest course
    int height = 1;  // courses
    int copies = 1;  // times are reported for one
};

const std::vector<ProblemRecipe>& all_problems();
const ProblemRecipe* find_problem(const std::string& name);
bool build_problem(Problem& problem, const ProblemRecipe& recipe);

}  // namespace epode::bench
