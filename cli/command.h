// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The whole command `epode`, for a program (program.cpp) or a process of Python (`python -m epode`).
#pragma once

namespace epode::cli {

// argv[0] is the program's name. Returns the exit code.
int run_command(int argc, char** argv);

}  // namespace epode::cli
