// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// `epode capture`: runs any ODE program with the recorder in front of it.
#pragma once

#include <string>
#include <vector>

namespace epode::cli {

struct CaptureOptions {
    std::string output, stepper;
    std::vector<std::string> command;  // the program and its arguments
    bool quiet = false;
};

// The program's own exit code, unless nothing was recorded.
int capture(const CaptureOptions& options);

}  // namespace epode::cli
