// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The report of a run: one list of named fields, printed as a table for people or as one JSON object for
// programs. Both come from the same list, so they cannot disagree.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenes/measure.h"

namespace epode::cli {

struct RunPlan {
    scenes::Stepper stepper = scenes::Stepper::kQuick;
    double dt = 0;
    int steps = 0;
    int iterations = 0;
    std::uint32_t seed = 1;
};

struct Outcome {
    bool step_failed = false;
    int messages = 0;
    std::string library;
};

struct Field {
    std::string key;    // of the JSON object
    std::string json;   // ready to print: a number, a quoted string, null, a bool
    std::string label;  // of the table; empty: this field is for programs only
    std::string text;
};

std::vector<Field> describe(const scenes::Scene& scene, const RunPlan& plan, const scenes::RunRecord& record,
                            const Outcome& outcome);
std::string as_table(const std::vector<Field>& fields);
std::string as_json(const std::vector<Field>& fields);

}  // namespace epode::cli
