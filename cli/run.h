// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// `epode run`: one scene, one stepper, one report. Exit codes as everywhere in the program: 0 fine, 1 a
// problem was found (a state that is not finite, a failed step, a file that cannot be written), 2 wrong
// usage.
#pragma once

#include "cli/plan.h"

namespace epode::cli {

int run(const RunOptions& options);
int list_scenes();

}  // namespace epode::cli
