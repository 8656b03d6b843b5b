// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The report of a run, as a list of fields.
#pragma once

#include <string>
#include <vector>

#include "cli/fields.h"
#include "cli/plan.h"
#include "scenes/measure.h"

namespace epode::cli {

struct Outcome {
    bool step_failed = false;
    int messages = 0;
    std::string library;
};

std::vector<Field> describe(const scenes::Scene& scene, const RunPlan& plan, const scenes::RunRecord& record,
                            const Outcome& outcome);

}  // namespace epode::cli
