// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a cell gave, and all cells of a run as a file of JSON, one cell a line.
#pragma once

#include "trial.h"

#include <string>
#include <vector>

namespace epode::trials {

enum class Ending { kDone, kTime, kCrash };  // kTime: it took longer than a cell may

struct Cell {
    const Scene* scene;
    Setting setting;
};

struct Result {
    Cell cell;
    Ending ending = Ending::kDone;
    double seconds = 0;  // of CPU
    std::map<std::string, double> figures = {};

    // The figure of a law; infinite for a cell that did not end.
    double figure(const Law& law) const;
};

void write_json(const std::vector<Result>& results, const std::string& path);
// Throws std::runtime_error where the file is none of write_json, or names scenes or settings that are not there.
std::vector<Result> read_json(const std::string& path);

}  // namespace epode::trials
