// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Cells in processes of their own: a crash or an endless loop costs one cell, and cells run at the same time.
// Figures do not depend on how many.
#pragma once

#include "result.h"

#include <functional>

namespace epode::trials {

struct PoolOptions {
    int jobs = 0;                                                    // 0: one for each processor
    int seconds = 60;                                                // of CPU that a cell may take
    std::function<void(const Result&)> done = [](const Result&) {};  // as they end
};

// Results in the order of the cells.
std::vector<Result> run_cells(const std::vector<Cell>& cells, const PoolOptions& options);

}  // namespace epode::trials
